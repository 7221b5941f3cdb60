"""``foon load``, ``foon stats`` and ``foon cypher`` as a person uses them."""

from __future__ import annotations

import csv
import io
import json

import pytest
from kitchen_stories import SALAD, subgraph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import write_text

GOOD = write_text(subgraph("good", "salad", *SALAD))
UNIT_WITHOUT_MOTION = "O\tonion\t0\nO\tonion\t1\n//\n"


@pytest.fixture
def folder(tmp_path):
    """Two subgraphs, one of which has a unit that cannot be used."""
    (tmp_path / "good.txt").write_text(GOOD, encoding="utf-8")
    (tmp_path / "bad.txt").write_text(UNIT_WITHOUT_MOTION + GOOD.partition("//\n")[2], encoding="utf-8")
    return tmp_path


@pytest.fixture
def database(empty_graph, monkeypatch):
    """Make the commands use the database of the tests."""
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))


def foon(*words):
    return CliRunner().invoke(app, list(map(str, words)))


def count_of_videos():
    return json.loads(foon("cypher", "MATCH (v:Video) RETURN count(v) AS n", "--json").stdout)[0]["n"]


@pytest.mark.neo4j
def test_more_unusable_units_than_allowed_load_nothing_and_say_how_to_load_the_rest(database, folder):
    answer = foon("load", "foon", folder)
    assert answer.exit_code == 1
    assert "bad.txt" in answer.stderr
    assert "--bad-tolerance 1" in answer.stderr
    assert count_of_videos() == 0


@pytest.mark.neo4j
def test_the_counts_tell_new_known_and_changed_videos(database, folder):
    first = json.loads(foon("load", "foon", folder, "--bad-tolerance", 1, "--json").stdout)
    assert (first["inserted"], first["unchanged"], first["replaced"], first["rejected_units"]) == (2, 0, 0, 1)
    (folder / "bad.txt").write_text(GOOD.partition("//\n")[2], encoding="utf-8")
    (folder / "good.txt").write_text(GOOD.rpartition("//\n")[0].rpartition("//\n")[0], encoding="utf-8")
    second = json.loads(foon("load", "foon", folder, "--json").stdout)
    assert (second["inserted"], second["unchanged"], second["replaced"], second["rejected_units"]) == (0, 1, 1, 0)


def test_a_dry_run_reads_reports_and_needs_no_database(folder, monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "bolt://127.0.0.1:1")
    report = folder / "notices.jsonl"
    answer = foon("load", "foon", folder, "--dry-run", "--bad-tolerance", 1, "--report", report, "--json")
    assert answer.exit_code == 0
    assert json.loads(answer.stdout)["subgraphs"] == 2
    (notice,) = [json.loads(line) for line in report.read_text(encoding="utf-8").splitlines()]
    assert (notice["kind"], notice["severity"], notice["line"]) == ("unit-without-motion", "rejected", 3)


def test_a_path_that_is_not_there_is_said_to_be(tmp_path):
    answer = foon("load", "foon", tmp_path / "lost.txt")
    assert answer.exit_code == 1
    assert "lost.txt" in answer.stderr


def test_a_report_that_cannot_be_written_is_wrong_usage(folder):
    answer = foon("load", "foon", folder, "--dry-run", "--report", folder / "no" / "where.jsonl")
    assert answer.exit_code == 2
    assert "where.jsonl" in answer.stderr


@pytest.mark.neo4j
def test_the_figures_of_the_graph_are_those_of_its_files(database, folder):
    foon("load", "foon", folder, "--bad-tolerance", 1)
    of_graph, of_files = foon("stats", "--json"), foon("stats", "--files", folder, "--json")
    assert json.loads(of_graph.stdout) == json.loads(of_files.stdout)


@pytest.mark.neo4j
def test_the_equivalents_of_the_graph_are_those_of_its_files(database, folder):
    foon("load", "foon", folder, "--bad-tolerance", 1)
    of_graph = foon("similar", "shallot", "qwxyz", "--json")
    of_files = foon("similar", "shallot", "qwxyz", "--json", "--files", folder)
    assert of_graph.stdout == of_files.stdout
    assert json.loads(of_graph.stdout.splitlines()[0])["nearest"][0]["name"] == "onion"


def test_stats_count_each_distinct_thing_once(tmp_path):
    (tmp_path / "one.txt").write_text(GOOD, encoding="utf-8")
    (tmp_path / "two.txt").write_text(GOOD, encoding="utf-8")
    figures = json.loads(foon("stats", "--files", tmp_path, "--json").stdout)
    assert (figures["videos"], figures["units"], figures["goals"]) == (2, len(SALAD), {"salad": 1})
    assert next(iter(figures["most_used_motions"].items())) == ("pick-and-place", 2)
    assert figures["most_made_states"]["chopped"] == "chop, 1 of 1 units"


def test_stats_are_readable(tmp_path):
    (tmp_path / "one.txt").write_text(GOOD, encoding="utf-8")
    answer = foon("stats", "--files", tmp_path)
    assert answer.exit_code == 0
    assert "object nodes" in answer.stdout
    assert "pick-and-place" in answer.stdout


@pytest.mark.neo4j
def test_cypher_answers_as_json_csv_or_table(database):
    query = "UNWIND [1, 2] AS n RETURN n, $food AS food, [n] AS list, null AS nothing"
    rows = [{"n": n, "food": "onion", "list": [n], "nothing": None} for n in (1, 2)]
    assert json.loads(foon("cypher", query, "-P", "food=onion", "--json").stdout) == rows
    table = foon("cypher", query, "-P", "food=onion", "--csv").stdout
    assert list(csv.reader(io.StringIO(table))) == [
        ["n", "food", "list", "nothing"],
        *([str(n), "onion", f"[{n}]", ""] for n in (1, 2)),
    ]
    assert "onion" in foon("cypher", query, "-P", "food=onion").stdout


@pytest.mark.neo4j
def test_cypher_prints_lists_as_words_numbers_to_the_right_and_says_where_nothing_is_found(database):
    table = foon("cypher", "UNWIND [1, 10] AS n RETURN n AS count, ['knife', 'onion'] AS inputs").stdout
    assert "│     1 │ knife, onion │" in table
    nothing = foon("cypher", "MATCH (n:Nothing) RETURN n")
    assert nothing.exit_code == 0
    assert "Nothing in this graph answers that." in nothing.stderr


@pytest.mark.neo4j
def test_a_query_of_ours_that_nothing_answers_says_which_name_is_misspelt(database, monkeypatch):
    foon("load", "foon", demo_folder())

    def told(name, **given):
        answer = foon("cypher", "--name", name, *(word for key in given for word in ("-P", f"{key}={given[key]}")))
        assert answer.exit_code == 0, answer.stderr
        return answer.stderr

    assert "It has no name “onoin”: did you mean “onion”?" in told("states_of_food", food="onoin")
    assert "did you mean “onion”?" in told("states_of_food", food="Onion")
    assert "did you mean “greek_salad”?" in told("steps_of_video", video="greek_sald")
    assert "did you mean “oil”?" in told("where_kind_joins", kind="oill")
    assert "“qqqq”: foon cypher --name names shows them all." in told("dishes_with_foods", foods="onion,qqqq")
    assert "It has no name" not in told("motion_on_food", food="onion", motion="squeeze")
    removed = foon("remove", "greek_sald")
    assert (removed.exit_code, "Did you mean greek_salad" in removed.stderr) == (2, True)
    monkeypatch.setattr("foon_kg.cli.cypher.MOST_NAMES", 1)  # of more names it is not known what has none
    assert "It has no name" not in told("states_of_food", food="onoin")


@pytest.mark.neo4j
def test_cypher_says_that_there_are_more_rows(database):
    answer = foon("cypher", "UNWIND range(1, 9) AS n RETURN n", "--limit", 2, "--json")
    assert json.loads(answer.stdout) == [{"n": 1}, {"n": 2}]
    assert "--limit" in answer.stderr


@pytest.mark.neo4j
def test_cypher_writes_only_with_write(database):
    refused = foon("cypher", "CREATE (n:Note {text: 'x'}) RETURN n")
    assert refused.exit_code == 1
    assert "--write" in refused.stderr
    made = foon("cypher", "CREATE (n:Note {text: 'x'}) RETURN n", "--write", "--json")
    assert json.loads(made.stdout) == [{"n": {"labels": ["Note"], "properties": {"text": "x"}}}]
    assert "1 nodes created" in made.stderr


def test_a_parameter_without_a_name_is_wrong_usage():
    answer = foon("cypher", "RETURN 1", "--param", "onion")
    assert answer.exit_code == 2
    assert "--param" in answer.stderr


@pytest.mark.neo4j
def test_a_text_that_a_spreadsheet_would_take_for_a_formula_is_none_in_csv(database, folder):
    foon("load", "foon", folder, "--bad-tolerance", 1)
    answer = foon("cypher", "RETURN '=1+1' AS sum, '-2' AS less, 'onion' AS food", "--csv")
    assert list(csv.reader(io.StringIO(answer.stdout)))[1] == ["'=1+1", "-2", "onion"]
