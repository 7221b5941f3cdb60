"""What files would change in the graph, and what taking videos out would: asked without writing anything."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence

import neo4j

from foon_kg.model import Subgraph
from foon_kg.model.errors import UsageError
from foon_kg.model.nodes import distinct_by_name
from foon_kg.plans.difference import VideoDifference, difference, labels_of
from foon_kg.store.graph import statements as cypher
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.statements import ask
from foon_kg.store.graph.values import subgraph_of


def differences(connection: Connection, subgraphs: Iterable[Subgraph]) -> tuple[VideoDifference, ...]:
    """Return for each of ``subgraphs`` what loading it would change now, compared with the graph of ``connection``.

    Raises ReadError where two of them have one name and differ, GraphError where the database fails.
    """
    wanted = {subgraph.name: subgraph for subgraph in distinct_by_name(subgraphs)}
    with connection.session() as session:
        return session.execute_read(_differences, list(wanted), wanted)


def losses(connection: Connection, names: Sequence[str]) -> tuple[VideoDifference, ...]:
    """Return for each of the videos called ``names`` what taking it alone out of the graph would take away.

    ``connection`` leads to that graph. Raises :class:`~foon_kg.model.errors.UsageError` where it has no such video.
    """
    with connection.session() as session:
        return session.execute_read(_losses, names)


def _losses(transaction: neo4j.ManagedTransaction, names: Sequence[str]) -> tuple[VideoDifference, ...]:
    there = {row.name for row in ask(transaction, cypher.VIDEO_CONTENTS, names=list(names))}
    if unknown := [name for name in names if name not in there]:
        raise unknown_videos(transaction, unknown)
    return _differences(transaction, names, {})


def _differences(
    transaction: neo4j.ManagedTransaction, names: Sequence[str], wanted: dict[str, Subgraph]
) -> tuple[VideoDifference, ...]:
    before = {row.name: subgraph_of(row) for row in ask(transaction, cypher.SUBGRAPHS, names=list(names))}
    units = [a.unit for subgraph in (*before.values(), *wanted.values()) for a in subgraph.annotations]
    keys = sorted({unit.key for unit in units})
    shown = {row.key: tuple(row.videos) for row in ask(transaction, cypher.UNITS_SHOWN, keys=keys)}
    known = ask(transaction, cypher.LABELS_THERE, names=sorted(labels_of(units)))
    labels = frozenset(row.name for row in known)
    return tuple(difference(name, before.get(name), wanted.get(name), shown, labels) for name in names)


def unknown_videos(transaction: neo4j.ManagedTransaction, names: Sequence[str]) -> UsageError:
    """Return the error that the graph of ``transaction`` has no videos called ``names``, with what is spelled alike."""
    there = [row.name for row in ask(transaction, cypher.VIDEO_NAMES)]
    near = dict.fromkeys(one for name in sorted(names) for one in difflib.get_close_matches(name, there, n=2))
    meant = f"Did you mean {' or '.join(near)}? " if near else ""
    return UsageError(
        f"the graph has no video “{'”, “'.join(sorted(names))}”",
        hint=f"{meant}A video is named like its file, without the ending: foon cypher 'MATCH (v:Video) RETURN v.name'.",
    )
