"""Recipe1M+ as its authors publish it, read as a stream in bounded memory.

``layer1.json`` is a list of ``{id, title, ingredients: [{text}], instructions, partition, url}``. Beside it may lie
``det_ingrs.json``, a list of ``{id, valid: [bool], ingredients: [{text}]}`` with the food that was detected in each
line, and ``recipes_with_nutritional_info.json``, which has quantities and units. The lists need not have one order, so
what lies beside is put on disk by id first; that pass also finds out whether every file can be read to its end, before
anything is loaded.
"""

from __future__ import annotations

import json
import sqlite3
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any, Self

from foon_kg.loaders.json_stream import stream_list
from foon_kg.loaders.notices import Notice, NoticeKind, Severity
from foon_kg.loaders.text_blocks import half_character
from foon_kg.model.collected import CollectedLine, CollectedRecipe

LAYER_1 = "layer1.json"
DETECTED = "det_ingrs.json"
NUTRITION = "recipes_with_nutritional_info.json"
MOST_INGREDIENTS = 300
"""A recipe with more is none: the longest of real collections stay far below."""

Tell = Callable[[Notice], None]


class Recipe1M(AbstractContextManager["Recipe1M"]):
    """The recipes of one ``layer1.json`` with what lies beside it; use it in a ``with`` statement."""

    def __init__(self, layer1: Path) -> None:
        self._path = layer1
        self._folder = tempfile.TemporaryDirectory(prefix="foon-kg-recipes-")
        self._disk = sqlite3.connect(Path(self._folder.name) / "beside.sqlite", isolation_level=None)
        self._disk.execute("PRAGMA journal_mode = OFF")  # nobody needs these tables after a crash
        self._disk.execute("PRAGMA synchronous = OFF")

    def read_beside(self, tell: Tell) -> None:
        """Read what lies beside ``layer1.json``, once, before :meth:`recipes`; ``tell`` hears what cannot be used.

        Raises ReadError where a file is no JSON list or ends too early.
        """
        self._keep("detected", DETECTED, _detected, tell)
        self._keep("amounts", NUTRITION, _amounts, tell)

    def recipes(self, tell: Tell) -> Iterator[CollectedRecipe]:
        """Yield the recipes in the order of ``layer1.json``; ``tell`` hears of what is no recipe and is left out."""
        for number, value in stream_list(self._path):
            place = f"{self._path}: element {number}"
            problem = _problem(value)
            if problem is None and isinstance(value, dict):
                yield self._recipe(place, value, tell)
            elif problem is not None:
                tell(Notice(place, None, *problem, "recipe rejected", Severity.REJECTED))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._disk.close()
        self._folder.cleanup()

    def _recipe(self, place: str, fields: Mapping[str, object], tell: Tell) -> CollectedRecipe:
        recipe_id = str(fields["id"])
        texts = _texts(fields["ingredients"])
        detected = self._beside("detected", place, recipe_id, texts, tell)
        amounts = self._beside("amounts", place, recipe_id, texts, tell)
        lines = (
            CollectedLine(text, food or None, "", *(amount or ("", "")))
            for text, food, amount in zip(texts, detected, amounts, strict=True)
        )
        return CollectedRecipe(
            recipe_id,
            _optional(fields, "title") or "",
            tuple(lines),
            place,
            partition=_optional(fields, "partition"),
            url=_optional(fields, "url"),
            instructions=instructions_of(fields.get("instructions")),
        )

    def _keep(
        self, table: str, name: str, read: Callable[[Mapping[str, object]], Sequence[object] | None], tell: Tell
    ) -> None:
        """Put what the file beside says of each recipe on disk; a file that is not there says nothing."""
        self._disk.execute(f"CREATE TABLE {table} (id TEXT, said TEXT)")
        path = self._path.with_name(name)
        if path.exists():
            self._fill(table, path, read, tell)
        # after the rows: ids come in any order, and to sort them once is quicker than to keep them sorted all the time
        self._disk.execute(f"CREATE INDEX {table}_id ON {table} (id)")

    def _fill(
        self, table: str, path: Path, read: Callable[[Mapping[str, object]], Sequence[object] | None], tell: Tell
    ) -> None:
        """Put on disk what ``path`` says; what cannot be used of it is told."""
        self._disk.execute("BEGIN")
        for number, value in stream_list(path):
            said = read(value) if isinstance(value, dict) and _is_id(value.get("id")) else None
            if said is None:
                message = f"no “id” with lists of one length in {path.name}"
                place = f"{path}: element {number}"
                tell(Notice(place, None, NoticeKind.BAD_FIELD, message, "what it says is not used"))
                continue
            row = (_field(value, "id"), json.dumps(said))
            self._disk.execute(f"INSERT INTO {table} VALUES (?, ?)", row)  # noqa: S608 - the name is ours
        self._disk.execute("COMMIT")

    def _beside(self, table: str, place: str, recipe_id: str, texts: Sequence[str], tell: Tell) -> Sequence[Any]:
        """Return what ``table`` says of each line; nothing where it has another number of lines, which is told.

        Where a file says it twice, the last counts.
        """
        query = f"SELECT said FROM {table} WHERE id = ? ORDER BY rowid DESC LIMIT 1"  # noqa: S608 - the name is ours
        row = self._disk.execute(query, (recipe_id,)).fetchone()
        said = json.loads(row[0]) if row else []
        if row and len(said) != len(texts):
            message = f"{len(texts)} ingredients here and {len(said)} beside ({table})"
            tell(Notice(place, None, NoticeKind.LISTS_DIFFER, message, "what stands beside is not used"))
        return said if len(said) == len(texts) else [None] * len(texts)


def _problem(value: object) -> tuple[NoticeKind, str] | None:
    """Return why an element is no recipe, ``None`` where it is one."""
    if not isinstance(value, dict):
        return NoticeKind.BAD_FIELD, f"no object but {_kind(value)}"
    if not _is_id(value.get("id")):
        return NoticeKind.BAD_FIELD, "it has no “id”"
    if not isinstance(value.get("title", ""), str):
        return NoticeKind.BAD_FIELD, f"“title” is {_kind(value['title'])}"
    ingredients = value.get("ingredients")
    if not isinstance(ingredients, list) or not all(_is_text(entry) for entry in ingredients):
        return NoticeKind.BAD_FIELD, "“ingredients” is no list of {text}"
    return count_problem(len(ingredients))


def count_problem(count: int) -> tuple[NoticeKind, str] | None:
    """Return why no recipe has ``count`` ingredients, ``None`` where one may."""
    if not count:
        return NoticeKind.NO_INGREDIENTS, "it has no ingredients"
    if count > MOST_INGREDIENTS:
        return NoticeKind.TOO_MANY_INGREDIENTS, f"{count} ingredients, and no dish has over {MOST_INGREDIENTS}"
    return None


def instructions_of(value: object) -> tuple[str, ...]:
    """Return the steps that a field (``value``) lists, as texts or as {text}; what is neither is no step."""
    listed = value if isinstance(value, list) else value.splitlines() if isinstance(value, str) else []
    texts = (one.get("text") if isinstance(one, dict) else one for one in listed)
    steps = (" ".join(text.split()) for text in texts if isinstance(text, str) and half_character(text) is None)
    return tuple(step for step in steps if any(map(str.isalpha, step)))


def _detected(value: Mapping[str, object]) -> Sequence[object] | None:
    """Return the food of each line, ``""`` where it is not valid."""
    valid, found = value.get("valid"), value.get("ingredients")
    if not isinstance(valid, list) or not isinstance(found, list) or len(valid) != len(found):
        return None
    if not all(_is_text(entry) for entry in found):
        return None
    return [text if good is True else "" for good, text in zip(valid, _texts(found), strict=True)]


def _amounts(value: Mapping[str, object]) -> Sequence[object] | None:
    """Return quantity and unit of each line."""
    lists = [value.get(name) for name in ("ingredients", "quantity", "unit")]
    if not all(isinstance(entries, list) and all(map(_is_text, entries)) for entries in lists):
        return None
    ingredients, quantities, units = (_texts(entries) for entries in lists)
    if not len(ingredients) == len(quantities) == len(units):
        return None
    return list(zip(quantities, units, strict=True))


def _is_id(value: object) -> bool:
    return isinstance(value, str) and value != "" and half_character(value) is None


def _is_text(entry: object) -> bool:
    return isinstance(entry, dict) and isinstance(entry.get("text"), str)


def _texts(entries: object) -> list[str]:
    listed: Iterable[Mapping[str, object]] = entries if isinstance(entries, list) else []
    return [str(entry["text"]) for entry in listed]


def _field(value: object, name: str) -> object:
    return value.get(name) if isinstance(value, dict) else None


def _optional(fields: Mapping[str, object], name: str) -> str | None:
    value = fields.get(name)
    return value if isinstance(value, str) else None


def _kind(value: object) -> str:
    names = {dict: "an object", list: "a list", str: "a text", bool: "yes or no", type(None): "nothing"}
    return names.get(type(value), "a number")
