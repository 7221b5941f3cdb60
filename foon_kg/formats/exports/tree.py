"""What is exported: a task tree, whatever it was read from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from foon_kg.food.motion_costs import NO_COSTS, MotionCosts
from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Recipe, Sighting, Subgraph, steps_of
from foon_kg.model.tree import newly_made
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.search.classic import RetrievalResult


@dataclass(frozen=True)
class ExportedTree:
    """A task tree: ``units`` in the order of execution, from ``kitchen`` to ``goal``.

    ``goal`` is ``None`` for a FOON file in which no output is marked. ``subgraph`` is the tree as a
    FOON file has it, ``result`` the plan result that it comes from, if any; ``costs`` are the weights of
    its motions with which it was retrieved.
    """

    name: str
    units: tuple[KnownUnit, ...]
    kitchen: tuple[ObjectNode, ...]
    goal: ObjectNode | None
    subgraph: Subgraph
    result: PlanResult | None = None
    costs: MotionCosts = NO_COSTS

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
