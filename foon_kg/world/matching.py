"""Whether a food that is there is the one that a node without a number speaks of: by its form, its state, its place."""

from __future__ import annotations

from collections.abc import Collection

from foon_kg.food import Utensil
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Lump, Vessel


def divides_like(lump: Lump, said: NodeReading) -> bool:
    """Return whether ``lump`` is in no smaller pieces than a node ``said``, and remains exactly where that says so."""
    if said.undivided:
        return lump.fine == 0 and not lump.mixed
    if said.fine and lump.fine > said.fine and set(said.node.states).isdisjoint(lump.states):
        return False
    return not lump.parts or all(part.remains for part in lump.parts) == said.remains


def is_still(lump: Lump, said: NodeReading) -> bool:
    """Return whether ``lump`` is still as the node ``said`` that it came out as."""
    if lump.gone or lump.states != said.node.states:
        return False
    return said.place is None or lump.where is None or said.place_utensil is None or same_place(said.place, lump.where)


def place_score(said: NodeReading, lump: Lump, there: Collection[str], *, lies_on: bool | None) -> int:
    """Return how well the place of a lump is the one that the node ``said``: 0 not at all, 3 the same.

    ``there`` are the labels of the vessels that go in; ``lies_on`` says whether the lump lies on the food that the node
    names as its place, ``None`` where it names none.
    """
    if said.place is None:
        return _score_without_place(said, lump, there)
    if lump.where is None:
        return 2 if _may_lie_nowhere(said) else 0
    if lies_on is not None:
        return 2 if lies_on else 1
    return 3 if same_place(said.place, lump.where) else 0


def _score_without_place(said: NodeReading, lump: Lump, there: Collection[str]) -> int:
    if lump.where is None:
        return 3
    if lump.where.label in there:
        return 2
    if not said.undivided:
        return 1
    # one more whole onion is taken from the kitchen, not out of a bowl into which somebody put one
    return 1 if lump.where.row.role == "place" or "cut" in lump.where.row.can else 0


def _may_lie_nowhere(said: NodeReading) -> bool:
    """Whether what is in the place of a node may be told without one: it is a food, a table, or a packet."""
    return said.place_utensil is None or said.place_utensil.role == "place" or in_storage(said)


def same_place(label: str, vessel: Vessel) -> bool:
    """Whether a place called ``label`` is ``vessel``: annotators write *in pan* of what lies in the cooking pan."""
    return label in {vessel.label, vessel.label.rpartition(" ")[2]} or vessel.label == label.rpartition(" ")[2]


def carries(utensil: Utensil | None) -> bool:
    """Whether ``utensil`` is a tool that carries a portion: what is in it was scooped up before."""
    return utensil is not None and utensil.role == "tool" and "scoop" in utensil.can and "hand" not in utensil.can


def in_storage(said: NodeReading) -> bool:
    """Return whether the node ``said`` that its food is in what it is sold in, or comes out of a tap."""
    return said.place_utensil is not None and said.place_utensil.keeps_food
