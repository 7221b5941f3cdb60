"""Lists of words that say nothing of one food, state, motion or utensil, read from ``lists.toml``.

What is known of one word stands in the row of that word in the other tables; a list here says which words belong
together for one question of the program ("which foods are free", "which motions go on by themselves").
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from functools import cache
from itertools import combinations

from foon_kg.food.shipped import shipped


@cache
def word_list(name: str) -> frozenset[str]:
    """Return the words of the list ``name``, as ``word_list("free foods")``; KeyError for a list that is not there."""
    return word_lists()[name]


def names_in(name: str) -> Collection[str]:
    """Return the names of the family of dishes ``name``, or the words of the list that is called so; else KeyError."""
    return shipped("families")["families"].get(name) or word_list(name)


@cache
def longer_names() -> Mapping[tuple[str, ...], Collection[tuple[str, ...]]]:
    """Return the words of each name of a family that stands in longer ones of another, with the words of these.

    An esfiha aberta is no esfiha, nor is a bolo bao a bao.
    """
    families: Mapping[str, Collection[str]] = shipped("families")["families"]
    family_of = {tuple(name.split()): family for family, names in families.items() for name in names}
    found: defaultdict[tuple[str, ...], list[tuple[str, ...]]] = defaultdict(list)
    for name, family in family_of.items():
        for start, end in combinations(range(len(name) + 1), 2):
            if family_of.get(name[start:end], family) != family:
                found[name[start:end]].append(name)
    return found


def says(told: Iterable[str], what: str) -> bool:
    """Whether one of the words that are ``told`` is of the list ``what``, as ``says(states, "runs")``.

    KeyError for a list that is not there.
    """
    return not word_list(what).isdisjoint(told)


@cache
def word_lists() -> Mapping[str, frozenset[str]]:
    """Return every list by its name."""
    return {name: frozenset(words) for name, words in shipped("lists").items()}
