"""The service that the page, the API and the agents share: every question, from the FOON as it stands now."""

from __future__ import annotations

import math
import threading
import time
from collections import OrderedDict
from concurrent.futures import CancelledError, Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Protocol

from foon_kg.foon import ConnectionSettings
from foon_kg.model.errors import UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.web.explore.explorer import Explorer
from foon_kg.web.foon import Served
from foon_kg.web.graph_words import GraphWords
from foon_kg.web.questions import BusyError, Question, Reply, TooLongError
from foon_kg.web.words import FoonWords, Kind, Words
from foon_kg.web.workers import Workers

SECONDS = 20.0
"""How long anybody waits for an answer."""

PATIENCE = 2.0
"""How long who first sees a new edition after a pause waits for it; others go on with the one before."""

PAUSE = 5.0
"""So many seconds after the last answer whose edition stood: the next one might be older than anybody expects."""

MOST_KEPT = 512
"""How many answers are kept for who asks the same again."""


class FoonSource(Protocol):
    """Where the FOON comes from."""

    def edition(self) -> str:
        """Return the name of the edition that stands now, which takes no time worth speaking of."""
        ...

    def read(self) -> Served:
        """Return the FOON as it stands now, which may take a while."""
        ...

    def fresh(self) -> str | None:
        """Return the name of the edition that stands now where that is known at once."""
        ...

    def close(self) -> None:
        """Give back what is held open."""
        ...


@dataclass(frozen=True)
class Edition:
    """One edition of the FOON with all that answers from it; ``newer`` is one that is being read meanwhile.

    One that is too large for memory has no ``explorer``; ``server`` is the Neo4j that is asked for its parts.
    """

    name: str
    words: Words
    explorer: Explorer | None
    workers: Workers
    newer: str | None = None
    server: ConnectionSettings | None = None

    def close(self, *, at_once: bool = False) -> None:
        """End what answers from it, once it has answered or ``at_once``."""
        self.workers.close(at_once=at_once)
        self.words.foon.close()


class FoonService:
    """Answers plans, suggestions, completions, likenesses and looks around objects. Any number of threads may ask.

    Plans are made by ``processes`` processes (0: by one thread of this one); more than ``most`` at once are refused
    with BusyError, and a process that plans for longer than ``seconds`` is replaced. Equal questions to one edition of
    the FOON are answered once. While a new edition is read the one before answers; only who first sees it after a
    ``pause``, in which nobody saw that the one before still stands, waits up to ``patience`` seconds for it. Close it,
    or use it in ``with``.
    """

    def __init__(
        self,
        foon: FoonSource,
        *,
        processes: int = 0,
        most: int = 16,
        seconds: float = SECONDS,
        patience: float = PATIENCE,
        pause: float = PAUSE,
    ) -> None:
        self._foon = foon
        self._processes = processes
        self._most = most
        self._seconds = seconds
        self._patience = patience
        self._pause = pause
        self._stood = -math.inf
        self._turn = threading.Lock()
        self._edition: Edition | None = None
        self._reader = ThreadPoolExecutor(1, "foon-reading")
        self.reading: Future[Edition] | None = None
        self._kept: OrderedDict[Question, Future[Reply]] = OrderedDict()
        self._words: OrderedDict[bytes, Question] = OrderedDict()

    def remember_words(self, words: bytes, question: Question) -> None:
        """Remember in which ``words`` a question was asked: whoever says them again need not be understood again."""
        with self._turn:
            self._words[words] = question
            while len(self._words) > MOST_KEPT:
                self._words.popitem(last=False)

    def kept_answer(self, words: bytes) -> tuple[Edition, Reply] | None:
        """Return the answer to what was said before in the same ``words``; ``None`` where it is not there at once."""
        name = self._foon.fresh()
        with self._turn:
            question, edition = self._words.get(words), self._edition
            if question is None or edition is None or edition.name != name:
                return None
            kept = self._kept.get(question)
            if kept is None or not kept.done() or _failed(kept):
                return None
            self._kept.move_to_end(question)
            return edition, kept.result()

    def current(self) -> Edition:
        """Return the edition that answers now; raises GraphError where there is none."""
        name = self._foon.edition()
        with self._turn:
            there = self._edition
            now = time.monotonic()
            if there is not None and there.name == name:
                self._stood = now
                return there
            reading, first = self.reading, False
            if reading is None or reading.done():
                reading, first = self._begin_reading(), now - self._stood >= self._pause
        if there is None:
            return reading.result()
        try:
            return reading.result(self._patience if first else 0)
        except TimeoutError:
            return replace(there, newer=name)

    def asked(self, question: Question) -> tuple[Edition, Future[Reply]]:
        """Take a question that takes a while; raises BusyError, or GraphError where there is no FOON."""
        edition = self.current()
        with self._turn:
            if self._edition is not None and self._edition.name != edition.name:
                edition = self._edition  # it took the place of the other meanwhile
            kept = self._kept.get(question)
            if kept is not None and not _failed(kept):
                self._kept.move_to_end(question)
                return edition, kept
            try:
                future = edition.workers.submit(question)
            except RuntimeError as error:
                raise _ending() from error
            self._kept[question] = future
            while len(self._kept) > MOST_KEPT:
                self._kept.popitem(last=False)
            return edition, future

    def standing(self) -> tuple[Edition | None, int]:
        """Return the edition that answers, if any does yet, and how many answers are kept; waits for nobody."""
        with self._turn:
            return self._edition, len(self._kept)

    def ask(self, question: Question) -> Future[Reply]:
        """Take a question that takes a while; raises what :meth:`asked` raises."""
        return self.asked(question)[1]

    def answer(self, question: Question) -> Reply:
        """Return the answer to a ``question`` that takes a while; raises TooLongError, BusyError or GraphError."""
        try:
            return self.ask(question).result(self._seconds)
        except TimeoutError as error:
            raise TooLongError(self._seconds) from error
        except CancelledError as error:
            raise _ending() from error

    def summary(self) -> JsonObject:
        """Return how large the FOON is, and its dish types."""
        return self.current().words.summary()

    def complete(self, kind: Kind, text: str, limit: int) -> list[str]:
        """Return at most ``limit`` words that ``text`` may become, of a ``kind``."""
        return self.current().words.complete(kind, text, limit)

    def similar(self, names: list[str], limit: int, role: str | None = None) -> list[JsonObject]:
        """Return for each of ``names`` at most ``limit`` known foods that can stand for it.

        With ``role``, where it plays that.
        """
        return self.current().words.similar(names, limit, role)

    def around(self, label: str) -> JsonObject:
        """Return what the FOON has around the object ``label``; raises UnknownError."""
        return self.current().words.around(label)

    def explorer(self) -> Explorer:
        """Return what the FOON answers to who wanders through it; raises UsageError where it is too large for that."""
        edition = self.current()
        if edition.explorer is None:
            raise UsageError(
                f"nobody wanders through a FOON of {edition.words.size.units:,} steps: it is too large to be held here",
                hint="Serve some of its videos (foon serve --files), or ask it in Cypher (foon serve --cypher).",
            )
        return edition.explorer

    def close(self) -> None:
        """End the processes, and give the sockets back."""
        self._reader.shutdown(cancel_futures=True)
        with self._turn:
            if self._edition is not None:
                self._edition.close(at_once=True)
                self._edition = None
        self._foon.close()

    def __enter__(self) -> FoonService:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _begin_reading(self) -> Future[Edition]:
        try:
            self.reading = self._reader.submit(self._read)
        except RuntimeError as error:
            raise _ending() from error
        return self.reading

    def _read(self) -> Edition:
        """Read the FOON, begin the processes that plan from it, and have it answer from now on.

        Those that ask a graph for parts of it go on: they ask the new edition.
        """
        served = self._foon.read()
        edition = self._edition_of(served)
        with self._turn:
            if self._edition is not None and self._edition.workers is not edition.workers:
                self._edition.close()
            self._kept.clear()
            self._edition, self._stood = edition, time.monotonic()
        return edition

    def _edition_of(self, served: Served) -> Edition:
        there = self._edition
        if served.snapshot is not None:
            words, explorer = FoonWords(served.snapshot, served.lessons), Explorer(served.snapshot)
            return Edition(served.edition, words, explorer, self._workers(served))
        if there is not None and there.server == served.server:
            return Edition(served.edition, GraphWords(there.words.foon), None, there.workers, server=served.server)
        return Edition(served.edition, GraphWords(served.foon()), None, self._workers(served), server=served.server)

    def _workers(self, served: Served) -> Workers:
        return Workers(served, self._processes, self._most, self._seconds)


def _failed(future: Future[Reply]) -> bool:
    return future.done() and (future.cancelled() or future.exception() is not None)


def _ending() -> BusyError:
    return BusyError("the service is ending", hint="Ask again when it is there again.")
