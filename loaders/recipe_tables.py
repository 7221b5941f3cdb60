"""Recipes from tables and small JSON files: our own query JSON, JSON Lines, CSV and Parquet.

A table has a column ``id``, ``title``, ``type`` (or ``dish_type``), ``ingredients``, ``instructions``, ``partition``,
``url``, or those that public collections have in their place (``OTHER_NAMES``); all but ``ingredients`` may be missing.
A cell of ingredients is a list in JSON or as Python prints it (of texts, or of ``{object, state}``), or texts with line
ends, ``|`` or ``;`` between them; one of instructions has a step a line, or is a list.
"""

from __future__ import annotations

import ast
import csv
import json
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from functools import partial
from io import TextIOWrapper
from itertools import islice
from pathlib import Path
from types import ModuleType

from foon_kg.loaders.json_document import ENDS_EARLY, ends_early
from foon_kg.loaders.json_stream import stream_list
from foon_kg.loaders.notices import Notice, NoticeKind, Severity, UnreadableFile
from foon_kg.loaders.paths import decode
from foon_kg.loaders.recipe1m import Tell, count_problem, instructions_of
from foon_kg.model.collected import CollectedLine, CollectedRecipe
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.nodes import name_of_file
from foon_kg.model.regular_files import open_regular, read_bytes

LONGEST_LINE = 16_000_000
"""More characters than a recipe has."""

MOST_COLUMNS = 1_000
"""Of a table; pandas took 1 GB and nine seconds for a row of 200,000."""

LONGEST_PRINTED_LIST = 100_000
"""Characters of a list as Python prints it: its reader takes hundreds of bytes for each."""

OTHER_NAMES = {"title": ("name",), "instructions": ("directions", "steps"), "url": ("link",), "type": ("dish_type",)}
"""What RecipeNLG and the tables of food.com call their columns; capitals and spaces around are passed over."""

_ROWS = 5_000
_BETWEEN = re.compile(r"[\n|;]")
_TOO_MANY_CELLS = re.compile(r"Expected (\d+) fields in line (\d+), saw (\d+)")
_OPEN_QUOTE = re.compile(r"EOF inside string starting at row (\d+)")


def read_rows(path: Path, tell: Tell) -> Iterator[CollectedRecipe]:
    """Yield the recipes of the file at ``path`` in their order; ``tell`` hears of what is no recipe and is left out.

    Raises ReadError where the file cannot be read as what its ending says, UsageError for an unknown ending or where
    the extra ``recipes`` is not installed.
    """
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        hint = f"Known endings: {', '.join(KNOWN_ENDINGS)}."
        raise UsageError(f"{path}: no collection of recipes", hint=hint)
    for number, row in reader(path):
        place = f"{path}: recipe {number}"
        recipe = _recipe(path, number, place, row, tell)
        if isinstance(recipe, CollectedRecipe):
            yield recipe
        else:
            kind, message = recipe
            tell(Notice(place, None, kind, message, "recipe rejected", Severity.REJECTED))


def _recipe(path: Path, number: int, place: str, row: object, tell: Tell) -> CollectedRecipe | tuple[NoticeKind, str]:
    if not isinstance(row, Mapping):
        return NoticeKind.BAD_FIELD, "no object with fields"
    row = _as_ours(row)
    if "ingredients" not in row:
        return NoticeKind.BAD_FIELD, "it has no “ingredients”"
    lines = _lines(row["ingredients"], place, tell)
    if lines is None:
        return NoticeKind.BAD_FIELD, "“ingredients” is no list of texts or of {object, state}"
    if problem := count_problem(len(lines)):
        return problem
    alone = name_of_file(path) if path.suffix.lower() == ".json" and number == 1 else f"{name_of_file(path)}-{number}"
    return CollectedRecipe(
        _number(row, "id") or alone,
        _text(row, "title") or "",
        lines,
        place,
        dish_type=_text(row, "type"),
        partition=_text(row, "partition"),
        url=_text(row, "url"),
        instructions=instructions_of(_steps(row.get("instructions"))),
    )


def _as_ours(row: Mapping[str, object]) -> dict[str, object]:
    """Return ``row`` with the names that we use; a column of ours that says something goes before another's."""
    named = {str(name).strip().casefold(): value for name, value in row.items()}
    for ours, others in OTHER_NAMES.items():
        told = next((named[name] for name in others if named.get(name)), None)
        if told and not named.get(ours):
            named[ours] = told
    return named


def _steps(cell: object) -> object:
    """Return the list that a cell of instructions writes, or the cell where it is none."""
    listed = _entries(cell) if isinstance(cell, str) and cell.lstrip().startswith("[") else None
    return cell if listed is None else listed


def _lines(cell: object, place: str, tell: Tell) -> tuple[CollectedLine, ...] | None:
    """Return the ingredients that a cell lists, ``None`` where it lists something else; one without a name is told."""
    if isinstance(cell, str) and not cell.lstrip().startswith("["):
        return tuple(CollectedLine(part.strip()) for part in _BETWEEN.split(cell) if part.strip())
    entries = _entries(cell)
    if entries is None:
        return None
    lines = []
    for position, entry in enumerate(entries):
        line = _line(entry)
        if line is not None:
            lines.append(line)
        else:
            message = f"ingredients[{position}] names nothing"
            tell(Notice(place, None, NoticeKind.MISSING_NAME, message, "the ingredient is left out"))
    return tuple(lines)


def _entries(cell: object) -> list[str | Mapping[str, object]] | None:
    """Return the entries of a list, which a ``cell`` may write; ``None`` where it is no list of ingredients."""
    if isinstance(cell, str):
        cell = _written_list(cell)
    if not isinstance(cell, list) or not all(isinstance(entry, str | Mapping) for entry in cell):
        return None
    return cell


def _written_list(text: str) -> object:
    """Return what ``text`` writes in JSON, else as Python prints it; ``None`` where it is neither."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        pass
    if len(text) > LONGEST_PRINTED_LIST:
        return None
    try:
        return ast.literal_eval(text.strip())
    except (ValueError, SyntaxError, MemoryError, RecursionError):  # as its documentation lists them
        return None


def _line(entry: str | Mapping[str, object]) -> CollectedLine | None:
    if isinstance(entry, str):
        return CollectedLine(entry.strip()) if entry.strip() else None
    food, state, text = _words(entry, "object"), _words(entry, "state"), _words(entry, "text")
    if not food and not text:
        return None
    quantity = _number(entry, "quantity") or ""
    return CollectedLine(text or f"{state} {food}".strip(), food or None, state, quantity, _words(entry, "unit"))


def _words(fields: Mapping[str, object], name: str) -> str:
    return _text(fields, name) or ""


def _text(fields: Mapping[str, object], name: str) -> str | None:
    value = fields.get(name)
    return value.strip() or None if isinstance(value, str) else None


def _number(fields: Mapping[str, object], name: str) -> str | None:
    """Return a field that may be a number, as text."""
    value = fields.get(name)
    if isinstance(value, int | float) and not isinstance(value, bool) and value == value:  # noqa: PLR0124 - not NaN
        return str(value)
    return _text(fields, name)


def _json(path: Path) -> Iterator[tuple[int, object]]:
    """One recipe, or a list of them."""
    try:
        with open_regular(path) as stream:
            alone = stream.read(64).lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{")
        if not alone:
            yield from stream_list(path)
            return
        text = decode(read_bytes(path)).removeprefix("\ufeff")
    except UnreadableFile as bad:
        raise ReadError(f"{path}:{bad.line or 1}: {bad.problem.message}", hint="Save it as UTF-8 text.") from bad
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="Make the file readable.") from error
    yield 1, _value(path, 1, text)


def _json_lines(path: Path) -> Iterator[tuple[int, object]]:
    line = 0
    try:
        with TextIOWrapper(open_regular(path), encoding="utf-8-sig") as stream:
            for line, text in enumerate(iter(partial(stream.readline, LONGEST_LINE), ""), start=1):
                if len(text) >= LONGEST_LINE:
                    raise ReadError(f"{path}:{line}: a line without end", hint="Each recipe is a line of its own.")
                if text.strip():
                    yield line, _value(path, line, text.strip())
    except UnicodeDecodeError as error:
        line += 1 + error.object[: error.start].count(b"\n")  # a block is read before the lines in it come
        raise ReadError(f"{path}:{line}: not UTF-8 text", hint="Save it as UTF-8.") from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="Make the file readable.") from error


def _value(path: Path, line: int, text: str) -> object:
    """Return the JSON that begins on ``line``. Raises ReadError with the line on which it is none."""
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        where = f"{path}:{line + error.lineno - 1}"
        if ends_early(error):
            raise ReadError(f"{where}: {ENDS_EARLY}", hint="Write it to its end.") from error
        raise ReadError(f"{where}: not JSON: {error.msg}", hint="Correct this line.") from error
    except (ValueError, RecursionError) as error:  # a number too long to be read, brackets in brackets in brackets
        hint = "Mend it there."
        raise ReadError(f"{path}:{line}: a number or a list that no recipe has", hint=hint) from error


def _csv(path: Path) -> Iterator[tuple[int, object]]:
    pandas = _pandas()
    number = 0
    try:
        _refuse_many(path, _csv_columns(path))
        with (
            open_regular(path) as stream,
            pandas.read_csv(
                stream, dtype=str, keep_default_na=False, chunksize=_ROWS, encoding="utf-8-sig", on_bad_lines="error"
            ) as chunks,
        ):
            for chunk in chunks:
                for row in chunk.to_dict("records"):
                    number += 1
                    yield number, row
    except pandas.errors.EmptyDataError as error:
        raise ReadError(f"{path}: the file is empty", hint="Its first line names the columns.") from error
    except UnicodeDecodeError as error:
        hint = "Save it as UTF-8."
        raise ReadError(f"{path}: after recipe {number}: not UTF-8 text", hint=hint) from error
    except pandas.errors.ParserError as error:
        raise _no_table(path, number, error) from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="Make the file readable.") from error


def _csv_columns(path: Path) -> int:
    """Return how many columns the first row has; of one that cannot be read the reader itself tells what is wrong."""
    return next((len(cells) for _, cells in _csv_rows(path)), 0)


def _csv_line(path: Path, row: int) -> int:
    """Return the line on which a ``row`` (from 1) begins; its number where pandas alone reads so far."""
    return next((line for line, _ in islice(_csv_rows(path), row - 1, None)), row)


def _csv_rows(path: Path) -> Iterator[tuple[int, list[str]]]:
    """Yield each row with the line on which it begins: pandas counts rows, and a cell may hold line ends.

    Ends where Python's own reader, which is slower than that of pandas, cannot read on.
    """
    begins = 1
    with TextIOWrapper(open_regular(path), encoding="utf-8-sig", errors="replace", newline="") as stream:
        rows = csv.reader(iter(partial(stream.readline, LONGEST_LINE), ""))  # a line without end is not read to its end
        with suppress(csv.Error):
            for cells in rows:
                yield begins, cells
                begins = rows.line_num + 1


def _refuse_many(path: Path, columns: int) -> None:
    """Raise ReadError for a table so wide that a row of it takes memory and time out of all proportion."""
    if columns > MOST_COLUMNS:
        raise ReadError(
            f"{path}: {columns} columns, and {MOST_COLUMNS} are the most",
            hint="A recipe is a row: what it needs in one column, “ingredients”.",
        )


def _no_table(path: Path, number: int, error: Exception) -> ReadError:
    """Return the error of a table that pandas cannot read after recipe ``number``, with the line where it is known."""
    said = str(error).strip()
    if cells := _TOO_MANY_CELLS.search(said):
        hint = "A cell with a comma needs quotes around it."
        line = _csv_line(path, int(cells[2]))
        return ReadError(f"{path}:{line}: {cells[3]} cells under {cells[1]} columns", hint=hint)
    if row := _OPEN_QUOTE.search(said):
        line = _csv_line(path, int(row[1]) + 1)
        return ReadError(f"{path}:{line}: a quote begins here and does not end", hint="End it.")
    return ReadError(f"{path}: after recipe {number}: no CSV table: {said}", hint="Mend it there.")


def _parquet(path: Path) -> Iterator[tuple[int, object]]:
    _pandas()
    import pyarrow as pa  # noqa: PLC0415 - an extra
    from pyarrow import parquet  # noqa: PLC0415 - an extra

    number = 0
    try:
        with open_regular(path) as stream, parquet.ParquetFile(stream) as table:
            _refuse_many(path, table.metadata.num_columns)
            for batch in table.iter_batches(batch_size=_ROWS):
                for row in batch.to_pylist():
                    number += 1
                    yield number, row
    except (pa.ArrowException, OSError) as error:
        raise ReadError(f"{path}: after recipe {number}: no Parquet table: {error}", hint="Write it anew.") from error


def _pandas() -> ModuleType:
    try:
        import pandas as pd  # noqa: PLC0415 - an extra
    except ImportError as error:
        hint = "pip install 'foon-kg[recipes]'"
        raise UsageError("this table needs pandas, which is not installed", hint=hint, code="recipes") from error
    return pd


_READERS: Mapping[str, Callable[[Path], Iterator[tuple[int, object]]]] = {
    ".json": _json,
    ".jsonl": _json_lines,
    ".csv": _csv,
    ".parquet": _parquet,
}

KNOWN_ENDINGS = tuple(_READERS)
