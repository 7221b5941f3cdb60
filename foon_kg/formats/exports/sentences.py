"""A functional unit as an English sentence that a cook can follow.

The sentence is built from what the unit changes, not from its verb: something is brought into a vessel (pour the oil
into the bowl), foods change where they are (chop the onion on the cutting board with the knife), or only utensils do
(turn on the stove). What neither changes nor is a place is a tool.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property, lru_cache
from itertools import permutations

from foon_kg.food import motions
from foon_kg.food.lists import says, word_list
from foon_kg.formats.exports.phrases import (
    hosts_things,
    in_words,
    is_flat,
    joined_by,
    motion_to,
    resting_in,
    stands_in,
    the,
    with_object,
)
from foon_kg.model import UNMEASURED, FunctionalUnit, Measures, ObjectNode
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.measures import measured_words

_PLACES = frozenset({"in", "inside", "on", "over", None})
_FEW = 3
"""So many foods are named one by one; of more it is “everything”, as a cook says it."""


MOST_SAID = 1 << 12
"""For how many units it is kept how they are said: steps come again in many plans."""


def sentence(unit: FunctionalUnit | Step, kitchen: Kitchen, measures: Measures = UNMEASURED) -> str:
    """Return one sentence for ``unit``, with a capital letter, its ``measures`` and a full stop.

    ``kitchen`` tells foods from utensils.
    """
    said = _said(unit.input_nodes, unit.motion, unit.output_nodes, kitchen) + measured_words(measures, unit.motion)
    return f"{said[:1].upper()}{said[1:]}."


@lru_cache(maxsize=MOST_SAID)
def _said(inputs: tuple[ObjectNode, ...], motion: str, outputs: tuple[ObjectNode, ...], kitchen: Kitchen) -> str:
    return _Reading(inputs, motion, outputs, kitchen).said()


class _Reading:
    """What a unit changes, and the words for it."""

    def __init__(
        self, inputs: tuple[ObjectNode, ...], motion: str, outputs: tuple[ObjectNode, ...], kitchen: Kitchen
    ) -> None:
        self._kitchen = kitchen
        self._verb, self._inputs, self._outputs = motion, inputs, outputs
        self._foods = [node for node in inputs if kitchen.is_food(node)]
        self._utensils = [node for node in inputs if not kitchen.is_food(node)]
        self._food_made = [node for node in outputs if kitchen.is_food(node)]
        after = set(outputs)  # their hashes are kept: to compare nodes one by one costs more than all else
        self._changed = [node for node in inputs if node not in after]

    def said(self) -> str:
        """Return the sentence as it begins in the middle of a text."""
        if (likes := self._between_likes()) is not None:
            return self._moving_between(*likes)
        if (vessel := self._taken_out()) is not None:
            return self._taking_out(vessel)
        if self._target is not None and self._brought:
            return self._gives[0] + self._bringing(self._target)
        return self._gives[0] + self._working()

    def _working(self) -> str:
        cooks = self._food_made and any(node.ingredients for node in self._utensils)
        return self._changing() if self._foods or cooks else self._handling()

    def _between_likes(self) -> tuple[ObjectNode, ObjectNode] | None:
        """Return the vessel that is emptied into another one of its name, and that one, as they are before.

        Where foods of both are named, as when the whole gets its name, the fuller one is filled: what comes last on a
        dish is less than that.
        """
        pairs = [
            (source, target)
            for source, target in permutations(self._utensils, 2)
            if source.label == target.label and self._emptied_into(source, target)
        ]
        return min(pairs, key=lambda pair: len(pair[0].ingredients), default=None)

    def _emptied_into(self, source: ObjectNode, target: ObjectNode) -> bool:
        after = [set(node.ingredients) for node in self._outputs if node.label == source.label]
        moves = motions.transfers(self._verb) and {*source.ingredients, *target.ingredients} in after and set() in after
        named = [food for food in self._foods if self._is_of(food, source)]
        return bool(source.ingredients) and moves and (not target.ingredients or bool(named))

    @staticmethod
    def _is_of(food: ObjectNode, vessel: ObjectNode) -> bool:
        """Return whether a food is what a vessel holds, or a part of that."""
        return food.container == vessel.label and {*(food.ingredients or (food.label,))} <= {*vessel.ingredients}

    def _moving_between(self, source: ObjectNode, target: ObjectNode) -> str:
        named = [food.label for food in self._foods if self._is_of(food, source)]
        names = self._without_parts(named or source.ingredients)
        to = "the other" if target.ingredients else "an empty one"
        said = with_object(self._verb, the(names) if len(names) <= _FEW else "everything")
        way = motion_to(source.label, self._outputs)
        return f"{said} from one {source.label} {way} {to}{self._with_tools({source.label})}"

    def _taken_out(self) -> ObjectNode | None:
        """Return the vessel with food in it that comes out of, or off, something else."""
        if joined_by(self._verb) != "from" or not self._foods:
            return None
        left = [node for node in self._utensils if any(u.label == node.container for u in self._utensils)]
        return next((node for node in left if not stands_in(node.label, node.container or "", self._outputs)), None)

    def _taking_out(self, vessel: ObjectNode) -> str:
        held = self._held_in(vessel)
        said = f"the {vessel.label}" + (f" with {the(held)}" if 0 < len(held) <= _FEW else "")
        return f"{with_object(self._verb, said)} from the {vessel.container}{self._with_tools({vessel.label})}"

    @cached_property
    def _target(self) -> ObjectNode | None:
        """The vessel that holds more than before, or that a food comes to lie in."""
        gaining = (node for node in self._outputs if self._gained(node))
        return next(gaining, next((u for u in self._utensils if self._placed(u.label)), None))

    def _placed(self, place: str) -> set[str]:
        """Return the foods that are in ``place`` now and were elsewhere before."""
        before = {food.label: food.container for food in self._foods}
        return {n.label for n in self._food_made if n.container == place and before.get(n.label, place) != place}

    def _gained(self, after: ObjectNode) -> set[str]:
        """Return what a utensil holds that it did not hold before; one that nobody named before held nothing."""
        if self._kitchen.is_food(after):
            return set()
        return set(after.ingredients).difference(*(u.ingredients for u in self._utensils if u.label == after.label))

    @cached_property
    def _brought(self) -> list[str]:
        """What is brought into the target: what it gained, or all that changes where that has new names."""
        if self._target is None:
            return []
        place = self._target.label
        known = self._known_of(self._gained(self._target) | self._placed(place), place)
        filled = any(node.ingredients for node in self._utensils if node.label == place)
        if known or filled or any(food.container == place for food in self._foods):
            return self._without_parts(known)
        after = set(self._outputs)
        return [food.label for food in self._foods if food not in after]

    def _known_of(self, gained: set[str], place: str) -> list[str]:
        """Return what was there before, elsewhere than at ``place``, of what that ``gained``."""
        elsewhere = [node for node in self._inputs if node.container != place]
        known = [node.label for node in elsewhere if node.label in gained]
        known += [node.label for node in elsewhere if self._is_mixture_of(node, gained)]
        return known + [name for node in self._utensils for name in node.ingredients if name in gained]

    def _is_mixture_of(self, node: ObjectNode, names: set[str]) -> bool:
        """Whether a node is a food that is made of nothing but what has these names."""
        return self._kitchen.is_food(node) and bool(node.ingredients) and names >= {*node.ingredients}

    def _held_in(self, vessel: ObjectNode) -> list[str]:
        """Return what a vessel holds, a mixture by its name."""
        made = [food.label for food in self._foods if food.container == vessel.label and food.ingredients]
        return self._without_parts([*made, *vessel.ingredients] if vessel.ingredients else [])

    def _without_parts(self, names: Iterable[str]) -> list[str]:
        """Return names without those of which another one is made: a batter is told, and not its flour."""
        told = list(dict.fromkeys(names))
        parts = {part for food in self._foods if food.label in told for part in food.ingredients if part != food.label}
        return [name for name in told if name not in parts]

    def _bringing(self, target: ObjectNode) -> str:
        places = self._left_places(target)
        source = next(iter(places)) if len(places) == 1 else None
        if (dipped := self._dipped(target)) and source is not None:
            return f"{with_object(self._verb, the(dipped))} into {the(self._brought)} in the {source}{self._gives[1]}"
        if self._verb == "fill":
            said = f"fill the {target.label} with {the(self._brought)}"
        else:
            said = with_object(self._verb, the(self._brought))
        if source is not None and not stands_in(target.label, source, self._inputs):
            said += f" from the {source}"
        if self._verb != "fill":
            said += f" {self._way_to(target, moved=source is not None)} the {target.label}"
        return said + self._with_tools({target.label, *filter(None, places)}) + self._gives[1]

    def _left_places(self, target: ObjectNode) -> set[str | None]:
        """Return where what is brought to a vessel was before."""
        brought = {*self._brought}
        lay_in = {node.container for node in self._inputs if node.label in brought} - {target.label}
        others = [node for node in self._utensils if node.label != target.label]
        return lay_in | {node.label for node in others if not brought.isdisjoint(node.ingredients)}

    def _way_to(self, target: ObjectNode, *, moved: bool) -> str:
        """Return how what is brought comes to its place: into it, onto it, or over the foods that are there."""
        under = self._smeared_over(target)
        if 0 < len(under) <= _FEW:
            return f"over {the(under)} {resting_in(target.label)}"
        if is_flat(target.label) and not moved and not motions.transfers(self._verb):
            return resting_in(target.label)  # cut on a board, not onto it
        return motion_to(target.label, self._outputs)

    def _smeared_over(self, target: ObjectNode) -> list[str]:
        """Return the foods over which what is brought is smeared; none where nothing is."""
        if not says(self._verb.split(), "is smeared by") or not _called(target.label, self._utensils):
            return []
        return self._held_besides(target)

    def _dipped(self, target: ObjectNode) -> list[str]:
        """Return what is dipped into what is brought to it: what the ``target`` holds or carries besides."""
        if not says(self._verb.split(), "is turned in by"):
            return []
        return self._held_besides(target)

    def _held_besides(self, target: ObjectNode) -> list[str]:
        """Return what a vessel held before, without what is brought to it."""
        there = next(iter(_called(target.label, self._utensils)), target)
        return [name for name in self._held_in(there) if name not in self._brought]

    def _in_bath(self, names: list[str]) -> str:
        """Return foods with the water that they are cooked or soaked in: ``the rice in the water``."""
        wet = motions.heats(self._verb) or self._verb in word_list("soaks")
        bath = [name for name in names if wet and self._kitchen.is_free(name)]
        foods = [name for name in names if name not in bath]
        return f"{the(foods)} in {the(bath)}" if bath and foods else the(names)

    def _changing(self) -> str:
        """Say what is done with foods where they are; of a full vessel, with everything in it."""
        foods = self._foods_changed
        vessel = max(self._utensils, key=lambda node: len(node.ingredients), default=None)
        held = self._held_in(vessel) if vessel is not None else []
        where = vessel.label if vessel is not None and held else _only_place(foods)
        said = self._done_with(foods, held, where)
        said += f" {self._relation(where)} the {where}{self._over(where)}" if where else ""
        used = {where or "", *(food.container or "" for food in self._foods)}
        return said + self._with_tools(used) + self._gives[1] + self._making(held)

    def _over(self, where: str) -> str:
        """Return over what a vessel stands that is in another one: "over the water in the pot"; else ``""``."""
        holders = {node.container for node in self._utensils if node.label == where}
        under = next((node for node in self._utensils if node.label in holders and node.ingredients), None)
        return f" over {the(under.ingredients)} in the {under.label}" if under is not None else ""

    def _done_with(self, foods: Sequence[ObjectNode], held: list[str], where: str | None) -> str:
        """Return the verb with its objects: what a vessel held, and ``foods`` that come to it; of many "everything"."""
        fresh = [food for food in foods if food.label not in held]
        if len(held) <= _FEW:
            told = [*(held if foods else ()), *(food.label for food in fresh)] or held
            return with_object(self._verb, self._in_bath(told))
        added = [food.label for food in fresh if food.container != where]
        first = f"add {the(added)}, then " if added else ""
        return first + with_object(self._verb, "everything")

    def _making(self, held: Sequence[str]) -> str:
        """Return what comes of foods under a new name: "to make the dough"; ``""`` where nothing does."""
        known = {node.label for node in self._foods} | set(held)
        made = [node.label for node in self._food_made if node.label not in known]
        return f" to make {the(made)}" if made else ""

    @cached_property
    def _foods_changed(self) -> list[ObjectNode]:
        """The foods that change, water apart that only washes something."""
        after = set(self._outputs)
        changed = [food for food in self._foods if food not in after] or self._foods
        foods = [food for food in changed if not self._only_washes(food)]
        return foods if foods or any(node.ingredients for node in self._utensils) else changed

    def _only_washes(self, food: ObjectNode) -> bool:
        return self._kitchen.is_free(food.label) and not _called(food.label, self._food_made)

    def _handling(self) -> str:
        """Say what is done with utensils alone: one that is moved, else one that is there later too, else the first."""
        changed = self._changed or list(self._inputs)
        after = {node.label for node in self._outputs}
        covers = self._verb == "cover"  # what is moved is the lid then, and what matters stands still

        def rank(node: ObjectNode) -> tuple[bool, ...]:
            return ((self._moved_to(node) is None) != covers, node.label not in after, not node.ingredients)

        first = min(changed, key=rank)
        beside = self._beside(first, [node.label for node in self._inputs if node is not first])
        return with_object(self._verb, f"the {first.label}") + beside + self._until_utensil(first)

    def _beside(self, first: ObjectNode, others: Sequence[str]) -> str:
        """Return the words for what one of the ``others`` has to do with the ``first``: where it goes, with what."""
        place, joined = self._moved_to(first), joined_by(self._verb)
        if joined is not None and others:
            return f" {joined} the {others[0]}"
        if place is not None and place in others:
            return f" {motion_to(place, self._outputs)} the {place}"
        if first.container in others:
            return f" {first.relation} the {first.container}" if first.relation in _PLACES else ""
        return f" with the {others[0]}" if others and not self._verb.startswith("turn ") else ""

    def _moved_to(self, node: ObjectNode) -> str | None:
        """Return where a utensil ends up, if it is in or on something else then."""
        after = [other for other in self._outputs if other.label == node.label and other.relation in _PLACES]
        return next((n.container for n in after if n.container and n.container != node.container), None)

    def _relation(self, container: str) -> str:
        relations = [n.relation for n in (*self._foods, *self._food_made) if n.container == container and n.relation]
        return relations[0] if relations else resting_in(container)

    def _with_tools(self, places: Collection[str]) -> str:
        """Return the tools in words: " in the oven", " with the knife"; ``places`` are told already, or no tools."""
        if any(node.label == "faucet" for node in self._utensils):
            return " under the faucet" if "faucet" not in places or self._target is None else ""
        ways: dict[str, list[str]] = {"in": [], "on": [], "with": []}  # an oven, a stove, a knife
        for label in self._tools(places):
            ways[hosts_things(label) or "with"].append(label)
        return "".join(f" {way} {the(labels)}" for way, labels in ways.items() if labels)

    def _tools(self, places: Collection[str]) -> list[str]:
        """Return the empty utensils that nothing is in, or lies on, and that are no places themselves."""
        taken = {node.container for node in self._inputs if node.container} | set(places)
        free = (node for node in self._utensils if not node.ingredients and node.container not in taken)
        return [node.label for node in free if node.label not in taken]

    @cached_property
    def _gives(self) -> tuple[str, str]:
        """In which states foods come out that they were not in: an adverb, and words at the end."""
        labels = dict.fromkeys(node.label for node in self._food_made)
        return in_words(self._verb, [state for label in labels for state in self._new_states(label)])

    def _new_states(self, label: str) -> list[str]:
        """Return the states that the food called ``label`` was not in; none where several of that name come out."""
        after, before = _called(label, self._food_made), _called(label, self._foods)
        if len(after) != 1 or not (before or motions.heats(self._verb)):
            return []
        known = {state for node in before or self._foods for state in node.states}
        return [state for state in after[0].states if state not in known]

    def _until_utensil(self, node: ObjectNode) -> str:
        after = [state for other in self._outputs if other.label == node.label for state in other.states]
        told = [s for s in after if s not in node.states and s not in {"empty", "closed", "off", "on", "open"}]
        return in_words(self._verb, told)[1]


def _called(label: str, nodes: Iterable[ObjectNode]) -> list[ObjectNode]:
    return [node for node in nodes if node.label == label]


def _only_place(foods: Sequence[ObjectNode]) -> str | None:
    """Return in what foods are, where it is one thing."""
    places = {food.container for food in foods if food.container}
    return next(iter(places)) if len(places) == 1 else None
