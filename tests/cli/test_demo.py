"""The demo, and planning from a real Neo4j: the same answers as from files."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.demo import NEXT, RECIPE, demo_subgraphs
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.plans.result import PlanResult
from foon_kg.store import server

pytestmark = pytest.mark.neo4j


@pytest.fixture
def demo(empty_graph, monkeypatch):
    """``foon demo`` on the Neo4j of the tests in the place of the user's own."""
    monkeypatch.setattr(server, "ensure_running", lambda _say: empty_graph)
    return lambda *options: CliRunner().invoke(app, ["demo", *options])


@pytest.fixture
def foon(empty_graph, monkeypatch):
    """``foon`` with the Neo4j of the tests named by the environment."""
    monkeypatch.setenv("NEO4J_URI", empty_graph.uri)
    monkeypatch.setenv("NEO4J_USER", empty_graph.user)
    monkeypatch.setenv("NEO4J_PASSWORD", empty_graph.password)
    monkeypatch.setenv("NEO4J_DATABASE", empty_graph.database)
    return lambda *arguments: CliRunner().invoke(app, [str(argument) for argument in arguments])


def test_the_demo_shows_a_tree_for_a_food_that_its_foon_has_not_seen(demo):
    answer = demo()
    assert answer.exit_code == 0, answer.stderr
    assert "~kohlrabi is handled like" in answer.stdout
    assert answer.stdout.count("\n  ~kohlrabi\n") == 1
    assert NEXT in answer.stderr
    known = {node.label for subgraph in demo_subgraphs() for a in subgraph.annotations for node in a.unit.input_nodes}
    assert "kohlrabi" not in known


def test_the_demo_again_changes_nothing_and_answers_the_same(demo):
    first, again = demo("--json"), demo("--json")
    count = len(demo_subgraphs())
    assert f"Loaded {count} of the demo's {count} subgraphs." in first.stderr
    assert f"Loaded 0 of the demo's {count} subgraphs, {count} were there already." in again.stderr
    assert first.stdout == again.stdout
    assert PlanResult.from_json(json.loads(first.stdout)).recipe.id == RECIPE


def test_a_plan_from_neo4j_is_the_plan_from_the_files(foon):
    assert foon("load", "foon", demo_folder()).exit_code == 0
    from_graph = foon("plan", *demo_recipes(), "--json")
    from_files = foon("plan", *demo_recipes(), "--json", "--files", demo_folder())
    assert from_graph.exit_code == from_files.exit_code
    assert from_graph.stdout == from_files.stdout


def test_a_plan_from_a_neo4j_that_does_not_answer_says_where_and_what_to_do(foon, monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "bolt://127.0.0.1:9")
    answer = foon("plan", "--dish", "salad", "chopped onion")
    assert (answer.exit_code, answer.stdout) == (1, "")
    error, hint = answer.stderr.splitlines()
    assert "bolt://127.0.0.1:9" in error
    assert "NEO4J_URI" in hint
