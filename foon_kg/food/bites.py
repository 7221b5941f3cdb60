"""How a dish is eaten, as its type and title tell: with a spoon or fork alone, or with a knife beside it."""

from __future__ import annotations

from collections.abc import Collection

from foon_kg.food.lists import says, word_lists
from foon_kg.food.rows import Dish, Food


def stays_whole(food: Food, states: Collection[str], dish_type: str) -> bool:
    """Return whether a ``food`` that is asked in one of these ``states`` stays in one piece in such a dish.

    An olive that is asked whole does in a salad of ``dish_type`` "salad"; a carrot does not.
    """
    kinds = word_lists().get(f"stays whole in {dish_type}", frozenset())
    return food.is_any(kinds) and says(states, "is asked in one piece")


def is_eaten_by_bites(told: Collection[str], dishes: Collection[Dish]) -> bool:
    """Return whether whoever eats a dish has no knife, so that nothing in it may be more than a bite.

    ``told`` are the words of its type and title, ``dishes`` those that these name.
    """
    if any(dish.stacked or dish.laid for dish in dishes):
        return False
    knife = says(told, "is eaten with a knife")
    return says(told, "is eaten by bites") and (not knife or says(told, "is eaten by bites whatever is in it"))
