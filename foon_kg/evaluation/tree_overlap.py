"""How much two trees have in common: their units, what is done to which food, and how the units hang together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from foon_kg.evaluation.edit_distance import edit_distance, unit_graph
from foon_kg.food import singular
from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.model.json_fields import JsonObject
from foon_kg.plans.kitchen import Kitchen

MEASURES = ("units", "units_with_states", "triples", "graph")
"""The measures of an overlap, each from 0 (nothing in common) to 1 (the same)."""


@dataclass(frozen=True)
class Overlap:
    """What two trees have in common.

    ``units``: the motion with its main object. ``units_with_states``: the same with the states of the main object.
    ``triples``: food, state and motion, for each food that a unit takes itself. Units count as often as they are there,
    triples once. ``graph``: the edit distance of the graphs of both (:mod:`~foon_kg.evaluation.edit_distance`) as a
    likeness; where ``proven`` is false its search was given up, and it is at least so much.
    """

    units: float
    units_with_states: float
    triples: float
    graph: float
    proven: bool = True

    def to_json(self) -> JsonObject:
        """Return the figures as JSON, to six decimals."""
        return {measure: round(getattr(self, measure), 6) for measure in MEASURES} | {"graph_proven": self.proven}


NOTHING = Overlap(0.0, 0.0, 0.0, 0.0)
"""The overlap of a tree that is not there."""


def overlap(ours: Sequence[FunctionalUnit], truth: Sequence[FunctionalUnit], kitchen: Kitchen) -> Overlap:
    """Return what the units ``ours`` and ``truth`` have in common; but for ``graph`` their order says nothing.

    ``kitchen`` tells foods from utensils.
    """
    one, other = ([(unit.motion, main_object(unit, kitchen)) for unit in units] for units in (ours, truth))
    names, true_names = list(map(_without_states, one)), list(map(_without_states, other))
    edits = edit_distance(unit_graph(ours, names), unit_graph(truth, true_names))
    return Overlap(
        in_common(Counter(names), Counter(true_names)),
        in_common(Counter(map(_with_states, one)), Counter(map(_with_states, other))),
        in_common(Counter(set(_triples(ours, kitchen))), Counter(set(_triples(truth, kitchen)))),
        edits.closeness,
        edits.proven,
    )


def main_object(unit: FunctionalUnit, kitchen: Kitchen) -> ObjectNode | None:
    """Return what a unit is about: the first food that it takes, else the first vessel with food, else its first input.

    ``kitchen`` tells foods from utensils. Of these one that moves comes before one that does not: what is poured before
    what it is poured onto.
    """

    def rank(place: int) -> tuple[int, bool, int]:
        part = unit.inputs[place]
        kind = 0 if kitchen.is_food(part.node) else 1 if kitchen.foods_in(part.node) else 2
        return kind, not part.moving, place

    places = range(len(unit.inputs))
    return unit.inputs[min(places, key=rank)].node if unit.inputs else None


def in_common(one: Counter[Hashable], other: Counter[Hashable]) -> float:
    """Return the intersection over union (0 to 1) of ``one`` bag and the ``other``.

    Two empty ones have nothing in common.
    """
    together = (one | other).total()
    return (one & other).total() / together if together else 0.0


def _without_states(unit: tuple[str, ObjectNode | None]) -> Hashable:
    motion, node = unit
    return motion, node and singular(node.label)


def _with_states(unit: tuple[str, ObjectNode | None]) -> Hashable:
    motion, node = unit
    return motion, node and (singular(node.label), node.states)


def _triples(units: Iterable[FunctionalUnit], kitchen: Kitchen) -> Iterator[Hashable]:
    for unit in units:
        for node in unit.input_nodes:
            if kitchen.is_food(node):
                yield from ((singular(node.label), state, unit.motion) for state in node.states or ("",))
