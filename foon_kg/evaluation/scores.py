"""Every required ingredient of a tree scored 0, 1 or 2 by its progress line, as people did in the paper's experiment.

The rule (``foon evaluate recipes --help`` says the same). An ingredient is worth

- **2** when its line starts in the kitchen, reaches the asked state by motions that make that state in the FOON, and
  ends in the dish. A state in which the food is sold needs no motion: it only has to be shown.
- **1** when it ends in the dish but its preparation is missing or not supported.
- **0** otherwise, and always where there is no tree.

*Starts in the kitchen*: the first stage of the line is an input of the tree that no earlier unit outputs. *Motions that
make that state*: the motion after which the line first shows the food in the asked state is among those with which
units of the FOON give that state to some food (:class:`~foon_kg.model.knowledge.MadeBy`). *Ends in the dish*: the line
gets to the goal, and the goal names the food, as its label or among its ingredients.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from foon_kg.food import singular
from foon_kg.model import ObjectNode, RequiredIngredient
from foon_kg.model.knowledge import Vocabulary
from foon_kg.model.names import canonical
from foon_kg.model.tree import leaves_of
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.progress import ProgressLine, ProgressStep, progress_lines
from foon_kg.plans.result import PlanResult

MOST = 2
"""The best score of one ingredient."""


class Reason(StrEnum):
    """Why an ingredient has its score."""

    DONE = "as asked"
    SOLD_SO = "as it is sold"
    NOT_FROM_KITCHEN = "does not start in the kitchen"
    NOT_SHOWN = "never in the asked state"
    NOT_PREPARED = "already prepared in the kitchen"
    NOT_SUPPORTED = "by a motion that never makes it so"
    NOT_IN_DISH = "does not end in the dish"
    NO_TREE = "there is no tree"

    @property
    def score(self) -> int:
        """The score that goes with this reason."""
        if self in {Reason.DONE, Reason.SOLD_SO}:
            return MOST
        return 0 if self in {Reason.NOT_IN_DISH, Reason.NO_TREE} else 1


@dataclass(frozen=True)
class LineScore:
    """A required ingredient, its progress line (``None`` without a tree), and what that is worth."""

    ingredient: RequiredIngredient
    reason: Reason
    line: ProgressLine | None = None

    @property
    def score(self) -> int:
        """0, 1 or 2."""
        return self.reason.score


class Rule:
    """The rule for trees that were planned from a FOON with the words of ``vocabulary``."""

    def __init__(self, vocabulary: Vocabulary, kitchen: Kitchen) -> None:
        self.kitchen = kitchen
        self.made_by = frozenset((canonical(row.state), row.motion) for row in vocabulary.motions)

    def scores(self, result: PlanResult) -> tuple[LineScore, ...]:
        """Return the score of each ingredient that the recipe of ``result`` names, each once, in its order."""
        units = [unit.as_unit() for unit in result.units]
        asked = wanted(result.recipe.ingredients)
        kitchen = self.kitchen.with_foods(want.object for want in asked)
        leaves = leaves_of(units)
        scores = []
        for want in asked:
            (line,) = progress_lines(units, result.goal, [want], kitchen)
            scores.append(LineScore(want, self._reason(want, line, leaves, result.goal), line))
        return tuple(scores)

    def _reason(
        self, want: RequiredIngredient, line: ProgressLine, leaves: Sequence[ObjectNode], goal: ObjectNode
    ) -> Reason:
        food = singular(want.object)
        if line.end_product is None or food not in {singular(goal.label), *map(singular, goal.ingredients)}:
            return Reason.NOT_IN_DISH
        if not line.steps or not any(_is(line.steps[0], leaf) for leaf in leaves):
            return Reason.NOT_FROM_KITCHEN
        place = _first_in_state(line, food, want.state)
        if place is None:
            return Reason.NOT_SHOWN
        if self.kitchen.is_start_state(want.object, want.state):
            return Reason.SOLD_SO
        if place == 0:
            return Reason.NOT_PREPARED
        supported = (canonical(want.state), line.steps[place - 1].motion) in self.made_by
        return Reason.DONE if supported else Reason.NOT_SUPPORTED


def without_tree(ingredients: Iterable[RequiredIngredient]) -> tuple[LineScore, ...]:
    """Return the scores of a recipe that got no tree: 0 for each of its ``ingredients``."""
    return tuple(LineScore(want, Reason.NO_TREE) for want in wanted(ingredients))


def share_correct(scores: Sequence[int]) -> float:
    """Return the sum of ``scores`` (0 to 2) by the greatest that it could be.

    0 for a recipe that names no ingredient.
    """
    return sum(scores) / (MOST * len(scores)) if scores else 0.0


def wanted(ingredients: Iterable[RequiredIngredient]) -> tuple[RequiredIngredient, ...]:
    """Return each of the ``ingredients`` once in each of its states, as the planner does.

    Those without a food are left out.
    """
    return tuple(dict.fromkeys(want for want in ingredients if want.object))


def _first_in_state(line: ProgressLine, food: str, state: str) -> int | None:
    """Return the place of the first step at which ``food`` itself is in ``state``."""
    asked = canonical(state)
    for place, step in enumerate(line.steps):
        if singular(step.object) == food and asked in map(canonical, step.states):
            return place
    return None


def _is(step: ProgressStep, node: ObjectNode) -> bool:
    """Whether a step of a progress line is ``node``; a vessel stands in its own place."""
    if step.object:
        place = (step.object, step.relation, step.container)
        return place == (node.label, node.relation, node.container) and step.states == node.states
    return step.container == node.label and step.states == node.states
