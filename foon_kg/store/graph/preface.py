"""What stands before a question in Cypher (``CYPHER 25``, ``EXPLAIN``, ``PROFILE``), and questions about the schema."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.store.graph.question_words import Token, read_pieces

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


def unplanned(text: str) -> tuple[str, str]:
    """Return ``text`` with spaces in place of ``EXPLAIN`` and ``PROFILE`` before it, and that word in lower case."""
    pieces = read_pieces(text)
    places = [place for place, piece in enumerate(pieces) if piece.kind != "space"]
    found = [places[one] for one in modes([pieces[place] for place in places])]
    mode = pieces[found[0]].lower if found else ""
    return "".join(" " * len(one.text) if place in found else one.text for place, one in enumerate(pieces)), mode


def modes(tokens: Sequence[Token]) -> list[int]:
    """Return the places of ``EXPLAIN`` and ``PROFILE`` in ``tokens``, before the question itself."""
    return [place for place in range(begin(tokens)) if tokens[place].lower in MODES]


def begin(tokens: Sequence[Token]) -> int:
    """Return the place in ``tokens`` of the first word of the question itself."""
    place = 0
    while place < len(tokens):
        if tokens[place].lower in MODES:
            place += 1
        elif tokens[place].lower == "cypher":
            place = _after_options(tokens, place + 1)
        else:
            break
    return place


def _after_options(tokens: Sequence[Token], place: int) -> int:
    """Return the place after a version, and after settings such as ``runtime=slotted``."""
    if place < len(tokens) and tokens[place].kind == "number":
        place += 1
    while place + 2 < len(tokens) and tokens[place].kind == "word" and tokens[place + 1].text == "=":
        place += 3
    return place


def shows_schema(tokens: Sequence[Token]) -> bool:
    """Return whether the first clause of ``tokens`` shows indexes or constraints, which say nothing of the server."""
    first = begin(tokens)
    if first >= len(tokens) or tokens[first].lower != "show":
        return False
    for token in tokens[first + 1 : first + 2 + _MOST_KINDS]:
        if token.lower in _SCHEMA:
            return True
        if token.lower not in _KINDS:
            return False
    return False
