"""``foon diff`` and ``foon remove`` on a real graph: the same answer as in memory, and as loading and removing give."""

from __future__ import annotations

import json

import pytest
from foons import foons, subgraphs_named
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model.errors import UsageError
from foon_kg.plans.difference import differences as in_memory
from foon_kg.store.graph import Connection, load, remove
from foon_kg.store.graph.differences import differences, losses

pytestmark = pytest.mark.neo4j


@pytest.fixture
def connection(empty_graph, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    with Connection(empty_graph) as connection:
        yield connection


def unit_keys(connection):
    with connection.session() as session:
        return set(session.run("MATCH (m:Motion) RETURN m.key AS key").value("key"))


def names_of(connection):
    with connection.session() as session:
        return session.run("MATCH (v:Video) RETURN v.name AS name").value("name")


def foon(*words):
    return CliRunner().invoke(app, list(map(str, words)))


@settings(max_examples=8, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(foons(), st.sampled_from(("a", "d")).flatmap(subgraphs_named))
def test_neo4j_and_memory_tell_the_same_and_loading_does_it(connection, videos, video):
    load(connection, videos)
    remove(connection, set(names_of(connection)) - {one.name for one in videos})
    (told,) = differences(connection, [video])
    assert (told,) == in_memory([video], videos)
    before = unit_keys(connection)
    load(connection, [video])
    after = unit_keys(connection)
    assert {unit.key for unit in told.added} == after - before
    assert {unit.key for unit in told.dropped} == before - after


def test_removing_takes_what_was_told_and_leaves_what_others_show(connection):
    load(connection, [result.subgraph for result in read_paths([demo_folder()])])
    (told,) = losses(connection, ["greek_salad"])
    before = unit_keys(connection)
    answer = json.loads(foon("remove", "greek_salad", "--json").stdout)
    assert before - unit_keys(connection) == {unit.key for unit in told.dropped}
    assert {one.unit.key for one in told.left} <= unit_keys(connection)
    assert len(answer[0]["dropped"]) == len(told.dropped) > 0
    assert len(answer[0]["left"]) == len(told.left) > 0


def test_a_dry_run_and_a_diff_change_nothing(connection):
    subgraphs = [result.subgraph for result in read_paths([demo_folder()])]
    load(connection, subgraphs)
    before = unit_keys(connection)
    assert foon("remove", "greek_salad", "--dry-run").exit_code == 0
    assert foon("diff", demo_folder() / "greek_salad.txt", "--units").exit_code == 0
    assert unit_keys(connection) == before


def test_one_unknown_video_and_none_is_removed(connection):
    load(connection, [result.subgraph for result in read_paths([demo_folder() / "greek_salad.txt"])])
    before = unit_keys(connection)
    answer = foon("remove", "greek_salad", "nowhere")
    assert answer.exit_code == 2
    assert "nowhere" in answer.stderr
    assert unit_keys(connection) == before
    with pytest.raises(UsageError, match="nowhere"):
        losses(connection, ["nowhere"])


def test_a_diff_against_files_needs_no_database(tmp_path):
    text = (demo_folder() / "greek_salad.txt").read_text(encoding="utf-8")
    (tmp_path / "leek_salad.txt").write_text(text.replace("onion", "leek"), encoding="utf-8")
    answer = json.loads(foon("diff", tmp_path, "--files", demo_folder(), "--json").stdout)
    assert answer[0]["status"] == "new"
    assert answer[0]["new_labels"] == ["leek"]
    shown = foon("diff", tmp_path, "--files", demo_folder(), "--units").stdout
    assert "and" in shown
    assert "leek_salad (new)" in shown


def test_a_plain_table_of_a_video_can_be_compared_as_well(tmp_path):
    table = tmp_path / "leek.csv"
    table.write_text("start,end,motion,inputs,outputs\n,,chop,leek (whole); knife,leek (chopped)\n", encoding="utf-8")
    answer = json.loads(foon("diff", table, "--files", demo_folder(), "--json").stdout)
    assert [(one["video"], one["status"], one["new_labels"]) for one in answer] == [("leek", "new", ["leek"])]
