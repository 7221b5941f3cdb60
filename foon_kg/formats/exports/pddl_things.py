"""A plan whose things have numbers, as a kitchen in which each thing is in one form and in one place at a time.

A thing of the plan (this onion, that bowl) is a constant; so is each form in which one is seen (chopped; empty; holding
an onion). A step needs its inputs in their forms and places; then those are gone, and the outputs have theirs. A food
that goes into others is gone for good. In the end the dish is there, and every appliance is as its last step leaves it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from foon_kg.food import tables
from foon_kg.formats.exports.pddl_names import name_of, words_of
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention, Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult

FOOD, UTENSIL = "food", "utensil"


@dataclass
class Thing:
    """A thing of the plan: its name in PDDL, and how it is where the plan has got to; ``None`` where it is not."""

    name: str
    label: str
    kind: str
    form: ObjectNode | None = None
    place: int | None = None


@dataclass
class Action:
    """A step: what has to hold before it, and what holds no more and what does after it."""

    name: str
    unit: Step
    needs: list[str] = field(default_factory=list)
    ends: list[str] = field(default_factory=list)
    makes: list[str] = field(default_factory=list)


def has_numbers(result: PlanResult) -> bool:
    """Return whether every node of a plan's ``result`` has the number of a thing."""
    mentions = [one for unit in result.units for one in (*unit.inputs, *unit.outputs)]
    return bool(mentions) and all(one.thing is not None for one in mentions)


class Kitchenful:
    """The things of a plan, followed from its first step to its last.

    ``begin`` are the facts of the kitchen once so many steps are ``done``, ``end`` those of the goal; ``forms`` name
    the forms.
    """

    def __init__(self, result: PlanResult, kitchen: Kitchen, done: int = 0) -> None:
        self.things = _things(result.units, kitchen)
        self.forms: dict[ObjectNode, str] = {}
        self.begin: list[str] = []
        last = {one.thing: place for place, unit in enumerate(result.units) for one in unit.inputs}
        digits = len(str(len(result.units)))
        self.actions: list[Action] = []
        for place, unit in enumerate(result.units):
            if place == done:  # what is taken only later is still as it was found, and is told when it is
                self.begin = [fact for thing in self.things.values() for fact in self._facts(thing)]
            action = Action(name_of(f"step_{place + 1:0{digits}}", unit.motion), unit)
            self._take(action, {thing for thing, taken in last.items() if taken == place})
            self._make(action)
            self.actions.append(action)
        self.end = self._end(result)

    def _take(self, action: Action, for_the_last_time: set[int | None]) -> None:
        made = {one.thing for one in action.unit.outputs}
        for one in action.unit.inputs:
            thing = self.things[one.thing or 0]
            if thing.form is None:
                thing.form, thing.place = _form(one), one.container_thing
                self.begin += self._facts(thing)
            action.needs += self._facts(thing)
            if thing.kind == FOOD and one.thing in for_the_last_time and one.thing not in made:
                action.ends += self._facts(thing)
                thing.form = thing.place = None

    def _make(self, action: Action) -> None:
        for one in action.unit.outputs:
            thing = self.things[one.thing or 0]
            action.ends += self._facts(thing)
            thing.form, thing.place = _form(one), one.container_thing
            action.makes += self._facts(thing)
        action.ends = [fact for fact in action.ends if fact not in action.makes]

    def _facts(self, thing: Thing) -> list[str]:
        if thing.form is None:
            return []
        form = self.forms.setdefault(thing.form, name_of(f"f{len(self.forms) + 1}", words_of(thing.form)))
        where = (
            "(unplaced " + thing.name if thing.place is None else f"(at {thing.name} {self.things[thing.place].name}"
        )
        return [f"(is {thing.name} {form})", f"{where})"]

    def _end(self, result: PlanResult) -> list[str]:
        made = [one for unit in reversed(result.units) for one in unit.outputs if one.node == result.goal]
        facts = self._facts(self.things[made[0].thing or 0]) if made else []
        for thing in self.things.values():
            row = tables().utensil(thing.label)
            if row is not None and row.role == "appliance":
                facts += self._facts(thing)[:1]
        return facts


def _things(units: Sequence[Step], kitchen: Kitchen) -> dict[int, Thing]:
    """Return every thing by its number, also one in which others only are said to be."""
    things: dict[int, Thing] = {}
    mentions = [one for unit in units for one in (*unit.inputs, *unit.outputs)]
    for node, number, _ in mentions:
        if number is not None and number not in things:
            things[number] = _thing(number, node.label, FOOD if kitchen.is_food(node) else UTENSIL)
    for node, _, container in mentions:
        if container is not None and container not in things:
            things[container] = _thing(container, node.container, UTENSIL)
    return things


def _thing(number: int, label: str | None, kind: str) -> Thing:
    return Thing(name_of(f"t{number}", label or ""), label or "", kind)


def _form(one: Mention) -> ObjectNode:
    """Return a node without its place, where that is a thing of its own."""
    return one.node if one.container_thing is None else replace(one.node, relation=None, container=None)
