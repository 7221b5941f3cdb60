"""What is exported: a task tree, whatever it was read from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

from foon_kg.food.motion_costs import NO_COSTS, MotionCosts
from foon_kg.formats.exports.pddl_things import has_numbers
from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Recipe, Sighting, Subgraph, steps_of
from foon_kg.model.errors import FormatError, UsageError
from foon_kg.model.tree import newly_made
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.search.classic import RetrievalResult


@dataclass(frozen=True)
class ExportedTree:
    """A task tree: ``units`` in the order of execution, from ``kitchen`` to ``goal``.

    ``goal`` is ``None`` for a FOON file in which no output is marked. ``subgraph`` is the tree as a
    FOON file has it, ``result`` the plan result that it comes from, if any; ``costs`` are the weights of
    its motions with which it was retrieved. Of the units the first ``done`` were carried out already.
    """

    name: str
    units: tuple[KnownUnit, ...]
    kitchen: tuple[ObjectNode, ...]
    goal: ObjectNode | None
    subgraph: Subgraph
    result: PlanResult | None = None
    costs: MotionCosts = NO_COSTS
    done: int = 0

    @classmethod
    def of_plan(cls, result: PlanResult) -> Self:
        """Return the tree of a plan result. It knows neither the stars of motions nor which nodes move."""
        subgraph = result.to_subgraph()
        units = tuple(
            KnownUnit(annotation.unit, planned.sightings)
            for annotation, planned in zip(subgraph.annotations, result.units, strict=True)
        )
        return cls(subgraph.name, units, result.kitchen, result.goal, subgraph, result)

    @classmethod
    def of_subgraph(cls, subgraph: Subgraph, kitchen: Kitchen) -> Self:
        """Return the tree that the ``subgraph`` of a FOON file tells, each unit seen where the file says so.

        A file names no ``kitchen``: the tree starts from its leaves, and from the empty utensils at rest that it also
        puts back later, as ``foon check`` reads it.
        """
        units = tuple(steps_of(subgraph))
        marked = [p.node for known in units for p in known.unit.outputs if p.dish_type]
        leaves = kitchen_of([known.unit for known in units], kitchen)
        return cls(subgraph.name, units, leaves, marked[-1] if marked else None, subgraph)

    @classmethod
    def of_retrieved(cls, result: RetrievalResult) -> Self:
        """Return the tree of the ``result`` of a classic retrieval: its units as the FOON has them."""
        subgraph = result.to_subgraph()
        return cls(subgraph.name, tuple(steps_of(subgraph)), result.kitchen, result.goal, subgraph, costs=result.costs)

    def after(self, done: int) -> ExportedTree:
        """Return this tree once its first ``done`` steps were carried out.

        Raises :class:`~foon_kg.model.errors.UsageError` where that leaves none, and
        :class:`~foon_kg.model.errors.FormatError` where its things have no numbers, and so nobody can say how they are.
        """
        if not done < len(self.units):
            raise UsageError(f"{self.name} has {len(self.units)} steps: none is left", hint="Name an earlier step.")
        if self.result is None or not has_numbers(self.result):
            raise FormatError(
                f"{self.name}: its things have no numbers, so nobody knows how they are after a step",
                hint="Give the plan result (JSON).",
            )
        return replace(self, done=done)

    @property
    def recipe(self) -> Recipe | None:
        """What was asked for, where somebody asked."""
        return self.result.recipe if self.result is not None else None

    @property
    def title(self) -> str:
        """What to call the dish: as the recipe does, else as its goal is called."""
        if self.recipe is not None and self.recipe.title:
            return self.recipe.title
        return self.goal.label if self.goal is not None else self.name


def best_sighting(known: KnownUnit) -> Sighting | None:
    """Return where a ``known`` unit can best be looked at: the first place with a time and an address, if any."""

    def told(seen: Sighting) -> int:
        return (seen.start is not None and seen.end is not None) + bool(seen.source)

    return max(known.seen_in, key=told, default=None)


def kitchen_of(units: Sequence[FunctionalUnit], kitchen: Kitchen) -> tuple[ObjectNode, ...]:
    """Return what has to be at hand for ``units``: what they take and none newly makes, and utensils at rest.

    ``kitchen`` knows which utensils are at rest.
    """
    made = {node for unit in units for node in newly_made(unit)}
    taken = dict.fromkeys(node for unit in units for node in unit.input_nodes)
    return tuple(n for n in taken if n not in made or (not kitchen.is_food(n) and kitchen.has(n)))
