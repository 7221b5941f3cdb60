"""Which steps of a task tree have to wait for which: the partial order behind the order of execution.

A step waits for an earlier one as an instruction of a program waits for another: it takes what that one makes, it
makes or uses up what that one takes, or both make the same node. Everything else may be done side by side.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.model import ObjectNode
from foon_kg.result import PlannedUnit


def earlier_steps(units: Sequence[PlannedUnit]) -> tuple[frozenset[int], ...]:
    """Answer for every unit (in the order of execution) the places of the units that have to be done before it.

    What lies in the kitchen may be taken by several steps: there is more than one onion. What a unit made is used up
    by a unit that takes it and does not put it out again; whoever else takes it does so in the order of execution.
    """
    made_by: dict[ObjectNode, int] = {}
    taken_by: dict[ObjectNode, list[int]] = {}
    before: list[frozenset[int]] = []
    for place, unit in enumerate(units):
        waits: set[int] = set()
        outputs = frozenset(unit.output_nodes) - frozenset(unit.input_nodes)  # what stays as it is was only held
        for node in unit.input_nodes:
            if node in made_by:
                waits.add(made_by[node])
        used_up = {node for node in unit.input_nodes if node in made_by and node not in unit.output_nodes}
        for node in outputs | used_up:
            waits.update(taken_by.get(node, ()))
            if node in made_by:
                waits.add(made_by[node])
        for node in unit.input_nodes:
            taken_by.setdefault(node, []).append(place)
        for node in outputs:
            made_by[node], taken_by[node] = place, []
        for node in used_up:
            made_by[node] = place  # the next to take it comes after this one
        before.append(frozenset(waits - {place}))
    return tuple(before)
