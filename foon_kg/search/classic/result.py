"""The answer of a classic retrieval: a task tree of units of the FOON, as they are at a level."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Self

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import Annotation, FunctionalUnit, KnownUnit, ObjectNode, Participant, Subgraph
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.node_json import node_from_json, node_to_json, sighting_from_json
from foon_kg.model.tree import Step, leaves_of
from foon_kg.model.tree_json import unit_to_json
from foon_kg.search.classic.goal import GoalSought


@dataclass(frozen=True)
class RetrievedUnit:
    """A step: a unit of the FOON at the level of the question; ``success`` is its rate, ``None`` without weights."""

    known: KnownUnit
    success: Fraction | None

    def to_json(self) -> JsonObject:
        """Return one of the ``units`` of a result."""
        told = Step.of_unit(self.known.unit, "foon", self.known.seen_in)
        unit = unit_to_json(told) | {"accepts_any": told.accepts_any}
        for side, nodes in (("input_nodes", told.input_nodes), ("output_nodes", told.output_nodes)):
            unit[side] = [node_to_json(node) | {"moving": node in told.moving} for node in nodes]
        return {**unit, "success": None if self.success is None else float(self.success)}

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return the step of the ``fields`` that :meth:`to_json` wrote."""
        sides = (
            tuple(Participant(node_from_json(one), one.truth("moving")) for one in fields.nested_list(side))
            for side in ("input_nodes", "output_nodes")
        )
        inputs, outputs = sides
        unit = FunctionalUnit(inputs, fields.text("motion_node"), outputs, fields.truth("accepts_any"))
        seen_in = tuple(map(sighting_from_json, fields.nested_list("seen_in")))
        return cls(KnownUnit(unit, seen_in), _rate(fields.optional_number("success")))


@dataclass(frozen=True)
class RetrievalResult:
    """The best tree for ``sought``: ``units`` in an order of execution, from what is at hand to ``goal``.

    ``assumed`` are the motions of the tree that have no weight. ``exact`` says that no tree is better; where a time
    limit left that open, ``bound`` is what no tree can be better than: a number of units, or a success rate.

    >>> from foon_kg import Foon
    >>> from foon_kg.foon.demo import demo_folder
    >>> found = Foon.from_files(demo_folder()).retrieve("lemonade")
    >>> found.goal.label, found.units[-1].known.unit.motion, found.exact
    ('lemonade', 'stir', True)
    """

    sought: GoalSought
    goal: ObjectNode
    units: tuple[RetrievedUnit, ...]
    exact: bool
    assumed: tuple[str, ...] = ()
    bound: float | None = None

    @property
    def success(self) -> Fraction | None:
        """The product of the success rates of the units, from 0 to 1, exactly; ``None`` where no weights were asked.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> found = Foon.from_files(demo_folder()).retrieve("lemonade", costs=MotionCosts({"pour": 0.1, "stir": 0}))
        >>> found.success, found.assumed[:3]
        (Fraction(9, 1280), ('cut', 'fill', 'pick-and-place'))
        """
        rates = [unit.success for unit in self.units if unit.success is not None]
        return math.prod(rates, start=Fraction(1)) if len(rates) == len(self.units) else None

    @property
    def costs(self) -> MotionCosts:
        """The costs of its motions (0 to 1), as far as the weights of the question named them.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> asked = MotionCosts({"pour": 0.1, "whip": 0.9})
        >>> Foon.from_files(demo_folder()).retrieve("lemonade", costs=asked).costs
        MotionCosts(costs={'pour': 0.1})
        """
        rates = {step.known.unit.motion: step.success for step in self.units if step.success is not None}
        return MotionCosts({motion: float(1 - rate) for motion, rate in rates.items() if motion not in self.assumed})

    @property
    def kitchen(self) -> tuple[ObjectNode, ...]:
        """What has to be there before the first step, in the order of first use.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> found = Foon.from_files(demo_folder()).retrieve("lemonade")
        >>> [str(node) for node in found.kitchen[:2]]
        ['faucet (off)', 'water (liquid; from faucet)']
        """
        return leaves_of(step.known.unit for step in self.units)

    def to_json(self) -> JsonObject:
        """Return the result as ``foon retrieve --json`` prints it.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> told = Foon.from_files(demo_folder()).retrieve("lemonade").to_json()
        >>> told["total_units"], told["success"], told["exact"]
        (9, None, True)
        """
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

    @classmethod
    def from_json(cls, value: object, where: str = "tree") -> Self:
        """Return the result of a ``value`` that :meth:`to_json` wrote; raises ReadError for any other.

        ``where`` names the document in messages.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> found = Foon.from_files(demo_folder()).retrieve("lemonade")
        >>> RetrievalResult.from_json(found.to_json()) == found
        True
        """
        fields = Fields(value, where)
        return cls(
            GoalSought.from_json(fields.nested("asked")),
            node_from_json(fields.nested("goal")),
            tuple(map(RetrievedUnit.from_json, fields.nested_list("units"))),
            fields.truth("exact"),
            tuple(fields.texts("assumed_weights")),
            fields.optional_number("bound"),
        )

    def to_subgraph(self) -> Subgraph:
        """Return the tree as a subgraph, for FOON text: no other end product than the goal is marked in it.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> subgraph = Foon.from_files(demo_folder()).retrieve("lemonade").to_subgraph()
        >>> subgraph.name, len(subgraph.annotations), subgraph.annotations[-1].unit.motion
        ('lemonade', 9, 'stir')
        """
        last = len(self.units) - 1
        units = [
            Annotation(_marked(step.known.unit, self.goal if place == last else None), seen_in=step.known.seen_in)
            for place, step in enumerate(self.units)
        ]
        sightings = (sighting for step in self.units for sighting in step.known.seen_in)
        sources = tuple(dict.fromkeys(sighting.source for sighting in sightings if sighting.source))
        return Subgraph(self.goal.label, tuple(units), sources)


def _rate(number: float | None) -> Fraction | None:
    return None if number is None else Fraction(str(number))


def _marked(unit: FunctionalUnit, goal: ObjectNode | None) -> FunctionalUnit:
    def side(participants: tuple[Participant, ...]) -> tuple[Participant, ...]:
        return tuple(p if p.node == goal else replace(p, dish_type=None) for p in participants)

    return replace(unit, inputs=tuple(replace(p, dish_type=None) for p in unit.inputs), outputs=side(unit.outputs))
