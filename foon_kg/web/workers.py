"""Who plans: some processes (or one thread), each with the FOON in its own memory, and not more work than they can do.

A process that answers nothing within its time, or that somebody ended, is replaced: the others go on meanwhile.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from queue import SimpleQueue
from typing import Protocol

from foon_kg.web.foon import Served
from foon_kg.web.planning import PlanningDesk
from foon_kg.web.planning_process import PlanningProcess
from foon_kg.web.questions import BusyError, Question, Reply


class Desk(Protocol):
    """What answers questions, one after the other."""

    def answer(self, question: Question) -> Reply:
        """Return the reply to ``question``."""
        ...

    def close(self) -> None:
        """Give back what is held; a question that is under way is given up."""
        ...


class Workers:
    """Answers questions from one FOON; refuses more than ``most`` that are under way or waiting.

    A process that takes more than ``seconds`` for one question is ended, and another takes its place. A thread
    (``processes`` 0) cannot be ended: it is for who asks one question at a time and can wait.
    """

    def __init__(self, served: Served, processes: int, most: int, seconds: float) -> None:
        self._desks: list[Desk] = [PlanningProcess(served, seconds) for _ in range(processes)]
        self._desks = self._desks or [PlanningDesk(served)]
        self._free: SimpleQueue[Desk] = SimpleQueue()
        for desk in self._desks:
            self._free.put(desk)
        self._threads = ThreadPoolExecutor(len(self._desks), "foon-planning")  # a desk is free for each that is
        self._places = threading.BoundedSemaphore(most)

    def submit(self, question: Question) -> Future[Reply]:
        """Take ``question``; raises BusyError where there is no place left, RuntimeError where these were closed."""
        if not self._places.acquire(blocking=False):
            raise BusyError("too many plans are asked at once", hint="Ask again in a second.")
        try:
            future = self._threads.submit(self._answer, question)
        except RuntimeError:
            self._places.release()
            raise
        future.add_done_callback(lambda _: self._places.release())  # a place is held until the work is done
        return future

    def close(self, *, at_once: bool = False) -> None:
        """End when what was taken is done; ``at_once``: now, whatever is under way."""
        if at_once:
            for desk in self._desks:
                desk.close()
        else:
            for _ in self._desks:
                self._threads.submit(self._close_one)  # after all that was taken
        self._threads.shutdown(wait=at_once, cancel_futures=at_once)

    def _answer(self, question: Question) -> Reply:
        with self._desk() as desk:
            return desk.answer(question)

    @contextmanager
    def _desk(self) -> Iterator[Desk]:
        desk = self._free.get()
        try:
            yield desk
        finally:
            self._free.put(desk)

    def _close_one(self) -> None:
        self._free.get().close()
