"""What of a recipe's foods is made apart: its components, and the two parts of what is asked in them."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from foon_kg.food import Tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.parted import PART, comes_apart, parts_in
from foon_kg.food.rows import Dish
from foon_kg.food.techniques import Around, Technique
from foon_kg.integration.composing.assigning import MAIN, line_told, means
from foon_kg.integration.composing.components import Side, are, sides_of
from foon_kg.integration.composing.headed import SIDE
from foon_kg.integration.composing.techniques import technique_for
from foon_kg.integration.preparing.preparation import SECOND, Want
from foon_kg.model import Recipe

_PARTED = 5 * SECOND
"""Above this are the numbers of the second parts of opened foods."""

WHOLE = "whole"
"""The plan of a technique that is none for a dish whose parts a recipe tells apart."""


class Apart(NamedTuple):
    """The foods of a recipe; those of its components (``sides``); what is left (``own``), and the technique for it."""

    foods: tuple[Want, ...]
    own: tuple[Want, ...]
    sides: tuple[Side, ...]
    technique: Technique | None


def apart(
    wants: Sequence[Want],
    recipe: Recipe,
    dishes: Sequence[Dish],
    recorded: Sequence[tuple[str, Collection[str]]],
    known: Tables,
    *,
    baked: bool,
) -> Apart:
    """Return how ``wants``, the foods of a recipe, are parted; what is asked separated, where one part is beaten alone.

    ``dishes`` are those that the recipe is called; ``recorded`` is what the videos of its type make, each with its
    foods; ``known`` are the tables; ``baked``: it comes out of an oven.
    """
    foods = tuple(_in_parts(wants, known))
    # eggs are separated only where something asks for the foam: the whites beaten stiff for nothing are no dish
    found = _parted(foods, recipe, dishes, recorded, baked=baked)
    if foods == tuple(wants) or _has_foam(found):
        return found
    return _parted(tuple(wants), recipe, dishes, recorded, baked=baked)


def _parted(
    foods: tuple[Want, ...],
    recipe: Recipe,
    dishes: Sequence[Dish],
    recorded: Sequence[tuple[str, Collection[str]]],
    *,
    baked: bool,
) -> Apart:
    """Return what components take of foods, and what is left for which technique."""
    title_words = words(recipe.title or "")
    technique = technique_for(recipe.dish_type, title_words, foods, recorded)
    kept = _for_its_lines(foods, technique, title_words)
    rest = [want for want in foods if want not in kept]
    named = _named_by(technique, foods, title_words)
    own, sides = sides_of(rest, kept, dishes, recipe.dish_type, recipe.title or "", baked=baked, named=named)
    left = technique if own == foods else technique_for(recipe.dish_type, title_words, own, recorded)
    if not _is_named(sides):
        return Apart(foods, own, sides, left)
    if left is None and _says_what_is_put_on(technique) and not _is_beside(sides):
        return _with_what_is_served(Apart(foods, foods, (), technique), sides, recipe.dish_type, title_words, recorded)
    return Apart(foods, own, sides, _of_parts(left))


def _named_by(technique: Technique | None, foods: Sequence[Want], title_words: Sequence[str]) -> list[Want]:
    """Return the foods that a technique names itself, and does not only take with all the rest."""
    if technique is None:
        return []
    around = Around([want.facts for want in foods], title_words)
    parts = itertools.chain.from_iterable(technique.lines.values())
    named = [some for part in parts for some in part.foods if not some.is_rest]
    return [want for want in foods if are(named, want, around)]


def _of_parts(technique: Technique | None) -> Technique | None:
    """Return a technique, unless it is none for a dish whose parts a recipe tells apart."""
    return None if technique is not None and WHOLE in technique.plan else technique


def _says_what_is_put_on(technique: Technique | None) -> bool:
    """Whether a technique says itself what is put on what, so that its dish needs no components."""
    return technique is not None and bool(technique.called) and WHOLE not in technique.plan


def _is_named(sides: Sequence[Side]) -> bool:
    """Whether a recipe says itself of any food for which part it is, and not only that it is served with the dish."""
    done = {"", *word_list("is for what is done")}
    return any(want.part not in done for side in sides for want in side.wants)


def _is_beside(sides: Sequence[Side]) -> bool:
    """Whether a recipe says of all that is made apart that it stands beside the dish: no technique puts that on it."""
    beside = word_list("is made beside the dish")
    return all(want.part in beside for side in sides for want in side.wants)


def _for_its_lines(foods: Sequence[Want], technique: Technique | None, title_words: Sequence[str]) -> tuple[Want, ...]:
    """Return the foods of which a recipe says that they are for a line of a technique; of a whole one, its foam."""
    if technique is None:
        return ()
    side = _headed_in_a_line(technique, foods, title_words)
    if WHOLE in technique.plan:
        return (*_foam(foods, technique), *side)
    lines = sorted(technique.lines.keys() - {MAIN})
    return tuple(want for want in foods if want in side or (want.part and line_told(want.part, lines)))


def _headed_in_a_line(technique: Technique, foods: Sequence[Want], title_words: Sequence[str]) -> Sequence[Want]:
    """Return what a heading says is made beside a dish, if its technique has a line of its own for the first of it."""
    side = [want for want in foods if want.part == SIDE]
    if not side or not _has_a_line(technique, side[0], Around([want.facts for want in foods], title_words)):
        return ()
    return side


def _has_a_line(technique: Technique, want: Want, around: Around) -> bool:
    """Whether another line of a technique than that of the dish is for a food like ``want``."""
    parts = (part for line, some in technique.lines.items() if line != MAIN for part in some)
    return any(means(foods, want, around) for part in parts for foods in part.foods)


def _with_what_is_served(
    whole: Apart,
    sides: Sequence[Side],
    dish_type: str,
    title_words: Sequence[str],
    recorded: Sequence[tuple[str, Collection[str]]],
) -> Apart:
    """Return what a technique makes that says itself what is put on what, without what is only served with it."""
    served = tuple(side for side in sides if all(want.part in word_list("is for what is done") for want in side.wants))
    own = tuple(want for want in whole.foods if not any(want in side.wants for side in served))
    if served and technique_for(dish_type, title_words, own, recorded) is whole.technique:
        return whole._replace(own=own, sides=served)
    return whole


def _foam(foods: Sequence[Want], technique: Technique | None) -> tuple[Want, ...]:
    """Return what is beaten by itself where a technique has a line for it."""
    return tuple(want for want in foods if technique is not None and want.part == PART in technique.lines)


def _in_parts(wants: Sequence[Want], known: Tables) -> Iterator[Want]:
    """Yield foods, and instead of what is asked separated its two parts; the second as if it were listed last."""
    last = max((place for want in wants for place in want.places), default=0)
    beaten = []
    for want in wants:
        if not comes_apart(want.facts, want.asked) or want.at_hand:
            yield want
            continue
        last += 2  # nothing stands beside it
        first, second = (_part(want, label, known) for label in parts_in(want.label))
        beaten.append(replace(second, number=_PARTED + want.number, part=PART, places=(last,)))
        yield first
    yield from beaten


def _part(want: Want, label: str, known: Tables) -> Want:
    facts = known.foods.food(label)
    return replace(want, label=label, facts=facts, leaf=(want.asked,), storage="", make="", of=want)


def _has_foam(found: Apart) -> bool:
    """Whether what is beaten by itself joins a component, or a line of the technique that is for it."""
    if any(want.part == PART for side in found.sides for want in side.wants):
        return True
    return bool(_foam(found.own, found.technique))
