"""The staged tables as CSV files, and the arguments with which ``neo4j-admin database import`` reads them."""

from __future__ import annotations

import sqlite3
from pathlib import Path

from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.disk import explain_os_error
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.schema import kitchen_key
from foon_kg.store.offline.staged import Staged
from foon_kg.store.offline.tables import EDGES, END, FORMAT, NODES, NUMBER, START, Edges, Nodes, kind_of, named

ROWS_AT_ONCE = 10_000

_RECORD = ("name:string", "version:long", "kitchen:string", "words:string", "methods:string", "writes:long",
           "edition:string", "all_placed:boolean", "recipes:long", "sure_recipes:long")  # fmt: skip


def write_csv_files(staged: Staged, folder: Path, kitchen: Kitchen) -> list[str]:
    """Write a file for each table of what is ``staged`` into ``folder``, and return the arguments of the import.

    They name the files. ``kitchen`` tells foods from utensils.
    """
    arguments = [*FORMAT, "--id-type=integer"]
    with explain_os_error(f"cannot write to {folder}"):
        for table in (*NODES, *EDGES):
            path = folder / f"{table.name}.csv"
            if _write(staged.database, table, path):
                option = f"nodes={table.label}" if isinstance(table, Nodes) else f"relationships={table.type}"
                arguments.append(f"--{option}={path}")
        arguments += _write_record(staged, folder, kitchen)
    return arguments


def _write(database: sqlite3.Connection, table: Nodes | Edges, path: Path) -> int:
    """Write one table, a line a row; return how many there are. SQLite makes the lines."""
    header = [*table.ids, *table.columns, *([":LABEL"] if isinstance(table, Nodes) and table.labelled else [])]
    cells = [NUMBER] if isinstance(table, Nodes) else [f'"{START}"', f'"{END}"']
    cells += [_cell(named(column), kind_of(column)) for column in table.columns]
    cells += [_cell("_label", "string")] if isinstance(table, Nodes) and table.labelled else []
    line = " || ',' || ".join(cells)
    rows = database.execute(f"SELECT {line} FROM {table.name}")
    count = 0
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(",".join(header) + "\n")
        while lines := rows.fetchmany(ROWS_AT_ONCE):
            stream.writelines(f"{line}\n" for (line,) in lines)
            count += len(lines)
    return count


def _cell(name: str, kind: str) -> str:
    """Return the expression for a cell: texts and lists in quotes, nothing where there is no value."""
    if kind == "string" or kind.endswith("[]"):
        return f"""coalesce('"' || replace("{name}", '"', '""') || '"', '')"""
    return f"coalesce(\"{name}\", '')"


def _write_record(staged: Staged, folder: Path, kitchen: Kitchen) -> list[str]:
    """Write the record of the whole FOON, to which all labels lead."""
    database = staged.database
    placeless = "SELECT count(*) FROM Ingredient WHERE vector IS NULL AND singular IS NOT NULL"
    (missing,) = database.execute(placeless).fetchone()
    (edition,) = database.execute("SELECT lower(hex(randomblob(16)))").fetchone()
    words = [kitchen_key(kitchen), word_lists_key(), methods_key()]
    recipes = ["" if count is None else str(count) for count in staged.recipes or (None, None)]
    row = ["0", '"foon-kg"', "0", *(f'"{word}"' for word in words), "1", f'"{edition}"', str(not missing).lower()]
    row += recipes
    record, labels = folder / "Foon.csv", folder / "LABEL_OF.csv"
    record.write_text(",".join((":ID(Foon)", *_RECORD)) + "\n" + ",".join(row) + "\n", encoding="utf-8")
    with labels.open("w", encoding="utf-8") as stream:
        stream.write(":START_ID(Label),:END_ID(Foon)\n")
        stream.writelines(f"{number},0\n" for (number,) in database.execute(f"SELECT {NUMBER} FROM Label"))
    return [f"--nodes=Foon={record}", f"--relationships=LABEL_OF={labels}"]
