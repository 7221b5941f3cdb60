"""A whole collection planned into one file: the same bytes however often it was stopped, compressed by its ending."""

from __future__ import annotations

import gzip
import json
import signal
import subprocess
import sys
from contextlib import contextmanager, suppress

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app, blocks
from foon_kg.cli.blocks import adding, whole_blocks
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.language.collection import CollectionReader
from foon_kg.model.collected import CollectedLine, CollectedRecipe
from foon_kg.model.errors import UsageError
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.recipes import load_recipes, prepare_for_recipes, recipes_after, recipes_until

LINES = 8
FOON = [sys.executable, "-c", f"from foon_kg.cli import blocks, main; blocks.LINES = {LINES}; main()"]
FOODS = ("onion", "tomato", "cucumber", "carrot", "olive oil")
COUNT = 125
MANY = 600
ENDINGS = (".jsonl", ".jsonl.gz", ".jsonl.zst")


@pytest.fixture(autouse=True)
def short_blocks(monkeypatch):
    monkeypatch.setattr(blocks, "LINES", LINES)


def recipe(number):
    foods = [FOODS[number % 5], FOODS[(number // 5) % 5]] if number % 9 else ["qwxyz"]
    lines = tuple(CollectedLine(f"1 {food}, chopped", food, "", "1", "") for food in foods)
    return CollectedRecipe(f"r{number:03}", "Green Salad" if number % 7 else "Hot Soup", lines, f"element {number}")


def bring(connection, numbers):
    load_recipes(connection, map(recipe, numbers), CollectionReader({}).understand)


@pytest.fixture
def connection(empty_graph, monkeypatch):
    """The demo's FOON with many recipes."""
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    with Connection(empty_graph) as connection:
        load(connection, demo_subgraphs())
        prepare_for_recipes(connection)
        bring(connection, range(COUNT))
        yield connection


def plan(*options):
    return CliRunner().invoke(app, ["plan", *map(str, options)])


def unpacked(path):
    return b"".join(content for content, _ in whole_blocks(path))


def ending(name):
    if name.endswith(".zst"):
        pytest.importorskip("zstandard", reason="zstandard is not installed")
    return name


@pytest.mark.neo4j
@pytest.mark.slow
def test_a_collection_is_planned_in_its_order_and_a_killed_run_goes_on_to_the_same_bytes(connection, tmp_path):
    whole = tmp_path / "whole.jsonl.gz"
    answer = plan("--recipes", "all", "--output", whole, "--jobs", 1)
    assert answer.exit_code == 3, answer.stderr
    values = [json.loads(line) for line in gzip.decompress(whole.read_bytes()).splitlines()]
    assert [value["recipe"]["id"] for value in values] == [f"r{number:03}" for number in range(COUNT)]
    assert 0 < sum("error" in value for value in values) < COUNT / 2
    output = tmp_path / "plans.jsonl.gz"
    command = [*FOON, "plan", "--recipes", "all", "--output", str(output), "--jobs", "2"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, cwd=tmp_path) as process:
        while not (output.exists() and output.stat().st_size):
            with suppress(subprocess.TimeoutExpired):
                assert process.wait(0.05) is None, process.stderr.read()  # it ended by itself
        process.send_signal(signal.SIGKILL)
        process.wait()
    written = output.read_bytes()
    assert written
    assert len(written) < len(whole.read_bytes())
    assert whole.read_bytes().startswith(written)
    output.write_bytes(written + whole.read_bytes()[len(written) : len(written) + 20])  # killed while it wrote
    again = plan("--recipes", "all", "--output", output)
    assert (again.exit_code, output.read_bytes()) == (3, whole.read_bytes())
    assert f"of {COUNT} answers already" in again.stderr


@pytest.mark.neo4j
@pytest.mark.parametrize("bound", ["WHOLE", "UNITS_A_RECIPE"])
def test_of_a_large_foon_each_process_asks_for_parts_and_plans_the_same(connection, tmp_path, monkeypatch, bound):
    whole, parts = tmp_path / "whole.jsonl", tmp_path / "parts.jsonl"
    plan("--recipes", "soup", "--output", whole, "--jobs", 1)
    monkeypatch.setattr(f"foon_kg.foon.answering.{bound}", 0)
    monkeypatch.setattr("foon_kg.store.graph.Neo4jGraph.snapshot", None)  # nobody reads the whole
    answer = plan("--recipes", "soup", "--output", parts, "--jobs", 1)
    assert parts.read_bytes() == whole.read_bytes(), answer.stderr
    parts.unlink()
    plan("--recipes", "soup", "--output", parts, "--jobs", 2)
    assert parts.read_bytes() == whole.read_bytes()


@pytest.mark.neo4j
def test_what_another_program_learnt_is_read_whole(connection, tmp_path, monkeypatch):
    """In parts nothing could be asked of it."""
    own, others = tmp_path / "own.jsonl", tmp_path / "others.jsonl"
    plan("--recipes", "soup", "--output", own, "--jobs", 1)
    monkeypatch.setattr("foon_kg.foon.answering.UNITS_A_RECIPE", 0)
    monkeypatch.setattr("foon_kg.store.graph.reading.MOST_LEARNT_ANEW", 0)
    ask_freely(connection, "MATCH (f:Foon) SET f.methods = 'others'", write=True)
    answer = plan("--recipes", "soup", "--output", others, "--jobs", 1)
    assert others.read_bytes() == own.read_bytes(), answer.stderr


@pytest.mark.neo4j
def test_a_file_of_another_kitchen_or_other_wishes_is_refused_by_name(connection, tmp_path):
    output = tmp_path / "plans.jsonl"
    plan("--recipes", "soup", "--output", output, "--jobs", 1)
    written = output.read_bytes()
    assert plan("--recipes", "soup", "--output", output).exit_code in {0, 3}
    last = [line for line in map(json.loads, written.splitlines()) if "units" in line][-1]["recipe"]
    answer = plan("--recipes", "soup", "--avoid", last["ingredients"][0]["object"], "--output", output)
    told = f"has another tree of {last['id']} than this FOON, kitchen and wishes give"
    assert (answer.exit_code, told in " ".join(answer.stderr.split())) == (2, True), answer.stderr
    assert output.read_bytes() == written


@contextmanager
def cluster(folder):
    """A scheduler and two workers, each a process as on a machine of its own; its address and the workers."""
    distributed = pytest.importorskip("distributed", reason="the extra “cluster” is not installed")
    told = folder / "scheduler.json"
    rest = ["--host", "127.0.0.1", "--no-dashboard", "--scheduler-file", str(told)]
    worker = ["worker", *rest, "--nthreads", "1", "--no-nanny"]
    processes = [
        subprocess.Popen([sys.executable, "-m", "dask", *words], cwd=folder, stderr=subprocess.DEVNULL)
        for words in (["scheduler", "--port", "0", *rest], worker, worker)
    ]
    try:
        with distributed.Client(scheduler_file=str(told), set_as_default=False) as client:
            client.wait_for_workers(2)
            address = client.scheduler.address
        yield address, processes[1:]
    finally:
        for process in processes:
            process.kill()
            process.wait()


@pytest.mark.campaign
@pytest.mark.neo4j
@pytest.mark.slow
def test_a_cluster_that_loses_a_worker_in_the_middle_writes_the_same_bytes(connection, tmp_path):
    bring(connection, range(COUNT, MANY))
    here, there = tmp_path / "here.jsonl.gz", tmp_path / "there.jsonl.gz"
    assert plan("--recipes", "all", "--output", here, "--jobs", 1).exit_code == 3
    with cluster(tmp_path) as (address, workers):
        command = [*FOON, "plan", "--recipes", "all", "--output", str(there), "--dask", address]
        with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, cwd=tmp_path) as process:
            while not (there.exists() and there.stat().st_size):
                with suppress(subprocess.TimeoutExpired):
                    assert process.wait(0.05) is None, process.stderr.read()
            for worker in workers:
                worker.send_signal(signal.SIGSTOP)  # both are in the middle of it
            assert all(worker.poll() is None for worker in workers)
            assert there.stat().st_size < here.stat().st_size
            workers[0].kill()
            workers[1].send_signal(signal.SIGCONT)
            told = process.stderr.read()
            assert process.wait() == 3, told
    assert there.read_bytes() == here.read_bytes()


@pytest.mark.neo4j
@pytest.mark.parametrize("name", ENDINGS[1:2])
def test_a_file_goes_on_when_more_recipes_are_there_as_if_they_always_had_been(connection, tmp_path, name):
    first, whole = tmp_path / ending(f"a{name}"), tmp_path / f"b{name}"
    plan("--recipes", "soup", "--output", first, "--jobs", 1)
    there = unpacked(first)
    count = len(there.splitlines())
    again = plan("--recipes", "soup", "--output", first, "--jobs", 1)
    assert again.stderr == f"{first} has {count} of {count} answers already\n"
    bring(connection, range(COUNT, COUNT + 20))
    plan("--recipes", "soup", "--output", first, "--jobs", 1)
    plan("--recipes", "soup", "--output", whole, "--jobs", 1)
    assert unpacked(first).startswith(there)
    assert first.read_bytes() == whole.read_bytes()
    assert {json.loads(line)["recipe"]["dish_type"] for line in unpacked(first).splitlines()} == {"soup"}


@pytest.mark.neo4j
def test_a_file_of_another_collection_is_refused_and_left_alone(connection, tmp_path):
    output = tmp_path / "plans.jsonl"
    plan("--recipes", "soup", "--output", output, "--jobs", 1)
    before = output.read_bytes()
    answer = plan("--recipes", "all", "--output", output)
    assert answer.exit_code == 2
    assert "another collection" in answer.stderr
    assert output.read_bytes() == before
    output.write_bytes(b"notes\n")
    assert plan("--recipes", "all", "--output", output).exit_code == 2
    assert output.read_bytes() == b"notes\n"


@pytest.mark.neo4j
def test_recipes_are_read_behind_an_id_in_their_order(connection, monkeypatch):
    monkeypatch.setattr("foon_kg.store.graph.recipes.RECIPES_PER_TRANSACTION", 50)
    ids = [one.id for one in recipes_after(connection)]
    assert ids == [f"r{number:03}" for number in range(COUNT)]
    assert [one.id for one in recipes_after(connection, "r114")] == ids[115:]
    soups = [one.id for one in recipes_after(connection, "", "soup")]
    assert soups == ids[::7]
    assert recipes_until(connection, soups[2], "soup") == (len(soups), 3)
    assert recipes_until(connection, "") == (COUNT, 0)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--recipes", "all"], "--output"),
        (["--recipes", "sponge", "--output", "x.jsonl"], "is no dish type\nhint: It is one of: all, "),
        (["--recipes", "all", "onion", "--output", "x.jsonl"], "names all that is to be planned"),
        (["--recipes", "all", "--dish", "soup", "--output", "x.jsonl"], "names all that is to be planned"),
        (["--recipes", "all", "--foon", "--output", "x.jsonl"], "two forms"),
    ],
)
def test_what_makes_no_sense_of_a_collection_is_told(options, told):
    answer = plan(*options)
    assert answer.exit_code == 2
    assert told in answer.stderr


def write_and_stop(path, lines):
    with adding(path, 0) as add:
        for line in lines:
            add(line)
        raise KeyboardInterrupt


@pytest.mark.parametrize("name", ENDINGS)
@pytest.mark.parametrize("stop", [0, 1, LINES, LINES + 5])
def test_lines_make_the_same_bytes_wherever_they_were_stopped(tmp_path, name, stop):
    lines = [f"line {number} ✓" for number in range(2 * LINES + 3)]
    whole, parted = tmp_path / ending(f"whole{name}"), tmp_path / f"parted{name}"
    with adding(whole, 0) as add:
        for line in lines:
            add(line)
    with pytest.raises(KeyboardInterrupt):
        write_and_stop(parted, lines[:stop])
    there = list(whole_blocks(parted))
    done = sum(content.count(b"\n") for content, _ in there)
    assert done == (stop if name == ".jsonl" else stop // LINES * LINES)
    with adding(parted, there[-1][1] if there else 0) as add:
        for line in lines[done:]:
            add(line)
    assert parted.read_bytes() == whole.read_bytes()
    assert unpacked(whole).decode().splitlines() == lines


@pytest.mark.parametrize("name", ENDINGS[1:])
@pytest.mark.parametrize("at_once", [7, 1 << 20])
def test_a_block_that_was_being_written_is_not_read(tmp_path, name, at_once, monkeypatch):
    monkeypatch.setattr(blocks, "_AT_ONCE", at_once)
    path = tmp_path / ending(f"x{name}")
    with adding(path, 0) as add:
        for number in range(2 * LINES):
            add(f"line {number}")
    (_, first), (_, second) = whole_blocks(path)
    assert second == path.stat().st_size
    for cut in (1, 9, second - first - 1):
        path.write_bytes(path.read_bytes()[: second - cut])
        assert [end for _, end in whole_blocks(path)] == [first]


@pytest.mark.parametrize("name", ENDINGS[1:])
def test_a_file_that_is_not_what_its_ending_says_is_refused(tmp_path, name):
    path = tmp_path / ending(f"x{name}")
    path.write_bytes(b"a line of text\n")
    with pytest.raises(UsageError, match="not what its ending says"):
        list(whole_blocks(path))
