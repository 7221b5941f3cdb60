"""Cypher that a person typed: read-only unless writing was asked for, with a limit of rows and of time.

The READ access mode of Neo4j refuses every write to the graph, its schema and its users. It lets through what
reaches outside the graph (``LOAD CSV``), what disturbs others (``TERMINATE TRANSACTIONS``, some procedures) and what
tells about the server (``SHOW …``, but for indexes and constraints). So its words are read first
(:mod:`foon_kg.store.graph.looking`), then its plan is looked at, and nothing of that kind is run.

What is run may be other words that mean the same, and that a server can end (:class:`_Question`); columns, warnings and
faults are told in those that were typed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

import neo4j
from neo4j import exceptions as driver_errors
from neo4j.graph import Node, Path, Relationship

from foon_kg.model.errors import GraphError, WriteRefused
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.cypher_faults import told_error, unknown_names
from foon_kg.store.graph.deadline import Deadline
from foon_kg.store.graph.incoming import bound, too_much_came
from foon_kg.store.graph.interruptible import interruptible
from foon_kg.store.graph.looking import ADD_WRITE, PROCEDURES, only_looking, refuse_the_endless
from foon_kg.store.graph.patterns import bounded_texts, too_long
from foon_kg.store.graph.preface import without_plan_word
from foon_kg.store.graph.question_words import asked, put_around, read_pieces
from foon_kg.store.graph.told_plans import COLUMNS, PROFILED, name_and_details, operators, rows_of

ROW_LIMIT = 1_000
"""How many rows are answered where nobody says another number; the door and the command have the same."""

TIME_LIMIT = 30.0
"""Seconds that a question may take where nobody says another number; the door and the command have the same."""

LARGEST_ANSWER = 16_000_000
"""How large an answer may be, anything but a text counting as eight characters."""

MOST_ON_THE_WIRE = 2 * LARGEST_ANSWER
"""So many bytes of it are read: what a row holds is known only once it is there whole."""

_REFUSED_OPERATORS = ("AdministrationCommand", "LoadCSV", "Show", "Terminate", "Transaction")
_SHOWN = frozenset({"ShowIndexes", "ShowConstraints"})
_ASKED_FOR_ITS_PLAN = "EXPLAIN\n"
_AT_ONCE = "Eager"
"""The operator that has all rows there before the next one goes on."""
_ACCESS_MODE = "Neo.ClientError.Statement.AccessMode"
_WAITED_FOR_EACH_OTHER = "Neo.TransientError.Transaction.DeadlockDetected"
_TIMED_OUT = "Neo.ClientError.Transaction.TransactionTimedOut"
"""How the codes for it begin: another one ends in who set the time (``…ClientConfiguration``)."""
_NO_MEMORY = ("Neo.TransientError.General.OutOfMemoryError", "Neo.TransientError.General.MemoryPoolOutOfMemoryError")


@dataclass(frozen=True)
class Answer:
    """The rows of a query. ``cut`` says that there were more; ``changes`` counts what a write changed.

    ``warnings`` name labels, types and properties that nothing in the graph has; a write has none. The rows of
    ``EXPLAIN`` and ``PROFILE`` are the operators of the plan.
    """

    columns: tuple[str, ...]
    rows: tuple[tuple[Any, ...], ...]
    cut: bool
    changes: Mapping[str, int]
    warnings: tuple[str, ...] = ()

    def plain_rows(self) -> list[list[Any]]:
        """Return the rows in the types of JSON: nodes, edges and paths as objects, times and places as text.

        >>> from datetime import date
        >>> Answer(("day", "n"), ((date(2021, 5, 4), 7),), cut=False, changes={}).plain_rows()
        [['2021-05-04', 7]]
        """
        return [[_plain(value) for value in row] for row in self.rows]


@dataclass(frozen=True)
class _Question:
    """A question in words that mean the same, and within what it is to be answered.

    ``unplanned`` is to be EXPLAINed: as it was typed, but for comments where it may only look, and for ``plan_word``
    before it (``explain``, ``profile``, or nothing). In ``bounded`` no text is too long for its pattern; ``endable`` is
    that, and a server can end its list expressions as well.
    """

    typed: str
    unplanned: str
    plan_word: str
    bounded: str
    endable: str
    parameters: dict[str, Any]
    limit: int
    deadline: Deadline
    makes_transactions: bool
    """Whether it changes something in transactions of its own, of which the earlier ones stay whatever comes."""

    @property
    def is_asked_as_typed(self) -> bool:
        """Whether there is nothing in it that other words could bound or end."""
        return self.typed == self.bounded == self.endable


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

    It is run once, with ``parameters``; a change that had to be ended for another's is tried again. Of a change that is
    not answered nothing stays, but where it makes transactions of its own: then the error says that some of it does.

    Raises :class:`~foon_kg.model.errors.WriteRefused` for anything but a look at the graph (unless ``write``), and, be
    it to ``write`` or not, for a text in which something could hide. Raises GraphError, by its code, where the text is
    no Cypher or fails (``cypher``); where planning and running it takes longer than ``timeout`` seconds (``timeout``;
    the server is told to end it and may not heed, the caller is answered nevertheless); where it answers more than
    ``LARGEST_ANSWER``, or could keep a server at it for hours and is not asked (``too-much``); where the server had
    too little ``memory``, or ended of it (``server-ended``); where it and another change waited for each other
    (``waited``); and what :meth:`Connection.session` raises.
    """
    question = _question(text, dict(parameters or {}), limit, Deadline.after(timeout), write=write)

    def ask() -> Answer:
        # One row more than is shown tells that there are more. Of many, as many come at once as the driver has chosen.
        at_once = limit + 1 if limit < ROW_LIMIT else None
        with connection.session(writing=write, warned=True, at_once=at_once) as session, _server_ended(question):
            return _ask_to_write(session, question) if write else _ask_to_look(session, question)

    return question.deadline.within(ask, writing=write)


def _question(text: str, parameters: dict[str, Any], limit: int, deadline: Deadline, *, write: bool) -> _Question:
    """Return what is asked; raises WriteRefused and GraphError for what no server shall see."""
    pieces = read_pieces(text) if write else only_looking(text, parameters)
    if write:
        refuse_the_endless(asked(pieces), parameters)
    bounded = put_around(pieces, bounded_texts(pieces, parameters))
    endable = interruptible(pieces, parameters, writing=write)
    parts = any(piece.lower in {"transaction", "transactions"} for piece in pieces)
    return _Question(text, *without_plan_word(pieces), bounded, endable, parameters, limit, deadline, parts)


@contextmanager
def _server_ended(question: _Question) -> Iterator[None]:
    """Raise a GraphError where the server is lost that had let us in; what it lost us for may be the answer itself."""
    try:
        yield
    except (driver_errors.SessionExpired, driver_errors.ServiceUnavailable) as error:
        if too_much_came(error):
            raise _too_large(question) from error
        raise GraphError(
            "the server ended while it was at this question, most likely because it needed too much memory",
            hint="Ask for less. foon-kg's own server starts again with the next command.",
            code="server-ended",
        ) from error


def _ask_to_look(session: neo4j.Session, question: _Question) -> Answer:
    columns, summary = _planned_as_typed(session, question)
    _refuse_all_but_looking(summary)
    warnings = _warnings(session, question, summary)
    if question.plan_word == "explain":
        return replace(_answered_plan(summary.plan, question.limit), warnings=warnings)
    with _faults_in(question, None):
        answer = _run(session, question.endable, question)
    return replace(answer, columns=answer.columns if question.plan_word else columns, warnings=warnings)


def _ask_to_write(session: neo4j.Session, question: _Question) -> Answer:
    if question.is_asked_as_typed and question.plan_word != "explain":
        with _faults_in(question, question.typed):
            return _run_again(session, question.typed, question)
    columns, summary = _planned_as_typed(session, question)
    if question.plan_word == "explain":
        warnings = _warnings(session, question, summary)
        return replace(_answered_plan(summary.plan, question.limit), warnings=warnings)
    with _faults_in(question, None):
        if question.plan_word:  # the plan that is shown is that of what was typed, as nearly as may be
            return _run_again(session, question.bounded, question)
        text = question.endable if _ends_in_the_same_way(session, question, summary) else question.bounded
        return replace(_run_again(session, text, question), columns=columns)


def _planned_as_typed(session: neo4j.Session, question: _Question) -> tuple[tuple[str, ...], neo4j.ResultSummary]:
    """Return how the columns of a question are called, as it is written, and what the server says of its plan."""
    with _faults_in(question, question.typed, lines_before=1):
        return _planned(session, question.unplanned, question)


def _planned(session: neo4j.Session, text: str, question: _Question) -> tuple[tuple[str, ...], neo4j.ResultSummary]:
    # The one place where query text is put together: the person's own, behind the word that keeps it from running.
    result = session.run(_in_time(_ASKED_FOR_ITS_PLAN + text, question), question.parameters)
    return tuple(result.keys()), result.consume()


def _warnings(session: neo4j.Session, question: _Question, summary: neo4j.ResultSummary) -> tuple[str, ...]:
    """Return a line about each name in a question that nothing in the graph has, by the ``summary`` of its plan."""

    def known(procedure: str) -> list[str]:
        return [str(record[0]) for record in session.run(_in_time("CALL " + procedure, question))]

    with _faults_in(question, None):
        return tuple(unknown_names(summary.gql_status_objects, known, lines_before=1))


def _ends_in_the_same_way(session: neo4j.Session, question: _Question, as_typed: neo4j.ResultSummary) -> bool:
    """Whether a server goes about what writes in the words that it can end as it does in those that were typed.

    What looks at nodes and takes some away may have to be done at once where it was done row by row. And not all that
    may stand in a question may stand in those words.
    """
    if question.endable == question.bounded:
        return False
    try:
        endable = _planned(session, question.endable, question)[1]
    except driver_errors.ClientError as error:
        if (error.code or "").startswith(_TIMED_OUT):
            raise
        return False
    return _times_at_once(endable) == _times_at_once(as_typed)


def _times_at_once(summary: neo4j.ResultSummary) -> int:
    return [name_and_details(step)[0] for _, step in operators(summary.plan or {})].count(_AT_ONCE)


def _answered_plan(plan: Mapping[str, Any] | None, limit: int, *, profiled: bool = False) -> Answer:
    rows = tuple(rows_of(plan or {}, profiled=profiled))
    return Answer(PROFILED if profiled else COLUMNS, rows[:limit], len(rows) > limit, {})


def _run(session: neo4j.Session, text: str, question: _Question) -> Answer:
    """Return what ``text`` answers, which is the ``question`` in these or those words."""
    return _read(session, session.run(_in_time(text, question), question.parameters), question)


def _run_whole(session: neo4j.Session, text: str, question: _Question) -> Answer:
    """Return what a write answers, in a transaction of which nothing stays where there is no answer or no time left."""
    with session.begin_transaction(timeout=question.deadline.left()) as transaction:
        answer = _read(session, transaction.run(text, question.parameters), question)
        question.deadline.left()  # who asked is told soon that there is no answer
        transaction.commit()
    return answer


def _read(session: neo4j.Session, result: neo4j.Result, question: _Question) -> Answer:
    """Return the rows of a ``result``; raises GraphError where they are too large."""
    columns = tuple(result.keys())
    records: list[neo4j.Record] = []
    characters = 0
    with bound(session, MOST_ON_THE_WIRE):
        for record in result:
            characters += sum(map(_size, record.values()))
            if characters > LARGEST_ANSWER:
                raise _too_large(question)
            records.append(record)
            if len(records) > question.limit:
                break
        summary = result.consume()
    # The driver lists its counters nowhere; beside them stand truths (contains_updates), which are no int by type.
    counted = vars(summary.counters)
    changes = {name: count for name, count in sorted(counted.items()) if type(count) is int and count}
    if summary.profile:
        return replace(_answered_plan(summary.profile, question.limit, profiled=True), changes=changes)
    rows = tuple(tuple(record.values()) for record in records[: question.limit])
    return Answer(columns, rows, len(records) > question.limit, changes)


def _run_again(session: neo4j.Session, text: str, question: _Question) -> Answer:
    """Run a write, and again where it was ended for another's (nothing of it stays then), until the time is up.

    It is no busy loop: the next time it waits in the server until the other is done. Where it makes transactions of its
    own some of them may stay: such a question is not asked again.
    """
    while True:
        try:
            return (_run if question.makes_transactions else _run_whole)(session, text, question)
        except driver_errors.TransientError as error:
            if error.code != _WAITED_FOR_EACH_OTHER:
                raise
            if question.makes_transactions or question.deadline.is_over:
                raise _waited(question) from error


def _waited(question: _Question) -> GraphError:
    return GraphError(
        "this and another change waited for each other, and this was ended",
        hint="Ask again." + _what_stays(question),
        code="waited",
    )


def _too_large(question: _Question) -> GraphError:
    return GraphError(
        f"the answer is larger than {LARGEST_ANSWER // 1_000_000} MB",
        hint="Ask for fewer rows or columns, or for counts." + _what_stays(question),
        code="too-much",
    )


def _what_stays(question: _Question) -> str:
    """Return what there is to say of a change that was not answered."""
    return " What its earlier transactions changed stays." if question.makes_transactions else ""


def _size(value: object) -> int:
    """Return about how many characters a value has."""
    if isinstance(value, str | bytes):
        return len(value)
    if isinstance(value, Mapping):  # nodes and relationships, too
        return sum(_size(key) + _size(item) for key, item in value.items())
    if isinstance(value, Path):
        return _size(value.nodes) + _size(value.relationships)
    if isinstance(value, list | tuple | set | frozenset):
        return sum(map(_size, value))
    return 8


def _in_time(text: str, question: _Question) -> neo4j.Query:
    """Return what the driver is asked, which the server ends when the time of the ``question`` is over."""
    return neo4j.Query(text, timeout=question.deadline.left())


def _refuse_all_but_looking(summary: neo4j.ResultSummary) -> None:
    if summary.query_type != "r":
        raise WriteRefused("this would change the graph, its schema, its users or the server", hint=ADD_WRITE)
    for operator, details in map(name_and_details, (step for _, step in operators(summary.plan or {}))):
        if operator.startswith(_REFUSED_OPERATORS) and operator not in _SHOWN:
            raise WriteRefused(f"this does more than look at the graph ({operator})", hint=ADD_WRITE)
        if operator.startswith("ProcedureCall") and (name := details.partition("(")[0]) not in PROCEDURES:
            raise WriteRefused(f"the procedure {name} does more than look at the graph", hint=ADD_WRITE)


@contextmanager
def _faults_in(question: _Question, text: str | None, *, lines_before: int = 0) -> Iterator[None]:
    """Raise what a server says of a question as GraphError, in the lines of ``text``.

    The server got so many ``lines_before`` of ours; ``None`` where it was asked in words that nobody typed.
    """
    try:
        yield
    except driver_errors.Neo4jError as error:
        raise _explained(error, question, text, lines_before) from error


def _explained(error: driver_errors.Neo4jError, question: _Question, text: str | None, lines_before: int) -> GraphError:
    code = error.code or ""
    if code == _ACCESS_MODE:
        return WriteRefused("this would change the graph", hint=ADD_WRITE)
    if code.startswith(_TIMED_OUT):
        return question.deadline.late(more=_what_stays(question))
    if text is None and (refused := too_long(error.message or "")):
        return refused
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
