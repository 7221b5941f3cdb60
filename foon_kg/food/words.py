"""The words of a name: in lower case and in the singular, so that what two people write of one thing meets."""

from __future__ import annotations

import functools
import re
from collections.abc import Collection

from foon_kg.food.lists import word_list

_WORD = re.compile(r"[^\W\d_]+")
_IRREGULAR = {
    "chilies": "chili", "chillies": "chilli", "halves": "half", "knives": "knife", "leaves": "leaf", "loaves": "loaf",
}  # fmt: skip
_PLURALS = (("ies", "y"), ("oes", "o"), ("ches", "ch"), ("shes", "sh"), ("sses", "ss"), ("xes", "x"), ("s", ""))
_NO_PLURAL = ("ss", "us", "is")
_SHORT = 3


@functools.lru_cache(maxsize=1 << 16)
def words(name: str) -> tuple[str, ...]:
    """Return the words of a name, in lower case and in the singular: ``Bell Peppers`` → bell, pepper."""
    return tuple(singular_word(word) for word in _WORD.findall(name.lower()))


@functools.lru_cache(maxsize=1 << 16)
def singular(name: str) -> str:
    """Return a name with every word in the singular: labels of a FOON are, its ``{}`` names often are not."""
    return " ".join(words(name))


def singular_word(word: str) -> str:
    """Return one word, in lower case already, in the singular."""
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    one = word.removesuffix("s")
    if one.endswith("ie") and one in word_list("ends in ie"):
        return one
    for ending, one in _PLURALS:
        if word.endswith(ending) and len(word) > max(_SHORT, len(ending) + 1) and not word.endswith(_NO_PLURAL):
            word = word[: -len(ending)] + one
            break
    # cookies and cookie must meet somewhere, and the plural alone does not tell them from cherries
    return word[:-2] + "y" if word.endswith("ie") and len(word) > _SHORT else word


@functools.lru_cache(maxsize=1 << 14)
def plain_words(text: str) -> frozenset[str]:
    """Return the words of a motion or a state as they are written, in lower case."""
    return frozenset(_WORD.findall(text.lower()))


def is_among(name: str, names: Collection[str]) -> bool:
    """Return whether a food is among others, in the same words or with more (broth, chicken broth)."""
    own = name.split()
    for other in names:
        theirs = other.split()
        nested = set(own) <= set(theirs) or set(theirs) <= set(own)
        if theirs and own and nested and (own[0] == theirs[0] or own[-1] == theirs[-1]):
            return True
    return False


def is_unbaked(title: str) -> bool:
    """Whether a title says that the dish is made without an oven: a no-bake cheesecake, on the stovetop."""
    told = title.lower().replace("-", " ")
    return "no bake" in told or not word_list("is made on a stove").isdisjoint(words(told))
