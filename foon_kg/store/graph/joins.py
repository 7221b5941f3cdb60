"""How much of a question's patterns a planner has to join: bounded, before any server plans it.

A planner looks for an order in which to join the relationships of a pattern, and now and then lets nobody interrupt it.
What it costs was measured (``EXPLAIN``, Neo4j 2026.09): 0.2 s of processor for a star of 8 relationships, 5 s for one
of 40, 4 s where 8 nodes are all joined with each other, 24 s of 12, more than a minute and a half of 14.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from foon_kg.store.graph.question_words import Token, partners, too_much

MOST_RELATIONSHIPS = 40
"""Of all patterns of a question together; each word for a path of any length is one."""

MOST_RINGS = 20
"""How many of them may join nodes that are joined already, by whatever way."""

IN_PARTS = "Ask for a part of it, and join the rest by WITH in a question of its own."

Join = tuple[str, str]

_RELATIONSHIP = re.compile(r"<?-\[?->?[+*{]?|[+*{]?")
"""What stands between two nodes, brackets as the sign that opens them; how often it may be gone comes last."""

LONGEST_ARROW = 6


def refuse_dense_patterns(tokens: Sequence[Token]) -> None:
    """Raise GraphError where patterns in the ``tokens`` of a question have too many relationships, or rings of them.

    >>> from foon_kg.store.graph.question_words import read
    >>> refuse_dense_patterns(read("MATCH (a)-[:X]->(b)<--(a) RETURN b"))
    >>> refuse_dense_patterns(read("MATCH (a)" + "-->()" * 50 + " RETURN a"))
    Traceback (most recent call last):
    foon_kg.model.errors.GraphError: this question is too much to ask: its patterns have 50 relationships, and 40 are
    the most
    """
    joins = list(_joins(tokens))
    if len(joins) > MOST_RELATIONSHIPS:
        raise too_much(
            f"its patterns have {len(joins)} relationships, and {MOST_RELATIONSHIPS} are the most", hint=IN_PARTS
        )
    if (rings := _rings(joins)) > MOST_RINGS:
        raise too_much(
            f"{rings} relationships of its patterns join what is joined already, and {MOST_RINGS} are the most",
            hint=IN_PARTS,
        )


def _rings(joins: Sequence[Join]) -> int:
    """Return how many joins are between nodes that others join already."""
    above: dict[str, str] = {}

    def top(node: str) -> str:
        while node in above:
            node = above[node]
        return node

    rings = 0
    for one, other in joins:
        if (first := top(one)) == (second := top(other)):
            rings += 1
        else:
            above[first] = second
    return rings


def _joins(tokens: Sequence[Token]) -> Iterator[Join]:
    """Yield the two nodes of each relationship; one without a name, or of another part of a ``UNION``, is its own."""
    closed_at = partners(tokens)
    opened_at = {closed: opened for opened, closed in closed_at.items()}
    part = 0
    for place, token in enumerate(tokens):
        part += token.lower == "union"
        if token.text == ")" and place in opened_at:
            following = _next_node(tokens, place + 1, closed_at)
            if following is not None:
                yield _node(tokens, opened_at[place], part), _node(tokens, following, part)


def _node(tokens: Sequence[Token], opened: int, part: int) -> str:
    """Return what tells the node whose bracket opens there from others."""
    name = tokens[opened + 1].name
    return f"{part} {name}" if name else f"at {opened}"


def _next_node(tokens: Sequence[Token], place: int, closed_at: Mapping[int, int]) -> int | None:
    """Return where the bracket of the node opens to which a relationship leads that begins at ``place``; if one does.

    What could be one is taken for one: what is bounded is counted rather too high than too low.
    """
    between = ""
    while place < len(tokens) and len(between) <= LONGEST_ARROW:
        text = tokens[place].text
        if text == "(":
            return place if place in closed_at and _RELATIONSHIP.fullmatch(between) else None
        if text in {"[", "{"}:
            place = closed_at.get(place, len(tokens))
        between += text
        place += 1
    return None
