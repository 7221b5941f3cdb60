"""What a stage of a dish would change on the bench, what joins it, and what comes after it.

Nothing is done here: :mod:`~foon_kg.integration.making.cooking` asks, and does.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from foon_kg.food import Food, Tables
from foon_kg.food.lists import says, word_list
from foon_kg.food.parted import PART
from foon_kg.food.rows import MINCED
from foon_kg.integration.bench import Stuff, Vessel, foods_of, is_baked, is_flat, is_heated
from foon_kg.integration.composing.coated import is_portion
from foon_kg.integration.composing.swelling import are_only_boiled
from foon_kg.integration.joining.course import MIXES, WORKS, Course, Plan
from foon_kg.integration.joining.spots import Join, any_is, only_carries
from foon_kg.integration.making.consistency import is_loose_in_liquid
from foon_kg.integration.making.turns import Turn, after_the_oven, is_over_heat, laid_later, waiting
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import BATH, HEATS, THINNED, Line, Phase, Slot, Stage

_LONG = 2
"""What was heated so often in a pan takes longer than pasta does."""


class Stages:
    """Tells what stages of one dish are for: ``course`` is what joins where, ``plan`` what is to be made."""

    def __init__(self, course: Course, plan: Plan, known: Tables) -> None:
        self.course = course
        self.plan = plan
        self.known = known

    def waits_for_sauce(self, stage: Stage) -> bool:
        """Return whether what ``stage`` boils and drains joins a sauce that cooks before.

        It is boiled when that is ready.
        """
        return isinstance(stage, Phase) and stage.bath and not self.plan.one_pot

    def is_boiled_late(self, join: Join) -> bool:
        """Return whether the food of ``join`` is boiled by itself only when what it joins is ready: a sauce, a soup."""
        stage = join.spot.stage
        after = not self.plan.stacked and self.course.follows_heat(stage)
        waits = self.waits_for_sauce(stage) or self._waits_for_pan(stage, [join])
        return waits or (after and (self.plan.one_pot or not stage.heats))

    def is_fried_once_boiled(self, stage: Stage, joins: Sequence[Join]) -> bool:
        """Return whether of ``joins``, boiled and drained for ``stage``, something waits for what is fried before."""
        clumps = any_is(joins, *word_list("is rinsed before it is fried"))
        return clumps and _is_dry_phase(stage) and self.course.is_hot(stage)

    def _waits_for_pan(self, stage: Stage, joins: Sequence[Join]) -> bool:
        """Whether what is boiled and drained is so only when the sauce in a pan is ready, which takes longer."""
        if self.plan.stacked or not _is_dry_phase(stage) or self._is_asked(*word_list("is rinsed before it is fried")):
            return False
        pan = self.course.heated_before(stage)
        quick = any_is(self.course.joins_of(pan), *word_list("is done in a moment"))
        return len(pan) >= _LONG and not quick and are_only_boiled(joins)

    def is_served_beside(self, stage: Stage) -> bool:
        """Return whether what joins at ``stage`` comes hot beside what was cooked before, and is cooked no more."""
        hot = not (self.plan.stacked or self.plan.cold or self.plan.cooled or self.plan.in_pieces)
        return hot and not stage.heats and self.course.follows_heat(stage)

    def made_late(self, line: Line) -> frozenset[int]:
        """Return, by identity, what joins a line and is made just before: what waits for a sauce, and a foam.

        So is what is cooked to be laid on the rest, where that comes out of a hot pan of its own, and is lifted out,
        and whatever comes on what was baked at last.
        """
        late = [add for stage in after_the_oven(line.stages) for add in stage.lines]
        late += [add for stage in line.stages for add in stage.lines if self._waits(stage, add)]
        late += [add for add in laid_later(line.stages) if is_over_heat(add) and add not in waiting(line, self.course)]
        return frozenset(map(id, late))

    def made_before_rest(self, line: Line) -> frozenset[int]:
        """Return, by identity, what joins a line and is made before the rest: what keeps, for what is best hot."""
        return frozenset(id(add) for add in waiting(line, self.course) if not self._makes_foam(add))

    def _waits(self, stage: Stage, line: Line) -> bool:
        waits = self.waits_for_sauce(stage) or self._waits_for_pan(stage, self.course.joins_of(line.stages))
        return (waits and self.is_drained(line)) or self._makes_foam(line)

    def _makes_foam(self, line: Line) -> bool:
        """Whether a line beats egg whites or cream to a foam, which falls if it is made too early."""
        joins = self.course.joins_of(line.stages)
        foams = any(join.want.part == PART or join.want.foamed for join in joins)
        return foams and any("whip" in stage.does for stage in line.stages)

    def is_drained(self, line: Line) -> bool:
        """Return whether a line ends in a strainer."""
        row = self.known.utensil(line.stages[-1].vessel) if line.stages[-1].vessel else None
        return row is not None and "strain" in row.can

    @cached_property
    def on_plate(self) -> bool:
        """Whether the dish lies on a plate, however much runs out of it: what is carved, and portions of flesh."""
        if self.plan.label in word_list("is served on a plate"):
            return True
        flesh = [join.want for join in self.plan.joins if join.want.facts.is_any(word_list("is coated"))]
        in_one = any(is_portion(want, self.known) or want.asked == "whole" for want in flesh)
        return in_one and not (self.plan.one_pot or self.plan.spooned)

    def lies_baked(self, vessel: Vessel | None) -> bool:
        """Return whether the dish in ``vessel`` comes out of the oven in one piece, however wet what lies on it is."""
        whole = self.plan.laid or self.on_plate
        return whole and vessel is not None and any(map(is_baked, vessel.contents))

    def _goes_on(self, stage: Stage, following: Stage) -> bool:
        """Whether the next stage only goes on with what this one does, so that once is enough (contract C3, W4).

        A video that stirs, adds a food that is not asked, and stirs again, would have the plan stir twice.
        """
        if (
            self.course.stage_alive(following)
            or self.water(following)
            or stage.vessel != following.vessel
            or stage.appliance != following.appliance
        ):
            return False
        kinds = (frozenset({"heat"}), MIXES)
        mine = next((kind for kind in kinds if stage.does & kind), None)
        return mine is not None and bool(following.does & mine) and not stage.does & {"dry", "shape", "knead", "blend"}

    def heats_on(self, stage: Stage, later: Sequence[Stage], vessel: Vessel) -> bool:
        """Return whether ``vessel`` stays over the heat after ``stage``: it is heated next on what it stands on.

        ``later`` are the stages that come then.
        """
        if vessel.device is None or vessel.relation == "in":
            return False
        if stage.vessel not in {vessel.label, ""} or "cut" in stage.does:
            return False
        for one in later:
            if one.source == "heat" and one.heats:
                return one.appliance == vessel.device.label and one.vessel in {vessel.label, ""}
            if one.vessel not in {vessel.label, ""}:
                return False
        return False

    def lays(self, stage: Stage, joins: Sequence[Join], later: Sequence[Stage]) -> bool:
        """Return whether ``stage`` lays ``joins`` in layers: by a technique, to be chilled, or as the recorded dish.

        ``later`` are the stages that come then.
        """
        if self.plan.by_table and not stage.motion:
            return any("wait" in one.does for one in later)
        laid = bool(joins) and all(join.slot is not None and join.slot in stage.adds for join in joins)
        return laid and "wait" in stage.does and not (self.plan.in_pieces or self.plan.in_glass)

    def would_be_dry(self, stage: Stage, stuffs: Sequence[Join | Vessel]) -> bool:
        """Return whether ``stuffs`` that are solid come at ``stage`` into a pan with nothing to cook in."""
        if "dry" in stage.does:
            return False
        wants = [one.want for one in stuffs if isinstance(one, Join)]
        wet = any(want.squeezed or want.facts.is_any(word_list("wets the pan")) for want in wants)
        solid = any(not want.facts.is_any(word_list("only flavours")) for want in wants)
        return solid and not wet and not any(isinstance(one, Vessel) for one in stuffs)

    def merges(self, turn: Turn) -> bool:
        """Return whether nothing mixes the whole any more after ``turn``, so that what joins last completes it."""
        if not turn.main or self.is_worked_later([turn.stage, *turn.later]):
            return False
        return not any(self.course.stage_alive(one) for one in turn.later)

    def is_worked_later(self, later: Sequence[Stage]) -> bool:
        """Return whether any of the stages that come ``later`` mixes or heats the whole."""
        return any(self.mixing(one) for one in later)

    def mixing(self, stage: Stage) -> bool:
        """Return whether a stage mixes or heats."""
        return bool(stage.motion) and not stage.does.isdisjoint(MIXES | HEATS)

    def water(self, stage: Stage) -> bool:
        """Return whether free water joins at ``stage``: the frame has it, nobody asked for it.

        No other liquid takes its place.
        """
        free = self._free_water(stage)
        if not free or stage.does.isdisjoint(WORKS):
            return False
        if BATH not in free and self._is_asked("water"):
            return False
        if THINNED in free:
            wets = [join.want.facts for join in self._joins_of(stage) if not join.want.facts.is_a("fat")]
            return not any(facts.is_a("liquid", "creamy", "egg") for facts in wets)
        return isinstance(stage, Phase) or self._is_wetted(stage)

    def _is_wetted(self, stage: Stage) -> bool:
        """Whether what joins a stage needs the water that the video takes there."""
        joins = self._joins_of(stage)
        if not stage.appliance and all(join.slot is None for join in joins):
            return False  # nothing comes of what the video thins with it
        if "knead" in stage.does and self._is_asked("dough"):
            return False  # bought dough has its water
        if "liquid" not in stage.does and self._is_boiled_apart():
            return False  # that was the water to boil it in
        return not any(join.want.facts.is_a("cooking liquid") for join in joins)

    def _free_water(self, stage: Stage) -> list[Slot]:
        """Return the slots of a stage for water that no asked food takes."""
        taken = {id(join.slot) for join in self.plan.joins}
        return [slot for slot in stage.slots if slot.food == "water" and id(slot) not in taken]

    def _joins_of(self, stage: Stage) -> list[Join]:
        """Return the asked foods of which a stage was the place, wherever they join now."""
        return [join for join in self.plan.joins if join.spot.stage is stage]

    def _is_boiled_apart(self) -> bool:
        return not self.plan.one_pot and self._is_asked(*word_list("is boiled by itself"))

    def _is_asked(self, *kinds: str) -> bool:
        """Whether a food of one of some kinds is asked."""
        return any(join.want.facts.is_any(kinds) for join in self.plan.joins)

    def taken_up(self, stage: Stage, vessel: Vessel) -> Stuff | None:
        """Return the only food that ``stage`` cooks in a vessel: fat and spices that cling to it are one with it.

        So is the water in which it swells, where that is not poured off.
        """
        contents = vessel.contents
        foods = [stuff for stuff in contents if not self._is_a(stuff, "clings to what is fried")]
        swollen = [stuff for stuff in foods if self._is_a(stuff, "swells")]
        water = [stuff for stuff in foods if self._is_a(stuff, "goes into the water")]
        if BATH not in stage.adds and len(swollen) + len(water) == len(foods):
            foods = swollen
        return foods[0] if len(foods) == 1 < len(contents) else None

    def _is_a(self, stuff: Stuff, words_of: str) -> bool:
        return self.known.foods.food(stuff.label).is_any(word_list(words_of))

    def is_drained_next(self, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Return whether the water in which foods are cooked in ``vessel`` is poured away by the ``later`` stages.

        Until then it is no part of anything.
        """
        row = self.known.utensil(later[0].vessel) if later and later[0].vessel else None
        water = any(self.known.foods.food(stuff.label).is_a("water") for stuff in vessel.contents if not stuff.mixed)
        return water and row is not None and "strain" in row.can

    def is_idle(self, stage: Stage, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Return whether ``stage`` would change nothing in ``vessel``, or is done again by one of the ``later`` stages.

        What is asked of all work comes first; what heats is asked less, as it changes a food that is alone, too.
        """
        if self._is_done_again(stage, vessel, later):
            return True
        heats = stage.heats
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        if heats and self._gets_hot_later(foods, later):
            return True
        if _rises_by_nothing(stage, foods) or (not heats and self._is_not_to_be_held(stage, vessel)):
            return True
        if not stage.does.isdisjoint(MIXES):
            return self._is_mixed_needlessly(stage, vessel, heats=heats)
        return not heats and self._works_one_food_needlessly(stage, vessel, foods)

    def _is_done_again(self, stage: Stage, vessel: Vessel, later: Sequence[Stage]) -> bool:
        following = self._next(later, vessel)
        goes_on = following is not None and self._goes_on(stage, following)
        return goes_on or _mashes_what_runs(stage, vessel, later, self.known)

    def _gets_hot_later(self, foods: Sequence[Food], later: Sequence[Stage]) -> bool:
        """Whether foods that are only made hot are so by a later stage, and what comes next need not find them hot."""
        if not any(one.heats for one in later):
            return False  # this makes them hot, or nothing does
        return all(self._is_only_made_hot(food) for food in foods) and not self._is_awaited(later[0])

    def _is_not_to_be_held(self, stage: Stage, vessel: Vessel) -> bool:
        """Whether nobody turns food over where it lies, or in its liquid, or cuts what is in pieces."""
        if "turn" in stage.does and any(is_loose_in_liquid(stuff, self.known) for stuff in vessel.contents):
            return True
        turned = "turn" in stage.does and not stage.appliance and is_flat(vessel.label)
        return turned or ("cut" in stage.does and self._is_in_pieces(vessel))

    def _is_mixed_needlessly(self, stage: Stage, vessel: Vessel, *, heats: bool) -> bool:
        """Whether there is one food only to be mixed, that is so already, or everything is mixed before."""
        single = len(vessel.contents) == 1 and not vessel.contents[0].mixed
        needless = stage.does <= {"coat", "mix", "scatter"} or self._is_done_so(stage, vessel.contents[0])
        if single and not heats and needless:
            return True
        return stage.does <= {"mash", "mix", "blend", "move", "scatter"} and self._is_mixed(stage, vessel)

    def _works_one_food_needlessly(self, stage: Stage, vessel: Vessel, foods: Sequence[Food]) -> bool:
        """Whether hands would work one food that needs none of it: dough is rolled, and what is baked is cut open."""
        single = len(vessel.contents) == 1 and not vessel.contents[0].mixed
        rolled = "shape" in stage.does and bool(foods) and foods[0].is_a("dough") and not self._is_shaped(vessel)
        opened = stage.does == {"cut"} and is_heated(vessel.contents[0].states, self.known)
        return single and stage.does.isdisjoint({"peel", "wait"}) and not rolled and not opened

    def _is_awaited(self, following: Stage) -> bool:
        """Whether something comes next that has to come into a liquid that is hot: what was shaped."""
        shaped = any("shape" in stage.does for line in following.lines for stage in line.stages)
        return isinstance(following, Phase) and following.bath and shaped

    def _next(self, later: Sequence[Stage], vessel: Vessel) -> Stage | None:
        """Return the next stage, past one that only turns food over and that nobody does here."""
        turns = bool(later) and later[0].does == {"turn"} and not self.course.stage_alive(later[0])
        if turns and len(later) > 1 and self.is_idle(later[0], vessel, later[1:]):
            return later[1]
        return next(iter(later), None)

    def _is_in_pieces(self, vessel: Vessel) -> bool:
        """Whether there is nothing to cut in what a dish is cooked in: all of it is small, or one with the rest."""
        row = self.known.utensil(vessel.label)
        fine = all(s.mixed or any(self.known.state(t).fineness > 0 for t in s.states) for s in vessel.contents)
        return row is not None and bool(row.can & {"heat", "cook"}) and fine and len(vessel.contents) > 1

    def _is_shaped(self, vessel: Vessel) -> bool:
        """Whether dough was bought rolled out."""
        names = {word for food in foods_of(vessel) for word in food.split()}
        return says(names, "dough that is shaped")

    def _is_done_so(self, stage: Stage, stuff: Stuff) -> bool:
        """Whether one food is as a stage would make it: beaten before, in small bits, or dough that was bought."""
        facts = self.known.foods.food(stuff.label)
        beaten = "whip" in stage.does and not self.known.motion(stage.motion).gives.isdisjoint(stuff.states)
        small = any(self.known.state(state).fineness >= MINCED for state in stuff.states)
        small = small or form_of(self.known, stuff.label, stuff.states) == "powder"
        if small and not stage.does.isdisjoint({"blend", "whip"}):
            return True
        return beaten or ("knead" in stage.does and facts.is_a("dough"))

    def _is_only_made_hot(self, food: Food) -> bool:
        return food.is_any(word_list("is only made hot")) and not food.is_any(word_list("is cooked in phases"))

    def _is_mixed(self, stage: Stage, vessel: Vessel) -> bool:
        """Whether nothing is left to be mixed: it is mixed and nothing joined, or it is one food that pours."""
        if len(vessel.contents) != 1:
            return False
        (stuff,) = vessel.contents
        if not stuff.mixed:
            return form_of(self.known, stuff.label, stuff.states) in {"powder", "liquid"}
        done = {"blended"} if "blend" in stage.does else {"mixed", "blended"}
        return not self.course.stage_alive(stage) and not done.isdisjoint(stuff.states)

    def stays_in(self, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Return whether a vessel stays in its appliance: the next heating of ``later`` is there.

        Nothing joins before.
        """
        following = next((one for one in later if one.heats), None)
        return (
            following is not None
            and vessel.device is not None
            and following.appliance == vessel.device.label
            and following.vessel in {vessel.label, ""}
            and not any(one.adds for one in later)
        )

    def has_no_portions(self) -> bool:
        """Return whether a dish is spooned out of what it is baked in: nothing in it comes in portions."""
        return not any(is_portion(join.want, self.known) for join in self.plan.joins)

    def stays_there(self, stage: Stage, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Return whether ``stage`` only carries on the dish in ``vessel``, though it is eaten out of that.

        It was baked there. ``later`` are the stages that come then.
        """
        row = self.known.utensil(vessel.label)
        ends = all(only_carries(one) and not self.course.stage_alive(one) for one in (stage, *later))
        dish = row is not None and row.group in word_list("is served in what it is baked in")
        baked = any(map(is_baked, vessel.contents))
        return ends and dish and baked and not self.plan.tin and not self.plan.laid and self.has_no_portions()


def _is_dry_phase(stage: Stage) -> bool:
    """Whether foods fry at a stage, in their turn, and none of them boils."""
    return isinstance(stage, Phase) and not stage.bath


def _rises_by_nothing(stage: Stage, foods: Sequence[Food]) -> bool:
    """Whether a stage lets rise what has nothing in it that makes it rise."""
    return stage.motion in word_list("rises") and not any(f.is_any(word_list("makes dough rise")) for f in foods)


def _mashes_what_runs(stage: Stage, vessel: Vessel, later: Sequence[Stage], known: Tables) -> bool:
    """Whether a stage mashes what runs or dissolves in a vessel, and a ``later`` one stirs it anyway."""
    if "mash" not in stage.does or stage.heats or not any(one.does & MIXES for one in later):
        return False
    return all(_dissolves(stuff, known) for stuff in vessel.contents)


def _dissolves(stuff: Stuff, known: Tables) -> bool:
    return not stuff.mixed and form_of(known, stuff.label, stuff.states) in {"liquid", "powder"}
