"""Recipes stored over Bolt, and the same nodes and relationships imported offline (``recipe_collections.py compare``).

Both begin with recipes that are understood, and end with nodes and relationships on disk. The import reads CSV files,
which are written first and not counted; it makes neither constraints nor indexes, takes no heed of what is there
already, and needs a database that is down: a limit to measure against, and no other way to load.
"""

from __future__ import annotations

import csv
import os
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import psutil

from foon_kg.language.collection import CollectionReader, labels_of
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.model.collected import UnderstoodRecipe
from foon_kg.model.names import canonical
from foon_kg.store.graph import Connection, Neo4jGraph
from foon_kg.store.graph.recipes import load_recipes, prepare_for_recipes
from foon_kg.store.server import connection_settings, status
from foon_kg.store.server.home import Home
from foon_kg.store.server.java import run_admin
from foon_kg.store.server.launch import write_configuration
from foon_kg.store.server.startup_cache import the_startup_cache

NODES = {
    "Ingredient": (":ID(Ingredient)", "name", "canonical"),
    "DishType": (":ID(DishType)", "name"),
    "Recipe": (":ID(Recipe)", "id", "title", "content", "source", "partition", "url", "left_over:string[]"),
}
RELATIONSHIPS = {
    "CALLS_FOR": (":START_ID(Recipe)", ":END_ID(Ingredient)", "position:long", "state", "text", "quantity", "unit"),
    "KIND_OF": (":START_ID(Recipe)", ":END_ID(DishType)", "sure:boolean"),
}
LIST_DELIMITER = "\x1f"
OPENED = "--add-opens=java.base/java.nio=ALL-UNNAMED --add-opens=java.base/java.lang=ALL-UNNAMED"
"""The import starts a Java of its own, which must be told this."""


@dataclass(frozen=True)
class Cost:
    """What so many recipes took, in seconds."""

    recipes: int
    wall: float
    cpu: float

    def __str__(self) -> str:
        a_second = f"{self.recipes / self.wall:,.0f} a second of the clock, {self.recipes / self.cpu:,.0f} of CPU"
        return f"{self.wall:.1f} s, {self.cpu:.1f} s of CPU ({a_second})"


def compare(folder: Path, count: int) -> None:
    """Store the first ``count`` recipes of ``folder`` in both ways, and print what that took and the ratio.

    An import starts Java twice, whatever it imports: that of one recipe tells what of its time that is.

    The graph must not have them. It should be the local one: of another the CPU seconds are not known.
    """
    with Connection(connection_settings()) as connection:
        prepare_for_recipes(connection)
        understood = _understood(folder, count)
        bolt = _stored(connection, understood)
    print(f"{len(understood):,} understood recipes over Bolt: {bolt}", flush=True)
    offline, start = _imported(understood), _imported(understood[:1])
    print(f"the same by neo4j-admin database import: {offline}; of one recipe: {start}")
    whole, rows = bolt.cpu / offline.cpu, bolt.cpu / max(offline.cpu - start.cpu, 0.01)
    print(f"over Bolt takes {whole:.1f} times the CPU, {rows:.1f} times that of the rows alone")


def _imported(understood: Sequence[UnderstoodRecipe]) -> Cost:
    with tempfile.TemporaryDirectory(prefix="foon-kg-import-") as place:
        _write(Path(place), understood)
        return _cost(len(understood), lambda: _import(Path(place)))


def _understood(folder: Path, count: int) -> list[UnderstoodRecipe]:
    with (
        RecipeCollections([folder], lambda _: None) as collections,
        Neo4jGraph(connection_settings()) as graph,
        graph.reading() as view,
    ):
        collections.check()
        reader = CollectionReader(labels_of(view.vocabulary()))
        recipes = iter(collections)
        understood: list[UnderstoodRecipe] = []
        while batch := list(islice(recipes, min(1_000, count - len(understood)))):
            understood += reader.understand(batch)
        return understood


def _stored(connection: Connection, understood: Sequence[UnderstoodRecipe]) -> Cost:
    by_id = {one.recipe.id: one for one in understood}
    report = []

    def load() -> None:
        recipes = (one.recipe for one in understood)
        report.append(load_recipes(connection, recipes, lambda batch: [by_id[recipe.id] for recipe in batch]))

    cost = _cost(len(understood), load)
    if report[0].inserted != len(understood):
        raise SystemExit("some recipes were there already: name an empty FOON_KG_HOME")
    return cost


def _cost(recipes: int, work: Callable[[], None]) -> Cost:
    """Return what ``work`` took: of this process, of its children, and of the local server."""
    began, spent = time.perf_counter(), _cpu()
    work()
    return Cost(recipes, time.perf_counter() - began, _cpu() - spent)


def _cpu() -> float:
    pid = status().pid
    return sum(os.times()[:4]) + (sum(psutil.Process(pid).cpu_times()[:2]) if pid else 0.0)


def _write(place: Path, understood: Iterable[UnderstoodRecipe]) -> None:
    """Write a file of CSV for each label and each type; what stands twice is written once."""
    rows: dict[str, dict[tuple[object, ...], None]] = {name: {} for name in (*NODES, *RELATIONSHIPS)}
    for one in understood:
        recipe = one.recipe
        left_over = LIST_DELIMITER.join(one.left_over)
        values = (recipe.title, recipe.content, recipe.place, recipe.partition, recipe.url, left_over)
        rows["Recipe"][(recipe.id, recipe.id, *values)] = None
        for dish in one.dish_classes:
            rows["DishType"][(dish.name, dish.name)] = None
            rows["KIND_OF"][(recipe.id, dish.name, str(dish.sure).lower())] = None
        for position, called in enumerate(one.ingredients):
            food = called.object
            rows["Ingredient"][(food, food, canonical(food))] = None
            said = (called.state, called.text, called.quantity, called.unit)
            rows["CALLS_FOR"][(recipe.id, food, position, *said)] = None
    for name, columns in {**NODES, **RELATIONSHIPS}.items():
        with (place / f"{name}.csv").open("w", encoding="utf-8", newline="") as stream:
            writer = csv.writer(stream, quoting=csv.QUOTE_ALL)
            writer.writerow(columns)
            writer.writerows(rows[name])


def _import(place: Path) -> None:
    home = Home(place / "home")
    home.configuration.mkdir(parents=True)
    write_configuration(home, port=7687)
    cache = the_startup_cache()
    os.environ["JDK_JAVA_OPTIONS"] = OPENED
    options = (f"--array-delimiter={LIST_DELIMITER}", '--quote="', "--multiline-fields=true", "--id-type=string")
    files = (
        *(f"--nodes={name}={place / name}.csv" for name in NODES),
        *(f"--relationships={name}={place / name}.csv" for name in RELATIONSHIPS),
    )
    words = ("database", "import", "full", "neo4j", *options, *files)
    run_admin(place / "java.args", cache.jar_set.class_path(cache.folder), home.root, words)
