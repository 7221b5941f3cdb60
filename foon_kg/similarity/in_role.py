"""What stands for a food where it plays a role: a liquid, a protein, a fat."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.model.errors import UsageError
from foon_kg.model.knowledge import Neighbour
from foon_kg.similarity.confidences import best
from foon_kg.similarity.food import food_similarity
from foon_kg.similarity.roles import roles


def in_role(name: str, known: Sequence[str], role: str, limit: int) -> tuple[Neighbour, ...]:
    """Return the at most ``limit`` of ``known`` that a cook takes for ``name`` where it plays ``role``, best first.

    Ties are by name. Raises ``UsageError`` for a role that nobody knows.
    """
    if role not in roles():
        raise UsageError(f"no food is known to be there as “{role}”", hint=f"Write one of {', '.join(roles())}.")
    return best(known, food_similarity().in_slot(name, known, role), limit)
