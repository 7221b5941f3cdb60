"""Working on what is in a vessel: in which way, what comes of it, and what that is called."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from foon_kg.food import Food, Tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, foods_of, is_flat
from foon_kg.integration.joining.course import COATS, HEATS, MIXES, WORKS, Plan
from foon_kg.integration.making.alone import says_raw
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Asked, Phase, Stage
from foon_kg.integration.teaching.operators import Attested, Nearness, Way, is_liquid_fat
from foon_kg.world.becoming import meets

_MIXTURE = "mixture"

_POWDER = 5
"""So fine that nothing of it stays in a strainer."""

_LEAST = 2
"""Of as many foods is something of which one can be taken out."""

_RISEN = frozenset({"fermented", "proofed", "risen"})


class Worker:
    """Works on foods on a bench, and tells what comes of it."""

    def __init__(self, bench: Bench, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan

    def name(self, vessel: Vessel, label: str) -> None:
        """Let the last step tell what is in a vessel as one thing."""
        last = self.bench.done[-1]
        if len(vessel.contents) == 1 and vessel.contents[0].label == label:
            return
        whole = self._whole(vessel, label, self.kept_states(vessel))
        numbers = {stuff.number for stuff in vessel.contents}
        before = {mention.thing for mention in last.step.inputs}
        others = [stuff for stuff in vessel.contents if stuff.number not in before]
        vessel.contents[:] = [whole]
        outputs = [m for m in last.step.outputs if m.thing not in numbers and m.thing != vessel.number]
        inputs = [*last.step.inputs]
        shown = {mention.thing for mention in inputs}
        inputs += [self.bench.mention(stuff) for stuff in others if stuff.number not in shown]
        told = [self.bench.mention(vessel), self.bench.mention(whole), *outputs]
        if {mention.node for mention in told} <= {mention.node for mention in inputs}:
            told += [m for m in last.step.outputs if m.thing in numbers - {whole.number}]  # more of what is in it
        step = replace(last.step, inputs=tuple(inputs), outputs=tuple(told))
        self.bench.done[-1] = replace(last, step=step)

    def kept_states(self, vessel: Vessel) -> tuple[str, ...]:
        """Return the states that the one mixture in a vessel keeps when something joins it."""
        mixed = [stuff for stuff in vessel.contents if stuff.mixed]
        mixed = [stuff for stuff in mixed if stuff.label == self.plan.label] or mixed  # the dish, beside its frosting
        states = mixed[0].states if len(mixed) == 1 else ()
        beside = [stuff for stuff in vessel.contents if stuff not in mixed]
        tops = {join.want.number for join in self.plan.joins if join.on_top}
        laid = self.plan.stacked or is_flat(vessel.label) or all(stuff.wants <= tops for stuff in beside)
        stacked = laid and any(not self.known.foods.food(stuff.label).is_a("topping", "herb") for stuff in beside)
        dropped = {"blended", "mixed"} if stacked else set()  # what is laid on each other is no mixture
        return tuple(s for s in states if not self.known.state(s).half and s not in dropped)

    def _whole(self, vessel: Vessel, label: str, states: tuple[str, ...]) -> Stuff:
        foods = tuple(sorted({food for stuff in vessel.contents for food in stuff.foods}))
        wants = frozenset().union(*(stuff.wants for stuff in vessel.contents))
        same = next((stuff.number for stuff in vessel.contents if stuff.mixed and stuff.label == label), None)
        return Stuff(label, same or self.bench.number(), states, foods, wants, vessel, mixed=True)

    def lies_unmixed(self, vessel: Vessel) -> bool:
        """Whether something lies beside what was mixed before, uncooked, in a vessel in which it can be stirred."""
        mixed = [s for s in vessel.contents if s.mixed and not {"blended", "mixed"}.isdisjoint(s.states)]
        cooked = any(self.known.state(state).needs_heat for stuff in mixed for state in stuff.states)
        beside = [stuff for stuff in vessel.contents if stuff not in mixed]
        tops = all(self._is_a_topping(stuff) for stuff in beside)
        tops = tops or any("baked" in stuff.states for stuff in beside)
        return bool(mixed) and not tops and not cooked and not is_flat(vessel.label)

    def _is_a_topping(self, stuff: Stuff) -> bool:
        facts = self.known.foods.food(stuff.label)
        toasted = facts.is_a(*word_list("stays firm once it is toasted")) and self._is_cooked(stuff)
        return toasted or facts.is_a("topping")

    def _is_cooked(self, stuff: Stuff) -> bool:
        return any(self.known.state(state).needs_heat for state in stuff.states)

    def lies_on_what_is_done(self, stuff: Stuff, vessel: Vessel) -> bool:
        """Whether a food that came to what was cooked in a vessel is one that nobody leaves on it: noodles, butter."""
        if is_flat(vessel.label) or self.plan.stacked or self.plan.laid:
            return False
        done = [one for one in vessel.contents if one.mixed and one is not stuff]
        return self._is_tossed(stuff) and len(done) == 1 and self._is_cooked_loose(done[0])

    def _is_tossed(self, stuff: Stuff) -> bool:
        facts = self.known.foods.food(stuff.label, stuff.states)
        named = facts.is_a(*word_list("is eaten with a sauce")) and self._is_named_after(facts)
        return (named or facts.is_a(*word_list("is stirred into what is done"))) and not facts.is_a("topping")

    def _is_cooked_loose(self, stuff: Stuff) -> bool:
        return "baked" not in stuff.states and self._is_cooked(stuff)

    def toss(self, vessel: Vessel) -> None:
        """Stir what came to a dish that is done into it."""
        states = tuple(sorted({*self.kept_states(vessel), "mixed"}))
        self.bench.work(vessel, self.stirring(foods_of(vessel)), self.plan.label, states, with_device=False)

    def work_each(self, vessel: Vessel, attested: Attested, states: tuple[str, ...], *, with_device: bool) -> None:
        """Work on all foods of a vessel, each of which stays what it is."""
        stuffs = list(vessel.contents)
        device = vessel.device if with_device else None
        heats = not self.known.motion(attested.way[0]).does.isdisjoint({"heat", "warm"})
        clinging = self._fat_that_clings(stuffs) if heats and device is not None else []

        def change() -> None:
            for stuff in stuffs:
                facts = self.known.foods.food(stuff.label)
                if clinging and stuff.mixed:
                    stuff.foods = tuple(sorted({*stuff.foods, *(fat.label for fat in clinging)}))
                    stuff.wants |= frozenset().union(*(fat.wants for fat in clinging))
                if not stuff.mixed and (facts.is_a("water") or is_liquid_fat(facts)):
                    continue  # however long it boils, and whatever is fried in it
                kept = [s for s in stuff.states if not says_raw(s, self.known)]
                melts = (
                    facts.is_a("fat", *word_list("melts in the heat")) and not facts.is_a("liquid") and not stuff.mixed
                )
                stuff.states = ("melted",) if melts and device is not None else tuple(sorted({*kept, *states}))
            cools = attested.way[0] in word_list("cools")
            vessel.hot = not cools and (vessel.hot or (device is not None and heats))

        self.bench.emit(attested, [vessel, *([(device, vessel)] if device else []), *stuffs], change, [vessel, *stuffs])

    def _fat_that_clings(self, stuffs: Sequence[Stuff]) -> list[Stuff]:
        """Return the liquid fat of which some clings to the one thing fried in it, where that is made of several."""
        foods = self.known.foods
        fats = [stuff for stuff in stuffs if not stuff.mixed and is_liquid_fat(foods.food(stuff.label))]
        others = [stuff for stuff in stuffs if stuff not in fats]
        return fats if len(others) == 1 and others[0].mixed else []

    def let_rise(self, vessel: Vessel, stages: Sequence[Stage]) -> None:
        """Knead a dough that needs it and let it rise, where the video has no such stage: its dough was another one."""
        foods = foods_of(vessel)
        facts = [self.known.foods.food(food) for food in foods]
        dough = any(one.is_a("flour", "dough") for one in facts)
        if not dough or not any(one.is_a(*word_list("makes dough rise")) for one in facts):
            return
        rises = sorted(word_list("rises"))
        if any(stage.motion in rises for stage in stages) or any("rested" in stuff.states for stuff in vessel.contents):
            return
        kneads = any("knead" in stage.does for stage in stages)
        works = (
            [] if kneads else [([way for way in self.bench.operators.ways.get("knead", ()) if not way[1]], "kneaded")]
        )
        works.append(([way for motion in rises for way in self.bench.operators.ways_of(motion)], "rested"))
        if self.plan.portioned:
            works.append(([way for way in self.bench.operators.ways.get("cut", ()) if way[1]], "cut in pieces"))
        if self.plan.flat:
            works.append(([("press", ())], "flattened"))
        elif not any("shape" in stage.does for stage in stages):
            works.append(([("shape", ())], "shaped"))
        for ways, state in works:
            attested = self.bench.attest(ways, foods) or self.bench.far(ways, foods)
            whole = vessel.contents[0]
            if attested is not None:
                states = tuple(sorted({*whole.states, state}))
                self.bench.work(vessel, attested, whole.label, states, with_device=False)

    def heat_fat(self, vessel: Vessel) -> None:
        """Melt the fat that is alone in a pan over the heat, or let it get hot, before anything else comes into it."""
        stuffs = [stuff for stuff in vessel.contents if not stuff.mixed]
        foods = [self.known.foods.food(stuff.label) for stuff in stuffs]
        device = vessel.device
        if device is None or vessel.hot or not stuffs or not all(food.is_a("fat") for food in foods):
            return
        solid = [stuff for stuff, food in zip(stuffs, foods, strict=True) if not food.is_a("liquid")]
        motions = word_list("makes fat run" if solid else "makes fat hot")
        ways = [way for motion in sorted(motions) for way in self.bench.operators.ways_of(motion) if not way[1]]
        attested = self.bench.attest(ways, foods_of(vessel))
        if attested is None or len(stuffs) < len(vessel.contents):
            return

        def change() -> None:
            vessel.hot = True
            for stuff in solid:
                stuff.states = ("melted",)

        self.bench.emit(attested, [vessel, (device, vessel), *stuffs], change, [vessel, *stuffs])

    def cook_first_side(self, vessel: Vessel) -> None:
        """Cook on one side what runs and lies in a pan over the heat: before that nobody can turn it over."""
        half = {state for stuff in vessel.contents for state in stuff.states if self.known.state(state).half}
        mixed = [stuff for stuff in vessel.contents if stuff.mixed]
        done = any(self.known.state(state).needs_heat for stuff in mixed for state in stuff.states)
        if vessel.device is None or vessel.relation != "on" or len(mixed) != 1 or half or done:
            return
        ways = [way for way in self.bench.operators.ways.get("heat", ()) if self.known.motion(way[0]).does == {"heat"}]
        ways = [way for way in ways if "cooked" in self.known.motion(way[0]).gives]
        attested = self.bench.attest(ways, foods_of(vessel))
        if attested is not None:
            self.bench.work(vessel, attested, mixed[0].label, ("partly cooked",))

    def take_out(self, vessel: Vessel) -> Vessel:
        """Take out of what was cooked in a liquid what only gave it its taste, where the FOON shows how.

        Return what the rest is in then: what is drunk is poured through a strainer.
        """
        wants = self._inside(vessel, self.is_taken_out)
        loose = any(not want.facts.is_a(*word_list("is taken out of the dish")) for want in wants)
        if self.plan.drunk and loose and len(vessel.contents) == 1:  # a bag or a stick is lifted out
            return self._strain(vessel, wants)
        ways = [way for motion in sorted(word_list("takes out")) for way in self.bench.operators.ways_of(motion)]
        ways = [way for way in ways if any(self._lifts(tool) for tool in way[1])]
        for whole in list(vessel.contents):
            lifted = [want for want in wants if want.number in whole.wants and self._is_in_one_piece(want)]
            lifted = lifted[: max(0, len(whole.wants) - _LEAST + 1)]
            attested = (
                self.bench.attest(ways, lifted[0].names) or self.bench.far(ways, lifted[0].names) if lifted else None
            )
            if attested is not None:
                self._take_out(vessel, whole, lifted, attested)
        return vessel

    def strained(self, vessel: Vessel) -> Vessel:
        """Pour what was blended through a strainer, in which stays what does not run; return what the rest is in."""
        wants = self._inside(vessel, lambda want: want.facts.is_a(*word_list("stays in a strainer")))
        return self._strain(vessel, wants) if wants and len(vessel.contents) == 1 else vessel

    def _inside(self, vessel: Vessel, is_such: Callable[[Want], bool]) -> list[Want]:
        """Return the asked foods of a kind that are in a vessel."""
        inside = {number for stuff in vessel.contents for number in stuff.wants}
        return [join.want for join in self.plan.joins if join.want.number in inside and is_such(join.want)]

    def _strain(self, vessel: Vessel, wants: Sequence[Want]) -> Vessel:
        """Pour what is drunk through a strainer, in which stays what gave its taste; return what the rest is in."""
        through = [way for motion in sorted(word_list("strains")) for way in self.bench.operators.ways_of(motion)]
        attested = self.bench.attest(through, foods_of(vessel)) or self.bench.far(through, foods_of(vessel))
        if attested is None:
            return vessel
        strainer, jug = self.bench.vessel("strainer"), self.bench.vessel("pitcher")
        (whole,) = vessel.contents
        whole_states = tuple(state for state in whole.states if state in {"blended", "cooked"})
        left = [
            Stuff(want.label, self.bench.number(), whole_states, (want.label,), frozenset(), strainer) for want in wants
        ]

        def change() -> None:
            whole.foods = tuple(food for food in whole.foods if food not in {want.label for want in wants})
            whole.wants -= {want.number for want in wants}
            strainer.contents += left
            vessel.contents.clear()
            jug.contents.append(whole)
            whole.at = jug

        self.bench.emit(attested, [vessel, whole, strainer, jug], change, [jug, whole, strainer, *left, vessel])
        return jug

    def is_taken_out(self, want: Want) -> bool:
        """Whether a food only gives its taste, and nobody eats or drinks it."""
        strained = self.plan.drunk and want.facts.is_a(*word_list("is taken out of what is drunk"))
        strained = strained and not (want.make and (self.known.state(want.make).fine or 0) >= _POWDER)
        return strained or want.facts.is_a(*word_list("is taken out of the dish"))

    def _lifts(self, tool: str) -> bool:
        row = self.known.utensil(tool)
        return row is not None and "lift" in row.can

    def _is_in_one_piece(self, want: Want) -> bool:
        """Whether a food is still in one piece that can be lifted out: no chopped herb, nor leaves off their stem."""
        states = [state for state in (want.make, want.then, *want.leaf) if state]
        if want.facts.is_a(*word_list("is a leaf by itself")):
            states = [state for state in states if state not in word_list("is plucked off its stem")]
        elif not word_list("is plucked off its stem").isdisjoint(words(want.label)):
            return False
        plucked = not word_list("is plucked off its stem").isdisjoint(states)
        return not plucked and not any((self.known.state(state).fine or 0) > 0 for state in states)

    def _take_out(self, vessel: Vessel, whole: Stuff, wants: Sequence[Want], attested: Attested) -> None:
        plate = self.bench.vessel("plate")
        parts = [
            Stuff(want.label, self.bench.number(), ("cooked",), (want.label,), frozenset(), plate) for want in wants
        ]

        def change() -> None:
            whole.foods = tuple(food for food in whole.foods if food not in {want.label for want in wants})
            whole.wants -= {want.number for want in wants}
            plate.contents += parts

        self.bench.emit(attested, [vessel, whole, plate], change, [vessel, whole, plate, *parts])

    def let_rise_again(self, vessel: Vessel) -> None:
        """Let dough with yeast that rested and was shaped then rise where it is to be baked."""
        dough = next((stuff for stuff in vessel.contents if {"rested", "shaped"} <= set(stuff.states)), None)
        if dough is None or any(self.known.state(state).half for state in dough.states):
            return
        if not self.rises(dough.foods) or not _RISEN.isdisjoint(dough.states):
            return
        ways = [way for motion in sorted(word_list("rises")) for way in self.bench.operators.ways_of(motion)]
        attested = self.bench.attest(ways, dough.foods) or self.bench.far(ways, dough.foods)
        if attested is None:
            return
        states = tuple(sorted({*dough.states, *sorted(_RISEN & self.known.motion(attested.way[0]).gives)[:1]}))

        def change() -> None:
            dough.states = states

        self.bench.emit(attested, [vessel, dough], change, [vessel, dough])

    def rises(self, foods: Sequence[str]) -> bool:
        """Whether such dough rises by itself, and is no flat bread."""
        rising = any(self.known.foods.food(food).is_a(*word_list("makes dough rise")) for food in foods)
        return rising and not self.plan.flat

    def way(self, stage: Stage, vessel: Vessel) -> Attested | None:
        """Return how a stage is done to what is in the vessel, nearest to what the FOON attests, or ``None``."""
        foods = foods_of(vessel)
        if stage.does >= COATS:
            return self.bench.require([(stage.motion, stage.tools)], foods)
        if stage.motion in word_list("needs a closed vessel") and not self._is_closed(vessel):
            return self.stirring(foods)
        if "heat" in stage.does and "heat" not in self.known.motion(stage.motion).does:
            return self.stirring_hot(foods)
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
        return self._attested(stage, foods)

    def _attested(self, stage: Stage, foods: Sequence[str]) -> Attested | None:
        if stage.motion in word_list("cools"):
            return self.bench.cooling(foods)
        own = self.bench.attest([(stage.motion, stage.tools)], foods)
        if own is not None and own.nearness <= Nearness.LIKE:
            return own
        found = self.bench.attest(self.bench.operators.ways_of(stage.motion), foods)
        if found is not None and (own is None or found.nearness < own.nearness):
            return found
        return own or self._in_its_stead(stage, foods)

    def _in_its_stead(self, stage: Stage, foods: Sequence[str]) -> Attested | None:
        """Return a way that does what a stage does, where its own motion is attested for nothing like these foods."""
        main = "heat" if "heat" in stage.does else next(iter(sorted(stage.does & WORKS)), "")
        ways = [way for way in self.bench.operators.ways.get(main, ()) if self.known.motion(way[0]).does == stage.does]
        pulls = stage.motion in word_list("pulls flesh apart")
        # to roll and to pinch are no less alike for other foods than what else shapes; blades take what they get
        if stage.does == {"shape"} or "blend" in stage.does or isinstance(stage, Asked) or pulls:
            own = self.bench.far([(stage.motion, stage.tools)], foods)
            if own is not None:
                return own
        found = self.bench.attest(ways, foods)
        if found is None and (isinstance(stage, Phase) or stage.does >= {"dry", "heat"}):
            found = self.bench.far([(stage.motion, stage.tools)], foods)
        if found is None and "knead" in stage.does:
            return self.stirring(foods)  # where nobody kneads, it is stirred together
        if found is None and not stage.does.isdisjoint(MIXES | HEATS):
            raise RefusedError(f"nothing attests “{stage.motion}” for {', '.join(foods)}")
        return found

    def _is_closed(self, vessel: Vessel) -> bool:
        return bool(vessel.lid) or vessel.label in word_list("closed vessels")

    def stirring(self, foods: Sequence[str]) -> Attested:
        """Return the likeliest way to mix foods through with a tool, as they are."""
        ways = [way for way in self.bench.operators.ways.get("mix", ()) if way[1]]
        return self.bench.require([way for way in ways if self.known.motion(way[0]).does == {"mix"}], foods)

    def stirring_hot(self, foods: Sequence[str]) -> Attested:
        """Return the likeliest way to cook foods while they are mixed."""
        ways = self.bench.operators.ways.get("heat", ())
        return self.bench.require([way for way in ways if self.known.motion(way[0]).does == {"heat", "mix"}], foods)

    def label(self, stage: Stage, vessel: Vessel, *, last: bool = False, main: bool = False) -> str:
        """Return what the whole is called after a stage: as in the frame where that is true of what is in it."""
        if last:
            return self.plan.label if self._is_the_dish(vessel) else _MIXTURE
        label = stage.label
        if label == self.plan.goal and main and not stage.does.isdisjoint(HEATS):
            return self.plan.label if self._is_the_dish(vessel) else _MIXTURE
        facts = self.known.foods.food(label, stage.states)
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        if not label or label in self.known.dishes or not facts.is_a("made", "dough"):
            return vessel.contents[0].label if self._foams(stage, vessel) else ""
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
        if not all(w in names for w in named):
            return ""
        own = {*names, *self.plan.label.split()}
        *first, head = label.split()
        return " ".join([*(word for word in first if word in own), head])  # no biscuit dough where bread is made

    def _is_the_dish(self, vessel: Vessel) -> bool:
        """Whether what is boiled apart for a dish and gives it its name is in it yet, if that is to come: noodles."""
        naming = {join.want.number for join in self.plan.joins if self._gives_its_name(join.want)}
        return not naming or any(not naming.isdisjoint(stuff.wants) for stuff in vessel.contents)

    def _gives_its_name(self, want: Want) -> bool:
        """Whether a food is boiled by itself, and is what the dish is called after."""
        return want.facts.is_a(*word_list("is boiled by itself")) and self._is_named_after(want.facts)

    def _is_named_after(self, facts: Food) -> bool:
        """Whether a food is what makes the dish what it is called: rice in a dish of rice."""
        needs = {one for dish in self.known.dishes_named(self.plan.label) for need in dish.needs for one in need}
        return any(meets(one, facts, self.known) for one in needs)

    def coated(self, vessel: Vessel) -> str:
        """Return what the one food is called that lies in a vessel in what coats it, ``""`` where there are several."""
        coats = (*word_list("coats dry"), *word_list("coats wet"), *word_list("clings to what is coated"))
        facts = self.known.foods.food
        found = {s.label for s in vessel.contents if not all(facts(food).is_a(*coats) for food in s.foods)}
        return found.pop() if len(found) == 1 else ""

    def _heated(self, way: Way, *, finished: bool) -> set[str]:
        motion = self.known.motion(way[0])
        if "dry" in motion.does:
            return {"baked"}
        if "heat" in motion.does and "cooked" in motion.gives:
            return {"cooked" if finished else "partly cooked"}
        return {"heated"} if "warm" in motion.does and "heat" not in motion.does else set()

    def _stays_so(self, stage: Stage, vessel: Vessel) -> set[str]:
        """Return the states that a mixture keeps whatever is done to it: mixed, and what is blended stays cooked.

        What is fried or boiled in one piece keeps its shape, too; fat is no part of it.
        """
        foods = self.known.foods.food
        solids = [stuff for stuff in vessel.contents if stuff.mixed or not foods(stuff.label).is_a("fat")]
        if len(solids) != 1 or not solids[0].mixed:
            return set()
        (stuff,), heats = solids, not stage.does.isdisjoint(HEATS)
        kept = set(stuff.states) & (word_list("keeps its shape") - {"kneaded"}) if heats else set()
        if len(vessel.contents) > 1:
            return kept
        blends = "blend" in stage.does
        done = {s for s in stuff.states if s in {"mixed", "blended"} or (blends and self.known.state(s).needs_heat)}
        return kept | done

    def states(self, stage: Stage, vessel: Vessel, way: Way, *, product: bool, finished: bool) -> tuple[str, ...]:
        """Return in which states the foods of a vessel are after a stage; ``finished``: it is not heated any more."""
        does = self.known.motion(way[0]).does
        states = {"coated"} if stage.does >= COATS else set[str]()
        if "turn" in does and does.isdisjoint(HEATS) and len(vessel.contents) == 1:
            return tuple(sorted({*vessel.contents[0].states, "flipped"}))
        if product and "dry" not in does:
            states |= self._stays_so(stage, vessel)
        if ("blend" in does and "mix" not in stage.does) or way[0] == "blend":
            states.add("blended")
        elif not does.isdisjoint({"mix", "whip"}) and stage.does != {"shape"}:
            states |= set(stage.states) if self._foams(stage, vessel) else {"mixed"}
        if "knead" in does:
            states.add("kneaded")
        states |= self._heated(way, finished=finished)
        if way[0] in word_list("cools") and len(vessel.contents) == 1:
            states |= set(vessel.contents[0].states)
        if "wait" in does:
            states |= {"chilled"} if way[0] == "chill" else {"cooled"} if way[0] in word_list("cools") else {"rested"}
        if not states and stage.motion:
            able = sorted(s for s in stage.states if s in self.known.motion(way[0]).gives)
            states |= set(able[:1])
        if not does.isdisjoint({"shape", "turn", "cut", "peel"}) and does.isdisjoint(HEATS):
            own = [state for state in stage.states if state in self.known.motion(way[0]).gives]
            able = own or self.given_by(way)
            states |= set(able[:1]) if states.isdisjoint(able) else set()
            states |= set(vessel.contents[0].states) if len(vessel.contents) == 1 else set()
        return tuple(sorted(states))

    def _foams(self, stage: Stage, vessel: Vessel) -> bool:
        """Whether one food is beaten by itself to a foam, and is called as before."""
        foam = not word_list("is beaten to a foam").isdisjoint(stage.states)
        return foam and len(vessel.contents) == 1 and not vessel.contents[0].mixed

    def given_by(self, way: Way) -> list[str]:
        """Return the states that a way gives without heat, first the one called like it (shaped, not leveled)."""
        given = self.bench.operators.giving
        able = [s for s in given if way in given[s] and s in self.known.motion(way[0]).gives]
        cold = [s for s in able if not self.known.state(s).needs_heat]
        return sorted(cold, key=lambda s: (not s.startswith(way[0][:4]), s))
