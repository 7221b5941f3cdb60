"""What joins a stage comes to it: foods, and what other lines made, in their order, into water or into a hot pan."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import Stuff, Vessel
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.alone import Alone
from foon_kg.integration.making.placing import Placing
from foon_kg.integration.making.smoothing import Smoothing
from foon_kg.integration.making.turns import Incoming, Turn
from foon_kg.integration.teaching.frames import BATH, Stage


class Adding:
    """Brings on a bench what joins the stages of one dish."""

    def __init__(self, alone: Alone, placing: Placing) -> None:
        self.bench = alone.bench
        self.known: Tables = alone.known
        self.plan = alone.plan
        self.alone = alone
        self.carry = alone.carry
        self.ready = alone.ready
        self.placing = placing
        self.stages = placing.stages
        self.work = placing.work
        self.frying = alone.frying
        self.smoothing = Smoothing(self.bench, self.plan, self.carry, self.work, self.ready)

    def add_all(self, turn: Turn, vessel: Vessel, incoming: Incoming) -> None:
        """Bring what is ``incoming`` in a ``turn`` into the ``vessel`` of its stage; the last may end it."""
        on_stove = self.placing.is_on_stove(turn.stage, vessel)
        ordered = self.placing.ordered(turn.stage, incoming)
        if self.stages.water(turn.stage) and not self._is_watered(vessel):
            self.carry.water.add(vessel)
        hot_first = on_stove and self._is_hot_first(turn.stage, vessel, ordered)
        completes = self.stages.merges(turn)
        for one in ordered:
            if hot_first and not _is_fat(one):
                self.placing.heat_on(vessel)  # what fries comes into a hot pan
                self.work.heat_fat(vessel)
            came = self._stuffs(one)
            self._add(turn.stage, vessel, one, on_stove=on_stove)
            if self._is_tossed(turn, vessel, one, came):
                self.work.toss(vessel)
            elif completes and one is ordered[-1]:
                self._complete(turn, vessel, one, incoming.joins)

    def _is_watered(self, vessel: Vessel) -> bool:
        return any(self.known.foods.food(stuff.label).is_a("water") for stuff in vessel.contents if not stuff.mixed)

    def _is_hot_first(self, stage: Stage, vessel: Vessel, ordered: Sequence[Join | Vessel]) -> bool:
        """Return whether a pan is hot before more than fat comes into it; where it would be dry it gets fat."""
        if any(map(_is_fat, ordered)):
            return True
        if vessel.contents:
            return False
        if not self.stages.would_be_dry(stage, ordered):
            return self._is_fried_in_own(stage, vessel, ordered)
        return (
            self.carry.add_fat(vessel, self.plan)
            or self._is_fried_in_own(stage, vessel, ordered)
            or "heat" in stage.does
        )

    def _is_fried_in_own(self, stage: Stage, vessel: Vessel, ordered: Sequence[Join | Vessel]) -> bool:
        """Whether fat came into a pan for what is fried there: of the household's, or some that is asked elsewhere."""
        if "heat" not in stage.does or not stage.does.isdisjoint({"dry", "liquid"}):
            return False
        comes = [stuff for one in ordered for stuff in self._stuffs(one)]
        if self.frying.add_fat(vessel, comes):
            return True
        return self.frying.keeps_dry(vessel, comes) and self.carry.add_fat(vessel, self.plan)

    def _stuffs(self, one: Join | Vessel) -> list[Stuff]:
        """Return what comes with a food or another vessel."""
        return list(one.contents) if isinstance(one, Vessel) else [self.ready[one.want.number].stuff]

    def _add(self, stage: Stage, vessel: Vessel, one: Join | Vessel, *, on_stove: bool) -> None:
        """Bring a food, or what is in another vessel, into a vessel."""
        if isinstance(one, Vessel):
            self.bench.heat_off(one)
            if on_stove and BATH in stage.adds:
                self.carry.water.boil(vessel)
            if not vessel.contents and "shape" not in stage.does:
                self.placing.grease(vessel, one)
            self.carry.transfer(one, vessel, stage)
            return
        if on_stove and one.want.facts.is_any(word_list("comes when it boils")):
            self.carry.water.boil(vessel)
        self.alone.boil_water_first(one)
        smooth = self.smoothing.made(one, vessel)
        if smooth is not None:
            self.carry.transfer(smooth, vessel, stage)
            return
        self.carry.bring_joining(one, self.ready[one.want.number], vessel)

    def _is_tossed(self, turn: Turn, vessel: Vessel, one: Join | Vessel, came: Sequence[Stuff]) -> bool:
        """Whether what came to a dish that is done is stirred into it."""
        if not turn.main or _lies_on_top(one) or self.stages.is_worked_later([turn.stage, *turn.later]):
            return False
        return len(came) == 1 and self.work.lies_on_what_is_done(came[0], vessel)

    def _complete(self, turn: Turn, vessel: Vessel, last: Join | Vessel, joins: Sequence[Join]) -> None:
        """Make one of all that is in a vessel: stirred, where something lies beside what was mixed and is no layer."""
        beside = isinstance(last, Vessel) and turn.stage.is_added and not turn.stage.does  # poured over it
        stirred = self.work.lies_unmixed(vessel) and not (beside or _lies_on_top(last) or self._has_set(vessel))
        if stirred and not self.stages.lays(turn.stage, joins, turn.later):
            self.work.stir(vessel, self.plan.label, self.work.outcome.kept_states(vessel))
        else:
            self.work.name(vessel, self.plan.label)

    def _has_set(self, vessel: Vessel) -> bool:
        """Whether what is made by a table stood in the cold to set: what comes then lies on it, unless it is drunk."""
        cold = any(says(stuff.states, "was set in the cold") for stuff in vessel.contents)
        return cold and self.plan.by_table and not self.plan.in_glass


def _is_fat(one: Join | Vessel) -> bool:
    return isinstance(one, Join) and one.want.facts.is_a("fat")


def _lies_on_top(one: Join | Vessel) -> bool:
    return isinstance(one, Join) and one.on_top
