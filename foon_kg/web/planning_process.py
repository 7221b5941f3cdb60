"""A planning desk in a process of its own, which can be ended: when it takes too long, or when nobody needs it."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from multiprocessing.connection import Connection
from typing import Any

from foon_kg.model.copies import copies
from foon_kg.planning.processes import collect_seldom, end_with_parent, keep_for_good
from foon_kg.web.foon import Served
from foon_kg.web.planning import PlanningDesk
from foon_kg.web.questions import BusyError, InternalError, Question, Reply, TooLongError

BEGINNING = 120.0
"""Seconds within which a process has to be ready: a FOON of 200,000 units takes it twenty."""

_ENDING = 5.0
"""Seconds for which the exit code of a process is waited for whose pipe has ended."""

_READY = "foon_kg.web.warm"
"""What makes ready all that no FOON changes."""

_IDLE = 0.5
"""Seconds without a question after which a process practises: a dish takes it some 20 ms, which a question may wait."""


class PlanningProcess:
    """Answers one question at a time, each within ``seconds``; whatever becomes of its process, there is another."""

    def __init__(self, served: Served, seconds: float) -> None:
        self._served = served
        self._seconds = seconds
        self._ready = False
        self._closed = False
        self._turn = threading.Lock()
        self._begin()

    def answer(self, question: Question) -> Reply:
        """Return the reply to ``question``.

        Raises TooLongError where that takes more than ``seconds``, BusyError where the process was ended from outside
        (perhaps for want of memory), InternalError where planning failed; then another process is there already.
        """
        if not self._process.is_alive():
            self._replace()  # it was ended while nobody asked
        try:
            return self._asked(question)
        except TimeoutError as error:
            self._replace()
            raise TooLongError(self._seconds) from error
        except (EOFError, ConnectionError) as error:
            self._process.join(_ENDING)
            failed = (self._process.exitcode or 0) > 0  # a signal has a negative code
            self._replace()
            if failed:
                raise InternalError from error
            raise BusyError("a process that was planning was ended", hint="Ask again.") from error

    def close(self) -> None:
        """End the process; a question that is under way raises BusyError."""
        with self._turn:
            self._closed = True
            self._end()

    def _asked(self, question: Question) -> Reply:
        if not self._ready:
            self._told_within(BEGINNING)
            self._ready = True
        self._line.send(question)
        reply: Reply = self._told_within(self._seconds)
        return reply

    def _told_within(self, seconds: float) -> Any:  # noqa: ANN401 - what comes out of a pipe
        if not self._line.poll(seconds):
            raise TimeoutError
        return self._line.recv()

    def _replace(self) -> None:
        with self._turn:
            self._end()
            if not self._closed:
                self._begin()

    def _begin(self) -> None:
        context = copies(_READY)
        self._line, theirs = context.Pipe()
        self._process = context.Process(target=_plan, args=(theirs, self._served), name="foon-planning", daemon=True)
        self._ready = False
        self._process.start()
        theirs.close()

    def _end(self) -> None:
        self._process.kill()
        self._process.join()


def _plan(line: Connection[Any, Any], served: Served) -> None:
    """Answer the questions that come through ``line`` for as long as somebody has its other end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that serves hears it, and ends this one
    threading.Thread(target=end_with_parent, daemon=True).start()
    collect_seldom()
    desk = PlanningDesk(served)
    desk.get_ready()
    keep_for_good()
    line.send(None)  # it is ready
    practice = desk.practise()
    while True:
        if not line.poll(_IDLE):
            _until_asked(line, practice)
        try:
            question = line.recv()
        except EOFError:
            return
        line.send(desk.answer(question))


def _until_asked(line: Connection[Any, Any], practice: Iterator[object]) -> None:
    """Go on with ``practice`` as long as nothing comes through ``line``."""
    for _ in practice:
        if line.poll():
            return
