"""How old the answers of foon serve are after a load: the time from the end of a load to the first answer that has it.

    python benchmarks/freshness.py [--files FOLDER] [--loads 40] [--seed 1]

Loads the videos of a folder (of one format: TXT or JSON) into the Neo4j that NEO4J_URI names or foon-kg's own (name an
empty one: FOON_KG_HOME), starts foon serve on it and, so many times, replaces one video by itself with a unit more or
less, at any moment between two looks of the service; then it asks for a summary again and again until the answer names
the new edition (Foon-Edition). Printed: percentiles of that time and of the slowest answer meanwhile, and what a new
edition costs the processes of the service in CPU, which says on a busy machine what the seconds do not.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import statistics
import subprocess
import sys
import time
import urllib.request
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import psutil

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model import Subgraph
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.server import ensure_running
from foon_kg.store.settings import connection_from_environment

PROGRAM = "import sys; from foon_kg.cli import main; sys.exit(main())"
BETWEEN_LOOKS = 2.0
EVERY = 0.05
"""Seconds between two questions."""

LONGEST = 120.0


@dataclass(frozen=True)
class Seen:
    """One load: seconds until an answer had it, of the slowest answer meanwhile, and of processor."""

    stale: float
    slowest: float
    processor: float


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=Path, default=demo_folder())
    parser.add_argument("--loads", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    subgraphs = [result.subgraph for result in read_paths([given.files]) if result.subgraph is not None]
    settings = connection_from_environment() or ensure_running()
    moments = random.Random(given.seed)
    with Connection(settings) as connection, Neo4jGraph(settings) as graph:
        load(connection, subgraphs)
        serving = subprocess.Popen(
            [sys.executable, "-c", PROGRAM, "serve", "--port", "0"], stderr=subprocess.PIPE, text=True, env=os.environ
        )
        try:
            address = serving.stderr.readline().strip() if serving.stderr else ""
            ask(address)
            seen: list[Seen] = []
            for number in range(given.loads):
                time.sleep(moments.uniform(0, BETWEEN_LOOKS))
                seen.append(after_a_load(connection, graph, address, changed(subgraphs[0], number), serving.pid))
        finally:
            serving.terminate()
            serving.wait()
    print(f"{len(subgraphs)} videos, {len(seen)} loads, load of the machine {os.getloadavg()[0]:.1f}")
    show("seconds until an answer has it", [one.stale for one in seen])
    show("seconds of the slowest answer", [one.slowest for one in seen])
    show("seconds of processor", [one.processor for one in seen])


def changed(subgraph: Subgraph, number: int) -> Subgraph:
    """Return a video with or without its last unit, by turns."""
    return subgraph if number % 2 else replace(subgraph, annotations=subgraph.annotations[:-1])


def after_a_load(connection: Connection, graph: Neo4jGraph, address: str, subgraph: Subgraph, pid: int) -> Seen:
    """Load a video and wait until it is served."""
    before = processor(pid)
    load(connection, [subgraph])
    stored = time.monotonic()
    with graph.reading() as view:
        wanted = view.edition
    slowest = 0.0
    while time.monotonic() - stored < LONGEST:
        asked = time.monotonic()
        edition = ask(address)
        slowest = max(slowest, time.monotonic() - asked)
        if edition == wanted:
            return Seen(time.monotonic() - stored, slowest, processor(pid) - before)
        time.sleep(EVERY)
    raise SystemExit(f"after {LONGEST:g} seconds no answer had what was loaded")


def ask(address: str) -> str | None:
    """Return of which edition an answer is."""
    with urllib.request.urlopen(f"{address}api/summary", timeout=LONGEST) as answer:
        json.load(answer)
        return answer.headers["Foon-Edition"]


def processor(pid: int) -> float:
    """Return the seconds of processor that a service and its processes took."""
    total = 0.0
    for process in (psutil.Process(pid), *psutil.Process(pid).children(recursive=True)):
        try:
            times = process.cpu_times()
        except psutil.NoSuchProcess:
            continue
        total += times.user + times.system
    return total


def show(what: str, values: Sequence[float]) -> None:
    """Print the median, the 95 % and the longest."""
    cuts = statistics.quantiles(values, n=20, method="inclusive")
    print(f"{what:32} median {cuts[9]:6.2f}   95 % {cuts[18]:6.2f}   most {max(values):6.2f}")


if __name__ == "__main__":
    main()
