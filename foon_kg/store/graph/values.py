"""The values of the model into the rows that travel between Python and Neo4j, and out of them.

What one video says about a unit beside its identity (order, moving flags, dish classes, time) is kept on the
``SEEN_IN`` edge. A side of the unit is written there as the ranks of its participants among the distinct nodes of that
side in their total order.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from foon_kg.model import Annotation, FunctionalUnit, Goal, Measures, ObjectNode, Participant, Subgraph, Timing
from foon_kg.store.graph.rows import GoalValue, NodeRow, Properties, SeenUnit, SubgraphRow, UnitRow


def node_of(row: NodeRow) -> ObjectNode:
    """Return the object node that travelled as ``row``."""
    label, states, ingredients, relation, container = row
    return ObjectNode(label, tuple(states), tuple(ingredients), relation, container)


def row_of(node: ObjectNode) -> NodeRow:
    """Return ``node`` as it travels."""
    return (node.label, list(node.states), list(node.ingredients), node.relation, node.container)


def unit_of(
    verb: str, inputs: Iterable[NodeRow], outputs: Iterable[NodeRow], seen: Properties, *, accepts_any: bool
) -> FunctionalUnit:
    """Return the unit ``verb`` as one video has it, with its ``inputs``, its ``outputs`` and how it was ``seen``.

    ``accepts_any`` says that it may take any number of inputs.
    """
    ins, outs = _participants(inputs, seen, "inputs"), _participants(outputs, seen, "outputs")
    return FunctionalUnit(ins, verb, outs, accepts_any)


def bare_unit_of(row: UnitRow) -> FunctionalUnit:
    """Return the unit of a ``row`` without anything that a video says about it."""
    inputs, outputs = (tuple(Participant(node_of(node)) for node in side) for side in (row.inputs, row.outputs))
    return FunctionalUnit(inputs, row.verb, outputs, row.accepts_any)


def timing_of(seen: Properties) -> Timing:
    """Return the time in the properties with which a unit was ``seen``, as :func:`properties_of` wrote it."""
    return Timing(tuple(zip(seen["span_starts"], seen["span_ends"], strict=True)), seen["assumed"])


def measures_of(amounts: Sequence[str] | None, seconds: float | None, celsius: float | None) -> Measures:
    """Return ``amounts``, ``seconds`` and ``celsius`` as measures, as :func:`properties_of` wrote them."""
    return Measures(tuple(amounts or ()), seconds, celsius)


def properties_of(annotation: Annotation, position: int) -> Properties:
    """Return what the ``SEEN_IN`` edge of ``annotation`` at a ``position`` (from 0) keeps."""
    unit, timing, measures = annotation.unit, annotation.timing, annotation.measures
    return {
        "position": position,
        "start": timing.start,
        "end": timing.end,
        "assumed": timing.assumed,
        "span_starts": [float(start) for start, _ in timing.spans],
        "span_ends": [float(end) for _, end in timing.spans],
        **_side_as_properties(unit.inputs, "inputs"),
        **_side_as_properties(unit.outputs, "outputs"),
        "amounts": list(measures.amounts) or None,
        "seconds": measures.seconds,
        "celsius": measures.celsius,
    }


def _side_as_properties(participants: Sequence[Participant], side: str) -> Properties:
    distinct = _in_order({p.node for p in participants})
    ranks = {node: rank for rank, node in enumerate(distinct)}
    return {
        side: [ranks[p.node] for p in participants],
        f"{side}_moving": [p.moving for p in participants],
        f"{side}_dish": [p.dish_type or "" for p in participants],
    }


def _participants(rows: Iterable[NodeRow], seen: Properties, side: str) -> tuple[Participant, ...]:
    nodes = [node_of(row) for row in sorted(rows, key=order)]
    columns = zip(seen[side], seen[f"{side}_moving"], seen[f"{side}_dish"], strict=True)
    return tuple(Participant(nodes[rank], moving, dish or None) for rank, moving, dish in columns)


def _in_order(nodes: set[ObjectNode]) -> list[ObjectNode]:
    """Return ``nodes`` in the order that ranks count in."""
    if len({node.label for node in nodes}) == len(nodes):  # as nearly always: all else need not be compared
        return sorted(nodes, key=lambda node: node.label)
    return sorted(nodes, key=lambda node: order(row_of(node)))


def order(row: NodeRow) -> tuple[object, ...]:
    """Return the order of a ``row`` that ranks count in; no two nodes are equal in it."""
    label, states, ingredients, relation, container = row
    return (label, states, ingredients, relation is not None, relation or "", container is not None, container or "")


def goal_of(row: GoalValue) -> Goal:
    """Return the goal that travelled as ``row``."""
    node, dish_type, videos = node_of(row[0]), *row[1:]
    return Goal(node, dish_type, node.ingredients, tuple(sorted(videos)))


def subgraph_of(row: SubgraphRow) -> Subgraph:
    """Return the subgraph of a ``row``, as it was loaded."""
    return Subgraph(row.name, tuple(map(_annotation, row.units)), tuple(row.sources))


def _annotation(unit: SeenUnit) -> Annotation:
    _, verb, accepts_any, inputs, outputs, seen = unit
    measures = measures_of(seen.get("amounts"), seen.get("seconds"), seen.get("celsius"))
    return Annotation(unit_of(verb, inputs, outputs, seen, accepts_any=accepts_any), timing_of(seen), measures)
