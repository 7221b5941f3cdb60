"""What the first words of a question say: what stands before it (``CYPHER 25``, ``EXPLAIN``), and SHOW of a schema."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.store.graph.question_words import Token

PLAN_WORDS = frozenset({"explain", "profile"})
"""Words before a question that ask for its plan: EXPLAIN runs nothing, PROFILE runs the question."""

# The words of Neo4j 2026.09, and of versions before it; where a newer one has more, what shows it is refused.
_SCHEMA = frozenset({"constraint", "constraints", "index", "indexes"})
_KINDS = frozenset(
    {
        "all", "exist", "existence", "fulltext", "key", "lookup", "node", "point", "property", "range", "rel",
        "relationship", "text", "type", "unique", "uniqueness", "vector",
    }
)  # fmt: skip
_MOST_KINDS = 4
"""So many words at most stand between SHOW and what it shows (SHOW ALL RELATIONSHIP PROPERTY EXISTENCE CONSTRAINTS)."""


def without_plan_word(pieces: Sequence[Token]) -> tuple[str, str]:
    """Return the text of a question without ``EXPLAIN`` and ``PROFILE`` before it, and that word in lower case.

    ``pieces`` are all its pieces. Spaces take the place of these words, so that all else is where it was. Of two of
    them the first is returned, ``""`` where there is none.

    >>> from foon_kg.store.graph.question_words import read_pieces
    >>> without_plan_word(read_pieces("CYPHER 25 EXPLAIN RETURN 1"))
    ('CYPHER 25         RETURN 1', 'explain')
    """
    places = [place for place, piece in enumerate(pieces) if piece.kind != "space"]
    first = first_of_question([pieces[place] for place in places])
    found = {place for place in places[:first] if pieces[place].lower in PLAN_WORDS}
    blanked = "".join(" " * len(piece.text) if place in found else piece.text for place, piece in enumerate(pieces))
    return blanked, pieces[min(found)].lower if found else ""


def first_of_question(tokens: Sequence[Token]) -> int:
    """Return the place in ``tokens`` of the first word of the question itself; their number where there is none.

    >>> from foon_kg.store.graph.question_words import read
    >>> first_of_question(read("CYPHER 25 runtime=slotted PROFILE RETURN 1"))
    6
    """
    place = 0
    while place < len(tokens):
        if tokens[place].lower in PLAN_WORDS:
            place += 1
        elif tokens[place].lower == "cypher":
            place = _after_options(tokens, place + 1)
        else:
            break
    return place


def _after_options(tokens: Sequence[Token], place: int) -> int:
    """Return the place behind the version (``25``) and the settings (``runtime=slotted``) that begin at ``place``."""
    if place < len(tokens) and tokens[place].kind == "number":
        place += 1
    while place + 2 < len(tokens) and tokens[place].kind == "word" and tokens[place + 1].text == "=":
        place += 3
    return place


def shows_schema(tokens: Sequence[Token]) -> bool:
    """Return whether the first clause of ``tokens`` shows indexes or constraints, which say nothing of the server.

    >>> from foon_kg.store.graph.question_words import read
    >>> shows_schema(read("SHOW VECTOR INDEXES")), shows_schema(read("SHOW USERS"))
    (True, False)
    """
    first = first_of_question(tokens)
    if first >= len(tokens) or tokens[first].lower != "show":
        return False
    for token in tokens[first + 1 : first + 2 + _MOST_KINDS]:
        if token.lower in _SCHEMA:
            return True
        if token.lower not in _KINDS:
            return False
    return False
