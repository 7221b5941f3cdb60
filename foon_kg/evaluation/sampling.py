"""Which recipes are asked: dish types that the FOON knows too little of are left out, and samples are drawn."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from foon_kg.model import Goal, Recipe

FEWEST_GOALS = 3
"""A dish type with fewer goals in the FOON is left out, as in the paper."""


@dataclass(frozen=True)
class LeftOut:
    """A dish type that is not evaluated: how many ``goals`` the FOON has for it, and how many were to be asked."""

    dish_type: str
    goals: int
    asked: int

    def to_json(self) -> dict[str, object]:
        """Return it as JSON."""
        return {"dish_type": self.dish_type, "goals": self.goals, "asked": self.asked}


def known_enough(goals: Iterable[Goal]) -> dict[str, int]:
    """Return the dish types with at least three goals, with their counts, sorted by name."""
    counts = Counter(goal.dish_type for goal in goals)
    return {name: counts[name] for name in sorted(counts) if counts[name] >= FEWEST_GOALS}


def left_out(dish_types: Iterable[str], goals: Iterable[Goal]) -> tuple[LeftOut, ...]:
    """Return which of the ``dish_types`` (one for each question) have too few ``goals``, sorted by name."""
    known, asked = Counter(goal.dish_type for goal in goals), Counter(dish_types)
    return tuple(LeftOut(name, known[name], asked[name]) for name in sorted(asked) if known[name] < FEWEST_GOALS)


def drawn(names: Iterable[str], count: int, seed: int, dish_type: str) -> tuple[str, ...]:
    """Return ``count`` of ``names`` drawn at random by ``seed``, sorted; all where there are not more.

    Every ``dish_type`` draws for itself, so that one more of them changes no other's sample.
    """
    there = sorted(set(names))
    if len(there) <= count:
        return tuple(there)
    return tuple(sorted(random.Random(f"{seed} {dish_type}").sample(there, count)))  # noqa: S311 - a draw, no secret


def sampled(recipes: Sequence[Recipe], count: int, seed: int) -> list[Recipe]:
    """Return at most ``count`` recipes of each dish type, drawn by their ids and ``seed``, in their order."""
    kept: set[tuple[str, str]] = set()
    for dish_type in sorted({recipe.dish_type for recipe in recipes}):
        names = (recipe.id or "" for recipe in recipes if recipe.dish_type == dish_type)
        kept.update((dish_type, name) for name in drawn(names, count, seed, dish_type))
    return [recipe for recipe in recipes if (recipe.dish_type, recipe.id or "") in kept]
