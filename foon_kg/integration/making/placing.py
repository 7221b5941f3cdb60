"""Into which vessel the foods of a stage come, on which appliance it stands, and in which order they come to it."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Vessel, is_flat
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.bakeware import Bakeware
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.making.consistency import is_wet
from foon_kg.integration.making.stages import Stages
from foon_kg.integration.making.utensils import Utensils
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready
from foon_kg.integration.teaching.frames import BATH, Line, Stage


class Placing:
    """Takes vessels for the stages of one dish; ``ready`` are the prepared foods by the numbers of what was asked."""

    def __init__(self, bench: Bench, stages: Stages, carry: Carrier, work: Worker, ready: Mapping[int, Ready]) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.stages = stages
        self.course = stages.course
        self.plan = stages.plan
        self.carry = carry
        self.work = work
        self.ready = ready
        self.utensils = Utensils(bench)
        self.bakeware = Bakeware(self.known, self.plan.tin)

    def put_on(self, vessel: Vessel, device: str, stage: Stage) -> None:
        """Put a vessel on an appliance, unless it is there; an empty one is filled at the tap before."""
        if vessel.device is not None and vessel.device.label == device:
            return
        if vessel.device is None and not vessel.contents:
            if self.stages.water(stage):
                self.carry.water.add(vessel)
            asked = [join for join in self.course.ordered(stage) if join.want.facts.is_a("water") and not join.on_top]
            for join in asked[:1]:
                self.carry.bring(self.ready[join.want.number], vessel, join.slot)
        self.bench.place(vessel, device, "on")

    def label_for(
        self, stage: Stage, vessel: Vessel | None, lines: Sequence[Vessel], joins: Sequence[Join], *, dressed: bool
    ) -> str:
        """Return what a stage is done in: in the frame's vessel, where that suits what comes into it."""
        device, relation = self.utensils.device_for(stage)
        label = self.utensils.vessel_label(stage, vessel, device)
        comes = vessel if vessel is not None else next(iter(lines), None)
        if comes is None:
            label = self.bakeware.deep_for(label, [join.want for join in joins])
        elif label != comes.label:
            label = self.bakeware.tin_for(label, comes, in_oven=relation == "in")
        deep = vessel is not None and vessel.hot and not is_flat(vessel.label)  # on a tray nothing runs
        runs = vessel is not None and deep and any(is_wet(stuff, self.known) for stuff in vessel.contents)
        runs = runs and not self.stages.on_plate
        return "bowl" if (dressed or runs) and is_flat(label) and not self.stages.lies_baked(vessel) else label

    def vessel_for(
        self, stage: Stage, label: str, vessel: Vessel | None, lines: list[Vessel], joins: Sequence[Join]
    ) -> Vessel:
        """Return the vessel of a stage, called ``label``, with what was in ``vessel``.

        Where nothing was yet, that of ``lines`` or ``joins`` serves. What greases it is brought first, and taken out of
        ``joins``.
        """
        if vessel is None:
            return self._first_vessel(stage, label, lines, joins)
        if vessel.label == label:
            return vessel
        self.bench.heat_off(vessel)
        fresh = self.bench.vessel(label)
        row = self.known.utensil(label)
        bakes = row is not None and not row.can.isdisjoint({"bake", "heat", "cook"})
        under = ("fat", *word_list("lies under dough")) if self.plan.laid else ("fat",)
        grease = [join for join in joins if bakes and (join.layer < 0 or join.want.facts.is_a(*under))]
        device, relation = self.utensils.device_for(stage)
        self._stand(fresh, stage, device if relation == "on" else "")
        if not grease:
            self.grease(fresh, vessel)
        for join in grease:
            self.carry.bring(self.ready[join.want.number], fresh, join.slot)
            self.course.at[id(stage)].remove(join)
            joins.remove(join)  # type: ignore[attr-defined]
        hot_first = bool(grease) or not any(is_wet(stuff, self.known) for stuff in vessel.contents)
        if relation == "on" and hot_first and "heat" in stage.does:
            self.heat_on(fresh)
            self.work.heat_fat(fresh)
        self.carry.transfer(vessel, fresh, stage, whole=self.stages.lies_baked(vessel) or stage.does == {"cut"})
        return fresh

    def _first_vessel(self, stage: Stage, label: str, lines: list[Vessel], joins: Sequence[Join]) -> Vessel:
        """Return a vessel for what begins: that of a line or of a food that is in such a one, else a fresh one."""
        device, _ = self.utensils.device_for(stage)
        if lines and lines[0].label == label and (lines[0].device is None or lines[0].device.label == device):
            return lines.pop(0)
        for join in joins:
            own = self.ready[join.want.number].stuff.at
            if own is not None and own.label == label and not own.storage and len(own.contents) == 1:
                return own  # it was cooked in such a pan before, and the rest comes to it
        return self.bench.vessel(label)

    def _stand(self, fresh: Vessel, stage: Stage, device: str) -> None:
        """Put a vessel on an appliance, if any, with the water in which something is boiled at once."""
        if BATH in stage.adds:
            self.carry.water.add(fresh)
        if device:
            self.bench.place(fresh, device, "on")
        if BATH in stage.adds:
            self.carry.water.boil(fresh)

    def grease(self, fresh: Vessel, vessel: Vessel) -> None:
        """Grease a tin for batter or dough, with some of the fat that was asked for."""
        row = self.known.utensil(fresh.label)
        if row is None or "bake" not in row.can or row.can & {"heat"}:
            return
        soft = any(
            stuff.mixed
            and not any(self.known.state(state).needs_heat for state in stuff.states)
            and (binds(stuff.foods, self.known) or any(self.known.foods.food(f).is_a("egg") for f in stuff.foods))
            for stuff in vessel.contents
        )
        fat = next((j.want for j in self.plan.joins if j.want.facts.is_a("fat") and j.want.facts.is_a("stock")), None)
        if not soft or fat is None:
            return
        self.carry.grease(fat, fresh)

    def comers(
        self, stage: Stage, joins: Sequence[Join], lines: Sequence[Vessel], *, heats: bool
    ) -> list[Join | Vessel]:
        """Return what joins a stage in its order: foods, and vessels in which other lines were made."""
        stuffs: list[Join | Vessel] = []
        waiting = list(lines)
        by_line = [add for add in stage.adds if isinstance(add, Line)]
        first_line = min((stage.adds.index(add) for add in by_line), default=len(stage.adds))
        for join in joins:
            before = join.slot is not None and join.slot in stage.adds and stage.adds.index(join.slot) < first_line
            before = before or join.layer < 0
            if waiting and not before and not (heats and join.want.facts.is_a("fat")):
                stuffs += waiting
                waiting = []
            stuffs.append(join)
        return [*stuffs, *waiting]

    def heat_on(self, vessel: Vessel) -> None:
        """Turn on the appliance on which a vessel stands, if any."""
        if vessel.device is not None:
            self.bench.switch(vessel, vessel.device, on=True)

    def into_device(self, vessel: Vessel, device: str, relation: str) -> None:
        """Put a vessel in, on or under the appliance ``device``: an oven is on before, a machine gets its lid."""
        row = self.known.utensil(device)
        if row is not None and row.source == "heat" and relation == "in":
            self.bench.switch(None, self.bench.device(device), on=True)
        if relation == "attached to" or (row is not None and row.source == "power"):
            lid = f"{device} lid"
            if self.known.utensil(lid) is not None and vessel.label != "bowl":
                self.bench.cover(vessel, lid)
        self.bench.place(vessel, device, relation)

    def is_lit_first(self, oven: str, stages: Sequence[Stage]) -> bool:
        """Return whether an ``oven`` that is off is lit first of all: nothing waits before a dish comes into it."""
        row = self.known.utensil(oven)
        if row is None or row.source != "heat" or oven in self.bench.devices:
            return False
        if self.work.rising.rises([join.want.label for join in self.plan.joins]):
            return False
        before = list(itertools.takewhile(lambda stage: self.utensils.device_for(stage)[0] != oven, stages))
        return not any("wait" in stage.does for stage in before[:-1])
