"""Files with task trees: plan results as JSON (one, or many in JSON Lines) and FOON text."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from foon_kg.errors import ReadError
from foon_kg.form import TaskTree
from foon_kg.loaders import Notice, read_text
from foon_kg.model import Recipe

STANDARD_INPUT = "-"


@dataclass(frozen=True)
class TreeDocument:
    """One tree of a file: ``where`` is ``file`` or ``file:line``; ``value`` its JSON, ``None`` for FOON text."""

    where: str
    tree: TaskTree
    value: object = None
    notices: tuple[Notice, ...] = ()


def read_trees(file: Path, recipe: Recipe | None = None) -> Iterator[TreeDocument]:
    """Answer the trees in ``file`` (``-`` for standard input), in their order; ``recipe`` replaces the one they carry.

    What begins with ``{`` is JSON, everything else FOON text. Raises ReadError where it is neither.
    """
    text = text_of(file)
    if not text.lstrip().startswith("{"):
        yield _from_text(file, text, recipe)
        return
    for line, value in json_values(file, text):
        where = f"{file}:{line}"
        tree = TaskTree.from_json(value, where)
        yield TreeDocument(where, replace(tree, recipe=recipe or tree.recipe), value)


def text_of(file: Path) -> str:
    """Answer the text of ``file`` (``-`` for standard input); raises ReadError where it is no text."""
    try:
        return sys.stdin.read() if str(file) == STANDARD_INPUT else file.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise ReadError(f"{file}: cannot be read: {error}", hint="Give a plan result (JSON) or FOON text.") from error


def _from_text(file: Path, text: str, recipe: Recipe | None) -> TreeDocument:
    result = read_text(text, file.stem, str(file))
    if result.subgraph is None:
        raise ReadError(f"{file}: no task tree in it", hint="Give a plan result (JSON) or FOON text.")
    return TreeDocument(str(file), TaskTree.from_subgraph(result.subgraph, recipe), notices=result.notices)


def json_values(file: Path, text: str) -> Iterator[tuple[int, object]]:
    """Answer each JSON value of a text with the line where it begins, whether one a line or spread over many."""
    decoder = json.JSONDecoder()
    place, line, counted = _after_space(text, 0), 1, 0
    while place < len(text):
        line, counted = line + text.count("\n", counted, place), place
        try:
            value, end = decoder.raw_decode(text, place)
        except json.JSONDecodeError as error:
            raise ReadError(f"{file}:{error.lineno}: {error.msg}", hint="It should be JSON or JSON Lines.") from error
        yield line, value
        place = _after_space(text, end)


def _after_space(text: str, place: int) -> int:
    while place < len(text) and text[place].isspace():
        place += 1
    return place
