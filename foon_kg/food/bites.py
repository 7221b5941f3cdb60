"""How a dish is eaten, as its type and title tell: with a spoon or fork alone, or with a knife beside it."""

from __future__ import annotations

from collections.abc import Collection

from foon_kg.food.lists import says
from foon_kg.food.rows import Dish


def is_eaten_by_bites(told: Collection[str], dishes: Collection[Dish]) -> bool:
    """Return whether whoever eats a dish has no knife, so that nothing in it may be more than a bite.

    ``told`` are the words of its type and title, ``dishes`` those that these name.
    """
    if any(dish.stacked or dish.laid for dish in dishes):
        return False
    knife = says(told, "is eaten with a knife")
    return says(told, "is eaten by bites") and (not knife or says(told, "is eaten by bites whatever is in it"))
