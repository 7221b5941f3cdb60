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
    bought: dict[ObjectNode, None] = {}
    for leaf in leaves:
        if not kitchen.is_utensil(leaf.label):
            bought[ObjectNode(leaf.label, leaf.states, leaf.ingredients)] = None
    inside = (name for leaf in leaves if kitchen.is_utensil(leaf.label) for name in kitchen.foods_in(leaf))
    named = {node.label for node in bought}
    bought.update(dict.fromkeys(ObjectNode(name) for name in inside if name not in named))
    return tuple(sorted((n for n in bought if not kitchen.is_free(n.label)), key=lambda node: node.sort_key))
