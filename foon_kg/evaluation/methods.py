"""The ways to answer a question that leave-one-out compares: foon-kg, the paper's own method and two baselines."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from foon_kg.integration.methods import TeachingView
from foon_kg.model import FunctionalUnit, Goal, Recipe
from foon_kg.model.errors import NoTreeError
from foon_kg.model.knowledge import Neighbour
from foon_kg.model.names import canonical
from foon_kg.planning.paper import plan_by_the_paper
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.similarity import matching
from foon_kg.similarity.confidences import Confidences, best

Method = Callable[[TeachingView, Recipe], Sequence[FunctionalUnit]]
"""Answers the units of a tree; raises NoTreeError where there is none."""


class SameName:
    """A similarity for which only the same food is like a food."""

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Return 1 for each pair of a ``wanted`` and a ``known`` food of one canonical name, else 0."""
        columns = np.array([canonical(name) for name in known], dtype=object)
        rows = [columns == canonical(name) for name in wanted]
        return np.array(rows, dtype=float).reshape(len(wanted), len(known))

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        """Return of the ``known`` foods the same one as ``name`` first, then the others by name, at most ``limit``."""
        return best(known, self.matrix([name], known)[0], limit)

    def why(self, name: str, known: str) -> tuple[str, ...]:
        """Return what makes ``name`` and a ``known`` food alike."""
        return ("the same food",) if canonical(name) == canonical(known) else ()


def nearest_recipe(view: TeachingView, recipe: Recipe) -> Sequence[FunctionalUnit]:
    """Return the reference tree of the goal in ``view`` whose ingredients are most like those of ``recipe``, unchanged.

    A baseline. Raises NoTreeError where no goal is of its dish type.
    """
    goals = view.goals(recipe.dish_type or None)
    if not goals:
        raise NoTreeError(f"this FOON has no {recipe.dish_type}", code="no-goal")
    foods = list(dict.fromkeys(want.object for want in recipe.ingredients))

    def rank(goal: Goal) -> tuple[float, int]:
        return round(matching(foods, goal.ingredients)[0], 6), -len(goal.ingredients)

    nearest = max(goals, key=rank)
    return [known.unit for known in Planner(view, PlanSettings()).reference_tree(recipe, nearest.node)]


def by_the_paper(view: TeachingView, recipe: Recipe) -> Sequence[FunctionalUnit]:
    """Return the tree for ``recipe`` that the four algorithms of the paper make of ``view``, to the letter."""
    return [unit.as_unit() for unit in plan_by_the_paper(view, recipe).units]


@dataclass(frozen=True)
class Planning:
    """The method that plans with ``settings``, those of foon-kg unless told otherwise."""

    settings: PlanSettings = field(default_factory=PlanSettings)

    def __call__(self, view: TeachingView, recipe: Recipe) -> Sequence[FunctionalUnit]:
        """Return the units of the tree; raises NoTreeError where there is none."""
        return [unit.as_unit() for unit in Planner(view, self.settings).plan(recipe).units]


OURS = "foon-kg"
BASELINES: Mapping[str, Method] = {
    "nearest recipe": nearest_recipe,
    "no similarity": Planning(PlanSettings(similarity=SameName())),
    "paper": by_the_paper,
}
METHODS: Mapping[str, Method] = {OURS: Planning(), **BASELINES}
"""Every method by its name."""
