"""What a video heats though the dish is called so that it is cold, and what it mixes cold that has to fry in turn."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish
from foon_kg.integration.course import HEATS
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.places import NATURAL
from foon_kg.integration.preparation import owed
from foon_kg.integration.spots import Join

_MIXES = frozenset({"coat", "fetch", "mix", "move", "scatter", "whip"})


def is_never_heated(dishes: Collection[Dish], joins: Sequence[Join], known: Tables) -> bool:
    """Whether a dish is called so that it is cold, and nothing in it has to be cooked."""
    raw = any({"cook", "boil"} & owed(join.want, known) or join.want.cooked for join in joins)
    return not raw and any(dish.heated is False and not dish.is_type for dish in dishes)


def unheated(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line without its stages over the heat; what would join there joins what is left before, or after."""
    kept = tuple(stage for stage in line.stages if stage.does.isdisjoint(HEATS))
    if not kept or len(kept) == len(line.stages):
        return line, tuple(joins)
    became: dict[int, Stage] = {}
    last = kept[0]
    for stage in line.stages:
        last = stage if stage in kept else last
        became[id(stage)] = last
    return Line(kept), tuple(_at(join, became.get(id(join.spot.stage), join.spot.stage), kept) for join in joins)


def unmixed(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line without its stages that mix cold what is fried then: noodles with a sauce, flesh with a liquid.

    A cook fries each in its turn, and tosses with it what was boiled. Nothing changes where eggs or flour bind it.
    """
    hot = next((place for place, stage in enumerate(line.stages) if not stage.does.isdisjoint(HEATS)), 0)
    facts = [join.want.facts for join in joins]
    boiled = any(one.is_a(*word_list("is eaten with a sauce")) for one in facts)
    flesh = any(one.is_a(*word_list("is flesh")) and "cook" in one.owes for one in facts)
    wet = word_list("is cooked in for long") | word_list("is poured into the pan")
    stewed = flesh and any(one.is_of(*wet) for one in facts)
    bound = any(one.is_a("dough", "egg", "flour") or (one.is_a("creamy") and not stewed) for one in facts)
    pan, before = line.stages[hot], line.stages[:hot]
    cold = bool(before) and all(stage.does <= _MIXES for stage in before)
    if not (boiled or stewed) or bound or not cold or pan.does.isdisjoint(HEATS) or "dry" in pan.does:
        return line, tuple(joins)
    stages = [stage for one in before for stage in Line((one,)).all_stages()]
    kept = tuple(add for one in before for add in one.adds if isinstance(add, Line) and _heats(add))
    gone = [stage for stage in stages if not any(stage in add.all_stages() for add in kept)]
    fresh = replace(pan, adds=(*kept, *pan.adds))
    rest = tuple(line.stages[hot + 1 :])
    found = []
    for join in joins:
        spot = join.spot
        after = tuple(fresh if stage is pan else stage for stage in spot.after if not any(stage is g for g in gone))
        there = spot.stage is pan or any(spot.stage is one for one in gone)
        spot = replace(spot, stage=fresh, after=rest, side=False) if there else replace(spot, after=after)
        found.append(replace(join, spot=spot, slot=None if there else join.slot))
    return Line((fresh, *rest)), tuple(found)


def fat_in_the_heat(joins: Sequence[Join]) -> tuple[Join, ...]:
    """Return the joins with fat as hard as it is sold where things are heated, and not where they are mixed cold.

    Nothing changes where fat is creamed or rubbed in: with sugar, or with flour that is not fried.
    """
    if any(join.want.facts.is_a("dough", "leaven", *word_list("sweetens a batter")) for join in joins):
        return tuple(joins)
    hot = next((stage for join in joins for stage in join.spot.after if not stage.does.isdisjoint(HEATS)), None)
    if hot is not None and "dry" in hot.does and any(join.want.facts.is_a("flour") for join in joins):
        return tuple(joins)
    return tuple(_in_the_heat(join) if _is_mixed_hard(join) else join for join in joins)


def _is_mixed_hard(join: Join) -> bool:
    facts, stage = join.want.facts, join.spot.stage
    hard = facts.is_a("fat") and not facts.is_a("creamy", "liquid") and join.want.asked not in word_list("runs")
    return hard and bool(stage.does & {"mix"}) and stage.does <= _MIXES


def _in_the_heat(join: Join) -> Join:
    spot = join.spot
    place = next((n for n, stage in enumerate(spot.after) if not stage.does.isdisjoint(HEATS)), None)
    if place is None:
        return join
    spot = replace(spot, stage=spot.after[place], after=spot.after[place + 1 :], side=False)
    return replace(join, spot=spot, slot=None)


def _heats(line: Line) -> bool:
    return any(not stage.does.isdisjoint(HEATS) for stage in line.all_stages())


def _at(join: Join, stage: Stage, stages: Sequence[Stage]) -> Join:
    place = next((n for n, one in enumerate(stages) if one is stage), None)
    if place is None or (stage is join.spot.stage and stages[place + 1 :] == join.spot.after):
        return join
    spot = replace(join.spot, stage=stage, after=tuple(stages[place + 1 :]))
    return (
        replace(join, spot=spot, fit=min(join.fit, NATURAL))
        if stage is not join.spot.stage
        else replace(join, spot=spot)
    )
