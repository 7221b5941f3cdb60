"""The schema of the graph: applied once, checked at every connection.

The record of it says which of the numbered files in ``cypher/schema`` were applied, and what was in the kitchen
when the graph was written: which nodes are at hand is written into it (``Object.start``), and so are the tables of
foods, which leave utensils out.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import TYPE_CHECKING

import neo4j
from neo4j import exceptions as driver_errors

from foon_kg.cypher import schema_steps
from foon_kg.model import content_key
from foon_kg.model.errors import GraphError, SchemaError
from foon_kg.store.graph.rows import SchemaState
from foon_kg.store.graph.statements import AWAIT_INDEXES, SCHEMA_RECORD, SCHEMA_STATE, ask

if TYPE_CHECKING:
    from foon_kg.plans.kitchen import Kitchen

_SCHEMA_CONFLICT = "Neo.ClientError.Schema."
"""Another program made the same constraint, or the same record, just then: it is there at the next try."""

_TRIES = 5

_COUNTED = "foods in states, states by verbs, verbs by foods; utensils, what moves, which step is next"
"""What the graph tells beside what was annotated. A graph that tells less is written anew, as for another kitchen."""


def schema_version() -> int:
    """Return the version of the schema that this program writes: the number of steps that lead to it."""
    return len(schema_steps())


def kitchen_key(kitchen: Kitchen) -> str:
    """Return a hash of all in ``kitchen`` that decides what is at hand, what is a utensil, and what is counted."""
    return content_key(_COUNTED, *(_sorted(getattr(kitchen, field.name)) for field in dataclasses.fields(kitchen)))


def check_readable(state: SchemaState | None, kitchen: Kitchen) -> None:
    """Raise SchemaError unless a graph in ``state`` answers a program with this ``kitchen`` rightly.

    Raises GraphError where there is none.
    """
    if check_schema(state).kitchen != kitchen_key(kitchen):
        raise SchemaError(
            "the graph was written with another kitchen: other utensils or start states, or by an earlier foon-kg",
            hint="Load any FOON, even one that is there already: foon load foon PATH works the kitchen in anew.",
        )


def check_schema(state: SchemaState | None) -> SchemaState:
    """Return ``state``; raise SchemaError unless this program knows its schema, GraphError where there is no FOON."""
    if state is None:
        raise GraphError("the database holds no FOON yet", hint="Load one: foon load foon PATH…", code="empty")
    _refuse_newer(state)
    if state.version < schema_version():
        raise SchemaError(
            f"the graph has schema {state.version}, this foon-kg needs {schema_version()}",
            hint="Load any FOON, even one that is there already: foon load foon PATH brings the schema up to date.",
        )
    return state


def prepare_for_writing(session: neo4j.Session, kitchen: Kitchen) -> SchemaState:
    """Apply what is missing of the schema in ``session``, and return the state of the graph, written with ``kitchen``.

    Raises SchemaError for a newer one.
    """
    for _ in range(_TRIES - 1):
        try:
            return _up_to_date(session, kitchen)
        except driver_errors.ClientError as error:
            if not (error.code or "").startswith(_SCHEMA_CONFLICT):
                raise
    return _up_to_date(session, kitchen)


def _up_to_date(session: neo4j.Session, kitchen: Kitchen) -> SchemaState:
    state = read_state(session)
    if state is None or state.version < schema_version():
        session.execute_write(_run_steps, state.version if state else 0)
        session.execute_read(ask, AWAIT_INDEXES)
        from foon_kg.store.graph.learnt_by import methods_key  # noqa: PLC0415 - only a new graph needs it

        known = state or SchemaState(0, kitchen_key(kitchen), methods=methods_key())
        state = SchemaState(schema_version(), known.kitchen, known.words, known.edition, known.methods)
        session.execute_write(ask, SCHEMA_RECORD, version=state.version, kitchen=state.kitchen, methods=state.methods)
    _refuse_newer(state)
    return state


def read_state(session: neo4j.Session) -> SchemaState | None:
    """Return what the graph of a ``session`` says about itself, or ``None``."""
    return next(iter(session.execute_read(ask, SCHEMA_STATE)), None)


def _run_steps(transaction: neo4j.ManagedTransaction, after: int) -> None:
    """Run the numbered files that follow number ``after``."""
    for step in schema_steps()[after:]:
        transaction.run(step.text).consume()


def _refuse_newer(state: SchemaState) -> None:
    if state.version > schema_version():
        raise SchemaError(
            f"the graph has schema {state.version}, this foon-kg knows none after {schema_version()}",
            hint="A newer foon-kg wrote it: upgrade with pip install -U foon-kg, or name another NEO4J_DATABASE.",
        )


def _sorted(value: object) -> object:
    if isinstance(value, Mapping):
        return [[key, _sorted(value[key])] for key in sorted(value)]
    return sorted(value) if isinstance(value, frozenset) else value
