"""What a picture of a task tree has to show: boxes for object nodes and motions, and arrows between them.

A node is drawn once for every time a unit makes it, so that a picture reads from the kitchen to the goal even where
FOON's nodes go round in circles; where a plan numbers its things, two bowls that look alike are two. What comes from
the kitchen is drawn anew beside every unit that takes it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from foon_kg.formats.views.words import shown_inputs, shown_outputs
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention, Step
from foon_kg.plans.kitchen import Kitchen

_KITCHEN = -1
_Stage = tuple[int, Mention]
"""A thing as the unit at this place left it, or as it lies in the kitchen."""


@dataclass(frozen=True)
class ObjectBox:
    """An object node in the picture. ``part`` says whether it comes from the kitchen, is made, or is the goal."""

    node: ObjectNode
    part: Literal["kitchen", "made", "goal"]


@dataclass(frozen=True)
class MotionBox:
    """A motion in the picture: the ``number`` of its step (from 1), and the ``tools`` that are folded into it."""

    number: int
    unit: Step
    tools: tuple[str, ...]


@dataclass(frozen=True)
class Scene:
    """Boxes, and arrows between the places of two boxes."""

    boxes: tuple[ObjectBox | MotionBox, ...]
    arrows: tuple[tuple[int, int], ...]


def scene_of(units: Sequence[Step], goal: ObjectNode, kitchen: Kitchen, *, folded: bool = True) -> Scene:
    """Return the scene of a tree that makes ``goal``, whose ``units`` are in the order of execution.

    ``folded`` leaves out what a person does not look for: utensils of the ``kitchen`` are named within the motion,
    vessels whose foods stand beside them and leftovers that nothing takes are not there. A unit always keeps an arrow
    to what follows.
    """
    takings = _takings(units)
    shown = [_shown_inputs(unit, kitchen) if folded else list(_taken(unit)) for unit in units]
    _keep_connected(units, takings, shown, goal)
    return _Drawing(units, goal, kitchen, takings, shown).scene(folded=folded)


_PHASES = ("prepare", "heat", "finish")


def phases_of(scene: Scene) -> tuple[int, ...]:
    """Return for each box of a ``scene`` the place of its phase (making ready, cooking, serving).

    Nothing where a unit has none. What is made has the phase of the unit that makes it, what comes from the kitchen
    that of the unit that takes it.
    """
    phases: dict[int, int] = {}
    for place, box in enumerate(scene.boxes):
        if isinstance(box, MotionBox):
            if box.unit.phase is None:
                return ()
            phases[place] = _PHASES.index(box.unit.phase)
    made = {end: phases[start] for start, end in scene.arrows if start in phases}
    taken = {start: phases[end] for start, end in scene.arrows if end in phases}
    found = taken | made | phases
    return tuple(found[place] for place in range(len(scene.boxes)))


def foods_of(scene: Scene, kitchen: Kitchen) -> tuple[frozenset[str], ...]:
    """Return for each box of ``scene`` the foods that it shows: itself, what it is mixed of, what is in a vessel.

    ``kitchen`` tells foods from utensils.
    """

    def foods(node: ObjectNode) -> frozenset[str]:
        own = (node.label,) if kitchen.is_food(node) else ()
        return frozenset((*own, *kitchen.foods_in(node)))

    def of_box(box: ObjectBox | MotionBox) -> frozenset[str]:
        if isinstance(box, ObjectBox):
            return foods(box.node)
        return frozenset().union(*map(foods, (*box.unit.input_nodes, *box.unit.output_nodes)))

    return tuple(map(of_box, scene.boxes))


def _taken(unit: Step) -> tuple[Mention, ...]:
    return tuple(dict.fromkeys(one._replace(container_thing=None) for one in unit.inputs))


def _made(unit: Step) -> tuple[Mention, ...]:
    return tuple(dict.fromkeys(one._replace(container_thing=None) for one in unit.outputs))


def _takings(units: Sequence[Step]) -> list[dict[Mention, int]]:
    """Return for every unit which unit made each of its inputs last."""
    made: dict[Mention, int] = {}
    takings = []
    for place, unit in enumerate(units):
        takings.append({one: made.get(one, _KITCHEN) for one in _taken(unit)})
        made.update(dict.fromkeys(_made(unit), place))
    return takings


def _shown_inputs(unit: Step, kitchen: Kitchen) -> list[Mention]:
    shown = [node for node in shown_inputs(unit.input_nodes) if not _is_tool(node, kitchen)]
    return [one for one in _taken(unit) if one.node in shown]


def _is_tool(node: ObjectNode, kitchen: Kitchen) -> bool:
    return kitchen.is_utensil(node.label) and not kitchen.foods_in(node)


def _keep_connected(
    units: Sequence[Step],
    takings: Sequence[dict[Mention, int]],
    shown: list[list[Mention]],
    goal: ObjectNode,
) -> None:
    """Show a folded node where it is the only way on from a unit: a stove is turned on for somebody."""
    for place, unit in enumerate(units):
        takers = range(place + 1, len(units))
        if goal in unit.output_nodes or any(takings[i].get(n) == place for i in takers for n in shown[i]):
            continue
        on = ((i, one) for i in takers for one, maker in takings[i].items() if maker == place)
        taker = next(on, None)
        if taker is not None:
            shown[taker[0]].append(taker[1])


@dataclass
class _Drawing:
    units: Sequence[Step]
    goal: ObjectNode
    kitchen: Kitchen
    takings: Sequence[dict[Mention, int]]
    shown: Sequence[Sequence[Mention]]
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
        inputs = [self._input(place, one) for one in self.shown[place]]
        unit = self.units[place]
        folded_in = (one.node for one in _taken(unit) if one not in self.shown[place])
        tools = dict.fromkeys(node.label for node in folded_in if _is_tool(node, self.kitchen))
        motion = self._add(MotionBox(place + 1, unit, tuple(tools) if folded else ()))
        self.motions.append(motion)
        self.arrows += [(box, motion) for box in inputs]

    def _input(self, place: int, one: Mention) -> int:
        maker = self.takings[place][one]
        if maker == _KITCHEN:
            return self._add(ObjectBox(one.node, "kitchen"))
        return self._made(maker, one)

    def _outputs(self, place: int, *, folded: bool) -> None:
        outputs = _made(self.units[place])
        for one in self._drawn(place, outputs) if folded else outputs:
            self._made(place, one)

    def _drawn(self, place: int, outputs: Sequence[Mention]) -> Sequence[Mention]:
        """Return which ``outputs`` of a step are drawn beside those that others take: the dish, else what is left."""
        goal = [one for one in outputs if one.node == self.goal][:1]
        if goal and not self._made_later(place):
            return goal
        if any(self._taken(place, one) for one in outputs):
            return []  # what others take is drawn with them
        shown = shown_outputs([one.node for one in outputs])
        return [one for one in outputs if one.node in shown]

    def _made_later(self, place: int) -> bool:
        return any(self.goal in unit.output_nodes for unit in self.units[place + 1 :])

    def _taken(self, place: int, one: Mention) -> bool:
        later = range(place + 1, len(self.units))
        return any(self.takings[i].get(one) == place and one in self.shown[i] for i in later)

    def _made(self, maker: int, one: Mention) -> int:
        stage = (maker, one)
        if stage not in self.made:
            last = one.node == self.goal and not self._made_later(maker)
            self.made[stage] = self._add(ObjectBox(one.node, "goal" if last else "made"))
            self.arrows.append((self.motions[maker], self.made[stage]))
        return self.made[stage]

    def _add(self, box: ObjectBox | MotionBox) -> int:
        self.boxes.append(box)
        return len(self.boxes) - 1
