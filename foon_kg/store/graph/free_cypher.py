"""Cypher that a person typed: read-only unless writing was asked for, with a limit of rows and of time.

The READ access mode of Neo4j refuses every write to the graph, its schema and its users. It lets through what
reaches outside the graph (``LOAD CSV``), what disturbs others (``TERMINATE TRANSACTIONS``, some procedures) and what
tells about the server (``SHOW …``). So its words are read first (:mod:`foon_kg.store.graph.looking`), then its plan is
looked at, and nothing of that kind is run.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import neo4j
from neo4j import exceptions as driver_errors

from foon_kg.model.errors import GraphError, WriteRefused
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.interruptible import interruptible
from foon_kg.store.graph.looking import HINT, PROCEDURES, only_looking
from foon_kg.store.graph.question_words import read

ROW_LIMIT = 1_000
TIME_LIMIT = 30.0
"""Seconds."""

GRACE = 2.0
"""Seconds after its time limit in which a server may say itself that it ended a question."""

MOST_BYTES = 16_000_000
"""How large an answer may be."""

_REFUSED_OPERATORS = ("AdministrationCommand", "LoadCSV", "Show", "Terminate", "Transaction")
_ACCESS_MODE = "Neo.ClientError.Statement.AccessMode"
_TIMED_OUT = "Neo.ClientError.Transaction.TransactionTimedOut"
_NO_MEMORY = ("Neo.TransientError.General.OutOfMemoryError", "Neo.TransientError.General.MemoryPoolOutOfMemoryError")


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

    Raises :class:`~foon_kg.model.errors.WriteRefused` for anything but a look at the graph (unless ``write``),
    GraphError where the text is no Cypher, fails, takes longer than ``timeout`` seconds (``timeout``; the server is
    told to end it and may not heed, the caller is answered nevertheless) or answers more than ``MOST_BYTES``
    (``too-much``).
    """
    endable = text
    if write:
        read(text)
    else:
        pieces = only_looking(text, parameters)
        text, endable = "".join(piece.text for piece in pieces), interruptible(pieces)

    def ask() -> Answer:
        with connection.session(writing=write) as session:
            try:
                if write:
                    return _run(session, text, parameters, limit, timeout)
                columns = _looked_at(session, text, parameters, timeout)
                return replace(_run(session, endable, parameters, limit, timeout), columns=columns)
            except driver_errors.Neo4jError as error:
                raise _explained(error, timeout) from error
            except driver_errors.SessionExpired as error:
                raise GraphError(
                    "the server ended while it was at this question, most likely because it needed too much memory",
                    hint="Ask for less. foon-kg's own server starts again with the next command.",
                    code="server-ended",
                ) from error

    return _within(timeout + GRACE, ask, _late(timeout, stubborn=True))


def _within(seconds: float, ask: Callable[[], Answer], late: GraphError) -> Answer:
    """Return what ``ask`` returns, or raise what it raises; ``late`` where that takes longer.

    A server can be at an expression that it does not interrupt. Then the thread that waits for it is left behind; it
    ends with its connection.
    """
    found: list[Answer | BaseException] = []

    def work() -> None:
        try:
            found.append(ask())
        except BaseException as error:  # noqa: BLE001 - whatever it is, it is raised where somebody waits
            found.append(error)

    thread = threading.Thread(target=work, name="free Cypher", daemon=True)
    thread.start()
    thread.join(seconds)
    if not found:
        raise late
    if isinstance(found[0], BaseException):
        raise found[0]
    return found[0]


def _late(timeout: float, *, stubborn: bool = False) -> GraphError:
    hint = "Ask for less, or allow more with --timeout."
    if stubborn:
        hint += " The server does not let go of this question: “foon server stop” ends it, if it is foon-kg's own."
    return GraphError(f"no answer within {timeout:g} seconds", hint=hint, code="timeout")


def _looked_at(
    session: neo4j.Session, text: str, parameters: Mapping[str, Any] | None, timeout: float
) -> tuple[str, ...]:
    """Return how the columns of a question are called, as it is written, once its plan is found to only look."""
    # The one place where query text is put together: the person's own, behind the word that keeps it from running.
    result = session.run(_typed(f"EXPLAIN {text}", timeout), dict(parameters or {}))
    columns = tuple(result.keys())
    _refuse_all_but_looking(result.consume())
    return columns


def _run(session: neo4j.Session, text: str, parameters: Mapping[str, Any] | None, limit: int, timeout: float) -> Answer:
    result = session.run(_typed(text, timeout), dict(parameters or {}))
    columns, records, size = tuple(result.keys()), [], 0
    for record in result:
        size += sum(map(_size, record.values()))
        if size > MOST_BYTES:
            raise GraphError(
                f"the answer is larger than {MOST_BYTES // 1_000_000} MB",
                hint="Ask for fewer rows or columns, or for counts.",
                code="too-much",
            )
        records.append(record)
        if len(records) > limit:
            break
    counters = vars(result.consume().counters)
    changes = {name: count for name, count in sorted(counters.items()) if type(count) is int and count}
    rows = tuple(tuple(record.values()) for record in records[:limit])
    return Answer(columns, rows, len(records) > limit, changes)


def _size(value: object) -> int:
    """Return about how many bytes a value has."""
    if isinstance(value, str | bytes):
        return len(value)
    if isinstance(value, Mapping):
        return sum(_size(key) + _size(item) for key, item in value.items())
    if isinstance(value, list | tuple | set | frozenset):
        return sum(map(_size, value))
    return 8


def _typed(text: str, timeout: float) -> neo4j.Query:
    return neo4j.Query(text, timeout=timeout)


def _refuse_all_but_looking(summary: neo4j.ResultSummary) -> None:
    if summary.query_type != "r":
        raise WriteRefused("this would change the graph, its schema, its users or the server", hint=HINT)
    for operator, details in _operators(summary.plan or {}):
        if operator.startswith(_REFUSED_OPERATORS):
            raise WriteRefused(f"this does more than look at the graph ({operator})", hint=HINT)
        if operator.startswith("ProcedureCall") and (name := details.partition("(")[0]) not in PROCEDURES:
            raise WriteRefused(f"the procedure {name} does more than look at the graph", hint=HINT)


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
        return WriteRefused("this would change the graph", hint=HINT)
    if code.startswith(_TIMED_OUT):
        return _late(timeout)
    if code in _NO_MEMORY:
        return GraphError(
            "this question needs more memory than the server has", hint="Ask for less at once.", code="memory"
        )
    return GraphError(error.message or code, hint="See the Cypher manual: neo4j.com/docs/cypher-manual.", code="cypher")
