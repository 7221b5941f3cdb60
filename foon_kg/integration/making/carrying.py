"""Bringing foods from one place to another, as their form and what they come out of allow."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from foon_kg.food import Food, Tables, singular, words
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, foods_of, is_flat
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.preparing.preparer import Preparer
from foon_kg.integration.teaching.frames import Slot, Stage
from foon_kg.integration.teaching.operators import Attested, Way, form_of, is_liquid_fat
from foon_kg.world.running import is_runny

_TAP, _JUG = "faucet", "measuring cup"
"""Where water comes from, and in what it comes to what stands on a stove."""

_DEEP = "baking dish"
"""What is wet is baked in it."""

_SMALL = 3
"""As finely as this is cut what nobody picks up piece by piece."""

_DRY = word_list("coats dry")
_COATING = _DRY | word_list("coats wet") | word_list("clings to what is coated")
_SOLID = word_list("keeps its shape") | word_list("is one piece when it is done")
_HOLDS = word_list("holds a mixture together")
_POUR = frozenset({"pour", "drip"})
_MOVES = frozenset({"move", "scatter", "fetch"})


class Carrier:
    """Carries foods about on a bench."""

    def __init__(self, bench: Bench, preparer: Preparer) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.preparer = preparer
        self.kept: list[Ready] = []
        """What is asked of the water in which something boils, until some of that is taken."""

    def open_into(self, ready: Ready, vessel: Vessel) -> None:
        """Open a food in its shell over a vessel; raises :class:`RefusedError` where nothing opens it."""
        attested = self.preparer.opening(ready.want)
        if attested is None:
            raise RefusedError(f"nothing opens {ready.want.label}")
        state = self.preparer._gives(attested.way, ("shell", "open"))  # noqa: SLF001
        self.bench.bring([ready.stuff], vessel, attested, (state,))
        ready.whole_shell = False

    def transfer(self, source: Vessel, target: Vessel, stage: Stage, *, whole: bool = False) -> None:
        """Bring all that is in one vessel into another (as one piece: ``whole``); water runs off in a strainer.

        Raises :class:`RefusedError` where nothing brings it.
        """
        stuffs = list(source.contents)
        if solid := self._strained(stuffs, target):
            self.drain(source, target, solid)
            return
        out_of_tin = self._is_in_tin(source)
        if out_of_tin:
            self._cool(source)
        moved = [stuff for stuff in stuffs if not self._stays_in_the_pan(stuff, stuffs)]
        foods = foods_of(source)
        if "coat" in stage.does and stage.motion in word_list("greases") and not whole:
            onto = self.bench.attest(self.bench.operators.ways_of(stage.motion), foods)
            if onto is not None and target.contents:
                self.bench.bring(moved, target, onto, onto=list(target.contents))
                return
        ways = self._ways_out(source, moved, stage, whole=whole)
        if out_of_tin:
            ways = [way for way in ways if not way[1]] or ways  # nothing reaches under it
        if self._is_portioned(moved, target):
            ways = self._by_the_spoon()[:1] or ways
        attested = self.bench.attest(ways[:1], foods) or self.bench.require(ways, foods)
        self.bench.bring(moved, target, attested, leaves=len(moved) < len(stuffs))

    def _strained(self, stuffs: Sequence[Stuff], target: Vessel) -> list[Stuff]:
        """Return what stays in a strainer, without the water that runs off; nothing where none does."""
        row = self.known.utensil(target.label)
        if row is None or "strain" not in row.can:
            return []
        rest = [stuff for stuff in stuffs if stuff.mixed or not self.known.foods.food(stuff.label).is_a("water")]
        return rest if len(rest) < len(stuffs) else []

    def _ways_out(self, source: Vessel, moved: Sequence[Stuff], stage: Stage, *, whole: bool) -> list[Way]:
        """Return the ways to bring what is ``moved`` out of a vessel, that of the recorded ``stage`` first."""
        runs, one_piece = self._hangs_together(moved, whole=whole)
        usual = self.bench.operators.brings("liquid" if runs else "whole" if one_piece else "pieces", "vessel")
        tools = stage.tools if (stage.motion, stage.tools) in usual else ()
        told: Way = (stage.motion, tools)
        ways = [way for way in usual if self._pure(way)]
        if stage.motion and self._pure(told) and (not runs or told in usual):
            ways.insert(0, told)
        if one_piece and (whole or not _SOLID.isdisjoint(state for stuff in moved for state in stuff.states)):
            ways = self._lifting(ways, source)
        return self._with_tools(ways) if source.hot and not self._is_in_tin(source) else ways

    def _with_tools(self, ways: Sequence[Way]) -> list[Way]:
        """Return ways of which nobody picks up with bare hands what is hot, where a tool does it."""
        bare = [way for way in ways if way[0] in word_list("picks up") and not way[1]]
        named = sorted({way[0] for way in bare})
        lifters = [way for name in named for way in self.bench.operators.ways_of(name) if any(map(self._lifts, way[1]))]
        return [*lifters, *(way for way in ways if not lifters or way not in bare)]

    def _by_the_spoon(self) -> list[Way]:
        """Return the ways that fetch a portion with a tool."""
        ways = [way for way in self.bench.operators.ways.get("fetch", ()) if way[1] and self._pure(way)]
        return [way for way in ways if "move" in self.known.motion(way[0]).does]

    def _stays_in_the_pan(self, stuff: Stuff, beside: Sequence[Stuff]) -> bool:
        """Whether liquid fat in which something was fried is left where it is: what clings to that is part of it."""
        if stuff.mixed or not stuff.wants or not is_liquid_fat(self.known.foods.food(stuff.label)):
            return False
        return any(other is not stuff and stuff.wants <= other.wants for other in beside)

    def _is_in_tin(self, vessel: Vessel) -> bool:
        """Whether something was baked in a tin with a rim."""
        row = self.known.utensil(vessel.label)
        return row is not None and row.group == "tins" and any("baked" in stuff.states for stuff in vessel.contents)

    def _cool(self, vessel: Vessel) -> None:
        """Let what was baked cool in its tin, or it breaks when it comes out."""
        (whole, *others) = vessel.contents
        if vessel.hot and not others:
            self.bench.let_cool(vessel, whole, foods_of(vessel))

    def _hangs_together(self, stuffs: Sequence[Stuff], *, whole: bool) -> tuple[bool, bool]:
        """Return whether what is moved runs, and whether it is moved in one piece."""
        states = {state for stuff in stuffs for state in stuff.states}
        solids = [stuff for stuff in stuffs if stuff.mixed or not self.known.foods.food(stuff.label).is_a("fat")]
        alone = len(solids) == 1 or not any(self._is_liquid(stuff) or self.is_wet(stuff) for stuff in stuffs)
        uncut = alone and any(self._is_uncut(stuff) for stuff in solids)
        shaped = whole or uncut or not word_list("keeps its shape").isdisjoint(states)
        runs = not shaped and (len(stuffs) > 1 or any(self._is_liquid(stuff) or self.is_wet(stuff) for stuff in stuffs))
        holds = shaped or (len(solids) == 1 and solids[0].mixed)
        return runs, shaped or (holds and not runs and not self._is_loose(solids[0]))

    def _is_liquid(self, stuff: Stuff) -> bool:
        return form_of(self.known, stuff.label, stuff.states) in {"liquid", "soft"}

    def _lifting(self, ways: Sequence[Way], source: Vessel) -> list[Way]:
        """Return the ways to move what is in one piece: nothing is poured, and with a tool first where it is hot."""
        ways = [way for way in ways if not _POUR & set(way[0].split())]
        if not source.hot:
            return ways
        flesh = any(self._is_uncut(stuff) for stuff in source.contents)
        lifters = [way for way in ways if way[1] and (flesh or any(self._lifts(tool) for tool in way[1]))]
        return [*lifters, *(way for way in ways if way not in lifters)]

    def _lifts(self, tool: str) -> bool:
        row = self.known.utensil(tool)
        return row is not None and row.group in word_list("lifts what is hot")

    def _is_uncut(self, stuff: Stuff) -> bool:
        """Whether a food is flesh that nobody cut, and no stew that is called by it."""
        foods = [self.known.foods.food(food) for food in stuff.foods]
        small = all(food.is_a(*word_list("is a mouthful")) for food in foods if food.is_a(*word_list("is coated")))
        if stuff.mixed and (small or any(f"kind:{food.kind}" in word_list("stays liquid") for food in foods)):
            return False
        if self._is_breaded(stuff) or (not stuff.mixed and {"baked", "whole"} <= set(stuff.states)):
            return True
        facts = self.known.foods.food(stuff.label)
        cut = any((self.known.state(state).fine or 0) > 0 for state in stuff.states)
        return not cut and facts.is_a(*word_list("is coated")) and not facts.is_a(*word_list("patties are made of"))

    def _is_breaded(self, stuff: Stuff) -> bool:
        """Whether a mixture is one food that comes in portions, with what it was turned in."""
        foods = {name: self.known.foods.food(name) for name in stuff.foods}
        flesh = [name for name, food in foods.items() if food.is_a(*word_list("is coated"))]
        turned = all(food.is_a(*_COATING) for name, food in foods.items() if name not in flesh)
        portion = len(flesh) == 1 and not word_list("is a portion").isdisjoint(words(flesh[0]))
        return stuff.mixed and portion and turned and any(food.is_a(*_DRY) for food in foods.values())

    def _is_loose(self, stuff: Stuff) -> bool:
        """Whether a mixture is of dry foods, or of what stays loose when it is cooked, that nothing holds together."""
        foods = [self.known.foods.food(food) for food in stuff.foods]
        if _SOLID.isdisjoint(stuff.states) and any(food.is_a(*word_list("stays loose")) for food in foods):
            return True
        cooked = any(self.known.state(state).needs_heat for state in stuff.states)
        if not cooked and _SOLID.isdisjoint(stuff.states) and not any(food.is_a(*_HOLDS) for food in foods):
            return any(form_of(self.known, food.name, ()) in {"pieces", "whole"} for food in foods)
        holds = any(food.is_a("creamy", "dough", "egg", "fat", "liquid", "water") for food in foods)
        return not holds and not cooked and any(form_of(self.known, food, ()) == "powder" for food in stuff.foods)

    def _is_portioned(self, stuffs: Sequence[Stuff], target: Vessel) -> bool:
        """Whether batter comes onto a tray, or a filling onto what it fills: it is set on it spoon by spoon."""
        row = self.known.utensil(target.label)
        if stuffs[-1].label in word_list("is spooned onto what it fills") and self._is_filled(target):
            return True
        raw = not any(self.known.state(state).needs_heat for stuff in stuffs for state in stuff.states)
        flour = any(binds(stuff.foods, self.known) for stuff in stuffs)
        kneaded = not word_list("keeps its shape").isdisjoint(stuffs[-1].states)
        return (
            raw
            and flour
            and not kneaded
            and stuffs[-1].mixed
            and row is not None
            and "bake" in row.can
            and is_flat(target.label)
        )

    def _is_filled(self, target: Vessel) -> bool:
        """Whether what lies in or on a vessel is filled: all that lies flat, and what is hollow."""
        foods = (self.known.foods.food(stuff.label) for stuff in target.contents)
        hollow = any(food.is_a(*word_list("is filled with a spoon")) for food in foods)
        return bool(target.contents) and (hollow or is_flat(target.label))

    def add_fat(self, vessel: Vessel, plan: Plan) -> bool:
        """Bring some of the fat that was asked for into a pan; return whether there is any."""
        fats = [j.want for j in plan.joins if j.want.facts.is_a("fat") and j.want.facts.is_a("stock")]
        fats.sort(key=lambda want: not want.facts.is_a("liquid"))
        if not fats:
            return False
        taken = self.bench.fetch(fats[0].label, fats[0].leaf, [fats[0].number], fats[0].storage)
        self.bring(Ready(fats[0], taken), vessel, None)
        return True

    def grease(self, fat: Want, tin: Vessel) -> None:
        """Spread some of a fat in a tin."""
        stuff = self.bench.fetch(fat.label, fat.leaf, [fat.number], fat.storage)
        by_hand = [way for motion in sorted(word_list("greases")) for way in self.bench.operators.ways_of(motion)]
        attested = (
            None if form_of(self.known, fat.label, fat.leaf) == "liquid" else self.bench.attest(by_hand, fat.names)
        )
        if attested is None:
            self.bring(Ready(fat, stuff), tin, None)
        else:
            self.bench.bring([stuff], tin, attested)

    def drain(self, pot: Vessel, strainer: Vessel, stuffs: Sequence[Stuff]) -> None:
        """Pour a pot into a strainer: ``stuffs`` stay there, the water is gone, save what is asked of it."""
        while self.kept:
            self._keep_water(pot, self.kept.pop())
        foods = tuple(dict.fromkeys(food for stuff in stuffs for food in stuff.foods))
        drained = self.bench.require([("drain", ()), ("pour", ())], foods)
        salted = [stuff for stuff in stuffs if not stuff.mixed and self._dissolves(stuff)]
        kept = [stuff for stuff in stuffs if stuff not in salted] or list(stuffs)

        def change() -> None:
            pot.contents.clear()
            for stuff in kept:
                strainer.contents.append(stuff)
                stuff.at = strainer
            for stuff in salted if kept[0] not in salted else ():  # it is in what was boiled in it
                kept[0].foods += stuff.foods
                kept[0].wants |= stuff.wants

        self.bench.emit(drained, [pot, *stuffs, strainer], change, [strainer, *kept, pot])

    def _dissolves(self, stuff: Stuff) -> bool:
        facts = self.known.foods.food(stuff.label)
        return facts.is_a(*word_list("goes into the water")) and not facts.is_a("water")

    def _keep_water(self, pot: Vessel, ready: Ready) -> None:
        """Take some of the water of a pot, which is asked under a name of its own, before it is poured away."""
        water = next((stuff for stuff in pot.contents if self.known.foods.food(stuff.label).is_a("water")), None)
        ways = [way for way in self.bench.operators.ways_of("scoop") if way[1]]
        attested = self.bench.attest(ways, ("water",)) or self.bench.far(ways, ("water",))
        if water is None or attested is None:
            return
        cup, kept = self.bench.vessel(_JUG), ready.stuff
        rest = [stuff for stuff in pot.contents if stuff is not water]

        def change() -> None:
            pot.contents.remove(water)
            cup.contents.append(kept)
            kept.at, kept.states = cup, ("liquid",)

        self.bench.emit(attested, [pot, *pot.contents, cup], change, [cup, kept, pot, *rest])

    def is_wet(self, stuff: Stuff) -> bool:
        """Whether a mixture runs: it has liquid in it that was not baked away."""
        if not stuff.mixed or not word_list("keeps its shape").isdisjoint(stuff.states):
            return False
        if is_runny(stuff.label, stuff.states, stuff.foods, self.known):
            return True
        foods = [self.known.foods.food(food) for food in stuff.foods]
        liquids = word_list("stays liquid")
        if "baked" not in stuff.states and any(f"kind:{food.kind}" in liquids for food in foods):
            return True
        if "baked" not in stuff.states and (_is_a_sauce(foods) or _is_melted(stuff, foods)):
            return True
        if any(self.known.state(state).needs_heat for state in stuff.states):
            baked = "baked" in stuff.states and binds(stuff.foods, self.known)
            sets = baked or any(food.is_a("egg", "flour", "dough") for food in foods)  # what ran is solid now
            fried = any(food.is_a(*word_list("is coated")) for food in foods)  # fat that clings to flesh is no sauce
            wet = [food for food in foods if food.is_a("liquid", "creamy") and not (fried and food.is_a("fat"))]
            return not sets and bool(wet)
        return any(food.is_a("liquid", "creamy", "water", "egg") for food in foods)

    def _pure(self, way: Way) -> bool:
        return _only_brings(self.known, way[0])

    def tin_for(self, label: str, vessel: Vessel, tin: str, *, in_oven: bool) -> str:
        """Return in what is baked what comes out of ``vessel``: in the dish's ``tin``, and nothing wet on a tray.

        What was baked in the tin is not moved to other bakeware.
        """
        row = self.known.utensil(label)
        if row is None or "bake" not in row.can or (row.can & {"heat", "cook"} and not (tin and in_oven)):
            return label
        if vessel.label == tin:
            return tin
        mixed = [stuff for stuff in vessel.contents if stuff.mixed]
        batter = [stuff for stuff in mixed if self._sets(stuff, tin) and not self._is_sauce(stuff)]
        in_portions = row.group == "tins"
        runs = any(self.is_wet(stuff) for stuff in batter)
        if tin and batter and (in_portions or runs):
            return tin
        wet = any(
            self.is_wet(stuff) or form_of(self.known, stuff.label, stuff.states) == "liquid"
            for stuff in vessel.contents
        )
        plain = all(self.known.foods.food(food).is_a("fat") for food in self._liquids(vessel))
        return _DEEP if is_flat(label) and wet and not plain and not batter else label

    def _sets(self, stuff: Stuff, tin: str) -> bool:
        """Whether a mixture sets when it is baked: there is flour in it, or there are eggs for what has a ``tin``."""
        eggs = any(self.known.foods.food(food).is_a("egg") for food in stuff.foods)
        return binds(stuff.foods, self.known) or (bool(tin) and eggs)

    def _is_sauce(self, stuff: Stuff) -> bool:
        """Whether what flour binds is a sauce with something in it, and no batter."""
        foods = [self.known.foods.food(food) for food in stuff.foods]
        thin = any(food.is_of(*word_list("is a bath")) for food in foods)
        other = any(food.is_a("leaven", *word_list("makes no sauce of flour")) for food in foods)
        return not other and (thin or any(f"kind:{food.kind}" in word_list("makes a sauce of flour") for food in foods))

    def deep_for(self, label: str, wants: Sequence[Want]) -> str:
        """Return in what foods are baked that come into it one by one: nothing that runs on a tray."""
        row = self.known.utensil(label)
        bakes = row is not None and "bake" in row.can and is_flat(label)
        runs = any(want.facts.is_a("egg", "liquid") and not want.facts.is_a("fat") for want in wants)
        return _DEEP if bakes and runs else label

    def _liquids(self, vessel: Vessel) -> list[str]:
        return [food for food in foods_of(vessel) if self.known.foods.food(food).is_a("liquid", "creamy")]

    def add_water(self, vessel: Vessel) -> None:
        """Pour water from the tap into a vessel."""
        water = self.bench.fetch("water", ("liquid",), (), _TAP)
        attested = self.bench.require([("pour", ()), ("fill", ())], ("water",))
        if vessel.device is not None:
            jug = self.bench.vessel(_JUG)
            self.bench.bring([water], jug, attested)
        self.bench.bring([water], vessel, attested)

    def boil_water(self, pot: Vessel) -> None:
        """Bring the water in a pot that stands over the heat to the boil, where nothing but salt is in it."""
        water = next((stuff for stuff in pot.contents if self.known.foods.food(stuff.label).is_a("water")), None)
        foods = (self.known.foods.food(stuff.label) for stuff in pot.contents)
        if water is None or pot.device is None or any(not one.is_a(*word_list("goes into the water")) for one in foods):
            return
        boils = self.bench.attest([("boil", ()), ("heat", ())], ("water",))
        if boils is None or "boiling" in water.states:
            return
        self.bench.switch(pot, pot.device, on=True)

        def change() -> None:
            water.states = tuple(sorted({*water.states, "boiling"}))
            pot.hot = True

        self.bench.emit(boils, [pot, (pot.device, pot), *pot.contents], change, [pot, water])

    def bring(self, ready: Ready, vessel: Vessel, slot: Slot | None) -> None:
        """Bring one food into a vessel: as the slot has it, where that suits its form, else as is usual for it."""
        bath = word_list("goes into the water")
        foods = [self.known.foods.food(stuff.label) for stuff in vessel.contents]
        boiled = any(food.is_a("water") for food in foods)
        boiled = boiled and (ready.want.cooked or all(food.is_a(*bath) for food in foods))
        if ready.whole_shell and not boiled:
            self.open_into(ready, vessel)
            return
        stuff = ready.stuff
        source = stuff.at
        if source is vessel:
            return
        if source is not None and source.label == _TAP and vessel.device is not None:
            jug = self.bench.vessel(_JUG)
            self.bench.bring([stuff], jug, self._way_of(ready, slot, jug))
        attested = self._with_spoon(self._way_of(ready, slot, vessel))
        smears = attested.way[0] in word_list("greases") and form_of(self.known, stuff.label, stuff.states) == "soft"
        comes = [stuff, *self._clinging(stuff, source)] if attested.way[0] in _POUR else [stuff]
        self.bench.bring(comes, vessel, attested, onto=list(vessel.contents) if smears else ())

    def _clinging(self, stuff: Stuff, source: Vessel | None) -> list[Stuff]:
        """Return the fat in which a food was fried: nobody pours that out of its pan without it."""
        if source is None or source.storage or not source.hot:
            return []
        others = [one for one in source.contents if one is not stuff]
        return others if all(self.known.foods.food(one.label).is_a("fat") for one in others) else []

    def _with_spoon(self, attested: Attested) -> Attested:
        """Return a way with the tool that scoops, where a video forgot to name it."""
        return self.preparer.with_tool(attested) if attested.way[0] in word_list("is scooped by") else attested

    def bring_part(self, ready: Ready, vessel: Vessel) -> None:
        """Bring some of a food that is in pieces into or onto a vessel."""
        self.bench.bring_part(ready.stuff, vessel, self._way_of(ready, None, vessel))

    def _way_of(self, ready: Ready, slot: Slot | None, vessel: Vessel) -> Attested:
        """Return how one food is brought from where it is: as the slot has it, else as is usual for it."""
        stuff, want = ready.stuff, ready.want
        source = stuff.at
        role = "" if source is None else ("storage" if source.storage else "vessel")
        form = form_of(self.known, want.label, stuff.states)
        usual = self.bench.operators.brings(form, role)
        groups: list[list[Way]] = [self._as_shown(slot, want, stuff), self._by_store(usual, stuff, source)]
        if slot is not None and (slot.motion, slot.tools) in usual:
            groups.append([(slot.motion, slot.tools)])
        such = [self.bench.operators.brings_such(name, form, role) for name in (*want.names, f"kind:{want.facts.kind}")]
        groups += [[way for way in ways if self._pure(way)] for ways in (*such, usual)]
        attested: Attested | None = None
        if slot is not None and set(stuff.states) == set(slot.states):  # as recorded, whatever others do
            attested = self.bench.attest(self._fitting(groups[0], stuff, source, vessel, strict=False), stuff.foods)
        wished = not set(self.bench.instead).isdisjoint(stuff.foods)  # handled just as another food is
        for strict in (False,) if wished else (True, False):
            for group in groups:
                if attested is None:
                    ways = self._fitting(group, stuff, source, vessel, strict=strict)
                    attested = self.bench.attest(ways, stuff.foods)
                    if attested is None and group is groups[1]:  # whatever it is: no jar is emptied of what is thick
                        attested = self.bench.far(ways, stuff.foods)
        by_hand: list[Way] = [("pick-and-place", ()), ("pour", ())]
        if attested is None:  # as seldom as it may be
            ways = self._fitting(by_hand, stuff, source, vessel, strict=False)
            attested = self.bench.attest(ways, stuff.foods)
            if attested is None and not word_list("runs").isdisjoint(stuff.states):
                attested = self.bench.far(ways, stuff.foods)  # whatever it is: no hand picks up what runs
        return attested or self.bench.require(groups[-1] or by_hand, stuff.foods)

    def _as_shown(self, slot: Slot | None, want: Want, stuff: Stuff) -> list[Way]:
        """Return how the video brings this very food in such a form."""
        if slot is None or slot.food != singular(want.label):
            return []
        if slot.motion in word_list("greases") and form_of(self.known, want.label, stuff.states) == "soft":
            return list(self.bench.operators.ways_of(slot.motion))
        if not self._pure((slot.motion, slot.tools)):
            return []
        known = self.bench.known
        alike = form_of(known, slot.food, slot.states) == form_of(known, want.label, stuff.states)
        return [(slot.motion, slot.tools)] if alike else []

    def _fitting(
        self, ways: Sequence[Way], stuff: Stuff, source: Vessel | None, target: Vessel, *, strict: bool
    ) -> list[Way]:
        """Return the ways that suit a thing: nothing in one piece is poured, nor what runs picked up; cans spray.

        Where it is ``strict``, small pieces are not picked up either, nor slices poured onto a plate.
        """
        poured = not _is_laid(self.known, stuff.label, stuff.states, flat=strict and is_flat(target.label))
        picked = not (_is_poured(self.known, stuff.label, stuff.states) if strict else self._is_liquid(stuff))
        sprayed = source is not None and source.label in word_list("sprays")
        return [
            way
            for way in ways
            if (poured or not _POUR & set(way[0].split()))
            and (sprayed or way[0] not in word_list("is sprayed by"))
            and (picked or way[0] not in word_list("picks up"))
        ]

    def _by_store(self, usual: Sequence[Way], stuff: Stuff, source: Vessel | None) -> list[Way]:
        """Return the usual ways that what a food comes out of asks for: a mill strews, a tub is scooped out."""
        if source is None or not source.storage:
            return []
        row = self.known.utensil(source.label)
        motions: frozenset[str] = frozenset()
        if row is not None and row.group in word_list("strews"):
            motions = word_list("is strewn by")
        elif not word_list("is scooped").isdisjoint(stuff.states):
            motions = word_list("is scooped by")
        return [way for way in usual if way[0] in motions]


@lru_cache(maxsize=1 << 12)
def _only_brings(known: Tables, motion: str) -> bool:
    """Whether a motion brings a food somewhere and does nothing else to it."""
    does = known.motion(motion).does
    return bool(does) and does <= _MOVES and motion not in {"throw away", "remove", "measure", "scoop"}


@lru_cache(maxsize=1 << 14)
def _is_laid(known: Tables, label: str, states: tuple[str, ...], *, flat: bool) -> bool:
    """Whether a food comes somewhere piece by piece: what lies in one piece does, and slices onto what is ``flat``."""
    if known.foods.food(label, states).is_a(*word_list("carries what is stacked")):
        return True
    if not word_list("lies in one piece").isdisjoint(states):
        return True
    solid = form_of(known, label, states) in {"pieces", "whole"}
    return flat and solid and not _is_poured(known, label, states)


@lru_cache(maxsize=1 << 14)
def _is_poured(known: Tables, label: str, states: tuple[str, ...]) -> bool:
    """Whether nobody picks up a food piece by piece: it runs, or it is in small pieces."""
    facts = known.foods.food(label, states)
    finest = max((known.state(state).fine or 0 for state in states), default=0)
    form = form_of(known, label, states)
    loose = facts.is_a(*word_list("lies loose")) and word_list("lies in one piece").isdisjoint(states)
    return form in {"liquid", "powder"} or finest >= _SMALL or (loose and form in {"pieces", "whole"})


def _is_melted(stuff: Stuff, foods: Sequence[Food]) -> bool:
    """Whether a mixture is hot fat with what only seasons it."""
    seasoned = all(food.is_a(*word_list("runs with melted fat")) for food in foods)
    return "cooked" in stuff.states and seasoned and any(food.is_a("fat") for food in foods)


def _is_a_sauce(foods: Sequence[Food]) -> bool:
    """Whether foods make a sauce that flour only thickens: a liquid, and nothing that is solid in it or sets."""
    parts = word_list("is in what only gets thick")
    wet = any(food.is_a("cooking liquid") for food in foods)
    return (
        wet
        and all(food.is_a(*parts) for food in foods)
        and not any(food.is_a("dough", "egg", "leaven") for food in foods)
    )
