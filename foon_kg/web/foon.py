"""The FOON that is served: in memory, or in a graph that is too large for it, and which edition of it stands now."""

from __future__ import annotations

import itertools
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.foon import ConnectionSettings, Foon, Snapshot
from foon_kg.foon.answering import WHOLE
from foon_kg.model import content_key
from foon_kg.model.drafted import Lesson
from foon_kg.model.errors import GraphError
from foon_kg.plans.kitchen import Kitchen

EVERY = 2.0
"""Seconds between two looks whether the graph is still the same."""

EMPTY = "empty"
"""The edition of a database that holds no FOON yet."""


@dataclass(frozen=True)
class Served:
    """A FOON and the name of its edition: another one has other content.

    It is in memory (``snapshot``), or so large that who answers asks the graph of ``server`` for what each question
    needs. ``lessons`` are what drafts of recipes teach, for who asks to plan with them.
    """

    edition: str
    snapshot: Snapshot | None = None
    lessons: tuple[Lesson, ...] = ()
    server: ConnectionSettings | None = None

    def foon(self) -> Foon:
        """Return what answers questions about it; close it."""
        return Foon(self.snapshot, self.server, self.lessons)


class FixedFoon:
    """The FOON of files: it never changes while it is served."""

    def __init__(self, snapshot: Snapshot, lessons: Sequence[Lesson] = ()) -> None:
        self._snapshot = snapshot
        self._lessons = tuple(lessons)

    def edition(self) -> str:
        """Return the name of its only edition."""
        return self._name

    def fresh(self) -> str:
        """Return the name of its only edition."""
        return self.edition()

    def read(self) -> Served:
        """Return the FOON."""
        return Served(self._name, self._snapshot, self._lessons)

    def close(self) -> None:
        """Nothing is held open."""

    @cached_property
    def _name(self) -> str:
        drafts = [lesson.subgraph.name for lesson in self._lessons]
        return content_key([*(known.unit.key for known in self._snapshot.units), *drafts])


class LiveFoon:
    """The FOON of a graph, one without units where nothing is loaded yet. Any number of threads may ask.

    ``opened`` connects; it is called again where the graph stopped answering, as the local server does when it idles.
    One of more units than ``whole`` is never read as a whole.
    """

    def __init__(self, opened: Callable[[], Foon], every: float = EVERY, whole: int = WHOLE) -> None:
        self._opened = opened
        self._whole = whole
        self._every = every
        self._turn = threading.Lock()
        self._opening = threading.Lock()
        self._foon: Foon | None = None
        self._name: str | None = None
        self._looked = 0.0
        self._unnamed = (f"look-{number}" for number in itertools.count())

    def edition(self) -> str:
        """Return which edition the graph had at most ``every`` seconds ago; raises GraphError where nothing answers.

        While one thread looks the others are told what was seen before.
        """
        known = self._name
        if not self._turn.acquire(blocking=known is None):
            return known or self.edition()
        try:
            if self._name is None or time.monotonic() - self._looked >= self._every:
                self._name = self._look()
                self._looked = time.monotonic()
            return self._name
        finally:
            self._turn.release()

    def fresh(self) -> str | None:
        """Return which edition was seen in the last ``every`` seconds, if any was; waits for nobody."""
        return self._name if time.monotonic() - self._looked < self._every else None

    def read(self) -> Served:
        """Return the FOON as it stands now, or newer than its name says: then the next look sees another edition."""
        name = self._read_name()
        if name == EMPTY:
            return Served(name, Snapshot((), (), Kitchen.default()))
        foon = self._connected()
        if foon.is_larger_than(self._whole):
            return Served(name, None, foon.lessons(), foon.server)
        return Served(name, foon.snapshot(), foon.lessons())

    def close(self) -> None:
        """Give the sockets back."""
        with self._opening:
            if self._foon is not None:
                self._foon.close()
                self._foon = None

    def _look(self) -> str:
        try:
            return self._read_name()
        except GraphError as error:
            if error.code != "unreachable" or self._name is None:
                raise
            self.close()
            return self._read_name()

    def _read_name(self) -> str:
        """Return the edition's name; of a graph that does not tell editions apart each look is one of its own."""
        try:
            return self._connected().edition() or next(self._unnamed)
        except GraphError as error:
            if error.code != EMPTY:
                raise
            return EMPTY

    def _connected(self) -> Foon:
        with self._opening:  # one thread reads the FOON while another looks whether it is still the same
            if self._foon is None:
                self._foon = self._opened()
            return self._foon
