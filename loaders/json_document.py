"""The outer shape of a JSON document, with the line on which each of its parts begins.

A subgraph is in memory as a whole. A long document comes in blocks, and no more of it is held than one of its parts.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import NoReturn

from foon_kg.loaders.notices import UnreadableFile

_SPACE = " \t\r\n"


@dataclass(frozen=True)
class Document:
    """The units as (line, value), and the other fields of the file."""

    units: tuple[tuple[int, object], ...]
    fields: Mapping[str, object]


def parse_document(text: str) -> Document:
    """Return the parts of a ``text`` ``[unit, …]`` or ``{"units": [unit, …], …}``.

    Raises ``UnreadableFile`` for any other.
    """
    cursor = _Cursor(text)
    if cursor.peek() == "[":
        document = Document(tuple(cursor.items()), {})
    elif cursor.peek() == "{":
        document = _object_document(cursor)
    else:
        cursor.fail("no JSON list or object of units")
    if cursor.peek():
        cursor.fail("something follows the end of the JSON")
    return document


def _object_document(cursor: _Cursor) -> Document:
    units: tuple[tuple[int, object], ...] | None = None
    fields: dict[str, object] = {}
    for name in cursor.names():
        if name in fields or (name == "units" and units is not None):
            cursor.fail(f"the field {name!a} is there twice")
        if name == "units" and cursor.peek() == "[":
            units = tuple(cursor.items())
        else:
            fields[name] = cursor.value()
    if units is None or "units" in fields:
        cursor.fail('no list of "units" in it')
    return Document(units, fields)


def stream_fields(blocks: Iterable[str], inside: str) -> Iterator[tuple[int, str, object]]:
    """Yield the fields of the one JSON object that ``blocks`` make, as (line, name, value), one after another.

    Of a field called ``inside`` that is an object its own fields are answered in its place. Raises ``UnreadableFile``,
    perhaps after some fields: only who went through all of them knows that the document is whole.
    """
    cursor = _Cursor("", blocks)
    if cursor.peek() != "{":
        cursor.fail("no JSON object")
    for name in cursor.names():
        if name == inside and cursor.peek() == "{":
            for own in cursor.names():
                yield cursor.line, own, cursor.value()
        else:
            yield cursor.line, name, cursor.value()
    if cursor.peek():
        cursor.fail("something follows the end of the JSON")


def stream_items(blocks: Iterable[str]) -> Iterator[object]:
    """Yield the items of the one JSON list that ``blocks`` make, one after another; of a field twice the last counts.

    Raises ``UnreadableFile``, perhaps after some items: only who went through all of them knows that it is whole.
    """
    cursor = _Cursor("", blocks, json.JSONDecoder())
    if (first := cursor.peek()) != "[":
        cursor.fail(f"no JSON list ({f'it begins with {first}' if first else 'it is empty'})")
    yield from (value for _, value in cursor.items())
    if cursor.peek():
        cursor.fail("something follows the end of the JSON")


ENDS_EARLY = "not JSON: the text ends in the middle"
"""What is said of a stream that is truncated."""

_LONGEST_VALUE = 1 << 26


def ends_early(error: json.JSONDecodeError) -> bool:
    """Return whether a text is JSON as far as it goes, by the ``error`` that reading it raised."""
    return error.msg.startswith("Unterminated string") or not error.doc[error.pos :].strip()


_NEAR_THE_END = 16
"""No number, word or escape that a block cuts in two has more characters (``-Infinity``)."""


class _Cursor:
    """A place in a JSON text. Values are decoded whole, so that only the outermost brackets are walked by hand.

    ``blocks`` are what follows ``text``; what lies behind the cursor is forgotten when the next one is read.
    """

    def __init__(self, text: str, blocks: Iterable[str] = (), decoder: json.JSONDecoder | None = None) -> None:
        self._text = text
        self._blocks = iter(blocks)
        self._streams = not text
        self._at = 0
        self._first = 1  # the line on which the text begins
        self._line = 1
        self._counted = 0
        self._decoder = decoder or json.JSONDecoder(
            object_pairs_hook=_without_repetition, parse_constant=_refuse_constant
        )

    @property
    def line(self) -> int:
        self._line += self._text.count("\n", self._counted, self._at)
        self._counted = self._at
        return self._line

    def fail(self, message: str) -> NoReturn:
        raise UnreadableFile(message, self.line)

    def peek(self) -> str:
        """Go to the next character that is no white space and return it; nothing at the end."""
        while True:
            while self._text[self._at : self._at + 1] in _SPACE and self._at < len(self._text):
                self._at += 1
            if self._at < len(self._text) or not self._read_on():
                return self._text[self._at : self._at + 1]

    def value(self) -> object:
        """Decode the value that begins here and go behind it."""
        self.peek()
        while True:
            try:
                value, end = self._decoder.raw_decode(self._text, self._at)
            except json.JSONDecodeError as error:
                if self._may_be_cut(error) and self._read_on():
                    continue
                raise UnreadableFile(self._what_is_no_json(error), self._first + error.lineno - 1) from error
            except ValueError as error:
                reason = str(error).partition(": value has")[0]  # Python tells of a long number how to allow it
                raise UnreadableFile(f"in the value that begins here: {reason}", self.line) from error
            except RecursionError as error:
                raise UnreadableFile("the value that begins here is nested too deeply", self.line) from error
            if (
                end + _NEAR_THE_END < len(self._text) or not self._read_on()
            ):  # 12 may be the beginning of 123, or of 12e3
                self._at = end
                return value

    def _what_is_no_json(self, error: json.JSONDecodeError) -> str:
        return ENDS_EARLY if self._streams and ends_early(error) else f"not JSON: {error.msg}"

    def _may_be_cut(self, error: json.JSONDecodeError) -> bool:
        return error.msg.startswith("Unterminated string") or error.pos >= len(self._text) - _NEAR_THE_END

    def _read_on(self) -> bool:
        """Read as much again as waits to be decoded, one block at least; return whether there was anything."""
        wanted = max(1, len(self._text) - self._at)
        if wanted > _LONGEST_VALUE:
            self.fail(f"the value that begins here has more than {_LONGEST_VALUE:,} characters")
        read: list[str] = []
        while wanted > 0 and (block := next(self._blocks, "")):
            read.append(block)
            wanted -= len(block)
        if not read:
            return False
        self._first = self.line
        self._text, self._at, self._counted = "".join((self._text[self._at :], *read)), 0, 0
        return True

    def items(self) -> Iterator[tuple[int, object]]:
        """Yield the items of the list that begins here, each with its line."""
        for _ in self._between("[", "]"):
            yield self.line, self.value()

    def names(self) -> Iterator[str]:
        """Yield the names of the object that begins here; after each the cursor is before its value."""
        for _ in self._between("{", "}"):
            name = self.value()
            if not isinstance(name, str):
                self.fail("a field without a name")
            self._take(":")
            self.peek()
            yield name

    def _between(self, opening: str, closing: str) -> Iterator[None]:
        self._take(opening)
        if self.peek() != closing:
            self.peek()
            yield
            while self.peek() == ",":
                self._take(",")
                self.peek()
                yield
        self._take(closing)

    def _take(self, character: str) -> None:
        if (there := self.peek()) != character:
            if self._streams and not there:
                self.fail(ENDS_EARLY)
            self.fail(f"not JSON: {character!r} is missing")
        self._at += 1


def _without_repetition(pairs: list[tuple[str, object]]) -> dict[str, object]:
    values = dict(pairs)
    if len(values) < len(pairs):
        twice = Counter(name for name, _ in pairs).most_common(1)[0][0]
        raise ValueError(f"the field {twice!a} is there twice")
    return values


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is no number in JSON")
