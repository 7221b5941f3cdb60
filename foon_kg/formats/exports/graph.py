"""A tree or a whole FOON as the plain graph that DOT, Mermaid and GraphML draw: two kinds of nodes, directed edges."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Self

from foon_kg.food.motion_costs import NO_COSTS, MotionCosts
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import KnownUnit, ObjectNode, Participant
from foon_kg.model.tree import Mention, Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot


@dataclass(frozen=True)
class Edge:
    """From the node with the id ``start`` to the one with the id ``end``; ``moving`` as the unit says of the object."""

    start: str
    end: str
    moving: bool


@dataclass(frozen=True)
class BipartiteGraph:
    """Object nodes (ids ``o1``, …) and motion nodes (``m1``, …), each once and in the order of appearance.

    Where the things of a tree have numbers, two bowls are two object nodes though they look alike: ``things`` has the
    number of each. ``edges`` go unit by unit from the inputs to the motion, and from the motion to the outputs.
    ``goals`` are the end products, ``at_hand`` what no unit need make; ``costs`` say how likely motions succeed.
    """

    name: str
    objects: dict[str, ObjectNode]
    units: dict[str, KnownUnit]
    edges: tuple[Edge, ...]
    goals: frozenset[ObjectNode]
    at_hand: frozenset[ObjectNode]
    kitchen: Kitchen
    costs: MotionCosts = NO_COSTS
    things: Mapping[str, int] = field(default_factory=dict)

    def text_of(self, name: str) -> str:
        """Return what the object node called ``name`` shows: its fields, and its number as a plan has it."""
        number = self.things.get(name)
        return f"{self.objects[name]}{'' if number is None else f' #{number}'}"

    @classmethod
    def of_tree(cls, tree: ExportedTree, costs: MotionCosts = NO_COSTS) -> Self:
        """Return the graph of a task tree; its motion nodes are numbered like its steps, and weighed by ``costs``."""
        goals = frozenset((tree.goal,)) if tree.goal is not None else frozenset[ObjectNode]()
        planned = tree.result.units if tree.result is not None else ()
        names, edges = _drawn(tree.units, planned, tree.kitchen)
        objects = {name: node for (node, _), name in names.items()}
        things = {name: thing for (_, thing), name in names.items() if thing is not None}
        kitchen, at_hand = Kitchen.default(), frozenset(tree.kitchen)
        return cls(tree.title, objects, _numbered(tree.units), edges, goals, at_hand, kitchen, costs, things)

    @classmethod
    def of_foon(cls, foon: Snapshot, costs: MotionCosts = NO_COSTS) -> Self:
        """Return the graph of a whole ``foon``, weighed by ``costs``; its motions are in the order of their keys."""
        names, edges = _drawn(foon.units)
        objects = {name: node for (node, _), name in names.items()}
        goals = frozenset(goal.node for goal in foon.goals())
        at_hand = frozenset(filter(foon.kitchen.has, objects.values()))
        return cls("FOON", objects, _numbered(foon.units), edges, goals, at_hand, foon.kitchen, costs)


def _moving(side: Sequence[Participant]) -> frozenset[ObjectNode]:
    return frozenset(participant.node for participant in side if participant.moving)


def _numbered(units: Sequence[KnownUnit]) -> dict[str, KnownUnit]:
    return {f"m{number}": known for number, known in enumerate(units, 1)}


def _drawn(
    units: Sequence[KnownUnit], of_plan: Sequence[Step] = (), more: Iterable[ObjectNode] = ()
) -> tuple[dict[tuple[ObjectNode, int | None], str], tuple[Edge, ...]]:
    """Return the ids of the object nodes of ``units`` and ``more``, by their numbers as things, and the edges.

    ``of_plan`` has these numbers.
    """
    names: dict[tuple[ObjectNode, int | None], str] = {}
    edges: list[Edge] = []

    def name(one: Mention) -> str:
        return names.setdefault((one.node, one.thing), f"o{len(names) + 1}")

    for place, known in enumerate(units):
        motion, unit = f"m{place + 1}", known.unit
        planned = of_plan[place] if of_plan else Step.of_unit(unit, "foon", ())
        takes, gives = _moving(unit.inputs), _moving(unit.outputs)
        edges += [Edge(name(one), motion, one.node in takes) for one in dict.fromkeys(planned.inputs)]
        edges += [Edge(motion, name(one), one.node in gives) for one in dict.fromkeys(planned.outputs)]
    there = {node for node, _ in names}
    for node in more:
        if node not in there:
            name(Mention(node))
    return names, tuple(edges)
