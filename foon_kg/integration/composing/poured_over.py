"""A dressing is a part of its own: what makes one is mixed in a bowl and comes over the rest, whatever a video did."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import MINCED
from foon_kg.integration.joining.spots import NATURAL, Join
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Line, Slot, Stage

_PARTS = word_list("is poured over")
_TOLD = word_list("says that it is poured over")
_BODY = word_list("is the body of what is poured over")

_SPRAYS = word_list("sprays")
_WHEN_FINE = word_list("is poured over when it is fine")

_LEAST = 2
"""Of how many foods that run a dressing is made: oil alone is poured over the rest as it is."""

_BY_HAND = frozenset({"coat", "mash", "mix", "move", "scatter", "whip"})
"""What is done by hand to what stays cold: a video that does no more mixes a salad."""

_BOILS = frozenset({"heat", "liquid", "move", "separate"})
"""What is only boiled for a cold dish is boiled by itself."""

_MIXING = Stage((), "mix", frozenset({"mix"}), (), "bowl", "in", "", "", "", (), 0)


def is_poured_over(want: Want, slot: Slot | None = None) -> bool:
    """Return whether ``want`` is what dressings are made of: it runs, it seasons, or only its juice is taken.

    So is all that the recipe says is for one. ``slot`` is its place in the recorded dish, if it has one.
    """
    if want.part in _TOLD:
        return True
    if want.facts.kind in _SPRAYS:
        return False
    if want.facts.is_any(_WHEN_FINE) and tables().state(want.asked).fineness >= MINCED:
        return True
    return want.squeezed or want.facts.is_any(_PARTS) or (slot is not None and "juice" in slot.states)


def dressed_apart(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line and its joins such that the dressing is mixed by itself and comes over what it dresses.

    They are returned as they are where there is nothing to mix, or where a machine makes the recorded dressing.
    """
    parts = [join for join in joins if is_poured_over(join.want, join.slot)]
    rest = [join for join in joins if join not in parts]
    place = _last_mixing(line, rest)
    if place is None:
        return line, tuple(joins)
    beside = list(_beside(line))
    if not _has_enough_to_pour(parts, beside):
        return _at_once(line, place, _with_the_boiled(line, place, joins, beside), parts)
    return _tossed(line, place, joins, parts, set(map(id, filter(_is_cold, beside))))


def _with_the_boiled(line: Line, place: int, joins: Sequence[Join], beside: Sequence[Stage]) -> tuple[Join, ...]:
    """Return ``joins`` with what is only boiled ``beside`` a line coming by itself to its mixing at ``place``."""
    boiled = {id(stage) for stage in beside if stage.does <= _BOILS}
    last, later = line.stages[place], line.stages[place + 1 :]
    return tuple(_apart(join, last, later) if id(join.spot.stage) in boiled else join for join in joins)


def _is_cold(stage: Stage) -> bool:
    """Whether a stage is done by hand, or is only boiled for what is eaten cold."""
    return stage.does <= _BY_HAND or stage.does <= _BOILS


def _has_enough_to_pour(parts: Sequence[Join], beside: Sequence[Stage]) -> bool:
    """Whether ``parts`` are enough for a dressing, and no machine makes the recorded one ``beside`` the dish."""
    runs = [join for join in parts if not _only_seasons(join)]
    body = any(join.want.facts.is_any(_BODY) for join in runs)
    by_machine = {id(stage) for stage in beside if not _is_cold(stage)}
    own = all(join.slot is not None and id(join.spot.stage) in by_machine for join in runs)
    return len(runs) >= _LEAST and body and not own


def _tossed(
    line: Line, place: int, joins: Sequence[Join], parts: Sequence[Join], cold: Collection[int]
) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that gathers foods up to ``place``, mixes the dressing of ``parts``, and tosses all with it.

    ``cold`` are the stages beside it (by ``id``) whose foods come to the others by themselves.
    """
    last, later = line.stages[place], line.stages[place + 1 :]
    before = {id(one): _without_work(one) for one in line.stages[: place + 1] if _is_mixing(one)}
    gathered = before[id(last)] = _without_work(last)
    over = replace(_MIXING, step=last.step)
    mixes = last if {"mix"} <= last.does and "mash" not in last.does else _plain(last)
    tossed = replace(mixes, adds=(Line((over,)),))

    def moved(join: Join) -> Join:
        stage = join.spot.stage
        if join in parts:
            spot = replace(join.spot, stage=over, after=(tossed,), side=True)
            return replace(join, spot=spot, fit=min(join.fit, NATURAL))
        if (still := before.get(id(stage))) is not None:
            return replace(join, spot=replace(join.spot, stage=still))
        if id(stage) in cold or (join.slot is None and "blend" in stage.does):
            return _apart(join, gathered, (tossed, *later))
        return join

    found = tuple(map(moved, joins))
    joined = {id(join.spot.stage) for join in found}
    first = [before.get(id(one), one) for one in line.stages[:place] if one.does != {"wait"} or id(one) in joined]
    return Line((*first, gathered, tossed, *later)), found


def _at_once(line: Line, place: int, joins: tuple[Join, ...], parts: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line at whose mixing at ``place`` all comes together that a video mixes and cools for a dressing before.

    There is no dressing where none of ``parts`` joins it. What is mashed there is left alone.
    """
    kept: list[Stage] = []
    gone: list[Stage] = []
    for stage in line.stages[:place]:
        (gone if _comes_at_once(stage, joins, parts) else kept).append(stage)
    if not gone or _takes_foods_beside(gone, joins):
        return line, joins
    last, later = line.stages[place], line.stages[place + 1 :]
    left = set(map(id, gone))
    moved = tuple(_apart(join, last, later) if id(join.spot.stage) in left else join for join in joins)
    return Line((*kept, *line.stages[place:])), moved


def _comes_at_once(stage: Stage, joins: Sequence[Join], parts: Sequence[Join]) -> bool:
    """Whether a stage only waits, or mixes by hand what is no part of a dressing and is not mashed."""
    if stage.does == {"wait"}:
        return True
    if not stage.does <= _BY_HAND or stage.does.isdisjoint({"mix", "mash", "whip"}):
        return False
    here = [join for join in joins if join.spot.stage is stage]
    mashed = "mash" in stage.does and any(map(_is_mashed_there, here))
    return not mashed and not any(join in parts for join in here)


def _takes_foods_beside(stages: Sequence[Stage], joins: Sequence[Join]) -> bool:
    """Whether a line with foods joins one of ``stages``."""
    return any(_joins(line, joins) for stage in stages for line in stage.lines)


def _is_mashed_there(join: Join) -> bool:
    """Whether a food is what the video mashes there, or is of its kind."""
    soft = join.want.facts.is_any(word_list("can be mashed"))
    return soft and join.slot is not None and join.slot.kind == join.want.facts.kind


def _joins(line: Line, joins: Sequence[Join]) -> bool:
    """Whether any food joins a line."""
    stages = {id(stage) for stage in line.all_stages()}
    return any(id(join.spot.stage) in stages for join in joins)


def _plain(stage: Stage) -> Stage:
    return replace(stage, motion=_MIXING.motion, does=_MIXING.does, tools=())


def _only_seasons(join: Join) -> bool:
    facts = join.want.facts
    return facts.is_a("spice", "herb") and not facts.is_a("ready", "liquid", *_BODY)


def _apart(join: Join, stage: Stage, after: tuple[Stage, ...]) -> Join:
    """Return a join that comes to a stage by itself, and is cooked by itself if it has to be."""
    return Join(join.want, replace(join.spot, stage=stage, after=after, side=False), min(join.fit, NATURAL))


def _is_mixing(stage: Stage) -> bool:
    return "mix" in stage.does and stage.does <= _BY_HAND


def _without_work(stage: Stage) -> Stage:
    """Return a stage at which foods only come together: they are mixed once the dressing is there."""
    return replace(stage, motion="", does=frozenset())


def _last_mixing(line: Line, rest: Sequence[Join]) -> int | None:
    """Return the place of the last stage at which something but the dressing joins cold, and is mixed."""
    found, mixed = None, False
    for number, stage in enumerate(line.stages):
        if stage.heats:
            found, mixed = None, False
        stages = {id(one) for one in Line((stage,)).all_stages()}
        joins = any(id(join.spot.stage) in stages and not join.want.facts.is_a("topping") for join in rest)
        mixes = _is_mixing(stage)
        if joins and (mixes or (stage.does <= {"move", "scatter"} and not mixed)):
            found, mixed = number, mixes
    return found


def _beside(line: Line) -> Iterator[Stage]:
    """Yield the stages of the lines that join a line."""
    for stage in line.stages:
        for other in stage.lines:
            yield from other.all_stages()
