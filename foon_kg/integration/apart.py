"""What of a recipe's foods is made apart: its components, and the two parts of what is asked in them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from foon_kg.food import Tables, words
from foon_kg.food.parted import PART, comes_apart, parts_in
from foon_kg.food.rows import Dish
from foon_kg.food.techniques import Technique
from foon_kg.integration.components import Side, sides_of
from foon_kg.integration.preparation import SECOND, Want
from foon_kg.integration.techniques import technique_for
from foon_kg.model import Recipe

_PARTED = 5 * SECOND


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
    recorded: Collection[Sequence[str]],
    known: Tables,
    *,
    baked: bool,
) -> Apart:
    """Return how the foods of a recipe are parted. What is asked separated is so where one part is beaten by itself.

    ``dishes`` are those that it is called; ``recorded`` are the words of what the videos of its type make; ``baked``:
    it comes out of an oven.
    """
    whole, dish_type, title = tuple(wants), recipe.dish_type, recipe.title or ""
    for foods in dict.fromkeys((tuple(_in_parts(whole, known)), whole)):
        technique = technique_for(dish_type, words(title), foods, recorded)
        lines = technique.lines if technique is not None else {}
        kept = tuple(want for want in foods if want.part == PART and PART in lines)
        own, sides = sides_of([want for want in foods if want not in kept], dishes, dish_type, title, baked=baked)
        own = (*own, *kept)
        technique = technique_for(dish_type, words(title), own, recorded)
        found = Apart(foods, own, sides, technique)
        if foods is whole or _has_foam(found):
            break
    return found


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
    return replace(want, label=label, facts=facts, leaf=(want.asked,), storage="", make="", read_as=None, of=want)


def _has_foam(found: Apart) -> bool:
    """Whether what is beaten by itself joins a component, or a line of the technique that is for it."""
    if any(want.part == PART for side in found.sides for want in side.wants):
        return True
    return found.technique is not None and PART in found.technique.lines
