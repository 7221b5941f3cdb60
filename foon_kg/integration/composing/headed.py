"""What a heading means that names no known part of a dish: the dish itself, or something made beside it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import words
from foon_kg.food.lists import says, word_list
from foon_kg.food.words import is_part
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import Recipe

SIDE = "side"
"""The part of what is made beside a dish, as a heading of a name of its own says it."""

_WHOSE = re.compile(r"['\u2019]s\b", re.IGNORECASE)


def as_headed(recipe: Recipe, wants: Sequence[Want]) -> Recipe:
    """Return a recipe whose foods are all for known parts; ``wants`` are its foods as they are understood."""
    names = {one.part for one in recipe.ingredients if one.part and not is_part(one.part)}
    known = {name: _part_called(name, recipe, [want for want in wants if want.part == name]) for name in names}
    if not known:
        return recipe
    foods = (replace(one, part=known.get(one.part, one.part)) for one in recipe.ingredients)
    return replace(recipe, ingredients=tuple(foods))


def _part_called(name: str, recipe: Recipe, wants: Sequence[Want]) -> str:
    """Return the part that a heading calls by ``name``, above these ``wants``; ``""`` for the dish itself."""
    called = words(name)
    dish = {*_before_with(recipe.title or ""), *words(recipe.dish_type or "")}
    if says((name, *called), "is a dough by its name"):
        return "dough" if any(want.facts.is_a("flour") for want in wants) else ""
    if says((name, *called), "is the dish itself") or not dish.isdisjoint(called):
        return ""
    if any(want.facts.is_any(word_list("is the main part")) for want in wants):
        return ""
    return SIDE


def _before_with(title: str) -> Sequence[str]:
    """Return the words of a title that call the dish, without whose it is, and what it is served with."""
    told = words(" ".join(_WHOSE.split(title)))  # the s of a shepherd's pie is no "with"
    ends = (place for place, word in enumerate(told) if word in word_list("says what it is served with"))
    return told[: next(ends, len(told))]
