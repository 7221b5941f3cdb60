"""What a food may do in a dish: a liquid, a protein, a fat. In a slot for it one food stands for another sooner."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from foon_kg.food import tables
from foon_kg.food.lists import word_lists
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.model.knowledge import Neighbour

_PREFIX = "stands in as "


@cache
def roles() -> tuple[str, ...]:
    """Return the names of all roles, sorted."""
    return tuple(sorted(name.removeprefix(_PREFIX) for name in word_lists() if name.startswith(_PREFIX)))


@lru_cache(maxsize=1 << 14)
def roles_of(name: str) -> frozenset[str]:
    """Return the roles that a food may play, as the table of foods has it."""
    facts = tables().foods.food(name)
    return frozenset(role for role in roles() if not word_lists()[_PREFIX + role].isdisjoint({facts.kind, name}))


def in_role(name: str, known: Sequence[str], role: str, limit: int) -> tuple[Neighbour, ...]:
    """Return the known foods that a cook takes for ``name`` where it plays ``role``, best first, ties by name.

    Raises ``UsageError`` for a role that nobody knows.
    """
    from foon_kg.similarity.answers import best  # noqa: PLC0415 - the similarity itself asks for roles
    from foon_kg.similarity.food import food_similarity  # noqa: PLC0415

    if role not in roles():
        raise UsageError(f"no food is known to be there as “{role}”", hint=f"Write one of {', '.join(roles())}.")
    return best(known, food_similarity().in_slot(name, known, role), limit)
