"""Whether a command may import what makes data frames: it takes longer than connecting, asking and planning together.

The Neo4j driver imports pandas and pyarrow wherever they are installed, to answer data frames, which no command asks
it for. Commands that read tables themselves say so before they do. It imports numpy, too, to take arrays as parameters;
a command that has none may do without.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

_PACKAGES = ("pandas", "pyarrow")


def leave_out() -> None:
    """Have imports of these packages fail as if they were not installed, unless they are imported already."""
    for name in _PACKAGES:
        sys.modules.setdefault(name, None)  # type: ignore[arg-type] # None is how Python says: not here


def allow() -> None:
    """Let these packages be imported where they are installed."""
    for name in _PACKAGES:
        if name in sys.modules and sys.modules[name] is None:
            del sys.modules[name]


@contextmanager
def driver_without_arrays() -> Iterator[None]:
    """Have the Neo4j driver, if it is imported in this ``with``, not import numpy, which others import after it."""
    hidden = sys.modules.setdefault("numpy", None) is None  # type: ignore[arg-type] # as above
    try:
        yield
    finally:
        if hidden:
            del sys.modules["numpy"]
