"""When steps that happened are done: what waits for nothing is done earlier, or not at all.

A bench makes one thing after the other, as each stage knows only itself. Here the steps of a whole dish are looked at,
and only such are moved as share no thing with those that they pass.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench.steps import Done
from foon_kg.model.tree import Mention

_BRINGS = frozenset({"coat", "fetch", "move", "scatter"})


# --- heat that is turned off and on again ---


def without_short_breaks(done: Sequence[Done], known: Tables) -> list[Done]:
    """Return the steps ``done`` with appliances left on while food only came into their vessels.

    Each stage ends with its heat off, as nobody knows there what the next one does; nobody cooks so. ``known`` are the
    tables.
    """
    kept: list[Done] = []
    for one in done:
        place = _off_before(kept, one, known) if one.step.motion != "turn off" else None
        if place is None:
            kept.append(one)
        else:
            del kept[place]
    return kept


def _off_before(before: Sequence[Done], done: Done, known: Tables) -> int | None:
    """Return the place of the step that turned off what ``done`` turns on, with nothing but such steps since."""
    if len(done.step.inputs) != 1 or len(done.step.outputs) != 1:
        return None
    (off,), (on,) = done.step.inputs, done.step.outputs
    for place in range(len(before) - 1, -1, -1):
        step = before[place].step
        if step.inputs == (on,) and step.outputs == (off,):
            return place
        # only what brings food into that very vessel, while it stays where it is, may come between
        told = {mention.thing for mention in step.outputs}
        stays = off.container_thing in told and off.thing not in told
        if not stays or not known.motion(step.motion).does <= _BRINGS:
            return None
    return None


# --- water that is to boil when something else is done ---


def with_water_hot_in_time(done: Sequence[Done], known: Tables) -> list[Done]:
    """Return the steps ``done`` with water brought to the boil before what would wait for it is done.

    Water that is put on when a pan is off the heat already is put on before that pan; it comes to the boil while the
    pan simmers, if that is the last thing it does. ``known`` are the tables.
    """
    steps = list(done)
    for one in done:
        if _is_boiling(one):
            steps = _put_on_earlier(steps, steps.index(one), known)
    return steps if steps == list(done) else _with_stoves_as_they_are(steps)


def _with_stoves_as_they_are(steps: Sequence[Done]) -> list[Done]:
    """Return ``steps`` in which a stove that is told under no vessel is on when one of its burners is by then."""
    stoves = {mention.thing for done in steps for mention in done.step.outputs if _is_burner(mention)}
    on: set[int | None] = set()
    told = []
    for done in steps:
        before = on
        on = before - _over_heat(done.step.inputs) | _over_heat(list(filter(_is_lit, done.step.outputs)))
        inputs, outputs = (
            tuple(_as_it_is(one, is_on=bool(lit)) if one.thing in stoves else one for one in mentions)
            for mentions, lit in ((done.step.inputs, before), (done.step.outputs, on))
        )
        told.append(done._replace(step=replace(done.step, inputs=inputs, outputs=outputs)))
    return told


def _as_it_is(stove: Mention, *, is_on: bool) -> Mention:
    """Return a ``stove`` that is on or not; one that is under a vessel, or was found on, is told so already."""
    switched = {("on",): ("off",), ("off",): ("on",)}
    if _is_burner(stove) or stove.node.states not in switched or is_on == _is_on(stove):
        return stove
    return stove._replace(node=replace(stove.node, states=switched[stove.node.states]))


def _is_boiling(done: Done) -> bool:
    """Whether a step has only brought water to the boil, with nothing in it but what goes into water."""
    hot = word_list("is boiled water")
    boils = any(not hot.isdisjoint(mention.node.states) for mention in done.step.outputs)
    return boils and any(map(_is_burner, done.step.inputs)) and _only_water(done)


def _only_water(done: Done) -> bool:
    """Whether the vessels of a step have only water in them, and what goes into that."""
    goes = word_list("goes into the water")
    return all(goes.issuperset(mention.node.ingredients) for mention in done.step.outputs)


@dataclass(frozen=True)
class _Wait:
    """A ``pan``, in place since ``stood``, waits for water that fills a ``pot`` from ``begins`` to ``boils``."""

    pot: int | None
    pan: int | None
    stood: int
    begins: int
    boils: int


def _put_on_earlier(steps: list[Done], boils: int, known: Tables) -> list[Done]:
    """Return ``steps`` with the water that boils at the place ``boils`` put on before the pan that waits for it."""
    wait = _wait_for(steps, boils)
    if wait is None:
        return steps
    water = [one for one in steps[wait.begins : boils + 1] if wait.pot in _things(one)]
    others = _without(steps[wait.stood : boils + 1], water)
    if len(others) + len(water) < boils + 1 - wait.stood or _meet(others, water):
        return steps
    lit = _while_it_simmers(others, wait.pan, known)
    hot = list(filter(_uses_heat, water)) if lit else []
    idle = _makes_room(wait, steps)
    first, then = (_without(part, idle) for part in (others[:lit], others[lit:]))
    return [*steps[: wait.stood], *_without(water, hot), *first, *hot, *then, *steps[boils + 1 :]]


def _without(steps: Sequence[Done], others: Sequence[Done]) -> list[Done]:
    return [one for one in steps if one not in others]


def _wait_for(steps: Sequence[Done], boils: int) -> _Wait | None:
    """Return what waits for the water that boils at the place ``boils``; ``None`` where nothing does.

    Two vessels of one name are never over the heat at once: which burner is meant is known by that name.
    """
    pot = next(filter(_is_burner, steps[boils].step.inputs))
    begins = _begin_of_water(steps, boils, pot.container_thing)
    off = _last(steps[:begins], lambda one: one.step.motion == "turn off")
    pan = steps[off].step.outputs[0] if off is not None else None
    if pan is None or pan.node.container in {None, pot.node.container} or not _is_full_and_hot(steps[:begins], pan):
        return None
    stood = _last(steps[:begins], lambda one: _stands(one, pan.container_thing))
    return None if stood is None else _Wait(pot.container_thing, pan.container_thing, stood, begins, boils)


def _makes_room(wait: _Wait, steps: Sequence[Done]) -> list[Done]:
    """Return the steps that only made room for the pot, and need not when it stands before what is taken away."""
    between = (one for one in steps[wait.begins : wait.boils] if _takes_off_an_empty_one(one))
    return [one for one in between if not _meet([one], steps[wait.boils + 1 :])]


def _takes_off_an_empty_one(done: Done) -> bool:
    """Whether a step takes a vessel with nothing in it off a burner."""
    moved = _over_heat(done.step.inputs) - _over_heat(done.step.outputs)
    return bool(moved) and not any(mention.node.ingredients for mention in done.step.inputs)


def _begin_of_water(steps: Sequence[Done], boils: int, pot: int | None) -> int:
    """Return the place of the first of the steps that fill ``pot`` with the water that boils at the place ``boils``."""
    filled = [place for place in range(boils + 1) if pot in _things(steps[place])]
    used = [place for place in filled if not _only_water(steps[place])]
    return next(place for place in filled if not used or place > used[-1])


def _last(steps: Sequence[Done], is_such: Callable[[Done], bool]) -> int | None:
    """Return the place of the last of ``steps`` of which ``is_such`` is so."""
    return next((place for place in range(len(steps) - 1, -1, -1) if is_such(steps[place])), None)


def _while_it_simmers(steps: Sequence[Done], pan: int | None, known: Tables) -> int:
    """Return the place of the last of ``steps`` that cooks what is in ``pan``, if that is in a liquid; else 0."""

    def cooks(done: Done) -> bool:
        return pan in _over_heat(done.step.inputs) and "heat" in known.motion(done.step.motion).does

    last = _last(steps, cooks)
    return last if last is not None and "liquid" in known.motion(steps[last].step.motion).does else 0


def _stands(done: Done, pan: int | None) -> bool:
    """Whether a step stands ``pan`` on a burner."""
    return pan in _over_heat(done.step.outputs) - _over_heat(done.step.inputs)


def _over_heat(mentions: Sequence[Mention]) -> set[int | None]:
    """Return the numbers of what stands on burners."""
    return {mention.container_thing for mention in mentions if _is_burner(mention)}


def _is_full_and_hot(steps: Sequence[Done], burner: Mention) -> bool:
    """Whether something is in the vessel on a ``burner`` after ``steps``, and has not cooled there."""
    pan = burner.container_thing
    told = (mention.node for done in reversed(steps) for mention in done.step.outputs if mention.thing == pan)
    return any(node.ingredients and "hot" in node.states for node in itertools.islice(told, 1))


def _is_burner(mention: Mention) -> bool:
    """Whether it is a stove under a vessel."""
    return mention.node.relation == "under"


def _uses_heat(done: Done) -> bool:
    """Whether a step turns a burner on, or is done over one that is on."""
    return any(map(_is_lit, done.step.inputs + done.step.outputs))


def _is_lit(mention: Mention) -> bool:
    """Whether it is a stove that is on under a vessel."""
    return _is_burner(mention) and _is_on(mention)


def _is_on(stove: Mention) -> bool:
    return "off" not in stove.node.states


def _things(done: Done) -> set[int | None]:
    """Return the numbers of what takes part in a step, and of that in which it is."""
    return _numbers(done.step.inputs) | _numbers(done.step.outputs)


def _numbers(mentions: Sequence[Mention]) -> set[int | None]:
    """Return the numbers of the vessels and foods of ``mentions``: a stove, which has burners for all, is none."""
    stoves = {mention.thing for mention in mentions if _is_burner(mention)}
    return {number for one in mentions for number in (one.thing, one.container_thing)} - stoves


def _meet(some: Sequence[Done], others: Sequence[Done]) -> bool:
    """Whether steps change what takes part in others, or these what takes part in them."""
    stoves = {m.thing for one in (*some, *others) for m in one.step.inputs + one.step.outputs if _is_burner(m)} | {None}
    changed, also = (set().union(*(_numbers(one.step.outputs) for one in side)) - stoves for side in (some, others))
    told, besides = (set().union(*(_things(one) for one in side)) - stoves for side in (some, others))
    return not (changed.isdisjoint(besides) and also.isdisjoint(told))
