"""What a video heats though the dish is called so that it is cold, and what it mixes cold that has to fry in turn."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish
from foon_kg.integration.joining.spots import NATURAL, Join, any_is
from foon_kg.integration.preparing.preparation import owed
from foon_kg.integration.teaching.frames import Line, Stage, place_among

_MIXES = frozenset({"coat", "fetch", "mix", "move", "scatter", "whip"})


def is_never_heated(dishes: Collection[Dish], joins: Sequence[Join], known: Tables) -> bool:
    """Return whether one of the ``dishes`` that it is called is cold, and nothing of ``joins`` has to be cooked.

    ``known`` are the tables.
    """
    raw = any({"cook", "boil"} & owed(join.want, known) or join.want.cooked for join in joins)
    return not raw and any(dish.heated is False and not dish.is_type for dish in dishes)


def unheated(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line without its stages over the heat; what would join there joins what is left before, or after."""
    kept = tuple(stage for stage in line.stages if not stage.heats)
    if not kept or len(kept) == len(line.stages):
        return line, tuple(joins)
    became: dict[int, Stage] = {}
    last = kept[0]
    for stage in line.stages:
        last = stage if not stage.heats else last
        became[id(stage)] = last
    return Line(kept), tuple(_at(join, became.get(id(join.spot.stage), join.spot.stage), kept) for join in joins)


def unmixed(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line without its stages that mix cold what is fried then, and its ``joins``: noodles with a sauce, say.

    A cook fries each in its turn, and tosses with it what was boiled. Nothing changes where eggs or flour bind it.
    """
    hot = next((place for place, stage in enumerate(line.stages) if stage.heats), 0)
    pan, before, rest = line.stages[hot], line.stages[:hot], line.stages[hot + 1 :]
    cold = hot > 0 and all(stage.does <= _MIXES for stage in before)
    if not cold or "dry" in pan.does or not _is_fried_in_turn(joins):
        return line, tuple(joins)
    kept = _heated_beside(before)
    gone = _gone(before, kept)
    fresh = replace(pan, adds=(*kept, *pan.adds))
    found = tuple(_in_the_pan(join, pan, fresh, gone, rest) for join in joins)
    return Line((fresh, *rest)), found


def _heated_beside(stages: Sequence[Stage]) -> list[Line]:
    """Return the lines that join ``stages`` and in which something is heated."""
    return [line for stage in stages for line in stage.lines if _heats(line)]


def _gone(stages: Sequence[Stage], kept: Sequence[Line]) -> list[Stage]:
    """Return all of ``stages``, and of the lines that join them, but what is in a line that is ``kept``."""
    staying = {id(stage) for line in kept for stage in line.all_stages()}
    return [stage for stage in Line(tuple(stages)).all_stages() if id(stage) not in staying]


def _is_fried_in_turn(joins: Sequence[Join]) -> bool:
    """Whether foods are boiled for a sauce, or flesh is stewed in a liquid, and nothing binds them."""
    wet = word_list("is cooked in for long") | word_list("is poured into the pan")
    flesh = any(join.want.facts.is_any(word_list("is flesh")) and "cook" in join.want.facts.owes for join in joins)
    stewed = flesh and any(join.want.facts.is_of(*wet) for join in joins)
    bound = any_is(joins, "dough", "egg", "flour") or (not stewed and any_is(joins, "creamy"))
    return (stewed or any_is(joins, *word_list("is eaten with a sauce"))) and not bound


def _in_the_pan(join: Join, pan: Stage, fresh: Stage, gone: Sequence[Stage], rest: tuple[Stage, ...]) -> Join:
    """Return a join that comes into ``fresh``, if it joined the ``pan`` or a stage that is gone; else it stays."""
    spot = join.spot
    if spot.stage is pan or any(spot.stage is one for one in gone):
        return replace(join, spot=replace(spot, stage=fresh, after=rest, side=False), slot=None)
    after = tuple(fresh if stage is pan else stage for stage in spot.after if not any(stage is g for g in gone))
    return replace(join, spot=replace(spot, after=after))


def fat_in_the_heat(joins: Sequence[Join]) -> tuple[Join, ...]:
    """Return the joins with fat as hard as it is sold where things are heated, and not where they are mixed cold.

    Nothing changes where fat is creamed or rubbed in: with sugar, or with flour that is not fried.
    """
    if any_is(joins, "dough", "leaven", *word_list("sweetens a batter")):
        return tuple(joins)
    hot = next((stage for join in joins for stage in join.spot.after if stage.heats), None)
    if hot is not None and "dry" in hot.does and any_is(joins, "flour"):
        return tuple(joins)
    return tuple(_in_the_heat(join) if _is_mixed_hard(join) else join for join in joins)


def _is_mixed_hard(join: Join) -> bool:
    facts, stage = join.want.facts, join.spot.stage
    hard = facts.is_a("fat") and not facts.is_a("creamy", "liquid") and join.want.asked not in word_list("runs")
    return hard and bool(stage.does & {"mix"}) and stage.does <= _MIXES and not _covers(join)


def _covers(join: Join) -> bool:
    """Whether what a food is mixed with is spread on something before anything heats it."""
    cold = itertools.takewhile(lambda stage: not stage.heats, join.spot.after)
    return any(stage.motion in word_list("covers what is baked") for stage in cold)


def _in_the_heat(join: Join) -> Join:
    spot = join.spot
    place = next((n for n, stage in enumerate(spot.after) if stage.heats), None)
    if place is None:
        return join
    spot = replace(spot, stage=spot.after[place], after=spot.after[place + 1 :], side=False)
    return replace(join, spot=spot, slot=None)


def _heats(line: Line) -> bool:
    return any(stage.heats for stage in line.all_stages())


def _at(join: Join, stage: Stage, stages: Sequence[Stage]) -> Join:
    place = place_among(stages, stage)
    if place is None or (stage is join.spot.stage and stages[place + 1 :] == join.spot.after):
        return join
    spot = replace(join.spot, stage=stage, after=tuple(stages[place + 1 :]))
    return (
        replace(join, spot=spot, fit=min(join.fit, NATURAL))
        if stage is not join.spot.stage
        else replace(join, spot=spot)
    )
