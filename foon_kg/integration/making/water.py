"""Water: poured into a vessel from the tap, brought to the boil, and poured away when what boiled in it is done.

What is steamed stands above it. Where no video of the FOON does that, what is boiled is the evidence; it is declared as
a substitution.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel
from foon_kg.integration.making.outcome import says_raw
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.teaching.operators import Attested

TAP, JUG = "faucet", "measuring cup"
"""Where water comes from, and in what it comes to what stands on a stove."""

POT, LID, BASKET, STEAM = "pot", "pot lid", "steamer basket", "steam"
"""In what water boils, what covers that, what stands in it, and what is done there."""

_LIKE_STEAM = ("boil", "simmer", "cook")
"""What tells that a food is steamed, where no video does that: it is cooked by boiling water as well."""


class Water:
    """Handles water on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.kept: list[Ready] = []
        """What is asked of the water in which something boils, until some of that is taken."""

    def add(self, vessel: Vessel) -> None:
        """Pour water from the tap into a vessel."""
        water = self.bench.fetch("water", ("liquid",), (), TAP)
        attested = self.bench.require([("pour", ()), ("fill", ())], ("water",))
        if vessel.device is not None:
            self.bench.bring([water], self.bench.vessel(JUG), attested)
        self.bench.bring([water], vessel, attested)

    def boil(self, pot: Vessel) -> None:
        """Bring the water in a pot that stands over the heat to the boil, where nothing but salt is in it."""
        water, device = self._water_in(pot), pot.device
        foods = (self.known.foods.food(stuff.label) for stuff in pot.contents)
        if water is None or device is None or any(not one.is_any(word_list("goes into the water")) for one in foods):
            return
        boils = self.bench.attest([("boil", ()), ("heat", ())], water.foods)
        if boils is None or "boiling" in water.states:
            return
        self.bench.switch(pot, device, on=True)

        def change() -> None:
            water.states = tuple(sorted({*water.states, "boiling"}))
            pot.hot = True

        self.bench.emit(boils, [pot, (device, pot), *pot.contents], change, [pot, *pot.contents])

    def boils(self, ready: Ready, vessel: Vessel) -> bool:
        """Return whether a food that is ``ready`` comes into a vessel to be boiled: in salt water, or asked cooked."""
        foods = [self.known.foods.food(stuff.label) for stuff in vessel.contents]
        if not any(food.is_a("water") for food in foods):
            return False
        return ready.want.cooked or all(food.is_any(word_list("goes into the water")) for food in foods)

    def drain(self, pot: Vessel, strainer: Vessel, stuffs: Sequence[Stuff]) -> None:
        """Pour a pot into a strainer: ``stuffs`` stay there, the water is gone, save what is asked of it."""
        self._keep_what_is_asked(pot, stuffs)
        foods = tuple(dict.fromkeys(food for stuff in stuffs for food in stuff.foods))
        drained = self.bench.require([("drain", ()), ("pour", ())], foods)
        dissolved = [stuff for stuff in stuffs if self._dissolves(stuff)]
        kept = [stuff for stuff in stuffs if stuff not in dissolved]
        if not kept:
            kept, dissolved = list(stuffs), []

        def change() -> None:
            pot.contents.clear()
            for stuff in kept:
                strainer.contents.append(stuff)
                stuff.at = strainer
            for stuff in dissolved:  # it is in what was boiled in it
                kept[0].foods += stuff.foods
                kept[0].wants |= stuff.wants

        self.bench.emit(drained, [pot, *stuffs, strainer], change, [strainer, *kept, pot])

    def _keep_what_is_asked(self, pot: Vessel, stuffs: Sequence[Stuff]) -> None:
        """Take out of a pot what is asked of the water in which ``stuffs`` boiled."""
        for ready in [ready for ready in self.kept if self._is_of(ready.want, stuffs)]:
            self.kept.remove(ready)
            self._keep_some(pot, ready)

    def _is_of(self, water: Want, stuffs: Sequence[Stuff]) -> bool:
        """Whether some of the water in which ``stuffs`` boiled is asked: what is called so, or after one of them."""
        named = set(words(water.label))
        if any(named & {*words(stuff.label)} for stuff in stuffs):
            return True
        # "a ladleful of pasta water" names no other food, as "corn cooking water" does
        return not any(self.known.foods.is_listed(word) for word in named - {*words(water.facts.taken_for)})

    def _keep_some(self, pot: Vessel, ready: Ready) -> None:
        """Take some of the water of a pot, which is asked under a name of its own, before it is poured away."""
        water = self._water_in(pot)
        ways = [way for way in self.bench.operators.ways_of("scoop") if way[1]]
        attested = self.bench.near_or_far(ways, ("water",))
        if water is None or attested is None:
            return
        cup, kept = self.bench.vessel(JUG), ready.stuff
        rest = [stuff for stuff in pot.contents if stuff is not water]

        def change() -> None:
            pot.contents.remove(water)
            cup.contents.append(kept)
            kept.at, kept.states = cup, ("liquid",)

        self.bench.emit(attested, [pot, *pot.contents, cup], change, [cup, kept, pot, *rest])
        if ready.want.asked in word_list("is so by cooling") | word_list("is as warm as a hand"):
            self.bench.let_cool(cup, kept, kept.foods)

    def _water_in(self, pot: Vessel) -> Stuff | None:
        return next((stuff for stuff in pot.contents if self.known.foods.food(stuff.label).is_a("water")), None)

    def _dissolves(self, stuff: Stuff) -> bool:
        """Whether a food is salt or the like, and on its own."""
        if stuff.mixed:
            return False
        facts = self.known.foods.food(stuff.label)
        return facts.is_any(word_list("goes into the water")) and not facts.is_a("water")


class Steam:
    """Handles the steam of ``water`` on its bench."""

    def __init__(self, water: Water) -> None:
        self.water = water
        self.bench = water.bench

    def over_water(self, holder: Vessel, over: str) -> Vessel:
        """Stand ``holder`` over boiling water in what is called ``over``, under a lid; return that pot."""
        pot = self.bench.vessel(over)
        self.water.add(pot)
        self.bench.place(pot, "stove", "on")
        self.water.boil(pot)
        self.bench.stand_over(holder, pot)
        self.bench.cover(pot, LID)
        return pot

    def out_of_it(self, holder: Vessel, pot: Vessel) -> None:
        """Turn off the heat and lift ``holder`` out of its ``pot``."""
        self.bench.heat_off(pot)
        self.bench.uncover(pot)
        self.bench.lift_off(holder)
        self.bench.uncover(holder)

    def evidence(self, motion: str, foods: Sequence[str]) -> Attested:
        """Return what attests that ``foods`` are steamed (``motion``), be it that they, or the like, are boiled.

        Raises :class:`RefusedError` where this FOON has neither.
        """
        own = self.bench.near_or_far(self.bench.operators.ways_of(motion), foods)
        return own or self.bench.require([(name, ()) for name in _LIKE_STEAM], foods)

    def each(self, holder: Vessel, attested: Attested, motion: str, states: Sequence[str]) -> None:
        """Steam (``motion``), as is ``attested``, all in ``holder``: each stays what it is, in ``states`` then."""
        stuffs = list(holder.contents)
        self.bench.declare(motion, attested, stuffs[0].label)

        def change() -> None:
            for stuff in stuffs:
                kept = (state for state in stuff.states if not says_raw(state, self.bench.known))
                stuff.states = tuple(sorted({*kept, *states}))
            holder.hot = True

        inputs = [holder, *self.bench.under(holder), *stuffs]
        self.bench.emit(attested, inputs, change, [holder, *stuffs, *self.bench.water_under(holder)], motion=motion)
