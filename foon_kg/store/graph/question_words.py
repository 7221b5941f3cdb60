"""The words of a question in Cypher: its pieces in their order, within bounds, and nothing that hides.

A server tells the plan of a question, but not what stands inside its expressions: who is to know what it does reads its
words (:mod:`foon_kg.store.graph.looking`). Texts that are too long or nested too deep are refused: already to plan one
could take a server hours, and it lets nobody interrupt that.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate

from foon_kg.model.errors import GraphError, WriteRefused

MOST_CHARACTERS = 50_000
MOST_WORDS = 4_000
"""Of words, numbers, strings and signs together."""

DEEPEST = 60
"""How many brackets may stand within each other."""

DEEPEST_BRACES = 12
"""How many of them may be braces: each may begin a subquery, and to plan these takes twice as long for each more."""

MOST_OF = {"case": 60, "not": 100, "union": 100, "xor": 50}
"""Words that may stand within each other without a bracket, or of which each is a question of its own."""

_PIECE = re.compile(
    r"""
      (?P<space>\s+|//[^\n\r]*|/\*.*?\*/)
    | (?P<string>'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*")
    | (?P<quoted>`(?:[^`]|``)*`)
    | (?P<number>\d\w*(?:\.\d\w*)?)
    | (?P<word>\$?[^\W\d]\w*|\$\d+|\$`(?:[^`]|``)*`)
    | (?P<sign>(?!/\*)[!#-&(-/:-@\[\]^{-~])
    """,
    re.VERBOSE | re.DOTALL,
)
CLOSING = {"(": ")", "[": "]", "{": "}"}
OPEN, CLOSED = frozenset(CLOSING), frozenset(CLOSING.values())


@dataclass(frozen=True)
class Token:
    """A piece of a question: ``word``, ``quoted`` (in backticks), ``string``, ``number``, ``sign`` or ``space``."""

    kind: str
    text: str

    @property
    def lower(self) -> str:
        """A word in lower case, to compare it with a keyword; of anything else what no keyword is.

        By way of upper case: there are letters of which a server may make a plain one so.
        """
        return self.text.upper().lower() if self.kind == "word" else ""

    @property
    def name(self) -> str:
        """The name that a word or what stands in backticks is; ``""`` of anything else."""
        if self.kind == "quoted":
            return self.text[1:-1].replace("``", "`")
        return self.text if self.kind == "word" and not self.text.startswith("$") else ""


@dataclass(frozen=True)
class Around:
    """What is put around the pieces from ``first`` to ``last``."""

    first: int
    begins: str
    last: int
    ends: str


def put_around(pieces: Sequence[Token], arounds: Iterable[Around]) -> str:
    """Return the text of a question with what is put around its pieces; none begins in another and ends outside it.

    >>> put_around(read_pieces("RETURN n.x"), [Around(2, "[", 4, "][0]")])
    'RETURN [n.x][0]'
    """
    before: dict[int, str] = {}
    after: dict[int, str] = {}
    for one in sorted(arounds, key=lambda one: one.last - one.first):  # inner ones first: the others stand outside
        before[one.first] = one.begins + before.get(one.first, "")
        after[one.last] = after.get(one.last, "") + one.ends
    return "".join(f"{before.get(place, '')}{one.text}{after.get(place, '')}" for place, one in enumerate(pieces))


def read(text: str) -> tuple[Token, ...]:
    """Return the pieces of ``text`` without its spaces and comments.

    Raises :class:`~foon_kg.model.errors.WriteRefused` where something hides in it, GraphError where it is too much.

    >>> [piece.text for piece in read("RETURN n.x // all of them")]
    ['RETURN', 'n', '.', 'x']
    """
    return asked(read_pieces(text))


def read_pieces(text: str) -> tuple[Token, ...]:
    """Return all pieces of a question in their order, so that together they are its text; raises as :func:`read`.

    >>> [(piece.kind, piece.text) for piece in read_pieces("RETURN 'a'")]
    [('word', 'RETURN'), ('space', ' '), ('string', "'a'")]
    """
    if len(text) > MOST_CHARACTERS:
        raise too_much(f"it has {len(text)} characters, and {MOST_CHARACTERS} are the most")
    if re.search(r"\\u", text, re.IGNORECASE):
        raise WriteRefused(
            "a character that is written by its number could hide anything",
            hint="Write the character itself, or give the text as a parameter.",
        )
    return tuple(_tokens(text))


def asked(pieces: Sequence[Token]) -> tuple[Token, ...]:
    """Return the pieces that are no space; raises GraphError where they are too many or nested too deep."""
    tokens = tuple(piece for piece in pieces if piece.kind != "space")
    if len(tokens) > MOST_WORDS:
        raise too_much(f"it has {len(tokens)} words and signs, and {MOST_WORDS} are the most")
    for signs, most in (("([{", DEEPEST), ("{", DEEPEST_BRACES)):
        if _depth(tokens, signs) > most:
            raise too_much(f"more than {most} brackets ({signs}) stand within each other")
    counted = Counter(token.lower for token in tokens)
    for word, most in MOST_OF.items():
        if counted[word] > most:
            raise too_much(f"it says {word.upper()} {counted[word]} times, and {most} is the most")
    return tokens


def _depth(tokens: Sequence[Token], signs: str) -> int:
    """Return how many brackets that open with one of ``signs`` stand within each other."""
    closing = {CLOSING[sign] for sign in signs}
    steps = ((one.text in signs) - (one.text in closing) for one in tokens if one.kind == "sign")
    return max(accumulate(steps), default=0)


def partners(tokens: Sequence[Token]) -> dict[int, int]:
    """Return where each bracket that opens in ``tokens`` is closed.

    >>> partners(read("f([x])"))
    {2: 4, 1: 5}
    """
    found: dict[int, int] = {}
    open_ones: list[int] = []
    for place, token in enumerate(tokens):
        if token.text in OPEN:
            open_ones.append(place)
        elif open_ones and token.text == CLOSING[tokens[open_ones[-1]].text]:
            found[open_ones.pop()] = place
    return found


def too_much(why: str, *, hint: str = "Give long lists as parameters (-P).") -> GraphError:
    """Return the error for a question that a server could be at for hours: ``why``, and a ``hint`` of what to do."""
    return GraphError(f"this question is too much to ask: {why}", hint=hint, code="too-much")


def _tokens(text: str) -> Iterator[Token]:
    place = 0
    while place < len(text):
        found = _PIECE.match(text, place)
        if found is None:
            line = text.count("\n", 0, place) + 1
            raise WriteRefused(
                f"what begins in line {line} does not end, or is no sign of Cypher: {text[place : place + 20]!r}",
                hint="Close what is in quotation marks or backticks; use plain spaces and signs.",
            )
        place = found.end()
        yield Token(str(found.lastgroup), found.group())
