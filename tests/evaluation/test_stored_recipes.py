"""``foon evaluate recipes`` without files: recipes are drawn from those that the graph keeps of each dish type."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.language.collection import CollectionReader
from foon_kg.loaders import read_paths
from foon_kg.model.collected import CollectedLine, CollectedRecipe
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.recipes import load_recipes, prepare_for_recipes

pytestmark = pytest.mark.neo4j

SALADS = {f"s{number}": ("Green Salad", ("onion", "tomato")[: 1 + number % 2]) for number in range(5)}
OTHERS = {"unsure": ("Onion Soup with Salad", ("onion",)), "roast": ("Pork Roast", ("onion",))}


def collected(name, title, foods):
    lines = tuple(CollectedLine(f"1 {food}, chopped", food, "", "1", "") for food in foods)
    return CollectedRecipe(name, title, lines, f"layer1.json: {name}")


@pytest.fixture
def graph(empty_graph, monkeypatch):
    """The demo's FOON and a collection of recipes, in the database that the command uses."""
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    with Connection(empty_graph) as connection:
        load(connection, [one.subgraph for one in read_paths([demo_folder()])])
        prepare_for_recipes(connection)
        recipes = [collected(name, *rest) for name, rest in {**SALADS, **OTHERS}.items()]
        load_recipes(connection, recipes, CollectionReader({}).understand)


def evaluate(*arguments):
    return CliRunner().invoke(app, ["evaluate", "recipes", "--jobs", "1", "--json", *map(str, arguments)])


def ids(answer):
    assert answer.exit_code == 0, answer.output
    return [recipe["id"] for recipe in json.loads(answer.stdout)["recipes"]]


def test_stored_recipes_are_drawn_by_seed_and_get_the_figures_that_they_get_from_files(graph, tmp_path):
    answer = evaluate("--dish", "salad", "--dish", "roast", "--sample", 2, "--seed", 1)
    found = ids(answer)
    assert len(found) == 2
    assert set(found) <= SALADS.keys()  # those that surely are salads
    assert [dish["dish_type"] for dish in json.loads(answer.stdout)["left_out"]] == ["roast"]
    for name in found:
        title, foods = SALADS[name]
        ingredients = [{"object": food, "state": "chopped"} for food in foods]
        recipe = {"id": name, "title": title, "type": "salad", "ingredients": ingredients}
        (tmp_path / f"{name}.json").write_text(json.dumps(recipe), encoding="utf-8")
    from_files = json.loads(evaluate(tmp_path, "--seed", 1).stdout)
    assert from_files["recipes"] == json.loads(answer.stdout)["recipes"]
    assert ids(evaluate("--dish", "salad", "--sample", 2, "--seed", 2)) != found
