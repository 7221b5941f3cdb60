"""Making a dish after a frame: foods are prepared, brought together stage by stage, and heated block by block.

The phases are always the same (design, section 8): everything is cut and opened first; what has to be cooked by itself
is cooked; then the lines of the frame are carried out, each heat block uninterrupted; at the end everything is off.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Food, Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.alone import Alone
from foon_kg.integration.batters import binds
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, foods_of, is_flat
from foon_kg.integration.carrying import Carrier
from foon_kg.integration.coated import is_portion
from foon_kg.integration.course import COATS, HEATS, MIXES, WORKS, Course, Plan
from foon_kg.integration.crowned import crowned
from foon_kg.integration.frames import BATH, Asked, Line, Phase, Stage
from foon_kg.integration.operators import Attested, form_of
from foon_kg.integration.phases import in_phases
from foon_kg.integration.preparation import Ready
from foon_kg.integration.preparer import Preparer
from foon_kg.integration.serving import Serving
from foon_kg.integration.spots import Join, only_carries
from foon_kg.integration.utensils import Utensils
from foon_kg.integration.working import Worker

_GRATED = 4
_MIXTURE = "mixture"


_BY_ITSELF = word_list("is boiled by itself")


class Cooking:
    """One dish in the making on a bench."""

    def __init__(self, bench: Bench, line: Line, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.line, self.plan = line, plan = in_phases(*crowned(line, plan, self.known), self.known)
        self.ready: dict[int, Ready] = {}
        self.boiled_late: dict[int, Sequence[str]] = {}  # how it is cooked when the sauce is ready
        self.base_late: dict[int, Sequence[str]] = {}  # how a base is done when what lies on it is ready
        self.course = Course(line, plan)
        self.preparer = Preparer(bench)
        self.carry = Carrier(bench, self.preparer)
        self.alone = Alone(bench, self.course, self.preparer, self.carry, self.ready)
        self.work = Worker(bench, plan, self.alone)
        self.serving = Serving(bench, plan, self.carry, self.work, self.ready)
        self.utensils = Utensils(bench)

    # --- the whole ---

    def make(self) -> Stuff:
        """Make the dish and return it; raises :class:`RefusedError` where a step cannot be done."""
        flesh = word_list("is flesh")
        for join in sorted(self.course.in_order(), key=lambda one: one.want.facts.is_a(*flesh)):
            self._prepare(join)  # raw meat last: nothing else comes under its knife
        self.bench.phase = "heat"
        for join in self.course.in_order():
            method = self.alone.cooked_first(join)
            if method and self.plan.stacked and join.want.facts.is_a(*word_list("carries what is stacked")):
                self.base_late[join.want.number] = method
            elif method and self._waits_for_sauce(join.spot.stage) and join.want.facts.is_a(*_BY_ITSELF):
                self.boiled_late[join.want.number] = method
            elif method:
                self.alone.cook_first(join, method)
        vessel = self._run(self.line, main=True)
        if vessel is None:
            raise RefusedError("nothing of what was asked joins this dish")
        self.bench.phase = "finish"
        vessel = self._finish(vessel)
        if len(vessel.contents) > 1 or vessel.contents[0].label != self.plan.label:
            self.work.name(vessel, self.plan.label)
        self.bench.forget_short_breaks()
        return vessel.contents[0]

    # --- single foods ---

    def _prepare(self, join: Join) -> None:
        stage, want = join.spot.stage, join.want
        mashed = "mash" in stage.does and "mix" not in stage.does
        blended = (
            mashed
            or "blend" in stage.does
            or any(not one.does.isdisjoint({"blend"}) for one in join.spot.after[:1] if not stage.does)
        )
        form = join.slot.states if join.slot is not None else ()
        if self.plan.stacked and want.facts.is_a(*word_list("is split")):
            form = (*form, "halved")
        if self.plan.stacked and want.facts.is_a(*word_list("is sliced to be stacked")):
            form = (*form, "sliced")
        pulled = any(one.motion in word_list("pulls flesh apart") for one in join.spot.after)
        small = isinstance(stage, Phase) and stage.small and not pulled
        if small and want.facts.is_a(*word_list("is cut for a dish")):
            form = (*form, "chopped")
        cut = bool(want.make) and (self.known.state(want.make).fine or 0) > 0
        if not cut and self._is_eaten_raw(join) and want.facts.is_a(*word_list("is never eaten whole")):
            want = replace(want, make=min(word_list("is cut so to be eaten raw")))
        if not cut and self._is_shaped_later(join) and want.facts.is_a(*word_list("is mashed to be shaped")):
            want = replace(want, make="mashed")
        if self.plan.in_pieces and want.facts.is_a(*word_list("is crumbled")):
            form = (*form, "crumbled")
        self.bench.phase = "prepare"
        first = self.alone.cooked_first(join)
        whole = first and not self.alone.is_fried_open(want)
        if whole and "shell" in want.facts.owes and form_of(self.known, want.label, want.leaf) != "liquid":
            taken = self.bench.fetch(want.label, want.leaf, [want.number], want.storage)
            self.ready[want.number] = self._cut_once_done(Ready(want, taken, whole_shell=True))
            return
        ready = self.preparer.prepare(want, form, divided=not blended, alone=bool(first))
        if first:
            ready = self._cut_once_done(ready)
        self.ready[want.number] = ready
        self.alone.beaten_first(join, ready)
        if want.facts.is_a("water") and self.course.is_hot(stage):
            self.alone.measure(ready)

    def _is_eaten_raw(self, join: Join) -> bool:
        """Whether a food joins what nobody heats any more, or what is shaped with it inside."""
        works = (join.spot.stage, *join.spot.after)
        blended = any(not stage.does.isdisjoint({"blend", "liquid"}) for stage in works)
        return not blended and (self._is_shaped_later(join) or all(stage.does.isdisjoint(HEATS) for stage in works))

    def _is_shaped_later(self, join: Join) -> bool:
        """Whether the mass that a food joins is shaped, and then cooked: patties."""
        places = [place for place, stage in enumerate(join.spot.after) if "shape" in stage.does]
        return bool(places) and any("heat" in stage.does for stage in join.spot.after[places[0] :])

    def _cut_once_done(self, ready: Ready) -> Ready:
        """Have what is eaten in pieces cut when it is cooked."""
        pieces = self.plan.in_pieces and ready.want.facts.is_a(*word_list("is cut once it is cooked"))
        thick = self.plan.laid and ready.want.facts.is_a(*word_list("is flesh"))
        flat = self.plan.stacked and ready.want.facts.is_a(*word_list("is fried rather than boiled"))
        pieces = pieces or (self.plan.stacked and ready.want.facts.is_a(*word_list("is cut to be stacked")))
        if pieces or thick or (self.alone.is_asked_done(ready.want) and not flat):
            self.preparer.cut_once_done(ready)
        return ready

    # --- lines ---

    def _run(self, line: Line, *, main: bool = False, after: Sequence[Stage] = ()) -> Vessel | None:
        subs: dict[int, Vessel] = {}
        for place, stage in enumerate(line.stages):
            later = (*line.stages[place + 1 :], *after)
            for add in stage.adds:
                late = self._waits_for_sauce(stage) and isinstance(add, Line) and self._is_drained(add)
                if isinstance(add, Line) and self.course.alive(add) and not late:
                    made = self._run(add, after=(stage, *later))
                    if made is not None:
                        subs[id(add)] = made
        vessel: Vessel | None = None
        oven = next(
            (
                label
                for stage in line.stages
                for label, relation in [self.utensils.device_for(stage)]
                if relation == "in" and "heat" in stage.does
            ),
            "",
        )
        for place, stage in enumerate(line.stages):
            later = (*line.stages[place + 1 :], *after)
            if oven and self._preheats(oven) and self._is_near(oven, line.stages[place:]):
                self.bench.switch(None, self.bench.device(oven), on=True)  # it is hot when the dish comes in
                oven = ""
            self._boil_now(stage, vessel, subs, later)
            if vessel is not None and stage.motion in word_list("strains"):
                vessel = self.work.strained(vessel)
            else:
                vessel = self._stage(stage, vessel, subs, later, main=main)
        if vessel is not None:
            self.bench.heat_off(vessel)
        return vessel

    def _waits_for_sauce(self, stage: Stage) -> bool:
        """Whether what is boiled and drained joins a sauce that cooks before: it is boiled when that is ready."""
        return isinstance(stage, Phase) and stage.bath and not self.plan.one_pot

    def _is_drained(self, line: Line) -> bool:
        row = self.known.utensil(line.stages[-1].vessel) if line.stages[-1].vessel else None
        return row is not None and "strain" in row.can

    def _boil_now(self, stage: Stage, vessel: Vessel | None, subs: dict[int, Vessel], later: Sequence[Stage]) -> None:
        """Boil what waited for the sauce that it joins now; meanwhile that is off the heat."""
        if not self._waits_for_sauce(stage):
            return
        beside = [add for add in stage.adds if isinstance(add, Line) and self._is_drained(add)]
        lines = [line for line in beside if id(line) not in subs and self.course.alive(line)]
        joins = [join for join in self.course.ordered(stage) if join.want.number in self.boiled_late]
        if vessel is not None and (lines or joins):
            self.bench.heat_off(vessel)
        for line in lines:
            made = self._run(line, after=(stage, *later))
            if made is not None:
                subs[id(line)] = made
        for join in joins:
            self.alone.cook_first(join, self.boiled_late.pop(join.want.number))

    def _cook_base_now(self, joins: Sequence[Join], ready: Sequence[Vessel | None]) -> None:
        """Cook the base that waited until what is laid on it is ready; that is off the heat meanwhile."""
        late = [join for join in joins if join.want.number in self.base_late]
        for vessel in ready if late else ():
            if vessel is not None:
                self.bench.heat_off(vessel)
        for join in late:
            self.alone.cook_first(join, self.base_late.pop(join.want.number))

    def _is_near(self, oven: str, stages: Sequence[Stage]) -> bool:
        """Whether nothing has to wait before a dish comes into an oven: then that is lit first of all."""
        if self.work.rises([join.want.label for join in self.plan.joins]):
            return False
        before = list(itertools.takewhile(lambda stage: self.utensils.device_for(stage)[0] != oven, stages))
        return not any("wait" in stage.does for stage in before[:-1])

    def _preheats(self, label: str) -> bool:
        row = self.known.utensil(label)
        return row is not None and row.source == "heat" and label not in self.bench.devices

    def _stage(
        self, stage: Stage, vessel: Vessel | None, subs: dict[int, Vessel], later: Sequence[Stage], *, main: bool
    ) -> Vessel | None:
        joins = self.serving.in_layers(self.course.ordered(stage))
        lines = [subs[id(add)] for add in stage.adds if isinstance(add, Line) and id(add) in subs]
        if vessel is None and not joins and not lines:
            return None
        if main and self.plan.stacked and self.serving.is_put_together(stage, joins, later):
            for one in later:
                joins += self.course.taken(one)
                lines += [subs.pop(id(add)) for add in one.adds if isinstance(add, Line) and id(add) in subs]
            self._cook_base_now(joins, [*lines, vessel])
            return self.serving.stack(stage, vessel, joins, lines)
        self._cook_base_now(joins, [*lines, vessel])
        if main and vessel is not None and not joins and not lines and self._stays_there(stage, vessel, later):
            return vessel
        device, relation = self.utensils.device_for(stage)
        alone = vessel is None and not lines and len(joins) == 1  # there is nothing to mix it with
        dressed = main and not alone and self.serving.is_dressed(stage, vessel, joins, later)
        label = self._label_for(stage, vessel, lines, joins, dressed=dressed)
        vessel = self._vessel_for(stage, label, vessel, lines, joins)
        heats = bool(device) and (not stage.does.isdisjoint(HEATS) or stage.source == "heat")
        if (
            vessel.device is not None
            and (not heats or vessel.device.label != device)
            and not self._heats_on(stage, later, vessel)
        ):
            self.bench.heat_off(vessel)
        if heats and relation == "on":
            self._put_on(vessel, device, stage)
        tops = [join for join in joins if dressed and self.serving.lies_on_top(join)]
        self._add_all(
            stage, vessel, [join for join in joins if join not in tops], lines,
            heats=heats, relation=relation, later=later, main=main and not dressed,
        )  # fmt: skip
        if not vessel.contents:
            return None
        if dressed:
            self.serving.dress(vessel)
        for join in tops:
            self.carry.bring(self.ready[join.want.number], vessel, join.slot)
            self.work.name(vessel, self.plan.label)
        self._do(stage, vessel, device, relation, later, main=main)
        return self._take_out(stage, vessel, later, main=main)

    def _take_out(self, stage: Stage, vessel: Vessel, later: Sequence[Stage], *, main: bool) -> Vessel:
        """Take out of a pot what only gave its taste, before that is poured, served or blended; return its vessel."""
        hot = not stage.does.isdisjoint(HEATS) and vessel.relation == "on"
        if not hot or any(not one.does.isdisjoint(HEATS) for one in later):
            return vessel
        inside = {number for stuff in vessel.contents for number in stuff.wants}
        if any(self.work.is_taken_out(join.want) for join in self.plan.joins if join.want.number in inside):
            self.bench.heat_off(vessel)
            if len(vessel.contents) > 1:
                self.work.name(vessel, self.plan.label if main else stage.label or _MIXTURE)
            return self.work.take_out(vessel)
        return vessel

    def _put_on(self, vessel: Vessel, device: str, stage: Stage) -> None:
        """Put a vessel on an appliance, unless it is there; an empty one is filled at the tap before."""
        if vessel.device is not None and vessel.device.label == device:
            return
        if vessel.device is None and not vessel.contents:
            if self._water(stage):
                self.carry.add_water(vessel)
            asked = [join for join in self.course.ordered(stage) if join.want.facts.is_a("water") and not join.on_top]
            for join in asked[:1]:
                self.carry.bring(self.ready[join.want.number], vessel, join.slot)
        self.bench.place(vessel, device, "on")

    def _label_for(
        self, stage: Stage, vessel: Vessel | None, lines: Sequence[Vessel], joins: Sequence[Join], *, dressed: bool
    ) -> str:
        """Return what a stage is done in: in the frame's vessel, where that suits what comes into it."""
        device, relation = self.utensils.device_for(stage)
        label = self.utensils.vessel_label(stage, vessel, device)
        comes = vessel if vessel is not None else next(iter(lines), None)
        if comes is None:
            label = self.carry.deep_for(label, [join.want for join in joins])
        elif label != comes.label:
            label = self.carry.tin_for(label, comes, self.plan.tin, in_oven=relation == "in")
        runs = vessel is not None and vessel.hot and any(self.carry.is_wet(stuff) for stuff in vessel.contents)
        return "bowl" if (dressed or runs) and is_flat(label) and not self._lies_baked(vessel) else label

    def _lies_baked(self, vessel: Vessel | None) -> bool:
        """Whether a dish that lies on its dough comes out of the oven in one piece, however wet what lies on it."""
        return self.plan.laid and vessel is not None and any("baked" in stuff.states for stuff in vessel.contents)

    def _goes_on(self, stage: Stage, following: Stage) -> bool:
        """Whether the next stage only goes on with what this one does: once is enough."""
        if (
            self.course.stage_alive(following)
            or self._water(following)
            or stage.vessel != following.vessel
            or stage.appliance != following.appliance
        ):
            return False
        kinds = (frozenset({"heat"}), MIXES)
        mine = next((kind for kind in kinds if stage.does & kind), None)
        return mine is not None and bool(following.does & mine) and not stage.does & {"dry", "shape", "knead", "blend"}

    def _heats_on(self, stage: Stage, later: Sequence[Stage], vessel: Vessel) -> bool:
        """Whether a vessel stays over the heat: the next heating is on the same appliance."""
        if vessel.device is None or stage.vessel not in {vessel.label, ""} or "cut" in stage.does:
            return False
        for one in later:
            if one.source == "heat" and not one.does.isdisjoint(HEATS):
                return one.appliance == vessel.device.label and one.vessel in {vessel.label, ""}
            if one.vessel not in {vessel.label, ""}:
                return False
        return False

    def _vessel_for(
        self, stage: Stage, label: str, vessel: Vessel | None, lines: list[Vessel], joins: Sequence[Join]
    ) -> Vessel:
        if vessel is None:
            device, _ = self.utensils.device_for(stage)
            if lines and lines[0].label == label and (lines[0].device is None or lines[0].device.label == device):
                return lines.pop(0)
            for join in joins:
                own = self.ready[join.want.number].stuff.at
                if own is not None and own.label == label and not own.storage and len(own.contents) == 1:
                    return own  # it was cooked in such a pan before, and the rest comes to it
            return self.bench.vessel(label)
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
            self._grease(fresh, vessel)
        for join in grease:
            self.carry.bring(self.ready[join.want.number], fresh, join.slot)
            self.course.at[id(stage)].remove(join)
            joins.remove(join)  # type: ignore[attr-defined]
        hot_first = bool(grease) or not any(self.carry.is_wet(stuff) for stuff in vessel.contents)
        if relation == "on" and hot_first and "heat" in stage.does:
            self._heat_on(fresh)
            self.work.heat_fat(fresh)
        self.carry.transfer(vessel, fresh, stage, whole=self._lies_baked(vessel) or stage.does == {"cut"})
        return fresh

    def _stand(self, fresh: Vessel, stage: Stage, device: str) -> None:
        """Put a vessel on an appliance, if any, with the water in which something is boiled at once."""
        if BATH in stage.adds:
            self.carry.add_water(fresh)
        if device:
            self.bench.place(fresh, device, "on")
        if BATH in stage.adds:
            self.carry.boil_water(fresh)

    def _grease(self, fresh: Vessel, vessel: Vessel) -> None:
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

    def _add_all(
        self, stage: Stage, vessel: Vessel, joins: Sequence[Join], lines: Sequence[Vessel], *,
        heats: bool, relation: str, later: Sequence[Stage], main: bool,
    ) -> None:  # fmt: skip
        on_stove = heats and vessel.device is not None and relation == "on"
        stuffs = self._comers(stage, joins, lines, heats=heats)
        watered = any(self.known.foods.food(stuff.label).is_a("water") for stuff in vessel.contents if not stuff.mixed)
        if self._water(stage) and not watered:
            self.carry.add_water(vessel)
        fat_first = any(isinstance(one, Join) and one.want.facts.is_a("fat") for one in stuffs)
        hot_first = fat_first
        if on_stove and not vessel.contents and not fat_first and self._would_be_dry(stage, stuffs):
            hot_first = self.carry.add_fat(vessel, self.plan) or "heat" in stage.does
        for number, one in enumerate(stuffs):
            last = number == len(stuffs) - 1
            merge = self._merges(stage, later, main=main) and last
            fat = isinstance(one, Join) and one.want.facts.is_a("fat")
            if on_stove and hot_first and not fat:
                self._heat_on(vessel)  # what fries comes into a hot pan
                self.work.heat_fat(vessel)
            self._add(stage, vessel, one, on_stove=on_stove)
            on_top = isinstance(one, Join) and one.on_top
            if merge and self.work.lies_unmixed(vessel) and not on_top and not self._lays(stage, joins):
                attested = self.work.stirring(foods_of(vessel))
                self.bench.work(vessel, attested, self.plan.label, self.work.kept_states(vessel), with_device=False)
            elif merge and (main or len(vessel.contents) > 1):
                self.work.name(vessel, self.plan.label if main else self.work.label(stage, vessel))

    def _add(self, stage: Stage, vessel: Vessel, one: Join | Vessel, *, on_stove: bool) -> None:
        """Bring a food, or what is in another vessel, into a vessel."""
        if isinstance(one, Vessel):
            self.bench.heat_off(one)
            if on_stove and BATH in stage.adds:
                self.carry.boil_water(vessel)
            if not vessel.contents and "shape" not in stage.does:
                self._grease(vessel, one)
            self.carry.transfer(one, vessel, stage)
            return
        if on_stove and one.want.facts.is_a(*word_list("comes when it boils")):
            self.carry.boil_water(vessel)
        self.alone.boil_water_first(one)
        self.carry.bring(self.ready[one.want.number], vessel, one.slot)

    def _lays(self, stage: Stage, joins: Sequence[Join]) -> bool:
        """Whether the recorded dish lays just such foods on each other and never mixes them: layers."""
        laid = bool(joins) and all(join.slot is not None and join.slot in stage.adds for join in joins)
        return laid and "wait" in stage.does and not (self.plan.in_pieces or self.plan.drunk)

    def _would_be_dry(self, stage: Stage, stuffs: Sequence[Join | Vessel]) -> bool:
        """Whether solid food comes into a pan with nothing to cook in."""
        if "dry" in stage.does:
            return False
        facts = [one.want.facts for one in stuffs if isinstance(one, Join)]
        wet = any(one.is_a(*word_list("wets the pan")) for one in facts)
        solid = any(not one.is_a(*word_list("only flavours")) for one in facts)
        return solid and not wet and not any(isinstance(one, Vessel) for one in stuffs)

    def _comers(
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

    def _merges(self, stage: Stage, later: Sequence[Stage], *, main: bool) -> bool:
        """Whether nothing mixes the whole any more, so that what joins last completes it."""
        works = [stage, *later]
        return (
            main
            and not any(self._mixing(one) for one in works)
            and not any(self.course.stage_alive(one) for one in later)
        )

    def _mixing(self, stage: Stage) -> bool:
        return bool(stage.motion) and not stage.does.isdisjoint(MIXES | HEATS)

    def _water(self, stage: Stage) -> bool:
        """Whether free water joins here: the frame has it, nobody asked for it, and no other liquid takes its place."""
        taken = [join.slot for join in self.plan.joins if join.slot is not None]
        free = [slot for slot in stage.slots if not any(slot is one for one in taken)]
        if not any(slot.food == "water" for slot in free) or stage.does.isdisjoint(WORKS):
            return False
        bath = any(slot == BATH for slot in free)
        if not bath and any(join.want.facts.is_a("water") for join in self.plan.joins):
            return False
        if isinstance(stage, Phase):
            return True
        alike = any(join.slot is not None for join in self.plan.joins if join.spot.stage is stage)
        bought = "knead" in stage.does and any(join.want.facts.is_a("dough") for join in self.plan.joins)
        if bought or not (stage.appliance or alike):
            return False  # bought dough has its water, and nothing comes of what the video thins with it
        apart = any(join.want.facts.is_a(*word_list("is boiled by itself")) for join in self.plan.joins)
        if apart and not self.plan.one_pot and "liquid" not in stage.does:
            return False  # that was the water to boil it in
        liquids = [join for join in self.plan.joins if join.want.facts.is_a("cooking liquid")]
        return not any(join.spot.stage is stage for join in liquids)

    # --- heat and work ---

    def _heat_on(self, vessel: Vessel) -> None:
        if vessel.device is not None:
            self.bench.switch(vessel, vessel.device, on=True)

    def _do(
        self, stage: Stage, vessel: Vessel, device: str, relation: str, later: Sequence[Stage], *, main: bool
    ) -> None:
        idle = not isinstance(stage, Asked) and self._is_idle(stage, vessel, later)
        if not stage.motion or stage.does.isdisjoint(WORKS) or idle:
            return
        if device and not relation:
            self._by_hand_device(stage, vessel, device, later, main=main)
            return
        if device and (vessel.device is None or vessel.device.label != device):
            if "dry" in stage.does:
                self.work.let_rise_again(vessel)
            self._into_device(vessel, device, relation)
        if vessel.device is not None and not self.bench.is_running(vessel) and vessel.device.label == device:
            self._heat_on(vessel)
        if "turn" in stage.does:
            self.work.cook_first_side(vessel)
        attested = self.work.way(stage, vessel)
        if attested is None:
            return
        self._work(stage, vessel, attested, later, with_device=bool(device), main=main)
        if vessel.device is not None and vessel.relation != "on" and not self._stays_in(vessel, later):
            self.bench.heat_off(vessel)

    def _work(
        self, stage: Stage, vessel: Vessel, attested: Attested, later: Sequence[Stage], *, with_device: bool, main: bool
    ) -> None:
        mixes = not stage.does.isdisjoint(MIXES)
        heats = not stage.does.isdisjoint(HEATS)
        # what is only browned at last, by no video's step, is done before
        finished = not any(not one.does.isdisjoint(HEATS) for one in later if one.step >= 0)
        label = self.work.label(stage, vessel, last=main and not any(self._mixing(one) for one in later), main=main)
        label = label or (self.work.coated(vessel) if stage.does >= COATS else "")
        fried = self._fried(vessel) if heats and finished and not label else None
        label = label if fried is None else fried.label
        product = (bool(label) or (mixes and not heats)) and not self._is_drained_next(vessel, later)
        states = self.work.states(stage, vessel, attested.way, product=product, finished=finished)
        if fried is not None:
            states = tuple(sorted({*states, *(s for s in fried.states if not self.alone.says_raw(s))}))
        if product and [(stuff.label, stuff.states) for stuff in vessel.contents] == [(label or "mixture", states)]:
            return
        if product:
            self.bench.work(vessel, attested, label or "mixture", states, with_device=with_device)
            if mixes and not heats and not any(one.does & MIXES and self.course.stage_alive(one) for one in later):
                self.work.let_rise(vessel, [stage, *later])
        else:
            self.work.work_each(vessel, attested, states, with_device=with_device)

    def _fried(self, vessel: Vessel) -> Stuff | None:
        """Return the only food that is fried in a vessel: the fat and the spices that cling to it are one with it."""
        clings = word_list("clings to what is fried")
        foods = [stuff for stuff in vessel.contents if not self.known.foods.food(stuff.label).is_a(*clings)]
        return foods[0] if len(foods) == 1 < len(vessel.contents) else None

    def _is_drained_next(self, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Whether the water in which foods are cooked is poured away then: until then it is no part of anything."""
        row = self.known.utensil(later[0].vessel) if later and later[0].vessel else None
        water = any(self.known.foods.food(stuff.label).is_a("water") for stuff in vessel.contents if not stuff.mixed)
        return water and row is not None and "strain" in row.can

    def _is_idle(self, stage: Stage, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Whether a stage would change nothing: it is done again anyway, or there is only one food to be mixed."""
        mixes = not stage.does.isdisjoint(MIXES)
        heats = not stage.does.isdisjoint(HEATS)
        single = len(vessel.contents) == 1 and not vessel.contents[0].mixed
        following = self._next(later, vessel)
        if following is not None and self._goes_on(stage, following):
            return True
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        if later and heats and all(self._is_only_made_hot(food) for food in foods) and not self._is_awaited(later[0]):
            return True
        flat = stage.motion in word_list("rises") and not any(f.is_a(*word_list("makes dough rise")) for f in foods)
        done = "turn" in stage.does and not stage.appliance and is_flat(vessel.label)  # it lies on a plate
        if flat or (done and not heats) or ("cut" in stage.does and not heats and self._is_in_pieces(vessel)):
            return True
        needless = stage.does <= {"coat", "mix", "scatter"} or self._is_done_so(stage, vessel.contents[0])
        if single and mixes and not heats and needless:
            return True
        if mixes and stage.does <= {"mash", "mix", "blend", "move", "scatter"} and self._is_mixed(stage, vessel):
            return True
        rolled = "shape" in stage.does and bool(foods) and foods[0].is_a("dough") and not self._is_shaped(vessel)
        opened = stage.does == {"cut"} and "baked" in vessel.contents[0].states
        alone = stage.does.isdisjoint({"peel", "wait"})
        return not mixes and not heats and alone and single and not rolled and not opened

    def _is_awaited(self, following: Stage) -> bool:
        """Whether something comes next that has to come into a liquid that is hot: what was shaped."""
        lines = (add for add in following.adds if isinstance(add, Line))
        return (
            isinstance(following, Phase) and following.bath and any("shape" in s.does for a in lines for s in a.stages)
        )

    def _next(self, later: Sequence[Stage], vessel: Vessel) -> Stage | None:
        """Return the next stage, past one that only turns food over and that nobody does here."""
        turns = bool(later) and later[0].does == {"turn"} and not self.course.stage_alive(later[0])
        if turns and len(later) > 1 and self._is_idle(later[0], vessel, later[1:]):
            return later[1]
        return next(iter(later), None)

    def _is_in_pieces(self, vessel: Vessel) -> bool:
        """Whether there is nothing to cut in what a dish is cooked in: all of it is small, or one with the rest."""
        row = self.known.utensil(vessel.label)
        fine = all(s.mixed or any((self.known.state(t).fine or 0) > 0 for t in s.states) for s in vessel.contents)
        return row is not None and bool(row.can & {"heat", "cook"}) and fine and len(vessel.contents) > 1

    def _is_shaped(self, vessel: Vessel) -> bool:
        """Whether dough was bought rolled out."""
        names = {word for food in foods_of(vessel) for word in food.split()}
        return not word_list("dough that is shaped").isdisjoint(names)

    def _is_done_so(self, stage: Stage, stuff: Stuff) -> bool:
        """Whether one food is as a stage would make it: beaten before, in small bits, or dough that was bought."""
        facts = self.known.foods.food(stuff.label)
        beaten = "whip" in stage.does and not self.known.motion(stage.motion).gives.isdisjoint(stuff.states)
        small = any((self.known.state(state).fine or 0) >= _GRATED for state in stuff.states)
        small = small or form_of(self.known, stuff.label, stuff.states) == "powder"
        if small and not stage.does.isdisjoint({"blend", "whip"}):
            return True
        return beaten or ("knead" in stage.does and facts.is_a("dough"))

    def _is_only_made_hot(self, food: Food) -> bool:
        return food.is_a(*word_list("is only made hot")) and not food.is_a(*word_list("is cooked in phases"))

    def _is_mixed(self, stage: Stage, vessel: Vessel) -> bool:
        """Whether nothing is left to be mixed: it is mixed and nothing joined, or it is one food that pours."""
        if len(vessel.contents) != 1:
            return False
        (stuff,) = vessel.contents
        if not stuff.mixed:
            return form_of(self.known, stuff.label, stuff.states) in {"powder", "liquid"}
        done = {"blended"} if "blend" in stage.does else {"mixed", "blended"}
        return not self.course.stage_alive(stage) and not done.isdisjoint(stuff.states)

    def _stays_in(self, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Whether a vessel stays in its appliance: the next heating is there, and nothing joins before."""
        following = next((one for one in later if not one.does.isdisjoint(HEATS)), None)
        return (
            following is not None
            and vessel.device is not None
            and following.appliance == vessel.device.label
            and following.vessel in {vessel.label, ""}
            and not any(one.adds for one in later)
        )

    def _by_hand_device(self, stage: Stage, vessel: Vessel, device: str, later: Sequence[Stage], *, main: bool) -> None:
        """Work with an appliance that is held in the hand."""
        attested = self.work.way(stage, vessel)
        if attested is None:
            return
        machine = self.bench.device(device)
        self.bench.switch(None, machine, on=True)
        label = self.work.label(stage, vessel, last=main and not any(self._mixing(one) for one in later), main=main)
        states = self.work.states(stage, vessel, attested.way, product=True, finished=False)
        self.bench.work(vessel, attested, label or "mixture", states, extra=machine)
        self.bench.switch(None, machine, on=False)

    def _into_device(self, vessel: Vessel, device: str, relation: str) -> None:
        row = self.known.utensil(device)
        if row is not None and row.source == "heat" and relation == "in":
            self.bench.switch(None, self.bench.device(device), on=True)
        if relation == "attached to" or (row is not None and row.source == "power"):
            lid = f"{device} lid"
            if self.known.utensil(lid) is not None and vessel.label != "bowl":
                self.bench.cover(vessel, lid)
        self.bench.place(vessel, device, relation)

    def _has_no_portions(self) -> bool:
        """Whether a dish is spooned out of what it is baked in: nothing in it comes in portions."""
        return not any(is_portion(join.want, self.known) for join in self.plan.joins)

    def _stays_there(self, stage: Stage, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Whether a dish is only carried on though it is eaten out of what it was baked in."""
        row = self.known.utensil(vessel.label)
        ends = all(only_carries(one) and not self.course.stage_alive(one) for one in (stage, *later))
        dish = row is not None and row.group in word_list("is served in what it is baked in")
        baked = any("baked" in stuff.states for stuff in vessel.contents)
        return ends and dish and baked and not self.plan.tin and not self.plan.laid and self._has_no_portions()

    def _finish(self, vessel: Vessel) -> Vessel:
        """Turn everything off and serve the dish, where nobody eats from what it is in; return what it is in then."""
        self.bench.heat_off(vessel)
        self.bench.all_off()
        row = self.known.utensil(vessel.label)
        if self.plan.drunk and row is not None and row.group in word_list("is not drunk from"):
            glass = self.bench.vessel("mug" if vessel.hot else "drinking glass")
            self.carry.transfer(vessel, glass, self.line.stages[-1])
            return glass
        if row is None or row.can.isdisjoint({"heat", "cook", "bake"}) or "chilled" in vessel.contents[0].states:
            return vessel
        if len(vessel.contents) > 1 or vessel.contents[0].label != self.plan.label:
            self.work.name(vessel, self.plan.label)
        if row.group in word_list("is served in what it is baked in") and self._has_no_portions():
            return vessel
        target = self.bench.vessel("bowl" if self.carry.is_wet(vessel.contents[0]) else "plate")
        try:
            self.carry.transfer(vessel, target, self.line.stages[-1])
        except RefusedError:  # nobody of this FOON serves such a dish
            return vessel
        return target
