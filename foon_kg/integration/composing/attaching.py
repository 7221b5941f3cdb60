"""Where a component comes to the rest of its dish: in what is mixed, before it is heated, on what is done or cold."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.food.techniques import NOWHERE, Component, works
from foon_kg.integration.composing.components import Side, are
from foon_kg.integration.composing.techniques import carried_out, stage_of
from foon_kg.integration.joining.course import COATS, MIXES
from foon_kg.integration.joining.patterns import line_with, with_line, with_replaced
from foon_kg.integration.joining.spots import UNNATURAL, Join, Spot, StageType, is_ladled, only_carries, spots_of
from foon_kg.integration.teaching.frames import ADDED, Line, Stage

# where foods of a component are before its line is made: they join no stage of the dish
_NOWHERE = Spot(
    (),
    Stage((), "", frozenset(), (), "", "", "", "", "", (), ADDED),
    StageType("top", "never", joins=False),
    side=False,
    after=(),
)


def with_sides(
    line: Line, joins: Sequence[Join], sides: Sequence[Side], title_words: Sequence[str], known: Tables
) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that each component, one of ``sides``, joins, and the joins with those of its foods.

    ``title_words`` are the words of the dish's title, ``known`` the tables.
    """
    for side in sides:
        line, joins = _with_side(line, joins, side, title_words, known)
    return line, tuple(joins)


def _with_side(
    line: Line, joins: Sequence[Join], side: Side, title_words: Sequence[str], known: Tables
) -> tuple[Line, Sequence[Join]]:
    component = side.component
    own = [Join(want, _NOWHERE, UNNATURAL) for want in side.wants]
    target = stage_of(component.by)
    found: Sequence[Join] = own
    if component.technique.lines:
        made, found = carried_out(component.technique, own, title_words, known)
        target = replace(target, adds=(made,))
    on_top = works()[component.by].on_top
    whole, at, became = _folded(line, target, side, joins) or _attached(line, target, _place(component, line.stages))
    if at is not target:
        became[id(target)] = at
    spots = {id(spot.stage): spot for spot in spots_of(whole)}
    layer = -1 if component.at == "under" else 0

    def moved(join: Join) -> Join:
        if join.spot is _NOWHERE:
            return replace(join, spot=spots[id(at)], on_top=on_top, layer=layer)
        return replace(join, spot=spots.get(id(became.get(id(join.spot.stage), join.spot.stage)), join.spot))

    return whole, [moved(join) for join in (*joins, *found)]


def _attached(line: Line, target: Stage, at: str) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return a line with ``target`` at its place, that stage there, and by identity what became of others."""
    if at == "between" and only_carries(line.stages[-1]):
        whole, changed = with_line(line, line.stages[-1], target.lines[0])
        return whole, changed[id(line.stages[-1])], changed
    if at == "closed in":
        return Line((*line.stages[:-1], target, line.stages[-1])), target, {}
    worked = _worked_at(line, at)
    if worked and at == "simmered":
        return _attached_simmering(line, worked[-1], target)
    if worked:
        return _attached_to(line, worked, target, at)
    bakes = [place for place, stage in enumerate(line.stages) if stage.does >= {"dry", "heat"}]
    return _attached_baked(line, bakes, target, at) if bakes else _attached_last(line.stages, target, at)


def _place(component: Component, stages: Sequence[Stage]) -> str:
    """Return where a component joins: what is put together with the rest lies in what is closed there by hand."""
    closed = component.at == "done" and not works()[component.by].on_top and _closes_by_hand(stages)
    return "closed in" if closed else component.at


def _closes_by_hand(stages: Sequence[Stage]) -> bool:
    """Whether what lies where it is served is closed there at last: what comes on it then would lie outside."""
    before, last = stages[-2:] if len(stages) > 1 else (stages[0], stages[0])
    folds = last.does == {"shape"} and not last.adds and before.vessel == last.vessel
    return folds and bool(before.vessel) and only_carries(before)


def _attached_baked(line: Line, bakes: Sequence[int], target: Stage, at: str) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return a line with ``target`` at its place, where it is baked at the places ``bakes``; as :func:`_attached`."""
    stages = line.stages
    mixed = [stage for stage in stages[: bakes[0]] if not stage.does.isdisjoint(MIXES)]
    to_mixed = {"shaped": _attached_shaped, "folded": _attached_folded}
    to_baked = {"before": _attached_before, "shaped": _attached_before, "again": _attached_again}
    if mixed and at in to_mixed:
        return to_mixed[at](line, mixed[-1], target)
    if at in to_baked:
        return to_baked[at](stages, bakes[-1], target)
    if at == "under":
        tin = stages[bakes[0]].vessel
        return line, next(stage for stage in stages if stage.vessel == tin), {}
    return _attached_last(stages, target, at)


def _worked_at(line: Line, at: str) -> list[Stage]:
    """Return the stages that do what a component joins ``at``; some only of the dish itself."""
    stages = line.stages if at in {"simmered", "tossed"} else line.all_stages()
    return [stage for stage in stages if _is_at(stage, at)]


def _is_at(stage: Stage, at: str) -> bool:
    """Whether a stage shapes, mixes or stews, as a component asks that joins there."""
    mixes = not stage.does.isdisjoint({"mix", "knead"})
    shapes = "shape" in stage.does and "heat" not in stage.does
    over_heat = "heat" in stage.does and "dry" not in stage.does
    return {"mixed": mixes, "tossed": mixes, "shaped": shapes, "simmered": over_heat, "stewed": over_heat}.get(
        at, False
    )


def _attached_to(line: Line, worked: Sequence[Stage], target: Stage, at: str) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return a line with ``target`` after the last stage that shapes, or in the first or last one that mixes."""
    if at in {"mixed", "stewed", "tossed"}:
        mixing = worked[-1] if at == "tossed" else worked[0]
        whole, changed = with_line(line, mixing, target.lines[0])
        return whole, changed[id(mixing)], changed
    became: dict[int, Stage] = {}
    return _with_next(line, worked[-1], target, became), target, became


def _attached_simmering(line: Line, heat: Stage, target: Stage) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return a line in which what was heated simmers on in its vessel with ``target``, once it is blended if it is."""
    target = replace(target, vessel=heat.vessel, relation=heat.relation, appliance=heat.appliance, source=heat.source)
    became: dict[int, Stage] = {}
    last = next(one for one in reversed(line.stages) if one is heat or "blend" in one.does)
    return _with_next(line, last, target, became), target, became


def _attached_shaped(line: Line, mixing: Stage, target: Stage) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return a line in which what a stage mixes is shaped, and comes to ``target`` then."""
    became: dict[int, Stage] = {}
    shape = replace(stage_of("shape"), vessel=mixing.vessel)
    line = _with_next(line, mixing, shape, became)
    return _with_next(line, shape, target, became), target, became


def _attached_folded(line: Line, mixing: Stage, target: Stage) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return a line in which what a stage mixes is mixed with ``target`` next, in the same vessel."""
    target = replace(target, vessel=mixing.vessel, relation=mixing.relation, label=mixing.label or target.label)
    became: dict[int, Stage] = {}
    return _with_next(line, mixing, target, became), target, became


def _attached_before(stages: Sequence[Stage], place: int, target: Stage) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return stages with ``target`` on what is baked at a ``place``, before that, as :func:`_attached` does."""
    heat = stages[place]
    laid = replace(heat, motion="", does=frozenset(), appliance="", source="", label="", states=())
    target = replace(target, vessel=heat.vessel, relation=heat.relation)
    fresh = (*stages[:place], laid, target, replace(heat, adds=()), *stages[place + 1 :])
    return Line(fresh), target, {id(heat): laid}


def _attached_again(stages: Sequence[Stage], place: int, target: Stage) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return stages with ``target`` on what was baked at a ``place``, which is baked once more with it."""
    heat = stages[place]
    target = replace(target, vessel=heat.vessel, relation=heat.relation)
    return Line((*stages[: place + 1], target, replace(heat, adds=()), *stages[place + 1 :])), target, {}


def _attached_last(stages: Sequence[Stage], target: Stage, at: str) -> tuple[Line, Stage, dict[int, Stage]]:
    """Return stages with ``target`` at their end, once the dish is done or cold, as :func:`_attached` does."""
    target = _on_what_is_done(stages[-1], target)
    cold = at == "cooled"
    cut = stages[-1:] if cold and "cut" in stages[-1].does and not stages[-1].adds else ()
    rest = stages[-1:] if only_carries(stages[-1]) and not cut else ()
    done = stages[: len(stages) - len(rest) - len(cut)]
    cool = (stage_of("cool"),) if cold and not (done and "wait" in done[-1].does) else ()
    became = {id(one): replace(one, vessel=target.vessel, relation=target.relation) for one in cut}
    return Line((*done, *cool, *rest, target, *became.values())), target, became  # it is cut with what lies on it


def _on_what_is_done(last: Stage, target: Stage) -> Stage:
    """Return ``target`` in the vessel in which it comes on a dish of which ``last`` is the last stage."""
    if not target.vessel and is_ladled(last):
        target = replace(target, vessel=min(word_list("is eaten out of when it is ladled")))
    if not target.vessel and last.vessel in word_list("is turned out of when it is baked"):
        target = replace(target, vessel="plate", relation="on")  # nobody lifts a cake out from under its cream
    return target


def _folded(
    line: Line, target: Stage, side: Side, joins: Sequence[Join]
) -> tuple[Line, Stage, dict[int, Stage]] | None:
    """Return a line in which one part of a food comes to the other where that is mixed last before it is heated.

    ``None`` where ``side`` is no such part.
    """
    other = _other_part(side, joins)
    if other is None:
        return None
    spot = other.spot
    cold = list(itertools.takewhile(lambda stage: not stage.heats, (spot.stage, *spot.after)))
    mixing = next((one for one in reversed(cold) if not one.does.isdisjoint(MIXES) and not one.does >= COATS), None)
    if mixing is None:
        add = target.lines[0] if target.lines else Line((target,))
        whole, became = with_line(line, spot.stage, add)
        return whole, became[id(spot.stage)], became
    return _attached_folded(line, mixing, target)


def _other_part(side: Side, joins: Sequence[Join]) -> Join | None:
    """Return the first food that comes of the same one as a food of a component, when that is opened.

    Where each part of it is listed by itself that is the one beside which the component stands.
    """
    whole = [want.of for want in side.wants if want.of is not None]
    other = next((join for join in joins if join.want.of in whole), None)
    if other is not None or side.component.at != "folded":
        return other
    return next((join for join in joins if are(side.component.beside[0], join.want, NOWHERE)), None)


def _with_next(line: Line, stage: Stage, target: Stage, became: dict[int, Stage]) -> Line:
    """Return a line in which ``target`` comes next after a stage, in whichever line that is."""
    own = line_with(line, stage)
    place = next(place for place, one in enumerate(own.stages, start=1) if one is stage)
    return with_replaced(line, own, Line((*own.stages[:place], target, *own.stages[place:])), became)
