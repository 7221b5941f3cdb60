"""What was fetched of one edition of the FOON is kept for the next program, and nothing else is ever answered."""

from __future__ import annotations

import stat

import pytest
from kitchen_stories import SALAD, subgraph

from foon_kg.model import kept
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.graph.kept_rows import KeptRows
from foon_kg.store.graph.rows import Row
from foon_kg.store.graph.statements import Statement
from foon_kg.store.snapshot import Snapshot


class Counted(Row):
    name: str
    count: int


class Measured(Row):
    name: str
    weight: float


COUNTED = Statement("counted", Counted)
ROWS = [Counted("onion", 3), Counted("crème “fraîche”\n", 0)]


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "editions"


def test_rows_are_kept_for_one_edition_one_question_and_its_columns(folder):
    KeptRows("e1").write(COUNTED, {"names": ["onion"]}, ROWS)
    assert KeptRows("e1").read(COUNTED, {"names": ["onion"]}) == ROWS
    assert KeptRows("e1").read(COUNTED, {"names": ["egg"]}) is None
    assert KeptRows("e2").read(COUNTED, {"names": ["onion"]}) is None
    assert KeptRows("e1").read(Statement("counted", Measured), {"names": ["onion"]}) is None


def test_only_the_owner_may_read_what_is_kept(folder):
    KeptRows("e1").write(COUNTED, {}, ROWS)
    (file,) = folder.iterdir()
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


@pytest.mark.parametrize(
    "broken", [b"", b"{}", b"\xff\xfe", b"[[1]]\n[[1]]"], ids=["empty", "json", "no text", "other"]
)
def test_a_file_that_is_not_what_it_should_be_is_none_and_is_written_anew(folder, broken):
    KeptRows("e1").write(COUNTED, {}, ROWS)
    (file,) = folder.iterdir()
    file.write_bytes(broken)
    assert KeptRows("e1").read(COUNTED, {}) is None
    KeptRows("e1").write(COUNTED, {}, ROWS)
    assert KeptRows("e1").read(COUNTED, {}) == ROWS


def test_a_file_with_other_rows_than_were_written_is_none(folder):
    KeptRows("e1").write(COUNTED, {}, ROWS)
    (file,) = folder.iterdir()
    file.write_text(file.read_text(encoding="utf-8").replace('"onion",3', '"onion",4'), encoding="utf-8")
    assert KeptRows("e1").read(COUNTED, {}) is None


def test_where_nothing_can_be_written_nothing_is_kept(folder):
    folder.parent.write_text("a file, and no folder")
    KeptRows("e1").write(COUNTED, {}, ROWS)
    assert KeptRows("e1").read(COUNTED, {}) is None


def test_so_many_files_are_kept_and_no_more(folder, monkeypatch):
    monkeypatch.setattr(kept, "MOST_FILES", 3)
    for number in range(5):
        KeptRows(f"e{number}").write(COUNTED, {}, ROWS)
    assert len(list(folder.iterdir())) == 3
    assert KeptRows("e4").read(COUNTED, {}) == ROWS


def words_and_goals(graph):
    with graph.reading() as view:
        return view.vocabulary(), view.goals("salad"), view.round_trips


@pytest.mark.neo4j
def test_another_program_does_not_fetch_words_and_goals_again(folder, empty_graph):
    with Connection(empty_graph) as connection:
        load(connection, [subgraph("salad", "salad", *SALAD)])
    with Neo4jGraph(empty_graph) as graph:
        *fetched, trips = words_and_goals(graph)
    with Neo4jGraph(empty_graph) as graph:
        *kept, fewer = words_and_goals(graph)
    assert kept == fetched
    assert (trips, fewer) == (3, 1)


@pytest.mark.neo4j
def test_what_is_kept_of_an_older_edition_is_not_answered(folder, empty_graph):
    shorter = subgraph("salad", "salad", *SALAD[:3])
    with Connection(empty_graph) as connection:
        load(connection, [subgraph("salad", "salad", *SALAD)])
        with Neo4jGraph(empty_graph) as graph:
            words_and_goals(graph)
        load(connection, [shorter])
    with Neo4jGraph(empty_graph) as graph:
        words, *_ = words_and_goals(graph)
    assert words == Snapshot.of([shorter], Kitchen.default()).vocabulary()


@pytest.mark.neo4j
def test_what_was_fetched_while_somebody_wrote_is_not_kept(folder, empty_graph):
    with Connection(empty_graph) as connection, Neo4jGraph(empty_graph) as graph:
        load(connection, [subgraph("salad", "salad", *SALAD)])
        with graph.reading() as view:
            load(connection, [subgraph("salad", "salad", *SALAD[:3])])
            view.vocabulary()
    assert not folder.exists()
