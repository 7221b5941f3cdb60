"""Bringing foods from one place to another, as their form and what they come out of allow."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Food, Tables, singular
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, foods_of, is_baked, is_flat, is_heated
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.bringing import Bringing, Transport, only_brings, pours
from foon_kg.integration.making.consistency import SOLID, form_together, is_shaped, is_uncut
from foon_kg.integration.making.water import JUG, TAP, Water
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.preparing.preparer import Preparer
from foon_kg.integration.teaching.forms import form_of, is_liquid_fat
from foon_kg.integration.teaching.frames import Slot, Stage
from foon_kg.integration.teaching.operators import Attested, Way

_WHY = "nobody asked for fat, and a dry pan burns what is fried: some of the household's {fat}"


class Carrier:
    """Carries foods about on a bench."""

    def __init__(self, bench: Bench, preparer: Preparer) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.preparer = preparer
        self.bringing = Bringing(bench)
        self.water = Water(bench)
        self.pans_with_fat: list[Vessel] = []
        """What a food was fried in by itself whose fat ran out there."""

    # --- one food ---

    def bring(self, ready: Ready, vessel: Vessel, slot: Slot | None) -> None:
        """Bring one food that is ``ready`` into a vessel: as ``slot`` has it, if that suits its form, or as usual."""
        if ready.whole_shell and not self.water.boils(ready, vessel):
            self.open_into(ready, vessel)
            return
        stuff, source = ready.stuff, ready.stuff.at
        if source is vessel:
            return
        if vessel.device is not None:
            self._draw(ready, slot)
        attested = self._with_spoon(self.bringing.way(Transport.of(ready, vessel, slot)))
        motion = attested.way[0]
        if motion in word_list("is smeared by"):
            self._soften(stuff)
        smears = motion in word_list("greases") and form_of(self.known, stuff.label, stuff.states) == "soft"
        comes = [stuff, *self._clinging(stuff, source)] if motion in {"pour", "drip"} else [stuff]
        self.bench.bring(comes, vessel, attested, onto=list(vessel.contents) if smears else ())

    def _draw(self, ready: Ready, slot: Slot | None) -> None:
        """Draw water into a jug for what stands under no tap; whatever else it is stays where it is."""
        if ready.stuff.at is not None and ready.stuff.at.label == TAP:
            jug = self.bench.vessel(JUG)
            self.bench.bring([ready.stuff], jug, self.bringing.way(Transport.of(ready, jug, slot)))

    def _clinging(self, stuff: Stuff, source: Vessel | None) -> list[Stuff]:
        """Return the fat in which a food was fried: nobody pours that out of its pan without it."""
        if source is None or source.storage or not (source.hot or "cooled" in stuff.states):
            return []
        others = [one for one in source.contents if one is not stuff]
        return others if all(self.known.foods.food(one.label).is_a("fat") for one in others) else []

    def _with_spoon(self, attested: Attested) -> Attested:
        """Return a way with the tool that scoops, where a video forgot to name it."""
        return self.preparer.with_tool(attested) if attested.way[0] in word_list("is scooped by") else attested

    def bring_part(self, ready: Ready, vessel: Vessel) -> None:
        """Bring some of a food in pieces that is ``ready`` into or onto a vessel."""
        self.bench.bring_part(ready.stuff, vessel, self.bringing.way(Transport.of(ready, vessel)))

    def open_into(self, ready: Ready, vessel: Vessel) -> None:
        """Open a food in its shell that is ``ready`` over a vessel.

        Raises :class:`RefusedError` where nothing opens it.
        """
        attested = self.preparer.opening(ready.want)
        if attested is None:
            raise RefusedError(f"nothing opens {ready.want.label}")
        state = self.preparer.gives(attested.way, ("shell", "open"))
        self.bench.bring([ready.stuff], vessel, attested, (state,))
        ready.whole_shell = False

    # --- some of the fat ---

    def add_fat(self, vessel: Vessel, plan: Plan) -> bool:
        """Bring some of the fat that was asked for into ``vessel``, a pan; return whether ``plan`` has any."""
        fats = [j.want for j in plan.joins if j.want.facts.is_a("fat") and j.want.facts.is_a("stock")]
        fats.sort(key=lambda want: not want.facts.is_a("liquid"))
        if not fats:
            return False
        taken = self.bench.fetch(fats[0].label, fats[0].leaf, [fats[0].number], fats[0].storage, stands=fats[0].stands)
        self.bring(Ready(fats[0], taken), vessel, None)
        return True

    def grease(self, fat: Want, tin: Vessel) -> None:
        """Spread some of a fat in a tin, or pour it where it runs."""
        self.smear(Ready(fat, self.bench.fetch(fat.label, fat.leaf, [fat.number], fat.storage, stands=fat.stands)), tin)

    def bring_joining(self, join: Join, ready: Ready, vessel: Vessel) -> None:
        """Bring what is ``ready`` of a food into a vessel as it joins there; fat under all else greases it."""
        if join.layer < 0 and join.want.facts.is_a("fat"):
            self.smear(ready, vessel)
        else:
            self.bring(ready, vessel, join.slot)

    def smear(self, fat: Ready, tin: Vessel) -> None:
        """Spread fat that is ready in a tin, or pour it where it runs."""
        runs = form_of(self.known, fat.want.label, fat.stuff.states) == "liquid"
        attested = None if runs else self.bench.attest(self.bench.ways_by(word_list("greases")), fat.want.names)
        if attested is None:
            self.bring(fat, tin, None)
        else:
            self._soften(fat.stuff)
            self.bench.bring([fat.stuff], tin, attested)

    @staticmethod
    def _soften(stuff: Stuff) -> None:
        """Let fat that is spread have lain out of the refrigerator: nobody spreads it as hard as it is there."""
        fresh = stuff.at is not None and bool(stuff.at.storage)
        if fresh and says(stuff.states, "is hard in the refrigerator"):
            stuff.states = (min(word_list("is soft so")),)

    # --- all that is in a vessel ---

    def transfer(self, source: Vessel, target: Vessel, stage: Stage, *, whole: bool = False) -> None:
        """Bring all that is in ``source`` into ``target`` (as one piece: ``whole``), as ``stage`` has it.

        Water runs off in a strainer. Raises :class:`RefusedError` where nothing brings it.
        """
        stuffs = list(source.contents)
        if solid := self._strained(stuffs, target):
            self.water.drain(source, target, solid)
            return
        if self._is_in_tin(source):
            self._cool(source)
        moved = [stuff for stuff in stuffs if not self._stays_in_the_pan(stuff, stuffs)]
        foods = foods_of(source)
        smeared = None if whole else self._smearing(stage, moved, target)
        if smeared is not None:
            self.bench.bring(moved, target, smeared, onto=list(target.contents))
            return
        ways = self._ways_out(source, moved, stage, whole=whole)
        if self._is_portioned(moved, target):
            ways = self._by_the_spoon()[:1] or ways
        attested = self.bench.attest(ways[:1], foods) or self.bench.require(ways, foods)
        self.bench.bring(moved, target, attested, leaves=len(moved) < len(stuffs))

    def _smearing(self, stage: Stage, stuffs: Sequence[Stuff], target: Vessel) -> Attested | None:
        """Return how a stage spreads ``stuffs`` on what is in a vessel, where it does: none of them is in one piece."""
        if not target.contents or "coat" not in stage.does or stage.motion not in word_list("greases"):
            return None
        if any(not SOLID.isdisjoint(stuff.states) for stuff in stuffs):
            return None
        foods = tuple(dict.fromkeys(food for stuff in stuffs for food in stuff.foods))
        if self._is_dry(foods):
            return self.bench.near_or_far(self.bench.ways_by(word_list("puts on what is dry")), foods)
        return self.bench.attest(self.bench.operators.ways_of(stage.motion), foods)

    def _is_dry(self, foods: Sequence[str]) -> bool:
        """Whether foods make a powder together: nothing in them makes a paste of that."""
        dry = word_list("only flavours")
        return all(
            form_of(self.known, food, ()) == "powder" or self.known.foods.food(food).is_any(dry) for food in foods
        ) and not any(self.known.foods.food(food).is_any(word_list("makes a paste of what is dry")) for food in foods)

    def _strained(self, stuffs: Sequence[Stuff], target: Vessel) -> list[Stuff]:
        """Return what stays in a strainer, without the water that runs off; nothing where none does."""
        row = self.known.utensil(target.label)
        if row is None or "strain" not in row.can:
            return []
        rest = [stuff for stuff in stuffs if stuff.mixed or not self.known.foods.food(stuff.label).is_a("water")]
        return rest if len(rest) < len(stuffs) else []

    def _stays_in_the_pan(self, stuff: Stuff, beside: Sequence[Stuff]) -> bool:
        """Whether liquid fat in which something was fried is left where it is: what clings to that is part of it."""
        if stuff.mixed or not stuff.wants or not is_liquid_fat(self.known.foods.food(stuff.label)):
            return False
        return any(other is not stuff and stuff.wants <= other.wants for other in beside)

    def _is_in_tin(self, vessel: Vessel) -> bool:
        """Whether something was baked in a tin with a rim."""
        row = self.known.utensil(vessel.label)
        return row is not None and row.group == "tins" and any(map(is_baked, vessel.contents))

    def _cool(self, vessel: Vessel) -> None:
        """Let what was baked cool in its tin, or it breaks when it comes out."""
        (whole, *others) = vessel.contents
        if vessel.hot and not others:
            self.bench.let_cool(vessel, whole, foods_of(vessel))

    # --- the ways out of a vessel ---

    def _ways_out(self, source: Vessel, moved: Sequence[Stuff], stage: Stage, *, whole: bool) -> list[Way]:
        """Return the ways to bring what is ``moved`` out of a vessel, that of the recorded ``stage`` first."""
        form = form_together(moved, self.known, whole=whole)
        ways = self._usual_ways(form, stage)
        if form == "whole":
            solid = whole or any(not SOLID.isdisjoint(stuff.states) for stuff in moved)
            ways = self._lifting(ways, source) if solid else self._spooning(ways, moved, source)
        if self._is_in_tin(source):
            return [way for way in ways if not way[1]] or ways  # nothing reaches under it
        return self._with_tools(ways) if source.hot else ways

    def _spooning(self, ways: list[Way], stuffs: Sequence[Stuff], source: Vessel) -> list[Way]:
        """Return the ways to move what has no form; out of a deep vessel it is spooned: a custard, but no dough."""
        row = self.known.utensil(source.label)
        deep = row is not None and row.group in word_list("is spooned out of")
        spoons = self._by_the_spoon()
        if not deep or not spoons or is_shaped(stuffs, self.known) or any(map(self._is_raw_dough, stuffs)):
            return ways
        return [*spoons, *(way for way in ways if way[0] not in word_list("picks up"))]

    def _is_raw_dough(self, stuff: Stuff) -> bool:
        foods = map(self.known.foods.food, stuff.foods)
        return not is_heated(stuff.states, self.known) and any(food.is_a("dough", "flour") for food in foods)

    def _usual_ways(self, form: str, stage: Stage) -> list[Way]:
        """Return the usual ways to bring foods of a form out of a vessel, that of the recorded ``stage`` first."""
        usual = self.bench.operators.brings(form, "vessel")
        ways = [way for way in usual if only_brings(self.known, way[0])]
        told: Way = (stage.motion, stage.tools)
        if told not in usual:
            told = (stage.motion, ())
        suits = form != "liquid" or told in usual
        return [told, *ways] if suits and self._moves(stage.motion, form) else ways

    def _moves(self, motion: str, form: str) -> bool:
        """Whether a motion, be it ``""``, brings foods of a form: nobody spreads what is in one piece."""
        return only_brings(self.known, motion) and (form != "whole" or motion not in word_list("greases"))

    def _with_tools(self, ways: Sequence[Way]) -> list[Way]:
        """Return ways of which nobody picks up with bare hands what is hot, where a tool does it."""
        bare = [way for way in ways if way[0] in word_list("picks up") and not way[1]]
        lifters = [way for way in self.bench.ways_by({way[0] for way in bare}) if self._lifts(way)]
        return [*lifters, *(way for way in ways if not lifters or way not in bare)]

    def _lifting(self, ways: Sequence[Way], source: Vessel) -> list[Way]:
        """Return the ways to move what is in one piece: nothing is poured, and with a tool first where it is hot."""
        ways = [way for way in ways if not pours(way[0])]
        if not source.hot:
            return ways
        flesh = any(is_uncut(stuff, self.known) for stuff in source.contents)
        return sorted(ways, key=lambda way: not (self._lifts(way) or (flesh and way[1])))

    def _lifts(self, way: Way) -> bool:
        """Whether a way is done with a tool that lifts what is hot."""
        rows = map(self.known.utensil, way[1])
        return any(row is not None and row.group in word_list("lifts what is hot") for row in rows)

    def _is_portioned(self, stuffs: Sequence[Stuff], target: Vessel) -> bool:
        """Whether batter comes onto a tray, or a filling onto what it fills: it is set on it spoon by spoon."""
        last = stuffs[-1]
        if last.label in word_list("is spooned onto what it fills") and self._is_filled(target):
            return True
        if not last.mixed or says(last.states, "keeps its shape") or not self._is_tray(target):
            return False
        raw = not any(is_heated(stuff.states, self.known) for stuff in stuffs)
        return raw and any(binds(stuff.foods, self.known) for stuff in stuffs)

    def _is_tray(self, vessel: Vessel) -> bool:
        row = self.known.utensil(vessel.label)
        return row is not None and "bake" in row.can and is_flat(vessel.label)

    def _is_filled(self, target: Vessel) -> bool:
        """Whether what lies in or on a vessel is filled: all that lies flat, and what is hollow."""
        foods = (self.known.foods.food(stuff.label) for stuff in target.contents)
        hollow = any(food.is_any(word_list("is filled with a spoon")) for food in foods)
        return bool(target.contents) and (hollow or is_flat(target.label))

    def _by_the_spoon(self) -> list[Way]:
        """Return the ways that fetch a portion with a tool."""
        ways = [way for way in self.bench.operators.ways.get("fetch", ()) if way[1]]
        return [way for way in ways if only_brings(self.known, way[0]) and "move" in self.known.motion(way[0]).does]


class Frying:
    """Brings fat that nobody asked for into the pans of one dish on a bench, as ``plan`` lets it."""

    def __init__(self, bench: Bench, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan

    def add_fat(self, pan: Vessel, comes: Sequence[Stuff]) -> bool:
        """Bring some fat of the household into a ``pan`` for what ``comes`` into it; return whether that was due."""
        fat = self.plan.fat
        if fat is None or not self.is_due(pan, comes):
            return False
        runs = form_of(self.known, fat.label, fat.leaf) == "liquid"
        poured = self.bench.near_or_far([("pour", ())], fat.names) if runs else None
        if runs and poured is None:
            return False
        taken = self.bench.fetch(fat.label, fat.leaf, (), fat.storage, stands=fat.stands)
        self.bench.assumed[taken.number] = self._why(fat)
        way = poured or Bringing(self.bench).way(Transport.of(Ready(fat, taken), pan))
        self.bench.bring([taken], pan, way)
        return True

    def _why(self, fat: Want) -> str:
        """Return what is told of a portion of ``fat``: each is told, as the judge asks, and by its number."""
        why = _WHY.format(fat=fat.label)
        before = sum(told.startswith(why) for told in self.bench.assumed.values())
        return f"{why} (portion {before + 1})" if before else why

    def is_due(self, pan: Vessel, comes: Sequence[Stuff]) -> bool:
        """Return whether fat is due in a ``pan`` for what ``comes`` into it."""
        return not self.plan.in_glass and not pan.contents and self._is_dry(pan, comes)

    def keeps_dry(self, pan: Vessel, comes: Sequence[Stuff]) -> bool:
        """Return whether what ``comes``, foods or what was shaped of some, fries dry in a ``pan``, and gives no fat."""
        if any(stuff.mixed and not says(stuff.states, "keeps its shape") for stuff in comes):
            return False
        foods = [self.known.foods.food(food) for stuff in comes for food in stuff.foods]
        greasy = any(food.is_any(word_list("brings fat to the pan")) and not food.is_a("fat") for food in foods)
        return self.is_due(pan, comes) and not greasy and not _is_dough_without_fat(comes, foods)

    def _is_dry(self, pan: Vessel, comes: Sequence[Stuff]) -> bool:
        """Whether something of what ``comes`` would burn in a ``pan``, and nothing wets that or has fat of its own."""
        row = self.known.utensil(pan.label)
        if row is None or row.group not in word_list("holds what needs fat"):
            return False
        return any(map(self._burns, comes)) and not any(map(self._wets, comes))

    def _burns(self, stuff: Stuff) -> bool:
        """Whether a thing burns in a dry pan: flesh, vegetables, eggs, batter, and whatever was shaped."""
        if not stuff.mixed:
            return self.known.foods.food(stuff.label, stuff.states).is_any(word_list("burns in a dry pan"))
        return says(stuff.states, "keeps its shape") or self._sets(stuff)

    def _wets(self, stuff: Stuff) -> bool:
        """Whether a thing wets a pan, or gives fat in it."""
        if stuff.mixed:
            shaped = says(stuff.states, "keeps its shape") or self._sets(stuff)
            return not shaped and any(
                self.known.foods.food(food).is_any(word_list("keeps food from the pan")) for food in stuff.foods
            )
        facts = self.known.foods.food(stuff.label, stuff.states)
        return not facts.is_a("egg") and (
            says(stuff.states, "runs") or facts.is_any(word_list("keeps food from the pan"))
        )

    def _sets(self, stuff: Stuff) -> bool:
        """Whether a mixture sets in a pan: eggs do, and what is sweet in them only where flour is in it, too."""
        foods = [self.known.foods.food(food) for food in stuff.foods]
        eggs, flour, sweet = (
            any(food.is_any(word_list(one)) for food in foods)
            for one in ("sets in a pan", "makes a batter", "sweetens eggs")
        )
        return eggs and (flour or not sweet)


def _is_dough_without_fat(comes: Sequence[Stuff], foods: Sequence[Food]) -> bool:
    """Whether flat dough ``comes`` without fat among its ``foods`` (naan): the fat that is asked is for the bread."""
    dough = says([singular(stuff.label) for stuff in comes], "is cooked in a dry pan")
    return dough and not any(food.is_a("fat") for food in foods)
