"""The FOON that is served, as it stands now: in memory, and read anew when somebody has written to the graph."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Neo4jGraph
from foon_kg.store.snapshot import Snapshot

EVERY = 2.0
"""Seconds between two looks whether the graph is still the same."""


@dataclass(frozen=True)
class Served:
    """A FOON in memory; another ``edition`` (a number that only grows) has other content."""

    edition: int
    snapshot: Snapshot


class FixedFoon:
    """The FOON of files: it never changes while it is served."""

    def __init__(self, snapshot: Snapshot) -> None:
        self._served = Served(0, snapshot)

    def current(self) -> Served:
        """Answer the FOON."""
        return self._served

    def fresh(self) -> Served:
        """Answer the FOON."""
        return self._served

    def close(self) -> None:
        """Nothing is held open."""


class LiveFoon:
    """The FOON of a graph. Any number of threads may ask.

    ``opened`` connects; it is called again where the graph stopped answering, as the local server does when it idles.
    """

    def __init__(self, opened: Callable[[], Neo4jGraph], every: float = EVERY) -> None:
        self._opened = opened
        self._every = every
        self._turn = threading.Lock()
        self._graph: Neo4jGraph | None = None
        self._name: str | None = None
        self._served: Served | None = None
        self._looked = 0.0

    def current(self) -> Served:
        """Answer the FOON as it was at most ``every`` seconds ago; raises GraphError where nothing answers.

        While one thread reads a new edition the others go on with the one before.
        """
        served = self.fresh()
        if served is not None:
            return served
        served = self._served
        if not self._turn.acquire(blocking=served is None):
            return served or self.current()
        try:
            return self._look()
        finally:
            self._turn.release()

    def fresh(self) -> Served | None:
        """Answer the FOON where it was looked at in the last ``every`` seconds, and never wait for anybody."""
        served = self._served
        return served if served is not None and time.monotonic() - self._looked < self._every else None

    def close(self) -> None:
        """Give the sockets back."""
        if self._graph is not None:
            self._graph.close()
            self._graph = None

    def _look(self) -> Served:
        if (fresh := self.fresh()) is not None:
            return fresh  # another thread looked while this one waited for its turn
        served = self._served
        name = self._edition()
        if served is None or name is None or name != self._name:
            served = Served(0 if served is None else served.edition + 1, self._connected().snapshot())
        self._served, self._name, self._looked = served, name, time.monotonic()
        return served

    def _edition(self) -> str | None:
        try:
            return self._read_edition()
        except GraphError as error:
            if error.code != "unreachable" or self._served is None:
                raise
            self.close()
            return self._read_edition()

    def _read_edition(self) -> str | None:
        with self._connected().reading() as view:
            return view.edition

    def _connected(self) -> Neo4jGraph:
        if self._graph is None:
            self._graph = self._opened()
        return self._graph
