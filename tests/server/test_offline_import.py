"""``foon load foon --offline``: what neo4j-admin imports is the graph that a load writes, and nothing is lost by it."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from campaign.whole_graph import whole_graph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model.errors import UsageError
from foon_kg.store.graph import Connection, load
from foon_kg.store.offline.importing import _refuse_what_was_stored_meanwhile, _sweep
from foon_kg.store.server import connection_settings, start, stop

VIDEOS = ("greek_salad.txt", "spanish_omelette.txt", "garden_salad.txt")


RECIPES = [
    {"id": "1", "title": "Greek Salad", "ingredients": ["2 tomatoes, chopped", "1 cucumber, sliced", "120 g feta"]},
    {"id": "2", "title": "Jicama \u201cBowl\u201d", "ingredients": ["1 jicama, \tdiced", '"???"\x1f!\r\n, !']},
    {"id": "3", "title": "Onion Soup with Bread", "ingredients": ["3 onions, sliced", "1 jicama"]},
]
"""Also what no table likes to hold."""

COLLECTED = len(RECIPES)
NAMED = ("uri", "user", "password", "database")


def run(*words):
    return CliRunner().invoke(app, ["load", "foon", *map(str, words), "--json"])


@pytest.mark.neo4j
@pytest.mark.slow
def test_an_import_is_what_a_load_writes_and_takes_the_place_of_nothing_unasked(
    place, connection, empty_graph, monkeypatch, tmp_path
):
    files = [demo_folder() / name for name in VIDEOS]
    load(connection, [result.subgraph for result in read_paths(files)])
    collection = tmp_path / "recipes.json"
    collection.write_text(json.dumps(RECIPES), encoding="utf-8")
    for name in NAMED:
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    brought = CliRunner().invoke(app, ["load", "recipes", str(collection), "--json"])
    assert json.loads(brought.stdout)["inserted"] == COLLECTED, brought.output
    loaded = whole_graph(connection)
    for name in NAMED:
        monkeypatch.delenv(f"NEO4J_{name.upper()}")

    done = run(*files, "--offline", "--recipes", collection)
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["inserted"] == len(VIDEOS)
    assert json.loads(done.stdout)["inserted_recipes"] == COLLECTED
    assert not (place.root / "import").exists()
    with Connection(connection_settings()) as imported:
        assert whole_graph(imported) == loaded

        refused = run(files[0], "--offline")
        assert refused.exit_code == 2
        assert "--replace" in refused.output
        again = run(*files)
        assert json.loads(again.stdout)["unchanged"] == len(VIDEOS)
        assert whole_graph(imported) == loaded

    broken = tmp_path / "broken.txt"
    broken.write_text("O\t1\tonion\n//\n", encoding="utf-8")
    rejected = run(broken, "--offline", "--replace", "--bad-tolerance", "0")
    assert rejected.exit_code == 1, rejected.output
    assert not (place.root / "import").exists()
    with Connection(connection_settings()) as kept:
        assert whole_graph(kept) == loaded


@pytest.mark.neo4j
@pytest.mark.slow
def test_what_others_stored_meanwhile_is_seen_of_a_server_that_has_ended_since(place, ask):
    ask(start(), "CREATE (:Other)")
    stop()
    with place.locked(), pytest.raises(UsageError, match="another program stored a graph"):
        _refuse_what_was_stored_meanwhile(place, print)
    stop()


def test_what_a_killed_import_has_left_at_work_is_ended(tmp_path):
    folder = tmp_path / "import"
    folder.mkdir()
    sleeping = "import sys, time; print(flush=True); time.sleep(600)"

    def java(place):
        words = ["java", "-c", sleeping, f"@{place}/home/run/admin.args"]
        started = subprocess.Popen(words, executable=sys.executable, stdout=subprocess.PIPE)
        started.stdout.readline()
        return started

    left, other = java(folder), java(tmp_path / "import-of-others")
    try:
        _sweep(folder)
        assert left.poll() is not None
        assert other.poll() is None
        assert not folder.exists()
    finally:
        for process in (left, other):
            process.kill()
            process.communicate()


def test_a_dry_run_tells_of_the_recipes_too(tmp_path):
    collection = tmp_path / "recipes.json"
    collection.write_text(json.dumps(RECIPES), encoding="utf-8")
    told = run(demo_folder() / VIDEOS[0], "--offline", "--dry-run", "--recipes", collection)
    assert told.exit_code == 0, told.output
    counts = json.loads(told.stdout)
    assert (counts["subgraphs"], counts["recipes"], counts["rejected_recipes"]) == (1, COLLECTED, 0)
    (empty := tmp_path / "none").mkdir()
    assert run(demo_folder() / VIDEOS[0], "--offline", "--dry-run", "--recipes", empty).exit_code == 2


def test_another_neo4j_is_not_imported_into(monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "bolt://db.example.org:7687")
    refused = run(demo_folder(), "--offline")
    assert refused.exit_code == 2
    assert "db.example.org" in refused.output


@pytest.mark.parametrize("options", [["--replace"], ["--offline", "--check"], ["--recipes", "recipes.csv"]])
def test_options_that_do_not_go_together_are_refused(options):
    assert run(demo_folder(), *options).exit_code == 2
