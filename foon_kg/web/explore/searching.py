"""Search as one types, over the names of everything at once."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Collection, Mapping
from functools import cached_property

from foon_kg.formats.exports.phrases import motion_said
from foon_kg.web.explore.network import Network, Thing, ThingKind, grouped

_WORD = re.compile(r"[^\s_-]+")
_KINDS: tuple[ThingKind, ...] = ("food", "utensil", "dish", "motion", "video", "object")
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
        said = " ".join(words)
        names = [name for name in map(self._ids.__getitem__, places) if not kinds or name.partition(":")[0] in kinds]
        found: list[Thing] = []
        for are_objects in (False, True):  # objects are many, and come last
            if len(found) < limit:
                these = (self.network.thing(name) for name in names if name.startswith("object:") == are_objects)
                found += sorted(these, key=lambda thing: (thing.name != text.strip(), *_rank(thing, said)))
        return found[:limit]

    def _beginning(self, word: str) -> set[int]:
        names = self._names
        between = names[bisect_left(names, word) : bisect_left(names, word + _LAST)]
        return {place for name in between for place in self._places[name]}

    @cached_property
    def _ids(self) -> list[str]:
        kitchen = self.network.kitchen
        foods = (f"object:{key}" for key, node in self.network.nodes.items() if not kitchen.is_utensil(node.label))
        kinds = (kind for kind in _KINDS if kind != "object")
        return [*(f"{kind}:{name}" for kind in kinds for name in self.network.names(kind)), *foods]

    @cached_property
    def _places(self) -> Mapping[str, list[int]]:
        return grouped((word, place) for place, name in enumerate(self._ids) for word in _words(self._said(name)))

    def _said(self, name: str) -> str:
        """Return what a thing is found by; without making all of them."""
        kind, _, rest = name.partition(":")
        if kind == "motion":
            return f"{rest} {motion_said(rest)}"
        if kind != "object":
            return rest
        node = self.network.nodes[rest]
        return " ".join((*node.states, node.label))

    @cached_property
    def _names(self) -> list[str]:
        return sorted(self._places)


def _full_name(thing: Thing) -> str:
    return " ".join((*thing.states, thing.name))


def _words(text: str) -> list[str]:
    return _WORD.findall(text.lower())


def _rank(thing: Thing, said: str) -> tuple[bool, bool, int, int, str, str]:
    name = " ".join(_words(_full_name(thing)))
    return (name != said, not name.startswith(said), _KINDS.index(thing.kind), -thing.steps, name, thing.id)
