"""Whether a question in Cypher only looks at the graph: read word by word, before any server sees it.

A server tells the plan of a question, but not what stands inside its expressions: a ``COLLECT { … }`` in a list is text
there. So the words themselves are read, wherever they stand, and what this reader does not know is refused: clauses
that reach outside the graph, procedures and functions that are in no list here, and ways to write a word such that it
is not seen. A server gets the question without its comments and with plain spaces, so that it reads the same words.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from foon_kg.model.errors import WriteRefused
from foon_kg.store.graph.joins import refuse_dense_patterns
from foon_kg.store.graph.patterns import refuse_hard_patterns
from foon_kg.store.graph.preface import first_of_question, shows_schema
from foon_kg.store.graph.question_words import CLOSED, Token, asked, read_pieces, too_much

LONGEST_RANGE = 1_000_000
"""How many numbers a ``range`` may give: what an expression does with them no server bounds."""

PROCEDURES = frozenset(
    {
        "db.index.fulltext.queryNodes",
        "db.index.fulltext.queryRelationships",
        "db.index.vector.queryNodes",
        "db.index.vector.queryRelationships",
        "db.labels",
        "db.propertyKeys",
        "db.relationshipTypes",
        "db.schema.nodeTypeProperties",
        "db.schema.relTypeProperties",
        "db.schema.visualization",
    }
)
"""The procedures that a question may call: they look at nothing but the graph."""

SPACES = frozenset({"date", "datetime", "duration", "localdatetime", "localtime", "point", "time"})
"""The namespaces whose functions a question may call: they only reckon."""

FUNCTIONS = frozenset({"db.namefromelementid", "vector.similarity.cosine", "vector.similarity.euclidean"})

ADD_WRITE = "A question only looks at the graph. If you mean to change it, add --write."

_AFTER_A_NAME = {
    "", "and", "as", "asc", "ascending", "contains", "desc", "descending", "else", "end", "ends", "in", "is", "limit",
    "match", "optional", "or", "order", "return", "skip", "starts", "then", "union", "unwind", "when", "where", "with",
    "xor", "yield",
}  # fmt: skip
"""What may follow a name that is also the first word of a command."""

_LISTED = frozenset(name.lower() for name in PROCEDURES)


def only_looking(text: str, parameters: Mapping[str, Any] | None = None) -> tuple[Token, ...]:
    """Return the pieces of a question as a server may get them: spaces in place of comments, each word where it was.

    ``text`` is asked with ``parameters``. Raises :class:`~foon_kg.model.errors.WriteRefused` where a question does more
    than look at the graph, or may do so, and :class:`~foon_kg.model.errors.GraphError` for a text that is too long or
    nested too deep to be asked.

    >>> "".join(piece.text for piece in only_looking("MATCH (n) /* all */ RETURN n"))
    'MATCH (n)           RETURN n'
    >>> only_looking("LOAD CSV FROM $address AS line RETURN line")
    Traceback (most recent call last):
    foon_kg.model.errors.WriteRefused: this does more than look at the graph: LOAD CSV reads files and addresses
    """
    pieces = read_pieces(text)
    tokens = asked(pieces)
    refuse_the_endless(tokens, parameters)
    schema = first_of_question(tokens) if shows_schema(tokens) else None
    for number, token in enumerate(tokens):
        rest = tokens[number + 1 :]
        if _is_of_what_is_before(tokens, number) or number == schema:
            continue
        if not (number and tokens[number - 1].text == ":"):  # no clause begins in a label
            _refuse_clause(token, rest)
            _refuse_procedure(token, rest)
        _refuse_function(token, rest)
        _refuse_range(token, rest)
    return tuple(replace(piece, text=_plain(piece.text)) if piece.kind == "space" else piece for piece in pieces)


def refuse_the_endless(tokens: Sequence[Token], parameters: Mapping[str, Any] | None) -> None:
    """Raise GraphError where ``tokens``, asked with ``parameters``, could keep a server at it for hours.

    Nobody can interrupt that, whoever asks it.
    """
    refuse_hard_patterns(tokens, parameters or {})
    refuse_dense_patterns(tokens)


def _plain(space: str) -> str:
    return re.sub(r"[^\n]", " ", space)


def _is_of_what_is_before(tokens: Sequence[Token], number: int) -> bool:
    """Whether a name is a property, or a part of a name that was looked at."""
    if number < 2 or tokens[number - 1].text != ".":  # noqa: PLR2004 - something, and a dot
        return False
    owner = tokens[number - 2]
    return owner.kind in {"word", "quoted", "string"} or owner.text in CLOSED


def _refuse_clause(token: Token, rest: Sequence[Token]) -> None:
    following = rest[0].name.lower() if rest else ""
    if token.lower == "load" and following == "csv":
        raise _refused("LOAD CSV reads files and addresses")
    if token.lower in {"transaction", "transactions"}:
        raise _refused(f"{token.text.upper()} is none of a question's matters")
    if token.lower in {"show", "terminate"} and following not in _AFTER_A_NAME:
        raise _refused(f"{token.text.upper()} {following.upper()} is about the server")
    if token.lower == "use" and _names_a_database(rest):
        raise _refused("USE asks another database")


def _names_a_database(rest: Sequence[Token]) -> bool:
    """Whether what follows USE is a name or a call: else "use" is a name itself."""
    if not rest:
        return False
    return rest[0].text == "(" or (bool(rest[0].name) and rest[0].name.lower() not in _AFTER_A_NAME)


def _refuse_procedure(token: Token, rest: Sequence[Token]) -> None:
    if token.lower == "call" and rest and rest[0].name:
        name = _dotted(rest)
        if name.lower() not in _LISTED:
            raise _refused(f"the procedure {name} is none that looks at the graph")


def _refuse_function(token: Token, rest: Sequence[Token]) -> None:
    """Refuse a function of a namespace that is in no list: it may do anything; those without one only reckon."""
    if not token.name:
        return
    name = _dotted((token, *rest))
    length = 2 * (len(_parts((token, *rest))) - 1)
    if len(rest) <= length or rest[length].text != "(":
        return
    hidden = token.kind == "quoted" and length == 0
    strange = length > 0 and token.name.lower() not in SPACES and name.lower() not in FUNCTIONS | _LISTED
    if hidden or strange:
        raise _refused(f"the function {name} may do anything")


def _refuse_range(token: Token, rest: Sequence[Token]) -> None:
    """Refuse a range of numbers that is written down and longer than anybody looks at."""
    if token.lower != "range" or not rest or rest[0].text != "(":
        return
    numbers = [one for one in rest[1:8] if one.kind == "number"]
    most = max((_value(one.text) for one in numbers), default=0)
    if most > LONGEST_RANGE:
        raise too_much(f"a range goes to {most}, and {LONGEST_RANGE} is the most")


def _value(number: str) -> int:
    try:
        return int(number.replace("_", ""), 0)
    except ValueError:
        return 0


def _dotted(tokens: Sequence[Token]) -> str:
    return ".".join(_parts(tokens))


def _parts(tokens: Sequence[Token]) -> list[str]:
    """Return the names that begin a text and are joined by dots."""
    names = [tokens[0].name]
    for dot, name in zip(tokens[1::2], tokens[2::2], strict=False):
        if dot.text != "." or not name.name:
            break
        names.append(name.name)
    return names


def _refused(why: str) -> WriteRefused:
    return WriteRefused(f"this does more than look at the graph: {why}", hint=ADD_WRITE)
