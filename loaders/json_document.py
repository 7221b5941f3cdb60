"""The outer shape of a JSON subgraph, with the line on which each unit begins."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping
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
    """Answer the parts of ``[unit, …]`` or ``{"units": [unit, …], …}``. Raises ``UnreadableFile`` for anything else."""
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


def parse_fields(text: str) -> tuple[tuple[int, str, object], ...]:
    """Answer the fields of the one JSON object in ``text`` as (line, name, value). Raises ``UnreadableFile``."""
    cursor = _Cursor(text)
    if cursor.peek() != "{":
        cursor.fail("no JSON object")
    fields = tuple((cursor.line, name, cursor.value()) for name in cursor.names())
    if cursor.peek():
        cursor.fail("something follows the end of the JSON")
    return fields


class _Cursor:
    """A place in a JSON text. Values are decoded whole, so that only the outermost brackets are walked by hand."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0
        self._line = 1
        self._counted = 0
        self._decoder = json.JSONDecoder(object_pairs_hook=_without_repetition, parse_constant=_refuse_constant)

    @property
    def line(self) -> int:
        self._line += self._text.count("\n", self._counted, self._at)
        self._counted = self._at
        return self._line

    def fail(self, message: str) -> NoReturn:
        raise UnreadableFile(message, self.line)

    def peek(self) -> str:
        """Go to the next character that is no white space and answer it; nothing at the end."""
        while self._text[self._at : self._at + 1] in _SPACE and self._at < len(self._text):
            self._at += 1
        return self._text[self._at : self._at + 1]

    def value(self) -> object:
        """Decode the value that begins here and go behind it."""
        self.peek()
        try:
            value, self._at = self._decoder.raw_decode(self._text, self._at)
        except json.JSONDecodeError as error:
            raise UnreadableFile(f"not JSON: {error.msg}", error.lineno) from error
        except ValueError as error:
            raise UnreadableFile(f"in the value that begins here: {error}", self.line) from error
        except RecursionError as error:
            raise UnreadableFile("the value that begins here is nested too deeply", self.line) from error
        return value

    def items(self) -> Iterator[tuple[int, object]]:
        """Answer the items of the list that begins here, each with its line."""
        for _ in self._between("[", "]"):
            yield self.line, self.value()

    def names(self) -> Iterator[str]:
        """Answer the names of the object that begins here; after each the cursor is before its value."""
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
        if self.peek() != character:
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
