"""The answer to a recipe examined: its lines scored by the rule, its tree put before the judge."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.evaluation.figures import RecipeFigures
from foon_kg.evaluation.scores import Rule, without_tree
from foon_kg.model import Goal, KnownUnit
from foon_kg.model.knowledge import Vocabulary
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanFailure, PlanResult
from foon_kg.validation import KnownFoon, check, tree_from_json


class Examiner:
    """Examines answers that were planned from one FOON."""

    def __init__(
        self, units: Sequence[KnownUnit], goals: Sequence[Goal], vocabulary: Vocabulary, kitchen: Kitchen
    ) -> None:
        self.free = kitchen.free_foods
        self.foon = KnownFoon.of(units, goals)
        self.rule = Rule(vocabulary, kitchen)

    def examine(self, outcome: PlanResult | PlanFailure) -> RecipeFigures:
        """Return the figures of one ``outcome``; a recipe without a tree has nothing correct, and nobody accepts it."""
        recipe = outcome.recipe
        if isinstance(outcome, PlanFailure):
            return RecipeFigures(recipe, without_tree(recipe.ingredients), error=outcome.message)
        return RecipeFigures(
            recipe,
            self.rule.scores(outcome),
            tuple(substitution.confidence for substitution in outcome.substitutions),
            check(tree_from_json(outcome.to_json()), self.foon, self.free),
            result=outcome,
        )
