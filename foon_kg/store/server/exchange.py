"""One folder of data put in the place of another, so that a kill at any moment leaves the one or the other, whole.

No system call that Python has exchanges two folders at once. So the data are moved aside first, under a name that tells
what they are, and a home is :func:`restored <restore>` by whoever next takes it up: to what it had, as long as nothing
else is there in its place. Whoever calls this holds the home (:meth:`~foon_kg.store.server.home.Home.locked`).
"""

from __future__ import annotations

import shutil

from foon_kg.store.disk import explain_os_error
from foon_kg.store.server.home import Home


def exchange(place: Home, made: Home) -> None:
    """Put the data of ``made`` in the place of those of ``place``, whose server is down; both have one password."""
    restore(place)
    with explain_os_error(f"cannot put {made.data} in the place of {place.data}"):
        if place.data.exists():
            place.data.rename(place.data_before)
        made.data.rename(place.data)
    shutil.rmtree(place.data_before, ignore_errors=True)  # what stays of it is taken away by the next start


def restore(place: Home) -> None:
    """Bring the home ``place`` in order where an :func:`exchange` was cut off: back, or to its end if that was near."""
    if not place.data_before.exists():
        return
    with explain_os_error(f"cannot restore {place.data} from {place.data_before}"):
        if place.data.exists():
            shutil.rmtree(place.data_before)
        else:
            place.data_before.rename(place.data)
