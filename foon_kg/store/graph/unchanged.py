"""Whether a load would change nothing: asked of the graph with the hashes of what is to be loaded."""

from __future__ import annotations

from collections.abc import Mapping

from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.rows import SchemaState
from foon_kg.store.graph.schema import kitchen_key, schema_version
from foon_kg.store.graph.statements import SCHEMA_STATE, VIDEO_CONTENTS, ask


def all_there(connection: Connection, contents: Mapping[str, str], kitchen: Kitchen) -> bool:
    """Return whether the graph of ``connection`` has videos of these ``contents`` (hashes by name).

    They must be written as this program would write them with this ``kitchen``. Nothing is raised for a graph that is
    not so: a load tells that.
    """
    with connection.session(writing=True) as session, session.begin_transaction() as transaction:
        state = next(iter(ask(transaction, SCHEMA_STATE)), None)
        if state is None or not _as_ours(state, kitchen):
            return False
        rows = ask(transaction, VIDEO_CONTENTS, names=list(contents))
        return {row.name: row.content for row in rows} == contents


def _as_ours(state: SchemaState, kitchen: Kitchen) -> bool:
    theirs = state.version, state.kitchen, state.words, state.methods
    return theirs == (schema_version(), kitchen_key(kitchen), word_lists_key(), methods_key())
