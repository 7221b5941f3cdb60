"""Reference trees that are kept in the graph: taken again for the same question, thrown out by what touches them."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor

import pytest
from examples import examples
from foons import foons
from hypothesis import given
from kitchen_stories import CHOP_ONION, SALAD, subgraph

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import UsageError
from foon_kg.model.knowledge import RetrievedTree
from foon_kg.planning import references
from foon_kg.planning.planner import plan
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import recall
from foon_kg.store.graph import Connection, Neo4jGraph, load, remove
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.remembering import keep_trees
from foon_kg.store.snapshot import Snapshot

pytestmark = pytest.mark.neo4j

BANANA = (
    "cutting board(empty); berry(whole); knife > slice > berry(sliced)@on cutting_board; cutting board{berry}",
    (
        "glass(empty); cutting board{berry}; berry(sliced)@on cutting_board"
        " > pour > glass{berry}; berry(sliced)@glass; cutting board(empty)"
    ),
    "glass{berry}; carton{lemonade}; lemonade(liquid)@carton > pour > glass{berry,lemonade}; lemonade(liquid)@glass",
)
STIR = (
    "glass{berry,lemonade}; berry(sliced)@glass; lemonade(liquid)@glass; spoon"
    " > stir > glass{drink}; drink{berry,lemonade}@glass"
)
SHORT_WAY = "onion(whole); cutting board(empty); knife > slice > onion(chopped)@on cutting_board; cutting board{onion}"

salad = subgraph("salad", "salad", *SALAD)
drink = subgraph("drink", "drinks", *BANANA, STIR)
with_a_fork = subgraph("with a fork", "drinks", *BANANA, STIR.replace("spoon", "fork"))
chopping = subgraph("chopping", "salad", *CHOP_ONION)
short_way = subgraph("short way", "salad", SHORT_WAY)

WANTS = {
    "salad": Recipe("salad", (RequiredIngredient("tomato", "diced"), RequiredIngredient("onion", "chopped"))),
    "drink": Recipe("drinks", (RequiredIngredient("berry", "sliced"), RequiredIngredient("lemonade", "liquid"))),
}


@pytest.fixture
def searches(monkeypatch):
    """The goals for which a reference tree was searched, not remembered."""
    searched = []

    def noted(problem, **limits):
        searched.append(problem.targets[0].label)
        return retrieve(problem, **limits)

    retrieve = recall.retrieve
    monkeypatch.setattr(recall, "retrieve", noted)
    assert references.retrieve_once is recall.retrieve_once
    return searched


def planned(graph, dish):
    with graph.reading() as view:
        return json.dumps(plan(view, WANTS[dish]).to_json())


def in_memory(dish, *subgraphs):
    return json.dumps(plan(Snapshot.of(subgraphs, Kitchen.default()), WANTS[dish]).to_json())


def kept(connection):
    """The labels of the goals whose trees are kept."""
    text = "MATCH (p:Plan)-[:ANSWERS]->(o) RETURN o.label ORDER BY o.label"
    return [label for (label,) in ask_freely(connection, text).rows]


def test_the_same_question_is_searched_once_and_answered_alike(connection, graph, searches):
    load(connection, [salad, drink])
    first = planned(graph, "salad")
    assert (kept(connection), searches) == (["salad"], ["salad"])
    assert planned(graph, "salad") == first == in_memory("salad", salad, drink)
    assert searches.count("salad") == 2  # the one in memory is the second


def test_another_program_takes_what_this_one_kept(connection, graph, empty_graph, searches):
    load(connection, [salad])
    planned(graph, "salad")
    with Neo4jGraph(empty_graph) as another:
        planned(another, "salad")
    assert searches == ["salad"]


def test_a_load_that_touches_another_dish_keeps_the_tree(connection, graph, searches):
    load(connection, [salad, drink])
    planned(graph, "salad")
    planned(graph, "drink")
    load(connection, [with_a_fork])
    planned(graph, "salad")
    assert searches == ["salad", "drink"]
    after = planned(graph, "drink")
    assert searches == ["salad", "drink", "drink"]
    assert after == in_memory("drink", salad, drink, with_a_fork)


def test_a_tree_is_not_taken_with_a_new_unit_far_behind_its_goal_though_no_old_one_changed(connection, graph):
    load(connection, [salad, drink])
    before = planned(graph, "salad")
    planned(graph, "drink")
    load(connection, [short_way])
    after = planned(graph, "salad")
    assert after == in_memory("salad", salad, drink, short_way)
    assert after != before


def test_a_tree_is_not_taken_without_a_unit_that_was_behind_its_goal(connection, graph):
    load(connection, [salad, drink, short_way])
    planned(graph, "salad")
    planned(graph, "drink")
    remove(connection, ["short way"])
    assert planned(graph, "salad") == in_memory("salad", salad, drink)


def test_with_a_goal_its_trees_go_and_nothing_dangles(connection, graph):
    load(connection, [salad, drink])
    planned(graph, "salad")
    planned(graph, "drink")
    load(connection, [subgraph("salad", "salad", *SALAD[:3])])
    assert kept(connection) == ["drink"]
    assert ask_freely(connection, "MATCH (p:Plan) RETURN count(*)").rows == ((1,),)


@examples(8)
@given(foons(("a", "b")), foons(("b", "c")))
def test_just_the_trees_of_nodes_that_go_go(connection, first, later):
    load(connection, first)
    was = Snapshot.of(first, Kitchen.default())
    nodes = {node for known in was.units for node in known.unit.output_nodes}
    keep_trees(connection, [RetrievedTree(node.key, "", node.key, (), ()) for node in nodes])
    load(connection, later)
    names = {subgraph.name for subgraph in later}
    now = Snapshot.of([*later, *(s for s in first if s.name not in names)], Kitchen.default())
    there = {n.key for known in now.units for n in (*known.unit.input_nodes, *known.unit.output_nodes)}
    left = {key for (key,) in ask_freely(connection, "MATCH (p:Plan) RETURN p.key").rows}
    assert left == {node.key for node in nodes} & there
    remove(connection, [subgraph.name for subgraph in now.subgraphs])
    assert ask_freely(connection, "MATCH (n) RETURN labels(n)").rows == ((["Foon"],),)


def test_a_video_that_shows_only_known_units_keeps_every_tree(connection, graph):
    load(connection, [salad])
    planned(graph, "salad")
    load(connection, [subgraph("the same again", "salad", *SALAD)])
    assert kept(connection) == ["salad"]
    again = subgraph("the same again", "salad", *SALAD)
    assert planned(graph, "salad") == in_memory("salad", salad, again)


def test_a_kept_tree_that_the_graph_has_outgrown_is_not_taken(connection, graph, searches):
    """As after a race: a plan read before a load and kept after it."""
    load(connection, [salad])
    with graph.reading() as view:
        plan(view, WANTS["salad"])
        load(connection, [short_way])
    assert kept(connection) == ["salad"]
    assert planned(graph, "salad") == in_memory("salad", salad, short_way)
    assert searches.count("salad") == 3  # searched anew, and once in memory
    planned(graph, "salad")
    assert searches.count("salad") == 3


def test_plans_and_loads_at_once_never_give_a_tree_of_another_state(connection, empty_graph):
    load(connection, [salad, drink])
    right = {in_memory("salad", salad, drink), in_memory("salad", salad, drink, short_way)}

    def cook(_):
        with Neo4jGraph(empty_graph) as own:
            return {planned(own, "salad") for _ in range(4)}

    def change(_):
        with Connection(empty_graph) as own:
            for _ in range(3):
                load(own, [short_way])
                remove(own, ["short way"])
        return set()

    with ThreadPoolExecutor(4) as programs:
        jobs = [programs.submit(work, n) for n, work in enumerate((cook, change, cook, cook))]
    assert set().union(*(job.result() for job in jobs)) <= right
    with Neo4jGraph(empty_graph) as own:
        assert planned(own, "salad") == in_memory("salad", salad, drink)


class ReadOnly(Connection):
    """What a user without the right to write has."""

    def session(self, *, writing=False):
        return super().session(writing=False)


def test_whoever_may_only_read_gets_the_same_answer_and_keeps_nothing(connection, graph, empty_graph, searches):
    load(connection, [salad])
    reader = Neo4jGraph(empty_graph)
    reader._connection = ReadOnly(empty_graph)
    with reader:
        assert planned(reader, "salad") == in_memory("salad", salad)
        assert kept(connection) == []
        planned(graph, "salad")
        before = len(searches)
        planned(reader, "salad")
        assert len(searches) == before


def test_a_plan_that_failed_keeps_nothing(connection, graph):
    load(connection, [salad])
    unknown = Recipe("brunch", WANTS["salad"].ingredients)
    with pytest.raises(UsageError), graph.reading() as view:
        assert plan(view, WANTS["salad"]).units != plan(view, unknown).units
    assert kept(connection) == []
