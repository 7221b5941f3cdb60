"""Dishes to begin with: what a FOON's own videos make, each planned once before it is offered."""

from __future__ import annotations

from collections.abc import Callable
from itertools import islice
from typing import TYPE_CHECKING

from foon_kg.foon import Answer, Foon, Question
from foon_kg.model.json_fields import JsonObject
from foon_kg.plans.result import PlanResult

if TYPE_CHECKING:
    from foon_kg.evaluation.recorded_dishes import RecordedDish

_TRIED = 3
"""For one dish that is shown at most so many are planned."""


def example_dishes(foon: Foon, answer: Callable[[Question], Answer], most: int) -> list[JsonObject]:
    """Return at most ``most`` recorded dishes of ``foon`` that ``answer`` plans, of as many types as there are.

    Each has its ``name``, its ``dish_type``, its ``ingredients`` in words, the foods among them, the ``video`` that
    makes it and how many steps its plan has.
    """
    found: dict[str, JsonObject] = {}
    for dish in islice(foon.recorded_dishes(), _TRIED * most):
        if len(found) == most:
            break
        if dish.goal.node.label not in found:
            found |= _planned(dish, answer)
    return list(found.values())


def _planned(dish: RecordedDish, answer: Callable[[Question], Answer]) -> dict[str, JsonObject]:
    """Return the dish by its name; nothing for one that cannot be planned."""
    plan = answer(question_of(dish)).outcome
    if not isinstance(plan, PlanResult):
        return {}
    return {
        dish.goal.node.label: {
            "name": dish.goal.node.label,
            "dish_type": dish.goal.dish_type,
            "ingredients": list(dish.texts),
            "foods": [wanted.object for wanted in dish.recipe.ingredients],
            "video": dish.goal.videos[0],
            "units": len(plan.units),
        }
    }


def question_of(dish: RecordedDish) -> Question:
    """Return the question for a recorded ``dish`` in words."""
    return Question(dish_type=dish.recipe.dish_type, texts=dish.texts)
