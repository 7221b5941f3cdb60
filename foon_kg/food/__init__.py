"""What is known of cooking, as data: foods, states, motions, utensils and dishes, with one loader.

``tables()`` returns all of it. The files beside this one (``foods.toml`` …) are the only place where foon-kg knows
anything of cooking; add a food, a motion or a tool there. Nothing here knows a task tree.
"""

from __future__ import annotations

from foon_kg.food.rows import Dish, Food, Kind, Level, Match, Motion, State, Utensil
from foon_kg.food.tables import Tables, tables
from foon_kg.food.words import is_among, is_unbaked, plain_words, singular, words

__all__ = [
    "Dish", "Food", "Kind", "Level", "Match", "Motion", "State", "Tables", "Utensil",
    "is_among", "is_unbaked", "plain_words", "singular", "tables", "words",
]  # fmt: skip
