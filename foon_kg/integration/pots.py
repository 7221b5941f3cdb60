"""What a video does in another order than the dish asks for by its name: blended once it is done, or never heated."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.rows import Dish
from foon_kg.integration.course import HEATS
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.places import NATURAL, Join
from foon_kg.integration.preparation import owed


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


def blended_when_done(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that cooks what its video blends raw, and blends it then."""
    stages = line.stages
    blend = next((n for n, stage in enumerate(stages) if "blend" in stage.does), None)
    heat = next((n for n, stage in enumerate(stages) if not stage.does.isdisjoint(HEATS)), None)
    if blend is None or heat is None or heat < blend:
        return line, tuple(joins)
    ends = max(n for n, stage in enumerate(stages) if not stage.does.isdisjoint(HEATS))
    first = replace(stages[heat], adds=(*stages[blend].adds, *stages[heat].adds))
    mixed = replace(stages[blend], adds=(), step=stages[ends].step)
    order = (
        *stages[:blend],
        *stages[blend + 1 : heat],
        first,
        *stages[heat + 1 : ends + 1],
        mixed,
        *stages[ends + 1 :],
    )
    became = {id(stages[blend]): first, id(stages[heat]): first}
    return Line(order), tuple(_at(join, became.get(id(join.spot.stage), join.spot.stage), order) for join in joins)


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
