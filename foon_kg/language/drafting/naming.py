"""A mixture that nobody named when it was made is called, from then on, as it is spoken of next: the dough."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.language.drafting.scene import Scene
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant
from foon_kg.model.drafts import DraftUnit, LeftOut

Row = DraftUnit | LeftOut


def renamed(rows: Sequence[Row], label: str, name: str) -> list[Row]:
    """Return ``rows`` in which the mixture ``label`` is called ``name`` from the unit on that made it last."""
    units = [(place, row) for place, row in enumerate(rows) if isinstance(row, DraftUnit)]
    made = next((place for place, row in reversed(units) if _makes(row.annotation.unit, label)), None)
    found = list(rows)
    for place, row in units:
        if made is not None and place >= made:
            # what goes into the unit that makes the mixture is another thing, though it is called alike
            found[place] = _in_unit(row, label, name, inputs=place > made)
    return found


def rename(scene: Scene, label: str, name: str) -> None:
    """Let what is called ``label`` in ``scene`` be called ``name``, too."""
    for things in (scene.foods, scene.utensils):
        nodes = [_node(node, label, name) for node in things.values()]
        things.clear()
        things.update((node.label, node) for node in nodes)
    scene.last = tuple(name if one == label else one for one in scene.last)
    if label in scene.sure:
        scene.sure[name] = scene.sure.pop(label)
    if label in scene.mixed:
        scene.mixed.add(name)


def _makes(unit: FunctionalUnit, label: str) -> bool:
    """Whether a unit makes a mixture: it is of other foods after it."""
    before = {frozenset(node.ingredients) for node in unit.input_nodes if node.label == label}
    return any(node.label == label and frozenset(node.ingredients) not in before for node in unit.output_nodes)


def _in_unit(row: DraftUnit, label: str, name: str, *, inputs: bool) -> DraftUnit:
    unit = row.annotation.unit
    before = _side(unit.inputs, label, name) if inputs else unit.inputs
    changed = FunctionalUnit(before, unit.motion, _side(unit.outputs, label, name), unit.accepts_any)
    # that nobody knew what it is called is no doubt any more
    doubts = tuple(doubt for doubt in row.doubts if not doubt.endswith(f"called “{label}”"))
    return replace(row, annotation=Annotation(changed, row.annotation.timing), doubts=doubts)


def _side(side: Sequence[Participant], label: str, name: str) -> tuple[Participant, ...]:
    return tuple(replace(one, node=_node(one.node, label, name)) for one in side)


def _node(node: ObjectNode, label: str, name: str) -> ObjectNode:
    names = tuple(name if one == label else one for one in node.ingredients)
    return replace(node, label=name if node.label == label else node.label, ingredients=names)
