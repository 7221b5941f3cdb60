"""A sauce of flour is cooked before it comes to the rest: flour in the fat first, then what is poured on it."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.course import HEATS
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.places import Join

_COOKED = Stage(
    (), "cook and stir", frozenset({"heat", "mix"}), ("spoon",), "cooking pan", "in", "stove", "heat", "", (), 0
)  # fmt: skip


def sauce_apart(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line and its joins such that flour, fat and milk or stock that meet cold are cooked to a sauce before.

    Nothing changes where they make a batter or a dough, or where the flour is only strewn on something.
    """
    flour = next((join for join in joins if join.want.facts.is_a("flour")), None)
    fats = [join for join in joins if join.want.facts.is_a("fat")]
    baths = [join for join in joins if join.want.facts.is_of(*word_list("is a bath"))]
    savoury = any(join.want.facts.is_a(*word_list("is eaten with a sauce of flour")) for join in joins)
    batter = any(join.want.facts.is_a("leaven", *word_list("makes no sauce of flour")) for join in joins)
    if flour is None or not fats or not baths or not savoury or batter:
        return line, tuple(joins)
    meets = baths[0].spot.stage
    if not meets.does.isdisjoint(HEATS) or not flour.spot.stage.does.isdisjoint(HEATS):
        return line, tuple(joins)
    pan = replace(_COOKED, step=meets.step)
    became: dict[int, Stage] = {}
    line = _with_sauce(line, meets, pan, became)
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


def _with_sauce(line: Line, meets: Stage, pan: Stage, became: dict[int, Stage]) -> Line:
    """Return a line where a sauce joins one of its stages; ``became`` is what that and those after it are then."""
    stages = []
    for stage in line.stages:
        adds = [_with_sauce(add, meets, pan, became) if isinstance(add, Line) else add for add in stage.adds]
        if stage is meets:
            adds.append(Line((pan,)))
        if any(one is not other for one, other in itertools.zip_longest(adds, stage.adds)):
            became[id(stage)] = replace(stage, adds=tuple(adds))
        stages.append(became.get(id(stage), stage))
    return Line(tuple(stages)) if any(a is not b for a, b in zip(stages, line.stages, strict=True)) else line
