"""What a title asks to be done, put where no stage of a dish does it: a cake upside down is turned over at last."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, replace

from foon_kg.food import Tables
from foon_kg.food.named import Named
from foon_kg.integration.composing.techniques import done_instead, stage_of
from foon_kg.integration.joining.course import WORKS
from foon_kg.integration.joining.patterns import line_with, with_replaced
from foon_kg.integration.joining.spots import Join, only_carries, spots_of
from foon_kg.integration.teaching.frames import Asked, Line, Stage


def as_named(line: Line, joins: Sequence[Join], asked: Iterable[Named], known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for a dish that does all that is ``asked`` by its title, where a stage does that.

    ``known`` are the tables, whose techniques have these stages.
    """
    joins = tuple(joins)
    for one in asked:
        if one.stage and not _is_done(one, joins, known):
            line, joins = _PUT[one.at](line, joins, one)
    return line, joins


def _is_done(one: Named, joins: Sequence[Join], known: Tables) -> bool:
    """Whether a stage does it to one of the foods that it is for, before or after that is heated."""
    for join in joins:
        stages = (join.spot.stage, *join.spot.after)
        hot = [place for place, stage in enumerate(stages) if stage.heats]
        works = [(place, stage.motion) for place, stage in enumerate(stages) if stage.motion]
        found = [place for place, motion in works if one.is_done_by(motion, known.motion(motion))]
        if one.is_of(join.want.label, join.want.facts) and len(one.in_time(found, hot)) >= one.times:
            return True
    return False


def _before(line: Line, joins: tuple[Join, ...], one: Named) -> tuple[Line, tuple[Join, ...]]:
    """Let the stage come before the oven, in what the dish is baked in; what fills it joins in between."""
    place = next((n for n, stage in enumerate(line.stages) if "dry" in stage.does), None)
    if place is None:
        return line, joins
    bake = line.stages[place]
    extra = replace(_stage(one), adds=bake.adds, vessel=bake.vessel, relation=bake.relation)
    bare = replace(bake, adds=())
    new = Line((*line.stages[:place], extra, bare, *line.stages[place + 1 :]))
    fills = [join for join in joins if _is_filled_with(one, join)]
    there: dict[int, Stage] = {join.want.number: bare for join in fills}
    there |= {join.want.number: extra for join in joins if join.spot.stage is bake and join not in fills}
    return new, _at(new, joins, there, {})


def _is_filled_with(one: Named, join: Join) -> bool:
    return any(some.mean(join.want.label, join.want.facts, ()) for some in one.fills)


def _done(line: Line, joins: tuple[Join, ...], one: Named) -> tuple[Line, tuple[Join, ...]]:
    """Let the stage come when what it is done to was heated for the last time, and cooled if it is."""
    meant = next((join for join in joins if one.is_of(join.want.label, join.want.facts)), None)
    own = line_with(line, meant.spot.stage) if one.of and meant is not None else line
    place = _when_done(own)
    if place is None:
        return line, joins
    rest = own.stages[place:]
    became: dict[int, Stage] = {}
    new = Line((*own.stages[:place], _stage(one), *(() if _only_carry(rest, joins) else rest)))
    new = with_replaced(line, own, new, became)
    return new, _at(new, joins, {}, became)


def _when_done(line: Line) -> int | None:
    """Return the place in a line after all heating, and the cooling that follows; ``None`` where nothing heats it."""
    places = [n for n, stage in enumerate(line.stages) if stage.heats]
    if not places:
        return None
    place = places[-1] + 1
    while place < len(line.stages) and "wait" in line.stages[place].does and line.stages[place].source != "cold":
        place += 1
    return place


def _only_carry(stages: Sequence[Stage], joins: Sequence[Join]) -> bool:
    """Whether stages only bring a dish somewhere: no food and no line joins it there."""
    taken = {id(join.spot.stage) for join in joins}
    return all(only_carries(stage) and not stage.adds and id(stage) not in taken for stage in stages)


def _last(line: Line, joins: tuple[Join, ...], one: Named) -> tuple[Line, tuple[Join, ...]]:
    """Let the stage come last of all that is done to the dish; what only lies on it joins after that."""
    place = len(line.stages)
    while place and line.stages[place - 1].does.isdisjoint(WORKS):
        place -= 1
    new = Line((*line.stages[:place], _stage(one), *line.stages[place:]))
    return new, _at(new, joins, {}, {})


def _instead(line: Line, joins: tuple[Join, ...], one: Named) -> tuple[Line, tuple[Join, ...]]:
    """Let the stage come in the stead of the last that bakes, in the same tin: what is steamed comes in no oven."""
    place = max((n for n, stage in enumerate(line.stages) if "dry" in stage.does), default=None)
    if place is None:
        return line, joins
    baked = line.stages[place]
    new = Line((*line.stages[:place], done_instead(one.stage, baked), *line.stages[place + 1 :]))
    return new, _at(new, joins, {}, {id(baked): new.stages[place]})


_PUT = {"before": _before, "done": _done, "heat": _instead, "last": _last}


def _stage(one: Named) -> Asked:
    stage = stage_of(one.stage)
    return Asked(**{field.name: getattr(stage, field.name) for field in fields(stage)})


def _at(line: Line, joins: Sequence[Join], there: Mapping[int, Stage], became: Mapping[int, Stage]) -> tuple[Join, ...]:
    """Return joins with what comes after them in a changed line; those that are named in ``there`` at its stages."""
    spots = {id(spot.stage): spot for spot in spots_of(line)}
    found = []
    for join in joins:
        stage = there.get(join.want.number) or became.get(id(join.spot.stage), join.spot.stage)
        spot = spots[id(stage)]
        found.append(replace(join, spot=spot, slot=join.slot if join.slot in spot.stage.adds else None))
    return tuple(found)
