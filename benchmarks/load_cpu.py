"""What a load into the local server costs: CPU seconds of this program, and of Java by what its threads are for.

    FOON_KG_HOME=FOLDER python benchmarks/load_cpu.py [--units N] [--transaction N]

Needs the public subgraphs beside the checkout, and Linux; the FOON (see big_foon.py) comes on top of what the server of
FOON_KG_HOME holds: for a load into a fresh graph take a new folder. Elapsed time means something only where nothing
else runs; CPU seconds grow less with the load of the machine.
"""

from __future__ import annotations

import argparse
import gc
import os
import resource
import time
from collections import Counter
from contextlib import suppress
from pathlib import Path

from big_foon import big_foon, real_subgraphs

from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.loading import UNITS_PER_TRANSACTION
from foon_kg.store.server import connection_settings
from foon_kg.store.server.home import home

KINDS = {"GC": "collector", "VM Thread": "collector", "C1": "compiler", "C2": "compiler", "neo4j.Bolt": "statements"}
"""What threads of Java are for, by how their names begin; all others do little."""

TICKS = os.sysconf("SC_CLK_TCK")


def spent(process: int) -> Counter[str]:
    """Return the CPU seconds of each kind of threads that ``process`` has."""
    found: Counter[str] = Counter()
    for thread in Path(f"/proc/{process}/task").iterdir():
        with suppress(OSError):  # it has ended
            name, _, rest = (thread / "stat").read_text(encoding="utf-8").partition("(")[2].rpartition(")")
            user, system = rest.split()[11:13]
            kind = next((kind for begin, kind in KINDS.items() if name.startswith(begin)), "others")
            found[kind] += (int(user) + int(system)) / TICKS
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--units", type=int, default=20_000)
    parser.add_argument("--transaction", type=int, default=UNITS_PER_TRANSACTION, help="how many units one has")
    options = parser.parse_args()
    gc.set_threshold(1_000_000, 50, 100)  # as every command of foon has it
    settings, subgraphs = connection_settings(), big_foon(real_subgraphs(), options.units)
    last = home().recall()
    if last is None or last.pid is None:
        parser.error("NEO4J_URI names another server than the local one")
    before, cpu, started = spent(last.pid), time.process_time(), time.perf_counter()
    with Connection(settings) as connection:
        load(connection, subgraphs, units_per_transaction=options.transaction)
    took, own = time.perf_counter() - started, time.process_time() - cpu
    now = spent(last.pid)
    now.subtract(before)
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{options.units:,} units in {took:.1f} s; this program {own:.1f} s of CPU, {most:,.0f} MB with the FOON")
    print(f"server {now.total():.1f} s of CPU: " + ", ".join(f"{kind} {now[kind]:.1f}" for kind in sorted(now)))


if __name__ == "__main__":
    main()
