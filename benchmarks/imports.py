"""How many modules each command imports before it asks Neo4j: what a person waits for when the server is up.

    python benchmarks/imports.py [--slowest N]

Every module costs, on any machine, and on a busy one their times say little: so they are counted, those of foon-kg and
those of other packages apart (the standard library's depend on Python). Each command is run against an address at which
nothing answers, so no database is needed. Printed: both counts with their limits; with ``--slowest`` the N modules that
took longest to import, in ms of their own. The exit code is 1 where a count is above its limit, or a package is
imported that its command can do without: ``make check`` runs this.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from dataclasses import dataclass

from foon_kg.foon.demo import demo_folder

NOBODY = "bolt://127.0.0.1:1"
MARK = "modules at the end:"
RUN = f"""
import atexit, sys
atexit.register(lambda: print("{MARK}", *(name for name, module in sys.modules.items() if module), file=sys.stderr))
from foon_kg.cli import main
main()
"""
LINE = re.compile(r"import time:\s+(\d+) \|\s+\d+ \|\s+(\S+)")


@dataclass(frozen=True)
class Command:
    """A command, the most modules of foon-kg and of other packages that it may import, and packages it may not.

    ``again``: counted is a second run, which finds what the first one kept.
    """

    words: tuple[str, ...]
    own: int
    others: int
    never: frozenset[str] = frozenset()
    again: bool = False

    @property
    def name(self) -> str:
        """How the command is called in the table."""
        words = [word for word in self.words[:2] if word in {"foon", "--files"}]
        return " ".join([self.words[0], *words])


DEMO = demo_folder()
HEAVY = frozenset({"pandas", "pyarrow", "requests", "spacy", "jgo"})
COMMANDS = (
    Command(("--help",), 48, 40, HEAVY),
    Command(("cypher", "RETURN 1"), 40, 260, HEAVY | {"numpy"}),
    Command(("stats",), 38, 260, HEAVY | {"numpy"}),
    Command(("load", "foon", str(DEMO)), 64, 260, HEAVY | {"numpy"}, again=True),
    Command(("similar", "caper"), 65, 355, HEAVY),
    Command(("plan", "--dish", "salad", "chopped onion"), 270, 355, HEAVY),
    Command(("plan", "--files", str(DEMO), "--dish", "salad", "chopped onion"), 271, 241, HEAVY | {"neo4j", "psutil"}),
)


def imported(words: tuple[str, ...]) -> dict[str, int]:
    """Return the modules that the command ``words`` imports, with the microseconds that each took by itself."""
    environment = {**os.environ, "NEO4J_URI": NOBODY}
    run = [sys.executable, "-X", "importtime", "-c", RUN, *words]
    told = subprocess.run(run, capture_output=True, text=True, check=False, env=environment).stderr
    names = told.partition(MARK)[2].split()  # what -X importtime tells has what could not be imported, too
    spent = {name: int(microseconds) for microseconds, name in LINE.findall(told)}
    return {name: spent.get(name, 0) for name in names}


def top(name: str) -> str:
    return name.partition(".")[0]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--slowest", type=int, default=0)
    options = parser.parse_args()
    faults: list[str] = []
    print(f"{'':20}{'foon-kg':>9}{'at most':>9}{'others':>9}{'at most':>9}")
    for command in COMMANDS:
        if command.again:
            imported(command.words)
        modules = imported(command.words)
        own = sum(top(name) == "foon_kg" for name in modules)
        others = sum(top(name) not in {"foon_kg", *sys.stdlib_module_names} for name in modules)
        print(f"foon {command.name:15}{own:9}{command.own:9}{others:9}{command.others:9}")
        for name in sorted(modules, key=lambda name: -modules[name])[: options.slowest]:
            print(f"    {modules[name] / 1000:8.1f} ms  {name}")
        if own > command.own or others > command.others:
            faults.append(f"foon {command.name} imports more than it may: import what is seldom used where it is used")
        if heavy := sorted(command.never & {top(name) for name in modules}):
            faults.append(f"foon {command.name} imports {', '.join(heavy)}, which it can do without")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
