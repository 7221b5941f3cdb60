"""Classic retrieval from Neo4j: the same trees as from memory, weights on the motion nodes, few round trips."""

from __future__ import annotations

import json
from collections import Counter

import neo4j
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from kitchen_stories import unit
from robot_kitchens import costs, deep_foons, foons, goals, kitchens, sought
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import Annotation, Subgraph
from foon_kg.model.errors import GraphError, NoTreeError, TooManyUnitsError
from foon_kg.model.levels import Level
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search.classic import Criterion, GoalSought, retrieve_tree
from foon_kg.store.graph import Neo4jGraph, load, load_weights, remove
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()
WEIGHTS = MotionCosts({"chop": 0.9, "mix": 0.25, "fly": 0.1})

pytestmark = pytest.mark.neo4j


def story(name, *lines):
    return Subgraph(name, tuple(Annotation(unit(line)) for line in lines))


SALAD = story(
    "salad",
    "onion(whole); knife > chop > onion(chopped)",
    "onion(chopped); bowl(empty) > mix > salad(mixed)",
    "salad(mixed) > serve > salad(served)",
)
SOUP = story("soup", "onion(whole); pot(empty) > mix > soup(mixed)", "onion(whole) > chop > onion(chopped)")


@pytest.fixture
def kept_costs(connection):
    """How many motion nodes have which verb and cost."""

    def ask():
        with connection.session() as session:
            rows = session.run(neo4j.Query("MATCH (m:Motion) RETURN m.verb AS verb, m.cost AS cost"))
            return Counter((row["verb"], row["cost"]) for row in rows)

    return ask


def test_more_units_than_memory_holds_are_refused_with_what_to_do(connection, empty_graph, monkeypatch):
    load(connection, [SALAD])
    sought_salad = GoalSought("salad", level=Level.STATES)
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        assert retrieve_tree(view, sought_salad, KITCHEN, MotionCosts()).units
        monkeypatch.setattr("foon_kg.search.classic.behind.MOST_UNITS", 1)
        with pytest.raises(TooManyUnitsError, match="more than 1 units") as refused:
            retrieve_tree(view, sought_salad, KITCHEN, MotionCosts())
    assert "level 3" in refused.value.hint


@settings(max_examples=6, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(foon=foons() | deep_foons(), goal=goals, beside=st.tuples(costs, kitchens))
def test_the_tree_is_the_one_that_memory_answers(connection, empty_graph, foon, goal, beside):
    weights, kitchen = beside
    with connection.session() as session:
        before = [row["name"] for row in session.run(neo4j.Query("MATCH (v:Video) RETURN v.name AS name"))]
    if before:
        remove(connection, before)
    load(connection, foon)
    snapshot = Snapshot.of(foon, KITCHEN)
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        assert view.called(["onion", "salad", "unicorn"]) == snapshot.called(["onion", "salad", "unicorn"])
        for level, by in zip(Level, (Criterion.UNITS, Criterion.SUCCESS, Criterion.UNITS), strict=True):
            asked = sought(goal, level, by)
            assert answer(view, asked, kitchen, weights) == answer(snapshot, asked, kitchen, weights)


def answer(view, asked, kitchen, weights):
    try:
        return retrieve_tree(view, asked, kitchen, weights, time_limit=None)
    except NoTreeError as error:
        return (error.code, error.message, error.hint)


def test_weights_are_kept_on_the_motion_nodes_and_say_what_only_one_side_knows(connection, empty_graph, kept_costs):
    load(connection, [SALAD])
    report = load_weights(connection, WEIGHTS)
    assert (report.motions, report.units) == (3, 2)
    assert (report.not_in_graph, report.without_weight) == (("fly",), ("serve",))
    assert kept_costs() == {("chop", 0.9): 1, ("mix", 0.25): 1, ("serve", None): 1}
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        assert view.motion_costs() == WEIGHTS


def test_loading_weights_again_changes_nothing_and_others_take_their_place(connection, kept_costs):
    load(connection, [SALAD])
    first = load_weights(connection, WEIGHTS)
    before = kept_costs()
    assert load_weights(connection, WEIGHTS) == first
    assert kept_costs() == before
    load_weights(connection, MotionCosts({"serve": 0.0}))
    assert kept_costs() == {("chop", None): 1, ("mix", None): 1, ("serve", 0.0): 1}


def test_units_that_come_later_have_their_weights_too(connection, empty_graph, kept_costs):
    load(connection, [SALAD])
    load_weights(connection, WEIGHTS)
    load(connection, [SALAD, SOUP])
    assert kept_costs() == {("chop", 0.9): 2, ("mix", 0.25): 2, ("serve", None): 1}
    load(connection, [SALAD, SOUP], Kitchen.default(["salt"]))  # another kitchen: the whole graph is written anew
    assert kept_costs() == {("chop", 0.9): 2, ("mix", 0.25): 2, ("serve", None): 1}


def test_a_graph_without_a_foon_takes_no_weights(connection):
    with pytest.raises(GraphError, match="no FOON"):
        load_weights(connection, WEIGHTS)


def test_a_retrieval_at_level_3_takes_a_handful_of_round_trips(connection, empty_graph):
    load(connection, [SALAD])
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        begun = view.round_trips
        tree = retrieve_tree(view, GoalSought("salad", ("served",)), KITCHEN, view.motion_costs())
        assert len(tree.units) == 3
        assert view.round_trips - begun <= 4


def test_both_commands_work_on_the_graph(connection, empty_graph, monkeypatch, tmp_path):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    load(connection, [SALAD])
    file = tmp_path / "weights.json"
    file.write_text(json.dumps(dict(WEIGHTS.costs)), encoding="utf-8")
    loaded = CliRunner().invoke(app, ["load", "weights", str(file), "--json"])
    assert json.loads(loaded.stdout)["units"] == 2
    assert "no unit of the graph has fly" in loaded.stderr
    found = CliRunner().invoke(app, ["retrieve", "salad", "--state", "served", "--by", "success", "--json"])
    assert found.exit_code == 0, found.stderr
    assert json.loads(found.stdout)["success"] == 0.0375
    assert "without a weight, taken as 0.5: serve" in found.stderr
    file.write_text('{"chop": 2}', encoding="utf-8")
    assert CliRunner().invoke(app, ["load", "weights", str(file)]).exit_code == 1
    again = CliRunner().invoke(app, ["retrieve", "salad", "--state", "served", "--by", "success", "--json"])
    assert again.stdout == found.stdout
