"""A functional unit as an English sentence that a cook can follow.

The sentence is built from what the unit changes, not from its verb: something is brought into a vessel (pour the oil
into the bowl), foods change where they are (chop the onion on the cutting board with the knife), or only utensils do
(turn on the stove). What neither changes nor is a place is a tool.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import cached_property

from foon_kg.food import motions, tables
from foon_kg.food.lists import word_list
from foon_kg.model import UNMEASURED, FunctionalUnit, Measures, ObjectNode
from foon_kg.plans.kitchen import Kitchen, is_place
from foon_kg.plans.measures import measured_words

_SAID_AS = {"pick-and-place": "put", "place": "put", "put inside": "put", "insert": "put", "sit": "rest"}
_AFTER_THE_OBJECT = frozenset({"in", "with", "into"})
_PARTS = frozenset({"ends", "seeds", "skin", "slits"})
_JOINED_BY = {"attach": "to", "detach": "from", "remove": "from", "take out": "from", "scrape": "from"}
_FLAT = word_list("flat utensils")
_SHAPES = {"leaf": "leaves"} | {
    shape: shape for shape in ("chunks", "cubes", "halves", "leaves", "pieces", "powder", "slices", "strips", "wedges")
}
_IRREGULAR = {"freeze": "frozen", "grind": "ground", "tear": "torn", "break": "broken", "cut": "cut"}
_PLACES = frozenset({"in", "inside", "on", "over", None})
_FEW = 3
_COGNATE = 3


def sentence(unit: FunctionalUnit, kitchen: Kitchen, measures: Measures = UNMEASURED) -> str:
    """Return one sentence for ``unit``, with a capital letter, its ``measures`` and a full stop."""
    said = _Reading(unit, kitchen).said() + measured_words(measures, unit.motion)
    return f"{said[:1].upper()}{said[1:]}."


def listed(names: Iterable[str]) -> str:
    """Return ``a, b and c``, each name once; nothing for no names."""
    *first, last = dict.fromkeys(names) or ("",)
    return f"{', '.join(first)} and {last}" if first else last


class _Reading:
    """What ``unit`` changes, and the words for it."""

    def __init__(self, unit: FunctionalUnit, kitchen: Kitchen) -> None:
        self._kitchen = kitchen
        self._verb, self._inputs, self._outputs = unit.motion, unit.input_nodes, unit.output_nodes
        self._foods = [node for node in unit.input_nodes if kitchen.is_food(node)]
        self._utensils = [node for node in unit.input_nodes if not kitchen.is_food(node)]
        self._food_made = [node for node in unit.output_nodes if kitchen.is_food(node)]
        self._changed = [node for node in unit.input_nodes if node not in unit.output_nodes]

    def said(self) -> str:
        if self._target is not None and self._brought:
            return self._bringing(self._target)
        cooks = self._food_made and any(node.ingredients for node in self._utensils)
        return self._changing() if self._foods or cooks else self._handling()

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
        gained = self._gained(self._target) | self._placed(place)
        known = [n.label for n in self._inputs if n.label in gained and n.container != place]
        known += [name for node in self._utensils for name in node.ingredients if name in gained]
        filled = any(node.ingredients for node in self._utensils if node.label == place)
        if known or filled or any(food.container == place for food in self._foods):
            return self._without_parts(known)
        return [food.label for food in self._foods if food in self._changed]

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
        places = {node.container for node in self._inputs if node.label in self._brought} - {target.label}
        places |= {u.label for u in self._utensils if u.label != target.label and set(u.ingredients) & {*self._brought}}
        source = next(iter(places)) if len(places) == 1 else None
        if self._verb == "fill":
            said = f"fill the {target.label} with {_the(self._brought)}"
        else:
            said = _with_object(self._verb, _the(self._brought))
        if source is not None and not _stands_in(target.label, source, self._inputs):
            said += f" from the {source}"
        if self._verb != "fill":
            worked = _is_flat(target.label) and not motions.transfers(self._verb)  # cut on a board, and not onto it
            way = _resting_in(target.label) if worked else _motion_to(target.label, self._outputs)
            said += f" {way} the {target.label}"
        return said + self._with_tools({target.label, *filter(None, places)}) + self._until()

    def _changing(self) -> str:
        foods = self._foods_changed
        vessel = max(self._utensils, key=lambda node: len(node.ingredients), default=None)
        held = self._held_in(vessel) if vessel is not None else []
        places = {food.container for food in foods if food.container}
        where = vessel.label if vessel is not None and held else next(iter(places)) if len(places) == 1 else None
        fresh = [food.label for food in foods if food.label not in held]
        if len(held) > _FEW:
            fresh = [food.label for food in foods if food.label in fresh and food.container != where]
            said = f"add {_the(fresh)}, then " if fresh else ""
            said += _with_object(self._verb, "everything")
        else:
            said = _with_object(self._verb, _the([*(held if foods[:1] else ()), *fresh] or held))
        said += f" {self._relation(where)} the {where}" if where else ""
        used = {where or "", *(food.container or "" for food in self._foods)}
        known = {node.label for node in self._foods} | set(held)
        made = [node.label for node in self._food_made if node.label not in known]
        return said + self._with_tools(used) + self._until() + (f" to make {_the(made)}" if made else "")

    @cached_property
    def _foods_changed(self) -> list[ObjectNode]:
        """The foods that change, water apart that only washes something."""
        changed = [food for food in self._foods if food in self._changed] or self._foods
        told = {node.label for node in self._food_made}
        foods = [food for food in changed if food.label in told or not self._kitchen.is_free(food.label)]
        return foods if foods or any(node.ingredients for node in self._utensils) else changed

    def _handling(self) -> str:
        """Say what is done with utensils alone: one that is moved, else one that is there later too, else the first."""
        changed = self._changed or list(self._inputs)
        after = {node.label for node in self._outputs}
        covers = self._verb == "cover"  # what is moved is the lid then, and what matters stands still

        def rank(node: ObjectNode) -> tuple[bool, ...]:
            return ((self._moved_to(node) is None) != covers, node.label not in after, not node.ingredients)

        first = min(changed, key=rank)
        others = [node.label for node in self._inputs if node is not first]
        place = self._moved_to(first)
        said = _with_object(self._verb, f"the {first.label}")
        if self._verb in _JOINED_BY and others:
            said += f" {_JOINED_BY[self._verb]} the {others[0]}"
        elif place is not None and place in others:
            said += f" {_motion_to(place, self._outputs)} the {place}"
        elif first.container in others:
            said += f" {first.relation} the {first.container}" if first.relation in _PLACES else ""
        elif others and not self._verb.startswith("turn "):
            said += f" with the {others[0]}"
        return said + self._until_utensil(first)

    def _moved_to(self, node: ObjectNode) -> str | None:
        """Return where a utensil ends up, if it is in or on something else then."""
        after = [other for other in self._outputs if other.label == node.label and other.relation in _PLACES]
        return next((n.container for n in after if n.container and n.container != node.container), None)

    def _relation(self, container: str) -> str:
        relations = [n.relation for n in (*self._foods, *self._food_made) if n.container == container and n.relation]
        return relations[0] if relations else _resting_in(container)

    def _with_tools(self, places: Collection[str]) -> str:
        if any(node.label == "faucet" for node in self._utensils):
            return " under the faucet" if "faucet" not in places or self._target is None else ""
        taken = {node.container for node in self._inputs if node.container} | set(places)
        free = (node for node in self._utensils if not node.ingredients and node.container not in taken)
        tools = [node.label for node in free if node.label not in taken]
        rooms = [label for label in tools if _is_room(label)]
        said = f" in {_the(rooms)}" if rooms else ""
        tools = [label for label in tools if label not in rooms]
        return said + (f" with {_the(tools)}" if tools else "")

    def _until(self) -> str:
        """Say in which states foods come out that they were not in, save those that the verb names (peel: peeled)."""
        found: list[str] = []
        for label in dict.fromkeys(node.label for node in self._food_made):
            after = [node for node in self._food_made if node.label == label]
            before = [node for node in self._foods if node.label == label]
            known = {state for node in before for state in node.states}
            if len(after) == 1 and (before or motions.heats(self._verb)):
                found += [state for state in after[0].states if state not in known]
        return self._in_words(found)

    def _until_utensil(self, node: ObjectNode) -> str:
        after = [state for other in self._outputs if other.label == node.label for state in other.states]
        told = [s for s in after if s not in node.states and s not in {"empty", "closed", "off", "on", "open"}]
        return self._in_words(told)

    def _in_words(self, states: Iterable[str]) -> str:
        words = self._verb.split()
        if words[-1] in _PARTS:
            return ""
        roots = {_IRREGULAR.get(word, word)[:_COGNATE] for word in words}
        told = [state for state in states if not is_place(state) and (" " in state or state[:_COGNATE] not in roots)]
        shapes = [state for state in told if state in _SHAPES]
        rest = [state for state in told if state not in _SHAPES]
        return (f" into {listed(_SHAPES[shape] for shape in shapes)}" if shapes else "") + (
            f" until {listed(rest)}" if rest else ""
        )


def _the(labels: Iterable[str]) -> str:
    return f"the {listed(labels)}"


def _with_object(verb: str, thing: str) -> str:
    """Return ``cut the onion in half``, ``cut off the ends of the onion``, ``put the onion``."""
    words = _SAID_AS.get(verb, verb).split()
    if len(words) > 1 and words[-1] in _PARTS:
        between = "in" if words[-1] == "slits" else "of"
        return f"{' '.join(words[:-1])} {'' if between == 'in' else 'the '}{words[-1]} {between} {thing}"
    if len(words) > 1 and words[1] in _AFTER_THE_OBJECT:
        return f"{words[0]} {thing} {' '.join(words[1:])}"
    return f"{' '.join(words)} {thing}"


def _stands_in(inner: str, outer: str, nodes: Iterable[ObjectNode]) -> bool:
    return any(node.label == inner and node.container == outer for node in nodes)


def _is_flat(label: str) -> bool:
    return bool(label) and label.rsplit(maxsplit=1)[-1] in _FLAT


def _is_room(label: str) -> bool:
    """Say whether a utensil is an appliance in which things stand: an oven, a fridge."""
    row = tables().utensil(label)
    return row is not None and row.role == "appliance" and row.holds == "in"


def _motion_to(label: str, after: Iterable[ObjectNode]) -> str:
    relations = {node.relation for node in after if node.container == label}
    return "onto" if "on" in relations or (_is_flat(label) and "in" not in relations) else "into"


def _resting_in(label: str) -> str:
    return "on" if _is_flat(label) else "in"
