"""What is laid in layers and baked: a sauce that cooks before, boiled sheets, something soft, and cheese on top."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.patterns import BAKE, LAID, MIX, STIR, fresh, put_at
from foon_kg.integration.places import Join


def layered(line: Line, joins: Sequence[Join], told: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made that ``told``, the words of type and title, call one of layers.

    Nothing changes where there are no sheets, or no sauce.
    """
    sheets = [join for join in joins if join.want.facts.is_a(*word_list("is a layer of its own"))]
    soft = [join for join in joins if join.want.facts.is_a(*word_list("is mixed for a layer"))]
    tops = [join for join in joins if join.want.facts.is_a(*word_list("melts on top")) and join not in soft]
    sauce = [join for join in joins if join not in (*sheets, *soft, *tops)]
    if len(sheets) != 1 or not sauce or word_list("is laid in layers").isdisjoint(told):
        return line, tuple(joins)
    pan, laid, mix, middle, bake = fresh(STIR, LAID, MIX, LAID, BAKE)
    below = replace(laid, adds=(Line((pan,)),))
    middle = replace(middle, adds=(Line((mix,)),))
    places: list[tuple[list[Join], Stage]] = [(sheets, laid), (soft, mix), (tops, bake)]
    stages = (below, laid, middle, bake) if soft else (below, laid, bake)
    return put_at(Line(stages), joins, lambda join: next((stage for some, stage in places if join in some), pan))
