"""A sauce of flour is cooked before it comes to the rest: flour in the fat first, then what is poured on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.joining.course import HEATS
from foon_kg.integration.joining.patterns import STIR, with_line
from foon_kg.integration.joining.spots import Join, any_is
from foon_kg.integration.teaching.frames import Line


def sauce_apart(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line and its joins such that flour, fat and milk or stock that meet cold are cooked to a sauce before.

    Nothing changes where they make a batter or a dough, or where the flour is only strewn on something.
    """
    flour = next((join for join in joins if join.want.facts.is_a("flour")), None)
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    baths = [join for join in joins if join.want.facts.is_of(*word_list("is a bath"))]
    if flour is None or not fats or not baths or not _are_for_a_sauce(joins):
        return line, tuple(joins)
    meets = baths[0].spot.stage
    if not meets.does.isdisjoint(HEATS) or not flour.spot.stage.does.isdisjoint(HEATS):
        return line, tuple(joins)
    pan = replace(STIR, step=meets.step)
    line, became = with_line(line, meets, Line((pan,)))
    own = (flour, fats[0], *baths)

    def moved(join: Join) -> Join:
        spot = join.spot
        stage, *after = (became.get(id(one), one) for one in (spot.stage, *spot.after))
        joined = spot.stage is meets and join.want.facts.is_a("spice", *word_list("melts on what is hot"))
        if join not in own and not joined:
            return replace(join, spot=replace(spot, stage=stage, after=tuple(after)))
        first = became[id(meets)]
        rest = tuple(after) if spot.stage is meets else tuple(became.get(id(one), one) for one in baths[0].spot.after)
        return replace(join, spot=replace(spot, stage=pan, after=(first, *rest), side=True), slot=None)

    return line, tuple(moved(join) for join in joins)


def _are_for_a_sauce(joins: Sequence[Join]) -> bool:
    """Whether a sauce of flour goes with what is there, and nothing makes a batter or dough of it."""
    batter = any_is(joins, "leaven", *word_list("makes no sauce of flour"))
    return any_is(joins, *word_list("is eaten with a sauce of flour")) and not batter
