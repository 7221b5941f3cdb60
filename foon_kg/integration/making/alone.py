"""Foods that are cooked, beaten or measured by themselves before they join the others."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff
from foon_kg.integration.composing.coated import is_portion
from foon_kg.integration.joining.course import HEATS, MIXES, Course
from foon_kg.integration.joining.spots import Join, Spot
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.preparing.preparation import Ready, Want, owed
from foon_kg.integration.preparing.preparer import Preparer
from foon_kg.integration.teaching.frames import Phase, Stage
from foon_kg.integration.teaching.operators import Attested, Nearness, Way, form_of

_MUCH_ALIKE = 0.8
_POWDER = 5
_BOILED = word_list("is so by boiling")


class Alone:
    """Cooks single foods on a bench. ``ready`` are the prepared foods by the numbers of what was asked."""

    def __init__(
        self, bench: Bench, course: Course, preparer: Preparer, carry: Carrier, ready: dict[int, Ready]
    ) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.course = course
        self.plan = course.plan
        self.preparer = preparer
        self.carry = carry
        self.ready = ready

    def measure(self, ready: Ready) -> None:
        """Fetch water before anything is hot."""
        if ready.stuff.at is not None and ready.stuff.at.storage:
            cup = self.bench.vessel("measuring cup")
            attested = self.bench.attest([("pour", ())], ready.want.names)
            if attested is not None:
                self.bench.bring([ready.stuff], cup, attested)

    def boil_water_first(self, join: Join) -> None:
        """Boil water that is asked boiling and joins what nobody heats any more."""
        want, ready = join.want, self.ready[join.want.number]
        hot = any(
            not stage.does.isdisjoint(HEATS) and "dry" not in stage.does
            for stage in (join.spot.stage, *join.spot.after)
        )
        if hot or not want.facts.is_a("water") or want.asked not in word_list("is boiled water"):
            return
        pot = self.bench.vessel("pot")
        self.carry.bring(ready, pot, None)
        self.bench.place(pot, "stove", "on")
        self.carry.boil_water(pot)
        self.bench.heat_off(pot)
        beside = [one.want.facts for one in self.plan.joins if one.spot.stage is join.spot.stage]
        if any(facts.is_a(*word_list("makes dough rise")) for facts in beside):
            self.bench.let_cool(pot, ready.stuff, want.names)  # it would kill what makes it rise

    def beaten_first(self, join: Join, ready: Ready) -> None:
        """Open a food over a bowl of its own and beat it, where it is asked or joins so and is not beaten later."""
        if not ready.whole_shell:
            return
        stage, want = join.spot.stage, join.want
        beaten = [
            s
            for s in (want.make, *(join.slot.states if join.slot else ()))
            if s and "shell" in self.known.state(s).earns and not self.known.state(s).needs_heat
        ]
        heats = not stage.does.isdisjoint(HEATS)
        mixes = not stage.does.isdisjoint(MIXES) and not heats
        if not (want.make or (beaten and not mixes)):
            return
        if not any(s for s in beaten if self._beating(want, s)):
            return
        state = next(s for s in beaten if self._beating(want, s))
        bowl = self.bench.vessel("bowl")
        self.carry.open_into(ready, bowl)
        attested = self._beating(want, state)
        if attested is not None:
            self.bench.work(bowl, attested, want.label, (state,), with_device=False)
            ready.stuff = bowl.contents[0]

    def beat_to_foam(self, ready: Ready) -> None:
        """Pour a liquid into a bowl of its own and whip it: that is done last, as the foam falls."""
        want, bowl = ready.want, self.bench.vessel("bowl")
        ways = [way for way in self.bench.operators.making(want.make) if "whip" in self.known.motion(way[0]).does]
        attested = self.bench.attest(ways, want.names) or self.bench.far(ways, want.names)
        if attested is None:
            ready.assumptions.append(f"no step of this FOON makes {want.label} {want.make}: it is bought so")
            return
        self.bench.bring([ready.stuff], bowl, self.bench.require([("pour", ())], want.names))
        self.bench.work(bowl, attested, want.label, (want.make,), with_device=False)
        ready.stuff = bowl.contents[0]

    def _beating(self, want: Want, state: str) -> Attested | None:
        motion = self.known.motion
        ways = [way for way in self.bench.operators.making(state) if motion(way[0]).does <= {"mix", "whip"} and way[1]]
        ways.sort(key=lambda way: "whip" not in motion(way[0]).does)
        return self.bench.attest(ways, want.names)

    def is_asked_done(self, want: Want) -> bool:
        """Whether a recipe begins with meat or fish that was cooked before: then it is boiled by itself, and cut."""
        return want.make in word_list("begins cooked") and want.facts.is_a(*word_list("is flesh"))

    def cooked_first(self, join: Join) -> tuple[str, ...]:
        """Return the motions by which a food is cooked by itself before it joins; nothing where the dish cooks it."""
        want, spot = join.want, join.spot
        due = {"cook", "boil"} & owed(want, self.known)
        first = self._made_otherwise(join) if due or want.cooked else self._warmed_first(join)
        before = want.cooked and want.asked in word_list("only what was cooked is so") and not self._pours(want)
        if first or before or not (due or want.cooked):
            return first or (self._usual_cooking(want) if before else ())
        in_turn = isinstance(spot.stage, Phase) and "boil" not in due and not want.cooked and not want.then
        in_turn = in_turn and not self._is_cut_of_its_shell(want) and not self.preparer.is_mashed_raw(want)
        if in_turn or not self.plan.eased.isdisjoint({want.facts.kind, *want.facts.kinds}):
            return ()
        told = join.slot.cooked if join.slot is not None and self._is_the_same(join) else ()
        if self._is_cut_of_its_shell(want):
            told = ("boil",)
        if self.is_fried_open(want) and not self._cooks_such(spot):
            told = ("cook",)
        if told or want.then or self.preparer.is_mashed_raw(want) or (due and self.is_asked_done(want)):
            fried = want.facts.is_a(*word_list("is fried rather than boiled")) and not want.then
            return told or (("cook",) if fried else ("boil",))
        heats = [stage for stage in (spot.stage, *spot.after) if "heat" in stage.does]
        if self._is_boiled_there(join, heats, due):
            return ()
        boiled = want.cooked and self._is_boiled(want.make) and not any("liquid" in stage.does for stage in heats)
        thick = self.plan.laid and want.facts.is_a(*word_list("is flesh"))  # it would be raw when the dough is done
        done_there = heats and self._cooks_there(join, due) and not self._is_toasted(join) and not thick
        if boiled or "boil" in due:
            return ("boil",)
        return () if done_there else self._asked_cooking(want) or self._usual_cooking(want)

    def _made_otherwise(self, join: Join) -> tuple[str, ...]:
        """Return how a food is cooked for which neither its video nor its kind is asked.

        What a title calls roasted is baked, flesh for a salad fried whole, and what is divided then as it is asked.
        """
        want, spot = join.want, join.spot
        if want.roasted and not any("dry" in stage.does for stage in (spot.stage, *spot.after)):
            return tuple(sorted(word_list("is roasted by")))
        if want.cooked and want.then:
            return self._to_be_divided(want)
        heats = [stage for stage in (spot.stage, *spot.after) if not stage.does.isdisjoint(HEATS)]
        pan = bool(heats) and "dry" not in heats[0].does and not self.course.has_liquid(heats[:1])
        if pan and self._is_thick(want):
            return ("boil",)  # it would be brown outside and raw within
        if isinstance(spot.stage, Phase) and self._takes_longer(want):
            return ("boil",)  # the grain would be mush when it is done
        whole = self.plan.in_pieces and is_portion(want, self.known)
        return ("cook",) if whole and not self.course.has_liquid([spot.stage]) else ()

    def _to_be_divided(self, want: Want) -> tuple[str, ...]:
        """Return how a food is cooked that is cut or mashed then: as it is asked, else in water to be mashed."""
        mashed = want.then in word_list("only what is soft is so") and want.make in word_list("begins cooked")
        if mashed or not want.make or self._is_boiled(want.make):
            return ("boil",)
        return self._asked_cooking(want) or self._usual_cooking(want)

    def _takes_longer(self, want: Want) -> bool:
        """Whether pulses are asked beside grain that is done long before them; in a soup they have all the time."""
        facts = [join.want.facts for join in self.plan.joins]
        others = (one for one in facts if not one.is_a(*word_list("takes longer than the rest")))
        quick = any(one.is_a(*word_list("is toasted")) for one in others)
        slow = want.facts.is_a(*word_list("takes longer than the rest")) and "boil" in want.facts.owes
        return slow and quick and not self.plan.spooned

    def _is_thick(self, want: Want) -> bool:
        """Whether a food is asked in such large pieces that it takes very long in a pan."""
        halved = bool(want.make) and self.known.state(want.make).fine == 1
        return halved and want.facts.is_a(*word_list("takes long in the pan"))

    def _is_boiled_there(self, join: Join, heats: Sequence[Stage], due: set[str]) -> bool:
        """Whether a food gets done in the liquid of the dish."""
        want, stage = join.want, join.spot.stage
        if isinstance(stage, Phase) and (want.cooked or not (stage.bath or self.course.swells_there(join))):
            return False
        bath = [stage for stage in heats if "dry" not in stage.does]
        by_itself = want.facts.is_a(*word_list("is boiled by itself")) and not self.plan.one_pot
        drained = any("liquid" in stage.does and "water" in {s.food for s in stage.slots} for stage in heats)
        return "boil" in due and bool(bath) and self.course.has_liquid(bath) and (drained or not by_itself)

    def is_fried_open(self, want: Want) -> bool:
        """Whether a food that runs out of its shell is asked done as only a pan does it."""
        return want.make in word_list("is done in a pan") and self._pours(want)

    def _cooks_such(self, spot: Spot) -> bool:
        """Whether the dish itself cooks what joins there."""
        return any(not stage.does.isdisjoint(HEATS) for stage in (spot.stage, *spot.after))

    def _is_the_same(self, join: Join) -> bool:
        """Whether a food is so much like that of its slot that it is cooked as that one is."""
        return join.slot is not None and (join.slot.kind == join.want.facts.kind or join.fit >= _MUCH_ALIKE)

    def _is_cut_of_its_shell(self, want: Want) -> bool:
        """Whether a food that runs out of its shell is asked in pieces or peeled: it is boiled in its shell."""
        fine = self.known.state(want.make).fine or 0 if want.make else 0
        peeled = want.asked in word_list("has no shell any more")
        return (peeled or 0 < fine < _POWDER) and self._pours(want)

    def _asked_cooking(self, want: Want) -> tuple[str, ...]:
        """Return the motions that give a food the cooked state in which it is asked (fried), as the FOON shows."""
        if not want.cooked:
            return ()
        ways = [way for way in self.bench.operators.giving.get(want.make, ()) if self._is_simple_heat(way)]
        found = self.bench.attest(ways, want.names, act=True)
        return (found.way[0],) if found is not None and found.nearness <= Nearness.LIKE else ()

    def _is_simple_heat(self, way: Way) -> bool:
        does = self.known.motion(way[0]).does
        return "heat" in does and "dry" not in does and does <= {"heat", "fat", "liquid", "mix"}

    def _cooks_there(self, join: Join, due: set[str]) -> bool:
        """Whether a food gets done where it joins, and is not only warmed up there with foods that are done."""
        quick = join.spot.post[0] == "heat" and join.slot is None and "cook" in due and not self._pours(join.want)
        return not quick or self.course.has_liquid([join.spot.stage])

    def _usual_cooking(self, want: Want) -> tuple[str, ...]:
        """Return how such foods are cooked by themselves in this FOON."""
        traits = sorted(f"trait:{trait}" for trait in want.facts.traits)
        for name in (want.facts.kind, *traits, *sorted(want.facts.kinds)):
            if self.plan.cooked_by.get(name):
                return self.plan.cooked_by[name]
        if form_of(self.known, want.label, want.leaf) == "liquid":
            return ()  # it would be poured away with the water
        fat = any(one.want.facts.is_a("fat") for one in self.plan.joins)
        soft = not want.facts.is_a(*word_list("is boiled rather than fried")) and "shell" not in want.facts.owes
        return ("cook",) if fat and soft else ("boil",)

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
        hot = not join.spot.stage.does.isdisjoint(HEATS) and not self._is_toasted(join)
        if not state or not self.known.state(state).needs_heat or hot:
            return ()
        ways = [way for way in self.bench.operators.making(state) if self.known.motion(way[0]).does & HEATS]
        given = [way for way in ways if way in self.bench.operators.giving.get(state, ())]
        if state in word_list("is only made warm"):
            given = [way for way in ways if self.known.motion(way[0]).does == {"heat"} and not way[1]]
        found = self.bench.attest(given, join.want.names) or self.bench.far(given[:1], join.want.names)
        return (found.way[0],) if found is not None else ()

    def _is_toasted(self, join: Join) -> bool:
        """Whether a food that is eaten as it is would not turn out as asked among what is cooked there."""
        return (
            isinstance(join.spot.stage, Phase)
            and join.want.facts.traits >= {"ready", "stock"}
            and not (join.want.facts.is_a("fat"))
        )

    def _pours(self, want: Want) -> bool:
        """Whether a food is opened over the dish and runs into it: such food is cooked as fast as anything."""
        return "shell" in want.facts.owes and self.preparer.opening(want) is not None

    def cook_first(self, join: Join, method: Sequence[str]) -> None:
        """Cook a prepared food by itself with the first of these motions that suits it, and open it where it is due."""
        ready = self.ready[join.want.number]
        if self.is_fried_open(join.want):
            self._pan_cook(ready, method)
            return
        if any("dry" in self.known.motion(motion).does for motion in method) and self._bake_alone(ready, method):
            return
        liquid = any("liquid" in self.known.motion(motion).does for motion in method)
        liquid = (
            liquid
            or join.want.make in _BOILED
            or "boil" in owed(join.want, self.known)
            or (ready.whole_shell and form_of(self.known, join.want.label, join.want.leaf) == "whole")
        )
        if liquid:
            self._boil(ready)
        else:
            self._pan_cook(ready, method)
        if ready.whole_shell:
            ready.whole_shell = False
            self.preparer.rinse(ready, "washed")  # which cools it
            self.preparer.shelled(ready, join.slot.states if join.slot else ())
        elif liquid and self._is_eaten_cold(join):
            self.preparer.rinse(ready, "washed")
        if join.want.asked in word_list("is so by cooling"):
            self._cool(ready)
        self.preparer.cut_now(ready)

    def _cool(self, ready: Ready) -> None:
        """Let what was cooked cool where it is."""
        if ready.stuff.at is not None:
            self.bench.let_cool(ready.stuff.at, ready.stuff, ready.want.names)

    def _bake_alone(self, ready: Ready, method: Sequence[str]) -> bool:
        """Bake a food by itself on a tray, with some of the fat that was asked; return whether the FOON shows how."""
        bench, want = self.bench, ready.want
        ways = [way for motion in method for way in bench.operators.ways_of(motion)]
        attested = bench.attest(ways, want.names) or bench.far(ways, want.names)
        if attested is None:
            return False
        oven, tray = bench.device("oven"), bench.vessel("baking tray")
        bench.switch(None, oven, on=True)
        self.carry.bring(ready, tray, None)
        if word_list("is done dry").isdisjoint(method):
            self.carry.add_fat(tray, self.plan)
        device = bench.place(tray, oven.label, "in")
        stuff, states = ready.stuff, self._cooked_states(ready.stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            tray.hot = True

        bench.emit(attested, [tray, (device, tray), *tray.contents], change, [tray, *tray.contents])
        bench.heat_off(tray)
        self.preparer.cut_now(ready)
        return True

    def _runs(self, stuff: Stuff) -> bool:
        return form_of(self.known, stuff.label, stuff.states) == "liquid"

    def _is_eaten_cold(self, join: Join) -> bool:
        """Whether a food is boiled for a cold dish, and is cooled under water for it."""
        cold = (self.plan.cold or self.plan.in_pieces) and not join.spot.heats_later
        facts = join.want.facts
        soaks = facts.is_a(*word_list("is not cooled under water"))
        return cold and not soaks and facts.is_a(*word_list("is cooled under water"))

    def _boil(self, ready: Ready) -> None:
        bench, want = self.bench, ready.want
        pot = bench.vessel("pot")
        self.carry.add_water(pot)
        device = bench.place(pot, "stove", "on")
        if want.facts.is_a(*word_list("comes when it boils")):
            self.carry.boil_water(pot)
        bench.switch(pot, device, on=True)
        self.carry.bring(ready, pot, None)
        attested = bench.require([("boil", ()), ("cook", ()), ("simmer", ())], want.names)
        stuff = ready.stuff
        before = list(pot.contents)
        states = self._cooked_states(stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            pot.hot = True

        wet = [other for other in before if other is not stuff] if self.carry.kept else []
        bench.emit(attested, [pot, (device, pot), *before], change, [pot, stuff, *wet])
        bench.switch(pot, device, on=False)
        self.carry.drain(pot, bench.vessel("strainer"), [stuff])

    def _cooked_states(self, stuff: Stuff, want: Want, way: Way) -> tuple[str, ...]:
        kept = [s for s in stuff.states if not self.says_raw(s)]
        able = self.known.motion(way[0]).gives | {
            s for s in (want.make,) if way in self.bench.operators.giving.get(s, ())
        }
        if "liquid" in self.known.motion(way[0]).does:
            able |= _BOILED
        if want.make in able and self.known.state(want.make).needs_heat:
            return tuple(sorted({*(kept if want.cooked else ()), want.make}))
        return tuple(sorted({*kept, "cooked"}))

    def says_raw(self, state: str) -> bool:
        """Whether a state says that a food is as yet uncooked, or in one piece as it was bought."""
        row = self.known.state(state)
        return row.half or not {"raw", "uncooked", "frozen"}.isdisjoint(state.split())

    def _is_stirred(self, ready: Ready, method: Sequence[str]) -> bool:
        """Whether a food is in pieces, which would burn where they lie."""
        pieces = any(1 < (self.known.state(state).fine or 0) < _POWDER for state in ready.stuff.states)
        loose = pieces or ready.want.facts.is_a(*word_list("lies loose"))
        return loose and set(method) == {"cook"} and not self._pours(ready.want)

    def _pan_cook(self, ready: Ready, method: Sequence[str]) -> None:
        bench, want = self.bench, ready.want
        pan = bench.vessel("cooking pan")
        device = bench.place(pan, "stove", "on")
        runs = form_of(self.known, want.label, want.leaf) == "liquid"
        if not runs and not want.facts.is_a("fat") and word_list("is done dry").isdisjoint(method):
            self.carry.add_fat(pan, self.plan)
        bench.switch(pan, device, on=True)
        self.carry.bring(ready, pan, None)
        stuff = ready.stuff
        ways = [way for motion in (*method, "cook") for way in bench.operators.ways_of(motion)]
        if self._is_stirred(ready, method):
            stirring = [
                way for motion in sorted(word_list("cooks and stirs")) for way in bench.operators.ways_of(motion)
            ]
            ways = [*(way for way in stirring if way[1]), *ways]
        attested = bench.require(ways, want.names)
        states = self._cooked_states(stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            pan.hot = True
            for other in pan.contents:
                if other is not stuff and self.known.foods.food(other.label).is_a("fat") and not self._runs(other):
                    other.states = ("melted",)

        bench.emit(attested, [pan, (device, pan), *pan.contents], change, [pan, *pan.contents])
        bench.switch(pan, device, on=False)
