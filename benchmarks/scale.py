"""What a plan asks of Neo4j, and how long it takes, on FOONs of growing size with one shape (see big_foon.py).

    python benchmarks/scale.py [--units N ...] [--recipes N] [--loaded]

Needs the public subgraphs and recipes beside the checkout. The Neo4j is the one that NEO4J_URI names, else the local
server; it gets the FOONs, each on top of the smaller one (``--loaded``: it has them already). For each size: loading,
then some real recipes in three ways: asked for the first time; again by a program that has read nothing (a new
``foon plan``), so that reference trees are kept already; and again by one that has planned them before (a service).
Printed: round trips, kilobytes as JSON would have them, milliseconds of each kind of question, of the database's share
(their sum, decoding included) and of the whole plan, and how long this program kept a core busy. All but the last is
wall time: nothing else should run.
"""

from __future__ import annotations

import argparse
import gc
import json
import statistics
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from big_foon import SHARED, big_foon, real_subgraphs

from foon_kg.model import Recipe
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.planning.recipes import IngredientWords, foods_named, names_in, read_recipe, recipe_files
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, GraphView, Neo4jGraph, load
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.server import ConnectionSettings, connection_settings

QUERIES = SHARED.parents[1] / "queries"
COLUMNS = ("trips", "kB", "methods", "words", "goals", "behind", "trees", "database", "plan", "CPU")

KINDS = {
    "methods": "methods",
    "methods_for": "methods",
    "vocabulary": "words",
    "words_for": "words",
    "words_in": "words",
    "goals": "goals",
    "likely_goals": "goals",
    "behind": "behind",
    "remembered": "trees",
    "remember": "trees",
}


class TimedView:
    """A view whose questions are timed: milliseconds by kind of question."""

    def __init__(self, view: GraphView) -> None:
        self.view, self.spent = view, dict.fromkeys(KINDS.values(), 0.0)

    @property
    def memory(self) -> TimedView:
        """The trees are asked of this view, too."""
        return self

    def __getattr__(self, name: str):
        if not callable(getattr(self.view, name)):
            return getattr(self.view, name)

        def timed(*asked, **named):
            started = time.perf_counter()
            answer = getattr(self.view, name)(*asked, **named)
            self.spent[KINDS[name]] += (time.perf_counter() - started) * 1000
            return answer

        return timed


def asked_once(graph: Neo4jGraph, recipe: Recipe) -> dict[str, float]:
    """Plan one recipe and return what it cost."""
    answers: list[object] = []
    with graph.reading() as view:
        ask = view._ask  # noqa: SLF001 - to weigh the answers
        view._ask = lambda *a, **k: answers.append(rows := ask(*a, **k)) or rows  # noqa: SLF001 - the same
        timed = TimedView(view)
        started, cpu = time.perf_counter(), time.process_time()
        with suppress(NoTreeError):
            Planner(timed, PlanSettings()).plan(recipe)
        whole, cpu = (time.perf_counter() - started) * 1000, (time.process_time() - cpu) * 1000
        trips = view.round_trips
    size = len(json.dumps([[vars(row) for row in rows] for rows in answers])) / 1000
    return {"trips": trips, "kB": size, **timed.spent, "database": sum(timed.spent.values()), "plan": whole, "CPU": cpu}


def show(title: str, rows: Sequence[dict[str, float]]) -> None:
    for name, choose in (("median", statistics.median), ("most", max)):
        print(f"{title:>24} {name:6}" + "".join(f"{choose(row[c] for row in rows):9.0f}" for c in COLUMNS), flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--units", type=int, nargs="*", default=[2_000, 20_000])
    parser.add_argument("--recipes", type=int, default=12)
    parser.add_argument("--loaded", action="store_true")
    options = parser.parse_args()
    gc.set_threshold(100_000, 50, 100)
    settings = connection_settings()
    real = real_subgraphs()
    paths = list(recipe_files([QUERIES]))
    paths = paths[:: len(paths) // options.recipes]
    print(f"{'':>31}" + "".join(f"{column:>9}" for column in COLUMNS))
    for units in options.units:
        if not options.loaded:
            started = time.perf_counter()
            subgraphs = big_foon(real, units)
            made, cpu = time.perf_counter(), time.process_time()
            with Connection(settings) as connection:
                load(connection, subgraphs)
            print(
                f"{units} units made in {made - started:.0f} s, loaded in {time.perf_counter() - made:.1f} s "
                f"({time.process_time() - cpu:.1f} s of CPU of this program)",
                flush=True,
            )
            del subgraphs
        measure(settings, paths, str(units))


def words_of(view: GraphView, path: Path) -> IngredientWords:
    """Return the words in which a recipe file is read."""
    named, lines = foods_named(path)
    return IngredientWords(view.words_for(named, names_in(lines)), Kitchen.default())


def measure(settings: ConnectionSettings, paths: Sequence[Path], title: str) -> None:
    with Neo4jGraph(settings) as service:
        with service.reading() as view:
            recipes = [read_recipe(path, words_of(view, path)).recipe for path in paths]
        for recipe in recipes:
            asked_once(service, recipe)  # the server compiles, and this program reads
        show(f"{title}, by a service", [asked_once(service, recipe) for recipe in recipes])
    with Connection(settings) as connection:
        ask_freely(connection, "MATCH (p:Plan) DETACH DELETE p", write=True)
    for how in ("first", "again"):
        rows = []
        for recipe in recipes:
            with Neo4jGraph(settings) as graph:
                rows.append(asked_once(graph, recipe))
        show(f"{title}, {how}", rows)


if __name__ == "__main__":
    main()
