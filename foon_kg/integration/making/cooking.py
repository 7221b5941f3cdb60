"""Making a dish after a frame: foods are prepared, brought together stage by stage, and heated block by block.

The phases are always the same: everything is cut and opened first; what has to be cooked by itself is cooked; then the
lines of the frame are carried out, each heat block uninterrupted; at the end everything is off.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, is_heated
from foon_kg.integration.composing.toppings import with_toppings_last
from foon_kg.integration.joining.course import Course, Plan
from foon_kg.integration.joining.phases import in_phases
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.adding import Adding
from foon_kg.integration.making.alone import Alone
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.making.dipping import Dipping
from foon_kg.integration.making.doing import Doing
from foon_kg.integration.making.lifting import Lifting
from foon_kg.integration.making.placing import Placing
from foon_kg.integration.making.precooking import Precooking
from foon_kg.integration.making.readying import Readying
from foon_kg.integration.making.serving import Serving
from foon_kg.integration.making.stacking import Stacking
from foon_kg.integration.making.stages import Stages
from foon_kg.integration.making.steaming import Steaming
from foon_kg.integration.making.turns import Incoming, Turn, turns_of
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready
from foon_kg.integration.preparing.preparer import Preparer
from foon_kg.integration.teaching.frames import LiftedOut, Line, Stage, Steamed


class Cooking:
    """One dish in the making on a bench."""

    def __init__(self, bench: Bench, line: Line, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        line, plan = with_toppings_last(line, plan, self.known)  # what only lies on a dish is in none of its phases
        line, plan = in_phases(line, plan, self.known)
        self.line, self.plan = line, plan
        self.ready: dict[int, Ready] = {}
        self.boiled_late: dict[int, Sequence[str]] = {}  # how it is cooked when the sauce is ready
        self.base_late: dict[int, Sequence[str]] = {}  # how a base is done when what lies on it is ready
        self.course = Course(line, plan)
        preparer = Preparer(bench)
        self.carry = Carrier(bench, preparer)
        self.precooking = Precooking(bench, self.course, preparer)
        self.work = Worker(bench, plan)
        self.alone = Alone(self.precooking, self.carry, self.work, self.ready)
        self.readying = Readying(self.alone)
        self.serving = Serving(bench, plan, self.carry, self.work, self.ready)
        self.stacking = Stacking(bench, plan, self.carry, self.work, self.ready)
        self.dipping = Dipping(bench, plan, self.carry, self.work, self.ready)
        self.stages = Stages(self.course, plan, self.known)
        self.placing = Placing(bench, self.stages, self.carry, self.work, self.ready)
        self.adding = Adding(self.alone, self.placing)
        self.doing = Doing(self.placing)
        self.steaming = Steaming(self.doing)
        self.lifting = Lifting(self.work)
        self.made: dict[int, Vessel] = {}
        """In what each line was made, by its identity."""

    # --- the whole ---

    def make(self) -> Stuff:
        """Make the dish and return it; raises :class:`RefusedError` where a step cannot be done."""
        flesh = word_list("is flesh")
        for join in sorted(self.course.in_order(), key=lambda one: one.want.facts.is_any(flesh)):
            self.readying.prepare(join)  # raw meat last: nothing else comes under its knife
        self.bench.phase = "heat"
        for join in self.course.in_order():
            self._cook_first(join)
        vessel = self._run(self.line, main=True)
        if vessel is None:
            raise RefusedError("nothing of what was asked joins this dish")
        self.bench.phase = "finish"
        vessel = self.serving.served(vessel, self.line.stages[-1], self.stages)
        if len(vessel.contents) > 1 or vessel.contents[0].label != self.plan.label:
            self.work.name(vessel, self.plan.label)
        self.bench.put_in_time()
        return vessel.contents[0]

    def _cook_first(self, join: Join) -> None:
        """Cook a food by itself that needs it, or leave that until what it is for is ready."""
        method = self.precooking.method(join)
        if not method:
            return
        facts, number = join.want.facts, join.want.number
        if self.plan.stacked and facts.is_any(word_list("carries what is stacked")):
            self.base_late[number] = method
        elif self._waits_for_the_rest(join):
            self.boiled_late[number] = method
        else:
            self.alone.cook_first(join, method)
            self._rinse_what_waits(join.spot.stage, [join])

    def _rinse_what_waits(self, stage: Stage, joins: Sequence[Join]) -> None:
        """Rinse what was boiled and drained for a stage, where it waits until other foods are fried."""
        if len(joins) == 1 and self.stages.is_fried_once_boiled(stage, joins):
            ready = self.ready[joins[0].want.number]
            if not ready.stuff.mixed and is_heated(ready.stuff.states, self.known):
                self.alone.preparer.rinse(ready, "washed")

    def _waits_for_the_rest(self, join: Join) -> bool:
        """Whether a food is boiled by itself when its sauce is ready, or what it is served beside.

        Grain waits for what is only fried, which is done in a moment and good then only, unless that stands before;
        a stew waits for it.
        """
        stage, facts = join.spot.stage, join.want.facts
        if facts.is_any(word_list("is boiled by itself")):
            return self.stages.is_boiled_late(join)
        beside = facts.is_any(word_list("is boiled when the rest is ready"))
        stands = any("wait" in one.does for one in self.line.all_stages())
        if facts.is_any(word_list("is boiled before the rest is fried")) and not stands:
            return beside and not self.course.was_only_fried_before(stage) and self.stages.is_served_beside(stage)
        return beside and self.stages.is_served_beside(stage)

    # --- lines ---

    def _run(self, line: Line, *, main: bool = False, after: Sequence[Stage] = ()) -> Vessel | None:
        """Carry out a line, after which the stages in ``after`` come, and return in what its whole is; if anything is.

        What joins it is made first, but for what is made late.
        """
        turns, late = turns_of(line, after, main=main), self.stages.made_late(line)
        for add, turn in self._at_once(line, turns, late):
            self._run_all([add], turn)
        vessel: Vessel | None = None
        oven = self.placing.oven_of(line)
        for place, turn in enumerate(turns):
            if oven and self.placing.is_lit_first(oven, line.stages[place:]):
                self.bench.switch(None, self.bench.device(oven), on=True)  # it is hot when the dish comes in
                oven = ""
            self._make_late(turn, vessel, late)
            vessel = self._by_itself(turn, vessel) or self._stage(turn, vessel)
        if vessel is not None:
            self.bench.heat_off(vessel)
        return vessel

    def _at_once(self, line: Line, turns: Sequence[Turn], late: Collection[int]) -> list[tuple[Line, Turn]]:
        """Return what joins a line in ``turns`` and is not made ``late``, each with its turn: first what keeps."""
        first = self.stages.made_before_rest(line)
        lines = [(add, turn) for turn in turns for add in self._alive(turn.stage) if id(add) not in late]
        return sorted(lines, key=lambda one: id(one[0]) not in first)

    def _by_itself(self, turn: Turn, vessel: Vessel | None) -> Vessel | None:
        """Return in what the whole is after a turn in which it is parted, or closed with bread; ``None`` at others."""
        return self._parted(turn.stage, vessel) or self.stacking.closed(turn.stage, vessel, main=turn.main)

    def _parted(self, stage: Stage, vessel: Vessel | None) -> Vessel | None:
        """Return in what flesh is that is lifted out, or what runs through a strainer; ``None`` at any other stage."""
        if vessel is not None and stage.motion in word_list("strains"):
            return self.work.taking_out.strained(vessel)
        if vessel is not None and isinstance(stage, LiftedOut):
            return self.lifting.lifted(stage, vessel)
        return None

    def _alive(self, stage: Stage) -> list[Line]:
        """Return the lines that join at a stage and that something asked joins."""
        return [line for line in stage.lines if self.course.alive(line)]

    def _run_all(self, lines: Iterable[Line], turn: Turn) -> None:
        """Carry out lines that join at a stage, and note in what each of them is made."""
        for line in lines:
            self._empty_for(line)
            vessel = self._run(line, after=(turn.stage, *turn.later))
            if vessel is not None:
                self.made[id(line)] = vessel
            if self.stages.is_drained(line):
                self._rinse_what_waits(turn.stage, self.course.joins_of(line.stages))

    def _empty_for(self, line: Line) -> None:
        """Bring what waits in a vessel that a kitchen has once (a blender jar) into a bowl, if ``line`` needs that."""
        needed = _vessels_of(line)
        for vessel in list(self.made.values()):
            row = self.known.utensil(vessel.label)
            if vessel.contents and row is not None and not row.many and vessel.label in needed:
                bowl = self.bench.vessel("bowl")
                self.carry.transfer(vessel, bowl, line.stages[-1])
                # a line is made in the vessel of the first one that joined it: both are in the bowl now
                self.made = {made: bowl if one is vessel else one for made, one in self.made.items()}

    def _make_late(self, turn: Turn, vessel: Vessel | None, late: Collection[int]) -> None:
        """Make what waited until now, and boil what waited for its sauce; meanwhile that is off the heat."""
        lines = [line for line in self._alive(turn.stage) if id(line) in late and id(line) not in self.made]
        joins = [join for join in self._joins_until_heat(turn) if join.want.number in self.boiled_late]
        if vessel is not None and (lines or joins):
            self.bench.heat_off(vessel)
        self._run_all(lines, turn)
        for join in joins:
            self.alone.cook_first(join, self.boiled_late.pop(join.want.number))

    def _joins_until_heat(self, turn: Turn) -> list[Join]:
        """Return what joins a stage, and where that does not heat, what joins until one does."""
        cold = itertools.takewhile(lambda one: not one.heats, (turn.stage, *turn.later))
        return [join for one in ([turn.stage] if turn.heats else cold) for join in self.course.ordered(one)]

    def _cook_base_now(self, joins: Sequence[Join], ready: Sequence[Vessel | None]) -> None:
        """Cook the base that waited until what is laid on it is ready; that is off the heat meanwhile. Beat foams."""
        late = [join for join in joins if join.want.number in self.base_late]
        for vessel in filter(None, ready if late else ()):
            self.bench.heat_off(vessel)
        for join in late:
            self.alone.cook_first(join, self.base_late.pop(join.want.number))
        for join in joins:
            if join.want.foamed:
                self.alone.beat_to_foam(self.ready[join.want.number])

    # --- stages ---

    def _stage(self, turn: Turn, vessel: Vessel | None) -> Vessel | None:
        """Carry out a stage with what is in ``vessel``, and return in what it is then."""
        stage = turn.stage
        joins = self.serving.in_layers(self.course.ordered(stage))
        beside = self._made_for(stage)
        incoming = Incoming(joins, [*(one for _, one in beside), *self.lifting.returned(stage)])
        if vessel is None and not incoming:
            return None
        # a dish on bread is put together at once, whatever its video laid on later
        stacked = turn.main and self.plan.stacked and self.stacking.is_put_together(stage, joins, turn.later)
        if stacked:
            self._take_all(turn.later, incoming)
        self._cook_base_now(incoming.joins, [*incoming.lines, vessel])
        if stacked:
            return self.stacking.stack(stage, vessel, incoming)
        self.alone.cooling.before(stage, vessel, beside, turn.later)
        if self.dipping.is_for(stage, vessel, incoming):
            return self.dipping.done(stage, vessel, incoming)
        if isinstance(stage, Steamed):
            return self.steaming.done(turn, stage, vessel, incoming)
        return self._brought_and_done(turn, vessel, incoming)

    def _made_for(self, stage: Stage) -> list[tuple[Line, Vessel]]:
        """Return the lines that join at a stage with that in which they were made, of those that were."""
        return [(line, self.made[id(line)]) for line in stage.lines if id(line) in self.made]

    def _take_all(self, later: Sequence[Stage], incoming: Incoming) -> None:
        """Have all that joins later come now."""
        for one in later:
            incoming.joins += self.course.taken(one)
            incoming.lines += [self.made.pop(id(add)) for add in one.lines if id(add) in self.made]

    def _brought_and_done(self, turn: Turn, vessel: Vessel | None, incoming: Incoming) -> Vessel | None:
        """Bring what joins a stage to what is in ``vessel``, do what it does, and return in what that is then."""
        stage = turn.stage
        if vessel is not None and turn.main and not incoming and self.stages.stays_there(stage, vessel, turn.later):
            return vessel
        dressed = self._is_dressed(turn, vessel, incoming)
        vessel = self.placing.placed(turn, vessel, incoming, dressed=dressed)
        self.stacking.lay_open(turn, vessel, incoming)
        tops = incoming.take(self.serving.lies_on_top) if dressed else []
        self.adding.add_all(replace(turn, main=self._may_end(turn, dressed=dressed)), vessel, incoming)
        if not vessel.contents:
            return None
        if dressed:
            self.serving.dress(vessel, tops)
        portions = self.serving.portions(stage, vessel)
        if portions:
            return self.serving.shaped(stage, vessel, portions)
        self.doing.do(turn, vessel)
        return self.doing.take_out(turn, vessel)

    def _may_end(self, turn: Turn, *, dressed: bool) -> bool:
        """Whether what joins in a turn may make the whole one: it is the dish, is not ``dressed`` and not left open."""
        return turn.main and not dressed and not self.stacking.open

    def _is_dressed(self, turn: Turn, vessel: Vessel | None, incoming: Incoming) -> bool:
        """Whether what joins a stage dresses a dish that is done; one food alone has nothing to be mixed with."""
        alone = vessel is None and not incoming.lines and len(incoming.joins) == 1
        return turn.main and not alone and self.serving.is_dressed(turn.stage, vessel, incoming.joins, turn.later)


def _vessels_of(line: Line) -> set[str]:
    """Return what the vessels of a line are called, and those of the lines that join it."""
    own = {stage.vessel for stage in line.stages}
    return own.union(*(_vessels_of(add) for stage in line.stages for add in stage.lines))
