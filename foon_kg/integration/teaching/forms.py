"""In which form a food is handled: it runs, is a powder, is soft, comes in pieces, or is whole.

What brings, cuts or cooks a food is chosen by its form where nothing is known of the food itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from foon_kg.food import Food, Tables
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import POWDER

_SOLD_SOFT = frozenset({"creamy", "paste", "sauce", "jelly", "thick liquid", "thick sauce", "whipped"})
"""As what a shop sells a food that is scooped or spread."""

_SOLD_FINE = frozenset({"ground", "granulated", "powder", "dried"})
"""As what a shop sells a food that is strewn or poured, where its kind is one that comes so."""


def is_scooped(states: Sequence[str]) -> bool:
    """Return whether a food is scooped or spread by its ``states``: a sauce of beans, and no bean in its water."""
    return not _SOLD_SOFT.isdisjoint(states)


def is_liquid_fat(facts: Food) -> bool:
    """Return whether a food of these ``facts`` is fat that runs as it is sold: what is fried in it stays apart."""
    return facts.is_a("fat") and facts.is_a("liquid")


@lru_cache(maxsize=1 << 14)
def form_of(known: Tables, label: str, states: tuple[str, ...]) -> str:
    """Return how a food called ``label`` in ``states`` is handled: liquid, powder, soft, pieces or whole.

    ``known`` are the tables. What runs comes first, be it solid as it is sold (melted butter); stock that is no powder
    (rice) is handled in pieces, as nobody takes a single grain.
    """
    facts = known.foods.food(label, states)
    if _runs(facts, states):
        return "liquid"
    if facts.is_a("creamy") or is_scooped((facts.sold_as, *states)):
        return "soft"
    if facts.is_a("spice", "leaven", "flour", "sweet", "stock") and facts.sold_as in _SOLD_FINE:
        return "powder"
    finest = max((known.state(state).fineness for state in states), default=0)
    if finest >= POWDER:
        return "soft"
    return "pieces" if finest > 0 or facts.is_a("stock") else "whole"


def _runs(facts: Food, states: Sequence[str]) -> bool:
    """Whether a food is liquid, was made so, or comes with its liquid out of a can."""
    made_so = says(states, "runs")
    return made_so or facts.is_a("liquid", "water", *word_list("runs out of its can"))
