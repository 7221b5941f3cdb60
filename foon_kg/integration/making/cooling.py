"""Letting cool what was cooked before it meets what is eaten cold: leaves wilt under it, and mayonnaise runs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, foods_of, is_baked
from foon_kg.integration.joining.course import Course, Plan
from foon_kg.integration.joining.spots import Join, any_is
from foon_kg.integration.preparing.preparation import Ready
from foon_kg.integration.teaching.frames import Line, Stage

_NO_LONGER_HOT = word_list("is no longer hot")


class Cooling:
    """Lets foods cool on a bench, for a dish that is eaten cold."""

    def __init__(self, bench: Bench, plan: Plan, course: Course) -> None:
        self.bench = bench
        self.plan = plan
        self.course = course

    def alone(self, join: Join, ready: Ready) -> None:
        """Let a food that is ``ready`` cool that was cooked by itself, if it is asked so or joins what stays cold.

        So does what comes to a leaven that lives, which a boiling heat would kill. ``join`` is where that is.
        """
        asked = join.want.asked in word_list("is so by cooling")
        if asked or (self.plan.cooled and not join.spot.heats_later) or self._meets_what_lives(join):
            self._cool(ready.stuff.at, ready.stuff)

    def _meets_what_lives(self, join: Join) -> bool:
        """Whether a food joins where what makes dough rise does, and is hotter than a hand when it was cooked."""
        want = join.want
        if want.facts.is_a("fat") or want.make in word_list("is as warm as a hand"):
            return False
        others = (one.want for one in self.course.joins_of([join.spot.stage]) if one is not join)
        return any(one.facts.is_any(word_list("makes dough rise")) for one in others)

    def before(
        self, stage: Stage, vessel: Vessel | None, beside: Sequence[tuple[Line, Vessel]], later: Sequence[Stage]
    ) -> None:
        """Let cool what is in ``vessel`` and what was made ``beside`` it, where nothing is heated any more.

        That is neither by ``stage`` nor by a ``later`` one.
        """
        joins = self.course.ordered(stage)
        melts = any_is(joins, *word_list("melts away on what is hot")) and _is_baked(vessel)
        if _is_any_hot((stage, *later)) or not (self.plan.cooled or melts):
            return
        incoming = len(joins) + len(beside)
        if vessel is not None:
            self._cool_for(incoming, vessel, hot=melts or self.course.is_hot(stage))
        if vessel is not None or incoming > 1:
            self._cool_beside(beside)

    def _cool_for(self, incoming: int, vessel: Vessel, *, hot: bool) -> None:
        """Let cool a vessel that is ``hot``; not where nothing (0) is ``incoming``."""
        if incoming and hot:
            self._cool_all(vessel)

    def _cool_beside(self, beside: Sequence[tuple[Line, Vessel]]) -> None:
        """Let cool what was made hot ``beside`` a dish."""
        for line, made in beside:
            if _is_any_hot(line.all_stages()):
                self._cool_all(made)

    def _cool_all(self, vessel: Vessel) -> None:
        """Let cool what is in a vessel; the fat in which something was fried does so with it."""
        food = self.bench.known.foods.food
        solids = [stuff for stuff in vessel.contents if stuff.mixed or not food(stuff.label).is_a("fat")]
        self._cool(vessel, *solids[:1])

    def _cool(self, vessel: Vessel | None, *stuffs: Stuff) -> None:
        """Let ``stuffs`` cool off the heat in what they are in, unless one of them is no longer hot."""
        if vessel is None or any(not _NO_LONGER_HOT.isdisjoint(stuff.states) for stuff in stuffs):
            return
        self.bench.heat_off(vessel)
        for stuff in stuffs:
            self.bench.let_cool(vessel, stuff, foods_of(vessel))


def _is_baked(vessel: Vessel | None) -> bool:
    return vessel is not None and any(map(is_baked, vessel.contents))


def _is_any_hot(stages: Iterable[Stage]) -> bool:
    return any(stage.heats for stage in stages)
