"""What dishes are called: which dish type is meant by a dish's own name, as ``called.toml`` says."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from foon_kg.food.shipped import shipped
from foon_kg.food.words import singular
from foon_kg.model import DISH_TYPES


def dish_type_called(name: str) -> str | None:
    """Return the dish type of a dish called ``name`` (“mushroom risotto”: rice), or ``None`` where none is known.

    The longest name at the end of ``name`` says it, else the last word of it that is a dish type.
    """
    told = singular(name.lower()).split()
    ends = (" ".join(told[place:]) for place in range(len(told)))
    return next((types for end in ends if (types := _dish_types().get(end))), None)


@cache
def _dish_types() -> Mapping[str, str]:
    """Return the dish type of every name, both by their singulars."""
    rows: Mapping[str, list[str]] = shipped("called")["dish_types"]
    called = {singular(name): dish_type for dish_type, names in rows.items() for name in names}
    return called | {singular(dish_type): dish_type for dish_type in DISH_TYPES}
