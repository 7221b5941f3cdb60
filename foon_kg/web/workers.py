"""Who plans: some processes (or one thread), each with the FOON in its own memory, and not more work than they can do.

What a process was given to answer with lives in a thread-local: one executor of each kind may live beside another.
"""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context, parent_process
from multiprocessing.connection import wait

from foon_kg.errors import FoonError
from foon_kg.snapshot import Snapshot
from foon_kg.web.planning import PlanningDesk
from foon_kg.web.questions import Question, Reply


class BusyError(FoonError):
    """More is asked at once than can be answered soon."""

    code = "busy"


class Workers:
    """Answers questions from one FOON; refuses more than ``most`` that are under way or waiting."""

    def __init__(self, snapshot: Snapshot, processes: int, most: int) -> None:
        self._executor = _executor(snapshot, processes)
        self._places = threading.BoundedSemaphore(most)
        for _ in range(max(processes, 1)):
            self._executor.submit(_ready)  # begin now, and not when somebody waits

    def submit(self, question: Question) -> Future[Reply]:
        """Take ``question``; raises BusyError where there is no place left, RuntimeError where the processes ended."""
        if not self._places.acquire(blocking=False):
            raise BusyError("too many plans are asked at once", hint="Ask again in a second.")
        try:
            future = self._executor.submit(_answer, question)
        except RuntimeError:
            self._places.release()
            raise
        future.add_done_callback(lambda _: self._places.release())  # a place is held until the work is done
        return future

    def close(self, *, at_once: bool = False) -> None:
        """End when what was taken is done; ``at_once``: only what is under way."""
        self._executor.shutdown(wait=at_once, cancel_futures=at_once)


def _executor(snapshot: Snapshot, processes: int) -> Executor:
    if not processes:
        return ThreadPoolExecutor(1, "foon-planning", initializer=_begin, initargs=(snapshot,))
    begin: Callable[[Snapshot], None] = _begin_process
    return ProcessPoolExecutor(processes, get_context("spawn"), initializer=begin, initargs=(snapshot,))


_own = threading.local()


def _begin(snapshot: Snapshot) -> None:
    _own.desk = PlanningDesk(snapshot)


def _begin_process(snapshot: Snapshot) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that serves hears it, and ends this one
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _begin(snapshot)


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)


def _ready() -> None:
    """Do nothing: a process that is asked has begun."""


def _answer(question: Question) -> Reply:
    desk: PlanningDesk = _own.desk
    return desk.answer(question)
