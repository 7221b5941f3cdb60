"""Making a dish after a frame: foods are prepared, brought together stage by stage, and heated block by block.

The phases are always the same (design, section 8): everything is cut and opened first; what has to be cooked by itself
is cooked; then the lines of the frame are carried out, each heat block uninterrupted; at the end everything is off.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, foods_of, is_flat
from foon_kg.integration.frames import Line, Slot, Stage
from foon_kg.integration.operators import Attested, Nearness, Way, form_of
from foon_kg.integration.places import Join
from foon_kg.integration.preparation import Preparer, Ready, Want, owed
from foon_kg.world.becoming import meets

_MIXES = frozenset({"mix", "whip", "knead", "mash", "blend"})
_HEATS = frozenset({"heat", "warm"})
_MOVES = frozenset({"move", "scatter", "fetch"})
_WORKS = _MIXES | _HEATS | {"wait", "shape", "turn", "cut"}


@dataclass
class Plan:
    """What is made: the name of the dish, its states, and which foods join where."""

    label: str
    goal: str
    joins: Sequence[Join]
    cooked_by: dict[str, tuple[str, ...]] = field(default_factory=dict)
    eased: frozenset[str] = frozenset()


class Cooking:
    """One dish in the making on a bench."""

    def __init__(self, bench: Bench, line: Line, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.preparer = Preparer(bench)
        self.line = line
        self.plan = plan
        self.at: dict[int, list[Join]] = {}
        for join in plan.joins:
            self.at.setdefault(id(join.spot.stage), []).append(join)
        self.ready: dict[int, Ready] = {}
        self.assumptions: list = []

    # --- the whole ---

    def make(self) -> Stuff:
        """Make the dish and return it; raises :class:`RefusedError` where a step cannot be done."""
        for join in self._in_order():
            self._prepare(join)
        self.bench.phase = "heat"
        for join in self._in_order():
            method = self._cooked_first(join)
            if method:
                self._cook_first(join, method)
        vessel = self._run(self.line, main=True)
        if vessel is None:
            raise RefusedError("nothing of what was asked joins this dish")
        self.bench.phase = "finish"
        self._finish(vessel)
        if len(vessel.contents) > 1:
            self._name(vessel, self.plan.label)
        return vessel.contents[0]

    def _in_order(self) -> Iterator[Join]:
        def walk(line: Line) -> Iterator[Join]:
            for stage in line.stages:
                for add in stage.adds:
                    if isinstance(add, Line):
                        yield from walk(add)
                yield from self._ordered(stage)

        yield from walk(self.line)

    def _ordered(self, stage: Stage) -> list[Join]:
        """Return the foods that join a stage in their order: as the frame has them; others by what they are."""
        slots = list(stage.adds)
        heats = not stage.does.isdisjoint(_HEATS)

        def order(join: Join) -> tuple[float, int, int]:
            facts = join.want.facts
            if join.slot is not None:
                place: float = slots.index(join.slot) if join.slot in slots else -0.5
            elif facts.is_a("fat") and heats:
                place = -1
            elif facts.is_a("liquid", "creamy"):
                place = len(slots) + 0.5
            elif facts.is_a("spice", "herb"):
                place = len(slots) + 1
            else:
                place = len(slots)
            owes = 0 if "cook" in facts.owes else 1
            return (place, owes, join.want.number)

        found = sorted(self.at.get(id(stage), ()), key=order)
        if heats:
            found.sort(key=lambda join: not join.want.facts.is_a("fat"))
        return found

    # --- single foods ---

    def _prepare(self, join: Join) -> None:
        stage, want = join.spot.stage, join.want
        blended = not stage.does.isdisjoint({"blend", "mash"}) or any(
            not one.does.isdisjoint({"blend"}) for one in join.spot.after[:1] if not stage.does
        )
        form = join.slot.states if join.slot is not None else ()
        self.bench.phase = "prepare"
        first = self._cooked_first(join)
        if first and "shell" in want.facts.owes and form_of(self.known, want.label, want.leaf) != "liquid":
            self.ready[want.number] = Ready(
                want, self.bench.fetch(want.label, want.leaf, [want.number], want.storage), whole_shell=True
            )
            return
        ready = self.preparer.prepare(want, form, divided=not blended)
        self.ready[want.number] = ready
        self._beaten_first(join, ready)
        if want.facts.is_a("water") and self._is_hot(stage):
            self._measure(ready)

    def _is_hot(self, stage: Stage) -> bool:
        """Whether the vessel of a stage is hot already when foods join there."""

        def before(line: Line) -> bool:
            if stage in line.stages:
                place = line.stages.index(stage)
                return any("heat" in one.does for one in line.stages[:place] if self._stage_alive(one))
            return any(before(add) for one in line.stages for add in one.adds if isinstance(add, Line))

        return before(self.line)

    def _measure(self, ready: Ready) -> None:
        """Fetch water before anything is hot."""
        if ready.stuff.at is not None and ready.stuff.at.storage:
            cup = self.bench.vessel("measuring cup")
            attested = self.bench.attest([("pour", ())], ready.want.names)
            if attested is not None:
                self.bench.bring([ready.stuff], cup, attested)

    def _beaten_first(self, join: Join, ready: Ready) -> None:
        """Open a food over a bowl of its own and beat it, where it is asked or joins so and is not beaten later."""
        if not ready.whole_shell:
            return
        stage, want = join.spot.stage, join.want
        beaten = [
            s
            for s in (want.make, *(join.slot.states if join.slot else ()))
            if s and "shell" in self.known.state(s).earns
        ]
        heats = not stage.does.isdisjoint(_HEATS)
        mixes = not stage.does.isdisjoint(_MIXES) and not heats
        if not (want.make or (beaten and not mixes)):
            return
        if not any(s for s in beaten if self._beating(want, s)):
            return
        state = next(s for s in beaten if self._beating(want, s))
        bowl = self.bench.vessel("bowl")
        self._open_into(ready, bowl)
        attested = self._beating(want, state)
        if attested is not None:
            self.bench.work(bowl, attested, want.label, (state,), with_device=False)
            ready.stuff = bowl.contents[0]

    def _beating(self, want: Want, state: str) -> Attested | None:
        motion = self.known.motion
        ways = [way for way in self.bench.operators.making(state) if motion(way[0]).does <= {"mix", "whip"} and way[1]]
        ways.sort(key=lambda way: "whip" not in motion(way[0]).does)
        return self.bench.attest(ways, want.names)

    def _open_into(self, ready: Ready, vessel: Vessel) -> None:
        attested = self.preparer.opening(ready.want)
        if attested is None:
            raise RefusedError(f"nothing opens {ready.want.label}")
        state = self.preparer._gives(attested.way, ("shell", "open"))  # noqa: SLF001
        self.bench.bring([ready.stuff], vessel, attested, (state,))
        ready.whole_shell = False

    def _cooked_first(self, join: Join) -> tuple[str, ...]:
        """Return the motions by which a food is cooked by itself before it joins; nothing where the dish cooks it."""
        want, spot = join.want, join.spot
        due = {"cook", "boil"} & owed(want, self.known)
        if not due and not want.cooked:
            return self._warmed_first(join)
        if want.facts.kind in self.plan.eased or any(kind in self.plan.eased for kind in want.facts.kinds):
            return ()
        if join.slot is not None and join.slot.cooked:
            return join.slot.cooked
        heats = [stage for stage in (spot.stage, *spot.after) if "heat" in stage.does]
        if want.cooked and self._is_boiled(want.make) and not any("liquid" in stage.does for stage in heats):
            return ("boil",)
        if "boil" in due:
            bath = [stage for stage in heats if "dry" not in stage.does]
            if bath and self._has_liquid(spot.path, bath):
                return ()
            return ("boil",)
        if heats and not (spot.post[0] == "heat" and join.slot is None and "cook" in due and not self._pours(want)):
            return ()
        if heats and self._has_liquid(spot.path, [spot.stage]):
            return ()
        for name in (
            want.facts.kind,
            *sorted(f"trait:{trait}" for trait in want.facts.traits),
            *sorted(want.facts.kinds),
        ):
            if self.plan.cooked_by.get(name):
                return self.plan.cooked_by[name]
        if form_of(self.known, want.label, want.leaf) == "liquid":
            return ()  # it would be poured away with the water
        return ("boil",)

    def _is_boiled(self, state: str) -> bool:
        """Whether a state is one that only cooking in water gives."""
        motions = {
            way[0] for way in self.bench.operators.ways.get("heat", ()) if state in self.known.motion(way[0]).gives
        }
        own = [motion for motion in motions if any(word.startswith(motion[:4]) for word in state.split())]
        return bool(own) and all("liquid" in self.known.motion(motion).does for motion in own)

    def _warmed_first(self, join: Join) -> tuple[str, ...]:
        """Return how a food is made warm by itself where it is asked so (melted): not where it comes into the heat."""
        state = join.want.make
        if not state or not self.known.state(state).needs_heat or not join.spot.stage.does.isdisjoint(_HEATS):
            return ()
        ways = [way for way in self.bench.operators.making(state) if self.known.motion(way[0]).does & _HEATS]
        found = self.bench.attest(
            [way for way in ways if way in self.bench.operators.giving.get(state, ())], join.want.names
        )
        return (found.way[0],) if found is not None else ()

    def _pours(self, want: Want) -> bool:
        """Whether a food is opened over the dish and runs into it: such food is cooked as fast as anything."""
        return "shell" in want.facts.owes and self.preparer.opening(want) is not None

    def _has_liquid(self, path: tuple[int, ...], stages: Sequence[Stage]) -> bool:
        for join in self.plan.joins:
            if join.want.facts.is_a("cooking liquid") and any(join.spot.stage is s for s in self._until(stages[-1])):
                return True
        return self._water_slot(stages)

    def _until(self, last: Stage) -> list[Stage]:
        found: list[Stage] = []

        def walk(line: Line) -> bool:
            for stage in line.stages:
                for add in stage.adds:
                    if isinstance(add, Line) and walk(add):
                        return True
                found.append(stage)
                if stage is last:
                    return True
            return False

        walk(self.line)
        return found

    def _water_slot(self, stages: Sequence[Stage]) -> bool:
        last = stages[-1]
        return any(slot.food == "water" for stage in self._until(last) for slot in stage.slots)

    def _cook_first(self, join: Join, method: Sequence[str]) -> None:
        ready = self.ready[join.want.number]
        liquid = any("liquid" in self.known.motion(motion).does for motion in method)
        liquid = (
            liquid
            or "boil" in owed(join.want, self.known)
            or (ready.whole_shell and form_of(self.known, join.want.label, join.want.leaf) == "whole")
        )
        if liquid:
            self._boil(ready)
        else:
            self._pan_cook(ready, method)
        if ready.whole_shell:
            ready.whole_shell = False
            self._cool(ready)
            self.preparer.shelled(ready, join.slot.states if join.slot else ())

    def _cool(self, ready: Ready) -> None:
        if ready.stuff.at is None:
            return
        attested = self.bench.require([(m, ()) for m in ("rinse", "wash")], ready.want.names)
        water = self.bench.fetch("water", ("liquid",), (), "faucet")
        stuff = ready.stuff
        states = tuple(sorted({*stuff.states, "washed"}))

        def change() -> None:
            stuff.states = states

        self.bench.emit(attested, [stuff.at, stuff, water], change, [stuff])

    def _boil(self, ready: Ready) -> None:
        bench, want = self.bench, ready.want
        pot = bench.vessel("pot")
        self._add_water(pot)
        device = bench.place(pot, "stove", "on")
        bench.switch(pot, device, on=True)
        self._bring(ready, pot, None)
        attested = bench.require([("boil", ()), ("cook", ()), ("simmer", ())], want.names)
        stuff = ready.stuff
        before = list(pot.contents)
        states = self._cooked_states(stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            pot.hot = True

        bench.emit(attested, [pot, (device, pot), *before], change, [pot, stuff])
        bench.switch(pot, device, on=False)
        strainer = bench.vessel("strainer")
        drained = bench.require([("drain", ()), ("pour", ())], want.names)

        def drain() -> None:
            pot.contents.clear()
            strainer.contents.append(stuff)
            stuff.at = strainer

        bench.emit(drained, [pot, stuff, strainer], drain, [strainer, stuff, pot])

    def _cooked_states(self, stuff: Stuff, want: Want, way: Way) -> tuple[str, ...]:
        kept = [s for s in stuff.states if not self._says_raw(s)]
        able = self.known.motion(way[0]).gives | {
            s for s in (want.make,) if way in self.bench.operators.giving.get(s, ())
        }
        if want.make in able and self.known.state(want.make).needs_heat:
            return tuple(sorted({*(kept if want.cooked else ()), want.make}))
        return tuple(sorted({*kept, "cooked"}))

    def _says_raw(self, state: str) -> bool:
        """Whether a state says that a food is as yet uncooked, or in one piece as it was bought."""
        row = self.known.state(state)
        return row.half or not {"raw", "uncooked", "frozen"}.isdisjoint(state.split())

    def _pan_cook(self, ready: Ready, method: Sequence[str]) -> None:
        bench, want = self.bench, ready.want
        pan = bench.vessel("cooking pan")
        device = bench.place(pan, "stove", "on")
        bench.switch(pan, device, on=True)
        self._bring(ready, pan, None)
        ways = [way for motion in (*method, "cook") for way in bench.operators.ways_of(motion)]
        attested = bench.require(ways, want.names)
        stuff = ready.stuff
        states = self._cooked_states(stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            pan.hot = True

        bench.emit(attested, [pan, (device, pan), stuff], change, [pan, stuff])
        bench.switch(pan, device, on=False)

    # --- lines ---

    def _alive(self, line: Line) -> bool:
        return any(
            self.at.get(id(stage)) or any(isinstance(add, Line) and self._alive(add) for add in stage.adds)
            for stage in line.stages
        )

    def _run(self, line: Line, *, main: bool = False, after: Sequence[Stage] = ()) -> Vessel | None:
        subs: dict[int, Vessel] = {}
        for place, stage in enumerate(line.stages):
            later = (*line.stages[place + 1 :], *after)
            for add in stage.adds:
                if isinstance(add, Line) and self._alive(add):
                    made = self._run(add, after=(stage, *later))
                    if made is not None:
                        subs[id(add)] = made
        vessel: Vessel | None = None
        oven = next(
            (
                label
                for stage in line.stages
                for label, relation in [self._device_for(stage)]
                if relation == "in" and "heat" in stage.does
            ),
            "",
        )
        for place, stage in enumerate(line.stages):
            later = (*line.stages[place + 1 :], *after)
            if (
                oven
                and any(self._device_for(one)[0] == oven for one in (stage, *line.stages[place + 1 : place + 2]))
                and self._preheats(oven)
            ):
                self.bench.switch(None, self.bench.device(oven), on=True)  # it is hot when the dish comes in
                oven = ""
            vessel = self._stage(stage, vessel, subs, later, main=main)
        if vessel is not None:
            self._heat_off(vessel)
        return vessel

    def _preheats(self, label: str) -> bool:
        row = self.known.utensil(label)
        return row is not None and row.source == "heat" and label not in self.bench.devices

    def _stage(
        self, stage: Stage, vessel: Vessel | None, subs: dict[int, Vessel], later: Sequence[Stage], *, main: bool
    ) -> Vessel | None:
        joins = self._ordered(stage)
        lines = [subs[id(add)] for add in stage.adds if isinstance(add, Line) and id(add) in subs]
        if vessel is None and not joins and not lines:
            return None
        device, relation = self._device_for(stage)
        label = self._vessel_label(stage, vessel, device)
        vessel = self._vessel_for(stage, label, vessel, lines, joins)
        heats = bool(device) and (not stage.does.isdisjoint(_HEATS) or stage.source == "heat")
        if (
            vessel.device is not None
            and (not heats or vessel.device.label != device)
            and not self._heats_on(stage, later, vessel)
        ):
            self._heat_off(vessel)
        if heats and relation == "on" and (vessel.device is None or vessel.device.label != device):
            self.bench.place(vessel, device, relation)
        self._add_all(stage, vessel, joins, lines, heats=heats, relation=relation, later=later, main=main)
        if not vessel.contents:
            return None
        self._work(stage, vessel, device, relation, later, main=main)
        return vessel

    def _goes_on(self, stage: Stage, following: Stage) -> bool:
        """Whether the next stage only goes on with what this one does: once is enough."""
        if self._stage_alive(following) or stage.vessel != following.vessel or stage.appliance != following.appliance:
            return False
        kinds = (frozenset({"heat"}), _MIXES)
        mine = next((kind for kind in kinds if stage.does & kind), None)
        return mine is not None and bool(following.does & mine) and not stage.does & {"dry", "shape", "knead", "blend"}

    def _heats_on(self, stage: Stage, later: Sequence[Stage], vessel: Vessel) -> bool:
        """Whether a vessel stays over the heat: the next heating is on the same appliance."""
        if vessel.device is None or stage.vessel not in {vessel.label, ""} or "cut" in stage.does:
            return False
        for one in later:
            if one.source == "heat" and not one.does.isdisjoint(_HEATS):
                return one.appliance == vessel.device.label and one.vessel in {vessel.label, ""}
            if one.vessel not in {vessel.label, ""}:
                return False
        return False

    def _device_for(self, stage: Stage) -> tuple[str, str]:
        over_heat = stage.source == "heat" and not stage.does.isdisjoint({"mix", "turn"})
        if stage.does.isdisjoint(_HEATS | {"blend", "wait"}) and stage.source != "power" and not over_heat:
            return "", ""
        row = self.known.utensil(stage.appliance) if stage.appliance else None
        if not stage.does.isdisjoint(_HEATS):
            if row is None or row.source != "heat":
                row = self.known.utensil("oven" if "dry" in stage.does else "stove")
        if row is None or row.role != "appliance":
            return "", ""
        if row.source == "power":
            used = (self.known.utensil(label) for label in self.bench.devices)
            row = next((other for other in used if other is not None and other.group == row.group), row)
        if row.source == "power" and not row.holds:
            return row.name, ""
        if "wait" in stage.does and row.source != "cold":
            return "", ""
        holds = "attached to" if row.holds == "attached" else row.holds
        return row.name, holds

    def _vessel_label(self, stage: Stage, vessel: Vessel | None, device: str) -> str:
        row = self.known.utensil(stage.vessel) if stage.vessel else None
        fits = row is not None and row.role in {"vessel", "wrap"}
        if device and fits and row is not None:
            appliance = self.known.utensil(device)
            if appliance is not None and appliance.source == "heat":
                able = {"in": {"bake", "microwave"}, "on": {"heat", "cook"}}.get(appliance.holds, set())
                fits = bool(row.can & able)
        if fits:
            return stage.vessel
        if device:
            appliance = self.known.utensil(device)
            if appliance is not None and appliance.source == "heat":
                if vessel is not None and self._can_stand(vessel.label, device):
                    return vessel.label
                if appliance.holds == "in":
                    return "baking tray"
                return "pot" if "liquid" in stage.does else "cooking pan"
        return vessel.label if vessel is not None else "bowl"

    def _can_stand(self, label: str, device: str) -> bool:
        row, appliance = self.known.utensil(label), self.known.utensil(device)
        if row is None or appliance is None:
            return False
        return bool(row.can & ({"bake", "microwave"} if appliance.holds == "in" else {"heat", "cook"}))

    def _vessel_for(
        self, stage: Stage, label: str, vessel: Vessel | None, lines: list[Vessel], joins: Sequence[Join]
    ) -> Vessel:
        if vessel is None:
            if lines and lines[0].label == label and lines[0].device is None:
                return lines.pop(0)
            for join in joins:
                own = self.ready[join.want.number].stuff.at
                if own is not None and own.label == label and not own.storage and len(own.contents) == 1:
                    return own  # it was cooked in such a pan before, and the rest comes to it
            return self.bench.vessel(label)
        if vessel.label == label:
            return vessel
        self._heat_off(vessel)
        fresh = self.bench.vessel(label)
        grease = [join for join in joins if join.want.facts.is_a("fat")]
        device, relation = self._device_for(stage)
        if device and relation == "on":
            self.bench.place(fresh, device, relation)
        if not grease:
            self._grease(fresh, vessel)
        for join in grease:
            self._bring(self.ready[join.want.number], fresh, join.slot)
            self.at[id(stage)].remove(join)
            joins.remove(join)  # type: ignore[attr-defined]
        self._transfer(vessel, fresh, stage)
        return fresh

    def _grease(self, fresh: Vessel, vessel: Vessel) -> None:
        """Grease a tin for batter or dough, with some of the fat that was asked for."""
        row = self.known.utensil(fresh.label)
        if row is None or "bake" not in row.can or row.can & {"heat"}:
            return
        soft = any(
            stuff.mixed and any(self.known.foods.food(f).is_a("flour", "dough", "egg") for f in stuff.foods)
            for stuff in vessel.contents
        )
        fat = next((j.want for j in self.plan.joins if j.want.facts.is_a("fat") and j.want.facts.is_a("stock")), None)
        if not soft or fat is None:
            return
        stuff = self.bench.fetch(fat.label, fat.leaf, [fat.number], fat.storage)
        self._bring(Ready(fat, stuff), fresh, None)

    def _transfer(self, source: Vessel, target: Vessel, stage: Stage) -> None:
        """Bring all that is in one vessel into another."""
        stuffs = list(source.contents)
        foods = foods_of(source)
        runs = len(stuffs) > 1 or any(
            form_of(self.known, stuff.label, stuff.states) in {"liquid", "soft"} or self._is_wet(stuff)
            for stuff in stuffs
        )
        usual = self.bench.operators.brings("liquid" if runs else "pieces", "vessel")
        ways: list[Way] = []
        if (
            stage.motion
            and self._pure((stage.motion, stage.tools))
            and (not runs or (stage.motion, ()) in usual or (stage.motion, stage.tools) in usual)
        ):
            ways.append((stage.motion, stage.tools))
        ways += [way for way in usual if self._pure(way)]
        attested = self.bench.attest(ways[:1], foods) or self.bench.require(ways, foods)
        self.bench.bring(stuffs, target, attested)

    def _is_wet(self, stuff: Stuff) -> bool:
        """Whether a mixture runs: it has liquid in it that was not baked away."""
        if not stuff.mixed or "baked" in stuff.states:
            return False
        foods = [self.known.foods.food(food) for food in stuff.foods]
        if any(self.known.state(state).needs_heat for state in stuff.states):
            sets = any(food.is_a("egg", "flour", "dough") for food in foods)  # what ran is solid now
            return not sets and any(food.is_a("liquid", "creamy") for food in foods)
        return any(food.is_a("liquid", "creamy", "water", "egg") for food in foods)

    def _pure(self, way: Way) -> bool:
        does = self.known.motion(way[0]).does
        return bool(does) and does <= _MOVES and way[0] not in {"throw away", "remove", "measure", "scoop"}

    def _add_all(
        self, stage: Stage, vessel: Vessel, joins: Sequence[Join], lines: Sequence[Vessel], *,
        heats: bool, relation: str, later: Sequence[Stage], main: bool,
    ) -> None:  # fmt: skip
        on_stove = heats and vessel.device is not None and relation == "on"
        stuffs: list[Join | Vessel] = []
        waiting = list(lines)
        by_line = [add for add in stage.adds if isinstance(add, Line)]
        first_line = min((stage.adds.index(add) for add in by_line), default=len(stage.adds))
        for join in joins:
            before = join.slot is not None and join.slot in stage.adds and stage.adds.index(join.slot) < first_line
            if waiting and not before and not (heats and join.want.facts.is_a("fat")):
                stuffs += waiting
                waiting = []
            stuffs.append(join)
        stuffs += waiting
        water = self._water(stage, vessel, later)
        if water:
            self._add_water(vessel)
        for number, one in enumerate(stuffs):
            last = number == len(stuffs) - 1
            merge = self._merges(stage, later, main=main) and last
            fat = isinstance(one, Join) and one.want.facts.is_a("fat")
            if on_stove and not fat and (vessel.contents or number > 0):
                self._heat_on(vessel)
            if isinstance(one, Vessel):
                self._heat_off(one)
                if not vessel.contents:
                    self._grease(vessel, one)
                self._transfer(one, vessel, stage)
            else:
                self._bring(self.ready[one.want.number], vessel, one.slot)
            if merge and self._lies_unmixed(vessel):
                attested = self._stirring(foods_of(vessel))
                self.bench.work(vessel, attested, self.plan.label, self._kept_states(vessel), with_device=False)
            elif merge and (main or len(vessel.contents) > 1):
                self._name(vessel, self.plan.label if main else self._label(stage, vessel))
        if on_stove:
            self._heat_on(vessel)

    def _merges(self, stage: Stage, later: Sequence[Stage], *, main: bool) -> bool:
        """Whether nothing mixes the whole any more, so that what joins last completes it."""
        works = [stage, *later]
        return (
            main
            and not any(self._mixing(one) for one in works)
            and not any(one.adds for one in later if self._stage_alive(one))
        )

    def _lies_unmixed(self, vessel: Vessel) -> bool:
        """Whether something lies beside what was mixed before, uncooked, in a vessel in which it can be stirred."""
        mixed = [s for s in vessel.contents if s.mixed and not {"blended", "mixed"}.isdisjoint(s.states)]
        cooked = any(self.known.state(state).needs_heat for stuff in mixed for state in stuff.states)
        beside = [stuff for stuff in vessel.contents if stuff not in mixed]
        tops = all(self.known.foods.food(stuff.label).is_a("topping") for stuff in beside)
        return bool(mixed) and not tops and not cooked and not is_flat(vessel.label)

    def _stage_alive(self, stage: Stage) -> bool:
        return bool(self.at.get(id(stage))) or any(isinstance(add, Line) and self._alive(add) for add in stage.adds)

    def _mixing(self, stage: Stage) -> bool:
        return bool(stage.motion) and not stage.does.isdisjoint(_MIXES | _HEATS)

    def _name(self, vessel: Vessel, label: str) -> None:
        """Let the last step tell what is in a vessel as one thing."""
        last = self.bench.done[-1]
        if len(vessel.contents) == 1 and vessel.contents[0].label == label:
            return
        whole = self._whole(vessel, label, self._kept_states(vessel))
        numbers = {stuff.number for stuff in vessel.contents}
        before = {mention.thing for mention in last.step.inputs}
        others = [stuff for stuff in vessel.contents if stuff.number not in before]
        vessel.contents[:] = [whole]
        outputs = [m for m in last.step.outputs if m.thing not in numbers and m.thing != vessel.number]
        inputs = [*last.step.inputs]
        shown = {mention.thing for mention in inputs}
        for stuff in others:
            if stuff.number not in shown:
                inputs.append(self.bench.mention(stuff))
        step = replace(
            last.step, inputs=tuple(inputs), outputs=(self.bench.mention(vessel), self.bench.mention(whole), *outputs)
        )
        self.bench.done[-1] = replace(last, step=step)

    def _kept_states(self, vessel: Vessel) -> tuple[str, ...]:
        mixed = [stuff for stuff in vessel.contents if stuff.mixed]
        states = mixed[0].states if len(mixed) == 1 else ()
        return tuple(s for s in states if not self.known.state(s).half)

    def _whole(self, vessel: Vessel, label: str, states: tuple[str, ...]) -> Stuff:
        foods = tuple(sorted({food for stuff in vessel.contents for food in stuff.foods}))
        wants = frozenset().union(*(stuff.wants for stuff in vessel.contents))
        return Stuff(label, self.bench.number(), states, foods, wants, vessel, mixed=True)

    def _water(self, stage: Stage, vessel: Vessel, later: Sequence[Stage]) -> bool:
        """Whether free water joins here: the frame has it, nobody asked for any, and no other liquid takes its place."""
        if not any(slot.food == "water" for slot in stage.slots):
            return False
        if any(join.want.facts.is_a("water") for join in self.plan.joins):
            return False
        liquids = [join for join in self.plan.joins if join.want.facts.is_a("cooking liquid")]
        return not any(join.spot.stage is stage for join in liquids)

    def _add_water(self, vessel: Vessel) -> None:
        water = self.bench.fetch("water", ("liquid",), (), "faucet")
        attested = self.bench.require([("pour", ()), ("fill", ())], ("water",))
        self.bench.bring([water], vessel, attested)

    def _bring(self, ready: Ready, vessel: Vessel, slot: Slot | None) -> None:
        if ready.whole_shell and not any(stuff.label == "water" for stuff in vessel.contents):
            self._open_into(ready, vessel)
            return
        stuff, want = ready.stuff, ready.want
        source = stuff.at
        if source is vessel:
            return
        role = "" if source is None else ("storage" if source.storage else "vessel")
        usual = self.bench.operators.brings(form_of(self.known, want.label, stuff.states), role)
        groups: list[list[Way]] = [self._by_store(usual, stuff, source)]
        if slot is not None and (slot.motion, slot.tools) in usual:
            groups.append([(slot.motion, slot.tools)])
        for name in (*want.names, f"kind:{want.facts.kind}"):
            counts = self.bench.operators.bringing.get((name, role), {})
            ways = sorted((way for way in counts if way in usual and counts[way] > 1), key=lambda w: (-counts[w], w))
            groups.append([way for way in ways if self._pure(way)])
        groups.append([way for way in usual if self._pure(way)])
        attested: Attested | None = None
        for group in groups:
            found = self.bench.attest(group, stuff.foods)
            if found is not None and (attested is None or found.nearness < attested.nearness):
                attested = found
            if attested is not None:
                break
        if attested is None:
            attested = self.bench.require(groups[-1] or [("pick-and-place", ()), ("pour", ())], stuff.foods)
        self.bench.bring([stuff], vessel, attested)

    def _by_store(self, usual: Sequence[Way], stuff: Stuff, source: Vessel | None) -> list[Way]:
        """Return the usual ways that the thing from which a food comes asks for: a mill strews, a tub is scooped out."""
        if source is None or not source.storage:
            return []
        row = self.known.utensil(source.label)
        motions: frozenset[str] = frozenset()
        if row is not None and row.group in word_list("strews"):
            motions = word_list("is strewn by")
        elif not word_list("is scooped").isdisjoint(stuff.states):
            motions = word_list("is scooped by")
        return [way for way in usual if way[0] in motions]

    # --- heat and work ---

    def _heat_on(self, vessel: Vessel) -> None:
        if vessel.device is not None:
            self.bench.switch(vessel, vessel.device, on=True)

    def _heat_off(self, vessel: Vessel) -> None:
        device = vessel.device
        if device is None:
            return
        self.bench.switch(vessel, device, on=False)
        if vessel.relation != "on":
            self.bench.take_off(vessel)
            self.bench.uncover(vessel)

    def _work(
        self, stage: Stage, vessel: Vessel, device: str, relation: str, later: Sequence[Stage], *, main: bool
    ) -> None:
        if not stage.motion or stage.does.isdisjoint(_WORKS):
            return
        mixes = not stage.does.isdisjoint(_MIXES)
        heats = not stage.does.isdisjoint(_HEATS)
        single = len(vessel.contents) == 1 and not vessel.contents[0].mixed
        if later and self._goes_on(stage, later[0]):
            return
        if all(self.known.foods.food(food).is_a("fat") for food in foods_of(vessel)) and later:
            return  # fat alone is only made hot
        if single and mixes and not heats and stage.does <= {"mix"}:
            return
        if not mixes and not heats and "wait" not in stage.does and single:
            return
        if device and not relation:
            self._by_hand_device(stage, vessel, device, later, main=main)
            return
        if device and (vessel.device is None or vessel.device.label != device):
            self._into_device(vessel, device, relation)
        if vessel.device is not None and not self.bench.is_running(vessel) and vessel.device.label == device:
            self._heat_on(vessel)
        attested = self._way(stage, vessel)
        if attested is None:
            return
        finished = not any(not one.does.isdisjoint(_HEATS) for one in later)
        label = self._label(stage, vessel, last=main and not any(self._mixing(one) for one in later), main=main)
        product = bool(label) or (mixes and not heats)
        states = self._states(stage, vessel, attested.way, product=product, finished=finished)
        if (
            product
            and len(vessel.contents) == 1
            and vessel.contents[0].label == (label or "mixture")
            and vessel.contents[0].states == states
        ):
            return
        if product:
            self.bench.work(vessel, attested, label or "mixture", states, with_device=bool(device))
        else:
            self._work_each(vessel, attested, states, with_device=bool(device))
        if vessel.device is not None and vessel.relation != "on":
            nxt = next((one for one in later if not one.does.isdisjoint(_HEATS)), None)
            if (
                nxt is None
                or nxt.appliance != vessel.device.label
                or nxt.vessel not in {vessel.label, ""}
                or any(one.adds for one in later)
            ):
                self._heat_off(vessel)

    def _by_hand_device(self, stage: Stage, vessel: Vessel, device: str, later: Sequence[Stage], *, main: bool) -> None:
        """Work with an appliance that is held in the hand."""
        attested = self._way(stage, vessel)
        if attested is None:
            return
        machine = self.bench.device(device)
        self.bench.switch(None, machine, on=True)
        label = self._label(stage, vessel, last=main and not any(self._mixing(one) for one in later), main=main)
        states = self._states(stage, vessel, attested.way, product=True, finished=False)
        self.bench.work(vessel, attested, label or "mixture", states, extra=machine)
        self.bench.switch(None, machine, on=False)

    def _work_each(self, vessel: Vessel, attested: Attested, states: tuple[str, ...], *, with_device: bool) -> None:
        stuffs = list(vessel.contents)
        device = vessel.device if with_device else None

        def change() -> None:
            for stuff in stuffs:
                kept = [s for s in stuff.states if not self._says_raw(s)]
                facts = self.known.foods.food(stuff.label)
                melts = facts.is_a("fat") and not facts.is_a("liquid") and not stuff.mixed
                stuff.states = ("melted",) if melts and device is not None else tuple(sorted({*kept, *states}))
            vessel.hot = vessel.hot or device is not None

        self.bench.emit(attested, [vessel, *([(device, vessel)] if device else []), *stuffs], change, [vessel, *stuffs])

    def _into_device(self, vessel: Vessel, device: str, relation: str) -> None:
        row = self.known.utensil(device)
        if row is not None and row.source == "heat" and relation == "in":
            self.bench.switch(None, self.bench.device(device), on=True)
        if relation == "attached to" or (row is not None and row.source == "power"):
            lid = f"{device} lid"
            if self.known.utensil(lid) is not None and vessel.label != "bowl":
                self.bench.cover(vessel, lid)
        self.bench.place(vessel, device, relation)

    def _way(self, stage: Stage, vessel: Vessel) -> Attested | None:
        foods = foods_of(vessel)
        if stage.motion in word_list("needs a closed vessel") and not self._is_closed(vessel):
            return self._stirring(foods)
        if "heat" in stage.does and "heat" not in self.known.motion(stage.motion).does:
            both = [
                way
                for way in self.bench.operators.ways.get("heat", ())
                if self.known.motion(way[0]).does == {"heat", "mix"}
            ]
            return self.bench.require(both, foods)
        mixes_by_hand = (
            not stage.tools
            and vessel.device is None
            and stage.does & {"mix", "whip", "mash"}
            and not stage.does & {"shape", "knead"}
        )
        if mixes_by_hand and not stage.appliance:
            tooled = [way for way in self.bench.operators.ways_of(stage.motion) if way[1]]
            found = self.bench.attest(tooled, foods)
            if found is not None and found.nearness <= Nearness.LIKE:
                return found
        own = self.bench.attest([(stage.motion, stage.tools)], foods)
        if own is not None and own.nearness <= Nearness.LIKE:
            return own
        found = self.bench.attest(self.bench.operators.ways_of(stage.motion), foods)
        if found is not None and (own is None or found.nearness < own.nearness):
            return found
        if own is not None:
            return own
        main = "heat" if "heat" in stage.does else next(iter(sorted(stage.does & _WORKS)), "")
        ways = [way for way in self.bench.operators.ways.get(main, ()) if self.known.motion(way[0]).does == stage.does]
        found = self.bench.attest(ways, foods)
        if found is None and not stage.does.isdisjoint(_MIXES | _HEATS):
            raise RefusedError(f"nothing attests “{stage.motion}” for {', '.join(foods)}")
        return found

    def _is_closed(self, vessel: Vessel) -> bool:
        return bool(vessel.lid) or vessel.label in word_list("closed vessels")

    def _stirring(self, foods: Sequence[str]) -> Attested:
        """Return the likeliest way to mix foods through with a tool, as they are."""
        ways = [way for way in self.bench.operators.ways.get("mix", ()) if way[1]]
        return self.bench.require([way for way in ways if self.known.motion(way[0]).does == {"mix"}], foods)

    def _label(self, stage: Stage, vessel: Vessel, *, last: bool = False, main: bool = False) -> str:
        """Return what the whole is called after a stage: as in the frame where that is true of what is in it."""
        if last:
            return self.plan.label
        label = stage.label
        if label == self.plan.goal and main and not stage.does.isdisjoint(_HEATS):
            return self.plan.label
        facts = self.known.foods.food(label, stage.states)
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        if not label or label in self.known.dishes or not facts.is_a("made", "dough"):
            return ""
        if not all(
            any(meets(need, food, self.known) for need in needs for food in foods)
            for needs in self.known.contains.get(label, ())
        ):
            return ""
        names = {word for food in foods for word in food.name.split()}
        named = [
            w
            for w in label.split()
            if self.known.foods.is_listed(w) and not self.known.foods.food(w).is_a("made", "dough")
        ]
        return label if all(w in names for w in named) else ""

    def _states(self, stage: Stage, vessel: Vessel, way: Way, *, product: bool, finished: bool) -> tuple[str, ...]:
        does = self.known.motion(way[0]).does
        states: set[str] = set()
        kept = {s for stuff in vessel.contents if stuff.mixed for s in stuff.states if s in {"mixed", "blended"}}
        if "turn" in does and does.isdisjoint(_HEATS) and len(vessel.contents) == 1:
            return tuple(sorted({*vessel.contents[0].states, "flipped"}))
        if product and len(vessel.contents) == 1:
            states |= kept
        if ("blend" in does and "mix" not in stage.does) or way[0] == "blend":
            states.add("blended")
        elif not does.isdisjoint({"mix", "whip"}):
            states.add("mixed")
        if "knead" in does:
            states.add("kneaded")
        if "dry" in does:
            states.add("baked")
        elif "heat" in does and "cooked" in self.known.motion(way[0]).gives:
            states.add("cooked" if finished else "partly cooked")
        elif "warm" in does:
            states.add("heated")
        if "wait" in does:
            states |= {"chilled"} if way[0] == "chill" else {"rested"}
        if not states and stage.motion:
            able = sorted(s for s in stage.states if s in self.known.motion(way[0]).gives)
            states |= set(able[:1])
        if not does.isdisjoint({"shape", "turn", "cut"}) and does.isdisjoint(_HEATS):
            known = {s for stuff in vessel.contents for s in stuff.states}
            given = self.bench.operators.giving
            able = [s for s in given if way in given[s] and s in self.known.motion(way[0]).gives]
            able = sorted(s for s in able if not self.known.state(s).needs_heat)
            states |= known | set(able[:1])
        return tuple(sorted(states))

    def _finish(self, vessel: Vessel) -> None:
        """Turn everything off, and let what is in the vessel be the dish."""
        self._heat_off(vessel)
        self.bench.all_off()
