"""One deadline for all that a question asks of a server, and an answer in time though a server heeds none.

A question is planned, run, and maybe run again: each of these gets what is left of the time, so that a server has ended
the last of them when who asked is told that there is no answer.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Self, TypeVar

from foon_kg.model.errors import GraphError

GRACE = 2.0
"""Seconds after its time limit in which a server may say itself that it ended a question."""

_HINT = "Ask for less, or allow more with --timeout."
_STUBBORN = (  # as foon_kg.store.server.idle does
    " The server does not let go of this question. foon-kg's own is started again for it within two minutes, once "
    "nobody else is at work; “foon server stop” ends it at once."
)
_MAY_BE_CHANGED = " What it was to change may be changed all the same: look before you ask again."

Found = TypeVar("Found")


@dataclass(frozen=True)
class Deadline:
    """When the ``seconds`` that a question may take are over, on the clock of ``time.monotonic``."""

    seconds: float
    over_at: float

    @classmethod
    def after(cls, seconds: float) -> Self:
        """Return the deadline that is so many ``seconds`` away."""
        return cls(seconds, time.monotonic() + seconds)

    @property
    def is_over(self) -> bool:
        """Whether no time is left."""
        return time.monotonic() >= self.over_at

    def left(self) -> float:
        """Return how many seconds are left, never 0: that is no limit to a server. Raises :meth:`late` where none are.

        >>> 0 < Deadline.after(30).left() <= 30
        True
        >>> Deadline.after(0).left()
        Traceback (most recent call last):
        foon_kg.model.errors.GraphError: no answer within 0 seconds
        """
        seconds = self.over_at - time.monotonic()
        if seconds <= 0:
            raise self.late()
        return seconds

    def late(self, *, more: str = "") -> GraphError:
        """Return the error of a question whose time is over (code ``timeout``); ``more`` ends its hint."""
        return GraphError(f"no answer within {self.seconds:g} seconds", hint=_HINT + more, code="timeout")

    def within(self, ask: Callable[[], Found], *, writing: bool) -> Found:
        """Return what ``ask`` returns, or raise what it raises; GraphError (``timeout``) ``GRACE`` after this deadline.

        A server can be at an expression that it does not interrupt. Then the thread that waits for it is left behind;
        it ends with its connection. Where ``ask`` is ``writing``, the error says what may come of that.

        >>> Deadline.after(30).within(lambda: 7, writing=False)
        7
        """
        found: list[Found] = []
        raised: list[BaseException] = []

        def work() -> None:
            try:
                found.append(ask())
            except BaseException as error:  # noqa: BLE001 - whatever it is, it is raised where somebody waits
                raised.append(error)

        thread = threading.Thread(target=work, name="free Cypher", daemon=True)
        thread.start()
        thread.join(max(0.0, self.over_at + GRACE - time.monotonic()))
        if raised:
            raise raised[0]
        if not found:
            raise self.late(more=(_MAY_BE_CHANGED if writing else "") + _STUBBORN)
        return found[0]
