"""What a stage does to what is in its vessel, once all that joins it is there."""

from __future__ import annotations

from collections.abc import Set

from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Stuff, Vessel
from foon_kg.integration.joining.course import COATS, MIXES, WORKS
from foon_kg.integration.making.lifting import lifts_later
from foon_kg.integration.making.outcome import MIXTURE, says_raw
from foon_kg.integration.making.placing import Placing
from foon_kg.integration.making.turns import Turn
from foon_kg.integration.preparing.preparation import Ready
from foon_kg.integration.preparing.treating import Treater
from foon_kg.integration.teaching.frames import Asked
from foon_kg.integration.teaching.operators import Attested, Way
from foon_kg.model.values import made_often


@made_often()
class Product:
    """What comes of work: one thing called ``label`` (``""``: each food stays what it is) in these ``states``."""

    label: str
    states: tuple[str, ...]


class Doing:
    """Does the work of the stages of one dish on a bench, in the vessels that were placed for them."""

    def __init__(self, placing: Placing) -> None:
        self.bench = placing.bench
        self.known = placing.known
        self.plan = placing.plan
        self.placing = placing
        self.stages = placing.stages
        self.work = placing.work

    def do(self, turn: Turn, vessel: Vessel) -> None:
        """Do what the stage of ``turn`` does to what is in ``vessel``, if it changes anything."""
        stage = turn.stage
        if self._is_idle(turn, vessel):
            return
        device, relation = self.placing.utensils.device_for(stage)
        if device and not relation:
            self._by_hand_device(turn, vessel, device)
            return
        if device:
            self._put_to(device, relation, turn, vessel)
        if "turn" in stage.does:
            self.work.cook_first_side(vessel)
        attested = self.work.ways.way(stage, vessel)
        if attested is None:
            return
        if stage.motion in word_list("pulls flesh apart"):
            self._clear(vessel)
        self._work(turn, vessel, attested, with_device=bool(device))
        if vessel.relation != "on" and not self.stages.stays_in(vessel, turn.later):
            self.bench.heat_off(vessel)

    def _clear(self, vessel: Vessel) -> None:
        """Take what nobody eats out of the flesh in a vessel, before that is pulled apart."""
        treater = Treater(self.bench)
        for join in self.plan.joins:
            for stuff in vessel.contents:
                if join.want.number in stuff.wants and not stuff.mixed:
                    treater.clear(Ready(join.want, stuff))

    def _is_idle(self, turn: Turn, vessel: Vessel) -> bool:
        """Whether a stage would change nothing; what a title asks for is done in any case."""
        stage = turn.stage
        if not stage.motion or stage.does.isdisjoint(WORKS):
            return True
        return not isinstance(stage, Asked) and self.stages.is_idle(stage, vessel, turn.later)

    def _put_to(self, device: str, relation: str, turn: Turn, vessel: Vessel) -> None:
        """Put a vessel to an appliance, unless it is there, and have that on."""
        if vessel.device is None or vessel.device.label != device:
            if "dry" in turn.stage.does:
                self.work.rising.let_rise_again(vessel)
            self.placing.into_device(vessel, device, relation)
        if not self.bench.is_running(vessel):
            self.placing.heat_on(vessel)

    def _work(self, turn: Turn, vessel: Vessel, attested: Attested, *, with_device: bool) -> None:
        """Work on what is in a vessel in the way that is attested."""
        product = self.product(turn, vessel, attested.way)
        if not product.label:
            self.work.work_each(vessel, attested, product.states, with_device=with_device)
            return
        if [Product(stuff.label, stuff.states) for stuff in vessel.contents] == [product]:
            return  # it is so already
        self.bench.work(vessel, attested, product.label, product.states, with_device=with_device)
        if turn.mixes_cold and not self._is_mixed_later(turn):
            self.work.rising.let_rise(vessel, [turn.stage, *turn.later])

    def _is_mixed_later(self, turn: Turn) -> bool:
        """Whether something joins later and is mixed in."""
        return any(one.does & MIXES and self.stages.course.stage_alive(one) for one in turn.later)

    def product(self, turn: Turn, vessel: Vessel, way: Way) -> Product:
        """Return what a stage makes of what is in a vessel, when it is done in some way."""
        finished = not turn.is_heated_on or _is_next(turn, {"blend", "mash"})  # nobody mashes what is still hard
        label = self._label(turn, vessel) or self._coated(turn, vessel)
        fried = None if label else self._fried(turn, vessel)
        if fried is not None:
            label = fried.label
        one = (bool(label) or turn.mixes_cold) and not self.stages.is_drained_next(vessel, turn.later)
        states = self.work.outcome.states(turn.stage, vessel, way, product=one, finished=finished)
        if fried is not None:
            states = self._as_fried(states, fried)
        return Product((label or MIXTURE) if one else "", states)

    def _label(self, turn: Turn, vessel: Vessel) -> str:
        """Return what the whole is called after a stage; ``""`` where it gets no name by it."""
        last = turn.main and not self.stages.is_worked_later(turn.later) and not lifts_later(turn.later)
        return self.work.outcome.label(turn.stage, vessel, last=last, main=turn.main)

    def _coated(self, turn: Turn, vessel: Vessel) -> str:
        """Return what is called as before when a stage coats it, if anything."""
        return self.work.outcome.coated(vessel) if turn.stage.does >= COATS else ""

    def _fried(self, turn: Turn, vessel: Vessel) -> Stuff | None:
        """Return the only food that a stage fries until it is done, if it fries one."""
        return self.stages.taken_up(turn.stage, vessel) if turn.heats and not turn.is_heated_on else None

    def _as_fried(self, states: tuple[str, ...], fried: Stuff) -> tuple[str, ...]:
        """Return the states of a food that is fried: those that it had and ``states``, and nothing of it is raw."""
        return tuple(sorted({*states, *(state for state in fried.states if not says_raw(state, self.known))}))

    def _by_hand_device(self, turn: Turn, vessel: Vessel, device: str) -> None:
        """Work with an appliance that is held in the hand."""
        attested = self.work.ways.way(turn.stage, vessel)
        if attested is None:
            return
        machine = self.bench.device(device)
        self.bench.switch(None, machine, on=True)
        label = self._label(turn, vessel) or MIXTURE
        states = self.work.outcome.states(turn.stage, vessel, attested.way, product=True, finished=False)
        self.bench.work(vessel, attested, label, states, extra=machine)
        self.bench.switch(None, machine, on=False)

    def take_out(self, turn: Turn, vessel: Vessel) -> Vessel:
        """Take out of a pot, or what comes out of the oven, what only gave its taste; return its vessel.

        That is before it is poured, served or blended.
        """
        if not _leaves_tastes_in(turn, vessel) or not self.work.taking_out.is_due(vessel):
            return vessel
        closed = self._is_closed_next(turn, vessel)
        if turn.heats_later and not (closed or _is_crushed_next(turn)):
            return vessel
        if len(vessel.contents) > 1:
            last = turn.main and not closed and not lifts_later(turn.later)
            self.work.name(vessel, self.work.outcome.label(turn.stage, vessel, last=last) or MIXTURE)
        self.bench.heat_off(vessel)
        return self.work.taking_out.take_out(vessel)

    def _is_closed_next(self, turn: Turn, vessel: Vessel) -> bool:
        """Whether what was cooked in ``vessel`` is baked next in or under a crust, out of which nothing comes again."""
        after = next((stage for stage in turn.later if stage.heats), None)
        if after is None or "dry" not in after.does:
            return False
        inside = {number for stuff in vessel.contents for number in stuff.wants}
        others = (join.want for join in self.plan.joins if join.want.number not in inside)
        return any(want.facts.is_any(word_list("closes what is baked")) for want in others)


def _leaves_tastes_in(turn: Turn, vessel: Vessel) -> bool:
    """Whether ``vessel`` is heated on a stove, or baked and nothing is lifted out of it, which leaves them behind."""
    if not turn.heats:
        return False
    return vessel.relation == "on" or ("dry" in turn.stage.does and not lifts_later(turn.later))


def _is_crushed_next(turn: Turn) -> bool:
    """Whether the next that is done to what a stage of ``turn`` cooks leaves no piece of it to be found again."""
    return _is_next(turn, {"blend", "mash", "shape"})


def _is_next(turn: Turn, does: Set[str]) -> bool:
    """Whether the next work on what a stage of ``turn`` cooks is one of these."""
    after = next((stage for stage in turn.later if not stage.does.isdisjoint(WORKS)), None)
    return after is not None and not after.does.isdisjoint(does)
