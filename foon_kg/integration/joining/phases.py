"""What is cooked in one open vessel over the heat, in the order in which a cook does it.

A video shows the order of its own foods only. So the stages in which one vessel stands over the heat are taken
together, and the foods that join there are parted again by what they are: what fries in the hot fat, what is stirred
into it for a moment, what cooks in the liquid, what is done soon, what is stirred in last. After each the whole is
cooked, as the video does it. Which food is in which phase is in :mod:`~foon_kg.integration.joining.additions`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.additions import (
    BINDS,
    DRY_ORDER,
    EGGS,
    EGGS_FIRST,
    LAST,
    ORDER,
    SOON,
    WET,
    Addition,
    Medium,
    VesselOverHeat,
    finishing_fat_last,
    in_parts,
    is_bath,
    is_dry_binder,
    is_strewn,
    makes_a_sauce,
    phase_in,
    phase_together,
    thickened_at_last,
    unbeaten,
    untoasted,
)
from foon_kg.integration.joining.course import WORKS, Plan
from foon_kg.integration.joining.lasting import as_long_as_needed, is_braised, tender_flesh_once
from foon_kg.integration.joining.patterns import STIR
from foon_kg.integration.joining.spots import Join, Spot, any_is
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import HEATS, Line, Phase, Slot, Stage, Steamed

# a stage that does more (shape, blend, bake) is no cooking in one open vessel, and stays what it is
_DONE_OVER_HEAT = HEATS | {"mix", "liquid", "move", "fat", "coat"}

_LEFT_RAW = frozenset({"coat", "mix", "move", "wait"})
"""What leaves flesh as it is: it is turned in something and stands."""


def in_phases(line: Line, plan: Plan, known: Tables) -> tuple[Line, Plan]:
    """Return the line of a dish and its plan with what stands over the heat in the order of a cook.

    ``known`` are the tables.
    """
    phaser = _Phaser(plan, known)
    changed = phaser.line(phaser.tossed(line))
    joins = [phaser.moved(join) for join in plan.joins]
    rank = {number: place for place, number in enumerate(phaser.order)}
    joins.sort(key=lambda join: rank.get(join.want.number, -1))
    return changed, replace(plan, joins=joins)


class _Phaser:
    """Parts the lines of one dish into phases.

    ``at`` has by the identity of a stage the foods that join there, ``became`` what became of it. ``spot`` says of each
    food that was moved, by its number, where it joins now; ``order`` are these numbers as the foods come.
    """

    def __init__(self, plan: Plan, known: Tables) -> None:
        self.plan = plan
        self.known = known
        self.order: list[int] = []
        self.became: dict[int, tuple[Stage, ...]] = {}
        self.spot: dict[int, Stage] = {}
        self.kept: list[Stage] = []  # an identity is only one for as long as the stage lives
        self.at: dict[int, list[Join]] = {}
        for join in plan.joins:
            self.at.setdefault(id(join.spot.stage), []).append(join)

    # --- lines ---

    def tossed(self, line: Line) -> Line:
        """Return a line that boils and drains with a pan in which that is tossed with what it is eaten with."""
        place = self._drained_before(line)
        if place is None or self.plan.cold:
            return line
        stage = line.stages[place]
        joins = [join for join in self.at.get(id(stage), ()) if not is_strewn(join)]
        if all(join.slot is not None for join in joins):
            return line
        drained = Line(line.stages[:place])
        pan = replace(STIR, adds=(drained, *stage.adds), label=stage.label, states=stage.states, step=stage.step)
        self.at[id(pan)] = joins
        self.at[id(stage)] = [join for join in self.at[id(stage)] if join not in joins]
        self.spot.update({join.want.number: pan for join in joins})
        self.became[id(stage)] = (pan, stage)
        self.kept.append(pan)
        return Line((pan, *line.stages[place:]))

    def _drained_before(self, line: Line) -> int | None:
        """Return the place of the stage just before which a line is drained, if nothing is done to it from there on."""
        for place in range(1, len(line.stages)):
            rest = line.stages[place:]
            if self._strains(line.stages[place - 1]) and all(one.does.isdisjoint(WORKS) for one in rest):
                return place
        return None

    def line(self, line: Line) -> Line:
        """Return a line of which what stands over the heat is in phases; itself where nothing is to be changed."""
        stages: list[Stage] = []
        runs = list(self._runs(line))
        sets = any("shape" in stage.does for stage in line.stages)
        for place, run in enumerate(runs):
            drained = place + 1 < len(runs) and self._strains(runs[place + 1][0])
            stages += self._cooked(run, drained=drained, sets=sets)
        same = len(stages) == len(line.stages) and all(a is b for a, b in zip(stages, line.stages, strict=True))
        return line if same else Line(tuple(stages))

    def _cooked(self, run: Sequence[Stage], *, drained: bool, sets: bool) -> Sequence[Stage]:
        """Return what becomes of the stages of one vessel: its phases, unless it is ``drained`` after them."""
        adds = {id(add): self.line(add) for stage in run for add in stage.lines}
        phases = () if drained else self._phases(run, adds, sets=sets)
        if phases:
            self.became.update((id(stage), phases) for stage in run)
            return phases
        if all(id(line) == before for before, line in adds.items()):
            return run
        changed = [_with_adds(stage, adds) for stage in run]
        for stage, other in zip(run, changed, strict=True):
            self.became[id(stage)] = (other,)
        return changed

    def moved(self, join: Join) -> Join:
        """Return a food with the stage at which it joins now, and with what comes after that."""
        old = join.spot
        unique = list({id(one): one for before in (old.stage, *old.after) for one in self._now(before)}.values())
        spot = self.spot.get(join.want.number, old.stage)
        here = next((place for place, one in enumerate(unique) if one is spot), 0)
        now = Spot(old.path, unique[here], old.stage_type, old.side, tuple(unique[here + 1 :]))
        return Join(join.want, now, join.fit, join.slot, join.layer, join.on_top)

    def _now(self, stage: Stage) -> Iterator[Stage]:
        """Yield what became of a stage, and of that again."""
        for one in self.became.get(id(stage), (stage,)):
            if one is stage:
                yield one
            else:
                yield from self._now(one)

    def _runs(self, line: Line) -> Iterator[list[Stage]]:
        """Yield the stages in groups: those of one vessel over the heat together, each other one by itself."""
        run: list[Stage] = []
        for stage in line.stages:
            together = self._is_over_heat(stage) and not isinstance(stage, Phase)
            if run and not (together and self._is_over_heat(run[-1]) and _same_place(run[-1], stage)):
                yield run
                run = []
            run.append(stage)
        if run:
            yield run

    def _strains(self, stage: Stage) -> bool:
        row = self.known.utensil(stage.vessel) if stage.vessel else None
        return row is not None and "strain" in row.can and not stage.heats  # nothing runs off in a steamer

    def _is_over_heat(self, stage: Stage) -> bool:
        row = self.known.utensil(stage.appliance) if stage.appliance else None
        over = row is not None and row.source == "heat" and row.holds == "on"
        return over and bool(stage.motion) and stage.does <= _DONE_OVER_HEAT and not isinstance(stage, Steamed)

    # --- phases ---

    def _phases(self, run: Sequence[Stage], adds: Mapping[int, Line], *, sets: bool) -> tuple[Stage, ...]:
        """Return the phases of the stages of one vessel, to which ``adds`` come; none where there are none to part."""
        if isinstance(run[0], Phase):
            return ()  # it has its place already
        vessel = self._vessel(run, sets=sets)
        if not vessel.hot or not self._is_over_heat(run[0]) or not self._is_cooked_in_phases(vessel.within):
            return ()
        medium = self._medium(vessel)
        if medium is None:
            return ()
        additions = self._thickened(self._additions(vessel, adds, medium), medium)
        additions = self._as_a_whole(additions, vessel.within, bath=medium.bath)
        order = ORDER if medium.bath else DRY_ORDER
        return self._stages(vessel, in_parts(tender_flesh_once(additions, order), order), bath=medium.bath)

    def _vessel(self, run: Sequence[Stage], *, sets: bool) -> VesselOverHeat:
        """Return what comes together in one vessel; what is mixed beside it may be ``_taken_out`` of that."""
        joins = [join for stage in run for join in self.at.get(id(stage), ())]
        beside = [line for stage in run for line in stage.lines]
        for line in beside:
            joins += self._taken_out(line, sets=sets)
        lines = [line for line in beside if self._foods(line)]
        within = list(joins)
        for line in lines:
            within += self._foods(line)
        return VesselOverHeat(run, joins, lines, within)

    def _is_cooked_in_phases(self, foods: Sequence[Join]) -> bool:
        return self.plan.one_pot or any_is(foods, *word_list("is cooked in phases")) or makes_a_sauce(foods)

    def _medium(self, vessel: VesselOverHeat) -> Medium | None:
        """Return what the foods of a vessel cook in; ``None`` where there is nothing to cook them in."""
        fat = self._has_fat(vessel.within)
        poured = [*vessel.joins, *(join for line in vessel.lines for join in self._bath_of(line))]
        if any(is_bath(one.want.facts) for one in poured):
            return Medium(fat=fat, bath=True)
        water = self._water(vessel, fat=fat)
        if water is not None:
            return Medium(fat=fat, bath=True, water=water)
        hot = fat or any_is(vessel.joins, *word_list("is flesh"))  # flesh has fat of its own
        return Medium(fat=True, bath=False) if hot else None

    def _has_fat(self, within: Sequence[Join]) -> bool:
        """Whether there is fat to fry in: among what comes together, or at hand in any kitchen."""
        fats = [join for join in self.plan.joins if join.want.facts.is_any(word_list("gives fat"))]
        return any(join in within or join.want.facts.is_a("stock") for join in fats)

    def _additions(self, vessel: VesselOverHeat, adds: Mapping[int, Line], medium: Medium) -> list[Addition]:
        """Return what comes into a vessel, each with its phase; ``adds`` are the lines as they are by now."""
        apart = not self.plan.one_pot
        water = [Addition(medium.water, None, WET)] if medium.water is not None else []
        foods = [Addition(join, join.want.facts, phase_in(join, medium, apart=apart)) for join in vessel.joins]
        foods = finishing_fat_last(foods)
        lines = [self._addition_of_line(line, adds[id(line)], medium) for line in vessel.lines]
        return water + foods + lines

    def _addition_of_line(self, line: Line, made: Line, medium: Medium) -> Addition:
        """Return how what a line makes, ``made`` by now, comes into a vessel: flesh in its marinade as flesh does."""
        flesh = [join for join in self._foods(line) if join.want.facts.is_any(word_list("is flesh"))]
        cold = all(stage.does <= _LEFT_RAW for stage in line.all_stages())
        if flesh and cold:
            return Addition(made, flesh[0].want.facts, phase_in(flesh[0], medium, apart=not self.plan.one_pot))
        return Addition(made, None, self._phase_of_line(line, bath=medium.bath))

    def _foods(self, line: Line) -> list[Join]:
        """Return the foods that join a line, and the lines that join it."""
        found: list[Join] = []
        for stage in line.stages:
            found += self.at.get(id(stage), ())
            for add in stage.lines:
                found += self._foods(add)
        return found

    def _taken_out(self, line: Line, *, sets: bool) -> list[Join]:
        """Take out of what is mixed cold what a cook puts into the vessel by itself, and return it.

        That is what has to be fried before raw eggs come, and eggs that would set in the liquid only when that boils:
        not where all of it ``sets``, and is folded then. In a pot in which all is cooked each comes in its turn.
        """
        if not _is_mixed_cold(line):
            return []
        foods = self._foods(line)
        found = foods if is_dry_binder(foods) or self._comes_in_turn(foods) else unbeaten(foods, sets=sets)
        for joins in self.at.values():
            joins[:] = [join for join in joins if join not in found]
        return found

    def _comes_in_turn(self, foods: Sequence[Join]) -> bool:
        """Whether foods that a video mixes beside a pot may as well come into it one by one.

        Starch that no fat takes up is stirred smooth before, and so is what holds together.
        """
        binds = any_is(foods, *word_list("makes lumps")) and not self._has_fat(foods)
        held = any_is(foods, *word_list("holds a mixture together") - word_list("makes lumps"))
        seasoned = all(is_bath(one.want.facts) or one.want.facts.is_a("herb", "spice") for one in foods)
        return (self.plan.one_pot or seasoned) and not binds and not held

    def _bath_of(self, line: Line) -> list[Join]:
        """Return what of a line may be liquid to cook in: not drained water, what eggs are beaten with, or a dough."""
        foods = self._foods(line)
        held = any("shape" in stage.does for stage in line.stages) or any_is(foods, "egg")
        return [] if held or self._strains(line.stages[-1]) else foods

    def _phase_of_line(self, line: Line, *, bath: bool) -> str:
        """Return when what is made beside the vessel joins.

        What was boiled and drained is done, and only gets hot again.
        """
        if self._strains(line.stages[-1]):
            return LAST if bath else WET
        made = self._phase_as_made(line, bath=bath)
        return made or phase_together([join.want.facts for join in self._foods(line)], bath=bath)

    def _phase_as_made(self, line: Line, *, bath: bool) -> str:
        """Return when a line joins by how it is made; ``""`` where that says nothing."""
        does = frozenset[str]().union(*(stage.does for stage in line.stages))
        if bath and self.plan.one_pot and "shape" in does:
            return SOON  # whoever stirs raw balls with the vegetables has none
        if "blend" in does:
            return BINDS if self._has_fat(()) else WET  # what was ground to a paste is fried
        return ""

    def _water(self, vessel: VesselOverHeat, *, fat: bool) -> Slot | None:
        """Return the free water of the video where something has to cook in it that is not fried."""
        if any_is(self.plan.joins, "water"):
            return None
        boils = self.plan.one_pot or self._boils(vessel)
        if fat and not boils:
            return None
        if boils and (vessel.water is None or self._is_taken(vessel.water)):
            return Slot("water", "water")  # there is no such dish without a liquid
        return vessel.water

    def _is_taken(self, water: Slot) -> bool:
        """Whether a food joins in the stead of the water of the video: a stock cube, which is no liquid."""
        return any(join.slot is water for join in self.plan.joins)

    def _boils(self, vessel: VesselOverHeat) -> bool:
        """Whether something in a vessel is not done unless it cooks in a liquid."""
        braised = not self.plan.stacked and any(map(is_braised, vessel.within))
        return braised or any(_has_to_boil_here(join.want) for join in vessel.joins)

    def _thickened(self, additions: list[Addition], medium: Medium) -> list[Addition]:
        """Return ``additions`` with a sauce that was stirred cold after what is fried for a moment, where they fry."""
        if not (medium.fat and medium.bath) or self.plan.one_pot:
            return additions
        return thickened_at_last(additions, [one for one in additions if self._is_cold_sauce(one)])

    def _is_cold_sauce(self, addition: Addition) -> bool:
        """Whether what comes was stirred cold with what binds or salts it, and has no flesh in it."""
        if not isinstance(addition.what, Line) or not _is_mixed_cold(addition.what):
            return False
        facts = [join.want.facts for join in self._foods(addition.what)]
        sauce = any(one.is_any(word_list("makes a sauce cold")) for one in facts)
        return sauce and not any(one.is_any(word_list("is flesh")) for one in facts)

    def _as_a_whole(self, additions: Sequence[Addition], within: Sequence[Join], *, bath: bool) -> list[Addition]:
        """Return ``additions`` with grain beside water, and eggs before rice and noodles, or after them in a sauce.

        Eggs that set before are scrambled among fried rice; what makes a sauce with cheese must not set.
        """
        if bath:
            return as_long_as_needed(untoasted(additions), within)
        eaten_with_a_sauce = any_is(within, *word_list("is eaten with a sauce"))
        first = eaten_with_a_sauce and not any_is(within, *word_list("makes a sauce with eggs"))
        eggs = EGGS_FIRST if first else EGGS
        return [replace(one, phase=eggs) if self._is_egg(one) else one for one in additions]

    def _is_egg(self, addition: Addition) -> bool:
        if addition.facts is not None:
            return addition.facts.is_a("egg")
        return isinstance(addition.what, Line) and any_is(self._foods(addition.what), "egg")

    def _stages(self, vessel: VesselOverHeat, parts: Sequence[Sequence[Addition]], *, bath: bool) -> tuple[Stage, ...]:
        """Return a stage for each of ``parts``, the foods of which join there; the last is what the run has made."""
        small = bath or any_is(vessel.within, "egg", *word_list("is eaten with a sauce"))
        stages: list[Stage] = []
        for number, part in enumerate(parts, start=1):
            last = number == len(parts)
            pattern = vessel.pattern(parts[:number], bath=bath, last=last)
            phase = _as_phase(pattern, part, vessel.run[-1] if last else None, bath=bath, small=small)
            stages.append(phase)
            self._place(part, phase)
        return tuple(stages)

    def _place(self, part: Sequence[Addition], phase: Phase) -> None:
        """Let the foods of ``part`` join at ``phase``, in their order."""
        for addition in part:
            if isinstance(addition.what, Join):
                self.spot[addition.what.want.number] = phase
                self.order.append(addition.what.want.number)


def _with_adds(stage: Stage, lines: Mapping[int, Line]) -> Stage:
    """Return a stage with its lines as they are in ``lines``, by the identity that they had."""
    return replace(stage, adds=tuple(lines.get(id(add), add) for add in stage.adds))


def _is_mixed_cold(line: Line) -> bool:
    return all(stage.does <= {"mix", "move", "whip"} for stage in line.stages)


def _as_phase(pattern: Stage, part: Sequence[Addition], end: Stage | None, *, bath: bool, small: bool) -> Phase:
    slots = [addition.what.slot if isinstance(addition.what, Join) else addition.what for addition in part]
    return Phase(
        tuple(slot for slot in slots if slot is not None), pattern.motion, pattern.does, pattern.tools, pattern.vessel,
        pattern.relation, pattern.appliance, pattern.source, end.label if end else "", end.states if end else (),
        pattern.step, bath=bath, small=small,
    )  # fmt: skip


def _has_to_boil_here(want: Want) -> bool:
    """Whether a food is not done unless it is boiled, and nobody boils such by itself."""
    boiled_apart = want.cooked or want.facts.is_any(word_list("is boiled by itself"))
    return "boil" in want.facts.owes and not boiled_apart


def _same_place(one: Stage, other: Stage) -> bool:
    return one.vessel == other.vessel and one.appliance == other.appliance
