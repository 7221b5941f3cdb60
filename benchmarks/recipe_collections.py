"""Collections of recipes of any size: make one of exactly the shape of Recipe1M+, and measure how it is loaded.

    python benchmarks/recipe_collections.py make FOLDER --recipes 100000
    python benchmarks/recipe_collections.py load FOLDER [--parse full]
    python benchmarks/recipe_collections.py compare FOLDER --recipes 100000

``load`` runs what ``foon load recipes`` runs against the Neo4j of the environment (else the local one), and prints for
every 50,000 recipes the rate, the CPU seconds of this process and of the local server, and what memory they have.
``compare`` reads so many recipes once, stores them over Bolt, and then imports the same nodes and relationships with
``neo4j-admin database import`` into a database of its own, which is thrown away: the quickest way there is.
"""

from __future__ import annotations

import argparse
import os
import resource
import time
from collections.abc import Sized
from pathlib import Path

import psutil
from made_recipes import make
from recipe_import import compare

from foon_kg.language.collection import CollectionReader, labels_of
from foon_kg.language.recipe_lines import LineReader
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.store.graph import Connection, Neo4jGraph
from foon_kg.store.graph.recipes import load_recipes, prepare_for_recipes
from foon_kg.store.server import connection_settings, status


def load(folder: Path, parse: str, every: int) -> None:
    """Load, and print the rate of each ``every`` recipes."""
    size = sum(file.stat().st_size for file in folder.glob("*.json"))
    settings = connection_settings()
    with (
        RecipeCollections([folder], lambda _: None) as collections,
        LineReader(os.cpu_count() or 1) as lines,
        Connection(settings) as connection,
    ):
        start, cpu = time.perf_counter(), time.process_time()
        total = collections.check()
        print(f"{total:,} recipes, {size / 1e6:,.0f} MB; read to the end in", end=" ")
        print(f"{time.perf_counter() - start:.0f} s, {time.process_time() - cpu:.0f} s of CPU", flush=True)
        prepare_for_recipes(connection)
        with Neo4jGraph(settings) as graph, graph.reading() as view:
            reader = CollectionReader(labels_of(view.vocabulary()), lines, parse == "full")
        rates = Rates(every)
        stored = load_recipes(connection, collections, reader.understand, stored=rates.add, version=reader.version)
    rates.show_whole()
    print(stored)


class Rates:
    """Prints how quickly each ``every`` recipes were stored, and at what cost."""

    def __init__(self, every: int) -> None:
        self._every = every
        self._server = _local_server()
        self._done = 0
        self._first = self._last = (0, time.perf_counter(), *self._spent())
        print("  recipes   wall s  recipes/s  CPU s: client  server   MB: client  server", flush=True)

    def add(self, stored: Sized) -> None:
        """Take down that so many recipes more are stored."""
        before, self._done = self._done, self._done + len(stored)
        if before // self._every != self._done // self._every:
            now = self._now()
            self._show(self._last, now)
            self._last = now

    def show_whole(self) -> None:
        """Print the same over all recipes."""
        print("in all:")
        self._show(self._first, self._now())

    def _now(self) -> tuple[int, float, float, float]:
        return self._done, time.perf_counter(), *self._spent()

    def _show(self, first: tuple[int, float, float, float], now: tuple[int, float, float, float]) -> None:
        done, wall, client, server = (b - a for a, b in zip(first, now, strict=True))
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        held = self._server.memory_info().rss / 1e6 if self._server else 0
        print(
            f"{now[0]:>9,} {wall:8.1f} {done / wall:10,.0f} {client:14.1f} {server:7.1f} {peak:12,.0f} {held:7,.0f}",
            flush=True,
        )

    def _spent(self) -> tuple[float, float]:
        """Return the CPU seconds of this process with its children, and of the local server (0 for another one)."""
        own = sum(os.times()[:4])
        server = sum(self._server.cpu_times()[:2]) if self._server else 0.0
        return own, server


def _local_server() -> psutil.Process | None:
    pid = None if "NEO4J_URI" in os.environ else status().pid
    return psutil.Process(pid) if pid else None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    maker, loader, comparer = (commands.add_parser(name) for name in ("make", "load", "compare"))
    for command in (maker, loader, comparer):
        command.add_argument("folder", type=Path)
    maker.add_argument("--recipes", type=int, default=100_000)
    maker.add_argument("--seed", type=int, default=1)
    loader.add_argument("--parse", choices=("quick", "full"), default="quick")
    loader.add_argument("--every", type=int, default=50_000)
    comparer.add_argument("--recipes", type=int, default=100_000)
    asked = parser.parse_args()
    if asked.command == "make":
        make(asked.folder, asked.recipes, asked.seed)
    elif asked.command == "load":
        load(asked.folder, asked.parse, asked.every)
    else:
        compare(asked.folder, asked.recipes)


if __name__ == "__main__":
    main()
