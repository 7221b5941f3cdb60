"""What a video heats though the dish is called so that it is cold."""

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
