"""Foods that somebody must not or will not eat: what in a recipe and in a tree is such a food.

Matching is cautious, because an allergy is worse than a bland salad: a name is avoided where its words say so
(*walnut halves*), or where WordNet (:mod:`foon_kg.similarity.taxonomy`) or the food groups put it, or a part of its
name, under what is avoided (*walnut oil*), or where it is as a rule made with an allergen that is avoided (mayonnaise
with egg, by ``food/allergens.toml``). What is left out is always said, with the reason.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from functools import lru_cache
from itertools import chain

from foon_kg.food import tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.shipped import shipped
from foon_kg.integration.preparing.preparation import Want, as_there
from foon_kg.integration.preparing.understanding import understood
from foon_kg.integration.teaching.operators import Operators
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen, household_fats
from foon_kg.similarity.groups import food_groups
from foon_kg.similarity.taxonomy import food_taxonomy


def why_avoided(food: str, avoided: Sequence[str]) -> str | None:
    """Return why ``food`` is one of the ``avoided`` foods or kinds of food, as a clause; ``None`` where it is not.

    >>> why_avoided("walnut oil", ["nuts"])
    'walnut belongs to “nuts”'
    """
    reasons = (_why(food, name) for name in avoided)
    return next((reason for reason in reasons if reason is not None), None)


def without_avoided(recipe: Recipe, avoided: Sequence[str]) -> tuple[Recipe, tuple[str, ...]]:
    """Return ``recipe`` without the avoided foods, and a note for each of these.

    Raises :class:`~foon_kg.model.errors.UsageError` where nothing is left of it.
    """
    if not avoided:
        return recipe, ()
    reasons = {wanted: why_avoided(wanted.object, avoided) for wanted in recipe.ingredients}
    kept = tuple(wanted for wanted in recipe.ingredients if reasons[wanted] is None)
    left_out = ((wanted, reason) for wanted, reason in reasons.items() if reason is not None)
    notes = tuple(f"“{wanted.object}” is left out: {reason}" for wanted, reason in left_out)
    if notes and not kept:
        raise UsageError(
            f"nothing is left of the recipe: {'; '.join(notes)}", hint="Avoid less, or add other ingredients."
        )
    return replace(recipe, ingredients=kept), (*_unknown(recipe, avoided), *notes)


def is_known(name: str) -> bool:
    """Return whether a food, or a kind of food, is called ``name``.

    >>> is_known("nuts"), is_known("nutts")
    (True, False)
    """
    wanted = words(canonical(name))
    if tables().foods.is_listed(name) or _kinds(canonical(name)):
        return True
    if any(wanted in _names(called, row) for called, row in shipped("allergens").items()):
        return True
    return any(_has_in_turn(words(kind), wanted) for kind in chain(food_groups().groups, food_taxonomy().names))


def _unknown(recipe: Recipe, avoided: Sequence[str]) -> Iterator[str]:
    """Yield a note for each name that is ``avoided``, of which nothing is known and which leaves nothing out."""
    asked = [wanted.object for wanted in recipe.ingredients]
    for name in avoided:
        if not is_known(name) and all(_why(food, name) is None for food in asked):
            yield _nothing_called(name)


def _nothing_called(name: str) -> str:
    """Return the note that nobody knows what is avoided by ``name``, with what may be meant."""
    from foon_kg.planning.spelling import spelled  # noqa: PLC0415 - few wishes have a word that nobody knows

    near = get_close_matches(name.lower(), food_groups().groups, 1, _CLOSE)
    meant = near[0] if near else spelled(name.lower())
    asked = f": did you mean “{meant}”?" if meant and meant != name.lower() else "."
    return f"no food, and no kind of food, is called “{name}”{asked} Nothing is left out for it."


def kitchen_without(kitchen: Kitchen, avoided: Sequence[str]) -> Kitchen:
    """Return ``kitchen`` in which no avoided food is free to use."""
    free = frozenset(food for food in kitchen.free_foods if why_avoided(food, avoided) is None)
    return kitchen if free == kitchen.free_foods else replace(kitchen, free_foods=free)


def household_fat(
    wants: Sequence[Want], title: str, kitchen: Kitchen, avoided: Collection[str], operators: Operators
) -> Want | None:
    """Return the fat in which a dish of ``wants``, called ``title``, may be fried though nobody asked for any.

    There is none where fat, or what gives its own, is asked, where the title says that it is without, and where all
    that the ``kitchen`` has is ``avoided``. ``operators`` are what the FOON shows.
    """
    if _is_without_fat(wants, title):
        return None
    allowed = (name for name in household_fats(kitchen) if why_avoided(name, tuple(avoided)) is None)
    fats = (_as_there(name, kitchen, operators) for name in allowed)
    return next((fat for fat in fats if not kitchen.lacks(_as_sold(fat))), None)


def _is_without_fat(wants: Sequence[Want], title: str) -> bool:
    """Whether no more fat is due: some of ``wants`` brings its own, or ``title`` says that it is without."""
    told = words(title)
    said = any(_has_in_turn(told, words(phrase)) for phrase in word_list("says that it is without fat"))
    return said or any(want.facts.is_any(word_list("brings fat to the pan")) for want in wants)


def _as_there(name: str, kitchen: Kitchen, operators: Operators) -> Want:
    """Return the fat called ``name`` as ``kitchen`` has it; it was not asked, and has no number of a required food."""
    return as_there(understood(0, RequiredIngredient(name, ""), operators.known, operators), kitchen)


def _as_sold(fat: Want) -> ObjectNode:
    """Return the node of ``fat`` before it is taken."""
    return ObjectNode(fat.label, fat.leaf, (), "in" if fat.storage else None, fat.storage or None)


def names_avoided(node: ObjectNode, avoided: Sequence[str]) -> bool:
    """Return whether ``node`` is an avoided food or says that it contains one."""
    return any(why_avoided(name, avoided) is not None for name in (node.label, *node.ingredients))


_CLOSE = 0.8
"""So alike (0 to 1, by :func:`difflib.get_close_matches`) a kind is called that may be meant."""

_REASONS_KEPT = 1 << 16
"""For so many names, each with one wish, it is kept why they are avoided."""


@lru_cache(maxsize=_REASONS_KEPT)
def _why(food: str, avoided: str) -> str | None:
    wanted = words(canonical(avoided))
    if not wanted:  # no words stand in everything
        return None
    rows = [row for called, row in shipped("allergens").items() if wanted in _names(called, row)]
    made_with = [_is_made_with(food, row) for row in rows]
    if False in made_with:  # its very name says that it is without
        return None
    return _why_named_so(canonical(food), avoided, wanted) or (f"“{avoided}” may be in it" if any(made_with) else None)


def _why_named_so(name: str, avoided: str, wanted: tuple[str, ...]) -> str | None:
    """Return why a food of this ``name`` is ``avoided`` by what it is called, ``wanted`` being the words of that."""
    for part in _parts(name):
        if words(part) == wanted:
            return f"“{avoided}” is to be avoided"
        if part != name and part in word_list("says nothing of what it is"):
            continue
        kind = next((kind for kind in _kinds(part) if _has_in_turn(words(kind), wanted)), None)
        if kind is not None:
            return f"{part} belongs to “{kind}”"
    return None


def _names(called: str, row: Mapping[str, Sequence[str]]) -> set[tuple[str, ...]]:
    """Return the names of the allergen of a ``row``, as words."""
    return {words(name) for name in (called, *row["called"])}


def _is_made_with(food: str, row: Mapping[str, Sequence[str]]) -> bool | None:
    """Return whether ``food`` is as a rule made with the allergen of a ``row``.

    ``False`` where its very name is one of those without, ``None`` where nothing says that it is made with it.
    """
    foods, name = tables().foods, canonical(food)
    own = foods.food(food) if foods.is_listed(food) else foods.food(name)
    names = {own.name, own.taken_for, name}
    if not names.isdisjoint(row["has"]) or not set(_parts(name)).isdisjoint(row["in_names"]):
        return True
    if not names.isdisjoint(row["lacks"]):
        return False
    return True if own.is_of(*row["has"]) and not own.is_of(*row["lacks"]) else None


def _parts(name: str) -> Iterator[str]:
    """Yield ``name`` and all parts of it that are whole words, the longest first."""
    spoken = name.split()
    for length in range(len(spoken), 0, -1):
        for start in range(len(spoken) - length + 1):
            # a part may be a plural or another name of a food, though the whole is neither
            yield canonical(" ".join(spoken[start : start + length]))


def _kinds(name: str) -> tuple[str, ...]:
    """Return the kinds of food that a canonical name belongs to, its groups first."""
    return (*food_groups().of(name), *food_taxonomy().kinds(name))


def _has_in_turn(kind: Sequence[str], wanted: Sequence[str]) -> bool:
    """Return whether the words of ``kind`` have those ``wanted`` beside each other."""
    return any(tuple(kind[start : start + len(wanted)]) == tuple(wanted) for start in range(len(kind)))
