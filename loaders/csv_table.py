"""The rows of a CSV table that a person or a program wrote, each with the line on which it ends."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from foon_kg.loaders.notices import NoticeKind, Problem, UnreadableFile

LONGEST_CELL = 131_072
"""More characters than this are nothing that is said of one action; the csv module stops there by itself."""


@dataclass(frozen=True)
class TableRow:
    """One row: the cells of its columns by their names in small letters, stripped; ``problem`` is why it is none."""

    line: int
    cells: Mapping[str, str]
    problem: Problem | None


def columns_of(text: str) -> tuple[str, ...]:
    """Return the names on the first line of the ``text`` of a table, in small letters; no name if it is no row."""
    first = io.StringIO(text.removeprefix("\ufeff"), newline="").readline()  # a table may be long
    try:
        return _names(next(csv.reader([first]), []))
    except csv.Error:
        return ()


def table_rows(text: str) -> Iterator[TableRow]:
    """Yield each row of the ``text`` of a table that is not empty; a byte order mark is passed over.

    Raises UnreadableFile with the line on which the row begins that is none: in which a quote never ends, say.
    """
    rows = _rows(text)
    columns = _names(next(rows, (0, []))[1])
    for line, cells in rows:
        if any(cell.strip() for cell in cells):
            named = {column: cell.strip() for column, cell in zip(columns, cells, strict=False)}
            yield TableRow(line, named, _problem(columns, cells))


def _rows(text: str) -> Iterator[tuple[int, list[str]]]:
    """Yield the cells of each row with its line. The limit of the csv module would end the whole table."""
    reader = csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline=""), strict=True)
    while True:
        begins = reader.line_num + 1
        limit = csv.field_size_limit(max(LONGEST_CELL, len(text)))
        try:
            cells = next(reader, None)
        except csv.Error as error:
            raise UnreadableFile(f"no table: {error}", begins) from error
        finally:
            csv.field_size_limit(limit)
        if cells is None:
            return
        yield reader.line_num, cells


def _names(cells: Sequence[str]) -> tuple[str, ...]:
    return tuple(cell.strip().lower() for cell in cells)


def _problem(columns: Sequence[str], cells: Sequence[str]) -> Problem | None:
    longest = max(map(len, cells))
    if longest > LONGEST_CELL:
        return Problem(NoticeKind.LONG_CELL, f"a cell of {longest} characters")
    if any(cell.strip() for cell in cells[len(columns) :]):
        message = f"{len(cells)} cells under {len(columns)} columns: a cell with a comma needs quotes"
        return Problem(NoticeKind.EXTRA_COLUMN, message)
    return None
