"""Stages that dishes are made of whatever their video does, and how foods and lines are put at them.

The patterns are never used themselves, but copies of them (:func:`fresh`, ``replace``): which stage a food joins is
known by the identity of that, and a dish may have two that are equal.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import replace

from foon_kg.integration.joining.spots import NATURAL, Join, spots_of
from foon_kg.integration.teaching.frames import Line, Stage

MIX = Stage((), "mix", frozenset({"mix"}), ("spoon",), "mixing bowl", "in", "", "", "mixture", (), 0)
SHAPE = replace(MIX, motion="shape", does=frozenset({"shape"}), tools=(), vessel="hand")
WHISK = replace(MIX, motion="whisk", tools=("whisk",), vessel="bowl")
COOK = Stage((), "cook", frozenset({"heat"}), (), "cooking pan", "in", "stove", "heat", "", (), 0)
STIR = replace(COOK, motion="cook and stir", does=frozenset({"heat", "mix"}), tools=("spoon",))
TURN = replace(COOK, motion="flip", does=frozenset({"turn"}), tools=("turner",))
SIMMER = replace(COOK, motion="simmer", does=frozenset({"heat", "liquid"}))
LAID = replace(MIX, motion="", does=frozenset(), tools=(), vessel="baking dish", label="")
BAKE = replace(LAID, motion="bake", does=frozenset({"dry", "heat"}), appliance="oven", source="heat")
TOP = replace(LAID, vessel="plate", relation="on")


def fresh(*stages: Stage) -> tuple[Stage, ...]:
    """Return copies of stages: a stage is known by its identity."""
    return tuple(replace(stage) for stage in stages)


def put_at(line: Line, joins: Sequence[Join], stage_of: Callable[[Join], Stage]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line, and the joins each at the stage of it that ``stage_of`` says."""
    spots = {id(spot.stage): spot for spot in spots_of(line)}
    found = []
    for join in joins:
        spot = spots[id(stage_of(join))]
        found.append(Join(join.want, spot, min(join.fit, NATURAL), on_top=join.on_top))
    return Line(line.stages), tuple(found)


def with_line(line: Line, meets: Stage, add: Line) -> tuple[Line, dict[int, Stage]]:
    """Return a line at whose stage ``meets`` the line ``add`` joins, and by identity what became of its stages."""
    became: dict[int, Stage] = {}
    return _with_line(line, meets, add, became), became


def line_with(line: Line, meant: Stage) -> Line:
    """Return the line, or one that joins it, of which the stage ``meant`` is one."""
    if any(stage is meant for stage in line.stages):
        return line
    lines = [add for stage in line.stages for add in stage.lines]
    return next((line_with(one, meant) for one in lines if any(stage is meant for stage in one.all_stages())), line)


def with_replaced(line: Line, old: Line, new: Line, became: dict[int, Stage]) -> Line:
    """Return a line in which the line ``old`` is ``new``; ``became`` gets, by identity, what its stages are then."""
    if line is old:
        return new
    stages = []
    for stage in line.stages:
        adds = tuple(with_replaced(add, old, new, became) if isinstance(add, Line) else add for add in stage.adds)
        if any(add is not before for add, before in zip(adds, stage.adds, strict=True)):
            became[id(stage)] = replace(stage, adds=adds)
        stages.append(became.get(id(stage), stage))
    changed = any(stage is not before for stage, before in zip(stages, line.stages, strict=True))
    return Line(tuple(stages)) if changed else line


def _with_line(line: Line, meets: Stage, add: Line, became: dict[int, Stage]) -> Line:
    stages = []
    for stage in line.stages:
        adds = [_with_line(one, meets, add, became) if isinstance(one, Line) else one for one in stage.adds]
        if stage is meets:
            adds.append(add)
        if any(one is not other for one, other in itertools.zip_longest(adds, stage.adds)):
            became[id(stage)] = replace(stage, adds=tuple(adds))
        stages.append(became.get(id(stage), stage))
    return Line(tuple(stages)) if any(a is not b for a, b in zip(stages, line.stages, strict=True)) else line
