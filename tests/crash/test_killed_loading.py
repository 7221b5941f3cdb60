"""A loader that is killed at any point leaves every video whole: as it was, or as it was to be.

As a test it is killed at every ninth point; ``make campaign`` kills it at each.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

import pytest
from kitchen_stories import SALAD, subgraph
from methods_told import told

from foon_kg.loaders import write_json
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.snapshot import Snapshot

pytestmark = [pytest.mark.neo4j, pytest.mark.slow]

PROGRAM = Path(__file__).with_name("loading_process.py")
BEFORE = (subgraph("first", "salad", *SALAD[:4]), subgraph("second", "soup", *SALAD[2:]))
WANTED = (
    subgraph("first", "salad", *SALAD),
    subgraph("second", "soup", *SALAD[2:]),
    subgraph("third", "salad", *SALAD[3:]),
)
LINES = 42
"""How many the loader tells; it is killed at each, by turns before the query is sent and while it runs."""


@pytest.fixture
def folder(tmp_path):
    for wanted in WANTED:
        (tmp_path / f"{wanted.name}.json").write_text(write_json(wanted), encoding="utf-8")
    return tmp_path


@pytest.fixture
def graph(empty_graph):
    """A graph in which one video has other content than will be loaded, one has the same, and one is missing."""
    with Connection(empty_graph) as connection, Neo4jGraph(empty_graph) as graph:
        load(connection, BEFORE)
        yield graph


class Loader:
    """A loading process that is led line by line."""

    def __init__(self, settings, folder):
        command = [sys.executable, str(PROGRAM), json.dumps(asdict(settings)), str(folder)]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.stored: set[str] = set()
        self.lines: list[str] = []

    def step(self):
        """Wait for the next line; answer whether there was one."""
        line = self.process.stdout.readline()
        if line.startswith("stored "):
            self.stored |= set(json.loads(line.removeprefix("stored ")))
        self.lines += [line] if line else []
        return bool(line)

    def go_on(self):
        self.process.stdin.write("\n")
        self.process.stdin.flush()

    def kill(self):
        self.process.kill()
        while self.step():
            pass  # what it still had told
        self.process.wait()
        self.process.stdout.close()
        self.process.stdin.close()


def run_to(loader, point):
    """Let the loader tell ``point`` lines; it waits after the last. Answer how many there were."""
    for number in range(point):
        if number:
            loader.go_on()
        if not loader.step():
            return number
    return point


@pytest.mark.parametrize("point", range(1, LINES + 1, 1 if os.environ.get("FOON_KG_CAMPAIGN") == "yes" else 9))
def test_every_video_is_whole_and_what_was_reported_is_there(empty_graph, graph, folder, point):
    loader = Loader(empty_graph, folder)
    run_to(loader, point)
    if point % 2 == 0:
        loader.go_on()
    loader.kill()
    snapshot = graph.snapshot()
    kept = {subgraph.name: subgraph for subgraph in snapshot.subgraphs}
    with graph.reading() as view:
        assert told(view.methods()) == told(snapshot.methods())
    for before, wanted in ((BEFORE[0], WANTED[0]), (BEFORE[1], WANTED[1]), (None, WANTED[2])):
        assert kept.get(wanted.name) in (before, wanted)
        assert wanted.name not in loader.stored or kept[wanted.name] == wanted
    with Connection(empty_graph) as connection:
        load(connection, WANTED)
    expected = Snapshot.of(WANTED, graph.snapshot().kitchen)
    with graph.reading() as view:
        assert graph.snapshot().units == expected.units
        assert (view.goals(), view.vocabulary()) == (expected.goals(), expected.vocabulary())
        assert told(view.methods()) == told(expected.methods())


def test_the_loader_that_nobody_kills_tells_as_many_lines(empty_graph, graph, folder):
    loader = Loader(empty_graph, folder)
    told = run_to(loader, 1000)
    loader.kill()
    assert told == LINES, loader.lines
    assert loader.stored == {"first", "second", "third"}
