"""What is exported: a task tree, whatever it was read from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Recipe, Subgraph
from foon_kg.model.tree import newly_made
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.store.snapshot import sightings_of


@dataclass(frozen=True)
class ExportedTree:
    """A task tree: ``units`` in the order of execution, from ``kitchen`` to ``goal``.

    ``goal`` is ``None`` for a FOON file in which no output is marked. ``subgraph`` is the tree as a
    FOON file has it, ``result`` the plan result that it comes from, if any.
    """

    name: str
    units: tuple[KnownUnit, ...]
    kitchen: tuple[ObjectNode, ...]
    goal: ObjectNode | None
    subgraph: Subgraph
    result: PlanResult | None = None

    @classmethod
    def of_plan(cls, result: PlanResult) -> Self:
        """Return the tree of a plan result. Its JSON knows neither the stars of motions nor which nodes move."""
        subgraph = result.to_subgraph()
        units = tuple(
            KnownUnit(annotation.unit, planned.sightings)
            for annotation, planned in zip(subgraph.annotations, result.units, strict=True)
        )
        return cls(subgraph.name, units, result.kitchen, result.goal, subgraph, result)

    @classmethod
    def of_subgraph(cls, subgraph: Subgraph, kitchen: Kitchen) -> Self:
        """Return the tree that the ``subgraph`` of a FOON file tells, each unit seen where the file has it.

        A file names no ``kitchen``: the tree starts from its leaves, and from the empty utensils at rest that it also
        puts back later, as ``foon check`` reads it.
        """
        units = tuple(KnownUnit(unit, (sighting,)) for unit, sighting in sightings_of(subgraph))
        marked = [p.node for known in units for p in known.unit.outputs if p.dish_type]
        leaves = kitchen_of([known.unit for known in units], kitchen)
        return cls(subgraph.name, units, leaves, marked[-1] if marked else None, subgraph)

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


def kitchen_of(units: Sequence[FunctionalUnit], kitchen: Kitchen) -> tuple[ObjectNode, ...]:
    """Return what has to be at hand for ``units``: what they take and none newly makes, and utensils at rest.

    ``kitchen`` knows which utensils are at rest.
    """
    made = {node for unit in units for node in newly_made(unit)}
    taken = dict.fromkeys(node for unit in units for node in unit.input_nodes)
    return tuple(n for n in taken if n not in made or (not kitchen.is_food(n) and kitchen.has(n)))
