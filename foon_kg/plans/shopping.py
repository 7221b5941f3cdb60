"""The shopping list: what has to be in the kitchen before the first step, utensils apart."""

from __future__ import annotations

from collections.abc import Iterable

from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen


def shopping_list(leaves: Iterable[ObjectNode], kitchen: Kitchen) -> tuple[ObjectNode, ...]:
    """Return the foods among the ``leaves`` of a tree as one buys them, sorted by name.

    ``kitchen`` tells foods from utensils. Where a food lies is nothing to buy, so that onions in a bag and onions on a
    board are one line; free foods (water) are not bought. A food that is only known to be in a packet or bottle is a
    line of its own.
    """
    foods: set[ObjectNode] = set()
    inside: set[str] = set()
    for leaf in leaves:
        if kitchen.is_utensil(leaf.label):
            inside.update(kitchen.foods_in(leaf))
        else:
            foods.add(ObjectNode(leaf.label, leaf.states, leaf.ingredients))
    foods.update(map(ObjectNode, inside - {food.label for food in foods}))
    return tuple(sorted((food for food in foods if not kitchen.is_free(food.label)), key=lambda food: food.sort_key))
