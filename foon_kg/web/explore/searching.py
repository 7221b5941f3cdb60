"""Search as one types, over the names of everything at once."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Collection, Mapping
from functools import cached_property

from foon_kg.web.explore.network import Network, Thing, ThingKind, grouped

_WORD = re.compile(r"[^\s_-]+")
_KINDS: tuple[ThingKind, ...] = ("food", "utensil", "dish", "motion", "video", "object", "step")
"""Of things that fit alike, those of earlier kinds come first."""

_LAST = "\U0010ffff"


class Search:
    """Finds things by the beginnings of the words of their names, of objects also of their states."""

    def __init__(self, network: Network) -> None:
        self.network = network

    def find(self, text: str, kinds: Collection[ThingKind] = (), limit: int = 12) -> list[Thing]:
        """Return at most ``limit`` things each word of ``text`` begins a word of, best first; of ``kinds``, if named.

        A name that is ``text`` to the letter comes first, objects come last. Else those that begin so come first, then
        it goes by kind and by how much they take part in. Not sought are steps, which are called like their motions,
        and vessels with what is in them.
        """
        words = _words(text)
        if not words:
            return []
        places = set.intersection(*(self._beginning(word) for word in words))
        found = [thing for thing in map(self._things.__getitem__, places) if not kinds or thing.kind in kinds]
        said = " ".join(words)
        return sorted(found, key=lambda thing: (thing.name != text.strip(), *_rank(thing, said)))[:limit]

    def _beginning(self, word: str) -> set[int]:
        names = self._names
        between = names[bisect_left(names, word) : bisect_left(names, word + _LAST)]
        return {place for name in between for place in self._places[name]}

    @cached_property
    def _things(self) -> list[Thing]:
        return [
            thing
            for thing in self.network.things()
            if thing.kind != "step" and not (thing.kind == "object" and thing.vessel)
        ]

    @cached_property
    def _places(self) -> Mapping[str, list[int]]:
        return grouped((word, place) for place, thing in enumerate(self._things) for word in _words(_full_name(thing)))

    @cached_property
    def _names(self) -> list[str]:
        return sorted(self._places)


def _full_name(thing: Thing) -> str:
    return " ".join((*thing.states, thing.name))


def _words(text: str) -> list[str]:
    return _WORD.findall(text.lower())


def _rank(thing: Thing, said: str) -> tuple[bool, bool, bool, int, int, str, str]:
    name = " ".join(_words(_full_name(thing)))
    place = _KINDS.index(thing.kind)
    return (thing.kind == "object", name != said, not name.startswith(said), place, -thing.steps, name, thing.id)
