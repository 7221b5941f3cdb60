"""Where a FOON is: in files that were read into memory, or in a Neo4j; and how it is read from there."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Self, TypeVar

from foon_kg.model.errors import ReadError, UsageError

if TYPE_CHECKING:  # every question imports what it needs: a command asks one, and should begin at once
    from foon_kg.model.drafted import Lesson
    from foon_kg.store.graph import Connection, GraphView, Neo4jGraph
    from foon_kg.store.server import ConnectionSettings
    from foon_kg.store.snapshot import Snapshot
    from foon_kg.store.with_drafts import WithDrafts
    from foon_kg.validation import KnownFoon

Found = TypeVar("Found")
Paths = str | os.PathLike[str]
Say = Callable[[str], None]
"""Takes one line for a person."""


def silent(_: object) -> None:
    """Say nothing."""


class Opened:
    """A FOON in files in memory, or in a Neo4j."""

    def __init__(
        self,
        snapshot: Snapshot | None = None,
        server: ConnectionSettings | None = None,
        lessons: Sequence[Lesson] = (),
    ) -> None:
        if (snapshot is None) == (server is None):
            raise UsageError("a FOON is in files or in a Neo4j", hint="Call Foon.from_files or Foon.connect.")
        self._snapshot = snapshot
        self._server = server
        self._lessons = lessons

    @classmethod
    def from_files(cls, *paths: Paths, drafts: Sequence[Paths] = ()) -> Self:
        """Read subgraph files and tables, and all in folders. What of them cannot be used is left out.

        ``drafts`` are files that ``foon draft recipes`` wrote: kept apart, for whoever plans ``with_drafts``.

        Raises :class:`~foon_kg.model.errors.ReadError` where there is nothing to read.

        >>> Foon.from_files(demo_folder())
        <Foon of 23 videos in memory>
        """
        from foon_kg.loaders.lessons import lessons_of, read_drafted
        from foon_kg.loaders.video_tables import read_videos
        from foon_kg.model.drafted import surest
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.store.snapshot import Snapshot

        found = [result.subgraph for result in read_videos([Path(path) for path in paths])]
        subgraphs = [subgraph for subgraph in found if subgraph is not None]
        if not subgraphs:
            names = ", ".join(map(str, paths)) or "no path"
            raise ReadError(f"there is no FOON in {names}", hint="Name subgraph files or folders.")
        return cls(
            snapshot=Snapshot.of(subgraphs, Kitchen.default()),
            lessons=surest(lessons_of(read_drafted(map(Path, drafts)))) if drafts else (),
        )

    @classmethod
    def connect(
        cls,
        uri: str | None = None,
        user: str = "neo4j",
        password: str = "",
        database: str = "neo4j",
        *,
        say: Say = silent,
    ) -> Self:
        """Connect to the Neo4j at ``uri``; without one to that of NEO4J_URI, else to foon-kg's own, which is started.

        What is done to start it, line by line, goes to ``say`` (``print``, say). Raises
        :class:`~foon_kg.model.errors.ServerError` where it cannot be started; whether a Neo4j answers shows the first
        question (:class:`~foon_kg.model.errors.GraphError`).
        """
        from foon_kg.store.server import ConnectionSettings, connection_settings

        return cls(
            server=connection_settings(say) if uri is None else ConnectionSettings(uri, user, password, database)
        )

    def close(self) -> None:
        """Give connections back. Another question opens them again."""
        for name in ("_graph", "_connection"):
            if name in self.__dict__:
                self.__dict__.pop(name).close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        if self._snapshot is not None:
            return f"<Foon of {len(self._snapshot.subgraphs)} videos in memory>"
        return f"<Foon at {self._server.uri if self._server else ''}>"

    @contextmanager
    def reading(self) -> Iterator[Snapshot | GraphView]:
        """Open the FOON for reading, for what this class has no method for.

        >>> with foon.reading() as view:
        ...     len(view.goals())
        23
        """
        if self._snapshot is not None:
            yield self._snapshot
            return
        with self._graph.reading() as view:
            yield view

    def of_one_state(self, ask: Callable[[Snapshot | GraphView], Found]) -> Found:
        """Return what ``ask`` finds, asked anew where somebody wrote to the FOON meanwhile."""
        with self.reading() as view:
            found = ask(view)
            while view.moved():
                found = ask(view)
            return found

    def snapshot(self) -> Snapshot:
        """Return the whole FOON in memory, as it stands now."""
        return self._snapshot or self._graph.snapshot()

    def with_drafts(self) -> WithDrafts:
        """Return the whole FOON in memory with what its drafts of recipes teach; there may be none."""
        from foon_kg.store.with_drafts import WithDrafts

        if self._snapshot is not None:
            return self._with_drafts
        with self._graph.reading() as view:
            return WithDrafts.of(self._graph.snapshot(), view.lessons())

    @cached_property
    def _with_drafts(self) -> WithDrafts:
        """What :meth:`with_drafts` returns of files: it never changes."""
        from foon_kg.store.with_drafts import WithDrafts

        return WithDrafts.of(self.snapshot(), self._lessons)

    @cached_property
    def known(self) -> KnownFoon:
        """What the judge compares a tree's evidence with."""
        from foon_kg.validation import KnownFoon

        whole = self.snapshot()
        return KnownFoon.of(whole.units, whole.goals())

    @cached_property
    def _graph(self) -> Neo4jGraph:
        from foon_kg.store.graph import Neo4jGraph

        return Neo4jGraph(self._needs_server("to read"))

    @cached_property
    def _connection(self) -> Connection:
        from foon_kg.store.graph.connection import Connection

        return Connection(self._needs_server("to ask"))

    def _needs_server(self, what: str) -> ConnectionSettings:
        if self._server is None:
            raise UsageError(f"a FOON in files has no Neo4j {what}", hint="Use Foon.connect().")
        return self._server
