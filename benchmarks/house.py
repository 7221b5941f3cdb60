"""The house in figures: entries, layers, circles, imports, sizes, docstrings, caches and limits of a checkout.

    python benchmarks/house.py [FOLDER] [--list FIGURE] [--way] [--hold]

Everything is read from the source, so that another checkout (``git worktree add``) is measured by the same rules:
``FOLDER`` is its top. ``--list`` shows the places behind a figure instead. ``--way`` runs ``foon plan`` of *this*
checkout over the demo and tells how many calls of how many modules stand between the command and the first unit of
the tree. ``--hold`` fails where a figure is greater than it may be by now: ``make check`` runs that. What counts as
what is said in ``docs/explanation/house.md``.
"""

from __future__ import annotations

import argparse
import ast
import re
import statistics
import subprocess
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from pathlib import Path

import networkx as nx
from house_functions import DRAWN, Function, score, scores

PACKAGE = "foon_kg"
BESIDE = ("cypher", "loaders")
"""Folders beside the package that are installed as parts of it."""

MOST_LINES = 400
"""A file with more lines than this is told."""

MOST_COMPLEX = 10
"""A function above this is told; comprehensions and boolean operators count, which ruff's C901 does not."""

RUN = 6
"""So many equal lines of code in a row, twice, are a duplicated place."""

AT_THE_DOORS = ("cli", "web")
"""The rooms that are asked to call the front door."""

FREE = ("model", "food", "foon", "formats", "docs", "plans", "validation", "loaders", "cypher")
"""The rooms whose values and files anybody may speak of: they answer no question of a FOON."""


@dataclass(frozen=True)
class Module:
    """A module: its name, file, text and tree."""

    name: str
    path: Path
    text: str
    tree: ast.Module = field(repr=False)

    @property
    def room(self) -> str:
        """Return the entry of the package that it belongs to; the package's own file is ``__init__``."""
        parts = self.name.split(".")
        return parts[1] if len(parts) > 1 else "__init__"


class House:
    """A checkout, read once."""

    def __init__(self, top: Path) -> None:
        self.top = top
        self.modules = {module.name: module for module in self._read()}

    def _read(self) -> Iterator[Module]:
        roots = [(self.top / PACKAGE, (PACKAGE,)), *((self.top / one, (PACKAGE, one)) for one in BESIDE)]
        for root, package in roots:
            for path in sorted(root.rglob("*.py")) if root.is_dir() else ():
                parts = (*package, *path.relative_to(root).with_suffix("").parts)
                name = ".".join(part for part in parts if part != "__init__")
                text = path.read_text(encoding="utf-8")
                yield Module(name, path, text, ast.parse(text))

    @cached_property
    def entries(self) -> list[str]:
        """Return the entries at the top of the package, folders beside it included."""
        own = {module.room for module in self.modules.values()}
        return sorted(own - {"__init__"})

    def _target(self, base: str, name: str) -> str | None:
        """Return the module that ``from base import name`` needs."""
        whole = f"{base}.{name}"
        return whole if whole in self.modules else base if base in self.modules else None

    def imports_of(self, module: Module, tree: ast.AST | None = None) -> Iterator[tuple[str, str]]:
        """Yield the modules of the package that a module imports, anywhere and for types too, and the name it takes."""
        for node in ast.walk(tree or module.tree):
            if isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
                for alias in node.names:
                    target = self._target(node.module, alias.name)
                    if target is not None and target != module.name:
                        yield target, alias.name
            elif isinstance(node, ast.Import):
                yield from ((alias.name, "") for alias in node.names if alias.name in self.modules)

    @cached_property
    def graph(self) -> nx.DiGraph[str]:
        """Return who imports whom, module by module."""
        graph: nx.DiGraph[str] = nx.DiGraph()
        graph.add_nodes_from(self.modules)
        for module in self.modules.values():
            graph.add_edges_from((module.name, target) for target, _ in self.imports_of(module))
        return graph

    @cached_property
    def rooms(self) -> nx.DiGraph[str]:
        """Return which room imports which, with how many pairs of modules do so."""
        graph: nx.DiGraph[str] = nx.DiGraph()
        counts = Counter(
            (self.modules[one].room, self.modules[other].room)
            for one, other in self.graph.edges
            if self.modules[one].room != self.modules[other].room and self.modules[other].room != "__init__"
        )
        graph.add_weighted_edges_from((one, other, count) for (one, other), count in counts.items())
        return graph

    @cached_property
    def floors(self) -> int:
        """Return the rooms on the longest way down, rooms of one circle counted as one."""
        return int(nx.dag_longest_path_length(nx.condensation(self.rooms), weight=None, default_weight=1)) + 1

    @cached_property
    def circles(self) -> list[list[str]]:
        """Return the circles between modules, each as its modules; imports for types alone count."""
        return [sorted(one) for one in nx.strongly_connected_components(self.graph) if len(one) > 1]

    @cached_property
    def room_circles(self) -> list[list[str]]:
        """Return the circles between rooms, each as its rooms."""
        return [sorted(one) for one in nx.strongly_connected_components(self.rooms) if len(one) > 1]

    @cached_property
    def functions(self) -> list[Function]:
        """Return the functions and methods, without those inside others."""
        found = []
        for module in self.modules.values():
            for owner in [module.tree, *(node for node in ast.walk(module.tree) if isinstance(node, ast.ClassDef))]:
                hidden = isinstance(owner, ast.ClassDef) and owner.name.startswith("_")
                found += [
                    Function(module.name, node, not hidden and not node.name.startswith("_"))
                    for node in owner.body
                    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
                ]
        return found

    def lines_matching(self, pattern: str) -> list[str]:
        """Return the places whose line matches, as ``file:line text``."""
        found = re.compile(pattern)
        return [
            f"{module.path.relative_to(self.top)}:{number} {line.strip()}"
            for module in self.modules.values()
            for number, line in enumerate(module.text.splitlines(), start=1)
            if found.search(line)
        ]

    @cached_property
    def long_files(self) -> list[str]:
        """Return the files with more lines than ``MOST_LINES``, those of tests too, the longest first."""
        paths = [*(module.path for module in self.modules.values()), *(self.top / "tests").rglob("*.py")]
        counts = {path: len(path.read_text(encoding="utf-8").splitlines()) for path in paths}
        long = sorted((-count, str(path.relative_to(self.top))) for path, count in counts.items() if count > MOST_LINES)
        return [f"{path} {-count}" for count, path in long]

    @cached_property
    def comments(self) -> tuple[int, int]:
        """Return the lines that are, or end in, a comment, and all that are not empty."""
        lines = [line for module in self.modules.values() for line in module.text.splitlines() if line.strip()]
        return sum(bool(re.search(r"(^|\s)# (?!noqa|type:|fmt:)", line)) for line in lines), len(lines)

    @cached_property
    def duplicates(self) -> list[str]:
        """Return pairs of places that share ``RUN`` lines of code or more, to the letter but for the indent."""
        where: dict[tuple[str, ...], list[tuple[str, int]]] = defaultdict(list)
        for module in self.modules.values():
            code = [
                (number, line.strip())
                for number, line in enumerate(module.text.splitlines(), start=1)
                if re.search(r"\w", line) and not re.match(r"\s*(#|from |import |\"\"\")", line)
            ]
            for start in range(len(code) - RUN + 1):
                run = code[start : start + RUN]
                where[tuple(line for _, line in run)].append((str(module.path.relative_to(self.top)), run[0][0]))
        pairs: dict[tuple[str, str], tuple[int, int]] = {}
        for places in where.values():
            for (one, first), (other, second) in pairwise(places):
                pairs.setdefault((one, other), (first, second))
        return [f"{one}:{first} ~ {other}:{second}" for (one, other), (first, second) in sorted(pairs.items())]

    def beside_the_door(self) -> list[str]:
        """Return what the rooms at the doors import at run time besides the front door and the rooms of values."""
        found = []
        for module in self.modules.values():
            if module.room not in AT_THE_DOORS:
                continue
            for target, name in self.imports_of(module, _without_types(module.tree)):
                if self.modules[target].room not in {module.room, "__init__", *AT_THE_DOORS, *FREE}:
                    found.append(f"{module.name} {target} {name}")
        return sorted(set(found))


def _without_types(tree: ast.Module) -> ast.Module:
    """Return a module without what only a checker of types reads."""

    class Runs(ast.NodeTransformer):
        def visit_If(self, node: ast.If) -> ast.AST | None:
            return None if ast.unparse(node.test).endswith("TYPE_CHECKING") else self.generic_visit(node)

    return Runs().visit(ast.parse(ast.unparse(tree)))


def way() -> tuple[list[str], int]:
    """Return the calls on the way from ``foon plan`` to the first unit that is built, and how many were made till then.

    The calls are those that are open when the first unit of a tree is made, the command's first.
    """
    program = """
import sys
from foon_kg.cli import main
from foon_kg.foon.demo import demo_folder
import foon_kg.integration.final_tree as last
calls = 0
def watch(frame, event, _):
    global calls
    if event == "call" and frame.f_globals.get("__name__", "").startswith("foon_kg"):
        calls += 1
def told(*_):
    sys.setprofile(None)
    frame, names = sys._getframe(1), ["foon_kg.integration.final_tree:_unit"]
    while frame is not None:
        name = frame.f_globals.get("__name__", "")
        if name.startswith("foon_kg") and not frame.f_code.co_name.startswith("<"):
            names.append(name + ":" + frame.f_code.co_qualname)
        frame = frame.f_back
    print(calls, *reversed(names), sep="\\n", file=sys.stderr)
    import os; sys.stderr.flush(); os._exit(0)
last._unit = told
sys.argv = ["foon", "plan", "--dish", "salad", "chopped onion", "olive oil", "--files", str(demo_folder())]
sys.setprofile(watch)
main()
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    count, *names = done.stderr.strip().splitlines()
    return names, int(count)


def documents(top: Path) -> tuple[int, int, int]:
    """Return the lines of README, its ``foon`` commands, and those of all documents."""
    pages = [top / "README.md", *sorted((top / "docs").rglob("*.md"))]
    commands = {page: len(re.findall(r"^foon ", _shell(page), re.MULTILINE)) for page in pages if page.exists()}
    return len(pages[0].read_text(encoding="utf-8").splitlines()), commands[pages[0]], sum(commands.values())


def _shell(page: Path) -> str:
    return "\n".join(re.findall(r"```sh\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL))


def figures(house: House) -> Iterator[tuple[str, object]]:
    """Yield every figure with its name."""
    functions, lengths = house.functions, sorted(one.lines for one in house.functions)
    comments, lines = house.comments
    readme, of_readme, of_all = documents(house.top)
    drawn = scores(house.functions)
    yield "entries at the top of the package", len(house.entries)
    yield "floors: rooms on the longest way down", house.floors
    yield "circles between modules", len(house.circles)
    yield "circles between rooms", len(house.room_circles)
    yield "imports between rooms (pairs of modules)", int(house.rooms.size(weight="weight"))
    yield "rooms that import rooms (arrows)", house.rooms.number_of_edges()
    yield "imports of commands, page and MCP beside the door", len(house.beside_the_door())
    yield "modules", len(house.modules)
    yield f"files over {MOST_LINES} lines", len(house.long_files)
    yield "lines that are not empty", lines
    yield "comments, % of them", round(100 * comments / lines, 1)
    yield "functions", len(functions)
    yield "lines of a function: median", f"{statistics.median(lengths):g}"
    yield "lines of a function: nine in ten", lengths[len(lengths) * 9 // 10]
    yield f"functions more complex than {MOST_COMPLEX}", sum(one.complexity > MOST_COMPLEX for one in functions)
    yield "functions more complex than 20", sum(one.complexity > 20 for one in functions)
    yield "the most complex", max(one.complexity for one in functions)
    for name in drawn[0].said:
        asked = [one.said[name] for one in drawn if one.said[name] is not None]
        yield f"docstrings of {DRAWN}: {name}", f"{sum(map(bool, asked))} of {len(asked)}"
    yield SILENT, len(list(_silent(house)))
    yield f"pairs of files that share {RUN} lines", len(house.duplicates)
    yield "caches: Recent", len(house.lines_matching(CACHES["Recent"]))
    yield "caches: cached_property", len(house.lines_matching(CACHES["cached_property"]))
    yield "caches: cache, lru_cache", len(house.lines_matching(CACHES["functools"]))
    yield "limits: MOST_…", len(house.lines_matching(LIMITS))
    yield "lines of README", readme
    yield "foon commands in README", of_readme
    yield "foon commands in all documents", of_all


CACHES = {
    "Recent": r"\bRecent\(|default_factory=lambda: Recent",
    "cached_property": r"^\s*@(functools\.)?cached_property",
    "functools": r"^\s*@(functools\.)?(lru_)?cache\b",
}
LIMITS = r"^\s*_?MOST_[A-Z_]*\b.*="


SILENT = "public functions silent about an argument"

HELD: Mapping[str, int] = {
    "circles between modules": 0,
    "circles between rooms": 0,
    f"files over {MOST_LINES} lines": 0,
    f"functions more complex than {MOST_COMPLEX}": 0,
    "functions more complex than 20": 0,
    "the most complex": 10,
    f"pairs of files that share {RUN} lines": 5,
    SILENT: 0,
    "caches: Recent": 12,
    "caches: cached_property": 230,
    "caches: cache, lru_cache": 91,
    "limits: MOST_…": 88,
}
"""What may not get worse: the most of each figure. Whoever makes one better lowers it here."""


def worse(house: House) -> list[str]:
    """Return which of the figures that are held are greater than they may be, each in a line."""
    found = dict(figures(house))
    return [f"{name}: {found[name]}, and at most {most}" for name, most in HELD.items() if int(str(found[name])) > most]


def _silent(house: House) -> Iterator[Function]:
    """Yield the public functions whose docstring does not speak of each of their arguments."""
    return (one for one in house.functions if one.public and score(one).said["arguments"] is False)


LISTS: dict[str, Callable[[House], Iterable[object]]] = {
    "caches": lambda house: (line for pattern in CACHES.values() for line in house.lines_matching(pattern)),
    "limits": lambda house: house.lines_matching(LIMITS),
    "complex": lambda house: (
        f"{one.complexity:3} {one}"
        for one in sorted(house.functions, key=lambda one: -one.complexity)
        if one.complexity > MOST_COMPLEX
    ),
    "long": lambda house: house.long_files,
    "circles": lambda house: (" ".join(one) for one in house.circles),
    "doors": House.beside_the_door,
    "duplicates": lambda house: house.duplicates,
    "silent": _silent,
    "docstrings": lambda house: (f"{one.function} {one.said}" for one in scores(house.functions)),
    "rooms": lambda house: (f"{one} -> {other} {count:g}" for one, other, count in house.rooms.edges(data="weight")),
}
"""The places behind a figure, by what ``--list`` calls it."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parents[1])
    parser.add_argument("--list", choices=LISTS, help="the places behind a figure")
    parser.add_argument("--way", action="store_true", help="the calls from foon plan to the first unit")
    parser.add_argument("--hold", action="store_true", help="exit code 1 where a figure got worse than it may be")
    asked = parser.parse_args()
    if asked.way:
        calls, made = way()
        print(*calls, sep="\n")
        modules = {one.partition(":")[0] for one in calls}
        print(f"{len(calls)} calls deep, over {len(modules)} modules; {made:,} calls were made till then")
        return
    house = House(asked.folder.resolve())
    if asked.hold:
        if found := worse(house):
            print(*found, "python benchmarks/house.py --list complex (long, duplicates, …) shows where.", sep="\n")
            raise SystemExit(1)
        return
    if asked.list:
        print(*LISTS[asked.list](house), sep="\n")
        return
    for name, figure in figures(house):
        print(f"{name:52} {figure}")


if __name__ == "__main__":
    main()
