"""Progress lines: the life of each ingredient through a task tree.

A line follows one food from the first node that is or holds it, output to input, unit by unit to the goal: its own
node for as long as there is one, then the mixtures and vessels that took it up. Other programs print such lines from
the states of each node one word at a time; here a step is one node and the motion that takes it.
"""

from __future__ import annotations

import functools
import itertools
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Self

from foon_kg.food import singular
from foon_kg.model import FunctionalUnit, ObjectNode, RequiredIngredient
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.tree import Mention, Step
from foon_kg.plans.kitchen import Kitchen

_KITCHEN = -1


@dataclass(frozen=True)
class ProgressStep:
    """One stage in the life of an ingredient: how and where it is, and the motion that ends this stage.

    ``object`` is what the ingredient is or has become part of (an onion, then a mixture), empty where only the vessel
    is known; JSON has no field for it.
    """

    states: tuple[str, ...]
    relation: str | None
    container: str | None
    motion: str
    object: str = field(default="", compare=False)


@dataclass(frozen=True)
class ProgressLine:
    """The life of one ingredient through the tree; the motion of the last step makes ``end_product``.

    ``end_product`` is the label of the goal, or ``None`` for an ingredient that does not end in it.
    """

    ingredient: str
    steps: tuple[ProgressStep, ...]
    end_product: str | None

    def to_json(self) -> JsonObject:
        """Return one of the ``progress_lines`` of a plan result."""
        steps = [
            {"states": list(step.states), "relation": step.relation, "container": step.container, "motion": step.motion}
            for step in self.steps
        ]
        return {"ingredient": self.ingredient, "steps": steps, "end_product": self.end_product}

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return the line of the ``fields`` that :meth:`to_json` wrote."""
        steps = tuple(
            ProgressStep(s.texts("states"), s.optional_text("relation"), s.optional_text("container"), s.text("motion"))
            for s in fields.nested_list("steps")
        )
        return cls(fields.text("ingredient"), steps, fields.optional_text("end_product"))


def progress_lines(
    units: Sequence[FunctionalUnit], goal: ObjectNode, foods: Iterable[RequiredIngredient], kitchen: Kitchen
) -> tuple[ProgressLine, ...]:
    """Return a line for each of ``foods`` through the tree ``units`` (in the order of execution), in their order.

    Of all ways from the food to ``goal`` the line takes one that passes the state asked for (if any does), begins in
    the kitchen, loses sight of the food least often, stays longest with the food's own node, then with foods rather
    than vessels, and passes most units. A food asked for in two states has two lines where their ways differ. A food
    that is nowhere in the tree, or does not get to the goal, has a line without steps and without an end product.
    """
    stages = _Stages.of(units, goal, kitchen)
    lines = (_line(food, stages, kitchen) for food in foods)
    return tuple(dict.fromkeys(lines))


def lines_of_things(
    units: Sequence[Step], goal: ObjectNode, foods: Iterable[tuple[RequiredIngredient, int]]
) -> tuple[ProgressLine, ...]:
    """Return a line for each of ``foods`` through a tree that makes ``goal`` and numbers its things.

    ``units`` are in the order of execution; each food comes with its number. A thing that a unit takes and does not put
    out has become part of the food that names it among its ingredients.
    """
    inputs = [_by_thing(unit.inputs) for unit in units]
    outputs = [_by_thing(unit.outputs) for unit in units]
    found = []
    for food, number in foods:
        name, steps, now = singular(food.object), [], number
        for unit, taken_by, made_by in zip(units, inputs, outputs, strict=True):
            if (taken := taken_by.get(now)) is not None:
                steps.append(ProgressStep(taken.states, taken.relation, taken.container, unit.motion, taken.label))
                now = _taken_up_by(now, name, made_by)
        ends = outputs[-1].get(now) == goal
        found.append(ProgressLine(food.object, tuple(steps), goal.label if ends else None))
    return tuple(dict.fromkeys(found))


def _taken_up_by(now: int, name: str, made_by: Mapping[int, ObjectNode]) -> int:
    """Return the thing that the food ``name``, which was ``now``, is or is part of among what a unit makes."""
    if now in made_by:
        return now
    holding = [thing for thing, node in made_by.items() if name in map(singular, node.ingredients)]
    return holding[-1] if holding else now


def _by_thing(mentions: Sequence[Mention]) -> dict[int, ObjectNode]:
    """Return the first node of each numbered thing of a unit."""
    found: dict[int, ObjectNode] = {}
    for node, thing, _ in mentions:
        if thing is not None:
            found.setdefault(thing, node)
    return found


class _Stage(NamedTuple):
    """A node as the unit at place ``made_by`` left it (or as it lies in the kitchen)."""

    made_by: int
    node: ObjectNode


@dataclass(frozen=True)
class _Stages:
    """A tree as stages.

    ``uses`` has the places of the units that take each; ``relations`` the usual word between a food and a container.
    ``holding`` has the stages that are or hold each food (in the singular), ``taken`` the foods that each unit takes.
    """

    units: Sequence[FunctionalUnit]
    uses: dict[_Stage, list[int]]
    goal: _Stage | None
    relations: dict[str, str]
    holding: dict[str, list[_Stage]]
    taken: list[frozenset[str]]

    @classmethod
    def of(cls, units: Sequence[FunctionalUnit], goal: ObjectNode, kitchen: Kitchen) -> Self:
        made: dict[ObjectNode, int] = {}
        uses: dict[_Stage, list[int]] = {}
        for place, unit in enumerate(units):
            for node in unit.input_nodes:
                uses.setdefault(_Stage(made.get(node, _KITCHEN), node), []).append(place)
            for node in unit.output_nodes:
                made[node] = place
                uses[_Stage(place, node)] = []
        usual = _usual_relations(units, kitchen)
        holding: dict[str, list[_Stage]] = {}
        for stage in uses:
            for name in _names_of(stage.node):
                holding.setdefault(name, []).append(stage)
        taken = [frozenset().union(*map(_names_of, unit.input_nodes)) for unit in units]
        return cls(units, uses, _Stage(made[goal], goal) if goal in made else None, usual, holding, taken)

    def after(self, stage: _Stage) -> Iterator[_Stage]:
        """Yield the stages that the takers of ``stage`` leave."""
        for place in self.uses[stage]:
            for node in self.units[place].output_nodes:
                yield _Stage(place, node)

    def firsts(self, food: str) -> list[list[_Stage]]:
        """Return the stages that are or hold ``food`` and were not made from it: of the kitchen, then the others.

        Last come inputs that no unit outputs, but that lie where an earlier unit put such a thing: tea that was poured
        into the blender and is taken from there without its state is the same tea.
        """
        kitchen, begun, again = list[_Stage](), list[_Stage](), list[_Stage]()
        for stage in self.holding.get(food, ()):
            if stage == self.goal:
                continue
            if stage.made_by == _KITCHEN:
                (again if self._was_put_there(stage) else kitchen).append(stage)
            elif food not in self.taken[stage.made_by]:
                begun.append(stage)
        return [kitchen, begun, again]

    def _was_put_there(self, leaf: _Stage) -> bool:
        before = self.units[: self.uses[leaf][0]]
        outputs = (node for unit in before for node in unit.output_nodes)
        place = (leaf.node.label, leaf.node.container)
        return place[1] is not None and any((node.label, node.container) == place for node in outputs)


def _usual_relations(units: Iterable[FunctionalUnit], kitchen: Kitchen) -> dict[str, str]:
    """Return the word that most often stands between a food and each container in ``units``, ties by the alphabet."""
    relations: dict[str, Counter[str]] = {}
    for unit in units:
        for node in (*unit.input_nodes, *unit.output_nodes):
            if node.container and node.relation and kitchen.is_food(node):
                relations.setdefault(node.container, Counter())[node.relation] += 1
    return {container: max(sorted(words), key=words.__getitem__) for container, words in relations.items()}


class _Cost(NamedTuple):
    """What a way costs, the weightiest first; the signs make the least the best."""

    lost: int = 0
    turned: int = 0
    own: int = 0
    foods: int = 0
    units: int = 0


class _Way(NamedTuple):
    """A way from a stage to the goal; ties are broken by the earliest units, then by content."""

    cost: _Cost
    stages: tuple[_Stage, ...]

    @property
    def rank(self) -> tuple[object, ...]:
        return (self.cost, [(stage.made_by, stage.node.sort_key) for stage in self.stages])


def _line(wanted: RequiredIngredient, stages: _Stages, kitchen: Kitchen) -> ProgressLine:
    food = singular(wanted.object)
    firsts = stages.firsts(food)
    through = _ways(_followed(itertools.chain(*firsts), food, stages, kitchen), wanted.state, food, stages, kitchen)
    for passes_state, some in itertools.product((True, False), firsts):
        ways = [way for first in some if (way := through.get((_Followed(first, food), passes_state)))]
        if ways:
            best = min(ways, key=lambda way: way.rank)
            return ProgressLine(wanted.object, _steps(best.stages, stages, kitchen), best.stages[-1].node.label)
    return ProgressLine(wanted.object, (), None)


class _Followed(NamedTuple):
    """A stage, and the name by which the food is last known there: its own, or that of the mixture that took it up."""

    stage: _Stage
    known_as: str


def _followed(
    firsts: Iterable[_Stage], food: str, stages: _Stages, kitchen: Kitchen
) -> dict[_Followed, list[_Followed]]:
    """Return all that can be followed from ``firsts``, in the order in which it is made, each with what comes next."""
    found: dict[_Followed, list[_Followed]] = {}
    waiting = [_Followed(first, food) for first in firsts]
    while waiting:
        now = waiting.pop()
        if now not in found:
            after = stages.after(now.stage)
            found[now] = [_Followed(stage, _known_as(now, stage.node, food, kitchen)) for stage in after]
            waiting += found[now]
    order = sorted(found, key=lambda one: (one.stage.made_by, one.stage.node.sort_key, one.known_as))
    return {one: found[one] for one in order}


def _known_as(now: _Followed, after: ObjectNode, food: str, kitchen: Kitchen) -> str:
    """Return the name by which what was ``now`` is known in ``after``: a vessel keeps the name of what is in it."""
    if kitchen.is_food(after):
        return singular(after.label)
    before = singular(now.stage.node.label) if kitchen.is_food(now.stage.node) else now.known_as
    return before if _names(after, before) else food


def _ways(
    followed: dict[_Followed, list[_Followed]], state: str, food: str, stages: _Stages, kitchen: Kitchen
) -> dict[tuple[_Followed, bool], _Way]:
    """Return the best way of each to the goal: with True those that still pass ``state``, with False any.

    A stage is left only for later ones, so that one pass from the last unit backwards sees every way.
    """
    best: dict[tuple[_Followed, bool], _Way] = {}
    for now, following in reversed(followed.items()):
        passes = _is_food_in(state, now.stage.node, food)
        for wanted in (True, False):
            still_wanted = wanted and not passes
            later = (best.get((then, still_wanted)) for then in following)
            ways = [_with(now, way, stages, food, kitchen) for way in later if way is not None]
            if now.stage == stages.goal and not still_wanted:
                ways.append(_Way(_Cost(), (now.stage,)))
            if ways:
                best[now, wanted] = _best_of(ways)
    return best


def _is_food_in(state: str, node: ObjectNode, food: str) -> bool:
    """Whether ``node`` is the ``food`` itself (in the singular), in ``state``."""
    return state in node.states and singular(node.label) == food


def _best_of(ways: Sequence[_Way]) -> _Way:
    # Most stages have one way on. A rank has a key of every node of its way: it is made only where two ways compete.
    return ways[0] if len(ways) == 1 else min(ways, key=lambda way: way.rank)


def _with(now: _Followed, way: _Way, stages: _Stages, food: str, kitchen: Kitchen) -> _Way:
    """Return ``way`` with what is followed ``now`` before it."""
    stage, after = now.stage, way.stages[0].node
    unit = stages.units[way.stages[0].made_by]
    known_as = singular(stage.node.label) if kitchen.is_food(stage.node) else now.known_as
    carried = _names(after, food) or _names(after, known_as)
    turned = not carried and kitchen.is_food(after) and after.label not in {node.label for node in unit.input_nodes}
    cost = _Cost(
        way.cost.lost + (not carried and not turned),
        way.cost.turned + turned,
        way.cost.own - (singular(stage.node.label) == food),
        way.cost.foods - kitchen.is_food(stage.node),
        way.cost.units - 1,
    )
    return _Way(cost, (stage, *way.stages))


def _names(node: ObjectNode, food: str) -> bool:
    """Whether a node is ``food`` (in the singular) or says that it contains it."""
    return food in _names_of(node)


@functools.lru_cache(maxsize=1 << 14)
def _names_of(node: ObjectNode) -> frozenset[str]:
    return frozenset(map(singular, (node.label, *node.ingredients)))


def _steps(way: Sequence[_Stage], stages: _Stages, kitchen: Kitchen) -> tuple[ProgressStep, ...]:
    steps = []
    for stage, after in itertools.pairwise(way):
        node, motion = stage.node, stages.units[after.made_by].motion
        if kitchen.is_food(node):
            steps.append(ProgressStep(node.states, node.relation, node.container, motion, node.label))
        else:  # all that is known of a food in a vessel is the vessel: that is its place
            relation = stages.relations.get(node.label, "in")
            steps.append(ProgressStep(node.states, relation, node.label, motion))
    return tuple(steps)
