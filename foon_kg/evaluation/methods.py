"""The ways to answer a question that leave-one-out compares: foon-kg whole, baselines, and foon-kg without a part."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from foon_kg.knowledge import KnowledgeView, Neighbour
from foon_kg.model import FunctionalUnit, Recipe
from foon_kg.names import canonical
from foon_kg.planner import Planner
from foon_kg.settings import PlanSettings, Rules
from foon_kg.similarity.answers import Confidences, best

Method = Callable[[KnowledgeView, Recipe], Sequence[FunctionalUnit]]
"""Answers the units of a tree; raises NoTreeError where there is none."""


class SameName:
    """A similarity for which only the same food is like a food."""

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Answer 1 for equal canonical names, else 0."""
        columns = np.array([canonical(name) for name in known], dtype=object)
        rows = [columns == canonical(name) for name in wanted]
        return np.array(rows, dtype=float).reshape(len(wanted), len(known))

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        """Answer the same food first, then the others by name."""
        return best(known, self.matrix([name], known)[0], limit)

    def why(self, name: str, known: str) -> tuple[str, ...]:
        """Answer what makes two names alike."""
        return ("the same food",) if canonical(name) == canonical(known) else ()


def same_state(one: str, other: str) -> float:
    """Answer 1 for the same state, else 0."""
    return float(canonical(one) == canonical(other))


def nearest_recipe(view: KnowledgeView, recipe: Recipe) -> Sequence[FunctionalUnit]:
    """Answer the reference tree of the goal that algorithm 1 finds nearest, unchanged."""
    planner = Planner(view, PlanSettings())
    goal, _ = planner.reference_question(recipe)
    return [known.unit for known in planner.reference_tree(recipe, goal.goal.node)]


@dataclass(frozen=True)
class Planning:
    """The method that plans with ``settings``, those of foon-kg unless told otherwise."""

    settings: PlanSettings = field(default_factory=PlanSettings)

    def __call__(self, view: KnowledgeView, recipe: Recipe) -> Sequence[FunctionalUnit]:
        """Answer the units of the tree; raises NoTreeError where there is none."""
        return [unit.as_unit() for unit in Planner(view, self.settings).plan(recipe).units]


OURS = "foon-kg"
BASELINES: Mapping[str, Method] = {
    "nearest recipe": nearest_recipe,
    "no substitution": Planning(PlanSettings(similarity=SameName(), state_similarity=same_state)),
}
PARTS: Mapping[str, Method] = {
    "no similarity": Planning(PlanSettings(similarity=SameName())),
    "no state classes": Planning(PlanSettings(state_similarity=same_state)),
    "no motion choice": Planning(PlanSettings(rules=Rules(motions=False))),
    "no joining rule": Planning(PlanSettings(rules=Rules(joining=False))),
    "no own steps": Planning(PlanSettings(rules=Rules(carriers=False))),
    "first goal only": Planning(PlanSettings(rules=Rules(ties=False))),
    "greedy search": Planning(PlanSettings(time_limit=0.0)),
}
"""The planner without one of its parts each; a search without time answers the cheapest producers and compares none."""
METHODS: Mapping[str, Method] = {OURS: Planning(), **BASELINES, **PARTS}
"""Every method by its name."""


def methods(*, parts: bool) -> tuple[str, ...]:
    """Answer the names of the methods to be compared, ours first; with ``parts`` those without one of our parts too."""
    return (OURS, *BASELINES, *(PARTS if parts else ()))
