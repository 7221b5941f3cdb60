"""What is staged for an import does not depend on the parts in which it was staged, and leads to what is there."""

from __future__ import annotations

import pytest
from foons import foons
from hypothesis import given, settings
from kitchen_stories import SALAD, subgraph

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model.errors import ReadError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.statements import ATTESTED
from foon_kg.store.offline.csv_files import write_csv_files
from foon_kg.store.offline.staged import Staged
from foon_kg.store.offline.staging import Stager
from foon_kg.store.offline.tables import EDGES, END, NODES, START, named

KITCHEN = Kitchen.default()


def staged_in(path, parts):
    """Return what the tables say once ``parts`` were staged one after another."""
    with Staged(path, KITCHEN) as staged:
        stager = Stager(staged, KITCHEN)
        for part in parts:
            stager.stage(part)
        staged.finish()
        return stager.videos, contents(staged.database)


def contents(database):
    """Return the rows of all tables; nodes without a key are told by what they say."""
    named_by, found = {}, {}
    for table in NODES:
        rows = database.execute(f"SELECT * FROM {table.name}").fetchall()
        named_by[table.label] = {row[0]: row[1] if table.unique else row[1:] for row in rows}
        found[table.name] = sorted(repr(row[1:]) for row in rows)
    for table in EDGES:
        columns = "".join(f', "{named(column)}"' for column in table.columns)
        rows = database.execute(f'SELECT "{START}", "{END}"{columns} FROM {table.name}')
        starts, ends = named_by[table.start], named_by[table.end]
        found[table.name] = sorted(repr((starts[start], ends[end], *more)) for start, end, *more in rows)
    return found


@settings(max_examples=20, deadline=None)
@given(foons())
def test_in_parts_or_at_once_the_same_is_staged(tmp_path_factory, subgraphs):
    folder = tmp_path_factory.mktemp("staged")
    at_once = staged_in(folder / "once.sqlite", [subgraphs])
    one_by_one = staged_in(folder / "parts.sqlite", [[one] for one in subgraphs])
    assert at_once == one_by_one


def test_a_video_is_staged_once_and_two_of_one_name_are_refused(tmp_path):
    salad, shorter = subgraph("salad", "salad", *SALAD), subgraph("salad", "salad", *SALAD[:3])
    once = staged_in(tmp_path / "once.sqlite", [[salad]])
    assert once == staged_in(tmp_path / "twice.sqlite", [[salad, salad], [salad]])
    assert once[0] == 1
    with pytest.raises(ReadError, match="two different subgraphs"):
        staged_in(tmp_path / "other.sqlite", [[salad, shorter]])


def test_the_files_are_named_by_the_arguments_and_hold_as_many_rows_as_the_tables(tmp_path):
    subgraphs = [result.subgraph for result in read_paths([demo_folder()])]
    with Staged(tmp_path / "staged.sqlite", KITCHEN) as staged:
        Stager(staged, KITCHEN).stage(subgraphs)
        staged.finish()
        arguments = write_csv_files(staged, tmp_path, KITCHEN)
        units = {annotation.unit.key for subgraph in subgraphs for annotation in subgraph.annotations}
        (row,) = staged.ask(ATTESTED, keys=sorted(units))
        assert {unit for unit, *_ in row.attested} == units
    paths = {argument.rpartition("=")[2] for argument in arguments if argument.endswith(".csv")}
    assert paths == {str(path) for path in tmp_path.glob("*.csv") if path.read_text(encoding="utf-8").count("\n") > 1}
    motions = (tmp_path / "Motion.csv").read_text(encoding="utf-8").splitlines()
    assert len(motions) == len(units) + 1
    assert motions[0] == ":ID(Motion),key:string,verb:string,accepts_any:boolean"
