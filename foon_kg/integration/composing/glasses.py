"""What is drunk: whether its video heats it, how it is stirred in its glass, and what comes on top of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.integration.joining.course import MIXES, WORKS
from foon_kg.integration.joining.patterns import MIX, STIR
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.teaching.frames import Line, Stage, place_among
from foon_kg.integration.teaching.operators import Operators

_GLASS = replace(MIX, motion="stir", vessel="drinking glass", label="")
_SLICES = word_list("is a slice on a glass")


def is_heated(line: Line) -> bool:
    """Return whether the video of ``line`` itself heats something on an appliance, or takes what was heated."""
    heats = any("heat" in stage.does and stage.source == "heat" for stage in line.all_stages())
    return heats or any(slot.cooked for slot in line.all_slots())


def can_be_warmed(operators: Operators) -> bool:
    """Return whether any video that ``operators`` are learnt from stirs something over the heat."""
    return (STIR.motion, STIR.tools) in operators.ways.get("heat", ())


def can_be_blended(operators: Operators) -> bool:
    """Return whether any video that ``operators`` are learnt from blends something."""
    return bool(operators.ways.get("blend"))


def stirred(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that ends with stirring what is poured together in a glass, where none of ``joins`` is mixed."""
    machine = any(not stage.does.isdisjoint(WORKS) and stage.source for stage in line.all_stages())
    if machine or _is_mixed(line, joins):
        return line, tuple(joins)
    last = line.stages[-1]
    stir = replace(_GLASS, step=last.step, vessel=last.vessel if is_served_in(last.vessel) else _GLASS.vessel)
    found = (replace(join, spot=replace(join.spot, stage=stir, after=(), side=False)) for join in joins)
    return Line((stir,)), tuple(found)


def _is_mixed(line: Line, joins: Sequence[Join]) -> bool:
    """Whether a stage mixes several of the foods that come to it."""
    for stage in line.all_stages():
        coming = [join for join in joins if place_among((join.spot.stage, *join.spot.after), stage) is not None]
        if len(coming) > 1 and not stage.does.isdisjoint(MIXES):
            return True
    return False


def for_many(line: Line, joins: Sequence[Join], title_words: Sequence[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that ends in a jug where one of ``title_words`` says that the drink is for many.

    One glass does not hold it. Its ``joins`` are returned with it.
    """
    if not says(title_words, "is made for many"):
        return line, tuple(joins)
    stages = {id(stage): _in_a_jug(stage) for stage in line.stages}
    found = []
    for join in joins:
        after = tuple(stages.get(id(stage), stage) for stage in join.spot.after)
        spot = replace(join.spot, stage=stages.get(id(join.spot.stage), join.spot.stage), after=after)
        found.append(replace(join, spot=spot))
    return Line(tuple(stages.values())), tuple(found)


def _in_a_jug(stage: Stage) -> Stage:
    return replace(stage, vessel=min(word_list("holds what is made for many"))) if is_served_in(stage.vessel) else stage


def is_served_in(label: str) -> bool:
    """Return whether people drink out of the vessel ``label``."""
    row = tables().utensil(label) if label else None
    return row is not None and row.group in word_list("is drunk from")


def garnished(line: Line, joins: Sequence[Join], name_words: frozenset[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line at whose end slices and leaves come on top of what is drunk, and its ``joins``.

    Nothing changes where one of ``name_words``, those of its type and title, says that they are in it.
    """
    last = line.stages[-1]
    found = [join for join in joins if _is_garnish(join)]
    if says(name_words, "is muddled or blended") or len(found) in {0, len(joins)}:
        return line, tuple(joins)
    top = replace(last, adds=(), motion="", does=frozenset(), tools=(), label="")
    at_top = (
        replace(join, spot=replace(join.spot, stage=top, after=(), side=False), slot=None, on_top=True)
        for join in found
    )
    rest = [join for join in joins if join not in found]
    return Line((*line.stages, top)), (*rest, *at_top)


def _is_garnish(join: Join) -> bool:
    cut = says({join.want.asked, *words(join.want.label)[-1:]}, "garnishes a glass")
    return join.want.facts.is_any(word_list("is a leaf on a glass")) or (cut and join.want.facts.is_any(_SLICES))
