"""What a load into the local server costs: CPU seconds of this program, and of Java by what its threads are for.

    FOON_KG_HOME=FOLDER python benchmarks/load_cpu.py [--units N] [--transaction N] [--anew]
    FOON_KG_HOME=FOLDER python benchmarks/load_cpu.py --units N --files FILES

Needs the public subgraphs beside the checkout, and Linux; the FOON (see big_foon.py) comes on top of what the server of
FOON_KG_HOME holds: for a load into a fresh graph take a new folder. Elapsed time means something only where nothing
else runs; CPU seconds grow less with the load of the machine. The exit code is 1 where all units were there already,
and so nothing was measured. With ``--files`` the FOON is written to a folder (empty
or not there yet), and a process of its own reads it (``foon load foon``): its memory is that of the load alone.
``--anew`` then has all that is there learnt anew, as the first load after an upgrade does, and tells that, too.
"""

from __future__ import annotations

import argparse
import gc
import os
import resource
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from big_foon import big_foon, cuisines, real_subgraphs

from foon_kg import Foon
from foon_kg.loaders import write_text
from foon_kg.model import Subgraph
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely
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


def load_here(subgraphs: Sequence[Subgraph], transaction: int) -> tuple[float, float]:
    """Load from memory; return the CPU seconds of this program for it, and how many MB it has had at most."""
    cpu = time.process_time()
    with Connection(connection_settings()) as connection:
        load(connection, subgraphs, units_per_transaction=transaction)
    return time.process_time() - cpu, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def load_files(folder: Path) -> tuple[float, float]:
    """Load ``folder`` by a process of its own; return what :func:`load_here` does, of that process."""
    started = subprocess.Popen([sys.executable, "-m", "foon_kg", "load", "foon", str(folder)])
    _, status, used = os.wait4(started.pid, 0)
    started.returncode = os.waitstatus_to_exitcode(status)
    if started.returncode:
        sys.exit(started.returncode)
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def write_files(folder: Path, units: int) -> None:
    """Write a FOON of about ``units`` units, each video as a file."""
    folder.mkdir(parents=True, exist_ok=True)
    if any(folder.iterdir()):
        sys.exit(f"{folder} is not empty")
    for subgraph in cuisines(real_subgraphs(), units):
        (folder / f"{subgraph.name}.txt").write_text(write_text(subgraph), encoding="utf-8")


def learn_anew(subgraph: Subgraph) -> float:
    """Have all operators and frames learnt anew, by a load of what is there; return the CPU seconds of this program."""
    cpu = time.process_time()
    with Connection(connection_settings()) as connection:
        ask_freely(connection, "MATCH (f:Foon) SET f.methods = 'another program'", write=True)
        load(connection, [subgraph])
    return time.process_time() - cpu


def tell(what: str, seconds: float, own: str, server: Counter[str]) -> None:
    """Print ``what`` took so many ``seconds`` by the clock, what ``own`` this program took, and the ``server``."""
    print(f"{what} in {seconds:.1f} s; the program {own}")
    kinds = ", ".join(f"{kind} {server[kind]:.1f}" for kind in sorted(server))
    print(f"server {server.total():.1f} s of CPU: {kinds}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--units", type=int, default=20_000)
    parser.add_argument("--transaction", type=int, default=UNITS_PER_TRANSACTION, help="how many units one has")
    parser.add_argument("--anew", action="store_true", help="have all learnt anew afterwards")
    parser.add_argument("--files", type=Path, help="write the FOON here, and load it by another process")
    options = parser.parse_args()
    gc.set_threshold(1_000_000, 50, 100)  # as every command of foon has it
    connection_settings()
    last = home().recall()
    if last is None or last.pid is None:
        parser.error("NEO4J_URI names another server than the local one")
    subgraphs = []
    if options.files:
        write_files(options.files, options.units)
    else:
        subgraphs = big_foon(real_subgraphs(), options.units)
    there = Foon(server=connection_settings()).unit_count()
    before, started = spent(last.pid), time.perf_counter()
    if options.files:
        own, most = load_files(options.files)
    else:
        own, most = load_here(subgraphs, options.transaction)
    took, now = time.perf_counter() - started, spent(last.pid)
    new = Foon(server=connection_settings()).unit_count() - there
    if not new:
        sys.exit("no unit was new, so nothing was measured: take another FOON_KG_HOME, or more --units")
    alone = "alone" if options.files else "with the FOON"
    tell(f"{new:,} new units", took, f"{own:.1f} s of CPU, {most:,.0f} MB {alone}", now - before)
    if options.anew:
        before, started = spent(last.pid), time.perf_counter()
        own = learn_anew((subgraphs or real_subgraphs())[0])
        took = time.perf_counter() - started
        tell(f"{there + new:,} units learnt anew", took, f"{own:.1f} s of CPU", spent(last.pid) - before)


if __name__ == "__main__":
    main()
