"""The edit distance of two trees as graphs: how many units and ways between units tell them apart.

A tree is a graph of its units: each is a node, named by its motion and main object; a way leads from a unit to every
later one that takes what it made. Adding or taking away a unit costs 1, and so does a way; a unit of another name is
another unit. That is the graph edit distance of Sanfeliu and Fu (1983) where renaming a node costs more than taking
it away and adding another; it is what remains when as much as possible of both graphs is laid onto each other.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass

from foon_kg.model import FunctionalUnit, ObjectNode

MOST_STEPS = 20_000
"""After how many steps a search gives up; counted, not timed, so that it ends alike on every machine."""

Way = tuple[int, int]
"""From a unit to a later one, by their places in the tree."""

_Laid = tuple[dict[int, int | None], int]
"""Which units are laid onto which (``None``: onto nothing), and how many units and ways that keeps."""


@dataclass(frozen=True)
class UnitGraph:
    """The units of a tree by name, and the ways between them."""

    names: tuple[Hashable, ...]
    ways: frozenset[Way]

    @property
    def size(self) -> int:
        """How many units and ways there are."""
        return len(self.names) + len(self.ways)


@dataclass(frozen=True)
class EditDistance:
    """How many units and ways have to be added or taken away; ``proven`` says that no fewer would do.

    ``size`` are the units and ways of both graphs together: what is apart where they have nothing in common.
    """

    edits: int
    size: int
    proven: bool = True

    @property
    def closeness(self) -> float:
        """The distance as a likeness: 1 for the same graph, 0 for nothing in common, or for two that are empty."""
        return 1 - self.edits / self.size if self.size else 0.0


def unit_graph(units: Sequence[FunctionalUnit], names: Sequence[Hashable]) -> UnitGraph:
    """Return the graph of a tree whose units have ``names``; what a unit takes is of the last unit that made it."""
    makers, ways = dict[ObjectNode, int](), set[Way]()
    for place, unit in enumerate(units):
        ways.update((makers[node], place) for node in unit.input_nodes if node in makers)
        makers.update(dict.fromkeys(unit.output_nodes, place))
    return UnitGraph(tuple(names), frozenset(ways))


def edit_distance(one: UnitGraph, other: UnitGraph, *, most_steps: int = MOST_STEPS) -> EditDistance:
    """Return how many edits make one graph the other, by branch and bound over the units that have one name.

    Of a search that is given up after ``most_steps`` the least distance found so far is answered, as not ``proven``.
    """
    search = _Search(one, other, most_steps)
    search.run()
    size = one.size + other.size
    return EditDistance(size - 2 * search.best, size, proven=search.proven)


class _Search:
    """The greatest common part: units of ``one`` are laid onto units of the same name, one after the other."""

    def __init__(self, one: UnitGraph, other: UnitGraph, most_steps: int) -> None:
        self.other, self.most_steps = other, most_steps
        self.partners = {
            place: [partner for partner, twin in enumerate(other.names) if twin == name]
            for place, name in enumerate(one.names)
        }
        named = {(other.names[start], other.names[end]) for start, end in other.ways}
        self.ways = {way for way in one.ways if (one.names[way[0]], one.names[way[1]]) in named}
        self.order = sorted((p for p, found in self.partners.items() if found), key=lambda p: len(self.partners[p]))
        self.best, self.proven = 0, False

    def run(self) -> None:
        """Search until nothing better is left, or the steps are used up."""
        stack: list[_Laid] = [({}, 0)]
        for _ in range(self.most_steps):
            if not stack:
                self.proven = True
                return
            laid, kept = stack.pop()
            self.best = max(self.best, kept)
            if kept + self._at_most(laid) > self.best:
                stack += reversed(list(self._next(laid, kept)))

    def _next(self, laid: dict[int, int | None], kept: int) -> Iterator[_Laid]:
        """Yield what the next unit may be laid onto, the most ways first; at last onto nothing."""
        place = self.order[len(laid)]
        free = [partner for partner in self.partners[place] if partner not in laid.values()]
        for ways, partner in sorted((-self._ways_kept(place, partner, laid), partner) for partner in free):
            yield laid | {place: partner}, kept + 1 - ways
        yield laid | {place: None}, kept

    def _ways_kept(self, place: int, partner: int, laid: dict[int, int | None]) -> int:
        """Return how many ways between ``place`` and the units laid so far are there between their partners too."""
        known = [(other, there) for other, there in laid.items() if there is not None]
        forth = sum((place, other) in self.ways and (partner, there) in self.other.ways for other, there in known)
        return forth + sum(
            (other, place) in self.ways and (there, partner) in self.other.ways for other, there in known
        )

    def _at_most(self, laid: dict[int, int | None]) -> int:
        """Return how many units and ways may still be kept."""
        gone = {place for place, partner in laid.items() if partner is None}
        ways = sum(gone.isdisjoint(way) and not (way[0] in laid and way[1] in laid) for way in self.ways)
        return len(self.order) - len(laid) + ways
