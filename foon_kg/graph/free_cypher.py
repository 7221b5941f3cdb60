"""Cypher that a person typed: read-only unless writing was asked for, with a limit of rows and of time.

The READ access mode of Neo4j refuses every write to the graph, its schema and its users. It lets through what
reaches outside the graph (``LOAD CSV``), what disturbs others (``TERMINATE TRANSACTIONS``, some procedures) and what
tells about the server (``SHOW …``). So the plan of a question is looked at first, and nothing of that kind is run.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import neo4j
from neo4j import exceptions as driver_errors

from foon_kg.errors import GraphError, WriteRefused
from foon_kg.graph.connection import Connection

ROW_LIMIT = 1_000
TIME_LIMIT = 30.0
"""Seconds."""

PROCEDURES = frozenset(
    {
        "db.index.fulltext.queryNodes",
        "db.index.fulltext.queryRelationships",
        "db.index.vector.queryNodes",
        "db.index.vector.queryRelationships",
        "db.labels",
        "db.propertyKeys",
        "db.relationshipTypes",
        "db.schema.nodeTypeProperties",
        "db.schema.relTypeProperties",
        "db.schema.visualization",
    }
)
"""The procedures that a question may call: they look at nothing but the graph."""

_REFUSED_OPERATORS = ("AdministrationCommand", "LoadCSV", "Show", "Terminate", "Transaction")
_HINT = "A question only looks at the graph. If you mean to change it, add --write."
_ACCESS_MODE = "Neo.ClientError.Statement.AccessMode"
_TIMED_OUT = "Neo.ClientError.Transaction.TransactionTimedOut"


@dataclass(frozen=True)
class Answer:
    """The rows of a query. ``cut`` says that there were more; ``changes`` counts what a write changed."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Any, ...], ...]
    cut: bool
    changes: Mapping[str, int]


def ask_freely(
    connection: Connection,
    text: str,
    parameters: Mapping[str, Any] | None = None,
    *,
    write: bool = False,
    limit: int = ROW_LIMIT,
    timeout: float = TIME_LIMIT,
) -> Answer:
    """Run ``text`` once, without retries, and answer at most ``limit`` rows.

    Raises :class:`~foon_kg.errors.WriteRefused` for anything but a look at the graph (unless ``write``), GraphError
    where the text is no Cypher, fails, or takes longer than ``timeout`` seconds.
    """
    with connection.session(writing=write) as session:
        try:
            if not write:
                _refuse_all_but_looking(_plan(session, text, parameters, timeout))
            return _run(session, text, parameters, limit, timeout)
        except driver_errors.Neo4jError as error:
            raise _explained(error, timeout) from error


def _plan(
    session: neo4j.Session, text: str, parameters: Mapping[str, Any] | None, timeout: float
) -> neo4j.ResultSummary:
    # The one place where query text is put together: the person's own, behind the word that keeps it from running.
    return session.run(_typed(f"EXPLAIN {text}", timeout), dict(parameters or {})).consume()


def _run(session: neo4j.Session, text: str, parameters: Mapping[str, Any] | None, limit: int, timeout: float) -> Answer:
    result = session.run(_typed(text, timeout), dict(parameters or {}))
    columns, records = tuple(result.keys()), result.fetch(limit + 1)
    counters = vars(result.consume().counters)
    changes = {name: count for name, count in sorted(counters.items()) if type(count) is int and count}
    rows = tuple(tuple(record.values()) for record in records[:limit])
    return Answer(columns, rows, len(records) > limit, changes)


def _typed(text: str, timeout: float) -> neo4j.Query:
    return neo4j.Query(text, timeout=timeout)


def _refuse_all_but_looking(summary: neo4j.ResultSummary) -> None:
    if summary.query_type != "r":
        raise WriteRefused("this would change the graph, its schema, its users or the server", hint=_HINT)
    for operator, details in _operators(summary.plan or {}):
        if operator.startswith(_REFUSED_OPERATORS):
            raise WriteRefused(f"this does more than look at the graph ({operator})", hint=_HINT)
        if operator.startswith("ProcedureCall") and (name := details.partition("(")[0]) not in PROCEDURES:
            raise WriteRefused(f"the procedure {name} does more than look at the graph", hint=_HINT)


def _operators(plan: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Answer every operator of a plan with its details."""
    waiting = [plan]
    while waiting:
        step = waiting.pop()
        yield str(step.get("operatorType", "")), str(step.get("args", {}).get("Details", ""))
        waiting.extend(step.get("children", ()))


def _explained(error: driver_errors.Neo4jError, timeout: float) -> GraphError:
    code = error.code or ""
    if code == _ACCESS_MODE:
        return WriteRefused("this would change the graph", hint=_HINT)
    if code.startswith(_TIMED_OUT):
        return GraphError(
            f"no answer within {timeout:g} seconds", hint="Ask for less, or allow more with --timeout.", code="timeout"
        )
    return GraphError(error.message or code, hint="See the Cypher manual: neo4j.com/docs/cypher-manual.", code="cypher")
