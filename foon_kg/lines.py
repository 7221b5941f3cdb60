"""The foods of a task tree, one line each: where they start, which states they pass, where they join others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode


@dataclass(frozen=True)
class FoodLine:
    """One food of a script: its ``leaves`` (nodes that no earlier unit makes) and the states it passes.

    ``made_by`` maps each state that the script gives it to the motion that does so. ``joins`` is the place of the
    first unit in which it comes together with other foods, ``takes`` how many units take it from the kitchen.
    """

    label: str
    leaves: tuple[ObjectNode, ...]
    states: frozenset[str]
    made_by: tuple[tuple[str, str], ...]
    joins: int
    takes: int


def food_lines(script: Sequence[KnownUnit], kitchen: Kitchen) -> dict[str, FoodLine]:
    """Answer the line of every food that ``script`` takes from the kitchen, by label, sorted by label."""
    made: set[ObjectNode] = set()
    leaves: dict[str, dict[ObjectNode, int]] = {}
    for known in script:
        for node in known.unit.input_nodes:
            if node not in made and not kitchen.is_utensil(node.label):
                uses = leaves.setdefault(node.label, {})
                uses[node] = uses.get(node, 0) + 1
        made.update(known.unit.output_nodes)
    return {label: _line(label, leaves[label], script, kitchen) for label in sorted(leaves)}


def _line(label: str, leaves: dict[ObjectNode, int], script: Sequence[KnownUnit], kitchen: Kitchen) -> FoodLine:
    states: set[str] = set()
    made_by: dict[str, str] = {}
    joins: int | None = None
    for place, known in enumerate(script):
        before = {state for node in known.unit.input_nodes if node.label == label for state in node.states}
        after = {state for node in known.unit.output_nodes if node.label == label for state in node.states}
        for state in sorted(after - before):
            made_by.setdefault(state, known.unit.motion)
        states |= before | after
        if joins is None and _joins(label, known, kitchen):
            joins = place
    return FoodLine(
        label,
        tuple(leaves),
        frozenset(states),
        tuple(sorted(made_by.items())),
        len(script) - 1 if joins is None else joins,
        sum(leaves.values()),
    )


def _joins(label: str, known: KnownUnit, kitchen: Kitchen) -> bool:
    """Say whether ``label`` comes together with other foods in this unit."""
    unit = known.unit
    if not any(node.label == label or label in node.ingredients for node in unit.input_nodes):
        return False
    for node in unit.output_nodes:
        others = {name for name in node.ingredients if name != label and not kitchen.is_utensil(name)}
        if others and (label in node.ingredients or node.label == label):
            return True
        if label in node.ingredients and not kitchen.is_utensil(node.label) and node.label != label:
            return True
    return False
