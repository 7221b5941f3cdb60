"""Regular expressions in a question: known before it is asked, and such that no text takes hours to be matched.

Neo4j hands them to Java, which goes back and tries again, and which nobody interrupts at it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from foon_kg.model.errors import GraphError
from foon_kg.store.graph.question_words import Token, too_much

MOST_OPEN = 3
"""How often a pattern may say “as many as there are” (``*``, ``+``, ``{…}``): each is a factor of a text's length."""

MOST_CHOICES = 10
"""How often it may say “or nothing” (``?``)."""

HINT = "Use CONTAINS or STARTS WITH, or a plainer pattern: “.*(onion|leek).*”."

_PIECE = re.compile(
    r"(?P<fine>\\[dDwWsSbBnrt]|\\[^0-9A-Za-z]|\(\?[a-z]*[:)]?)|(?P<hidden>\\)|(?P<group>\)[*+{])"
    r"|(?P<open>[*+{][?+]?)|(?P<choice>\?)|.",
    re.DOTALL,
)
_AFTER = {")", "]", "}", ",", "|", ";"}
_ESCAPED = {"n": "\n", "r": "\r", "t": "\t", "b": "\b", "f": "\f"}


def refuse_hard_patterns(tokens: Sequence[Token], parameters: Mapping[str, Any]) -> None:
    """Raise GraphError where a pattern is not written down or given as a parameter, or could be at it for hours."""
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


def _judge(pattern: str) -> None:
    kinds = [found.lastgroup for found in _PIECE.finditer(pattern)]
    if "hidden" in kinds or "group" in kinds:
        raise too_much("a pattern repeats a group, or has a sign that is not known here", hint=HINT)
    if kinds.count("open") > MOST_OPEN or kinds.count("choice") > MOST_CHOICES:
        raise too_much(f"a pattern repeats more than {MOST_OPEN} parts", hint=HINT)
