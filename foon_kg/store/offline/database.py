"""The tables that are staged for an import, in one SQLite file."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Self

from foon_kg.store.disk import explain_os_error
from foon_kg.store.offline.tables import EDGES, END, LIST_DELIMITER, NODES, NUMBER, START, Edges, Nodes, kind_of, named

CACHE_KIB = 64_000
"""Bounds the memory that SQLite takes."""

Rows = Sequence[Mapping[str, Any]]

_TABLES = {table.name: table for table in (*NODES, *EDGES)}


class Database:
    """The tables of a FOON in the file ``path``, which is made where it is not there. Close it, or use ``with``."""

    def __init__(self, path: Path) -> None:
        with explain_os_error(f"cannot write {path}"):
            path.touch()
        self.database = sqlite3.connect(path, isolation_level=None)
        for pragma in ("journal_mode = OFF", "synchronous = OFF", f"cache_size = -{CACHE_KIB}"):
            self.database.execute(f"PRAGMA {pragma}")
        for table in _TABLES.values():
            self.database.execute(_made(table))
        self.database.execute("BEGIN")

    def commit(self) -> None:
        """Write down what was staged."""
        self.database.execute("COMMIT")
        self.database.execute("BEGIN")

    def close(self) -> None:
        """Let the file go."""
        self.database.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def one(self, table: str, properties: Mapping[str, Any]) -> int:
        """Make one node in ``table`` with these ``properties``, and return its number."""
        columns = [named(column) for column in nodes_of(table).columns]
        cells = [cell(properties.get(name)) for name in columns]
        marks = ", ".join("?" * (1 + len(cells)))
        number = self.database.execute(f"INSERT INTO {table} VALUES ({marks})", (None, *cells)).lastrowid
        return number or 0

    def insert(self, table: str, rows: Iterable[Sequence[Any]]) -> None:
        """Make nodes or edges in ``table`` of ``rows`` that are not there yet."""
        made = _TABLES[table]
        columns = (*_keys(made), *(named(column) for column in made.columns))
        marks = ", ".join("?" * len(columns))
        names = ", ".join(f'"{column}"' for column in columns)
        self.database.executemany(f"INSERT OR IGNORE INTO {table} ({names}) VALUES ({marks})", rows)

    def new(self, table: str, rows: Iterable[Sequence[Any]]) -> Iterator[tuple[str, int]]:
        """Make nodes in ``table`` of ``rows`` that are not there yet, and yield the key and number of each of these."""
        columns = [named(column) for column in nodes_of(table).columns]
        marks, names = ", ".join("?" * len(columns)), ", ".join(f'"{column}"' for column in columns)
        cursor, text = self.database.cursor(), f"INSERT OR IGNORE INTO {table} ({names}) VALUES ({marks})"
        for row in rows:
            if cursor.execute(text, row).rowcount:
                yield row[0], cursor.lastrowid or 0

    def merged(self, table: str, names: Iterable[str]) -> dict[str, int]:
        """Return the numbers of ``names`` in a ``table`` of words, which are made where they are not there yet."""
        wanted = sorted(set(names))
        self.database.executemany(f"INSERT OR IGNORE INTO {table} (name) VALUES (?)", ((name,) for name in wanted))
        return self.ids(table, wanted)

    def ids(self, table: str, keys: Iterable[str]) -> dict[str, int]:
        """Return the numbers of those nodes of ``table`` that are there, by their ``keys``."""
        return dict(self.found(table, NUMBER, keys))

    def found(self, table: str, column: str, keys: Iterable[str]) -> list[tuple[str, Any]]:
        """Return the key and one ``column`` of those nodes of ``table`` with ``keys`` that are there."""
        key = named(nodes_of(table).columns[0])
        text = f'SELECT t."{key}", t."{column}" FROM json_each(?) asked JOIN {table} t ON t."{key}" = asked.value'
        return self.database.execute(text, (json.dumps(list(keys)),)).fetchall()

    def count(self, table: str, rows: Rows, start: str, end: str, more: str = "") -> None:
        """Add the ``rows`` to counts in ``table`` between the nodes that the columns ``start`` and ``end`` name.

        ``more`` is one further column by which edges are told apart, if there is one.
        """
        edges = edges_of(table)
        starts = self._ends(edges.start, {row[start] for row in rows})
        ends = self._ends(edges.end, {row[end] for row in rows})
        cells = ((starts[row[start]], ends[row[end]], *((row[more],) if more else ()), row["count"]) for row in rows)
        self.add(table, cells, "count")

    def _ends(self, label: str, names: Iterable[str]) -> dict[str, int]:
        """Return the numbers of nodes; states and utensils are made where they are not there yet."""
        return self.merged(label, names) if label in {"State", "Utensil"} else self.ids(label, names)

    def add(self, table: str, rows: Iterable[Sequence[Any]], *counts: str) -> None:
        """Add ``rows`` to the columns ``counts`` of edges in ``table``, which are made where they are not there yet."""
        marks = ", ".join("?" * (2 + len(edges_of(table).columns)))
        sums = ", ".join(f'"{name}" = "{name}" + excluded."{name}"' for name in counts)
        self.database.executemany(f"INSERT INTO {table} VALUES ({marks}) ON CONFLICT DO UPDATE SET {sums}", rows)


def nodes_of(name: str) -> Nodes:
    """Return the table of the label ``name``; raises TypeError where that is no label."""
    table = _TABLES[name]
    if not isinstance(table, Nodes):
        raise TypeError(name)
    return table


def edges_of(name: str) -> Edges:
    """Return the table ``name`` of a type of relationship between two labels; raises TypeError where it is none."""
    table = _TABLES[name]
    if not isinstance(table, Edges):
        raise TypeError(name)
    return table


def _keys(table: Nodes | Edges) -> tuple[str, ...]:
    return () if isinstance(table, Nodes) else (START, END)


def _made(table: Nodes | Edges) -> str:
    """Return the statement that makes a table where it is not there; numbers are kept as numbers, all else as texts."""
    columns = [f'"{named(column)}" {"INTEGER" if kind_of(column) == "long" else "TEXT"}' for column in table.columns]
    if isinstance(table, Nodes):
        columns = [f"{NUMBER} INTEGER PRIMARY KEY", *columns, *(['"_label" TEXT'] if table.labelled else [])]
        unique: tuple[str, ...] = (named(table.columns[0]),) if table.unique else ()
        rest = ""
    else:
        columns = [f'"{START}" INTEGER', f'"{END}" INTEGER', *columns]
        unique, rest = table.unique, " WITHOUT ROWID" if table.unique else ""
    if unique:
        names = ", ".join(f'"{name}"' for name in unique)
        columns.append(f"{'UNIQUE' if isinstance(table, Nodes) else 'PRIMARY KEY'} ({names})")
    return f"CREATE TABLE IF NOT EXISTS {table.name} ({', '.join(columns)}){rest};"


def cell(value: object) -> str | int | None:
    """Return a value as it stands in the tables: the text that the CSV file has of it, but for whole numbers."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return value
    return joined(value) if isinstance(value, list | tuple) else repr(value)


def joined(values: Sequence[object]) -> str | None:
    """Return the list of ``values`` as one text, an empty one as nothing."""
    return LIST_DELIMITER.join([one if isinstance(one, str) else str(cell(one)) for one in values]) or None


def split(text: str | None) -> list[str]:
    """Return the list of which :func:`joined` made ``text``."""
    return text.split(LIST_DELIMITER) if text else []
