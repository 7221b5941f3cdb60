"""What stands in a list and is no food: headings, their meaning, and words for a part ("frosting") before its foods.

A heading that names no known part is the dish itself, or something made beside it. What stands behind a word for a
part, and makes that as a row of ``food/components.toml`` says, is for it; the word itself is bought by nobody. What
such a part needs of what is listed above it (flour and sugar for a crumble) is a second portion of that.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from foon_kg.food import singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.techniques import Around, Component, Foods, components_for
from foon_kg.food.words import heading_part, is_part
from foon_kg.integration.composing.components import are, have
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import Recipe, RequiredIngredient

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


class Inferred(NamedTuple):
    """A part that a recipe does not name, and the ``places`` of its foods in the list."""

    part: str
    places: tuple[int, ...]


def without_headings(recipe: Recipe) -> Recipe:
    """Return a ``recipe`` without headings that stand in its list as if they were foods.

    What follows one is for the part that it names, up to what is said to be for another.
    """
    if not any(_heading(one) for one in recipe.ingredients):
        return recipe
    return replace(recipe, ingredients=tuple(_headed(recipe.ingredients)))


def _heading(one: RequiredIngredient) -> str:
    """Return the part that a food of a list names which is a heading; ``""`` for any other."""
    first = one.object.lower().split()[:1]
    if not first or first[0] not in word_list("begins a heading"):
        return ""
    part = heading_part(one.object)
    return part if is_part(part) else ""


def _headed(listed: Iterable[RequiredIngredient]) -> Iterator[RequiredIngredient]:
    part, above = "", ""
    before = ""
    for one in listed:
        if found := _heading(one):
            part, above = found, before
        elif part and one.part in {"", above}:
            yield replace(one, part=part)
        else:
            part = ""
            yield one
        before = one.part


def as_opened(recipe: Recipe, wants: Sequence[Want]) -> tuple[Recipe, tuple[Inferred, ...]]:
    """Return a ``recipe`` whose words for parts are no foods, and these parts with the places of their foods.

    ``wants`` are its foods as they are understood. It is returned as it is where no word opens a part.
    """
    by_place = {place: want for want in wants for place in want.places}
    openers = [place for place, want in sorted(by_place.items()) if _may_open(want)]
    if not openers:
        return recipe, ()
    opened = list(_opened(recipe, by_place, openers))
    return _with_parts(recipe, opened) if opened else (recipe, ())


class _Opened(NamedTuple):
    """A ``part`` that the word at a ``place`` opens, up to the place ``end``, and what it takes once ``more``."""

    part: str
    place: int
    end: int
    more: tuple[int, ...]


def _may_open(want: Want) -> bool:
    return not want.part and singular(want.label) in word_list("opens a part")


def _opened(recipe: Recipe, by_place: dict[int, Want], openers: Sequence[int]) -> Iterator[_Opened]:
    ends = [*openers[1:], max(by_place) + 1]
    for place, end in zip(openers, ends, strict=True):
        found = _opened_at(place, end, recipe, by_place)
        if found is not None:
            yield found


def _opened_at(place: int, end: int, recipe: Recipe, by_place: dict[int, Want]) -> _Opened | None:
    """Return the part that the word at a place opens, up to the place ``end``; ``None`` where nothing makes it."""
    title_words = words(recipe.title or "")
    around = Around([want.facts for want in by_place.values()], title_words)
    part = singular(by_place[place].label)
    behind = [want for at, want in sorted(by_place.items()) if place < at < end]
    above = _above(place, by_place)
    for component in components_for({part}):
        if not _is_for(component, part, recipe.dish_type, title_words) or not _is_of(component, behind, around):
            continue
        more = _needed(component, behind, above, around)
        if more is not None:
            return _Opened(part, place, end, more)
    return None


def _above(place: int, by_place: dict[int, Want]) -> dict[int, Want]:
    """Return the foods that are listed above a place, by theirs."""
    return {at: want for at, want in by_place.items() if at < place}


def _is_for(component: Component, part: str, dish_type: str, title_words: Sequence[str]) -> bool:
    """Whether a component that is made of something is such a part of such a dish."""
    technique = component.technique
    typed = not technique.types or dish_type in technique.types
    made = bool(technique.lines) and bool(technique.needs)
    return part in component.parts and typed and made and not technique.is_never(title_words)


def _is_of(component: Component, behind: Sequence[Want], around: Around) -> bool:
    """Whether what stands behind the word for it is anything, and nothing that a component lacks."""
    return bool(behind) and not any(want.part or are(component.lacks, want, around) for want in behind)


def _needed(
    component: Component, behind: Sequence[Want], above: dict[int, Want], around: Around
) -> tuple[int, ...] | None:
    """Return the places of what a component needs besides what stands ``behind``; ``None`` where it is not ``above``.

    One thing that it needs has to stand behind its word.
    """
    needs = component.technique.needs
    lacking = [need for need in needs if not have([need], behind, around)]
    found = [_first(need, above, around) for need in lacking]
    places = tuple(place for place in found if place is not None)
    if len(lacking) == len(needs) or len(places) < len(lacking):
        return None
    return places if _begins(component, [*behind, *map(above.__getitem__, places)], around) else None


def _begins(component: Component, wants: Sequence[Want], around: Around) -> bool:
    """Whether a component begins with one of ``wants``, or with anything."""
    return not component.body or any(are(component.body, want, around) for want in wants)


def _first(need: Sequence[Foods], above: dict[int, Want], around: Around) -> int | None:
    """Return the first place above it of a food of which a dish has more than one portion, and that is needed."""
    stocked = (place for place in sorted(above) if above[place].facts.is_any(word_list("is there for another part")))
    return next((place for place in stocked if are(need, above[place], around)), None)


def _with_parts(recipe: Recipe, opened: Sequence[_Opened]) -> tuple[Recipe, tuple[Inferred, ...]]:
    """Return a recipe without the words that open parts, whose foods are said to be for them, and these parts."""
    foods = dict(enumerate(food for food in recipe.ingredients if food.object))
    said = {place: one.part for one in opened for place in range(one.place + 1, one.end)}
    for one in opened:
        del foods[one.place]
    kept = [replace(food, part=said.get(place, food.part)) for place, food in foods.items()]
    listed = (*kept, *(replace(foods[place], part=one.part, amount="") for one in opened for place in one.more))
    return replace(recipe, ingredients=listed), tuple(Inferred(one.part, _places(one.part, listed)) for one in opened)


def _places(part: str, listed: Sequence[RequiredIngredient]) -> tuple[int, ...]:
    """Return the places of the foods that are for a part."""
    return tuple(place for place, food in enumerate(listed) if food.part == part)
