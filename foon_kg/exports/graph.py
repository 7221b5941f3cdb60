"""A tree or a whole FOON as the plain graph that DOT, Mermaid and GraphML draw: two kinds of nodes, directed edges."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Self

from foon_kg.exports.tree import ExportedTree, nodes_of
from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode, Participant
from foon_kg.motion_costs import NO_COSTS, MotionCosts
from foon_kg.snapshot import Snapshot


@dataclass(frozen=True)
class Edge:
    """From the node with the id ``start`` to the one with the id ``end``; ``moving`` as the unit says of the object."""

    start: str
    end: str
    moving: bool


@dataclass(frozen=True)
class BipartiteGraph:
    """Object nodes (ids ``o1``, …) and motion nodes (``m1``, …), each once and in the order of appearance.

    ``goals`` are the end products, ``at_hand`` what no unit need make; ``costs`` say how likely motions succeed.
    """

    name: str
    objects: dict[ObjectNode, str]
    units: dict[str, KnownUnit]
    goals: frozenset[ObjectNode]
    at_hand: frozenset[ObjectNode]
    kitchen: Kitchen
    costs: MotionCosts = NO_COSTS

    @classmethod
    def of_tree(cls, tree: ExportedTree, costs: MotionCosts = NO_COSTS) -> Self:
        """Answer the graph of a task tree; its motion nodes are numbered like its steps."""
        goals = frozenset((tree.goal,)) if tree.goal is not None else frozenset[ObjectNode]()
        objects = _objects(tree.units, tree.kitchen)
        return cls(tree.title, objects, _numbered(tree.units), goals, frozenset(tree.kitchen), Kitchen.default(), costs)

    @classmethod
    def of_foon(cls, foon: Snapshot, costs: MotionCosts = NO_COSTS) -> Self:
        """Answer the graph of a whole FOON; its motion nodes are in the order of their keys."""
        objects = _objects(foon.units)
        goals = frozenset(goal.node for goal in foon.goals())
        at_hand = frozenset(filter(foon.kitchen.has, objects))
        return cls("FOON", objects, _numbered(foon.units), goals, at_hand, foon.kitchen, costs)

    def edges(self) -> Iterator[Edge]:
        """Answer the edges unit by unit: from the inputs to the motion, from the motion to the outputs."""
        for motion, known in self.units.items():
            takes, gives = _moving(known.unit.inputs), _moving(known.unit.outputs)
            for node in known.unit.input_nodes:
                yield Edge(self.objects[node], motion, node in takes)
            for node in known.unit.output_nodes:
                yield Edge(motion, self.objects[node], node in gives)


def _moving(side: Sequence[Participant]) -> frozenset[ObjectNode]:
    return frozenset(participant.node for participant in side if participant.moving)


def _numbered(units: Sequence[KnownUnit]) -> dict[str, KnownUnit]:
    return {f"m{number}": known for number, known in enumerate(units, 1)}


def _objects(units: Sequence[KnownUnit], more: Iterable[ObjectNode] = ()) -> dict[ObjectNode, str]:
    nodes = dict.fromkeys((*nodes_of(known.unit for known in units), *more))
    return {node: f"o{number}" for number, node in enumerate(nodes, 1)}
