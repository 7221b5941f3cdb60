"""What comes of work on what is in a vessel: what the whole is called then, and in which states it is."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Food, Tables
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, foods_of, is_baked, is_flat, is_heated
from foon_kg.integration.joining.course import COATS, Plan
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import HEATS, Stage
from foon_kg.integration.teaching.operators import Way
from foon_kg.world.becoming import meets

MIXTURE = "mixture"
"""What is called so that has no name of its own."""

_MIXED = frozenset({"blended", "mixed"})
"""The states of what is one thing by mixing, whatever is done to it afterwards."""

STEM = 4
"""So many letters of a motion begin a state that is called after it: boil and boiled, shape and shaped."""


class Outcome:
    """Tells what comes of the stages of one dish."""

    def __init__(self, bench: Bench, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan

    # --- what it is called ---

    def label(self, stage: Stage, vessel: Vessel, *, last: bool = False, main: bool = False) -> str:
        """Return what the whole is called after a stage: as in the frame where that is true of what is in ``vessel``.

        ``main``: it is on the dish's own line; ``last``: and nothing works on it any more.
        """
        is_goal = main and stage.label == self.plan.goal and stage.heats
        if last or is_goal:
            return self.plan.label if self._is_the_dish(vessel) else MIXTURE
        if not self._names_a_product(stage):
            return self._foam_of(vessel) if self._foams(stage, vessel) else ""
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        return self._product_label(stage.label, foods) if self._is_true_of(stage.label, foods) else ""

    def _names_a_product(self, stage: Stage) -> bool:
        """Whether a stage is said to make something that may be called so in another dish: dough, a sauce."""
        label = stage.label
        if not label or label in self.known.dishes:
            return False
        return self.known.foods.food(label, stage.states).is_a("made", "dough")

    def _is_true_of(self, label: str, foods: Sequence[Food]) -> bool:
        """Whether what a product of this name has to contain, and each food of its name, is among ``foods``."""
        if not all(self._has_one_of(needs, foods) for needs in self.known.contains.get(label, ())):
            return False
        names = {word for food in foods for word in food.name.split()}
        listed = (word for word in label.split() if self.known.foods.is_listed(word))
        return all(word in names or self.known.foods.food(word).is_a("made", "dough") for word in listed)

    def _has_one_of(self, needs: Sequence[str], foods: Sequence[Food]) -> bool:
        return any(meets(need, food, self.known) for need in needs for food in foods)

    def _product_label(self, label: str, foods: Sequence[Food]) -> str:
        """Return the name of a product with only those words that are true here: no biscuit dough makes bread."""
        own = {word for food in foods for word in food.name.split()} | {*self.plan.label.split()}
        *first, head = label.split()
        return " ".join([*(word for word in first if word in own), head])

    def _is_the_dish(self, vessel: Vessel) -> bool:
        """Whether what is boiled apart for a dish and gives it its name is in it yet, if that is to come: noodles."""
        naming = {join.want.number for join in self.plan.joins if self._gives_its_name(join.want)}
        return not naming or any(not naming.isdisjoint(stuff.wants) for stuff in vessel.contents)

    def _gives_its_name(self, want: Want) -> bool:
        """Whether a food is boiled by itself, and is what the dish is called after."""
        return want.facts.is_any(word_list("is boiled by itself")) and self.is_named_after(want.facts)

    def is_named_after(self, facts: Food) -> bool:
        """Return whether a food of these ``facts`` is what makes the dish what it is called: rice in a dish of rice."""
        needs = {one for dish in self.known.dishes_named(self.plan.label) for need in dish.needs for one in need}
        return any(meets(one, facts, self.known) for one in needs)

    def coated(self, vessel: Vessel) -> str:
        """Return what the one food is called that lies in a vessel in what coats it, ``""`` where there are several."""
        coats = (*word_list("coats dry"), *word_list("coats wet"), *word_list("clings to what is coated"))
        facts = self.known.foods.food
        found = {s.label for s in vessel.contents if not all(facts(food).is_any(coats) for food in s.foods)}
        return found.pop() if len(found) == 1 else ""

    def _foam_of(self, vessel: Vessel) -> str:
        """Return what a foam is called: as the food of it that foams."""
        facts = self.known.foods.food
        found = (stuff.label for stuff in vessel.contents if facts(stuff.label).is_any(word_list("foams")))
        return next(found, vessel.contents[0].label)

    # --- in which states it is ---

    def states(self, stage: Stage, vessel: Vessel, way: Way, *, product: bool, finished: bool) -> tuple[str, ...]:
        """Return in which states the foods of a vessel are after a stage that is done in some ``way``.

        ``product``: they are one thing then; ``finished``: it is not heated any more.
        """
        does = self.known.motion(way[0]).does
        by_hand = does.isdisjoint(HEATS)  # to turn what is in a pan cooks it besides, and is told by that
        if "turn" in does and by_hand and len(vessel.contents) == 1:
            return tuple(sorted({*vessel.contents[0].states, "flipped"}))
        states = set[str]()
        if product and "dry" not in does:
            states |= self._stays_so(stage, vessel)
        states |= self._mixed(stage, vessel, way) | self._heated(way, finished=finished) | self._waited(vessel, way)
        if not states and stage.motion:
            states |= set(sorted(self._given(stage, way))[:1])
        if by_hand and not does.isdisjoint({"shape", "turn", "cut", "peel"}):
            states |= self._shaped(stage, vessel, way, states)
        return tuple(sorted(states))

    def _mixed(self, stage: Stage, vessel: Vessel, way: Way) -> set[str]:
        """Return the states that mixing gives: coated, kneaded, blended, mixed; a foam is as its stage says."""
        does = self.known.motion(way[0]).does
        states = {"coated"} if stage.does >= COATS else set[str]()
        if "knead" in does:
            states.add("kneaded")
        if way[0] == "blend" or ("blend" in does and "mix" not in stage.does):
            return states | {"blended"}
        if does.isdisjoint({"mix", "whip"}) or stage.does == {"shape"}:
            return states
        return states | (set(stage.states) if self._foams(stage, vessel) else {"mixed"})

    def _foams(self, stage: Stage, vessel: Vessel) -> bool:
        """Whether one food is beaten by itself to a foam, or egg white with no more than what sweetens and holds it."""
        if not says(stage.states, "is beaten to a foam"):
            return False
        alone = len(vessel.contents) == 1 and not vessel.contents[0].mixed
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        return alone or all(food.is_any(word_list("is beaten in with what foams")) for food in foods)

    def _heated(self, way: Way, *, finished: bool) -> set[str]:
        motion = self.known.motion(way[0])
        if "dry" in motion.does:
            return {"baked"}
        if "heat" in motion.does and "cooked" in motion.gives:
            return {"cooked" if finished else "partly cooked"}
        return {"heated"} if "warm" in motion.does and "heat" not in motion.does else set()

    def _waited(self, vessel: Vessel, way: Way) -> set[str]:
        """Return the states that waiting gives: chilled, cooled, rested; one thing that cools stays what it is."""
        motion, cools = way[0], way[0] in word_list("cools")
        states = set(vessel.contents[0].states) if cools and len(vessel.contents) == 1 else set[str]()
        if "wait" in self.known.motion(motion).does:
            states.add("chilled" if motion == "chill" else "cooled" if cools else "rested")
        return states

    def _shaped(self, stage: Stage, vessel: Vessel, way: Way, states: set[str]) -> set[str]:
        """Return the states of what hands gave a form, beside ``states``: one thing stays what it is."""
        able = self._given(stage, way) or self._given_by(way)
        given = set(able[:1]) if states.isdisjoint(able) else set[str]()
        return given | set(vessel.contents[0].states) if len(vessel.contents) == 1 else given

    def _given(self, stage: Stage, way: Way) -> list[str]:
        """Return the states of a stage that a way gives by its motion."""
        return [state for state in stage.states if state in self.known.motion(way[0]).gives]

    def _given_by(self, way: Way) -> list[str]:
        """Return the states that a way gives without heat, first the one called like it (shaped, not leveled)."""
        given = self.bench.operators.giving
        able = [s for s in given if way in given[s] and s in self.known.motion(way[0]).gives]
        cold = [s for s in able if not self.known.state(s).needs_heat]
        return sorted(cold, key=lambda s: (not s.startswith(way[0][:STEM]), s))

    def _stays_so(self, stage: Stage, vessel: Vessel) -> set[str]:
        """Return the states that a mixture keeps whatever is done to it: mixed, and what is blended stays cooked.

        What is fried or boiled in one piece keeps its shape, too; fat is no part of it.
        """
        stuff = self._only_mixture(vessel)
        if stuff is None:
            return set()
        heats, blends = stage.heats, "blend" in stage.does
        kept = set(stuff.states) & (word_list("keeps its shape") - {"kneaded"}) if heats else set[str]()
        if len(vessel.contents) > 1:
            return kept
        return kept | {s for s in stuff.states if s in _MIXED or (blends and self.known.state(s).needs_heat)}

    def _only_mixture(self, vessel: Vessel) -> Stuff | None:
        """Return the mixture in a vessel, where nothing but fat is beside it."""
        foods = self.known.foods.food
        solids = [stuff for stuff in vessel.contents if stuff.mixed or not foods(stuff.label).is_a("fat")]
        return solids[0] if len(solids) == 1 and solids[0].mixed else None

    # --- what it keeps ---

    def kept_states(self, vessel: Vessel) -> tuple[str, ...]:
        """Return the states that the one mixture in a vessel keeps when something joins it."""
        whole = self._whole_in(vessel)
        if whole is None:
            return ()
        beside = [stuff for stuff in vessel.contents if stuff is not whole]
        dropped = _MIXED if self._is_laid_on(vessel, beside) else frozenset[str]()  # in layers nothing is mixed
        return tuple(s for s in whole.states if not self.known.state(s).half and s not in dropped)

    def _whole_in(self, vessel: Vessel) -> Stuff | None:
        """Return the one mixture in a vessel; beside its frosting the dish."""
        mixed = [stuff for stuff in vessel.contents if stuff.mixed]
        found = [stuff for stuff in mixed if stuff.label == self.plan.label] or mixed
        return found[0] if len(found) == 1 else None

    def _is_laid_on(self, vessel: Vessel, stuffs: Sequence[Stuff]) -> bool:
        """Whether foods are laid on what is in a vessel, as more than what only garnishes it."""
        tops = {join.want.number for join in self.plan.joins if join.on_top}
        if not (self.plan.stacked or is_flat(vessel.label) or all(stuff.wants <= tops for stuff in stuffs)):
            return False
        return any(not self.known.foods.food(stuff.label).is_a("topping", "herb") for stuff in stuffs)

    def is_cooked_loose(self, stuff: Stuff) -> bool:
        """Return whether ``stuff`` was cooked, and not baked in one piece."""
        return not is_baked(stuff) and is_heated(stuff.states, self.known)


def says_raw(state: str, known: Tables) -> bool:
    """Return whether a state says that a food is as yet uncooked, or in one piece as it was bought.

    ``known`` are the tables of states.
    """
    return known.state(state).half or not {"raw", "uncooked", "frozen"}.isdisjoint(state.split())
