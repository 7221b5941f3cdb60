"""How long it takes to read, merge and load subgraphs, to load them again, and to ask what a plan asks.

    python benchmarks/load.py FOLDER

The Neo4j is the one that NEO4J_URI names, else the local server; its FOON is replaced by the one in FOLDER. Times are
seconds of one run each: for a cold figure start the server just before.
"""

from __future__ import annotations

import argparse
import gc
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from foon_kg.loaders import read_paths
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, Neo4jGraph, load, remove
from foon_kg.store.graph.warming import warm
from foon_kg.store.server import connection_settings
from foon_kg.store.snapshot import Snapshot

FOODS = [("onion", "chopped"), ("lettuce", "chopped"), ("tomato", "sliced"), ("egg", "beaten"), ("cucumber", "sliced")]


@contextmanager
def timed(what: str) -> Iterator[None]:
    start = time.perf_counter()
    yield
    print(f"{what:40} {time.perf_counter() - start:8.3f} s")


def main(folder: Path) -> None:
    gc.set_threshold(100_000, 50, 100)  # collecting cycles would take half the time of what makes no cycles
    with timed("read"):
        subgraphs = [result.subgraph for result in read_paths([folder]) if result.subgraph is not None]
    with timed("merge in memory"):
        snapshot = Snapshot.of(subgraphs, Kitchen.default())
    print(f"{len(subgraphs)} subgraphs, {len(snapshot.units)} units")
    settings = connection_settings()
    with Connection(settings) as connection, Neo4jGraph(settings) as graph:
        with timed("load"):
            load(connection, subgraphs)
        with timed("load again, nothing changed"):
            load(connection, subgraphs)
        with timed("replace one video"):
            load(
                connection, [type(subgraphs[0])(subgraphs[0].name, subgraphs[0].annotations[1:], subgraphs[0].sources)]
            )
        with timed("the first plan's questions"):
            ask(graph)
        with timed("warming"):
            warm(settings)
        for _ in range(5):
            with timed("a plan's questions"):
                ask(graph)
        with timed("the whole FOON as a snapshot"):
            graph.snapshot()
        with timed("remove everything"):
            remove(connection, [subgraph.name for subgraph in subgraphs])
        with timed("load into the warm server"):
            load(connection, subgraphs)


def ask(graph: Neo4jGraph) -> None:
    """Ask what a plan of a salad asks: the words, the goals, what is behind the first three and behind some foods."""
    with graph.reading() as view:
        view.vocabulary()
        goals = view.goals("salad")
        units = view.behind([goal.node for goal in goals[:3]], FOODS)
    print(f"{view.round_trips} round trips, {len(goals)} goals, {len(units)} units", end="   ")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    main(parser.parse_args().folder)
