"""What a picture of a task tree has to show: boxes for object nodes and motions, and arrows between them.

A node is drawn once for every time a unit makes it, so that a picture reads from the kitchen to the goal even where
FOON's nodes go round in circles. What comes from the kitchen is drawn anew beside every unit that takes it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from foon_kg.kitchen import Kitchen
from foon_kg.model import ObjectNode
from foon_kg.result import PlannedUnit
from foon_kg.views.words import shown_inputs, shown_outputs

_KITCHEN = -1
_Stage = tuple[int, ObjectNode]
"""A node as the unit at this place left it, or as it lies in the kitchen."""


@dataclass(frozen=True)
class ObjectBox:
    """An object node in the picture. ``part`` says whether it comes from the kitchen, is made, or is the goal."""

    node: ObjectNode
    part: Literal["kitchen", "made", "goal"]


@dataclass(frozen=True)
class MotionBox:
    """A motion in the picture: the ``number`` of its step (from 1), and the ``tools`` that are folded into it."""

    number: int
    unit: PlannedUnit
    tools: tuple[str, ...]


@dataclass(frozen=True)
class Scene:
    """Boxes, and arrows between the places of two boxes."""

    boxes: tuple[ObjectBox | MotionBox, ...]
    arrows: tuple[tuple[int, int], ...]


def scene_of(units: Sequence[PlannedUnit], goal: ObjectNode, kitchen: Kitchen, *, folded: bool = True) -> Scene:
    """Answer the scene of a tree whose ``units`` are in the order of execution.

    ``folded`` leaves out what a person does not look for: utensils are named within the motion, vessels whose foods
    stand beside them and leftovers that nothing takes are not there. A unit always keeps an arrow to what follows.
    """
    takings = _takings(units)
    shown = [_shown_inputs(unit, kitchen) if folded else list(unit.input_nodes) for unit in units]
    _keep_connected(units, takings, shown, goal)
    return _Drawing(units, goal, kitchen, takings, shown).scene(folded=folded)


def _takings(units: Sequence[PlannedUnit]) -> list[dict[ObjectNode, int]]:
    """Answer for every unit which unit made each of its inputs last."""
    made: dict[ObjectNode, int] = {}
    takings = []
    for place, unit in enumerate(units):
        takings.append({node: made.get(node, _KITCHEN) for node in unit.input_nodes})
        made.update(dict.fromkeys(unit.output_nodes, place))
    return takings


def _shown_inputs(unit: PlannedUnit, kitchen: Kitchen) -> list[ObjectNode]:
    return [node for node in shown_inputs(unit.input_nodes) if not _is_tool(node, kitchen)]


def _is_tool(node: ObjectNode, kitchen: Kitchen) -> bool:
    return kitchen.is_utensil(node.label) and not kitchen.foods_in(node)


def _keep_connected(
    units: Sequence[PlannedUnit],
    takings: Sequence[dict[ObjectNode, int]],
    shown: list[list[ObjectNode]],
    goal: ObjectNode,
) -> None:
    """Show a folded node where it is the only way on from a unit: a stove is turned on for somebody."""
    for place, unit in enumerate(units):
        takers = range(place + 1, len(units))
        if goal in unit.output_nodes or any(takings[i].get(n) == place for i in takers for n in shown[i]):
            continue
        on = ((i, node) for i in takers for node, maker in takings[i].items() if maker == place)
        taker = next(on, None)
        if taker is not None:
            shown[taker[0]].append(taker[1])


@dataclass
class _Drawing:
    units: Sequence[PlannedUnit]
    goal: ObjectNode
    kitchen: Kitchen
    takings: Sequence[dict[ObjectNode, int]]
    shown: Sequence[Sequence[ObjectNode]]
    boxes: list[ObjectBox | MotionBox] = field(default_factory=list)
    arrows: list[tuple[int, int]] = field(default_factory=list)
    made: dict[_Stage, int] = field(default_factory=dict)
    motions: list[int] = field(default_factory=list)

    def scene(self, *, folded: bool) -> Scene:
        for place in range(len(self.units)):
            self._inputs_and_motion(place, folded=folded)
            self._outputs(place, folded=folded)
        return Scene(tuple(self.boxes), tuple(dict.fromkeys(self.arrows)))

    def _inputs_and_motion(self, place: int, *, folded: bool) -> None:
        inputs = [self._input(place, node) for node in self.shown[place]]
        unit = self.units[place]
        tools = dict.fromkeys(
            n.label for n in unit.input_nodes if n not in self.shown[place] and _is_tool(n, self.kitchen)
        )
        motion = self._add(MotionBox(place + 1, unit, tuple(tools) if folded else ()))
        self.motions.append(motion)
        self.arrows += [(box, motion) for box in inputs]

    def _input(self, place: int, node: ObjectNode) -> int:
        maker = self.takings[place][node]
        if maker == _KITCHEN:
            return self._add(ObjectBox(node, "kitchen"))
        return self._made(maker, node)

    def _outputs(self, place: int, *, folded: bool) -> None:
        outputs = self.units[place].output_nodes
        if not folded:
            for node in outputs:
                self._made(place, node)
        elif self.goal in outputs and not self._made_later(place):
            self._made(place, self.goal)
        elif not any(self._taken(place, node) for node in outputs):
            for node in shown_outputs(outputs):
                self._made(place, node)

    def _made_later(self, place: int) -> bool:
        return any(self.goal in unit.output_nodes for unit in self.units[place + 1 :])

    def _taken(self, place: int, node: ObjectNode) -> bool:
        later = range(place + 1, len(self.units))
        return any(self.takings[i].get(node) == place and node in self.shown[i] for i in later)

    def _made(self, maker: int, node: ObjectNode) -> int:
        stage = (maker, node)
        if stage not in self.made:
            last = node == self.goal and not self._made_later(maker)
            self.made[stage] = self._add(ObjectBox(node, "goal" if last else "made"))
            self.arrows.append((self.motions[maker], self.made[stage]))
        return self.made[stage]

    def _add(self, box: ObjectBox | MotionBox) -> int:
        self.boxes.append(box)
        return len(self.boxes) - 1
