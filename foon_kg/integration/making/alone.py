"""Foods that are cooked, beaten or measured by themselves before they join the others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import POWDER
from foon_kg.integration.bench import Bench, Stuff, Vessel
from foon_kg.integration.joining.course import MIXES
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.carrying import Carrier, Frying
from foon_kg.integration.making.cooling import Cooling
from foon_kg.integration.making.outcome import says_raw
from foon_kg.integration.making.precooking import Precooking
from foon_kg.integration.making.water import BASKET, POT, STEAM, Steam
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready, Want, owed
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import HEATS, Stage
from foon_kg.integration.teaching.operators import Attested, Way

_BOILED = word_list("is so by boiling")


class Alone:
    """Cooks single foods on a bench, as ``precooking`` says.

    ``ready`` are the prepared foods by the numbers of what was asked.
    """

    def __init__(self, precooking: Precooking, carry: Carrier, work: Worker, ready: dict[int, Ready]) -> None:
        self.bench: Bench = precooking.bench
        self.known: Tables = self.bench.known
        self.precooking = precooking
        self.plan = precooking.plan
        self.preparer = precooking.preparer
        self.carry = carry
        self.work = work
        self.ready = ready
        self.frying = Frying(self.bench, self.plan)
        self.cooling = Cooling(self.bench, self.plan, precooking.course)

    # --- water ---

    def measure(self, ready: Ready) -> None:
        """Fetch water, where that is ``ready`` to join, before anything is hot."""
        if ready.stuff.at is not None and ready.stuff.at.storage:
            cup = self.bench.vessel("measuring cup")
            attested = self.bench.attest([("pour", ())], ready.want.names)
            if attested is not None:
                self.bench.bring([ready.stuff], cup, attested)

    def boil_water_first(self, join: Join) -> None:
        """Boil water that is asked boiling and joins what nobody heats any more."""
        want, ready = join.want, self.ready[join.want.number]
        if not want.facts.is_a("water") or want.facts.is_any(word_list("is frozen water")):
            return
        if want.asked not in word_list("is boiled water"):
            return
        if any(map(_heats_water, (join.spot.stage, *join.spot.after))):
            return
        pot = self.bench.vessel("pot")
        self.carry.bring(ready, pot, None)
        self.bench.place(pot, "stove", "on")
        self.carry.water.boil(pot)
        self.bench.heat_off(pot)
        beside = [one.want.facts for one in self.plan.joins if one.spot.stage is join.spot.stage]
        if any(facts.is_any(word_list("makes dough rise")) for facts in beside):
            self.bench.let_cool(pot, ready.stuff, want.names)  # it would kill what makes it rise

    # --- beaten ---

    def beaten_first(self, join: Join, ready: Ready) -> None:
        """Open a food that is ``ready`` over a bowl of its own and beat it.

        That is so where it is asked or joins so and is not beaten later.
        """
        want, does = join.want, join.spot.stage.does
        beaten_later = does.isdisjoint(HEATS) and not does.isdisjoint(MIXES)
        if not ready.whole_shell or (beaten_later and not want.make):
            return
        for state in self._beaten_states(join):
            attested = self._beating(want, state)
            if attested is not None:
                bowl = self.bench.vessel("bowl")
                self.carry.open_into(ready, bowl)
                self._work_alone(ready, bowl, attested, state)
                return

    def _beaten_states(self, join: Join) -> Iterator[str]:
        """Yield the states in which a food is asked, or joins, and which only one out of its shell can have."""
        for state in filter(None, (join.want.make, *_joins_as(join))):
            row = self.known.state(state)
            if "shell" in row.earns and not row.needs_heat:
                yield state

    def _beating(self, want: Want, state: str) -> Attested | None:
        """Return how a food out of its shell is beaten to that state with a tool; ``None`` where nobody does so."""
        motion = self.known.motion
        ways = [way for way in self.bench.operators.making(state) if motion(way[0]).does <= {"mix", "whip"} and way[1]]
        ways.sort(key=lambda way: "whip" not in motion(way[0]).does)
        return self.bench.attest(ways, want.names)

    def beat_to_foam(self, ready: Ready) -> None:
        """Pour a liquid that is ``ready`` into a bowl of its own and whip it: that is done last, as the foam falls."""
        want, bowl = ready.want, self.bench.vessel("bowl")
        ways = [way for way in self.bench.operators.making(want.make) if "whip" in self.known.motion(way[0]).does]
        attested = self.bench.near_or_far(ways, want.names)
        if attested is None:
            ready.assumptions.append(f"no step of this FOON makes {want.label} {want.make}: it is bought so")
            return
        self.bench.bring([ready.stuff], bowl, self.bench.require([("pour", ())], want.names))
        self._work_alone(ready, bowl, attested, want.make)

    def _work_alone(self, ready: Ready, bowl: Vessel, attested: Attested, state: str) -> None:
        """Work on the only food of a bowl, which is in one state from then on."""
        self.bench.work(bowl, attested, ready.want.label, (state,), with_device=False)
        ready.stuff = bowl.contents[0]

    # --- cooked ---

    def cook_first(self, join: Join, method: Sequence[str]) -> None:
        """Cook the food of ``join`` by itself, with the first of ``method`` that suits it, and open it if it is due."""
        ready = self.ready[join.want.number]
        if self.precooking.is_fried_open(join.want):
            self._pan_cook(ready, method)
            return
        if self._is_steamed(ready):
            self._steam(ready)
            self.cooling.alone(join, ready)
            self.preparer.cut_now(ready)
            return
        dry = any("dry" in self.known.motion(motion).does for motion in method)
        baked = dry and self._bake_alone(ready, method)
        if baked or not self._is_rinsed_on_the_stove(join, ready, method):
            self.cooling.alone(join, ready)
        self.preparer.cut_now(ready)

    def _is_rinsed_on_the_stove(self, join: Join, ready: Ready, method: Sequence[str]) -> bool:
        """Boil a food by itself or cook it in a pan; return whether it was cooled under water then."""
        boiled = self._is_boiled(ready, method)
        if boiled:
            self._boil(ready)
        else:
            self._pan_cook(ready, method)
        if ready.whole_shell:
            ready.whole_shell = False
            self.preparer.rinse(ready, "washed")
            self.preparer.shelled(ready, _joins_as(join))
            return True
        rinsed = boiled and self._is_eaten_cold(join) and not ready.stuff.mixed
        if rinsed:
            self.preparer.rinse(ready, "washed")
        return rinsed

    def _is_steamed(self, ready: Ready) -> bool:
        """Whether a food is asked steamed; what swells in water is boiled, however it is called, and so are shells."""
        swells = ready.want.facts.is_any(word_list("is boiled by itself")) or "boil" in owed(ready.want, self.known)
        return ready.want.make in word_list("is so by steam") and not swells and not ready.whole_shell

    def _steam(self, ready: Ready) -> None:
        """Steam a food by itself in a basket over boiling water."""
        basket, steam = self.bench.vessel(BASKET), Steam(self.carry.water)
        self.carry.bring(ready, basket, None)
        pot = steam.over_water(basket, POT)
        steam.each(basket, steam.evidence(STEAM, ready.want.names), STEAM, (ready.want.make,))
        steam.out_of_it(basket, pot)

    def _is_boiled(self, ready: Ready, method: Sequence[str]) -> bool:
        """Whether a food is cooked in water: by its method, as it is asked, or because it is still in its shell."""
        want = ready.want
        if want.make in _BOILED or "boil" in owed(want, self.known):
            return True
        if any("liquid" in self.known.motion(motion).does for motion in method):
            return True
        return ready.whole_shell and form_of(self.known, want.label, want.leaf) == "whole"

    def _bake_alone(self, ready: Ready, method: Sequence[str]) -> bool:
        """Bake a food by itself on a tray, with some of the fat that was asked; return whether the FOON shows how."""
        bench, want = self.bench, ready.want
        ways = [way for motion in method for way in bench.operators.ways_of(motion)]
        attested = bench.near_or_far(ways, want.names)
        if attested is None:
            return False
        oven, tray = bench.device("oven"), bench.vessel("baking tray")
        bench.switch(None, oven, on=True)
        self.carry.bring(ready, tray, None)
        if not says(method, "is done dry"):
            self.carry.add_fat(tray, self.plan)
        device = bench.place(tray, oven.label, "in")
        stuff, states = ready.stuff, self._cooked_states(ready.stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            tray.hot = True

        bench.emit(attested, [tray, (device, tray), *tray.contents], change, [tray, *tray.contents])
        bench.heat_off(tray)
        return True

    def _is_eaten_cold(self, join: Join) -> bool:
        """Whether a food is boiled for a cold dish, and is cooled under water for it."""
        cold = (self.plan.cold or self.plan.in_pieces) and not join.spot.heats_later
        facts = join.want.facts
        soaks = facts.is_any(word_list("is not cooled under water"))
        return cold and not soaks and facts.is_any(word_list("is cooled under water"))

    def _own_water(self, want: Want) -> Ready | None:
        """Take the water that a recipe for a cold dish asks for grain: nobody pours it over what is done."""
        if not self.plan.cooled or want.facts.kind not in word_list("swells in its own water"):
            return None
        course = self.precooking.course
        for join in self.plan.joins:
            there = course.at.get(id(join.spot.stage), [])
            if join in there and join.want.facts.is_a("water") and not (join.want.make or join.spot.heats_later):
                there.remove(join)
                return self.ready[join.want.number]
        return None

    def _boil(self, ready: Ready) -> None:
        bench, want = self.bench, ready.want
        pot, own = bench.vessel("pot"), self._own_water(want)
        if own is None:
            self.carry.water.add(pot)
        else:
            self.carry.bring(own, pot, None)
        device = bench.place(pot, "stove", "on")
        if want.facts.is_any(word_list("comes when it boils")):
            self.carry.water.boil(pot)
        bench.switch(pot, device, on=True)
        self.carry.bring(ready, pot, None)
        attested = bench.require([("boil", ()), ("cook", ()), ("simmer", ())], want.names)
        stuff = ready.stuff
        before = list(pot.contents)
        states = self._cooked_states(stuff, want, attested.way)
        if own is not None or want.facts.is_any(word_list("swells to a porridge")):  # it swells until that is gone
            ready.stuff = bench.work(pot, attested, want.label, states)
            bench.switch(pot, device, on=False)
            return

        def change() -> None:
            stuff.states = states
            pot.hot = True

        wet = [other for other in before if other is not stuff] if self.carry.water.kept else []
        bench.emit(attested, [pot, (device, pot), *before], change, [pot, stuff, *wet])
        bench.switch(pot, device, on=False)
        self.carry.water.drain(pot, bench.vessel("strainer"), [stuff])

    def _cooked_states(self, stuff: Stuff, want: Want, way: Way) -> tuple[str, ...]:
        """Return in which states a food is that was cooked in some way: as it is asked, where that way gives it."""
        kept = [state for state in stuff.states if not says_raw(state, self.known)]
        if self._can_give(way, want.make) and self.known.state(want.make).needs_heat:
            return tuple(sorted({*(kept if want.cooked else ()), want.make}))
        return tuple(sorted({*kept, "cooked"}))

    def _can_give(self, way: Way, state: str) -> bool:
        """Whether a way gives a state, by its motion, in this FOON or, as it boils, as boiling does."""
        motion = self.known.motion(way[0])
        if state in motion.gives or way in self.bench.operators.giving.get(state, ()):
            return True
        return "liquid" in motion.does and state in _BOILED

    def _pan_cook(self, ready: Ready, method: Sequence[str]) -> None:
        """Cook a food by itself in a pan on the stove, in some of the fat that was asked unless it is done dry."""
        bench, want = self.bench, ready.want
        pan = bench.vessel("cooking pan")
        device = bench.place(pan, "stove", "on")
        runs = form_of(self.known, want.label, want.leaf) == "liquid"
        needs_fat = not runs and not want.facts.is_a("fat", *word_list("is fried until its fat runs"))
        if needs_fat and not says(method, "is done dry") and not self.precooking.is_toasted_in_a_pan(want):
            _ = self.carry.add_fat(pan, self.plan) or self.frying.add_fat(pan, [ready.stuff])
        bench.switch(pan, device, on=True)
        self.work.heat_fat(pan)
        self.carry.bring(ready, pan, None)
        stuff = ready.stuff
        attested = bench.require(self._pan_ways(ready, method), want.names)
        states = self._cooked_states(stuff, want, attested.way)

        def change() -> None:
            stuff.states = states
            pan.hot = True

        bench.emit(attested, [pan, (device, pan), *pan.contents], change, [pan, *pan.contents])
        bench.switch(pan, device, on=False)
        if want.facts.is_any(word_list("is fried until its fat runs")):
            self._leave_its_fat(ready, pan)
        elif want.facts.is_any(word_list("is taken out of its fat")):
            self._take_out_of_fat(ready, pan)

    def _take_out_of_fat(self, ready: Ready, pan: Vessel) -> None:
        """Lift a food out of the fat that it was fried in, which stays in the pan."""
        attested = self.bench.near_or_far(self.work.taking_out.lifting_ways(), ready.want.names)
        if attested is not None and len(pan.contents) > 1:
            self.bench.bring([ready.stuff], self.bench.vessel("plate"), attested, leaves=True)

    def _leave_its_fat(self, ready: Ready, pan: Vessel) -> None:
        """Lift a food out of the pan where its fat is all that the rest can be fried in."""
        plan = self.plan
        put_together = plan.stacked or plan.cold or plan.cooled or plan.in_pieces
        if put_together or any(join.want.facts.is_a("fat") for join in plan.joins):
            return
        if not ready.cut_later:
            lifted = self.bench.require([("pick-and-place", ()), ("pour", ())], ready.want.names)
            self.bench.bring([ready.stuff], self.bench.vessel("plate"), lifted)
        self.carry.pans_with_fat.append(pan)

    def _pan_ways(self, ready: Ready, method: Sequence[str]) -> list[Way]:
        """Return the ways to cook a food in a pan: what is in pieces is stirred, as it would burn where it lies."""
        ways = [way for motion in (*method, "cook") for way in self.bench.operators.ways_of(motion)]
        if not self._is_stirred(ready, method):
            return ways
        return [*(way for way in self.bench.ways_by(word_list("cooks and stirs")) if way[1]), *ways]

    def _is_stirred(self, ready: Ready, method: Sequence[str]) -> bool:
        """Whether a food is in pieces, which would burn where they lie."""
        pieces = any(1 < self.known.state(state).fineness < POWDER for state in ready.stuff.states)
        loose = pieces or ready.want.facts.is_any(word_list("lies loose"))
        return loose and set(method) == {"cook"} and not self.precooking.pours(ready.want)


def _joins_as(join: Join) -> tuple[str, ...]:
    """Return the states in which the video brings what joins there."""
    return join.slot.states if join.slot is not None else ()


def _heats_water(stage: Stage) -> bool:
    return stage.heats and "dry" not in stage.does
