"""How much a graph holds, counted by Neo4j: nothing of the FOON itself is read."""

from __future__ import annotations

from foon_kg.model.knowledge import MadeBy
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.schema import check_schema
from foon_kg.store.graph.statements import SCHEMA_STATE, STATISTICS, UNITS_COUNT, ask
from foon_kg.store.statistics import MOST, Statistics, most_first, most_made


def count(connection: Connection) -> Statistics:
    """Return the figures of the whole graph of a ``connection``.

    They are those that :meth:`~foon_kg.store.statistics.Statistics.of` counts in memory. Raises GraphError where no
    FOON answers, SchemaError for one of another version.
    """
    with connection.session() as session, session.begin_transaction() as transaction:
        check_schema(next(iter(ask(transaction, SCHEMA_STATE)), None))
        (row,) = ask(transaction, STATISTICS)
    verbs = most_first(dict(row.verbs))
    return Statistics(
        row.videos,
        row.units,
        row.object_nodes,
        row.labels,
        row.states,
        motions=len(verbs),
        goals=most_first(dict(row.goals)),
        most_used_motions=dict(list(verbs.items())[:MOST]),
        most_made_states=most_made(MadeBy(*motion) for motion in sorted(row.motions)),
    )


def unit_count(connection: Connection) -> int:
    """Return how many units the graph of a ``connection`` has."""
    with connection.session() as session:
        (row,) = session.execute_read(ask, UNITS_COUNT)
    return row.units
