"""The foods of a task tree, one line each: where they start, which states they pass, where they join others."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from foon_kg import motions
from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode


@dataclass(frozen=True)
class FoodLine:
    """One food of a script: its ``leaves`` (nodes that no earlier unit makes) and the states it passes.

    ``made_by`` maps each state that the script gives it to the motion that does so. ``joins`` is the place of the
    first unit in which it comes together with other foods, ``at_join`` are its states there; ``opened`` says that it
    is cracked, peeled, opened or cut by then.
    """

    label: str
    leaves: tuple[ObjectNode, ...]
    states: frozenset[str]
    made_by: tuple[tuple[str, str], ...]
    joins: int
    at_join: frozenset[str]
    opened: bool


def food_lines(script: Sequence[KnownUnit], kitchen: Kitchen, same: Collection[ObjectNode] = ()) -> dict[str, FoodLine]:
    """Answer the line of every food that ``script`` takes from the kitchen, by label, sorted by label.

    Nodes of ``same`` are made in it under another name.
    """
    made: set[ObjectNode] = set(same)
    leaves: dict[str, list[ObjectNode]] = {}
    for known in script:
        for node in known.unit.input_nodes:
            if node not in made and not kitchen.is_utensil(node.label):
                leaves.setdefault(node.label, []).append(node)
        made.update(known.unit.output_nodes)
    return {label: _line(label, leaves[label], script, kitchen) for label in sorted(leaves)}


def held_names(script: Sequence[KnownUnit], kitchen: Kitchen, same: Collection[ObjectNode] = ()) -> frozenset[str]:
    """Answer the names of what lies from the start in vessels of ``script`` that no earlier unit fills."""
    made: set[ObjectNode] = set(same)
    names: set[str] = set()
    for known in script:
        for node in known.unit.input_nodes:
            if node not in made and kitchen.is_utensil(node.label):
                names.update(kitchen.foods_in(node))
        made.update(known.unit.output_nodes)
    return frozenset(names)


def _line(label: str, leaves: Sequence[ObjectNode], script: Sequence[KnownUnit], kitchen: Kitchen) -> FoodLine:
    states: set[str] = set()
    made_by: dict[str, str] = {}
    for known in script:
        before, after = _states(label, known.unit.input_nodes), _states(label, known.unit.output_nodes)
        for state in sorted(after - before):
            made_by.setdefault(state, known.unit.motion)
        states |= before | after
    joins = next((place for place, known in enumerate(script) if _joins(label, known, kitchen)), len(script) - 1)
    there = script[joins].unit
    return FoodLine(
        label,
        tuple(dict.fromkeys(leaves)),
        frozenset(states),
        tuple(sorted(made_by.items())),
        joins,
        frozenset(_states(label, (*there.input_nodes, *there.output_nodes))),
        any(opens_food(label, known) for known in script[: joins + 1]),
    )


def _states(label: str, nodes: Sequence[ObjectNode]) -> set[str]:
    return {state for node in nodes if node.label == label for state in node.states}


def opens_food(label: str, known: KnownUnit) -> bool:
    """Say whether the unit cracks, peels, opens or cuts ``label`` (sense, S3)."""
    unit = known.unit
    changed = any(node.label == label and node not in unit.output_nodes for node in unit.input_nodes)
    return changed and motions.opens(unit.motion)


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
