"""What is cooked in one open vessel over the heat, in the order in which a cook does it.

A video shows the order of its own foods only. So the stages in which one vessel stands over the heat are taken
together, and the foods that join there are parted again by what they are: what fries in the hot fat, what is stirred
into it for a moment, what cooks in the liquid, what is done soon, what is stirred in last. After each the whole is
cooked, as the video does it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import Food, Tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.course import HEATS, WORKS, Plan
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.teaching.frames import Line, Phase, Slot, Stage

_BATHS = tuple(word_list("is a bath"))
_DONE_OVER_HEAT = HEATS | {"mix", "liquid", "move", "fat", "coat"}
_ORDER = ("is fried", "is stirred into the fat", "cooks in the liquid", "is done soon", "is stirred in last")
_FRIED, _BINDS, _WET, _SOON, _LAST = _ORDER
_EGGS_FIRST, _EGGS = "eggs before what is boiled", "eggs"
_DRY_ORDER = (_FRIED, _BINDS, _SOON, _EGGS_FIRST, _WET, _EGGS, _LAST)
_MOST_TELLING = (_LAST, _SOON, _BINDS, _FRIED, _WET)


@dataclass(frozen=True)
class _Comer:
    """What joins a vessel over the heat: an asked food, a line, or water that nobody asked for."""

    what: Join | Line | Slot
    facts: Food | None
    phase: str

    @property
    def rank(self) -> tuple[bool, bool, bool]:
        """Its place within its phase: fat first, then what takes longest, seasoning at the end."""
        facts = self.facts
        if facts is None:
            return (True, True, False)
        first = facts.is_a("fat"), facts.is_a(*word_list("is flesh"))
        return (not first[0], not first[1], facts.is_a("flour") or _seasons(facts))

    @property
    def is_solid(self) -> bool:
        """Whether something comes that is cooked, and no mere fat or seasoning."""
        if self.is_water:
            return False
        return self.facts is None or not (self.facts.is_a("fat") or _seasons(self.facts))

    @property
    def is_water(self) -> bool:
        """Whether it is water: to boil it is nothing to be told, but what joins it then is."""
        return isinstance(self.what, Slot) or (self.facts is not None and self.facts.is_a("water"))


def in_phases(line: Line, plan: Plan, known: Tables) -> tuple[Line, Plan]:
    """Return the line of a dish and its plan with what stands over the heat in the order of a cook."""
    phaser = _Phaser(plan, known)
    changed = phaser.line(phaser.tossed(line))
    joins = [phaser.moved(join) for join in plan.joins]
    rank = {number: place for place, number in enumerate(phaser.order)}
    joins.sort(key=lambda join: rank.get(join.want.number, -1))
    return changed, replace(plan, joins=joins)


def phase_of(facts: Food) -> str:
    """Return in which phase a food joins a vessel over the heat: by its name or kind, else by the broader ones."""
    for own in (facts.taken_for, facts.kind):
        for name in _MOST_TELLING:
            if own in word_list(name):
                return name
    return next((name for name in _MOST_TELLING if facts.is_a(*word_list(name))), _WET)


class _Phaser:
    def __init__(self, plan: Plan, known: Tables) -> None:
        self.plan = plan
        self.known = known
        self.order: list[int] = []
        self.became: dict[int, tuple[Stage, ...]] = {}
        self.spot: dict[int, Stage] = {}
        self.kept: list[Stage] = []  # what is known by its identity must not vanish
        self.at: dict[int, list[Join]] = {}
        for join in plan.joins:
            self.at.setdefault(id(join.spot.stage), []).append(join)

    # --- lines ---

    def tossed(self, line: Line) -> Line:
        """Return a line that boils and drains with a pan in which that is tossed with what it is eaten with."""
        for place, stage in enumerate(line.stages[1:], start=1):
            rest = line.stages[place:]
            joins = [join for join in self.at.get(id(stage), ()) if not is_strewn(join)]
            if not self._strains(line.stages[place - 1]) or any(not one.does.isdisjoint(WORKS) for one in rest):
                continue
            if self.plan.cold or all(join.slot is not None for join in joins):
                return line
            pan = Stage(
                (Line(line.stages[:place]), *stage.adds), "cook and stir", frozenset({"heat", "mix"}), ("spoon",),
                "cooking pan", "in", "stove", "heat", stage.label, stage.states, stage.step,
            )  # fmt: skip
            self.at[id(pan)] = joins
            self.at[id(stage)] = [join for join in self.at[id(stage)] if join not in joins]
            self.spot.update({join.want.number: pan for join in joins})
            self.became[id(stage)] = (pan, stage)
            self.kept.append(pan)
            return Line((pan, *rest))
        return line

    def line(self, line: Line) -> Line:
        stages: list[Stage] = []
        runs = list(self._runs(line))
        sets = any("shape" in stage.does for stage in line.stages)
        for place, run in enumerate(runs):
            adds = {id(add): self.line(add) for one in run for add in one.adds if isinstance(add, Line)}
            drained = place + 1 < len(runs) and self._strains(runs[place + 1][0])
            fresh = () if drained else self._phases(run, adds, sets=sets)
            if not fresh and all(adds[id(add)] is add for one in run for add in one.adds if isinstance(add, Line)):
                stages += run
                continue
            for one in run if not fresh else ():
                other = replace(one, adds=tuple(adds.get(id(add), add) for add in one.adds))
                self.became[id(one)] = (other,)
                stages.append(other)
            for one in run if fresh else ():
                self.became[id(one)] = fresh
            stages += fresh
        same = len(stages) == len(line.stages) and all(a is b for a, b in zip(stages, line.stages, strict=True))
        return line if same else Line(tuple(stages))

    def moved(self, join: Join) -> Join:
        """Return a food with the stage at which it joins now, and with what comes after that."""
        old = join.spot
        unique = list({id(one): one for before in (old.stage, *old.after) for one in self._now(before)}.values())
        spot = self.spot.get(join.want.number, old.stage)
        here = next((place for place, one in enumerate(unique) if one is spot), 0)
        return replace(join, spot=replace(old, stage=unique[here], after=tuple(unique[here + 1 :])))

    def _now(self, stage: Stage) -> Iterator[Stage]:
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
        return row is not None and "strain" in row.can

    def _is_over_heat(self, stage: Stage) -> bool:
        row = self.known.utensil(stage.appliance) if stage.appliance else None
        over = row is not None and row.source == "heat" and row.holds == "on"
        return over and bool(stage.motion) and stage.does <= _DONE_OVER_HEAT

    # --- phases ---

    def _phases(self, run: Sequence[Stage], adds: Mapping[int, Line], *, sets: bool) -> tuple[Stage, ...]:
        if isinstance(run[0], Phase):
            return ()  # it has its place already
        joins = [join for stage in run for join in self.at.get(id(stage), ())]
        beside = [add for stage in run for add in stage.adds if isinstance(add, Line)]
        joins += [join for line in beside for join in self._taken_out(line, sets=sets)]
        within = [*joins, *(join for line in beside for join in self._foods(line))]
        hot = [stage for stage in run if "heat" in stage.does]
        if not hot or not self._is_over_heat(run[0]) or not self._is_cooked_in_phases(within):
            return ()
        lines = [line for line in beside if self._foods(line)]
        fat = self._has_fat(within)
        bath = any(_is_bath(one.want.facts) for one in (*joins, *(j for line in lines for j in self._bath_of(line))))
        water = None if bath else self._water(run, joins, fat=fat)
        bath = bath or water is not None
        if not fat and not bath:
            if not any(join.want.facts.is_a(*word_list("is flesh")) for join in joins):
                return ()
            fat = True  # flesh fries without
        comers = self._comers(joins, adds, lines, fat=fat, bath=bath)
        if water is not None:
            comers.insert(0, _Comer(water, None, _WET))
        parts = _parts(self._as_a_whole(comers, within, bath=bath), _ORDER if bath else _DRY_ORDER)
        small = bath or any(one.want.facts.is_a("egg", *word_list("is eaten with a sauce")) for one in within)
        return self._stages(run, hot, parts, bath=bath, small=small)

    def _is_cooked_in_phases(self, foods: Sequence[Join]) -> bool:
        savoury = self.plan.one_pot or any(join.want.facts.is_a(*word_list("is cooked in phases")) for join in foods)
        return savoury or _makes_a_sauce(foods)

    def _has_fat(self, within: Sequence[Join]) -> bool:
        """Whether there is fat to fry in: among what comes together, or at hand in any kitchen."""
        fats = [join for join in self.plan.joins if join.want.facts.is_a(*word_list("gives fat"))]
        return any(join in within or join.want.facts.is_a("stock") for join in fats)

    def _comers(
        self, joins: Sequence[Join], adds: Mapping[int, Line], lines: Sequence[Line], *, fat: bool, bath: bool
    ) -> list[_Comer]:
        """Return what comes into the vessel, foods and ``lines``, each with its phase."""
        apart = not self.plan.one_pot
        foods = [_Comer(join, join.want.facts, _phase_in(join, fat=fat, bath=bath, apart=apart)) for join in joins]
        return foods + [_Comer(adds[id(line)], None, self._phase_of_line(line, bath=bath)) for line in lines]

    def _foods(self, line: Line) -> list[Join]:
        return [
            join
            for stage in line.stages
            for join in (
                *self.at.get(id(stage), ()),
                *(one for add in stage.adds if isinstance(add, Line) for one in self._foods(add)),
            )
        ]

    def _taken_out(self, line: Line, *, sets: bool) -> list[Join]:
        """Take out of what is mixed cold what a cook puts into the vessel by itself, and return it.

        That is what has to be fried before raw eggs come, and eggs that would set in the liquid only when that boils:
        not where all of it ``sets``, and is folded then.
        """
        foods = self._foods(line)
        if any(not stage.does <= {"mix", "move", "whip"} for stage in line.stages):
            return []
        batter = any(join.want.facts.is_a(*word_list("is held together with eggs")) for join in foods)
        eggs = not batter and any(join.want.facts.is_a("egg") for join in foods)
        bath = not sets and any(
            _is_bath(join.want.facts) and not join.want.facts.is_a(*word_list("is beaten with eggs")) for join in foods
        )
        found = [
            join
            for join in foods
            if (eggs and not join.want.facts.is_a("fat") and _needs_pan(join.want.facts))
            or (bath and join.want.facts.is_a("egg"))
        ]
        for joins in self.at.values():
            joins[:] = [join for join in joins if join not in found]
        return found

    def _bath_of(self, line: Line) -> list[Join]:
        """Return what of a line may be liquid to cook in: not drained water, nor what eggs are beaten with."""
        foods = self._foods(line)
        drained = self._strains(line.stages[-1]) or any(join.want.facts.is_a("egg") for join in foods)
        return [] if drained else foods

    def _phase_of_line(self, line: Line, *, bath: bool) -> str:
        """Return when what is made beside the vessel joins: with the first of its foods that does not only fry.

        What was boiled and drained is done, and only gets hot again.
        """
        if self._strains(line.stages[-1]):
            return _LAST if bath else _WET
        facts = [join.want.facts for join in self._foods(line)]
        if bath and self.plan.one_pot and any("shape" in stage.does for stage in line.stages):
            return _SOON  # whoever stirs raw balls with the vegetables has none
        if any(one.is_a(*word_list("is flesh")) for one in facts):
            return _FRIED
        order = (_WET, _SOON, _LAST) if bath else (_SOON, _WET, _LAST)
        phases = {_suited(one, fat=True, bath=bath) for one in facts}
        return next((name for name in order if name in phases), _WET)

    def _water(self, run: Sequence[Stage], joins: Sequence[Join], *, fat: bool) -> Slot | None:
        """Return the free water of the video where something has to cook in it that is not fried."""
        slot = next((slot for stage in run for slot in stage.slots if slot.food == "water"), None)
        if slot is None and self.plan.one_pot:
            slot = Slot("water", "water")  # there is no such dish without a liquid
        boils = any(
            "boil" in one.facts.owes and not one.cooked and not one.facts.is_a(*word_list("is boiled by itself"))
            for one in (join.want for join in joins)
        )
        asked = any(join.want.facts.is_a("water") for join in self.plan.joins)
        return slot if not asked and (not fat or boils or self.plan.one_pot) else None

    def _as_a_whole(self, comers: Sequence[_Comer], within: Sequence[Join], *, bath: bool) -> list[_Comer]:
        """Let grain come with water, and eggs before rice and noodles, but after them in a sauce with cheese."""
        if bath:
            return _untoasted(comers)
        facts = [join.want.facts for join in within]
        first = any(one.is_a(*word_list("is eaten with a sauce")) for one in facts) and not any(
            one.is_a(*word_list("makes a sauce with eggs")) for one in facts
        )
        eggs = _EGGS_FIRST if first else _EGGS
        return [replace(one, phase=eggs) if self._is_egg(one) else one for one in comers]

    def _is_egg(self, comer: _Comer) -> bool:
        if comer.facts is not None:
            return comer.facts.is_a("egg")
        return isinstance(comer.what, Line) and any(j.want.facts.is_a("egg") for j in self._foods(comer.what))

    def _stages(
        self,
        run: Sequence[Stage],
        hot: Sequence[Stage],
        parts: Sequence[Sequence[_Comer]],
        *,
        bath: bool,
        small: bool,
    ) -> tuple[Stage, ...]:
        stirs = next((stage for stage in hot if stage.does >= {"heat", "mix"}), None)
        simmers = next((stage for stage in hot if "liquid" in stage.does or "mix" not in stage.does), None)
        stages: list[Stage] = []
        for number, part in enumerate(parts):
            last = number == len(parts) - 1
            wet = bath and any(comer.phase == _WET and (comer.is_solid or comer.is_water) for comer in part)
            told = hot[-1] if last and not wet else simmers if wet else stirs
            phase = _as_phase(told or hot[-1], part, run[-1] if last else None, bath=bath, small=small)
            dry = not bath and "liquid" in phase.does  # there is none
            lumpy = wet and _thickens(parts[: number + 1])
            if dry or lumpy or (told is None and not wet):
                phase = replace(phase, motion="cook and stir", does=frozenset({"heat", "mix"}), tools=("spoon",))
            elif told is None:
                phase = replace(phase, motion="simmer", does=frozenset({"heat", "liquid"}), tools=())
            stages.append(phase)
            self._place(part, phase)
        return tuple(stages)

    def _place(self, part: Sequence[_Comer], phase: Phase) -> None:
        """Let the foods of ``part`` join at ``phase``, in their order."""
        for comer in part:
            if isinstance(comer.what, Join):
                self.spot[comer.what.want.number] = phase
                self.order.append(comer.what.want.number)


def _thickens(parts: Sequence[Sequence[_Comer]]) -> bool:
    """Whether the last of ``parts`` is what is poured on fat and flour, with nothing to be cooked in it."""
    *before, last = parts
    facts = [comer.facts for part in before for comer in part if comer.facts is not None]
    bound = any(one.is_a("flour") for one in facts) and any(one.is_a("fat") for one in facts)
    poured = [comer.facts for comer in last]
    wet = word_list("is stirred on flour")
    return bound and all(one is not None and (one.is_a(*wet) or _seasons(one)) for one in poured)


def _as_phase(pattern: Stage, part: Sequence[_Comer], end: Stage | None, *, bath: bool, small: bool) -> Phase:
    slots = [comer.what.slot if isinstance(comer.what, Join) else comer.what for comer in part]
    return Phase(
        tuple(slot for slot in slots if slot is not None), pattern.motion, pattern.does, pattern.tools, pattern.vessel,
        pattern.relation, pattern.appliance, pattern.source, end.label if end else "", end.states if end else (),
        pattern.step, bath=bath, small=small,
    )  # fmt: skip


def _untoasted(comers: Sequence[_Comer]) -> list[_Comer]:
    """Let grain come with the water where nothing else comes with that: one cooking is told of both."""
    if not all(one.is_water for one in comers if one.phase == _WET):
        return list(comers)
    toasted = word_list("is toasted")
    return [replace(c, phase=_WET) if c.facts is not None and c.facts.is_a(*toasted) else c for c in comers]


def _parts(comers: Sequence[_Comer], order: Sequence[str]) -> list[list[_Comer]]:
    """Part what joins by its phases; what only seasons, and fat, makes no phase of its own."""
    parts: list[list[_Comer]] = []
    waiting: list[_Comer] = []
    for name in order:
        here = sorted((comer for comer in comers if comer.phase == name), key=lambda comer: comer.rank)
        solid = [one for one in here if one.is_solid]
        water = [one for one in here if one.is_water]
        if solid or 0 < len(water) < len(here):
            parts.append([*waiting, *here])
            waiting = []
        elif parts and not water:
            parts[-1] += here
        else:
            waiting += here
    if waiting:
        parts.append(waiting)
    return parts


def is_strewn(join: Join) -> bool:
    """Whether a food is strewn on what is done; leaves that give their taste only by and by are not."""
    facts = join.want.facts
    return join.on_top or (facts.is_a("topping", "herb") and phase_of(facts) == _LAST)


def _needs_pan(facts: Food) -> bool:
    """Whether a food is not done when eggs set around it."""
    raw = facts.is_a(*word_list("is flesh")) and not facts.is_a("ready")
    return raw or phase_of(facts) == _FRIED or facts.is_a(*word_list("takes long in the pan"))


def _makes_a_sauce(joins: Sequence[Join]) -> bool:
    """Whether flour is stirred into fat, and something is poured on it."""
    facts = [join.want.facts for join in joins]
    other = any(one.is_a("leaven", *word_list("makes no sauce of flour")) for one in facts)
    told = any(one.is_a("flour") for one in facts) and any(one.is_a("fat") for one in facts)
    return told and not other and any(one.is_of(*_BATHS) for one in facts)


def _same_place(one: Stage, other: Stage) -> bool:
    return one.vessel == other.vessel and one.appliance == other.appliance


def _is_bath(facts: Food) -> bool:
    return facts.is_of(*_BATHS) and not facts.is_a(*word_list("is no bath"))


def _seasons(facts: Food) -> bool:
    """Whether a food only seasons what is cooked: cheese and bacon are salty, yet more than that."""
    more = facts.is_a("ready", *word_list("is cooked in phases")) or _is_bath(facts)
    return facts.is_a(*word_list("only flavours")) and not more


def _phase_in(join: Join, *, fat: bool, bath: bool, apart: bool) -> str:
    """Return in which phase an asked food joins: what no knife cuts takes as long as anything in the liquid.

    ``apart``: what is boiled and drained is boiled by itself, and done when it joins.
    """
    facts = join.want.facts
    done = join.want.cooked or join.want.asked in word_list("is so by dry heat")
    done = done or (apart and facts.is_a(*word_list("is boiled by itself")))
    if bath and done and facts.is_a(*word_list("is stirred in last when it is done")):
        return _LAST
    hard = facts.is_a(*word_list("is flesh")) and not word_list("is no work for a knife").isdisjoint(
        words(join.want.label)
    )
    late = phase_of(facts) in {_SOON, _LAST}
    return _WET if bath and hard and late else _suited(facts, fat=fat, bath=bath)


def _suited(facts: Food, *, fat: bool, bath: bool) -> str:
    """Return in which phase a food joins where there is fat to fry in and a liquid to cook in, or not."""
    phase = phase_of(facts)
    if phase in {_FRIED, _BINDS} and not fat:
        return _WET
    if not bath and facts.is_a(*word_list("is boiled by itself")):
        return _WET  # it is done already
    if phase == _WET and not bath and facts.is_a(*word_list("takes long in the pan")):
        return _FRIED
    if phase == _WET and bath and fat and facts.is_a(*word_list("is toasted")):
        return _BINDS
    return phase
