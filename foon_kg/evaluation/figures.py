"""What an evaluation of recipes found: by recipe, by dish type, and all in all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

from foon_kg.evaluation.curves import THRESHOLDS, histogram, recipes_over
from foon_kg.evaluation.resampling import Interval, bootstrap_mean
from foon_kg.evaluation.sampling import LeftOut
from foon_kg.evaluation.scores import LineScore, Reason, share_correct
from foon_kg.evaluation.verdicts import ALL, Verdicts, verdict_json
from foon_kg.model import Recipe
from foon_kg.model.json_fields import JsonObject
from foon_kg.plans.result import PlanResult
from foon_kg.validation import Report

_DECIMALS = 6


@dataclass(frozen=True)
class RecipeFigures:
    """One recipe: the score of each line, the confidence of each substitution, and what the judge says of its tree.

    ``error`` says why there is no tree; then there is no ``report``, and no ``result``.
    """

    recipe: Recipe
    scores: tuple[LineScore, ...]
    confidences: tuple[float, ...] = ()
    report: Report | None = field(default=None, repr=False)
    error: str = ""
    result: PlanResult | None = field(default=None, repr=False)

    @property
    def name(self) -> str:
        """The recipe's id, else its title."""
        return self.recipe.id or self.recipe.title or ""

    @property
    def correct(self) -> float:
        """The share of the recipe that is correct, 0 to 1: the sum of its scores by the greatest possible."""
        return share_correct([line.score for line in self.scores])

    def to_json(self) -> JsonObject:
        """Return the recipe's entry under ``recipes``."""
        lines = [
            {"object": s.ingredient.object, "state": s.ingredient.state, "score": s.score, "reason": s.reason.value}
            for s in self.scores
        ]
        return {
            "id": self.name,
            "dish_type": self.recipe.dish_type,
            "correct": round(self.correct, _DECIMALS),
            "lines": lines,
            "confidences": [round(confidence, _DECIMALS) for confidence in self.confidences],
            **verdict_json(self.report),
            "error": self.error or None,
        }


@dataclass(frozen=True)
class DishFigures:
    """Some recipes taken together, as a rule those of one dish type.

    ``correct`` is the share of all their lines, with the interval that drawing the recipes again gives.
    """

    name: str
    recipes: tuple[RecipeFigures, ...]
    correct: Interval

    @classmethod
    def of(cls, name: str, recipes: Sequence[RecipeFigures], seed: int) -> DishFigures:
        """Return ``recipes`` taken together under ``name``, with intervals that are resampled from ``seed``."""
        shares, lines = [recipe.correct for recipe in recipes], [len(recipe.scores) for recipe in recipes]
        return cls(name, tuple(recipes), bootstrap_mean(shares, seed, lines))

    @property
    def lines(self) -> int:
        """How many progress lines were scored."""
        return sum(len(recipe.scores) for recipe in self.recipes)

    @property
    def curve(self) -> dict[int, float]:
        """The share of recipes that are at least so many per cent correct, by threshold."""
        return dict(zip(THRESHOLDS, recipes_over([recipe.correct for recipe in self.recipes]), strict=True))

    @property
    def confidences(self) -> tuple[int, ...]:
        """How many substitutions have a confidence in each tenth from 0 to 1."""
        return histogram([confidence for recipe in self.recipes for confidence in recipe.confidences])

    @property
    def reasons(self) -> dict[Reason, int]:
        """How many lines have their score for which reason."""
        counts = Counter(line.reason for recipe in self.recipes for line in recipe.scores)
        return {reason: counts[reason] for reason in Reason if counts[reason]}

    @cached_property
    def verdicts(self) -> Verdicts:
        """What the judge says of the trees of all these recipes."""
        # kept, since it keeps its counts of the rules
        return Verdicts(tuple(recipe.report for recipe in self.recipes))

    @property
    def without_tree(self) -> tuple[RecipeFigures, ...]:
        """The recipes that got no tree."""
        return tuple(recipe for recipe in self.recipes if recipe.error)

    def to_json(self) -> JsonObject:
        """Return the entry under ``dish_types``."""
        return {
            "dish_type": self.name,
            "recipes": len(self.recipes),
            "lines": self.lines,
            "correct": self.correct.to_json(),
            "curve": [{"threshold": at, "recipes": round(share, _DECIMALS)} for at, share in self.curve.items()],
            "confidences": list(self.confidences),
            "reasons": {reason.value: count for reason, count in self.reasons.items()},
            **self.verdicts.to_json(),
            "without_tree": [recipe.name for recipe in self.without_tree],
        }


@dataclass(frozen=True)
class RecipeEvaluation:
    """What ``foon evaluate recipes`` found: ``foon`` names the FOON by its content."""

    foon: str
    seed: int
    recipes: tuple[RecipeFigures, ...]
    left_out: tuple[LeftOut, ...] = ()

    @cached_property
    def dishes(self) -> tuple[DishFigures, ...]:
        """The figures of each dish type, by name."""
        # kept, as are those of all: 10,000 samples are drawn for the interval of each
        names = sorted({recipe.recipe.dish_type for recipe in self.recipes})
        return tuple(
            DishFigures.of(name, [one for one in self.recipes if one.recipe.dish_type == name], self.seed)
            for name in names
        )

    @cached_property
    def all(self) -> DishFigures:
        """The figures of all recipes."""
        return DishFigures.of(ALL, self.recipes, self.seed)

    def to_json(self) -> JsonObject:
        """Return the evaluation as ``--json`` prints it and ``--compare`` reads it."""
        return {
            "evaluation": "recipes",
            "foon": self.foon,
            "seed": self.seed,
            "dish_types": [dish.to_json() for dish in (*self.dishes, self.all)],
            "left_out": [dish.to_json() for dish in self.left_out],
            "recipes": [recipe.to_json() for recipe in self.recipes],
        }
