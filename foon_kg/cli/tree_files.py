"""Files with task trees: plan results as JSON (one, or many in JSON Lines) and FOON text, one tree a file."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from foon_kg.cli.console import Say
from foon_kg.loaders import Notice, read_text
from foon_kg.model import Recipe, Subgraph, regular_files
from foon_kg.model.errors import ReadError
from foon_kg.model.json_text import json_value_at
from foon_kg.model.nodes import name_of_file
from foon_kg.model.tree import TaskTree
from foon_kg.validation import tree_from_json, tree_from_subgraph

STANDARD_INPUT = "-"
_ENDINGS = (".json", ".jsonl", ".txt")
_HINT = "Give a plan result (JSON) or FOON text."


@dataclass(frozen=True)
class TreeDocument:
    """One tree of a file: ``where`` is ``file`` or ``file:line``; ``value`` its JSON, ``None`` for FOON text.

    ``dish_type`` is that of its recipe, else that with which FOON text marks its goal; empty where neither says one.
    """

    where: str
    tree: TaskTree
    value: object = None
    notices: tuple[Notice, ...] = ()
    dish_type: str = ""


def read_trees(file: Path, recipe: Recipe | None = None) -> Iterator[TreeDocument]:
    """Yield the trees in ``file`` (``-`` for standard input), in their order; ``recipe`` replaces the one they carry.

    What begins with ``{`` is JSON, everything else FOON text. Raises ReadError where it is neither.
    """
    text = text_of(file)
    if not text.lstrip().startswith("{"):
        yield _from_text(file, text, recipe)
        return
    for line, value in json_values(file, text):
        where = f"{file}:{line}"
        tree = tree_from_json(value, where)
        tree = replace(tree, recipe=recipe or tree.recipe)
        yield TreeDocument(where, tree, value, dish_type=tree.recipe.dish_type if tree.recipe else "")


def read_all_trees(paths: Sequence[Path], say: Say) -> list[TreeDocument]:
    """Return the trees of files and, at any depth, of folders; in the order of the paths, in folders by file name.

    A file of a folder that holds no task tree is passed over with a word to ``say``; one that was named itself, and
    a folder without any tree, raises ReadError.
    """
    return [document for path in paths for document in (_below(path, say) if path.is_dir() else read_trees(path))]


def _below(folder: Path, say: Say) -> list[TreeDocument]:
    found: list[TreeDocument] = []
    for file in sorted(folder.rglob("*")):
        hidden = any(part.startswith(".") for part in file.relative_to(folder).parts)
        if hidden or file.suffix.lower() not in _ENDINGS or not file.is_file():
            continue
        try:
            found += read_trees(file)
        except ReadError as error:
            say(f"passed over: {error.message}")
    if not found:
        raise ReadError(f"{folder}: no task tree in this folder", hint=_HINT)
    return found


def text_of(file: Path) -> str:
    """Return the text of ``file`` (``-`` for standard input); raises ReadError where it is no text."""
    try:
        return sys.stdin.read() if str(file) == STANDARD_INPUT else regular_files.read_text(file)
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or "it is no text in UTF-8"
        raise ReadError(f"{file}: cannot be read: {why}", hint=_HINT) from error


def _from_text(file: Path, text: str, recipe: Recipe | None) -> TreeDocument:
    result = read_text(text, name_of_file(file), str(file))
    if result.subgraph is None:
        raise ReadError(f"{file}: no task tree in it", hint=_HINT)
    tree = tree_from_subgraph(result.subgraph, recipe)
    dish_type = recipe.dish_type if recipe else _marked(result.subgraph)
    return TreeDocument(str(file), tree, notices=result.notices, dish_type=dish_type)


def _marked(subgraph: Subgraph) -> str:
    """Return the dish type with which the last marked output of some FOON text is marked."""
    outputs = (output for annotation in subgraph.annotations for output in annotation.unit.outputs)
    marks = [output.dish_type for output in outputs if output.dish_type]
    return marks[-1] if marks else ""


def json_values(file: Path, text: str) -> Iterator[tuple[int, object]]:
    """Yield each JSON value in ``text`` with the line where it begins, whether one a line or spread over many.

    Errors name the ``file``.
    """
    place, line, counted = _after_space(text, 0), 1, 0
    while place < len(text):
        line, counted = line + text.count("\n", counted, place), place
        try:
            value, end = json_value_at(text, place)
        except json.JSONDecodeError as error:
            raise ReadError(f"{file}:{error.lineno}: {error.msg}", hint="It should be JSON or JSON Lines.") from error
        yield line, value
        place = _after_space(text, end)


def is_retrieved(value: object) -> bool:
    """Whether a JSON ``value`` is what ``foon retrieve --json`` prints: asked for a goal and not for a recipe."""
    return isinstance(value, dict) and "asked" in value


def _after_space(text: str, place: int) -> int:
    while place < len(text) and text[place].isspace():
        place += 1
    return place
