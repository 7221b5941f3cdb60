"""Into which vessel the foods of a stage come, on which appliance it stands, and in which order they come to it."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from operator import attrgetter

from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, fineness, is_flat, is_heated
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.joining.spots import Join, only_carries
from foon_kg.integration.making.bakeware import Bakeware
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.making.consistency import is_wet
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.stages import Stages
from foon_kg.integration.making.turns import Incoming, Turn
from foon_kg.integration.making.utensils import Utensils
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready
from foon_kg.integration.teaching.frames import BATH, Line, Stage


class Placing(Hands):
    """Takes vessels for the stages of one dish."""

    def __init__(self, bench: Bench, stages: Stages, carry: Carrier, work: Worker, ready: Mapping[int, Ready]) -> None:
        super().__init__(bench, stages.plan, carry, work, ready)
        self.stages = stages
        self.course = stages.course
        self.utensils = Utensils(bench)
        self.bakeware = Bakeware(self.known, self.plan.tin)

    # --- the vessel of a stage ---

    def placed(self, turn: Turn, vessel: Vessel | None, incoming: Incoming, *, dressed: bool) -> Vessel:
        """Return the vessel of a stage with what was in ``vessel``, where it stands when something joins.

        ``dressed``: what joins is mixed with a dish that is done. What comes into the fresh vessel before all else is
        taken out of ``incoming``.
        """
        stage = turn.stage
        device, relation = self.utensils.device_for(stage)
        label = self._label_for(stage, vessel, incoming, dressed=dressed)
        if vessel is None and is_flat(label):
            incoming.joins.sort(key=lambda join: not self._is_bed(join, stage))
        placed = self._vessel_for(turn, label, vessel, incoming)
        heats = self._is_heated(stage)
        stays = heats and placed.device is not None and placed.device.label == device
        if not stays and not self.stages.heats_on(stage, turn.later, placed):
            self.bench.heat_off(placed)
        if heats and relation == "on":
            self._put_on(placed, device, stage)
        return placed

    def is_on_stove(self, stage: Stage, vessel: Vessel) -> bool:
        """Return whether a vessel stands over the heat when something joins a stage."""
        return vessel.device is not None and self._is_heated(stage) and self.utensils.device_for(stage)[1] == "on"

    def _is_heated(self, stage: Stage) -> bool:
        """Whether an appliance heats what a stage is done in."""
        heat = stage.source == "heat" or stage.heats
        return heat and bool(self.utensils.device_for(stage)[0])

    def _put_on(self, vessel: Vessel, device: str, stage: Stage) -> None:
        """Put a vessel on an appliance, unless it is there; an empty one is filled at the tap before."""
        if vessel.device is not None and vessel.device.label == device:
            return
        if vessel.device is None and not vessel.contents:
            if self.stages.water(stage):
                self.carry.water.add(vessel)
            asked = [join for join in self.course.ordered(stage) if join.want.facts.is_a("water") and not join.on_top]
            for join in asked[:1]:
                self.bring(join, vessel)
        self.bench.place(vessel, device, "on")

    def _label_for(self, stage: Stage, vessel: Vessel | None, incoming: Incoming, *, dressed: bool) -> str:
        """Return what a stage is done in: in the frame's vessel, where that suits what comes into it."""
        device, relation = self.utensils.device_for(stage)
        label = self.utensils.vessel_label(stage, vessel, device)
        comes = vessel if vessel is not None else next(iter(incoming.lines), None)
        if comes is None:
            label = self.bakeware.deep_for(label, [join.want for join in incoming.joins])
        elif label != comes.label:
            label = self.bakeware.tin_for(label, comes, in_oven=relation == "in")
        return self._dish_label(label, stage, vessel, dressed=dressed)

    def _dish_label(self, label: str, stage: Stage, vessel: Vessel | None, *, dressed: bool) -> str:
        """Return what a dish is served in that would be in ``label``: a plate with a side, a bowl what runs."""
        if label == "bowl" and not stage.does and self.plan.has_a_side:
            return "plate"
        if not is_flat(label) or self.stages.lies_baked(vessel):
            return label
        return "bowl" if dressed or self._runs_off(vessel) else label

    def _runs_off(self, vessel: Vessel | None) -> bool:
        """Whether what is in a vessel would run off a plate: it is hot, and was in no tray."""
        if vessel is None or not vessel.hot or is_flat(vessel.label) or self.stages.on_plate:
            return False
        return self._is_wet(vessel) and not self.plan.has_a_side

    def _vessel_for(self, turn: Turn, label: str, vessel: Vessel | None, incoming: Incoming) -> Vessel:
        """Return the vessel of the stage of ``turn``, called ``label``, with what was in ``vessel``.

        Where nothing was yet, that of what joins serves.
        """
        stage = turn.stage
        if vessel is None:
            return self._first_vessel(stage, label, incoming)
        if vessel.label == label:
            return vessel
        self.bench.heat_off(vessel)
        fresh = self.bench.vessel(label)
        device, relation = self.utensils.device_for(stage)
        self._stand(fresh, stage, device if relation == "on" else "")
        under = self._lay_under(turn, fresh, incoming, hot=vessel.hot)
        if not under:
            self.grease(fresh, vessel)
        hot_first = under or not self._is_wet(vessel)
        if relation == "on" and hot_first and "heat" in stage.does:
            self.heat_on(fresh)
            self.work.heat_fat(fresh)
        self.carry.transfer(vessel, fresh, stage, whole=self.stages.lies_baked(vessel) or stage.does == {"cut"})
        return fresh

    def _lay_under(self, turn: Turn, fresh: Vessel, incoming: Incoming, *, hot: bool) -> bool:
        """Bring into a fresh vessel what comes there before what is cooked in it, or comes into it ``hot``.

        Return whether anything does.
        """
        under: Sequence[Join] = ()
        if self._bakes(fresh.label):
            under = incoming.take(self.lies_under)
        elif hot:
            under = [join for join in self._beds(turn) if not self._is_tossed(join, fresh)]
            incoming.take(under.__contains__)
        for join in under:
            self.bring(join, fresh)
            self.course.at[id(join.spot.stage)].remove(join)
        return bool(under)

    def _beds(self, turn: Turn) -> list[Join]:
        """Return what lies under a dish that is only served from now on, whenever it would come."""
        stages = (turn.stage, *turn.later)
        if not all(map(only_carries, stages)):
            return []
        return [join for stage in stages for join in self.course.ordered(stage) if self._is_bed(join, stage)]

    def _is_wet(self, vessel: Vessel) -> bool:
        return any(is_wet(stuff, self.known) for stuff in vessel.contents)

    def _bakes(self, label: str) -> bool:
        row = self.known.utensil(label)
        return row is not None and not row.can.isdisjoint({"bake", "heat", "cook"})

    def lies_under(self, join: Join) -> bool:
        """Return whether that of ``join`` comes before what is cooked in its vessel: fat, and what lies under dough."""
        under = ("fat", *word_list("lies under dough")) if self.plan.laid else ("fat",)
        return join.layer < 0 or join.want.facts.is_any(under)

    def _is_bed(self, join: Join, stage: Stage) -> bool:
        """Whether that of ``join`` lies under the dish where ``stage`` only serves it: rice, a leaf in one piece."""
        plan, want = self.plan, join.want
        if plan.stacked or plan.laid or plan.in_glass or not only_carries(stage):
            return False
        if want.facts.is_any(word_list("lies under what is served")):
            return True
        in_one = fineness([state for state in (want.make, *want.leaf) if state], self.known) == 0
        return in_one and want.facts.is_any(word_list("is a leaf to serve on"))

    @staticmethod
    def _is_tossed(join: Join, vessel: Vessel) -> bool:
        """Whether that of ``join`` is stirred into what is served in a ``vessel``."""
        return not is_flat(vessel.label) and join.want.facts.is_any(word_list("is stirred into what is done"))

    def _first_vessel(self, stage: Stage, label: str, incoming: Incoming) -> Vessel:
        """Return a vessel for what begins: that of a line or of a food that is in such a one, else a fresh one."""
        device, _ = self.utensils.device_for(stage)
        first = next(iter(incoming.lines), None)
        if first is not None and first.label == label and (first.device is None or first.device.label == device):
            return incoming.lines.pop(0)
        return self._own_vessel(label, incoming) or self._pan_with_fat(label) or self.bench.vessel(label)

    def _own_vessel(self, label: str, incoming: Incoming) -> Vessel | None:
        """Return the vessel ``label`` in which an ``incoming`` food was cooked before: the rest comes to it."""
        for join in incoming.joins:
            own = self.ready[join.want.number].stuff.at
            if own is not None and own.label == label and not own.storage and len(own.contents) == 1:
                return own
        return None

    def _pan_with_fat(self, label: str) -> Vessel | None:
        """Return an empty pan like ``label`` in which something left its fat, if there is one on the stove."""
        row = self.known.utensil(label)
        for pan in self.carry.pans_with_fat:
            other = self.known.utensil(pan.label)
            like = row is not None and other is not None and row.group == other.group
            if like and not pan.contents and pan.device is not None:
                return pan
        return None

    def _stand(self, fresh: Vessel, stage: Stage, device: str) -> None:
        """Put a vessel on an appliance, if any, with the water in which something is boiled at once."""
        if BATH in stage.adds:
            self.carry.water.add(fresh)
        if device:
            self.bench.place(fresh, device, "on")
        if BATH in stage.adds:
            self.carry.water.boil(fresh)

    def grease(self, fresh: Vessel, vessel: Vessel) -> None:
        """Grease the tin ``fresh`` for the batter or dough in ``vessel``, with some of the fat that was asked for."""
        row = self.known.utensil(fresh.label)
        if row is None or "bake" not in row.can or row.can & {"heat"}:
            return
        fats = [j.want for j in self.plan.joins if j.want.facts.is_a("fat") and j.want.facts.is_a("stock")]
        fat = min(fats, key=attrgetter("is_headed"), default=None)  # what a heading says is for another part
        if fat is not None and any(map(self._is_batter, vessel.contents)):
            self.carry.grease(fat, fresh)

    def _is_batter(self, stuff: Stuff) -> bool:
        """Whether a mixture is raw and sets when it is baked."""
        if not stuff.mixed or is_heated(stuff.states, self.known):
            return False
        return binds(stuff.foods, self.known) or any(self.known.foods.food(food).is_a("egg") for food in stuff.foods)

    # --- what comes into it ---

    def ordered(self, stage: Stage, incoming: Incoming) -> list[Join | Vessel]:
        """Return what is ``incoming`` at a stage in its order: foods, and vessels in which other lines were made."""
        found: list[Join | Vessel] = []
        waiting = list(incoming.lines)
        heats = self._is_heated(stage)
        for join in incoming.joins:
            first = _comes_before_lines(join, stage) or (not self.plan.by_table and self._is_bed(join, stage))
            if not first and not (heats and join.want.facts.is_a("fat")):
                found += waiting
                waiting = []
            found.append(join)
        return [*found, *waiting]

    # --- heat ---

    def heat_on(self, vessel: Vessel) -> None:
        """Turn on the appliance on which a vessel stands, if any."""
        if vessel.device is not None:
            self.bench.switch(vessel, vessel.device, on=True)

    def into_device(self, vessel: Vessel, device: str, relation: str) -> None:
        """Put a vessel by ``relation`` (in, on, under) to the appliance ``device``.

        An oven is on before, a machine gets its lid.
        """
        row = self.known.utensil(device)
        if row is not None and row.source == "heat" and relation == "in":
            self.bench.switch(None, self.bench.device(device), on=True)
        if relation == "attached to" or (row is not None and row.source == "power"):
            lid = f"{device} lid"
            if self.known.utensil(lid) is not None and vessel.label != "bowl":
                self.bench.cover(vessel, lid)
        self.bench.place(vessel, device, relation)

    def oven_of(self, line: Line) -> str:
        """Return the first appliance in which a stage of a line is heated, ``""`` where none is."""
        for stage in line.stages:
            device, relation = self.utensils.device_for(stage)
            if relation == "in" and "heat" in stage.does:
                return device
        return ""

    def is_lit_first(self, oven: str, stages: Sequence[Stage]) -> bool:
        """Return whether an ``oven`` that is off is lit before all ``stages``: nothing waits before a dish comes in."""
        row = self.known.utensil(oven)
        if row is None or row.source != "heat" or oven in self.bench.devices:
            return False
        if self.work.rising.rises([join.want.label for join in self.plan.joins]):
            return False  # it would be on while the dough rises
        before = list(itertools.takewhile(lambda stage: self.utensils.device_for(stage)[0] != oven, stages))
        return not any("wait" in stage.does for stage in before[:-1])


def _comes_before_lines(join: Join, stage: Stage) -> bool:
    """Whether a food comes to a stage before what other lines made: its slot does so, or all else lies on it."""
    lines = stage.lines
    first = stage.adds.index(lines[0]) if lines else len(stage.adds)
    slot = join.slot
    return join.layer < 0 or (slot is not None and slot in stage.adds and stage.adds.index(slot) < first)
