"""A substitution in words, as pages, the terminal and recipes for people say it."""

from __future__ import annotations

from foon_kg.food.words import singular_word
from foon_kg.model.claims import Substitution


def handled(one: Substitution) -> str:
    """Return how the food of ``one`` substitution is handled, in words that follow its name.

    >>> handled(Substitution("object", "leeks", "leeks", "onion", 0.9))
    'are handled like onion'
    """
    last = one.required.lower().rpartition(" ")[2]
    several = singular_word(last) != last
    if one.for_want:
        has, how = ("have", "are handled") if several else ("has", "is handled")
        return f"{has} no equivalent, and {how} like {one.equivalent} for want of one"
    return f"{'are' if several else 'is'} handled like {one.equivalent}"


def done_like(one: Substitution) -> str:
    """Return what another state, or another motion, is done like.

    >>> done_like(Substitution("state", "leek", "diced", "sliced", 0.9))
    'diced leek is made like sliced leek'
    """
    if one.kind == "state":
        return f"{one.required} {one.object} is made like {one.equivalent} {one.object}"
    return f"to {one.required} the {one.object} is done as to {one.equivalent} it"
