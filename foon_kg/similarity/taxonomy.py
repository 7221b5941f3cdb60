"""Foods by what they are: the food nouns of WordNet, so that kinds of one thing are near each other.

The nearness of two foods is Lin's (1998): how much of what is known of both is said already by what they share.
A name's row holds, at each kind it belongs to, the root of the information that this kind adds to the kinds above
it; the product of two rows is then the information they share, and the cosine Lin's measure in a geometric mean.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib.resources import files

from foon_kg.similarity.sparse import SparseRows

Kinds = dict[int, float]
MOST_NAMES = 1 << 14
"""Of so many names it is kept what they are."""

_SHORTENED = 0.9  # of "red onion" only the onion was found


@dataclass(frozen=True, eq=False)
class FoodTaxonomy:
    """The kinds of foods, each with its name and the information it adds (0..1), and the kinds that a word may mean."""

    names: tuple[str, ...]
    added: tuple[float, ...]
    above: tuple[frozenset[int], ...]
    meanings: dict[str, tuple[int, ...]]

    def rows(self, names: Sequence[str]) -> SparseRows:
        """Return one row for each canonical name, of length at most 1; zeros where WordNet has no such food."""
        return SparseRows.of([self._kinds(name) for name in names], len(self.added))

    def kinds(self, name: str) -> tuple[str, ...]:
        """Return the kinds that a canonical name, taken whole, may belong to, by name; none where it is no food."""
        return tuple(sorted({self.names[kind] for one in self.meanings.get(name, ()) for kind in self.above[one]}))

    def shared(self, one: str, other: str) -> str | None:
        """Return the name of the most telling kind that two canonical names, ``one`` and the ``other``, belong to."""
        both = self._kinds(one).keys() & self._kinds(other).keys()
        telling = {kind: sum(self.added[above] for above in self.above[kind]) for kind in both}
        return self.names[min(both, key=lambda kind: (-telling[kind], kind))] if both else None

    @cached_property
    def _kinds(self) -> Callable[[str], Kinds]:
        """:meth:`_kinds_of`, kept: plans ask again and again of the same names."""
        return lru_cache(maxsize=MOST_NAMES)(self._kinds_of)

    def _kinds_of(self, name: str) -> Kinds:
        words = name.split()
        for start in range(len(words)):
            meanings = self.meanings.get(" ".join(words[start:]))
            if meanings:
                kinds = {kind for meaning in meanings for kind in self.above[meaning]}
                scale = (_SHORTENED if start else 1.0) / math.sqrt(sum(self.added[kind] for kind in kinds) or 1.0)
                return {kind: scale * math.sqrt(self.added[kind]) for kind in sorted(kinds)}
        return {}


@lru_cache(maxsize=1)
def food_taxonomy() -> FoodTaxonomy:
    """Return the kinds that ship with foon-kg, read once."""
    text = files("foon_kg.similarity").joinpath("food-taxonomy.txt").read_text(encoding="utf-8")
    parents: list[list[int]] = []
    names: list[str] = []
    meanings: dict[str, list[int]] = {}
    for line in text.splitlines():
        if not line.startswith("#"):
            number, above, words = line.split(":", 2)
            parents.append([int(parent) for parent in above.split()])
            names.append(words.strip().split(", ")[0])
            for word in words.strip().split(", "):
                meanings.setdefault(word, []).append(int(number))
    above_each = _closure(parents)
    added = _information_added(parents, above_each)
    return FoodTaxonomy(tuple(names), added, above_each, {word: tuple(kinds) for word, kinds in meanings.items()})


def _closure(parents: Sequence[Sequence[int]]) -> tuple[frozenset[int], ...]:
    """Return of each kind all kinds above it, itself too."""
    done: dict[int, frozenset[int]] = {}

    def above(kind: int) -> frozenset[int]:
        if kind not in done:
            done[kind] = frozenset({kind}).union(*(above(parent) for parent in parents[kind]))
        return done[kind]

    return tuple(above(kind) for kind in range(len(parents)))


def _information_added(parents: Sequence[Sequence[int]], above: Sequence[frozenset[int]]) -> tuple[float, ...]:
    """Return what each kind adds to the most telling kind above it; information as Seco (2004): few kinds below."""
    below = [0] * len(parents)
    for kinds in above:
        for kind in kinds:
            below[kind] += 1
    information = [1 - math.log(count) / math.log(len(parents)) for count in below]
    return tuple(
        max(0.0, information[kind] - max((information[parent] for parent in parents[kind]), default=0.0))
        for kind in range(len(parents))
    )
