"""Working on what is in a vessel: it is heated, stirred, tossed, and told as one thing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, foods_of, is_baked, is_flat, is_heated
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.making.outcome import Outcome, says_raw
from foon_kg.integration.making.rising import Rising
from foon_kg.integration.making.taking_out import TakingOut
from foon_kg.integration.making.ways import Ways
from foon_kg.integration.teaching.forms import form_of, is_liquid_fat
from foon_kg.integration.teaching.operators import Attested
from foon_kg.world import Mention, Step


class Worker:
    """Works on foods on a bench: in these ``ways``, with this ``outcome``."""

    def __init__(self, bench: Bench, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan
        self.ways = Ways(bench)
        self.outcome = Outcome(bench, plan)
        self.rising = Rising(bench, plan)
        self.taking_out = TakingOut(bench, plan)

    # --- told as one thing ---

    def name(self, vessel: Vessel, label: str, states: tuple[str, ...] | None = None) -> None:
        """Let the last step tell what is in a ``vessel`` as one thing called ``label``, in ``states`` if said.

        It has to be the step that brought the last of that: a product needs no step of its own to be named (C3).
        """
        parts = list(vessel.contents)
        if len(parts) == 1 and parts[0].label == label:
            return
        whole = self._whole(vessel, label)
        whole.states = whole.states if states is None else states
        vessel.contents[:] = [whole]
        last = self.bench.done[-1]
        self.bench.done[-1] = last._replace(step=self._told_as_one(last.step, vessel, parts))

    def _told_as_one(self, step: Step, vessel: Vessel, parts: Sequence[Stuff]) -> Step:
        """Return a step that tells ``parts``, some of which it brought, as the one thing that a vessel holds now."""
        (whole,) = vessel.contents
        shown = {mention.thing for mention in step.inputs}
        inputs = [*step.inputs, *(self.bench.mention(stuff) for stuff in parts if stuff.number not in shown)]
        hidden = {vessel.number, *(stuff.number for stuff in parts)}
        others = [mention for mention in step.outputs if mention.thing not in hidden]
        outputs = [self.bench.mention(vessel), self.bench.mention(whole), *others]
        if not _show_more(outputs, inputs):  # a step that shows nothing new is none: it tells what came to it, too
            came = hidden - {vessel.number, whole.number}
            outputs += [mention for mention in step.outputs if mention.thing in came]
        return replace(step, inputs=tuple(inputs), outputs=tuple(outputs))

    def _whole(self, vessel: Vessel, label: str) -> Stuff:
        """Return what is in a vessel as one thing."""
        states = self.outcome.kept_states(vessel)
        foods = tuple(sorted({food for stuff in vessel.contents for food in stuff.foods}))
        wants = frozenset().union(*(stuff.wants for stuff in vessel.contents))
        same = next((stuff.number for stuff in vessel.contents if stuff.mixed and stuff.label == label), None)
        return Stuff(label, same or self.bench.number(), states, foods, wants, vessel, mixed=True)

    # --- stirred into what is there ---

    def lies_unmixed(self, vessel: Vessel) -> bool:
        """Whether something lies beside what was mixed before, uncooked, in a vessel in which it can be stirred."""
        mixed = [s for s in vessel.contents if s.mixed and not {"blended", "mixed"}.isdisjoint(s.states)]
        if not mixed or is_flat(vessel.label) or any(is_heated(stuff.states, self.known) for stuff in mixed):
            return False
        return not self._lies_on_top([stuff for stuff in vessel.contents if stuff not in mixed])

    def _lies_on_top(self, stuffs: Sequence[Stuff]) -> bool:
        """Whether foods are toppings, or what comes out of an oven in one piece is among them."""
        return any(map(is_baked, stuffs)) or all(self._is_a_topping(stuff) for stuff in stuffs)

    def _is_a_topping(self, stuff: Stuff) -> bool:
        facts = self.known.foods.food(stuff.label)
        toasted = facts.is_any(word_list("stays firm once it is toasted")) and is_heated(stuff.states, self.known)
        return toasted or facts.is_a("topping")

    def lies_on_what_is_done(self, stuff: Stuff, vessel: Vessel) -> bool:
        """Return whether ``stuff`` that came to what was cooked in ``vessel`` is one that nobody leaves on it.

        Noodles and butter are such.
        """
        if is_flat(vessel.label) or self.plan.stacked or self.plan.laid:
            return False
        done = [one for one in vessel.contents if one.mixed and one is not stuff]
        return self._is_tossed(stuff) and len(done) == 1 and self.outcome.is_cooked_loose(done[0])

    def _is_tossed(self, stuff: Stuff) -> bool:
        facts = self.known.foods.food(stuff.label, stuff.states)
        named = facts.is_any(word_list("is eaten with a sauce")) and self.outcome.is_named_after(facts)
        return (named or facts.is_any(word_list("is stirred into what is done"))) and not facts.is_a("topping")

    def toss(self, vessel: Vessel) -> None:
        """Stir what came to a dish that is done in ``vessel`` into it."""
        self.stir(vessel, self.plan.label, tuple(sorted({*self.outcome.kept_states(vessel), "mixed"})))

    def stir(self, vessel: Vessel, label: str, states: tuple[str, ...] = ("mixed",)) -> None:
        """Stir all that is in a vessel; it is one thing called ``label`` in these states then."""
        self.bench.work(vessel, self.ways.stirring(foods_of(vessel)), label, states, with_device=False)

    # --- heated ---

    def work_each(self, vessel: Vessel, attested: Attested, states: tuple[str, ...], *, with_device: bool) -> None:
        """Work on all foods of a vessel as is ``attested``, each of which stays what it is and has ``states`` then.

        ``with_device``: what the vessel stands on takes part.
        """
        stuffs = list(vessel.contents)
        device = vessel.device if with_device else None
        heats = device is not None and not self.known.motion(attested.way[0]).does.isdisjoint({"heat", "warm"})
        clinging = self._fat_that_clings(stuffs) if heats else []

        def change() -> None:
            before = [stuff.states for stuff in stuffs]
            for stuff in stuffs:
                if clinging and stuff.mixed:
                    stuff.foods = tuple(sorted({*stuff.foods, *(fat.label for fat in clinging)}))
                    stuff.wants |= frozenset().union(*(fat.wants for fat in clinging))
                if not self._stays_as_it_is(stuff):
                    stuff.states = self._worked(stuff, states, over_heat=device is not None)
            if heats and [stuff.states for stuff in stuffs] == before:
                self._bring_to_the_boil(stuffs)
            vessel.hot = attested.way[0] not in word_list("cools") and (vessel.hot or heats)

        self.bench.emit(attested, [vessel, *([(device, vessel)] if device else []), *stuffs], change, [vessel, *stuffs])

    def _bring_to_the_boil(self, stuffs: Sequence[Stuff]) -> None:
        """Have the water among ``stuffs`` boil, where all the rest was fried before and is as it was."""
        for stuff in stuffs:
            if not stuff.mixed and self.known.foods.food(stuff.label).is_a("water"):
                stuff.states = tuple(sorted({*stuff.states, "boiling"}))

    def _stays_as_it_is(self, stuff: Stuff) -> bool:
        """Whether it is water, however long it boils, or liquid fat, whatever is fried in it."""
        facts = self.known.foods.food(stuff.label)
        return not stuff.mixed and (facts.is_a("water") or is_liquid_fat(facts))

    def _worked(self, stuff: Stuff, states: tuple[str, ...], *, over_heat: bool) -> tuple[str, ...]:
        """Return the states of a food that work gives ``states``: what melts is melted, and nothing is raw any more."""
        facts = self.known.foods.food(stuff.label)
        melts = facts.is_a("fat", *word_list("melts in the heat")) and not facts.is_a("liquid")
        if over_heat and melts and not stuff.mixed:
            return ("melted",)
        given = set(states) - ({*word_list("only what lies in one piece is so")} if self._is_strewn(stuff) else set())
        return tuple(sorted({*(state for state in stuff.states if not says_raw(state, self.known)), *given}))

    def _is_strewn(self, stuff: Stuff) -> bool:
        """Whether it is a liquid or a powder on what is turned over, and nothing that is turned itself."""
        return not stuff.mixed and form_of(self.known, stuff.label, stuff.states) in {"liquid", "powder"}

    def _fat_that_clings(self, stuffs: Sequence[Stuff]) -> list[Stuff]:
        """Return the liquid fat of which some clings to the one thing fried in it, where that is made of several."""
        foods = self.known.foods
        fats = [stuff for stuff in stuffs if not stuff.mixed and is_liquid_fat(foods.food(stuff.label))]
        others = [stuff for stuff in stuffs if stuff not in fats]
        return fats if len(others) == 1 and others[0].mixed else []

    def heat_fat(self, vessel: Vessel) -> None:
        """Melt the fat that is alone in ``vessel``, a pan over the heat, or let it get hot, before all else comes."""
        stuffs, device = list(vessel.contents), vessel.device
        if device is None or vessel.hot or not self._is_only_fat(stuffs):
            return
        solid = [stuff for stuff in stuffs if form_of(self.known, stuff.label, stuff.states) != "liquid"]
        motions = word_list("makes fat run" if solid else "makes fat hot")
        attested = self.bench.near_or_far([way for way in self.bench.ways_by(motions) if not way[1]], foods_of(vessel))
        if attested is None:
            return

        def change() -> None:
            vessel.hot = True
            for stuff in solid:
                stuff.states = ("melted",)

        self.bench.emit(attested, [vessel, (device, vessel), *stuffs], change, [vessel, *stuffs])

    def _is_only_fat(self, stuffs: Sequence[Stuff]) -> bool:
        fat = (not stuff.mixed and self.known.foods.food(stuff.label).is_a("fat") for stuff in stuffs)
        return bool(stuffs) and all(fat)

    def cook_first_side(self, vessel: Vessel) -> None:
        """Cook on one side what runs and lies in ``vessel``, a pan over the heat; till then nobody can turn it over."""
        mixed = [stuff for stuff in vessel.contents if stuff.mixed]
        if vessel.device is None or vessel.relation != "on" or len(mixed) != 1:
            return
        if self._is_half_done(vessel) or is_heated(mixed[0].states, self.known):
            return
        attested = self.bench.attest(self.ways.cooking(), foods_of(vessel))
        if attested is not None:
            self.bench.work(vessel, attested, mixed[0].label, ("partly cooked",))

    def _is_half_done(self, vessel: Vessel) -> bool:
        return any(self.known.state(state).half for stuff in vessel.contents for state in stuff.states)


def _show_more(outputs: Iterable[Mention], inputs: Iterable[Mention]) -> bool:
    """Whether some of the nodes of ``outputs`` are none of ``inputs``."""
    return not {mention.node for mention in outputs} <= {mention.node for mention in inputs}
