"""What became of the reference tree: which of its steps a plan kept, changed or left out, and which it added.

A step of the plan goes back to a step of the reference when both were seen at one place of a video; every plan says
of its units where they were seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.result import PlannedUnit

Change = Literal["kept", "changed", "left out", "added"]


@dataclass(frozen=True)
class StepChange:
    """One step in both trees, or in one of them, each with its number from 1.

    ``gone`` and ``come`` are the names (of nodes, of what they hold, of the motion) that only the one or the other has.
    """

    change: Change
    before: tuple[int, KnownUnit] | None
    after: tuple[int, PlannedUnit] | None
    gone: tuple[str, ...] = ()
    come: tuple[str, ...] = ()


def step_changes(reference: Sequence[KnownUnit], final: Sequence[PlannedUnit]) -> tuple[StepChange, ...]:
    """Answer every step of the ``reference`` and of the ``final`` tree, in the order of the final one.

    A step that was left out stands before the next one of the reference that is still there.
    """
    rows: list[StepChange] = []
    waiting = list(enumerate(reference, start=1))
    for number, unit in enumerate(final, start=1):
        before = _origin(unit, waiting)
        if before is None:
            rows.append(StepChange("added", None, (number, unit)))
            continue
        while waiting and waiting[0][0] < before[0] and not _comes_later(waiting[0][1], final[number:]):
            rows.append(StepChange("left out", waiting.pop(0), None))
        waiting.remove(before)
        rows.append(_both(before, (number, unit)))
    return (*rows, *(StepChange("left out", one, None) for one in waiting))


def _origin(unit: PlannedUnit, waiting: Sequence[tuple[int, KnownUnit]]) -> tuple[int, KnownUnit] | None:
    seen = set(unit.seen_in)
    return next((one for one in waiting if not seen.isdisjoint(one[1].seen_in)), None)


def _comes_later(known: KnownUnit, later: Sequence[PlannedUnit]) -> bool:
    seen = set(known.seen_in)
    return any(not seen.isdisjoint(unit.seen_in) for unit in later)


def _both(before: tuple[int, KnownUnit], after: tuple[int, PlannedUnit]) -> StepChange:
    known, unit = before[1].unit, after[1]
    old = _names(known.input_nodes, known.motion, known.output_nodes)
    new = _names(unit.input_nodes, unit.motion_node, unit.output_nodes)
    same = set(known.input_nodes) == set(unit.input_nodes) and set(known.output_nodes) == set(unit.output_nodes)
    change: Change = "kept" if same and known.motion == unit.motion_node else "changed"
    gone, come = (tuple(n for n in one if n not in other) for one, other in ((old, new), (new, old)))
    return StepChange(change, before, after, gone, come)


def _names(inputs: Sequence[ObjectNode], motion: str, outputs: Sequence[ObjectNode]) -> tuple[str, ...]:
    names = [name for node in (*inputs, *outputs) for name in (node.label, *node.ingredients, *node.states)]
    return tuple(dict.fromkeys([*names, motion]))
