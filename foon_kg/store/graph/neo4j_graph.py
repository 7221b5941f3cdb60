"""A FOON kept in Neo4j: it opens the views through which the planner asks it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Self

from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.edition import Edition
from foon_kg.store.graph.reading import GraphView
from foon_kg.store.graph.remembering import keep_trees
from foon_kg.store.settings import ConnectionSettings

if TYPE_CHECKING:
    from foon_kg.store.snapshot import Snapshot


class Neo4jGraph:
    """A FOON kept in Neo4j. Close it, or use it in ``with``.

    It is a :class:`~foon_kg.model.knowledge.KnowledgeGraph`.

    A view begins with one round trip that checks the schema and asks which edition of the FOON it is. What an earlier
    view of the same edition read is not read again; words and goals not even by another program (``KeptRows``).
    """

    def __init__(self, settings: ConnectionSettings, kitchen: Kitchen | None = None) -> None:
        self._connection = Connection(settings)
        self._kitchen = kitchen or Kitchen.default()
        self._edition = Edition()
        self._keeps_trees = True

    @contextmanager
    def reading(self) -> Iterator[GraphView]:
        """Open a view. Raises GraphError where no FOON answers, SchemaError for one of another version."""
        with self._connection.session() as session, session.begin_transaction() as transaction:
            view = GraphView(transaction)
            self._edition = view.begin(self._kitchen, self._edition)
            yield view
            view.keep()
        if view.retrieved and self._keeps_trees:
            self._keeps_trees = keep_trees(self._connection, view.retrieved)

    def snapshot(self) -> Snapshot:
        """Return the whole FOON in memory."""
        from foon_kg.store.snapshot import Snapshot  # noqa: PLC0415 - slow to import, and few commands need all

        with self.reading() as view:
            return Snapshot.of(view.subgraphs(view.video_names()), self._kitchen)

    def close(self) -> None:
        """Give the sockets back."""
        self._connection.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
