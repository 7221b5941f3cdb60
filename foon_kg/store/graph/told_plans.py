"""How a server goes about a question (``EXPLAIN``, ``PROFILE``), as rows: one an operator, from the answer down."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

COLUMNS = ("operator", "details", "estimated_rows")
PROFILED = (*COLUMNS, "rows", "db_hits")


def operators(plan: Mapping[str, Any]) -> Iterator[tuple[int, Mapping[str, Any]]]:
    """Yield every operator of a plan with its depth, each before what it takes its rows from.

    >>> plan = {"operatorType": "ProduceResults@neo4j", "children": [{"operatorType": "AllNodesScan@neo4j"}]}
    >>> [(depth, name_and_details(step)[0]) for depth, step in operators(plan)]
    [(0, 'ProduceResults'), (1, 'AllNodesScan')]
    """
    waiting = [(0, plan)]
    while waiting:
        depth, step = waiting.pop()
        yield depth, step
        waiting.extend((depth + 1, child) for child in reversed(step.get("children", ())))


def name_and_details(step: Mapping[str, Any]) -> tuple[str, str]:
    """Return what the operator of a ``step`` is called, and what it is about."""
    return str(step.get("operatorType", "")).partition("@")[0], str(step.get("args", {}).get("Details", ""))


def rows_of(plan: Mapping[str, Any], *, profiled: bool) -> Iterator[tuple[Any, ...]]:
    """Yield the row of each operator of a ``plan``, with what it took where ``profiled``.

    One below another is indented.

    >>> plan = {"operatorType": "Filter@neo4j", "args": {"Details": "n.x > 1", "EstimatedRows": 2.04}}
    >>> list(rows_of(plan, profiled=False))
    [('Filter', 'n.x > 1', 2.0)]
    """
    for depth, step in operators(plan):
        name, details = name_and_details(step)
        estimated = step.get("args", {}).get("EstimatedRows")
        row = ("  " * depth + name, details, None if estimated is None else round(estimated, 1))
        yield (*row, step.get("rows"), step.get("dbHits")) if profiled else row
