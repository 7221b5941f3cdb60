"""Loading files again that are in the graph: nothing is parsed, and all is told as the first time."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import pytest
from kitchen_stories import SALAD, subgraph
from typer.testing import CliRunner

from foon_kg.cli import app, files_read
from foon_kg.foon import Foon
from foon_kg.loaders import ReadResult, paths, write_text
from foon_kg.model.errors import FoonError, UsageError

GOOD = write_text(subgraph("good", "salad", *SALAD))
ODD = "O\tonion\t0\nO\tonion\t1\n//\n" + GOOD.partition("//\n")[2].replace("onion", "qwxyz")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Two subgraphs, of which one has a unit without a motion and a food that no table has."""
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "cache"))
    (tmp_path / "foon").mkdir()
    (tmp_path / "foon" / "good.txt").write_text(GOOD, encoding="utf-8")
    (tmp_path / "foon" / "odd.txt").write_text(ODD, encoding="utf-8")
    return tmp_path / "foon"


@pytest.fixture
def parsed(monkeypatch):
    """The names of the files that were parsed."""
    names = []
    read = paths._read_file
    monkeypatch.setattr(paths, "_read_file", lambda path, reader: (names.append(path.name), read(path, reader))[1])
    return names


@pytest.fixture
def database(empty_graph, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))


def load(folder, *options):
    return CliRunner().invoke(app, ["load", "foon", str(folder), "--json", *map(str, options)])


def counts(answer):
    assert answer.exit_code == 0, answer.stderr
    found = json.loads(answer.stdout)
    return found["inserted"], found["unchanged"], found["replaced"]


@pytest.mark.neo4j
def test_files_that_are_in_the_graph_are_not_parsed_again_and_told_again(database, folder, parsed, tmp_path):
    reports = tmp_path / "first.jsonl", tmp_path / "second.jsonl"
    first = load(folder, "--bad-tolerance", 1, "--report", reports[0])
    assert (counts(first), parsed) == ((2, 0, 0), ["good.txt", "odd.txt"])
    parsed.clear()
    second = load(folder, "--bad-tolerance", 1, "--report", reports[1])
    assert (counts(second), parsed) == ((0, 2, 0), [])
    assert second.stderr.replace("second", "first") == first.stderr
    assert "qwxyz" in first.stderr
    assert reports[0].read_text(encoding="utf-8") == reports[1].read_text(encoding="utf-8")
    same = {"subgraphs", "units", "rejected_units"}
    told = [{name: json.loads(answer.stdout)[name] for name in same} for answer in (first, second)]
    assert told[0] == told[1]


@pytest.mark.neo4j
def test_a_file_that_changed_is_parsed_and_replaced(database, folder, parsed):
    load(folder, "--bad-tolerance", 1)
    parsed.clear()
    (folder / "odd.txt").write_text(GOOD, encoding="utf-8")
    assert counts(load(folder)) == (0, 1, 1)
    assert "odd.txt" in parsed


@pytest.mark.neo4j
def test_files_that_another_hand_took_out_or_changed_are_loaded_again(database, folder, parsed):
    load(folder, "--bad-tolerance", 1)
    CliRunner().invoke(app, ["remove", "good"])
    assert counts(load(folder, "--bad-tolerance", 1)) == (1, 1, 0)
    (folder / "odd.txt").write_text(GOOD, encoding="utf-8")
    load(folder / "odd.txt")
    (folder / "odd.txt").write_text(ODD, encoding="utf-8")
    parsed.clear()
    assert counts(load(folder, "--bad-tolerance", 1)) == (0, 1, 1)
    assert parsed


@pytest.mark.neo4j
def test_a_graph_written_with_another_kitchen_is_written_anew(database, folder, monkeypatch):
    load(folder, "--bad-tolerance", 1)
    CliRunner().invoke(app, ["cypher", "--write", "MATCH (f:Foon) SET f.kitchen = 'another'"])
    assert counts(load(folder, "--bad-tolerance", 1)) == (0, 2, 0)
    stats = CliRunner().invoke(app, ["similar", "shallot"])
    assert stats.exit_code == 0, stats.stderr


def test_too_much_that_is_unusable_is_refused_the_second_time_too(folder, monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "bolt://127.0.0.1:1")
    first, second = load(folder), load(folder)
    assert (first.exit_code, second.exit_code) == (1, 1)
    assert first.output == second.output
    assert "--bad-tolerance 1" in second.stderr


@pytest.mark.parametrize("changed", ["bytes", "name", "program", "own table"])
def test_what_was_kept_of_other_files_or_by_another_program_is_none(folder, tmp_path, monkeypatch, changed):
    load(folder, "--dry-run", "--bad-tolerance", 1)
    assert files_read.remembered(sorted(folder.iterdir())) is not None
    if changed == "bytes":
        (folder / "good.txt").write_text(GOOD + "\n", encoding="utf-8")
    elif changed == "name":
        (folder / "good.txt").rename(folder / "goon.txt")
    elif changed == "program":
        monkeypatch.setattr(files_read.kept, "code_key", lambda _: "another")
    else:
        (tmp_path / "own.toml").write_text("[kinds.vegetable]\nwords = ['qwxyz']\n", encoding="utf-8")
        monkeypatch.setenv("FOON_KG_FOODS", str(tmp_path / "own.toml"))
    assert files_read.remembered(sorted(folder.iterdir())) is None


@pytest.mark.neo4j
@pytest.mark.parametrize("most", [0, 1])
def test_files_of_many_units_are_loaded_from_a_temporary_file(database, folder, parsed, most, monkeypatch):
    monkeypatch.setattr(files_read.Spool.__init__, "__defaults__", (most,))
    assert (counts(load(folder, "--bad-tolerance", 1)), parsed) == ((2, 0, 0), ["good.txt", "odd.txt"])
    with Foon.connect() as foon:
        assert {one.name for one in foon.snapshot().subgraphs} == {"good", "odd"}


def test_a_spool_gives_back_what_came_in_its_order_from_memory_and_file():
    results = [ReadResult(name, subgraph(name, "salad", *SALAD)) for name in ("c", "a", "b")]
    with files_read.Spool(most=1) as spool:
        assert spool.is_empty
        for result in (*results, ReadResult("bad", None)):
            spool.add(result)
        assert not spool.is_empty
        assert [list(spool), list(spool)] == [[result.subgraph for result in results]] * 2


def test_a_full_folder_of_temporary_files_is_told(monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", "/dev/full")
    with files_read.Spool(most=0) as spool, pytest.raises(UsageError, match="cannot be written"):
        spool.add(ReadResult("a", subgraph("a", "salad", *SALAD)))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device here is a full disk")
def test_a_disk_that_is_full_is_told_while_files_are_read(monkeypatch):
    monkeypatch.setattr(tempfile, "TemporaryFile", lambda **_: Path("/dev/full").open("r+b"))  # noqa: SIM115
    with pytest.raises(FoonError, match="no space is left there"), files_read.Spool(most=0) as spool:
        spool.add(ReadResult("a", subgraph("a", "salad", *SALAD)))
