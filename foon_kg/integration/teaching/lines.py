"""Lines of stages as they grow while a video is followed: clusters of parts that have met, and what joins what.

:mod:`~foon_kg.integration.teaching.derivation` says what meets when.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace

from foon_kg.food import Tables, singular
from foon_kg.integration.teaching.frames import Line, Slot, Stage
from foon_kg.integration.teaching.played import Place, compact
from foon_kg.world import Part

WORK = frozenset({
    "blend", "coat", "cut", "heat", "knead", "mash", "mix", "shape", "turn", "wait", "warm", "whip",
})  # fmt: skip
"""What motions do (:class:`~foon_kg.food.rows.Motion`) that makes a stage of a step.

What only brings food somewhere (fetch, move, scatter), parts one from another (open, peel, separate) or says how
something is heated (dry, fat, liquid) makes none."""

_MAKES = WORK - {"cut", "turn"}
"""What makes one thing of several foods: cut or turned over together they stay what they are."""

Brought = tuple[str, tuple[str, ...], str]
"""How a food was brought: the motion, its tools, and out of which vessel."""


@dataclass(eq=False)
class Cluster:
    """Parts of matter (by their numbers) that stay together from some step on: a line as it grows.

    ``first`` is the least number of its ``parts``.
    ``stages`` are what was done to it so far, ``waiting`` what joined since the last of them. ``cooked`` are the
    motions that cooked it while it was one food by itself, ``brought`` is how it came to its ``place``, in which it was
    after the ``step`` of that number.
    """

    parts: frozenset[int]
    first: int
    stages: list[Stage] = field(default_factory=list)
    waiting: list[Slot | Line] = field(default_factory=list)
    cooked: list[str] = field(default_factory=list)
    place: Place | None = None
    step: int = -1
    brought: Brought = ("", (), "")

    @property
    def is_untouched(self) -> bool:
        """Whether nothing has joined it yet and nothing was done to it but what is done to a food by itself."""
        return not self.stages and not self.waiting

    @property
    def vessel(self) -> str:
        """The label of its vessel, ``""`` for none."""
        return self.place.vessel if self.place is not None else ""

    def slot(self, parts: dict[int, Part], known: Tables, brought: Brought) -> Slot:
        """Return it as the slot of one food, the first of its ``parts``, that was ``brought`` so.

        ``known`` are the tables.
        """
        part = parts[self.first]
        states = self.place.states if self.place is not None else part.states
        kind = known.foods.food(part.name, part.states).kind
        return Slot(part.name, kind, states, tuple(dict.fromkeys(self.cooked)), *brought)

    def line(self, step: int) -> Line:
        """Return it as the line that it is after the step of that number; what still waits joins at a last stage."""
        stages = list(self.stages)
        if self.waiting:
            adds = tuple(self.waiting)
            vessel, relation, label, states = place_told(self.place)
            stages.append(Stage(adds, "", frozenset(), (), vessel, relation, "", "", label, states, step))
        last = stages[-1:] if stages and _only_moves(stages[-1]) else []
        return Line((*_without_detours(stages[: len(stages) - len(last)]), *last))


def place_told(place: Place | None) -> tuple[str, str, str, tuple[str, ...]]:
    """Return the vessel of a place and how things are there, and what they are called with their states."""
    return (place.vessel, place.relation, place.label, place.states) if place is not None else ("", "in", "", ())


def joined(line: Line) -> list[Slot | Line]:
    """Return what joins where ``line`` does: itself, or its foods where they were only cut on one board."""
    if any(not stage.does.isdisjoint(_MAKES) for stage in line.stages):
        return [line]
    return [add for stage in line.stages for add in stage.adds]


def distinct(
    adds: Sequence[Slot | Line], stages: Sequence[Stage], fetched: Collection[str], known: Tables
) -> list[Slot | Line]:
    """Return ``adds`` without foods that are only the name of what is made here, and portions that come together.

    ``stages`` are those that make it. A dish may be called like a food of it (black beans): that of the names of
    ``fetched`` foods is no mere name. ``known`` are the tables.
    """
    lines = [add for add in adds if isinstance(add, Line)]
    inside = {slot.food for stage in stages for slot in stage.slots}.union(*map(_foods, lines))
    made = _labels(stages).union(*(_labels(line.stages) for line in lines))

    def is_mere_name(slot: Slot) -> bool:
        facts = known.foods.food(slot.food, slot.states)
        named = slot.food in made and (compact(slot.food) not in fetched or facts.is_a("made"))
        return named or (facts.is_a("made") and facts.is_a("batter", "dough"))

    kept: list[Slot | Line] = []
    for add in adds:
        if isinstance(add, Slot):
            if add.food in inside or is_mere_name(add):
                continue
            inside.add(add.food)
        kept.append(add)
    return kept


def _foods(line: Line) -> set[str]:
    return {slot.food for slot in line.all_slots()}


def _labels(stages: Iterable[Stage]) -> set[str]:
    return {singular(stage.label) for stage in stages}


def _without_detours(stages: Sequence[Stage]) -> list[Stage]:
    """Return ``stages`` without bringing the whole to a place from which it is only brought on."""
    kept: list[Stage] = []
    for stage in stages:
        if kept and _only_moves(kept[-1]):
            before = kept.pop()
            stage = replace(stage, adds=(*before.adds, *stage.adds))  # noqa: PLW2901
        kept.append(stage)
    return kept


def _only_moves(stage: Stage) -> bool:
    return stage.does.isdisjoint(WORK)
