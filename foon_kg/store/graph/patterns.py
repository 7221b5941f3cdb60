"""Regular expressions in a question: known before it is asked, and such that no text takes hours to be matched.

Neo4j hands them to Java, which goes back and tries again, and which nobody interrupts at it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from foon_kg.model.errors import GraphError
from foon_kg.store.graph.question_words import CLOSED, Around, Token, partners, too_much

MOST_OPEN = 3
"""How often a pattern may say “as many as there are” (``*``, ``+``, ``{…}``): each is a factor of a text's length."""

MOST_CHOICES = 10
"""How often it may say “or nothing” (``?``)."""

LONGEST_TEXT = {2: 10_000, 3: 500, 4: 100}
"""How many characters may be held against a pattern that says “as many as there are” twice, and so on (``?`` counts as
one more): some 10⁸ steps at most, which take a second or so."""

TOO_LONG = "a text is too long for its pattern"
"""What the server says of one, in the words of a date that is none."""

HINT = "Use CONTAINS or STARTS WITH, or a plainer pattern: “.*(onion|leek).*”."

_PIECE = re.compile(
    r"(?P<fine>\\[dDwWsSbBnrt]|\\[^0-9A-Za-z]|\(\?[a-z]*[:)]?)|(?P<hidden>\\)|(?P<group>\)[*+{])"
    r"|(?P<open>[*+{][?+]?)|(?P<choice>\?)|.",
    re.DOTALL,
)
_BOUNDED = f"CASE WHEN size(toStringOrNull(text)) > {{most}} THEN date('{TOO_LONG}') ELSE text END"
_WORDS_BEFORE = frozenset(
    {"and", "by", "case", "distinct", "else", "not", "or", "return", "then", "when", "where", "with", "xor"}
)
_SIGNS_BEFORE = frozenset("([{,|:=")
_AFTER = {")", "]", "}", ",", "|", ";"}
_ESCAPED = {"n": "\n", "r": "\r", "t": "\t", "b": "\b", "f": "\f"}


def refuse_hard_patterns(tokens: Sequence[Token], parameters: Mapping[str, Any]) -> None:
    """Raise GraphError where a pattern in ``tokens`` is neither written down nor one of ``parameters``, or too hard.

    Too hard is what a server could be at for hours.
    """
    for place in range(len(tokens) - 1):
        if (tokens[place].text, tokens[place + 1].text) == ("=", "~"):
            _judge(_pattern(tokens[place + 2 :], parameters))


def _pattern(tokens: Sequence[Token], parameters: Mapping[str, Any]) -> str:
    """Return the text after ``=~``: strings and parameters, joined by ``+``."""
    parts: list[str] = []
    for place, token in enumerate(tokens):
        if place % 2 == 0:
            parts.append(_text(token, parameters))
        elif token.text != "+":
            if token.kind in {"word", "quoted"} or token.text in _AFTER:
                break
            raise _unknown()
    return "".join(parts)


def _text(token: Token, parameters: Mapping[str, Any]) -> str:
    if token.kind == "string":
        return re.sub(r"\\(.)", lambda found: _ESCAPED.get(found[1], found[1]), token.text[1:-1], flags=re.DOTALL)
    name = token.text[1:].removeprefix("`").removesuffix("`").replace("``", "`")
    if token.kind == "word" and token.text.startswith("$") and isinstance(parameters.get(name, ""), str):
        return str(parameters.get(name, ""))  # one that is not given is the server's to miss
    raise _unknown()


def _unknown() -> GraphError:
    return too_much(
        "what follows =~ is neither a string nor a parameter", hint="Write the pattern down, or use CONTAINS."
    )


def bounded_texts(pieces: Sequence[Token], parameters: Mapping[str, Any]) -> Iterator[Around]:
    """Yield what is put around each text that is held against a pattern, such that a server refuses one too long.

    ``pieces`` are those of the question, asked with ``parameters``. Raises GraphError where it is not plain what that
    text is.
    """
    places = [place for place, piece in enumerate(pieces) if piece.kind != "space"]
    tokens = [pieces[place] for place in places]
    for at in range(1, len(tokens) - 2):
        if (tokens[at].text, tokens[at + 1].text) == ("=", "~"):
            most = LONGEST_TEXT.get(_degree(_pattern(tokens[at + 2 :], parameters)))
            if most is not None:
                first = places[_begin_of_operand(tokens, at - 1)]
                yield Around(first, "[text IN [", places[at - 1], f"] | {_BOUNDED.format(most=most)}][0]")


def too_long() -> GraphError:
    """Return the error for a text that is longer than what may be held against its pattern."""
    most = ", ".join(f"{most:,} with {degree}" for degree, most in LONGEST_TEXT.items())
    return too_much(f"a text is too long for its pattern (*, + or {{…}}, and ?: at most {most} of them)", hint=HINT)


def _degree(pattern: str) -> int:
    """Return to which power of a text's length a pattern may take."""
    kinds = [found.lastgroup for found in _PIECE.finditer(pattern)]
    return kinds.count("open") + ("choice" in kinds)


def _begin_of_operand(tokens: Sequence[Token], last: int) -> int:
    """Return where the text begins that ends at ``last``: a string, a bracket, a name with its properties, a call."""
    first = _begin_of_term(tokens, last)
    joined = first > 1 and tokens[first - 1].text == tokens[first - 2].text == "|"
    if not first or (_stands_before(tokens[first - 1]) and not joined):
        return first
    raise too_much(
        "it is not plain which text is held against a pattern", hint="Put what stands before =~ into brackets."
    )


def _begin_of_term(tokens: Sequence[Token], last: int) -> int:
    """Return the same, by brackets and dots alone."""
    opened_at = {closed: opened for opened, closed in partners(tokens).items()}
    first = last
    while True:
        if first in opened_at:
            first = opened_at[first]
            if not first or not _is_called_or_indexed(tokens[first - 1], tokens[first]):
                return first
            first -= 1
        elif first > 1 and tokens[first - 1].text == ".":
            first -= 2
        else:
            return first


def _is_called_or_indexed(before: Token, bracket: Token) -> bool:
    if before.name:
        return not _stands_before(before)
    return bracket.text == "[" and before.text in CLOSED


def _stands_before(token: Token) -> bool:
    """Whether an expression can begin after this word or sign, and nothing binds it to what is before."""
    return token.lower in _WORDS_BEFORE or token.text in _SIGNS_BEFORE


def _judge(pattern: str) -> None:
    kinds = [found.lastgroup for found in _PIECE.finditer(pattern)]
    if "hidden" in kinds or "group" in kinds:
        raise too_much("a pattern repeats a group, or has a sign that is not known here", hint=HINT)
    if kinds.count("open") > MOST_OPEN or kinds.count("choice") > MOST_CHOICES:
        raise too_much(f"a pattern repeats more than {MOST_OPEN} parts", hint=HINT)
