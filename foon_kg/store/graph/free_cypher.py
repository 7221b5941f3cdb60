"""Cypher that a person typed: read-only unless writing was asked for, with a limit of rows and of time.

The READ access mode of Neo4j refuses every write to the graph, its schema and its users. It lets through what
reaches outside the graph (``LOAD CSV``), what disturbs others (``TERMINATE TRANSACTIONS``, some procedures) and what
tells about the server (``SHOW …``, but for indexes and constraints). So its words are read first
(:mod:`foon_kg.store.graph.looking`), then its plan is looked at, and nothing of that kind is run.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import neo4j
from neo4j import exceptions as driver_errors
from neo4j.graph import Node, Path, Relationship

from foon_kg.model.errors import GraphError, WriteRefused
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.cypher_faults import told_error, unknown_names
from foon_kg.store.graph.incoming import bound, too_much_came
from foon_kg.store.graph.interruptible import interruptible
from foon_kg.store.graph.looking import HINT, PROCEDURES, only_looking, refuse_the_endless
from foon_kg.store.graph.patterns import TOO_LONG, bounded_texts, too_long
from foon_kg.store.graph.preface import unplanned
from foon_kg.store.graph.question_words import asked, put_around, read_pieces
from foon_kg.store.graph.told_plans import COLUMNS, PROFILED, name_and_details, operators, rows_of

ROW_LIMIT = 1_000
TIME_LIMIT = 30.0
"""Seconds."""

GRACE = 2.0
"""Seconds after its time limit in which a server may say itself that it ended a question."""

MOST_BYTES = 16_000_000
"""How large an answer may be."""

MOST_ON_THE_WIRE = 2 * MOST_BYTES
"""So much of it is read: what a row holds is known only once it is there whole."""

MOST_AT_ONCE = 1_000
"""Rows that the server sends without being asked for more."""

_REFUSED_OPERATORS = ("AdministrationCommand", "LoadCSV", "Show", "Terminate", "Transaction")
_SHOWN = frozenset({"ShowIndexes", "ShowConstraints"})
_ASKED_FOR_ITS_PLAN = "EXPLAIN\n"
_AT_ONCE = "Eager"
"""The operator that has all rows there before the next one goes on."""
_ACCESS_MODE = "Neo.ClientError.Statement.AccessMode"
_WAITED_FOR_EACH_OTHER = "Neo.TransientError.Transaction.DeadlockDetected"
_TIMED_OUT = "Neo.ClientError.Transaction.TransactionTimedOut"
_NO_MEMORY = ("Neo.TransientError.General.OutOfMemoryError", "Neo.TransientError.General.MemoryPoolOutOfMemoryError")


@dataclass(frozen=True)
class Answer:
    """The rows of a query. ``cut`` says that there were more; ``changes`` counts what a write changed.

    ``warnings`` name labels, types and properties that nothing in the graph has. The rows of ``EXPLAIN`` and
    ``PROFILE`` are the operators of the plan.
    """

    columns: tuple[str, ...]
    rows: tuple[tuple[Any, ...], ...]
    cut: bool
    changes: Mapping[str, int]
    warnings: tuple[str, ...] = ()

    def plain_rows(self) -> list[list[Any]]:
        """Return the rows in the types of JSON: nodes, edges and paths as objects, times and places as text."""
        return [[_plain(value) for value in row] for row in self.rows]


def ask_freely(
    connection: Connection,
    text: str,
    parameters: Mapping[str, Any] | None = None,
    *,
    write: bool = False,
    limit: int = ROW_LIMIT,
    timeout: float = TIME_LIMIT,
) -> Answer:
    """Return what ``text`` answers on ``connection``, at most ``limit`` rows.

    It is run once, with ``parameters``; a change that had to be ended for another's is tried again.

    Raises :class:`~foon_kg.model.errors.WriteRefused` for anything but a look at the graph (unless ``write``),
    GraphError where the text is no Cypher, fails, takes longer than ``timeout`` seconds (``timeout``; the server is
    told to end it and may not heed, the caller is answered nevertheless) or answers more than ``MOST_BYTES``
    (``too-much``). Of what could keep a server at it for hours, and is not asked, the code is ``too-much``, too.
    """
    typed = text
    pieces = read_pieces(text) if write else only_looking(text, parameters)
    if write:
        refuse_the_endless(asked(pieces), parameters)
    else:
        text = "".join(piece.text for piece in pieces)
    bounded = put_around(pieces, bounded_texts(pieces, parameters or {}))
    endable = interruptible(pieces, parameters, writing=write)

    def ask() -> Answer:
        with connection.session(writing=write, warned=True, at_once=min(limit + 1, MOST_AT_ONCE)) as session:
            try:
                planned = _planned(session, text, typed, parameters, timeout, write=write)
                if planned is not None and planned.mode == "explain":
                    return _answered_plan(planned.summary.plan, planned.warnings, limit)
                if planned is None:
                    same = endable != bounded and _to_write(session, text, endable, parameters, timeout)
                    return _run_again(session, endable if same else bounded, parameters, limit, timeout)
                answer = _run(session, endable, parameters, limit, timeout)
                columns = answer.columns if planned.mode else planned.columns
                return replace(answer, columns=columns, warnings=planned.warnings)
            except driver_errors.Neo4jError as error:
                raise _explained(error, bounded if write else endable, timeout) from error
            except (driver_errors.SessionExpired, driver_errors.ServiceUnavailable) as error:
                if too_much_came(error):
                    raise _too_large() from error
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
        hint += (
            " The server does not let go of this question. foon-kg's own is started again for it within two minutes, "
            "once nobody else is at work; “foon server stop” ends it at once."
        )
    return GraphError(f"no answer within {timeout:g} seconds", hint=hint, code="timeout")


@dataclass(frozen=True)
class _Planned:
    """How the columns of a question are called, as it is written, and what the server says of its plan.

    ``mode`` is the word before it that asks for the plan, or nothing.
    """

    columns: tuple[str, ...]
    summary: neo4j.ResultSummary
    mode: str
    warnings: tuple[str, ...]


def _planned(
    session: neo4j.Session, text: str, typed: str, parameters: Mapping[str, Any] | None, timeout: float, *, write: bool
) -> _Planned | None:
    """Return how the server goes about a question; ``None`` of one that may write and is to be run.

    Raises :class:`~foon_kg.model.errors.WriteRefused` where one that may not write does more than look, and GraphError
    in lines and columns of the text as it was ``typed``.
    """
    question, mode = unplanned(text)
    if write and mode != "explain":
        return None
    try:
        # The one place where query text is put together: the person's own, behind the word that keeps it from running.
        result = session.run(_typed(_ASKED_FOR_ITS_PLAN + question, timeout), dict(parameters or {}))
        columns, summary = tuple(result.keys()), result.consume()
    except driver_errors.Neo4jError as error:
        raise _explained(error, typed, timeout, lines_before=1) from error
    if not write:
        _refuse_all_but_looking(summary)

    def known(procedure: str) -> list[str]:
        return [str(record[0]) for record in session.run("CALL " + procedure)]

    warnings = tuple(unknown_names(summary.gql_status_objects, known, lines_before=1))
    return _Planned(columns, summary, mode, warnings)


def _to_write(
    session: neo4j.Session, typed: str, endable: str, parameters: Mapping[str, Any] | None, timeout: float
) -> bool:
    """Whether a server goes about what may write in the words that it can end as it does in those that were typed.

    What looks at nodes and takes some away may have to be done at once where it was done row by row.
    """
    plans = []
    try:
        for text in (typed, endable):
            question, mode = unplanned(text)
            plan = session.run(_typed(_ASKED_FOR_ITS_PLAN + question, timeout), dict(parameters or {}))
            names = [name_and_details(step)[0] for _, step in operators(plan.consume().plan or {})]
            plans.append((plan.keys(), names.count(_AT_ONCE)))
    except driver_errors.Neo4jError:  # no Cypher as it is, which running it tells, or none in the other words
        return False
    return not mode and plans[0] == plans[1]


def _answered_plan(
    plan: Mapping[str, Any] | None, warnings: tuple[str, ...], limit: int, *, profiled: bool = False
) -> Answer:
    rows = tuple(rows_of(plan or {}, profiled=profiled))
    return Answer(PROFILED if profiled else COLUMNS, rows[:limit], len(rows) > limit, {}, warnings)


def _run(session: neo4j.Session, text: str, parameters: Mapping[str, Any] | None, limit: int, timeout: float) -> Answer:
    result = session.run(_typed(text, timeout), dict(parameters or {}))
    columns, records, size = tuple(result.keys()), [], 0
    with bound(session, MOST_ON_THE_WIRE):
        for record in result:
            size += sum(map(_size, record.values()))
            if size > MOST_BYTES:
                raise _too_large()
            records.append(record)
            if len(records) > limit:
                break
        summary = result.consume()
    counters = vars(summary.counters)
    if summary.profile:
        return _answered_plan(summary.profile, (), limit, profiled=True)
    changes = {name: count for name, count in sorted(counters.items()) if type(count) is int and count}
    rows = tuple(tuple(record.values()) for record in records[:limit])
    return Answer(columns, rows, len(records) > limit, changes)


def _run_again(
    session: neo4j.Session, text: str, parameters: Mapping[str, Any] | None, limit: int, timeout: float
) -> Answer:
    """Run what may write; until time is up again, where it and another had to wait for each other: nothing of it stays.

    Where it makes transactions of its own some of them may stay: such a question is not asked again.
    """
    until = time.monotonic() + timeout
    again = not any(token.lower in {"transaction", "transactions"} for token in read_pieces(text))
    while True:
        try:
            return _run(session, text, parameters, limit, timeout)
        except driver_errors.TransientError as error:
            if error.code != _WAITED_FOR_EACH_OTHER:
                raise
            if not again or time.monotonic() >= until:
                raise _waited(again=again) from error


def _waited(*, again: bool) -> GraphError:
    told = "nothing was changed" if again else "what its earlier transactions changed stays"
    return GraphError(
        f"this and another change waited for each other, and this was ended: {told}",
        hint="Ask again.",
        code="waited",
    )


def _too_large() -> GraphError:
    return GraphError(
        f"the answer is larger than {MOST_BYTES // 1_000_000} MB",
        hint="Ask for fewer rows or columns, or for counts.",
        code="too-much",
    )


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
    for operator, details in map(name_and_details, (step for _, step in operators(summary.plan or {}))):
        if operator.startswith(_REFUSED_OPERATORS) and operator not in _SHOWN:
            raise WriteRefused(f"this does more than look at the graph ({operator})", hint=HINT)
        if operator.startswith("ProcedureCall") and (name := details.partition("(")[0]) not in PROCEDURES:
            raise WriteRefused(f"the procedure {name} does more than look at the graph", hint=HINT)


def _explained(error: driver_errors.Neo4jError, text: str, timeout: float, *, lines_before: int = 0) -> GraphError:
    code = error.code or ""
    if code == _ACCESS_MODE:
        return WriteRefused("this would change the graph", hint=HINT)
    if code.startswith(_TIMED_OUT):
        return _late(timeout)
    if TOO_LONG in (error.message or ""):
        return too_long()
    if code in _NO_MEMORY:
        return GraphError(
            "this question needs more memory than the server has", hint="Ask for less at once.", code="memory"
        )
    return told_error(error.message or code, text, lines_before=lines_before)


def _plain(value: Any) -> object:  # noqa: ANN401 - whatever a driver can answer
    """Return a value of the driver as JSON knows it: nodes, edges and paths as objects, times and places as text."""
    if isinstance(value, Node):
        return {"labels": sorted(value.labels), "properties": _plain(dict(value))}
    if isinstance(value, Relationship):
        return {"type": value.type, "properties": _plain(dict(value))}
    if isinstance(value, Path):
        return {"nodes": list(map(_plain, value.nodes)), "relationships": list(map(_plain, value.relationships))}
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple | set | frozenset):
        return list(map(_plain, value))
    return value if isinstance(value, str | int | float | bool | None) else str(value)
