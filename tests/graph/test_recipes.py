"""Collections of recipes in the graph: nothing twice, nothing lost, and a killed load goes on."""

from __future__ import annotations

import json
import signal
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kitchen_stories import SALAD, subgraph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.language.collection import CollectionReader
from foon_kg.loaders import read_paths
from foon_kg.model.collected import CalledFor, CollectedLine, CollectedRecipe, DishClass
from foon_kg.model.errors import SchemaError, UsageError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, Neo4jGraph, load, remove
from foon_kg.store.graph.recipes import (
    class_counts,
    load_recipes,
    prepare_for_recipes,
    recipe_count,
    recipe_ids,
    stored_recipe,
    wanted_foods,
)

pytestmark = pytest.mark.neo4j

UNSEEN = "jicama"


def recipe(number, *foods, title="Green Salad", **more):
    lines = tuple(CollectedLine(f"1 {food}, chopped", food, "", "1", "") for food in foods or ("onion", UNSEEN))
    return CollectedRecipe(f"r{number:03}", title, lines, f"layer1.json: element {number}", **more)


@pytest.fixture
def connection(empty_graph):
    with Connection(empty_graph) as connection:
        prepare_for_recipes(connection)
        yield connection


@pytest.fixture
def environment(empty_graph, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))


def bring(connection, recipes, **more):
    return load_recipes(connection, recipes, CollectionReader({}).understand, **more)


def count(connection, pattern):
    with connection.session() as session:
        return session.run(f"MATCH {pattern} RETURN count(*) AS n").single()["n"]


def foon(*words):
    return CliRunner().invoke(app, list(map(str, words)))


def test_a_recipe_comes_back_as_it_was_understood(connection):
    bring(connection, [recipe(1, title="Onion Soup with Bread", url="http://x.example", partition="train")])
    stored = stored_recipe(connection, "r001")
    assert stored.title == "Onion Soup with Bread"
    assert stored.dish_classes == (DishClass("soup", sure=True), DishClass("bread", sure=False))
    assert stored.ingredients == (
        CalledFor("onion", "chopped", "1 onion, chopped", "1", ""),
        CalledFor(UNSEEN, "chopped", f"1 {UNSEEN}, chopped", "1", ""),
    )


def test_the_same_food_twice_is_called_for_twice_in_the_order_of_the_recipe(connection):
    bring(connection, [recipe(1, "salt", "onion", "salt")])
    assert [called.object for called in stored_recipe(connection, "r001").ingredients] == ["salt", "onion", "salt"]


def test_loading_again_changes_nothing_and_reads_nothing_again(connection):
    recipes = [recipe(number) for number in range(7)]
    assert bring(connection, recipes, recipes_per_transaction=3).inserted == 7
    understood = []
    again = load_recipes(connection, recipes, lambda batch: understood.extend(batch) or ())
    assert (again.inserted, again.replaced, again.unchanged, understood) == (0, 0, 7, [])
    assert count(connection, "(:Recipe)-[:CALLS_FOR]->()") == 14


def test_a_recipe_with_another_content_is_replaced(connection):
    bring(connection, [recipe(1)])
    assert bring(connection, [recipe(1, "leek", title="Cherry Pie")]).replaced == 1
    stored = stored_recipe(connection, "r001")
    assert [called.object for called in stored.ingredients] == ["leek"]
    assert [dish.name for dish in stored.dish_classes] == ["pie"]


def test_another_way_of_understanding_reads_everything_again(connection):
    bring(connection, [recipe(1)], version="1")
    assert bring(connection, [recipe(1)], version="2").replaced == 1


def test_after_each_transaction_its_recipes_are_safe_and_counted(connection):
    seen = []
    bring(
        connection,
        [recipe(number) for number in range(5)],
        stored=lambda report: seen.append((len(report), count(connection, "(:Recipe)"))),
        recipes_per_transaction=2,
    )
    assert [size for size, _ in seen] == [2, 2, 1]
    assert all(there >= sum(size for size, _ in seen[: place + 1]) for place, (_, there) in enumerate(seen))


KILLED = """
import os, signal, sys
sys.path[:0] = {path!r}
from foon_kg.language.collection import CollectionReader
from foon_kg.store.graph import Connection
from foon_kg.store.graph.recipes import load_recipes
from foon_kg.store.settings import ConnectionSettings
from foon_kg.model.collected import CollectedLine, CollectedRecipe

settings = ConnectionSettings(*sys.argv[1:5])
recipes = [
    CollectedRecipe(f"r{{n:03}}", "Green Salad", (CollectedLine("1 onion, chopped", "onion", "", "1", ""),), "x")
    for n in range(40)
]
stored = []

def tell(report):
    stored.append(report)
    if len(stored) == 2:
        os.kill(os.getpid(), signal.SIGKILL)

with Connection(settings) as connection:
    load_recipes(connection, recipes, CollectionReader({{}}).understand, stored=tell, recipes_per_transaction=5)
"""


def test_a_killed_load_goes_on_behind_what_is_safe(connection, empty_graph):
    login = (empty_graph.uri, empty_graph.user, empty_graph.password, empty_graph.database)
    program = KILLED.format(path=sys.path)
    ended = subprocess.run([sys.executable, "-c", program, *login], check=False, capture_output=True)
    assert ended.returncode == -signal.SIGKILL, ended.stderr.decode()
    there = count(connection, "(:Recipe)")
    assert 10 <= there < 40
    assert there % 5 == 0, "a batch is there whole or not at all"
    recipes = [recipe(number, "onion") for number in range(40)]
    report = bring(connection, recipes)
    assert report.unchanged >= 10
    assert len(report) == count(connection, "(:Recipe)") == 40
    assert count(connection, "(:Recipe)-[:CALLS_FOR]->(:Ingredient)") == 40


def test_a_foon_loaded_over_recipes_and_removed_again_leaves_them(connection):
    bring(connection, [recipe(1, "onion", UNSEEN)])
    load(connection, [subgraph("salad", "salad", *SALAD)])
    other_kitchen = Kitchen.default().with_foods(["knife"])  # everything but the recipes is written anew
    load(connection, [subgraph("salad", "salad", *SALAD)], other_kitchen)
    remove(connection, ["salad"], other_kitchen)
    assert [called.object for called in stored_recipe(connection, "r001").ingredients] == ["onion", UNSEEN]
    assert recipe_ids(connection, "salad") == ["r001"]


def test_recipes_make_no_food_known_and_no_dish_type_possible(connection, empty_graph):
    load(connection, [subgraph("salad", "salad", *SALAD)])
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        before, goals = view.vocabulary(), view.goals()
    bring(connection, [recipe(1, UNSEEN, title="Jicama Stew"), recipe(2, "onion", title="Onion Salad")])
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        assert view.vocabulary() == before
        assert view.goals() == goals
        assert all(near.name != UNSEEN for nearest in view.equivalents([UNSEEN]) for near in nearest)


def test_the_table_counts_what_is_sure_and_what_no_unit_has(connection):
    load(connection, [subgraph("salad", "salad", *SALAD)])
    unsure = recipe(2, UNSEEN, title="Delight with Salad")
    bring(connection, [recipe(1, "tomato", UNSEEN), unsure, recipe(3, "tomato")])
    (row,) = class_counts(connection)
    assert (row.dish_type, row.recipes, row.ingredients, row.unseen) == ("salad", 2, 3, 1)
    total = recipe_count(connection)
    assert (total.recipes, total.sure, total.foods) == (3, 2, 2)


def test_wanted_foods_are_ranked_by_recipes_not_by_lines(connection):
    bring(connection, [recipe(1, "sumac", "sumac", "sumac"), recipe(2, UNSEEN), recipe(3, UNSEEN)])
    assert [(row.food, row.recipes, row.states) for row in wanted_foods(connection, 5)] == [
        (UNSEEN, 2, ["chopped"]),
        ("sumac", 1, ["chopped"]),
    ]


FOODS = ("onion", "tomato", UNSEEN, "sumac")
TITLES = ("Green Salad", "Hot Soup", "Delight with Salad")


@settings(max_examples=12)
@given(st.lists(st.tuples(st.integers(0, 5), st.sampled_from(TITLES), st.lists(st.sampled_from(FOODS), min_size=1))))
def test_what_is_kept_is_what_counting_gives(emptied_server, drawn):
    with Connection(emptied_server) as connection:
        prepare_for_recipes(connection)
        for number, title, foods in drawn:
            bring(connection, [recipe(number, *foods, title=title)])
        kept = everything_counted(connection)
        with connection.session(writing=True) as session:
            session.run(FORGET_COUNTS).consume()
        prepare_for_recipes(connection)
        assert everything_counted(connection) == kept


FORGET_COUNTS = """
MATCH (f:Foon) REMOVE f.recipes, f.sure_recipes
WITH f MATCH (n:DishType|Ingredient) REMOVE n.recipes
WITH f MATCH ()-[r:USED_IN|ASKED_AS]->() DELETE r
"""


def everything_counted(connection):
    return recipe_count(connection), class_counts(connection), wanted_foods(connection, 9)


def test_recipes_that_were_never_counted_are_said_to_be_and_counted_by_the_next_load(connection, monkeypatch):
    monkeypatch.setattr("foon_kg.store.graph.recipe_counts.RECIPES_COUNTED_AT_ONCE", 2)
    recipes = [recipe(number, "onion", UNSEEN) for number in range(5)]
    bring(connection, recipes)
    kept = everything_counted(connection)
    with connection.session(writing=True) as session:
        session.run(FORGET_COUNTS).consume()
    for question in (recipe_count, class_counts, lambda c: wanted_foods(c, 3)):
        with pytest.raises(SchemaError, match="kept no counts"):
            question(connection)
    prepare_for_recipes(connection)
    assert bring(connection, recipes).unchanged == 5
    assert everything_counted(connection) == kept


def test_counts_are_kept_where_the_foon_is_written_anew(connection):
    bring(connection, [recipe(1, "onion", UNSEEN)])
    load(connection, [subgraph("salad", "salad", *SALAD)])
    load(connection, [subgraph("salad", "salad", *SALAD)], Kitchen.default().with_foods(["knife"]))
    (row,) = wanted_foods(connection, 1)
    assert (row.food, row.recipes, row.states) == (UNSEEN, 1, ["chopped"])
    assert class_counts(connection)[0].ingredients == 2


def test_nothing_is_counted_where_there_is_nothing(empty_graph):
    with Connection(empty_graph) as connection:
        assert recipe_count(connection).recipes == 0
        assert (class_counts(connection), wanted_foods(connection, 3)) == ([], [])


def test_a_recipe_that_is_not_there_is_said_to_be(connection):
    with pytest.raises(UsageError, match="no recipe “nowhere”"):
        stored_recipe(connection, "nowhere")


@pytest.fixture
def layer1(tmp_path):
    rows = [
        {"id": f"x{n}", "title": "Onion Soup", "ingredients": [{"text": "1 onion, chopped"}, {"text": "123"}]}
        for n in range(4)
    ]
    (tmp_path / "layer1.json").write_text(json.dumps([*rows, {"id": "bad"}]), encoding="utf-8")
    return tmp_path


def test_the_command_loads_nothing_when_more_is_unusable_than_allowed(environment, layer1):
    answer = foon("load", "recipes", layer1)
    assert answer.exit_code == 1
    assert "element 5" in answer.stderr
    assert "--bad-tolerance 1" in answer.stderr


def test_the_command_loads_reports_and_draws(environment, layer1, tmp_path):
    report = tmp_path / "report.jsonl"
    answer = foon("load", "recipes", layer1, "--bad-tolerance", 1, "--report", report, "--json")
    counts = json.loads(answer.stdout)
    assert {name: counts[name] for name in ("inserted", "recipes", "rejected_recipes", "foods", "left_over")} == {
        "inserted": 4,
        "recipes": 4,
        "rejected_recipes": 1,
        "foods": 4,
        "left_over": 4,
    }
    kinds = [json.loads(line)["kind"] for line in report.read_text(encoding="utf-8").splitlines()]
    assert kinds == ["bad-field", *["no-food"] * 4]
    drawn = [json.loads(foon("recipes", "--sample", 2, "--dish", "soup", "--seed", 3, "--json").stdout) for _ in "ab"]
    assert drawn[0] == drawn[1]
    assert len({row["id"] for row in drawn[0]}) == 2
    table = json.loads(foon("recipes", "--json").stdout)
    assert table["dish_types"] == [{"dish_type": "soup", "recipes": 4, "ingredients": 4, "unseen": 4}]
    assert json.loads(foon("recipes", "--unseen", 1, "--json").stdout)[0]["food"] == "onion"


def test_a_recipe_of_the_graph_is_planned_by_its_id(environment, connection):
    load(connection, [result.subgraph for result in read_paths([demo_folder()])])
    bring(connection, [recipe(1, "tomato", "cucumber"), recipe(2, "onion", title="Delight")])
    planned = json.loads(foon("plan", "--recipe", "r001", "--json").stdout)
    assert planned["recipe"]["id"] == "r001"
    assert planned["recipe"]["dish_type"] == "salad"
    assert {wanted["object"] for wanted in planned["recipe"]["ingredients"]} == {"tomato", "cucumber"}
    assert planned["units"]
    asked = json.loads(foon("plan", "--recipe", "r002", "--dish", "soup", "--json").stdout)
    assert asked["recipe"]["dish_type"] == "soup"


@pytest.mark.parametrize("words", [[], ["chopped onion", "--recipe", "r001"], ["--recipe", "nowhere"]])
def test_what_is_to_be_planned_must_be_said_once_and_be_there(environment, connection, words):
    assert foon("plan", *words).exit_code == 2


@pytest.mark.parametrize(
    "words",
    [
        ["--sample", "1", "--unseen", "1"],
        ["--dish", "salad"],
        ["--partition", "val"],
        ["--sample", "1", "--dish", "gruel"],
        ["--sample", "1", "--partition", "val"],
    ],
)
def test_wrong_usage_of_recipes_is_said(environment, words):
    assert foon("recipes", *words).exit_code == 2
