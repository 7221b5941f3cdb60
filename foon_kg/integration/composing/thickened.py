"""A sauce of flour is cooked before it comes to the rest: flour in the fat first, then what is poured on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.joining.patterns import STIR, with_line
from foon_kg.integration.joining.spots import Join, any_is
from foon_kg.integration.teaching.frames import Line


def sauce_apart(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line and its joins such that flour, fat and milk or stock that meet cold are cooked to a sauce before.

    Nothing changes where they make a batter or a dough, or where the flour is only strewn on something.
    """
    own = _sauce(joins)
    if not own:
        return line, tuple(joins)
    flour, bath = own[0], own[2]
    meets = bath.spot.stage
    if meets.heats or flour.spot.stage.heats:
        return line, tuple(joins)
    pan = replace(STIR, step=meets.step)
    line, became = with_line(line, meets, Line((pan,)))

    def moved(join: Join) -> Join:
        spot = join.spot
        stage, *after = (became.get(id(one), one) for one in (spot.stage, *spot.after))
        joined = spot.stage is meets and join.want.facts.is_a("spice", *word_list("melts on what is hot"))
        if join not in own and not joined:
            return replace(join, spot=replace(spot, stage=stage, after=tuple(after)))
        first = became[id(meets)]
        rest = tuple(after) if spot.stage is meets else tuple(became.get(id(one), one) for one in bath.spot.after)
        return replace(join, spot=replace(spot, stage=pan, after=(first, *rest), side=True), slot=None)

    return line, tuple(moved(join) for join in joins)


def _sauce(joins: Sequence[Join]) -> tuple[Join, ...]:
    """Return flour, fat and all that is poured on it, in this order; none of it where they make no sauce."""
    flours = [join for join in joins if join.want.facts.is_a("flour")]
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    baths = [join for join in joins if join.want.facts.is_of(*word_list("is a bath"))]
    batter = any_is(joins, "leaven", *word_list("makes no sauce of flour"))
    if batter or not any_is(joins, *word_list("is eaten with a sauce of flour")):
        return ()
    return (flours[0], fats[0], *baths) if all((flours, fats, baths)) else ()
