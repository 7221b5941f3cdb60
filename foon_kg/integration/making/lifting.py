"""Flesh is lifted out of what it was cooked in, to be carved or pulled apart, and comes back to that on the plate."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.lists import word_list
from foon_kg.food.rows import CHOPPED
from foon_kg.integration.bench import Stuff, Vessel, fineness
from foon_kg.integration.making.outcome import MIXTURE
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import LiftedOut, Rejoined, Stage


class Lifting:
    """Lifts the flesh of one dish out of a vessel; what stays behind waits in that until the flesh is ready."""

    def __init__(self, work: Worker) -> None:
        self.work = work
        self.taking_out = work.taking_out
        self.bench = work.bench
        self.known = work.known
        self.left: list[Vessel] = []

    def lifted(self, stage: Stage, vessel: Vessel) -> Vessel:
        """Return in what flesh is that was lifted out of a ``vessel`` at a ``stage``; ``vessel`` where none was."""
        wants = self.taking_out.inside(vessel, self._is_lifted)
        self.bench.heat_off(vessel)
        target = self.bench.vessel(stage.vessel)
        pieces = [want for want in wants if not self._is_in_bits(want)]
        for stuff in list(vessel.contents):
            self._lift(stuff, [want for want in pieces or wants if want.number in stuff.wants], target)
        if not target.contents:
            return vessel
        self._clear(vessel)
        self.left = [vessel] if vessel.contents else []
        return target

    def returned(self, stage: Stage) -> list[Vessel]:
        """Return what flesh was lifted out of, where the rest comes to it at this stage."""
        if not isinstance(stage, Rejoined):
            return []
        left, self.left = self.left, []
        return left

    def _clear(self, vessel: Vessel) -> None:
        """Take leaves that only gave their taste out of what stays in a vessel: the last step left it there."""
        if self.taking_out.holds_leaves(vessel):
            self.work.name(vessel, MIXTURE)
            self.taking_out.take_out(vessel)

    def _is_lifted(self, want: Want) -> bool:
        return want.facts.is_any(word_list("is flesh")) and not want.facts.is_any(word_list("stays in its sauce"))

    def _is_in_bits(self, want: Want) -> bool:
        """Whether flesh is so fine that it is part of what the rest was cooked in: nobody picks that out."""
        return fineness([state for state in (want.make, *want.leaf) if state], self.known) >= CHOPPED

    def _lift(self, stuff: Stuff, wants: Sequence[Want], target: Vessel) -> None:
        """Lift ``wants`` out of a thing; the thing itself, with what clings to it, where it is nothing else."""
        vessel = stuff.at
        if not wants or vessel is None:
            return
        attested = self.bench.near_or_far(self.taking_out.lifting_ways(), wants[0].names)
        if attested is None:
            return
        if stuff.mixed:
            self.taking_out.lift(vessel, stuff, wants, attested, target, asked=True)
            return
        clings = self._clinging([one for one in vessel.contents if one is not stuff])
        self.bench.bring([stuff, *clings], target, attested, leaves=True)
        if clings:
            self.work.name(target, stuff.label, stuff.states)

    def _clinging(self, others: Sequence[Stuff]) -> list[Stuff]:
        """Return which of the ``others`` beside flesh are lifted with it: none out of a liquid."""
        return [] if any(map(self._is_wet, others)) else [one for one in others if self._clings(one)]

    def _is_wet(self, stuff: Stuff) -> bool:
        """Whether a thing is a liquid that washes off flesh what lay on it: no fat, which runs off."""
        facts = self.known.foods.food(stuff.label, stuff.states)
        return not stuff.mixed and facts.is_a("cooking liquid", "water") and not facts.is_a("fat")

    def _clings(self, stuff: Stuff) -> bool:
        """Whether a thing lies on flesh and is lifted with it: what that was rubbed, brushed or strewn with."""
        foods = map(self.known.foods.food, stuff.foods)
        return all(food.is_any(word_list("clings to what is lifted")) for food in foods)


def lifts_later(later: Sequence[Stage]) -> bool:
    """Return whether at one of the stages that come ``later`` flesh is lifted out, or the rest comes to it."""
    return any(isinstance(stage, LiftedOut | Rejoined) for stage in later)
