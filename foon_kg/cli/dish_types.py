"""Dish types as options of commands: completed while they are typed, and refused where there is none of the name."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches

from foon_kg.model import DISH_TYPES
from foon_kg.model.errors import UsageError


def dish_types_like(incomplete: str) -> list[str]:
    """Return the dish types whose names begin with ``incomplete``, for the completion of a shell."""
    return [dish_type for dish_type in DISH_TYPES if dish_type.startswith(incomplete)]


def check_dish_types(names: Iterable[str], besides: Sequence[str] = ()) -> None:
    """Raise ``UsageError`` for the first of ``names`` that is no dish type; ``besides`` are words allowed too."""
    allowed = (*besides, *DISH_TYPES)
    unknown = next((name for name in names if name not in allowed), None)
    if unknown is not None:
        meant = get_close_matches(unknown.lower(), allowed, 1)
        asked = f"Did you mean {meant[0]}? " if meant else ""
        raise UsageError(f"“{unknown}” is no dish type", hint=f"{asked}It is one of: {', '.join(allowed)}.")
