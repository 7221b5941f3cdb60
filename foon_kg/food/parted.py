"""Foods that come apart when they are opened, and go two ways then: the yolk of an egg and its white."""

from __future__ import annotations

from foon_kg.food.lists import word_list
from foon_kg.food.rows import Food
from foon_kg.food.words import singular

PART = "foam"
"""For what of a dish that is which is beaten by itself."""


def comes_apart(facts: Food, state: str) -> bool:
    """Return whether a food that is asked in ``state`` is asked in its two parts, and somebody has to open it for that.

    ``facts`` are what the tables say of the food.
    """
    return state in word_list("is asked in two parts") and facts.is_any(word_list("comes apart when it is opened"))


def parts_in(label: str) -> tuple[str, str]:
    """Return what a food called ``label`` comes apart into: what stays with the rest, and what is beaten by itself.

    >>> parts_in("eggs")
    ('egg yolks', 'egg whites')
    """
    several = "" if singular(label) == label else "s"
    first, second = min(word_list("stays with the rest")), min(word_list("is beaten by itself"))
    return f"{first}{several}", f"{second}{several}"


def parts_asked(label: str, facts: Food, state: str) -> tuple[str, ...]:
    """Return the names, in the singular, of the parts in which the food ``label`` is asked in ``state``.

    ``facts`` are what the tables say of it. There are none where the food is asked whole.
    """
    return tuple(map(singular, parts_in(label))) if comes_apart(facts, state) else ()
