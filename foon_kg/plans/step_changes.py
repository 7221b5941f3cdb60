"""What became of the reference tree: which of its steps a plan kept, changed or left out, and which it added.

A step of the plan goes back to a step of the reference when both were seen at one place of a video (every plan says of
its units where they were seen), else when both do the same to the same things.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.tree import Step, newly_made

Change = Literal["kept", "changed", "left out", "added"]


@dataclass(frozen=True)
class StepChange:
    """One step in both trees, or in one of them, each with its number from 1.

    ``gone`` and ``come`` are the names (of nodes, of what they hold, of the motion) that only the one or the other has.
    """

    change: Change
    before: tuple[int, KnownUnit] | None
    after: tuple[int, Step] | None
    gone: tuple[str, ...] = ()
    come: tuple[str, ...] = ()

    def to_json(self) -> JsonObject:
        """Return the change field by field; a step is its number, from 1, and its motion."""
        before = self.before and {"step": self.before[0], "motion": self.before[1].unit.motion}
        after = self.after and {"step": self.after[0], "motion": self.after[1].motion}
        return {
            "change": self.change, "before": before, "after": after, "gone": list(self.gone), "come": list(self.come)
        }  # fmt: skip


def step_changes(reference: Sequence[KnownUnit], final: Sequence[Step]) -> tuple[StepChange, ...]:
    """Return every step of the ``reference`` and of the ``final`` tree, in the order of the final one.

    A step that was left out stands before the next one of the reference that is still there.
    """
    pairs = _pairs(reference, final)
    rows: list[StepChange] = []
    left_out = [place for place in range(len(reference)) if place not in pairs.values()]
    for number, unit in enumerate(final):
        place = pairs.get(number)
        if place is None:
            rows.append(StepChange("added", None, (number + 1, unit)))
            continue
        while left_out and left_out[0] < place:
            gone = left_out.pop(0)
            rows.append(StepChange("left out", (gone + 1, reference[gone]), None))
        rows.append(_both((place + 1, reference[place]), (number + 1, unit)))
    return (*rows, *(StepChange("left out", (gone + 1, reference[gone]), None) for gone in left_out))


def _pairs(reference: Sequence[KnownUnit], final: Sequence[Step]) -> dict[int, int]:
    """Return for the places of steps of the final tree the places of those of the reference that they go back to."""
    pairs: dict[int, int] = {}
    for alike in (_seen_alike, _done_alike):
        for number, unit in enumerate(final):
            waiting = [place for place in range(len(reference)) if place not in pairs.values()]
            ranked = [(-alike(reference[place], unit), place) for place in waiting]
            if number not in pairs and ranked and min(ranked)[0] < 0:
                pairs[number] = min(ranked)[1]
    return pairs


def _seen_alike(known: KnownUnit, unit: Step) -> int:
    """Return whether both were seen at one place of a video."""
    return int(not set(unit.sightings).isdisjoint(known.seen_in))


def _done_alike(known: KnownUnit, unit: Step) -> int:
    """Return to how many of the same things both do the same."""
    taken, made = ({node.label for node in side} for side in (unit.input_nodes, unit.output_nodes))
    changed = [node.label for node in newly_made(known.unit)]
    return len(taken & made & set(changed)) if known.unit.motion == unit.motion else 0


def _both(before: tuple[int, KnownUnit], after: tuple[int, Step]) -> StepChange:
    known, unit = before[1].unit, after[1]
    old = _names(known.input_nodes, known.motion, known.output_nodes)
    new = _names(unit.input_nodes, unit.motion, unit.output_nodes)
    same = set(known.input_nodes) == set(unit.input_nodes) and set(known.output_nodes) == set(unit.output_nodes)
    change: Change = "kept" if same and known.motion == unit.motion else "changed"
    gone, come = (tuple(n for n in one if n not in other) for one, other in ((old, new), (new, old)))
    return StepChange(change, before, after, gone, come)


def _names(inputs: Sequence[ObjectNode], motion: str, outputs: Sequence[ObjectNode]) -> tuple[str, ...]:
    names = [name for node in (*inputs, *outputs) for name in (node.label, *node.ingredients, *node.states)]
    return tuple(dict.fromkeys([*names, motion]))
