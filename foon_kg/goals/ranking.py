"""Algorithm 1, identify_goal_node: which recorded dish is most like the one asked for."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain, takewhile

from foon_kg.food.lists import word_list
from foon_kg.kitchen import words
from foon_kg.knowledge import LikelyGoals
from foon_kg.model import Goal, RequiredIngredient
from foon_kg.names import canonical
from foon_kg.similarity.groups import food_groups

NEAR = 0.05
"""Goals whose scores differ by no more than this are a near tie: how sure a name is, is not known more exactly."""

LOOKED_AT, MORE = 64, 4
"""How many goals are compared with a recipe at first, and how many times as many where these do not tell."""

_SLACK = 1e-9  # sums of confidences depend on their order in the last bits

_DISHES = word_list("groups of dishes")
"""The groups of foods (``data/food-groups.txt``) in which only dishes are."""


@dataclass(frozen=True)
class RankedGoal:
    """A goal with its likeness to a recipe.

    ``score`` is the greatest sum of name confidences when every required food is matched with at most one
    ingredient of the goal and every ingredient with at most one food. ``misnamed`` are foods in the goal's label
    that the recipe does not have (a *carrot* salad without carrot).
    """

    goal: Goal
    score: float
    misnamed: tuple[str, ...]


def rank_goals(
    goals: Collection[Goal],
    wants: Sequence[RequiredIngredient],
    *,
    name_confidence: Callable[[str, str], float],
    known_foods: frozenset[str],
    dish_type: str | None = None,
) -> tuple[RankedGoal, ...]:
    """Answer ``goals`` from the most to the least like the recipe; ``dish_type`` is ``None`` where none was asked.

    The order is: truly named before misnamed, then score (in hundredths), then fewer ingredients that nobody asked
    for, then the goal's node, then its dish type. The paper counts pairs above a threshold
    (``similarity.count_similar``); a matching counts each food once.
    """
    objects = sorted({want.object for want in wants})
    named = {name for goal in goals for name in goal.ingredients}
    pairs = {name: [(-name_confidence(object_, name), object_, name) for object_ in objects] for name in sorted(named)}
    ranked = [
        RankedGoal(
            goal,
            _match(chain.from_iterable(pairs[name] for name in goal.ingredients)),
            _misnamed(goal, objects, known_foods, dish_type or goal.dish_type),
        )
        for goal in goals
    ]
    return tuple(sorted(ranked, key=_order))


def _order(ranked: RankedGoal) -> tuple[object, ...]:
    return (
        len(ranked.misnamed),
        -round(ranked.score, 2),
        len(ranked.goal.ingredients),
        ranked.goal.node.sort_key,
        ranked.goal.dish_type,
    )


def likeliest(
    ask: Callable[[int], LikelyGoals], rank: Callable[[LikelyGoals], Sequence[RankedGoal]], least: int
) -> Sequence[RankedGoal]:
    """Answer the likeliest goals in the order of ``rank``, ``least`` of them at least where there are so many.

    ``ask`` answers so many goals, or more, among which the likeliest are; it is asked for more and more of them until
    nothing that it did not answer can come before one of the first ``least``.
    """
    count = LOOKED_AT
    while True:
        likely = ask(count)
        ranked = _settled(rank(likely), likely.most)
        if likely.most is None or len(ranked) >= least:
            return ranked
        count *= MORE


def _settled(ranked: Sequence[RankedGoal], most: float | None) -> Sequence[RankedGoal]:
    """Answer the head of ``ranked`` that stays what it is, whichever other goals of a score up to ``most`` there are.

    There are no others where ``most`` is ``None``.
    """
    if most is None:
        return ranked
    most = round(most + _SLACK, 2)
    return list(takewhile(lambda goal: not goal.misnamed and round(goal.score, 2) > most, ranked))


def near_ties(ranked: Sequence[RankedGoal]) -> int:
    """Answer how many goals at the head of ``ranked`` are so nearly alike that only their trees can tell them apart.

    Those are the goals that are as truly named as the first one and have at most ``NEAR`` less of its score.
    """
    if not ranked:
        return 0
    first = ranked[0]
    near = (len(goal.misnamed) == len(first.misnamed) and round(first.score - goal.score, 2) <= NEAR for goal in ranked)
    return sum(takewhile(bool, near))


def _match(pairs: Iterable[tuple[float, str, str]]) -> float:
    """Match greedily, surest pair first: within a factor of two of the best matching, and the same on real recipes.

    A pair is the confidence below zero, a required food and an ingredient.
    """
    taken_objects, taken_ingredients, score = set[str](), set[str](), 0.0
    for negative, name, ingredient in sorted(pairs):
        if name not in taken_objects and ingredient not in taken_ingredients:
            taken_objects.add(name)
            taken_ingredients.add(ingredient)
            score -= negative
    return score


def _misnamed(
    goal: Goal,
    objects: Sequence[str],
    known_foods: frozenset[str],
    dish_type: str,
) -> tuple[str, ...]:
    """Answer the foods that the goal's label names and the recipe does not have; the dish type's word apart."""
    spoken = words(goal.node.label)
    apart = set(words(dish_type))
    there = [set(words(name)) for name in objects]
    named = {
        " ".join(spoken[start:end])
        for start in range(len(spoken))
        for end in range(start + 1, len(spoken) + 1)
        if end - start < len(spoken) or len(spoken) == 1
    }
    foods = {name for name in named if name in known_foods and not set(name.split()) & apart}
    foods.discard(" ".join(spoken))
    foods -= _dish_in(goal.node.label)
    return tuple(sorted(name for name in foods if not any(set(name.split()) <= food for food in there)))


@cache
def _dish_in(label: str) -> frozenset[str]:
    """Answer the names at the end of a goal's label that say what kind of dish it is: muffin, fries, but not rice."""
    spoken = label.split()
    endings = (spoken[start:] for start in range(1, len(spoken)))
    return frozenset(" ".join(words(" ".join(ending))) for ending in endings if _is_dish(" ".join(ending)))


def _is_dish(name: str) -> bool:
    groups = food_groups().of(canonical(name))
    return bool(groups) and _DISHES.issuperset(groups)
