"""Foods that join a tree each by a unit of its own: as FOON brings such a food into such a vessel.

A food that the reference does not have joins where any number may enter (:mod:`foon_kg.integration`), often many at one
unit. A cook sprinkles the salt, then scrapes the onion into the bowl, then mixes. So each of them is brought there by
the unit of FOON that does it most like that: the motion that is most usual for the food, into the same vessel in the
same state and place.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, Self

from foon_kg import motions
from foon_kg.integration.reenacting import FinalTree
from foon_kg.kitchen import Kitchen, singular
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.ordering import Played
from foon_kg.recent import Recent
from foon_kg.script import EMPTY, Casting, Step
from foon_kg.substitution import FAIR

NO_PLACE = -1
"""The place of a step that no script has."""

MOST_UNITS = 65536
"""Of how many units it is kept whether they only bring a food into a vessel."""

Spot = tuple[str, tuple[str, ...], str | None, str | None]


@dataclass(frozen=True)
class Carrier:
    """A unit that brings one ``food`` into a ``vessel`` with nothing but ``tools``, which stay as they are.

    ``lying`` is the food as an output of its own, where the unit names it so; ``held`` says that it is taken out of a
    vessel that is an input too.
    """

    known: KnownUnit
    food: ObjectNode
    vessel: ObjectNode
    tools: tuple[ObjectNode, ...]
    lying: ObjectNode | None
    held: bool

    @classmethod
    def of(cls, known: KnownUnit, kitchen: Kitchen) -> Self | None:
        """Read a unit; ``None`` for one that does more, or less, than bring one food into one vessel."""
        unit = known.unit
        foods = [node for node in unit.input_nodes if kitchen.is_food(node)]
        if len(foods) != 1 or not _brings(unit.motion):
            return None
        food = foods[0]
        for vessel in unit.input_nodes:
            filled = [node for node in unit.output_nodes if _is_filled(vessel, node, food)]
            if not filled or kitchen.is_food(vessel) or vessel.label == food.container:
                continue
            beside = [n for n in unit.input_nodes if n not in {food, vessel} and n.label != food.container]
            left = [n for n in unit.output_nodes if n not in {*beside, *filled} and n.label != food.container]
            lying = [n for n in left if (n.label, n.states, n.container) == (food.label, food.states, vessel.label)]
            stay = all(not n.ingredients and n in unit.output_nodes and kitchen.at_rest(n) for n in beside)
            if stay and left == lying and lying == lying[:1]:
                held = any(node.label == food.container for node in unit.input_nodes)
                return cls(known, food, vessel, tuple(beside), lying[0] if lying else None, held)
        return None

    def fits(self, food: ObjectNode) -> bool:
        """Say whether ``food`` may come in the place of its own: from the same place it would need the same vessel."""
        same_place = (food.relation, food.container) == (self.food.relation, self.food.container)
        return not (self.held and same_place)

    def step(self, food: ObjectNode, vessel: ObjectNode) -> tuple[Step, ObjectNode]:
        """Answer the step that brings ``food`` into ``vessel``, and what the vessel is then."""
        states = tuple(state for state in vessel.states if state != EMPTY)
        inside = (*vessel.ingredients, food.label, *food.ingredients)
        full = replace(vessel, states=states, ingredients=inside)
        lying = () if self.lying is None else (replace(food, relation=self.lying.relation, container=vessel.label),)
        inputs, outputs = (food, vessel, *self.tools), (full, *lying, *self.tools)
        moving = frozenset({food})
        return Step(NO_PLACE, self.known, inputs, self.known.unit.motion, outputs, moving=moving), full


Read = Recent[str, Carrier | Literal[False]]
"""Units that were read, by their keys; ``False`` for one that is no carrier."""


@dataclass(frozen=True, eq=False)
class Carriers:
    """The carriers among some units, by the vessel; and how often which motion brings which food, by its name."""

    into: Mapping[Spot, Sequence[Carrier]]
    usual: Mapping[str, Counter[str]]

    @classmethod
    def of(cls, units: Iterable[KnownUnit], kitchen: Kitchen, read: Read | None = None) -> Self:
        """Read ``units``, which may come in any order; ``read`` keeps what each of them is."""
        read = Recent(MOST_UNITS) if read is None else read
        into: dict[Spot, list[Carrier]] = {}
        usual: dict[str, Counter[str]] = {}
        for known in units:
            carrier = read.find(known.unit.key)
            if carrier is None:
                carrier = read[known.unit.key] = Carrier.of(known, kitchen) or False
            if not carrier:
                continue
            unit = carrier.known.unit
            usual.setdefault(singular(carrier.food.label), Counter())[unit.motion] += len(carrier.known.seen_in)
            if motions.accepts_any(unit.motion, star=unit.accepts_any):
                into.setdefault(_spot(carrier.vessel), []).append(carrier)
        return cls(into, usual)

    def best(self, food: ObjectNode, vessel: ObjectNode, like: Callable[[str, str], float]) -> Carrier | None:
        """Answer what brings ``food`` into ``vessel`` most as FOON does; ``None`` where nothing does so.

        That is: by the motion most usual for the food, else for one that is ``like`` it or is in the same state.
        """
        offers = [(self._rank(carrier, food, like), carrier) for carrier in self.into.get(_spot(vessel), ())]
        fitting = [(rank, carrier) for rank, carrier in offers if rank is not None and carrier.fits(food)]
        return min(fitting, key=lambda offer: offer[0])[1] if fitting else None

    def _rank(
        self, carrier: Carrier, food: ObjectNode, like: Callable[[str, str], float]
    ) -> tuple[int, float, int, bool, int, int, str] | None:
        same = singular(carrier.food.label) == singular(food.label)
        sure = 1.0 if same else like(food.label, carrier.food.label)
        shares_state = not set(food.states).isdisjoint(carrier.food.states)
        if sure < FAIR and not shares_state:
            return None
        motion = carrier.known.unit.motion
        own = self.usual.get(singular(food.label), Counter())[motion]
        others = self.usual[singular(carrier.food.label)][motion]
        seen = len(carrier.known.seen_in)
        sure = round(sure, 1) if sure >= FAIR else 0.0
        return -own, -sure, -others, not shares_state, len(carrier.tools), -seen, carrier.known.unit.key


def carried(
    tree: FinalTree,
    carriers: Carriers,
    like: Callable[[str, str], float],
    kitchen: Kitchen,
    bare: Collection[ObjectNode] = (),
) -> FinalTree:
    """Answer ``tree`` in which each food that joins does so by a step of its own, those of ``bare`` apart.

    A step of the reference that then has nothing left to do is not there any more.
    """
    steps = list(tree.steps)
    for addition in tree.additions:
        food = addition.node
        at = next((place for place, (step, _) in enumerate(steps) if food in step.added), None)
        vessel = _vessel(steps[at][0], food, kitchen) if at is not None and food not in bare else None
        carrier = carriers.best(food, vessel, like) if vessel is not None else None
        if at is not None and vessel is not None and carrier is not None:
            steps[at : at + 1] = _in_two(steps[at], carrier, food, vessel)
    return replace(tree, steps=tuple(steps))


def _in_two(played: Played, carrier: Carrier, food: ObjectNode, vessel: ObjectNode) -> list[Played]:
    """Answer the step that brings the food, and what is left of the step that took it."""
    step, casting = played
    own, full = carrier.step(food, vessel)
    inputs = tuple(full if node == vessel else node for node in step.input_nodes if node != food)
    if not set(step.output_nodes) <= set(inputs):
        added = tuple(node for node in step.added if node != food)
        return [(own, Casting()), (replace(step, input_nodes=inputs, added=added), casting)]
    return [played] if own.motion == step.motion else [(own, Casting())]


def blamed(tree: FinalTree, places: Iterable[int]) -> frozenset[ObjectNode]:
    """Answer the foods that were carried in the steps of ``tree`` at ``places``, or just beside them."""
    near = {other for place in places for other in (place - 1, place, place + 1) if 0 <= other < len(tree.steps)}
    carried_in = [step for step, _ in (tree.steps[place] for place in sorted(near)) if step.place == NO_PLACE]
    return frozenset(step.input_nodes[0] for step in carried_in)


def _vessel(step: Step, food: ObjectNode, kitchen: Kitchen) -> ObjectNode | None:
    """Answer the vessel into which ``food`` comes in this step: one that stands there, and does not hold it yet."""
    for node in step.input_nodes:
        if kitchen.is_food(node) or node.label == food.container or node in step.moving:
            continue
        if food.label in node.ingredients or not (node.ingredients or EMPTY in node.states or not node.states):
            continue
        still = [other for other in step.output_nodes if _place(other) == _place(node)]
        holds = (other for other in step.output_nodes if food.label in other.ingredients)
        if still and any(other in still or other.container == node.label for other in holds):
            return node
    return None


def _brings(motion: str) -> bool:
    moves = motions.transfers(motion) or motions.accepts_any(motion)
    return moves and not motions.mixes(motion) and not motions.heats(motion)


def _is_filled(vessel: ObjectNode, after: ObjectNode, food: ObjectNode) -> bool:
    name = singular(food.label)
    before_it, then = (set(map(singular, node.ingredients)) for node in (vessel, after))
    return _spot(vessel) == _spot(after) and name in then - before_it


def _place(node: ObjectNode) -> tuple[str, str | None, str | None]:
    return node.label, node.relation, node.container


def _spot(node: ObjectNode) -> Spot:
    return node.label, tuple(state for state in node.states if state != EMPTY), node.relation, node.container
