"""The subset of Lisp in which MUHAI writes its recipes: lists, symbols, numbers, strings, quotes, and comments.

Nothing is evaluated. Every value has the line on which it begins. What MUHAI's networks mean is in ``muhai.py``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from foon_kg.loaders.notices import UnreadableFile

DEEPEST = 64
"""How many lists may be open at once; MUHAI's own files need 13."""

LONGEST = 4_000_000
"""How many characters a file may have; the longest of MUHAI's has 32,000."""

_TOKEN = re.compile(
    r"""(?P<skipped>\s+|;[^\n]*|\#\|(?:(?!\|\#).)*\|\#|,@|\#'|['`,])
    |(?P<open>\()|(?P<close>\))
    |(?P<text>"(?:[^"\\]|\\.)*")
    |(?P<symbol>[^\s()'`,";]+)""",
    re.VERBOSE | re.DOTALL,
)
_NEW_DEFINITION = re.compile(r"\((?:def\w+|in-package)\s")


@dataclass(frozen=True)
class Symbol:
    """A symbol, number or string, in lower case unless it is a string."""

    text: str
    line: int


@dataclass(frozen=True)
class Form:
    """A list of forms and symbols."""

    items: tuple[Form | Symbol, ...]
    line: int

    @property
    def head(self) -> str:
        """The first symbol, ``""`` where there is none."""
        first = self.items[0] if self.items else None
        return first.text if isinstance(first, Symbol) else ""

    def forms(self) -> Iterator[Form]:
        """Yield the lists directly inside."""
        return (item for item in self.items if isinstance(item, Form))


class Document(NamedTuple):
    """The outermost lists of a file, and the lines of those that were never closed."""

    forms: tuple[Form, ...]
    unclosed: tuple[int, ...]


def read_lisp(text: str) -> Document:
    """Return the lists of ``text``.

    A definition in the first column begins a new outermost list, as Lisp programmers write it: a list that is still
    open there is taken to end. Raises ``UnreadableFile`` with the line of a parenthesis without a partner, of an
    unfinished string or comment, of too deep a nesting, or for too long a text.

    >>> read_lisp("(bake ?tray 60 minute) ; an hour").forms[0].head
    'bake'
    """
    if len(text) > LONGEST:
        raise UnreadableFile(f"the file has more than {LONGEST:,} characters")
    return _Reader().read(text)


class _Reader:
    def __init__(self) -> None:
        self._done: list[Form] = []
        self._open: list[tuple[int, list[Form | Symbol]]] = []
        self._unclosed: list[int] = []

    def read(self, text: str) -> Document:
        place, line = 0, 1
        while place < len(text):
            match = _TOKEN.match(text, place)
            if match is None or (match[0].startswith("#|") and not match[0].endswith("|#")):
                raise UnreadableFile("a string or comment that begins here does not end", line)
            if match["open"] and (place == 0 or text[place - 1] == "\n") and _NEW_DEFINITION.match(text, place):
                self._end_all()
            self._take(match, line)
            line += match[0].count("\n")
            place = match.end()
        if self._open:
            raise UnreadableFile("the list that begins here is never closed", self._open[0][0])
        return Document(tuple(self._done), tuple(self._unclosed))

    def _take(self, match: re.Match[str], line: int) -> None:
        if match["open"]:
            if len(self._open) == DEEPEST:
                raise UnreadableFile(f"more than {DEEPEST} lists inside one another", line)
            self._open.append((line, []))
        elif match["close"]:
            if not self._open:
                raise UnreadableFile("a closing parenthesis without an opening one", line)
            self._close()
        elif match["text"]:
            self._add(Symbol(match["text"], line))
        elif match["symbol"]:
            self._add(Symbol(match["symbol"].lower(), line))

    def _end_all(self) -> None:
        if self._open:
            self._unclosed.append(self._open[0][0])
        while self._open:
            self._close()

    def _close(self) -> None:
        line, items = self._open.pop()
        self._add(Form(tuple(items), line))

    def _add(self, item: Form | Symbol) -> None:
        if self._open:
            self._open[-1][1].append(item)
        elif isinstance(item, Form):
            self._done.append(item)
