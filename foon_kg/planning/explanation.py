"""Why a final tree makes every required food as it does: read off the tree and what it was chosen from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from foon_kg.food import singular
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import RequiredIngredient
from foon_kg.model.tree import TreeUnit
from foon_kg.planning.attempt import Attempt
from foon_kg.planning.likes import RecipeLikes

MOST_OTHERS = 3
"""How many known foods that were passed over are named."""

How = Literal["played", "made", "sold", "assumed", "missing"]
"""The recorded dish has a place for such a food; or it is prepared and joins where its kind does; or it joins as it
is sold, or is assumed to be; or not at all."""


@dataclass(frozen=True)
class PassedOver:
    """A known food that might have stood for the required one, how sure that is (0..1), and why not."""

    label: str
    state: str
    confidence: float
    why: str


@dataclass(frozen=True)
class Joining:
    """Where a food joins the others: the step of the tree (from 1; ``None`` where it is not in it) and its motion.

    ``like`` is the food of the recorded dish in whose place it comes and ``likeness`` how like (0..1); without one it
    joins where foods of its kind do.
    """

    step: int | None
    motion: str
    like: str = ""
    likeness: float = 0.0
    left_open: tuple[str, ...] = ()


@dataclass(frozen=True)
class Explanation:
    """Why one required food is made as it is.

    ``label`` is the known food that it is handled like, ``confidence`` how sure that is (0..1) or that a person
    has ``chosen`` it; ``renamed`` are asked states and what each was read as; ``videos`` say where the evidence is.
    """

    want: RequiredIngredient
    how: How
    label: str = ""
    confidence: float = 1.0
    chosen: bool = False
    renamed: tuple[tuple[str, str], ...] = ()
    videos: tuple[str, ...] = ()
    joins: Joining | None = None
    passed_over: tuple[PassedOver, ...] = ()


def explanations(attempt: Attempt, likes: RecipeLikes) -> tuple[Explanation, ...]:
    """Return why the tree of ``attempt`` has each required food as it has it, in their order, by these ``likes``."""
    joins = sorted(attempt.fit.joins, key=lambda join: join.want.number)
    steps = _steps_of_things(attempt.result.units)
    return tuple(_explained(attempt, join, likes, steps) for join in joins)


def _explained(
    attempt: Attempt, join: Join, likes: RecipeLikes, steps: Mapping[int, Sequence[tuple[int, TreeUnit]]]
) -> Explanation:
    """Return why the food that comes in by ``join`` is made as the tree of ``attempt`` makes it.

    ``steps`` are those of each thing.
    """
    want = join.want
    asked = RequiredIngredient(want.label, want.asked)
    ready = attempt.cooking.ready.get(want.number)
    if ready is None:
        return Explanation(asked, "missing")
    number = ready.stuff.number
    own = steps.get(number, ())
    how = _how(ready.assumptions, join, [unit for _, unit in own])
    like, sure = _handled_like(attempt, want.label)
    chosen = bool(like) and singular(want.label) in likes.instead
    renamed = _renamed(attempt, want)
    others = likes.others(want.label, like) if like else ()
    why = "you chose another" if chosen else "less sure"
    return Explanation(
        asked, how, like or want.label, sure, chosen, renamed,
        tuple(_videos(unit for _, unit in own)), _joining(own, number, join), tuple(_passed_over(others, why)),
    )  # fmt: skip


def _passed_over(others: Sequence[tuple[str, float]], why: str) -> Iterator[PassedOver]:
    """Yield the first of ``others``, known foods with how sure each is, as passed over for the reason ``why``."""
    for name, confidence in others[:MOST_OTHERS]:
        yield PassedOver(name, "", round(confidence, 4), why)


def _how(assumptions: Sequence[object], join: Join, own: Sequence[TreeUnit]) -> How:
    """Return how a food comes to what it is: assumed, as a video plays it, made in steps of its own, or as sold."""
    if assumptions:
        return "assumed"
    if join.slot:
        return "played"
    return "made" if any(unit.phase == "prepare" for unit in own) else "sold"


def _renamed(attempt: Attempt, want: Want) -> tuple[tuple[str, str], ...]:
    """Return the state that was asked of a food, with the one that it was read as, where that is another."""
    return tuple(
        (one.required, one.equivalent)
        for one in attempt.result.substitutions
        if one.kind == "state" and one.object == want.label and one.required == want.asked
    )


def _handled_like(attempt: Attempt, label: str) -> tuple[str, float]:
    for one in attempt.result.substitutions:
        if one.kind == "object" and singular(one.object) == singular(label):
            return one.equivalent, one.confidence
    return "", 1.0


def _steps_of_things(units: Iterable[TreeUnit]) -> dict[int, list[tuple[int, TreeUnit]]]:
    """Return by the number of each thing the steps that take or make it, each with its place from 1."""
    found: dict[int, list[tuple[int, TreeUnit]]] = {}
    for place, unit in enumerate(units, 1):
        for thing in {one.thing for one in (*unit.taken, *unit.made) if one.thing is not None}:
            found.setdefault(thing, []).append((place, unit))
    return found


def _joining(own: Sequence[tuple[int, TreeUnit]], number: int, join: Join) -> Joining:
    """Return where the thing of this ``number``, which comes in by ``join``, joins others among its ``own`` steps."""
    step, motion = _first_shared(own, number)
    if join.slot is None:
        return Joining(step, motion)
    return Joining(step, motion, join.slot.food, round(join.fit, 4))


def _first_shared(own: Sequence[tuple[int, TreeUnit]], number: int) -> tuple[int | None, str]:
    """Return the first step after which a food shares its vessel with others."""
    for place, unit in own:
        inside = {one.container_thing for one in unit.made if one.thing == number} - {None}
        if any(one.thing in inside and len(one.node.ingredients) > 1 for one in unit.made):
            return place, unit.motion
    return (own[-1][0], own[-1][1].motion) if own else (None, "")


def _videos(units: Iterator[TreeUnit]) -> Iterator[str]:
    yield from dict.fromkeys(unit.seen_in[0].video for unit in units if unit.seen_in)
