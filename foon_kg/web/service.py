"""The service that the page, the API and the agents share: every question, from the FOON as it stands now."""

from __future__ import annotations

import threading
from collections import OrderedDict
from concurrent.futures import CancelledError, Future
from dataclasses import dataclass
from typing import Protocol

from foon_kg.model.json_fields import JsonObject
from foon_kg.web.explore.explorer import Explorer
from foon_kg.web.foon import Served
from foon_kg.web.questions import BusyError, Question, Reply, TooLongError
from foon_kg.web.words import FoonWords, Kind
from foon_kg.web.workers import Workers

SECONDS = 20.0
"""How long anybody waits for an answer."""

MOST_KEPT = 512
"""How many answers are kept for who asks the same again."""


class Foon(Protocol):
    """Where the FOON comes from."""

    def current(self) -> Served:
        """Answer the FOON as it stands now."""
        ...

    def close(self) -> None:
        """Give back what is held open."""
        ...


@dataclass(frozen=True)
class _Edition:
    """One edition of the FOON with all that answers from it."""

    number: int
    words: FoonWords
    explorer: Explorer
    workers: Workers


class FoonService:
    """Answers plans, suggestions, completions, likenesses and looks around objects. Any number of threads may ask.

    Plans are made by ``processes`` processes (0: by one thread of this one); more than ``most`` at once are refused
    with BusyError, and a process that plans for longer than ``seconds`` is replaced. Equal questions to one edition of
    the FOON are answered once. Close it, or use it in ``with``.
    """

    def __init__(self, foon: Foon, *, processes: int = 0, most: int = 16, seconds: float = SECONDS) -> None:
        self._foon = foon
        self._processes = processes
        self._most = most
        self._seconds = seconds
        self._turn = threading.Lock()
        self._edition: _Edition | None = None
        self._kept: OrderedDict[Question, Future[Reply]] = OrderedDict()

    def ask(self, question: Question) -> Future[Reply]:
        """Take a question that takes a while; raises BusyError, or GraphError where there is no FOON."""
        try:
            return self._taken(self._current(), question)
        except RuntimeError:  # another edition took its place meanwhile
            return self._taken(self._current(), question)

    def answer(self, question: Question) -> Reply:
        """Answer a question that takes a while; raises TooLongError, BusyError or GraphError where there is none."""
        try:
            return self.ask(question).result(self._seconds)
        except TimeoutError as error:
            raise TooLongError(self._seconds) from error
        except CancelledError as error:
            raise BusyError("the service is ending", hint="Ask again when it is there again.") from error

    def summary(self) -> JsonObject:
        """Answer how large the FOON is, and its dish types."""
        return self._current().words.summary()

    def complete(self, kind: Kind, text: str, limit: int) -> list[str]:
        """Answer what ``text`` may become."""
        return self._current().words.complete(kind, text, limit)

    def similar(self, names: list[str], limit: int) -> list[JsonObject]:
        """Answer for each name the known foods that can stand for it."""
        return self._current().words.similar(names, limit)

    def around(self, label: str) -> JsonObject:
        """Answer what the FOON has around an object; raises UnknownError."""
        return self._current().words.around(label)

    def explorer(self) -> Explorer:
        """Answer what the FOON answers to who wanders through it."""
        return self._current().explorer

    def close(self) -> None:
        """End the processes, and give the sockets back."""
        with self._turn:
            if self._edition is not None:
                self._edition.workers.close(at_once=True)
                self._edition = None
        self._foon.close()

    def __enter__(self) -> FoonService:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _current(self) -> _Edition:
        served = self._foon.current()
        with self._turn:
            if self._edition is None or self._edition.number < served.edition:
                self._edition = self._replaced(served)
            return self._edition

    def _replaced(self, served: Served) -> _Edition:
        if self._edition is not None:
            self._edition.workers.close()
        self._kept.clear()
        workers = Workers(served.snapshot, self._processes, self._most, self._seconds)
        return _Edition(served.edition, FoonWords(served.snapshot), Explorer(served.snapshot), workers)

    def _taken(self, edition: _Edition, question: Question) -> Future[Reply]:
        with self._turn:
            kept = self._kept.get(question)
            if kept is not None and not _failed(kept):
                self._kept.move_to_end(question)
                return kept
            self._kept[question] = future = edition.workers.submit(question)
            while len(self._kept) > MOST_KEPT:
                self._kept.popitem(last=False)
            return future


def _failed(future: Future[Reply]) -> bool:
    return future.done() and (future.cancelled() or future.exception() is not None)
