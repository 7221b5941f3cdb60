"""Questions in Cypher from the page: through the gate of ``foon cypher``, and only where the operator allowed them."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from foon_kg.foon import Foon
from foon_kg.model.errors import GraphError, UsageError, WriteRefused
from foon_kg.web.questions import BusyError, TooLongError, UnknownError

if TYPE_CHECKING:
    from foon_kg.store.graph.free_cypher import Answer

SECONDS = 10.0
"""How long a question may take."""

_MOST_AT_ONCE = 2
"""So many questions of people are under way at a time, each up to SECONDS: plans are asked of the same Neo4j."""
_HINTS = {
    "too-much": "Ask for fewer rows or columns, or for counts.",
    "memory": "Ask for less at once.",
    "cypher": "The named questions show how it is written.",
}
"""What to do about a question that the server refuses, by the code of the error."""


class NoCypherError(UnknownError):
    """This service takes no questions in Cypher."""

    code = "no-cypher"

    def __init__(self) -> None:
        hint = "Its operator can allow them where it serves a Neo4j: foon serve --cypher"
        super().__init__("this service takes no questions in Cypher", hint=hint)


class CypherDesk:
    """Asks a Neo4j what people typed, of which only looks at the graph are let through. Any number of threads may ask.

    ``opened`` connects for each question: the local server ends when it idles.
    """

    def __init__(self, opened: Callable[[], Foon], seconds: float = SECONDS) -> None:
        self._opened = opened
        self._seconds = seconds
        self._places = threading.BoundedSemaphore(_MOST_AT_ONCE)

    def ask(self, text: str, parameters: Mapping[str, Any], limit: int) -> Answer:
        """Return at most ``limit`` rows that ``text`` answers with these ``parameters``.

        Raises WriteRefused for more than a look, UsageError for what is no Cypher or too much, TooLongError, BusyError
        where others ask already, GraphError where no Neo4j answers.
        """
        if not self._places.acquire(blocking=False):
            raise BusyError("others ask in Cypher just now", hint="Ask again in a second.")
        try:
            with self._explained(), self._opened() as foon:
                return foon.cypher(text, parameters, limit=limit, timeout=self._seconds)
        finally:
            self._places.release()

    @contextmanager
    def _explained(self) -> Iterator[None]:
        try:
            yield
        except WriteRefused as error:
            raise WriteRefused(error.message, hint="A question here only looks at the graph.") from error
        except GraphError as error:
            if error.code == "timeout":
                raise TooLongError(self._seconds) from error
            if error.code in _HINTS:
                raise UsageError(error.message, hint=_HINTS[error.code], code=error.code) from error
            raise
