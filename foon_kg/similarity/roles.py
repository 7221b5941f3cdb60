"""What a food may do in a dish: a liquid, a protein, a fat. In a slot for it one food stands for another sooner."""

from __future__ import annotations

from functools import cache, lru_cache

from foon_kg.food import tables
from foon_kg.food.lists import word_lists

_PREFIX = "stands in as "


@cache
def roles() -> tuple[str, ...]:
    """Return the names of all roles, sorted."""
    return tuple(sorted(name.removeprefix(_PREFIX) for name in word_lists() if name.startswith(_PREFIX)))


@lru_cache(maxsize=1 << 14)
def roles_of(name: str) -> frozenset[str]:
    """Return the roles that a food of this ``name`` may play, as the table of foods has it."""
    facts = tables().foods.food(name)
    return frozenset(role for role in roles() if not word_lists()[_PREFIX + role].isdisjoint({facts.kind, name}))
