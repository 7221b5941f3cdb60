"""A FOON in Neo4j, as the planner asks it: each question one named query, all of a view in one read transaction."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from operator import itemgetter
from typing import Self, TypeVar

import neo4j

from foon_kg.graph.connection import Connection
from foon_kg.graph.equivalents import find_equivalents
from foon_kg.graph.rows import (
    SIDES,
    KnownUnitValue,
    SeenUnit,
    SubgraphRow,
    node_of,
    timing_of,
    unit_of,
)
from foon_kg.graph.schema import check_readable
from foon_kg.graph.statements import (
    BEHIND,
    EQUIVALENTS,
    GOALS,
    SCHEMA_STATE,
    SUBGRAPHS,
    VIDEO_NAMES,
    VOCABULARY,
    Statement,
    ask,
)
from foon_kg.kitchen import Kitchen
from foon_kg.knowledge import MadeBy, Neighbour, SeenAs, Vocabulary
from foon_kg.model import DISH_TYPES, Annotation, Goal, KnownUnit, ObjectNode, Sighting, Subgraph
from foon_kg.server.settings import ConnectionSettings
from foon_kg.similarity import food_similarity
from foon_kg.similarity.answers import nearest_of_each
from foon_kg.snapshot import Snapshot

Row = TypeVar("Row")

_SIGHTING_FIELDS = len(dataclasses.fields(Sighting))


class GraphView:
    """One read transaction on the graph; implements :class:`~foon_kg.knowledge.KnowledgeView`.

    ``round_trips`` counts the queries that were sent. Each method sends one. Neo4j reads what is committed when a query
    starts: a load that ends between two questions shows in the second.
    """

    def __init__(self, transaction: neo4j.Transaction) -> None:
        self._transaction = transaction
        self.round_trips = 0

    def vocabulary(self) -> Vocabulary:
        """Answer the words that the FOON knows."""
        (row,) = self._ask(VOCABULARY)
        foods = (SeenAs(*food) for food in row.foods)
        motions = (MadeBy(*motion) for motion in row.motions)
        return Vocabulary(tuple(sorted(foods)), tuple(sorted(motions)), tuple(sorted(row.dish_types)))

    def goals(self, dish_type: str | None = None) -> tuple[Goal, ...]:
        """Answer the goals of ``dish_type`` (of every type for ``None``), sorted by node and type."""
        asked = DISH_TYPES if dish_type is None else (dish_type,)
        found = ((node_of(row.node), row) for row in self._ask(GOALS, dish_types=asked))
        goals = (Goal(node, row.dish_type, node.ingredients, tuple(sorted(row.videos))) for node, row in found)
        return tuple(sorted(goals, key=lambda goal: (goal.node.sort_key, goal.dish_type)))

    def behind(self, nodes: Collection[ObjectNode], foods: Collection[tuple[str, str]] = ()) -> tuple[KnownUnit, ...]:
        """Answer every unit that may take part in making ``nodes`` or ``foods``, sorted by key."""
        keys = sorted({node.key for node in nodes})
        asked = [{"label": label, "state": state} for label, state in sorted(set(foods))]
        (row,) = self._ask(BEHIND, nodes=keys, foods=asked)
        return tuple(map(_known_unit, sorted(row.units, key=itemgetter(0))))

    def equivalents(self, names: Sequence[str], *, limit: int = 5) -> tuple[tuple[Neighbour, ...], ...]:
        """Answer, for each of ``names``, the ``limit`` known foods that can best stand for it; by the vector index.

        Where the graph was written with other word lists than this program's, its foods are compared in memory.
        """
        found = find_equivalents(lambda asked: self._ask(EQUIVALENTS, **asked), dict.fromkeys(names), limit)
        if found is None:
            return nearest_of_each(food_similarity(), names, self.vocabulary().labels, limit)
        return tuple(found[name] for name in names)

    def video_names(self) -> tuple[str, ...]:
        """Answer the names of all videos, sorted."""
        return tuple(sorted(row.name for row in self._ask(VIDEO_NAMES)))

    def subgraphs(self, names: Collection[str]) -> tuple[Subgraph, ...]:
        """Answer those of the named videos that the graph has, sorted by name, with all that was loaded."""
        rows = self._ask(SUBGRAPHS, names=sorted(set(names)))
        return tuple(sorted(map(subgraph_of, rows), key=lambda subgraph: subgraph.name))

    def check(self, kitchen: Kitchen) -> None:
        """Raise SchemaError or GraphError unless the graph is a FOON that this program can read."""
        check_readable(next(iter(self._ask(SCHEMA_STATE)), None), kitchen)

    def _ask(self, statement: Statement[Row], **parameters: object) -> list[Row]:
        self.round_trips += 1
        return ask(self._transaction, statement, **parameters)


class Neo4jGraph:
    """A FOON kept in Neo4j; implements :class:`~foon_kg.knowledge.KnowledgeGraph`. Close it, or use it in ``with``.

    The first view also checks the schema, which costs it one round trip more.
    """

    def __init__(self, settings: ConnectionSettings, kitchen: Kitchen | None = None) -> None:
        self._connection = Connection(settings)
        self._kitchen = kitchen or Kitchen.default()
        self._checked = False

    @contextmanager
    def reading(self) -> Iterator[GraphView]:
        """Open a view. Raises GraphError where no FOON answers, SchemaError for one of another version."""
        with self._connection.session() as session, session.begin_transaction() as transaction:
            view = GraphView(transaction)
            if not self._checked:
                view.check(self._kitchen)
                self._checked = True
            yield view

    def snapshot(self) -> Snapshot:
        """Answer the whole FOON in memory."""
        with self.reading() as view:
            return Snapshot.of(view.subgraphs(view.video_names()), self._kitchen)

    def close(self) -> None:
        """Give the sockets back."""
        self._connection.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def subgraph_of(row: SubgraphRow) -> Subgraph:
    """Answer the subgraph that was loaded."""
    return Subgraph(row.name, tuple(map(_annotation, row.units)), tuple(row.sources))


def _annotation(unit: SeenUnit) -> Annotation:
    _, verb, accepts_any, inputs, outputs, seen = unit
    return Annotation(unit_of(verb, inputs, outputs, seen, accepts_any=accepts_any), timing_of(seen))


def _known_unit(unit: KnownUnitValue) -> KnownUnit:
    """Write the unit as its first sighting has it, as the snapshot does."""
    _, verb, accepts_any, inputs, outputs, sightings = unit
    sightings.sort(key=itemgetter(0, 1))
    first = dict(zip(SIDES, sightings[0][_SIGHTING_FIELDS:], strict=True))
    written = unit_of(verb, inputs, outputs, first, accepts_any=accepts_any)
    return KnownUnit(written, tuple(Sighting(*sighting[:_SIGHTING_FIELDS]) for sighting in sightings))
