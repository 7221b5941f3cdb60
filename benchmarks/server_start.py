"""How long the local Neo4j takes: first fetch, first start, start-up cache, later starts, stop, memory.

    python benchmarks/server_start.py [RUNS]

Everything happens in a temporary home and cache; the first fetch needs the network (180 MB). Figures are wall-clock
seconds; the load of the machine is printed beside them because it changes them more than anything else does.
"""

from __future__ import annotations

import argparse
import os
import statistics
import tempfile
import time
from collections.abc import Callable
from contextlib import contextmanager
from pathlib import Path

import neo4j
from filelock import FileLock

from foon_kg.store.graph.warming import warm
from foon_kg.store.server import ConnectionSettings, start, status, stop
from foon_kg.store.server.fetch import fetch
from foon_kg.store.server.jars import pinned
from foon_kg.store.server.startup_cache import the_startup_cache


def seconds(action: Callable[[], object]) -> float:
    begun = time.perf_counter()
    action()
    return time.perf_counter() - begun


def report(name: str, figures: list[float], unit: str = "s") -> None:
    load = os.getloadavg()[0]
    print(f"{name:34} {statistics.median(figures):8.2f} {unit:3} of {len(figures)}, load {load:.1f}", flush=True)


def measure_starts(name: str, runs: int) -> None:
    """Start, warm the queries, write for the first time, stop; once a run."""
    figures: dict[str, list[float]] = {name: [], "  warming the queries": [], "  first write": [], "  stop": []}
    for _ in range(runs):
        reached: list[ConnectionSettings] = []
        figures[name].append(seconds(lambda into=reached: start(after_start=into.append)))
        figures["  warming the queries"].append(seconds(lambda found=reached: warm(found[0])))
        figures["  first write"].append(seconds(lambda found=reached: first_write(found[0])))
        figures["  stop"].append(seconds(stop))
    for what, measured in figures.items():
        report(what, measured)


def first_write(settings: ConnectionSettings) -> None:
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        driver.execute_query("UNWIND range(1, 100) AS i MERGE (n:Measured {key: i}) RETURN count(n)")


@contextmanager
def private_folders():
    with tempfile.TemporaryDirectory(prefix="foon-kg-bench-") as folder:
        os.environ["FOON_KG_HOME"] = f"{folder}/home"
        os.environ["FOON_KG_CACHE"] = f"{folder}/cache"
        try:
            yield Path(folder)
        finally:
            stop()


def main(runs: int) -> None:
    with private_folders() as folder:
        jars = pinned()
        report("first fetch", [seconds(lambda: fetch(jars, folder / "cache" / f"neo4j-{jars.version}"))])
        with FileLock(the_startup_cache().lock):  # nobody makes the cache meanwhile
            report("first start, with a new password", [seconds(lambda: start(after_start=lambda _settings: None))])
            report("memory after the first start", [(status().memory or 0) / 1e6], "MB")
            stop()
            measure_starts("start, plain", runs)
        report("making the start-up cache", [seconds(the_startup_cache().make)])
        print(f"start-up cache: {the_startup_cache().state()}, {the_startup_cache().file.stat().st_size / 1e6:.0f} MB")
        measure_starts("start, with the start-up cache", runs)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=int, nargs="?", default=3)
    main(parser.parse_args().runs)
