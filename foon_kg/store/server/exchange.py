"""The data of one home put in the place of another's, so that a program that is killed meanwhile loses neither.

The old data is set aside first and taken away last. Where both is there the new one is in its place; where only the
old one is there, set aside, the exchange was broken off, and :func:`settle` puts it back before anything starts.
"""

from __future__ import annotations

import shutil

from foon_kg.model.kept import write_private
from foon_kg.store.disk import explain_os_error
from foon_kg.store.server.home import Home


def exchange(place: Home, made: Home) -> None:
    """Put the data of ``made`` in the place of that of ``place``, which is locked and has no server running.

    Both are opened by the same password (:func:`share_password`). Raises ServerError; then all is as before.
    """
    data = place.databases.parent
    with explain_os_error(f"cannot put the import in the place of {data}"):
        if not place.password_file.exists():
            write_private(place.password_file, made.password_file.read_text(encoding="utf-8"))
        if data.exists():
            data.rename(place.set_aside)
        try:
            made.databases.parent.rename(data)
        except OSError:
            settle(place)
            raise
    settle(place)


def settle(place: Home) -> None:
    """End an exchange that was broken off: put the old data back where no new one took its place, else take it away."""
    data = place.databases.parent
    if not place.set_aside.exists():
        return
    if data.exists():
        shutil.rmtree(place.set_aside, ignore_errors=True)
        return
    with explain_os_error(f"cannot put {place.set_aside} back to {data}"):
        place.set_aside.rename(data)


def share_password(place: Home, made: Home) -> None:
    """Give a home that is being made the password of the one whose place its data will take, if that has one."""
    if place.password_file.exists():
        with explain_os_error(f"cannot write {made.password_file}"):
            write_private(made.password_file, place.password_file.read_text(encoding="utf-8"))
