"""How processes begin that all need the same: as copies of one that has made it ready, where the system can do that."""

from __future__ import annotations

import os
from functools import cache
from multiprocessing import get_all_start_methods, get_context
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from multiprocessing.context import ForkServerContext, SpawnContext

_TABLES = ("FOON_KG_ALIASES", "FOON_KG_FOODS", "FOON_KG_STATES", "FOON_KG_UTENSILS")
"""Name tables of a user's own, on which answers depend."""


def copies(ready: str) -> ForkServerContext | SpawnContext:
    """Return how a process begins: where it can be, as a copy of one that has imported the module ``ready``.

    That one begins with the first of them, for all of this program, and sees the environment as it was then. Where
    another table of a user's own is named since, a process begins by itself: much of what was made ready may follow
    from the tables.
    """
    if "forkserver" not in get_all_start_methods() or _own_tables() != _first_own_tables():
        return get_context("spawn")
    context = get_context("forkserver")
    context.set_forkserver_preload([ready])
    return context


def _own_tables() -> tuple[str, ...]:
    """Return where the environment says that a user's own tables are."""
    return tuple(os.environ.get(name, "") for name in _TABLES)


_first_own_tables = cache(_own_tables)
