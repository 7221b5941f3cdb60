"""What stands before a question in Cypher (``CYPHER 25``, ``EXPLAIN``, ``PROFILE``), and questions about the schema."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

MODES = frozenset({"explain", "profile"})
"""Words before a question that ask for its plan."""

_SCHEMA = frozenset({"constraint", "constraints", "index", "indexes"})
_KINDS = frozenset(
    {
        "all", "exist", "existence", "fulltext", "key", "lookup", "node", "point", "property", "range", "rel",
        "relationship", "text", "type", "unique", "uniqueness", "vector",
    }
)  # fmt: skip
_MOST_KINDS = 4


class Piece(Protocol):
    """A piece of a question, as :mod:`foon_kg.store.graph.looking` reads it."""

    @property
    def kind(self) -> str:
        """What it is: a ``word``, a ``space``, or another."""

    @property
    def text(self) -> str:
        """Its characters."""

    @property
    def lower(self) -> str:
        """A word in lower case; of anything else what no keyword is."""


def modes(tokens: Sequence[Piece]) -> list[int]:
    """Return the places of ``EXPLAIN`` and ``PROFILE`` before the question itself."""
    return [place for place in range(begin(tokens)) if tokens[place].lower in MODES]


def begin(tokens: Sequence[Piece]) -> int:
    """Return the place of the first word of the question itself."""
    place = 0
    while place < len(tokens):
        if tokens[place].lower in MODES:
            place += 1
        elif tokens[place].lower == "cypher":
            place = _after_options(tokens, place + 1)
        else:
            break
    return place


def _after_options(tokens: Sequence[Piece], place: int) -> int:
    """Return the place after a version, and after settings such as ``runtime=slotted``."""
    if place < len(tokens) and tokens[place].kind == "number":
        place += 1
    while place + 2 < len(tokens) and tokens[place].kind == "word" and tokens[place + 1].text == "=":
        place += 3
    return place


def shows_schema(tokens: Sequence[Piece]) -> bool:
    """Whether the first clause of a question shows indexes or constraints, which say nothing of the server."""
    first = begin(tokens)
    if first >= len(tokens) or tokens[first].lower != "show":
        return False
    for token in tokens[first + 1 : first + 2 + _MOST_KINDS]:
        if token.lower in _SCHEMA:
            return True
        if token.lower not in _KINDS:
            return False
    return False
