"""Making a dish after a frame: foods are prepared, brought together stage by stage, and heated block by block.

The phases are always the same (design, section 8): everything is cut and opened first; what has to be cooked by itself
is cooked; then the lines of the frame are carried out, each heat block uninterrupted; at the end everything is off.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel
from foon_kg.integration.composing.crowned import crowned
from foon_kg.integration.joining.course import COATS, HEATS, MIXES, WORKS, Course, Plan
from foon_kg.integration.joining.phases import in_phases
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.alone import Alone
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.making.dipping import Dipping
from foon_kg.integration.making.outcome import says_raw
from foon_kg.integration.making.placing import Placing
from foon_kg.integration.making.precooking import Precooking
from foon_kg.integration.making.serving import Serving
from foon_kg.integration.making.smoothing import Smoothing
from foon_kg.integration.making.stages import Stages
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.preparing.preparer import Preparer
from foon_kg.integration.teaching.frames import BATH, Asked, Line, Phase, Stage
from foon_kg.integration.teaching.operators import Attested, form_of

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
        self.precooking = Precooking(bench, self.course, self.preparer)
        self.alone = Alone(self.precooking, self.carry, self.ready)
        self.work = Worker(bench, plan)
        self.serving = Serving(bench, plan, self.carry, self.work, self.ready)
        self.dipping = Dipping(bench, self.carry, self.work, self.ready)
        self.smoothing = Smoothing(bench, plan, self.carry, self.work, self.ready)
        self.stages = Stages(self.course, plan, self.known)
        self.placing = Placing(bench, self.stages, self.carry, self.work, self.ready)

    # --- the whole ---

    def make(self) -> Stuff:
        """Make the dish and return it; raises :class:`RefusedError` where a step cannot be done."""
        flesh = word_list("is flesh")
        for join in sorted(self.course.in_order(), key=lambda one: one.want.facts.is_a(*flesh)):
            self._prepare(join)  # raw meat last: nothing else comes under its knife
        self.bench.phase = "heat"
        for join in self.course.in_order():
            method = self.precooking.method(join)
            if method and self.plan.stacked and join.want.facts.is_a(*word_list("carries what is stacked")):
                self.base_late[join.want.number] = method
            elif method and self.stages.is_boiled_late(join.spot.stage) and join.want.facts.is_a(*_BY_ITSELF):
                self.boiled_late[join.want.number] = method
            elif method:
                self.alone.cook_first(join, method)
        vessel = self._run(self.line, main=True)
        if vessel is None:
            raise RefusedError("nothing of what was asked joins this dish")
        self.bench.phase = "finish"
        vessel = self.serving.served(vessel, self.line.stages[-1], self.stages)
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
        form = self._form(join)
        want = self._as_eaten(join, blended=blended)
        self.bench.phase = "prepare"
        first = self.precooking.method(join)
        whole = first and not self.precooking.is_fried_open(want)
        if whole and "shell" in want.facts.owes and form_of(self.known, want.label, want.leaf) != "liquid":
            taken = self.bench.fetch(want.label, want.leaf, [want.number], want.storage)
            self.ready[want.number] = self._cut_once_done(Ready(want, taken, whole_shell=True, cut_later=want.then))
            return
        ready = self.preparer.prepare(want, form, divided=not blended, alone=bool(first))
        if first:
            ready = self._cut_once_done(ready)
        elif self.plan.by_bites and not blended:
            self.preparer.cut_to_bites(ready)
        self.ready[want.number] = ready
        self.alone.beaten_first(join, ready)
        if want.facts.is_a(*word_list("is the water of a pot")):
            self.carry.water.kept.append(ready)
        elif want.facts.is_a("water") and self.course.is_hot(stage):
            self.alone.measure(ready)

    def _form(self, join: Join) -> tuple[str, ...]:
        """Return in which states a food joins as far as nobody asked: as the slot has it, or as such a dish needs."""
        facts, stage = join.want.facts, join.spot.stage
        pulled = any(one.motion in word_list("pulls flesh apart") for one in join.spot.after)
        bites = self.plan.by_bites and not self.plan.in_pieces  # that is cut when it is cooked
        small = (bites or (isinstance(stage, Phase) and stage.small)) and not pulled
        needs = [
            ("halved", self.plan.stacked, "is split"),
            ("sliced", self.plan.stacked, "is sliced to be stacked"),
            ("chopped", small, "is cut for a dish"),
            ("shaved", self._is_mixed(join), "is cut off its cob"),
            ("crumbled", self.plan.in_pieces, "is crumbled"),
        ]
        form = join.slot.states if join.slot is not None else ()
        return (*form, *(state for state, needed, kinds in needs if needed and facts.is_a(*word_list(kinds))))

    def _is_mixed(self, join: Join) -> bool:
        """Whether more than seasoning joins at the same stage, or before it, so that nobody eats a food by itself."""
        others = (one.want.facts for one in self.plan.joins if one is not join)
        return any(not facts.is_a(*word_list("is eaten on a cob")) for facts in others)

    def _as_eaten(self, join: Join, *, blended: bool) -> Want:
        """Return a want that nobody asked cut, cut or mashed where it is never eaten, shaped or ``blended`` whole."""
        want = self._as_soft_as_needed(join)
        if any((self.known.state(state).fine or 0) > 0 for state in (want.make, *want.leaf) if state):
            return want
        if blended and want.facts.is_a(*word_list("is cut to be blended")):
            return replace(want, make=min(word_list("is cut so to be blended")))
        if self._is_shaped_later(join) and want.facts.is_a(*word_list("is mashed to be shaped")):
            return replace(want, make="mashed")
        if self._is_eaten_raw(join) and want.facts.is_a(*word_list("is never eaten whole")):
            return replace(want, make=min(word_list("is cut so to be eaten raw")))
        return want

    def _as_soft_as_needed(self, join: Join) -> Want:
        """Return a want that lay out of the refrigerator where it is beaten, or stirred with what is sweet."""
        want, stage = join.want, join.spot.stage
        if want.make or not want.facts.is_a(*word_list("is soft when it is beaten")):
            return want
        beside = [one.want.facts for one in self.course.ordered(stage)]
        creamed = any(facts.is_a("sweet") for facts in beside) and not any(facts.is_a("flour") for facts in beside)
        beaten = not stage.does.isdisjoint({"blend", "whip"}) or (creamed and "mix" in stage.does)
        hard = set(want.leaf) <= word_list("is hard in the refrigerator")
        if not hard or not beaten or not stage.does.isdisjoint(HEATS):
            return want
        return replace(want, leaf=tuple(word_list("is soft so")))

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
        thick = thick or (self.plan.by_bites and ready.want.facts.is_a(*word_list("is cut for a dish")))
        flat = self.plan.stacked and ready.want.facts.is_a(*word_list("is fried rather than boiled"))
        pieces = pieces or (self.plan.stacked and ready.want.facts.is_a(*word_list("is cut to be stacked")))
        if pieces or thick or (self.precooking.is_asked_done(ready.want) and not flat):
            self.preparer.cut_once_done(ready)
        return ready

    # --- lines ---

    def _run(self, line: Line, *, main: bool = False, after: Sequence[Stage] = ()) -> Vessel | None:
        subs: dict[int, Vessel] = {}
        late = self.stages.made_late(line)
        for place, stage in enumerate(line.stages):
            later = (*line.stages[place + 1 :], *after)
            for add in stage.adds:
                if isinstance(add, Line) and self.course.alive(add) and id(add) not in late:
                    made = self._run(add, after=(stage, *later))
                    if made is not None:
                        subs[id(add)] = made
        vessel: Vessel | None = None
        oven = next(
            (
                label
                for stage in line.stages
                for label, relation in [self.placing.utensils.device_for(stage)]
                if relation == "in" and "heat" in stage.does
            ),
            "",
        )
        for place, stage in enumerate(line.stages):
            later = (*line.stages[place + 1 :], *after)
            if oven and self.placing.is_lit_first(oven, line.stages[place:]):
                self.bench.switch(None, self.bench.device(oven), on=True)  # it is hot when the dish comes in
                oven = ""
            self._boil_now(stage, vessel, subs, later, late)
            if vessel is not None and stage.motion in word_list("strains"):
                vessel = self.work.taking_out.strained(vessel)
            else:
                vessel = self._stage(stage, vessel, subs, later, main=main)
        if vessel is not None:
            self.bench.heat_off(vessel)
        return vessel

    def _boil_now(
        self,
        stage: Stage,
        vessel: Vessel | None,
        subs: dict[int, Vessel],
        later: Sequence[Stage],
        late: Collection[int],
    ) -> None:
        """Make what waited until now, and boil what waited for its sauce; meanwhile that is off the heat."""
        beside = [add for add in stage.adds if isinstance(add, Line) and id(add) in late]
        lines = [line for line in beside if id(line) not in subs and self.course.alive(line)]
        here = itertools.takewhile(lambda one: one is stage or one.does.isdisjoint(HEATS), (stage, *later))
        there = here if stage.does.isdisjoint(HEATS) else [stage]
        joins = [j for one in there for j in self.course.ordered(one) if j.want.number in self.boiled_late]
        if vessel is not None and (lines or joins):
            self.bench.heat_off(vessel)
        for line in lines:
            made = self._run(line, after=(stage, *later))
            if made is not None:
                subs[id(line)] = made
        for join in joins:
            self.alone.cook_first(join, self.boiled_late.pop(join.want.number))

    def _cook_base_now(self, joins: Sequence[Join], ready: Sequence[Vessel | None]) -> None:
        """Cook the base that waited until what is laid on it is ready; that is off the heat meanwhile. Beat foams."""
        late = [join for join in joins if join.want.number in self.base_late]
        for vessel in ready if late else ():
            if vessel is not None:
                self.bench.heat_off(vessel)
        for join in late:
            self.alone.cook_first(join, self.base_late.pop(join.want.number))
        for join in joins:
            if join.want.foamed:
                self.alone.beat_to_foam(self.ready[join.want.number])

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
        beside = [(add, subs[id(add)]) for add in stage.adds if isinstance(add, Line) and id(add) in subs]
        self.alone.cooling.before(stage, vessel, beside, later)
        if self.dipping.is_for(stage, vessel, joins, lines):
            return self.dipping.done(stage, vessel, joins, lines)
        return self._brought_and_done(stage, vessel, joins, lines, later, main=main)

    def _brought_and_done(
        self, stage: Stage, vessel: Vessel | None, joins: list[Join], lines: list[Vessel], later: Sequence[Stage], *,
        main: bool,
    ) -> Vessel | None:  # fmt: skip
        """Bring what joins a stage to what is in ``vessel``, do what it does, and return in what that is then."""
        if main and vessel is not None and not joins and not lines and self.stages.stays_there(stage, vessel, later):
            return vessel
        device, relation = self.placing.utensils.device_for(stage)
        alone = vessel is None and not lines and len(joins) == 1  # there is nothing to mix it with
        dressed = main and not alone and self.serving.is_dressed(stage, vessel, joins, later)
        label = self.placing.label_for(stage, vessel, lines, joins, dressed=dressed)
        vessel = self.placing.vessel_for(stage, label, vessel, lines, joins)
        heats = bool(device) and (not stage.does.isdisjoint(HEATS) or stage.source == "heat")
        if (
            vessel.device is not None
            and (not heats or vessel.device.label != device)
            and not self.stages.heats_on(stage, later, vessel)
        ):
            self.bench.heat_off(vessel)
        if heats and relation == "on":
            self.placing.put_on(vessel, device, stage)
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
        portions = self.serving.portions(stage, vessel)
        if portions:
            return self.serving.shaped(stage, vessel, portions)
        self._do(stage, vessel, device, relation, later, main=main)
        return self._take_out(stage, vessel, later, main=main)

    def _take_out(self, stage: Stage, vessel: Vessel, later: Sequence[Stage], *, main: bool) -> Vessel:
        """Take out of a pot what only gave its taste, before that is poured, served or blended; return its vessel."""
        hot = not stage.does.isdisjoint(HEATS) and vessel.relation == "on"
        if not hot or any(not one.does.isdisjoint(HEATS) for one in later):
            return vessel
        inside = {number for stuff in vessel.contents for number in stuff.wants}
        if any(self.work.taking_out.is_taken_out(join.want) for join in self.plan.joins if join.want.number in inside):
            self.bench.heat_off(vessel)
            if len(vessel.contents) > 1:
                self.work.name(vessel, self.plan.label if main else self.work.outcome.label(stage, vessel) or _MIXTURE)
            return self.work.taking_out.take_out(vessel)
        return vessel

    def _add_all(
        self, stage: Stage, vessel: Vessel, joins: Sequence[Join], lines: Sequence[Vessel], *,
        heats: bool, relation: str, later: Sequence[Stage], main: bool,
    ) -> None:  # fmt: skip
        on_stove = heats and vessel.device is not None and relation == "on"
        stuffs = self.placing.comers(stage, joins, lines, heats=heats)
        watered = any(self.known.foods.food(stuff.label).is_a("water") for stuff in vessel.contents if not stuff.mixed)
        if self.stages.water(stage) and not watered:
            self.carry.water.add(vessel)
        fat_first = any(isinstance(one, Join) and one.want.facts.is_a("fat") for one in stuffs)
        hot_first = fat_first
        if on_stove and not vessel.contents and not fat_first and self.stages.would_be_dry(stage, stuffs):
            hot_first = self.carry.add_fat(vessel, self.plan) or "heat" in stage.does
        for number, one in enumerate(stuffs):
            last = number == len(stuffs) - 1
            ends = self.stages.merges(stage, later, main=main)
            merge = ends and last
            fat = isinstance(one, Join) and one.want.facts.is_a("fat")
            if on_stove and hot_first and not fat:
                self.placing.heat_on(vessel)  # what fries comes into a hot pan
                self.work.heat_fat(vessel)
            on_top = isinstance(one, Join) and one.on_top
            came = [self.ready[one.want.number].stuff] if isinstance(one, Join) else list(one.contents)
            self._add(stage, vessel, one, on_stove=on_stove)
            done = main and not on_top and not self.stages.is_worked_later([stage, *later])
            if done and len(came) == 1 and self.work.lies_on_what_is_done(came[0], vessel):
                self.work.toss(vessel)
                continue
            if merge and self.work.lies_unmixed(vessel) and not on_top and not self.stages.lays(stage, joins, later):
                self.work.stir(vessel, self.plan.label, self.work.outcome.kept_states(vessel))
            elif merge and (main or len(vessel.contents) > 1):
                self.work.name(vessel, self.plan.label if main else self.work.outcome.label(stage, vessel))

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
        if on_stove and one.want.facts.is_a(*word_list("comes when it boils")):
            self.carry.water.boil(vessel)
        self.alone.boil_water_first(one)
        smooth = self.smoothing.made(one, vessel)
        if smooth is not None:
            self.carry.transfer(smooth, vessel, stage)
            return
        self.carry.bring(self.ready[one.want.number], vessel, one.slot)

    # --- heat and work ---

    def _do(
        self, stage: Stage, vessel: Vessel, device: str, relation: str, later: Sequence[Stage], *, main: bool
    ) -> None:
        idle = not isinstance(stage, Asked) and self.stages.is_idle(stage, vessel, later)
        if not stage.motion or stage.does.isdisjoint(WORKS) or idle:
            return
        if device and not relation:
            self._by_hand_device(stage, vessel, device, later, main=main)
            return
        if device and (vessel.device is None or vessel.device.label != device):
            if "dry" in stage.does:
                self.work.rising.let_rise_again(vessel)
            self.placing.into_device(vessel, device, relation)
        if vessel.device is not None and not self.bench.is_running(vessel) and vessel.device.label == device:
            self.placing.heat_on(vessel)
        if "turn" in stage.does:
            self.work.cook_first_side(vessel)
        attested = self.work.ways.way(stage, vessel)
        if attested is None:
            return
        self._work(stage, vessel, attested, later, with_device=bool(device), main=main)
        if vessel.device is not None and vessel.relation != "on" and not self.stages.stays_in(vessel, later):
            self.bench.heat_off(vessel)

    def _work(
        self, stage: Stage, vessel: Vessel, attested: Attested, later: Sequence[Stage], *, with_device: bool, main: bool
    ) -> None:
        mixes = not stage.does.isdisjoint(MIXES)
        heats = not stage.does.isdisjoint(HEATS)
        # what is only browned at last, by no video's step, is done before
        finished = not any(not one.does.isdisjoint(HEATS) for one in later if one.step >= 0)
        label = self.work.outcome.label(stage, vessel, last=main and not self.stages.is_worked_later(later), main=main)
        label = label or (self.work.outcome.coated(vessel) if stage.does >= COATS else "")
        fried = self.stages.taken_up(stage, vessel) if heats and finished and not label else None
        label = label if fried is None else fried.label
        product = (bool(label) or (mixes and not heats)) and not self.stages.is_drained_next(vessel, later)
        states = self.work.outcome.states(stage, vessel, attested.way, product=product, finished=finished)
        if fried is not None:
            states = tuple(sorted({*states, *(s for s in fried.states if not says_raw(s, self.known))}))
        if product and [(stuff.label, stuff.states) for stuff in vessel.contents] == [(label or "mixture", states)]:
            return
        if product:
            self.bench.work(vessel, attested, label or "mixture", states, with_device=with_device)
            if mixes and not heats and not any(one.does & MIXES and self.course.stage_alive(one) for one in later):
                self.work.rising.let_rise(vessel, [stage, *later])
        else:
            self.work.work_each(vessel, attested, states, with_device=with_device)

    def _by_hand_device(self, stage: Stage, vessel: Vessel, device: str, later: Sequence[Stage], *, main: bool) -> None:
        """Work with an appliance that is held in the hand."""
        attested = self.work.ways.way(stage, vessel)
        if attested is None:
            return
        machine = self.bench.device(device)
        self.bench.switch(None, machine, on=True)
        label = self.work.outcome.label(stage, vessel, last=main and not self.stages.is_worked_later(later), main=main)
        states = self.work.outcome.states(stage, vessel, attested.way, product=True, finished=False)
        self.bench.work(vessel, attested, label or "mixture", states, extra=machine)
        self.bench.switch(None, machine, on=False)
