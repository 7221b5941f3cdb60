"""Dishes to begin with: what a FOON's own videos make, each asked as a cook would ask for it, and planned once."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from itertools import islice

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.foon import Answer, Question, Snapshot
from foon_kg.model import Goal, Recipe
from foon_kg.model.json_fields import JsonObject
from foon_kg.plans.result import PlanResult

_TRIED = 3
"""For one dish that is shown at most so many are planned."""

_FEW, _MANY = 4, 7
"""A dish of so many foods shows what a plan is, and still fits on a card."""


def example_dishes(snapshot: Snapshot, answer: Callable[[Question], Answer], most: int) -> list[JsonObject]:
    """Return at most ``most`` dishes of a FOON, its ``snapshot``, that ``answer`` plans, of as many types as there are.

    Each has its ``name``, its ``dish_type``, its ``ingredients`` in words, the foods among them, the ``video`` that
    makes it and how many steps its plan has.
    """
    found: dict[str, JsonObject] = {}
    for goal in islice(_by_turns(snapshot.goals()), _TRIED * most):
        if len(found) == most:
            break
        if goal.node.label not in found:
            found |= _planned(goal, snapshot, answer)
    return list(found.values())


def _planned(goal: Goal, snapshot: Snapshot, answer: Callable[[Question], Answer]) -> dict[str, JsonObject]:
    """Return the dish by its name; nothing for one that the video does not ask for, or that cannot be planned."""
    asked = _asked(goal, snapshot)
    if asked is None:
        return {}
    plan = answer(_question(asked)).outcome
    if not isinstance(plan, PlanResult):
        return {}
    return {
        goal.node.label: {
            "name": goal.node.label,
            "dish_type": goal.dish_type,
            "ingredients": list(_question(asked).texts),
            "foods": [wanted.object for wanted in asked.ingredients],
            "video": goal.videos[0],
            "units": len(plan.units),
        }
    }


def recorded_dishes(snapshot: Snapshot, most: int) -> Iterator[Question]:
    """Yield at most ``most`` dishes that videos in ``snapshot`` make, as a cook would ask for them, types by turns."""
    asked = (_asked(goal, snapshot) for goal in _by_turns(snapshot.goals()))
    return islice((_question(recipe) for recipe in asked if recipe is not None), most)


def _asked(goal: Goal, snapshot: Snapshot) -> Recipe | None:
    """Return the recipe of a goal's first video; None where the video does not ask for the goal."""
    subgraph = next(one for one in snapshot.subgraphs if one.name == goal.videos[0])
    asked = left_out_video(subgraph, snapshot.kitchen)
    return asked.recipe if asked is not None and asked.recipe.dish_type == goal.dish_type else None


def _question(recipe: Recipe) -> Question:
    texts = tuple(f"{wanted.state} {wanted.object}".strip() for wanted in recipe.ingredients)
    return Question(dish_type=recipe.dish_type, texts=texts)


def _by_turns(goals: tuple[Goal, ...]) -> Iterator[Goal]:
    """Yield a goal of each dish type, those of most videos first, then another of each, and so on."""
    videos, of_type = Counter[str](), defaultdict[str, list[Goal]](list)
    for goal in sorted(goals, key=_rank):
        videos[goal.dish_type] += len(goal.videos)
        of_type[goal.dish_type].append(goal)
    types = sorted(videos, key=lambda name: (-videos[name], name))
    for turn in range(max(map(len, of_type.values()), default=0)):
        yield from (of_type[name][turn] for name in types if turn < len(of_type[name]))


def _rank(goal: Goal) -> tuple[object, ...]:
    """Return what puts those first that show best what a plan is: of some foods, with a name of their own."""
    foods = len(goal.ingredients)
    return (max(_FEW - foods, foods - _MANY, 0), goal.node.label == goal.dish_type, -foods, goal.node.sort_key)
