"""Regular expressions in a question: known before it is asked, and such that no text takes hours to be matched.

Neo4j hands them to Java, which goes back and tries again, and which nobody interrupts at it. So a pattern has to be
written down, or given as a parameter. One that repeats a group, or too many parts, is refused
(:func:`refuse_hard_patterns`); where one repeats a few, the server refuses texts that are too long for it by what is
put around them (:func:`bounded_texts`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

from foon_kg.model.errors import GraphError
from foon_kg.store.graph.question_words import CLOSED, Around, Token, partners, too_much

MOST_STEPS = 100_000_000
"""So many steps of matching take a server some seconds: a text's length, multiplied by itself for each “as many as
there are” (``*``, ``+``, ``{…}``) of its pattern, in each of the ways."""

MOST_UNBOUNDED = 3
"""How often a pattern may say “as many as there are”."""

MOST_WAYS = 1_024
"""The ways to match a pattern are its alternatives (``|``), multiplied by those of its groups, and twice as many for
each “or nothing” (``?``): Java tries them all where a text does not match. So many are the most, one group apart: a
list of names may be long."""

LONGEST_TEXT = 1_000_000
"""A pattern that bears texts of more characters has no bound: nobody has such texts."""

PLAINER_PATTERN = "Use CONTAINS or STARTS WITH, or a plainer pattern: “.*(onion|leek).*”."

_PIECE = re.compile(
    r"""
      (?P<flag_x>\(\?[A-Za-z-]*x)            # behind it, spaces and remarks may part a group from its “*”
    | (?P<harmless>
          \\[dDwWsSbBnrt] | \\[^0-9A-Za-z]   # a kind of sign, or a sign itself
        | \(\?[A-Za-z-]*\)                   # flags
        | \[\^?+ (?: \\[dDwWsSbBnrt] | \\[^0-9A-Za-z] | (?!&&)[^][\\] )+ \] )
    | (?P<unknown_escape>\\)                 # \1 repeats a text, \Q hides signs
    | (?P<unclear_set>\[)                    # a set in a set: where it ends, Java may see otherwise
    | (?P<opens>\((?:\?[A-Za-z-]*:?)?)       # its “?” is no “or nothing”
    | (?P<repeated_group>\)[*+{])
    | (?P<closes>\))
    | (?P<unbounded>[*+{][?+]?)
    | (?P<optional>\?)
    | (?P<bar>\|)
    | .
    """,
    re.VERBOSE | re.DOTALL,
)
_REFUSED = {
    "repeated_group": "repeats a group",
    "unknown_escape": "has a sign behind a backslash that is not known here",
    "flag_x": "has the flag x, behind which spaces hide what it repeats",
}
_TOO_LONG = "a text is longer than its pattern bears: "
"""What the server says of one, in the words of a date that is none; then comes how many characters it bears."""

_BOUNDED = f"CASE WHEN size(toStringOrNull(text)) > {{most}} THEN date('{_TOO_LONG}{{most}}') ELSE text END"
_WORDS_BEFORE = frozenset(
    {"and", "by", "case", "distinct", "else", "not", "or", "return", "then", "when", "where", "with", "xor"}
)
"""Keywords behind which an expression begins."""

_SIGNS_BEFORE = frozenset("([{,|:=")
"""The signs behind which one begins, and to which nothing binds it."""

_ENDS_PATTERN = frozenset(")]},|;")
"""The signs that end a pattern, as every word does; but ``||`` joins texts as ``+`` does, and is refused."""

_ESCAPED = {"n": "\n", "r": "\r", "t": "\t", "b": "\b", "f": "\f"}
"""What a letter behind a backslash is in a string of Cypher; any other sign is itself (``\\u`` is refused before)."""


def refuse_hard_patterns(tokens: Sequence[Token], parameters: Mapping[str, Any]) -> None:
    """Raise GraphError where a pattern in ``tokens`` is neither written down nor one of ``parameters``, or too hard.

    Too hard is what a server could be at for hours, with the code ``too-much``.

    >>> from foon_kg.store.graph.question_words import read
    >>> refuse_hard_patterns(read("MATCH (n) WHERE n.name =~ '.*leek.*' RETURN n"), {})
    >>> refuse_hard_patterns(read("MATCH (n) WHERE n.name =~ '(a|aa)*b' RETURN n"), {})
    Traceback (most recent call last):
    foon_kg.model.errors.GraphError: this question is too much to ask: a pattern repeats a group
    """
    for place in _places(tokens):
        _refuse_if_hard(_pattern(tokens[place + 2 :], parameters))


def _places(tokens: Sequence[Token]) -> Iterator[int]:
    """Yield the place of each ``=~`` (two signs) that has something before it."""
    for place in range(1, len(tokens) - 1):
        if (tokens[place].text, tokens[place + 1].text) == ("=", "~"):
            yield place


def _pattern(tokens: Sequence[Token], parameters: Mapping[str, Any]) -> str:
    """Return the pattern with which ``tokens`` begin: strings and parameters, joined by ``+``."""
    parts: list[str] = []
    for number, token in enumerate(tokens):
        is_operand = number % 2 == 0
        if is_operand:
            parts.append(_value_of(token, parameters))
        elif token.text != "+":
            joined = token.text == "|" and [one.text for one in tokens[number + 1 : number + 2]] == ["|"]
            if not joined and (token.kind in {"word", "quoted"} or token.text in _ENDS_PATTERN):
                break
            raise too_much(
                f"what follows =~ is more than strings and parameters that are joined by +: {token.text}",
                hint="Where the sign belongs to what is compared, put the comparison into brackets: (n.name =~ '…').",
            )
    return "".join(parts)


def _value_of(token: Token, parameters: Mapping[str, Any]) -> str:
    """Return the text that a string or a parameter is; raises GraphError for anything else."""
    if token.kind == "string":
        return re.sub(r"\\(.)", lambda found: _ESCAPED.get(found[1], found[1]), token.text[1:-1], flags=re.DOTALL)
    name = token.text[1:].removeprefix("`").removesuffix("`").replace("``", "`")
    if token.kind == "word" and token.text.startswith("$") and isinstance(parameters.get(name, ""), str):
        return str(parameters.get(name, ""))  # one that is not given is the server's to miss
    raise too_much(
        "what follows =~ is neither a string nor a parameter", hint="Write the pattern down, or use CONTAINS."
    )


def bounded_texts(pieces: Sequence[Token], parameters: Mapping[str, Any]) -> Iterator[Around]:
    """Yield what is put around each text that is held against a pattern, such that a server refuses one too long.

    ``pieces`` are all those of the question, spaces too, asked with ``parameters``; the places are places in them. Only
    a pattern that bears no text of ``LONGEST_TEXT`` bounds its texts. Raises GraphError where it is not plain what that
    text is.

    >>> from foon_kg.store.graph.question_words import put_around, read_pieces
    >>> pieces = read_pieces("RETURN n.name =~ '.*a.*b'")
    >>> put_around(pieces, bounded_texts(pieces, {}))[:76]
    'RETURN [text IN [n.name] | CASE WHEN size(toStringOrNull(text)) > 10000 THEN'
    """
    places = [place for place, piece in enumerate(pieces) if piece.kind != "space"]
    tokens = [pieces[place] for place in places]
    for at in _places(tokens):
        most = _Pattern.read(_pattern(tokens[at + 2 :], parameters)).longest_text
        if most < LONGEST_TEXT:
            first = places[_begin_of_operand(tokens, at - 1)]
            yield Around(first, "[text IN [", places[at - 1], f"] | {_BOUNDED.format(most=most)}][0]")


def too_long(message: str) -> GraphError | None:
    """Return the error that a ``message`` of a server means which refused a text (:func:`bounded_texts`).

    ``None`` where it says something else.

    >>> print(too_long("Text cannot be parsed to a Date: a text is longer than its pattern bears: 10000"))
    this question is too much to ask: a text is longer than its pattern bears: 10,000 characters
    """
    told = re.search(_TOO_LONG + r"(\d+)", message)
    return told and too_much(f"{_TOO_LONG}{int(told[1]):,} characters", hint=PLAINER_PATTERN)


@dataclass(frozen=True)
class _Pattern:
    """What a regular expression says: of what ``kinds`` its pieces are (names in ``_PIECE``; None for a plain sign)."""

    kinds: tuple[str | None, ...]

    @classmethod
    def read(cls, text: str) -> _Pattern:
        return cls(tuple(found.lastgroup for found in _PIECE.finditer(text)))

    @property
    def alternatives(self) -> list[int]:
        """How many alternatives the pattern has, and each group in it."""
        found, within = [1], [0]
        for kind in self.kinds:
            if kind == "opens":
                within.append(len(found))
                found.append(1)
            elif kind == "closes" and len(within) > 1:
                within.pop()
            elif kind == "bar":
                found[within[-1]] += 1
        return found

    @property
    def ways(self) -> int:
        """In how many ways it may be matched, repetitions apart (``MOST_WAYS``)."""
        return int(prod(self.alternatives) * 2 ** self.kinds.count("optional"))

    @property
    def longest_text(self) -> int:
        """How many characters a text may have that is held against it."""
        degree = self.kinds.count("unbounded")
        return int((MOST_STEPS / min(self.ways, MOST_STEPS)) ** (1 / degree)) if degree else LONGEST_TEXT


def _refuse_if_hard(text: str) -> None:
    pattern = _Pattern.read(text)
    kinds = pattern.kinds
    for kind, why in _REFUSED.items():
        if kind in kinds:
            raise too_much(f"a pattern {why}", hint=PLAINER_PATTERN)
    if (count := kinds.count("unbounded")) > MOST_UNBOUNDED:
        raise too_much(
            f"a pattern has {count} of *, + and {{…}}, and {MOST_UNBOUNDED} are the most", hint=PLAINER_PATTERN
        )
    if "bar" in kinds and "unclear_set" in kinds:
        raise too_much("a pattern has | beside brackets in brackets", hint="Put \\ before a bracket that is a sign.")
    if pattern.ways // max(pattern.alternatives) > MOST_WAYS:
        raise too_much(f"a pattern has more than {MOST_WAYS:,} ways by its | and ?", hint=PLAINER_PATTERN)


def _begin_of_operand(tokens: Sequence[Token], last: int) -> int:
    """Return where the text begins that ends at ``last``: a string, a bracket, a name with its properties, a call.

    Raises GraphError where an operator stands before it, since that may bind it to more.
    """
    first = _begin_of_term(tokens, last)
    joined = first > 1 and tokens[first - 1].text == tokens[first - 2].text == "|"
    if not first or (_stands_before(tokens[first - 1]) and not joined):
        return first
    raise too_much(
        "it is not plain which text is held against a pattern", hint="Put what stands before =~ into brackets."
    )


def _begin_of_term(tokens: Sequence[Token], last: int) -> int:
    """Return where a string, bracket, name or call begins that ends at ``last``, by brackets and dots alone.

    An operator before it may bind it to more (``'a' + n.name``).
    """
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
