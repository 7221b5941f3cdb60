"""Lists of words that say nothing of one food, state, motion or utensil, read from ``lists.toml``.

What is known of one word stands in the row of that word in the other tables; a list here says which words belong
together for one question of the program ("which foods are free", "which motions go on by themselves").
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from functools import cache

from foon_kg.food.shipped import shipped


@cache
def word_list(name: str) -> frozenset[str]:
    """Return the words of the list ``name``, as ``word_list("free foods")``; KeyError for a list that is not there."""
    return word_lists()[name]


def names_in(name: str) -> Collection[str]:
    """Return the names of the family of dishes ``name``, or the words of the list that is called so; else KeyError."""
    return shipped("families")["families"].get(name) or word_list(name)


def says(told: Iterable[str], what: str) -> bool:
    """Whether one of the words that are ``told`` is of the list ``what``, as ``says(states, "runs")``.

    KeyError for a list that is not there.
    """
    return not word_list(what).isdisjoint(told)


@cache
def word_lists() -> Mapping[str, frozenset[str]]:
    """Return every list by its name."""
    return {name: frozenset(words) for name, words in shipped("lists").items()}
