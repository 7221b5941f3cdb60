"""The answer of a classic retrieval: a task tree of units of the FOON, as they are at a level."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction

from foon_kg.model import Annotation, FunctionalUnit, KnownUnit, ObjectNode, Participant, Subgraph
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.node_json import node_to_json
from foon_kg.model.tree import TreeUnit, leaves_of
from foon_kg.model.tree_json import unit_to_json
from foon_kg.search.classic.goal import GoalSought


@dataclass(frozen=True)
class RetrievedUnit:
    """A step: a unit of the FOON at the level of the question; ``success`` is its rate, ``None`` without weights."""

    known: KnownUnit
    success: Fraction | None

    def to_json(self) -> JsonObject:
        """Return one of the ``units`` of a result."""
        unit = unit_to_json(TreeUnit.of(self.known.unit, "foon", self.known.seen_in))
        return {**unit, "success": None if self.success is None else float(self.success)}


@dataclass(frozen=True)
class RetrievalResult:
    """The best tree for ``sought``: ``units`` in an order of execution, from what is at hand to ``goal``.

    ``assumed`` are the motions of the tree that have no weight. ``exact`` says that no tree is better; where a time
    limit left that open, ``bound`` is what no tree can be better than: a number of units, or a success rate.
    """

    sought: GoalSought
    goal: ObjectNode
    units: tuple[RetrievedUnit, ...]
    exact: bool
    assumed: tuple[str, ...] = ()
    bound: float | None = None

    @property
    def success(self) -> Fraction | None:
        """The product of the success rates of the units, ``None`` without weights."""
        rates = [unit.success for unit in self.units if unit.success is not None]
        return math.prod(rates, start=Fraction(1)) if len(rates) == len(self.units) else None

    @property
    def kitchen(self) -> tuple[ObjectNode, ...]:
        """What has to be there before the first step, in the order of first use."""
        return leaves_of(step.known.unit for step in self.units)

    def to_json(self) -> JsonObject:
        """Return the result as ``foon retrieve --json`` prints it."""
        return {
            "asked": self.sought.to_json(),
            "goal": node_to_json(self.goal),
            "units": [unit.to_json() for unit in self.units],
            "kitchen": [node_to_json(node) for node in self.kitchen],
            "total_units": len(self.units),
            "success": None if self.success is None else float(self.success),
            "assumed_weights": list(self.assumed),
            "exact": self.exact,
            "bound": self.bound,
            "level": int(self.sought.level),
            "substitutions": [],
            "assumptions": [],
        }

    def to_subgraph(self) -> Subgraph:
        """Return the tree as a subgraph, for FOON text: no other end product than the goal is marked in it."""
        last = len(self.units) - 1
        units = [
            _marked(step.known.unit, self.goal if place == last else None) for place, step in enumerate(self.units)
        ]
        sightings = (sighting for step in self.units for sighting in step.known.seen_in)
        sources = tuple(dict.fromkeys(sighting.source for sighting in sightings if sighting.source))
        return Subgraph(self.goal.label, tuple(map(Annotation, units)), sources)


def _marked(unit: FunctionalUnit, goal: ObjectNode | None) -> FunctionalUnit:
    def side(participants: tuple[Participant, ...]) -> tuple[Participant, ...]:
        return tuple(p if p.node == goal else replace(p, dish_type=None) for p in participants)

    return replace(unit, inputs=tuple(replace(p, dish_type=None) for p in unit.inputs), outputs=side(unit.outputs))
