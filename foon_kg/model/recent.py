"""What was worked out of late, so that a planner that lives long does not grow with every recipe it is asked.

Three things are kept in this program: what an object works out of itself (``functools.cached_property``, gone with the
object), what is read of the program's own tables (``functools.cache``), and what is worked out of what is asked: that
has a limit, here or as ``functools.lru_cache(maxsize=…)``. ``python benchmarks/house.py --list caches`` shows all.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, MutableMapping
from typing import TypeVar

K = TypeVar("K")
V = TypeVar("V")

MOST_WORDS = 1 << 12
"""Of so many different words a function of words keeps the answers: more than tables and the public FOON have motions
and states, while files of strangers, and a service that runs for months, may have any number."""


class Recent(MutableMapping[K, V]):
    """A mapping that keeps so many entries: of more, those go that were not asked for the longest."""

    def __init__(self, most: int) -> None:
        self.most = most
        self._entries: OrderedDict[K, V] = OrderedDict()

    def __getitem__(self, key: K) -> V:
        value = self._entries[key]
        self._entries.move_to_end(key)
        return value

    def find(self, key: K) -> V | None:
        """Return the entry of ``key`` or ``None``: :meth:`get`, quickly."""
        value = self._entries.get(key)
        if value is not None:
            self._entries.move_to_end(key)
        return value

    def __setitem__(self, key: K, value: V) -> None:
        self._entries[key] = value
        self._entries.move_to_end(key)
        if len(self._entries) > self.most:
            self._entries.popitem(last=False)

    def __delitem__(self, key: K) -> None:
        del self._entries[key]

    def __contains__(self, key: object) -> bool:
        return key in self._entries

    def __iter__(self) -> Iterator[K]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)
