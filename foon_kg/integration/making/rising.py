"""Dough that rises: it is kneaded, rests and is shaped, also where the dough of its video was another one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, foods_of
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.teaching.frames import Stage
from foon_kg.integration.teaching.operators import Way

_RISEN = frozenset({"fermented", "proofed", "risen"})
"""The states of dough that rose once it was shaped; "rested" is what it is after the first time."""


class Rising:
    """Lets the dough of one dish rise on a bench."""

    def __init__(self, bench: Bench, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan

    def rises(self, foods: Sequence[str]) -> bool:
        """Return whether dough of ``foods`` rises by itself, and is no flat bread."""
        return not self.plan.flat and self._has_leaven(foods)

    def _has_leaven(self, foods: Sequence[str]) -> bool:
        return any(self.known.foods.food(food).is_any(word_list("makes dough rise")) for food in foods)

    def let_rise(self, vessel: Vessel, stages: Sequence[Stage]) -> None:
        """Knead the dough in ``vessel`` if it needs that and let it rise, where no stage does so.

        The video's dough was another one then. ``stages`` are this one and all that come later.
        """
        foods = foods_of(vessel)
        if not self._is_to_rise(vessel, stages):
            return
        for ways, state in self._works(stages):
            attested = self.bench.near_or_far(ways, foods)
            whole = vessel.contents[0]
            if attested is not None:
                states = tuple(sorted({*whole.states, state}))
                self.bench.work(vessel, attested, whole.label, states, with_device=False)

    def _is_to_rise(self, vessel: Vessel, stages: Sequence[Stage]) -> bool:
        """Whether there is dough in a vessel that did not rest, and that no stage lets rise."""
        foods = foods_of(vessel)
        dough = any(self.known.foods.food(food).is_a("flour", "dough") for food in foods)
        if not dough or not self._has_leaven(foods) or any("rested" in stuff.states for stuff in vessel.contents):
            return False
        return not any(stage.motion in word_list("rises") for stage in stages)

    def _works(self, stages: Sequence[Stage]) -> Iterator[tuple[Sequence[Way], str]]:
        """Yield what is done to the dough in turn, each with the state that it gives."""
        ways, done = self.bench.operators.ways, frozenset().union(*(stage.does for stage in stages))
        if "knead" not in done:
            yield [way for way in ways.get("knead", ()) if not way[1]], "kneaded"
        yield self.bench.ways_by(word_list("rises")), "rested"
        if self.plan.portioned:
            yield [way for way in ways.get("cut", ()) if way[1]], "cut in pieces"
        if self.plan.flat:
            yield [("press", ())], "flattened"
        elif "shape" not in done:
            yield [("shape", ())], "shaped"

    def let_rise_again(self, vessel: Vessel) -> None:
        """Let dough with yeast rise in ``vessel``, where it is to be baked, if it rested and was shaped then."""
        dough = next((stuff for stuff in vessel.contents if {"rested", "shaped"} <= set(stuff.states)), None)
        if dough is None or not self._is_to_rise_again(dough):
            return
        attested = self.bench.near_or_far(self.bench.ways_by(word_list("rises")), dough.foods)
        if attested is None:
            return
        states = tuple(sorted({*dough.states, *sorted(_RISEN & self.known.motion(attested.way[0]).gives)[:1]}))

        def change() -> None:
            dough.states = states

        self.bench.emit(attested, [vessel, dough], change, [vessel, dough])

    def _is_to_rise_again(self, dough: Stuff) -> bool:
        """Whether dough did not rise since it was shaped, and was not begun to be baked."""
        begun = any(self.known.state(state).half for state in dough.states)
        return not begun and _RISEN.isdisjoint(dough.states) and self.rises(dough.foods)
