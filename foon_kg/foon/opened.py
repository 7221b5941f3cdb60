"""Where a FOON is: in files that were read into memory, or in a Neo4j; and how it is read from there."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Self, TypeVar

from foon_kg.model.errors import ReadError, UsageError

if TYPE_CHECKING:  # every question imports what it needs: a command asks one, and should begin at once
    from foon_kg.evaluation.recorded_dishes import RecordedDish
    from foon_kg.model import Subgraph
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


def listed(values: Iterable[Found], name: str) -> list[Found]:
    """Return ``values``, an argument called ``name``, as a list; raises UsageError for one text and for no list."""
    if isinstance(values, str | bytes | Mapping) or not isinstance(values, Iterable):
        raise UsageError(f"{name} is a list, and no {type(values).__name__}", hint=f'As in: {name}=["…", "…"].')
    return list(values)


def path_at(path: Paths) -> Path:
    """Return ``path``; raises UsageError for an empty one, which would be the folder that a program runs in."""
    if not os.fspath(path):
        raise UsageError("a path is empty", hint="“.” is the folder that you are in.")
    return Path(path)


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
        self._known: tuple[str | None, KnownFoon] | None = None

    @classmethod
    def from_files(cls, *paths: Paths, drafts: Sequence[Paths] = ()) -> Self:
        """Read subgraph files and tables, and all in folders. What of them cannot be used is left out.

        ``paths`` name them; ``drafts`` are files that ``foon draft recipes`` wrote: kept apart, for whoever plans
        ``with_drafts``.

        Raises :class:`~foon_kg.model.errors.ReadError` where there is nothing to read.

        >>> Foon.from_files(demo_folder())
        <Foon of 23 videos in memory>
        """
        from foon_kg.loaders.lessons import lessons_of, read_drafted
        from foon_kg.loaders.video_tables import read_videos
        from foon_kg.model.drafted import surest

        found = [result.subgraph for result in read_videos([path_at(path) for path in paths])]
        subgraphs = [subgraph for subgraph in found if subgraph is not None]
        if not subgraphs:
            names = ", ".join(map(str, paths)) or "no path"
            raise ReadError(f"there is no FOON in {names}", hint="Name subgraph files or folders.")
        return cls.of_subgraphs(subgraphs, surest(lessons_of(read_drafted(map(Path, drafts)))) if drafts else ())

    @classmethod
    def of_subgraphs(cls, subgraphs: Iterable[Subgraph], lessons: Sequence[Lesson] = ()) -> Self:
        """Return the FOON of subgraphs that were read already, with the ``lessons`` of drafts for ``with_drafts``.

        >>> Foon.of_subgraphs(foon.snapshot().subgraphs[:2])
        <Foon of 2 videos in memory>
        """
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.store.snapshot import Snapshot

        return cls(snapshot=Snapshot.of(subgraphs, Kitchen.default()), lessons=lessons)

    @classmethod
    def connect(
        cls,
        uri: str | None = None,
        user: str | None = None,
        password: str | None = None,
        database: str | None = None,
        *,
        say: Say = silent,
    ) -> Self:
        """Connect to the Neo4j at ``uri``; without one to that of NEO4J_URI, else to foon-kg's own, which is started.

        ``user`` (``neo4j``) and ``password`` (none) open its ``database`` (``neo4j``); those of NEO4J_URI are in the
        environment, too. What is done to start it, line by line, goes to ``say`` (``print``, say). Raises
        :class:`~foon_kg.model.errors.ServerError` where it cannot be started, and
        :class:`~foon_kg.model.errors.UsageError` for a user, a password or a database without a ``uri``. Whether a
        Neo4j answers shows the first question (:class:`~foon_kg.model.errors.GraphError`).

        >>> Foon.connect("bolt://localhost:7687", password="secret")
        <Foon at bolt://localhost:7687>
        """
        from foon_kg.store.server import ConnectionSettings, connection_settings

        if uri is not None:
            return cls(server=ConnectionSettings(uri, user or "neo4j", password or "", database or "neo4j"))
        if user or password or database:
            hint = "Name its uri, or set NEO4J_URI with NEO4J_USER, NEO4J_PASSWORD and NEO4J_DATABASE."
            raise UsageError("a user, a password or a database says nothing of which Neo4j", hint=hint)
        return cls(server=connection_settings(say))

    @classmethod
    def on_this_machine(cls, *, say: Say = silent) -> Self:
        """Connect to foon-kg's own Neo4j, which is started if it is down, whatever NEO4J_URI names.

        What is done to start it, line by line, goes to ``say``. Raises :class:`~foon_kg.model.errors.ServerError` where
        it cannot be started.
        """
        from foon_kg.store.server import ensure_running

        return cls(server=ensure_running(say))

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
        """Return what ``ask`` finds, asked anew where somebody wrote to the FOON meanwhile.

        >>> foon.of_one_state(lambda view: len(view.goals()))
        23
        """
        with self.reading() as view:
            found = ask(view)
            while view.moved():
                found = ask(view)
            return found

    def snapshot(self) -> Snapshot:
        """Return the whole FOON in memory, as it stands now.

        >>> len(foon.snapshot().subgraphs)
        23
        """
        return self._snapshot or self._graph.snapshot()

    def with_drafts(self) -> WithDrafts:
        """Return the whole FOON in memory with what its drafts of recipes teach; there may be none.

        >>> len(foon.with_drafts().units) == len(foon.snapshot().units)
        True
        """
        from foon_kg.store.with_drafts import WithDrafts

        if self._snapshot is not None:
            return self._with_drafts
        with self._graph.reading() as view:
            return WithDrafts.of(self._graph.snapshot(), view.lessons())

    @staticmethod
    def kinds_of_food() -> Sequence[str]:
        """Return the kinds of food that :meth:`plan` can ``avoid``.

        >>> "nuts" in foon.kinds_of_food()
        True
        """
        from foon_kg.similarity.groups import food_groups

        return food_groups().groups

    def foods(self) -> Sequence[str]:
        """Return the names of the foods that the FOON knows, sorted.

        >>> foon.foods()[:3]
        ['apple', 'apple juice', 'bacon']
        """
        with self.reading() as view:
            return view.vocabulary().labels

    def lessons(self) -> tuple[Lesson, ...]:
        """Return what the drafts of recipes teach that :meth:`plan` takes ``with_drafts``.

        >>> foon.lessons()
        ()
        """
        if self._snapshot is not None:
            return tuple(self._lessons)
        with self._graph.reading() as view:
            return view.lessons()

    def content_key(self) -> str:
        """Return a name for what the FOON knows: equal for equal units, whatever their videos are called.

        >>> foon.content_key() == Foon.from_files(demo_folder()).content_key()
        True
        """
        from foon_kg.model import content_key

        return content_key([known.unit.key for known in self.snapshot().units])

    def recorded_dishes(self) -> Iterator[RecordedDish]:
        """Yield the dishes that the videos make, each with the recipe that asks for it: what this FOON can be asked.

        They come by dish type in turns, those first that show best what a plan is. The whole FOON is read.

        >>> dish = next(foon.recorded_dishes())
        >>> dish.goal.node.label, dish.recipe.dish_type, dish.texts[:2]
        ('fruit punch', 'drinks', ('liquid apple juice', 'cube ice'))
        """
        from foon_kg.evaluation.recorded_dishes import recorded_dishes

        return recorded_dishes(self.snapshot())

    def is_larger_than(self, units: int) -> bool:
        """Whether the FOON is in a graph that has more than so many ``units``; files are in memory, of any size.

        >>> foon.is_larger_than(10)
        False
        """
        return self._snapshot is None and self.unit_count() > units

    def unit_count(self) -> int:
        """Return how many units the FOON has.

        >>> foon.unit_count() == len(foon.snapshot().units)
        True
        """
        if self._snapshot is not None:
            return len(self._snapshot.units)
        from foon_kg.store.graph.counting import unit_count

        return unit_count(self._connection)

    @property
    def server(self) -> ConnectionSettings:
        """The Neo4j that holds the FOON. Raises ``UsageError`` for one in files.

        >>> Foon.connect("bolt://localhost:7687", password="secret").server.uri
        'bolt://localhost:7687'
        """
        return self._needs_server("to ask")

    def edition(self) -> str | None:
        """Return the name of what the graph holds now: another one has other content. ``None`` where it tells none.

        Files are always of one edition, and tell none. Raises :class:`~foon_kg.model.errors.GraphError` where no FOON
        answers.

        >>> foon.edition()
        """
        if self._snapshot is not None:
            return None
        with self._graph.reading() as view:
            return view.edition

    @cached_property
    def _with_drafts(self) -> WithDrafts:
        """What :meth:`with_drafts` returns of files: it never changes."""
        from foon_kg.store.with_drafts import WithDrafts

        return WithDrafts.of(self.snapshot(), self._lessons)

    @property
    def known(self) -> KnownFoon:
        """What the judge compares a tree's evidence with.

        >>> len(foon.known.goals)
        23
        """
        from foon_kg.validation import KnownFoon

        # kept, since each plan.check() asks for it and it takes the whole FOON; anybody may have loaded something since
        edition = self.edition()
        tells_changes = edition is not None or self._snapshot is not None
        if self._known is None or self._known[0] != edition or not tells_changes:
            whole = self.snapshot()
            self._known = (edition, KnownFoon.of(whole.units, whole.goals()))
        return self._known[1]

    @cached_property
    def _graph(self) -> Neo4jGraph:
        from foon_kg.store.graph import Neo4jGraph

        return Neo4jGraph(self._needs_server("to read"))

    @cached_property
    def _connection(self) -> Connection:
        from foon_kg.store.graph.connection import Connection

        return Connection(self._needs_server("to ask"))

    def connection_for(self, what: str) -> Connection:
        """Return the connection to the Neo4j; raises UsageError for a FOON in files, which has none for ``what``.

        >>> foon.connection_for("for recipes")
        Traceback (most recent call last):
        foon_kg.model.errors.UsageError: a FOON in files has no Neo4j for recipes
        """
        self._needs_server(what)
        return self._connection

    def _needs_server(self, what: str) -> ConnectionSettings:
        if self._server is None:
            raise UsageError(f"a FOON in files has no Neo4j {what}", hint="Use Foon.connect().")
        return self._server
