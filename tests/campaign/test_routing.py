"""``neo4j://``: a cluster whose leader changes, whose followers are behind or whose members only read."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest
from campaign.scripted_cluster import COMMIT, RUN, ScriptedCluster
from campaign.whole_graph import whole_graph
from kitchen_stories import SALAD, subgraph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.language.collection import CollectionReader
from foon_kg.model.collected import CollectedLine, CollectedRecipe
from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection, Neo4jGraph, load, remove
from foon_kg.store.graph.recipes import load_recipes, prepare_for_recipes, recipe_count

pytestmark = pytest.mark.neo4j

VIDEOS = tuple(subgraph(f"video {n}", "salad", *SALAD[: len(SALAD) - n]) for n in range(3))
RECIPES = tuple(
    CollectedRecipe(f"r{n}", "Green Salad", (CollectedLine("1 onion, chopped", "onion", "", "1", ""),), f"file: {n}")
    for n in range(6)
)
PLAN = ("plan", "--dish", "salad", "chopped onion", "whole tomato", "--json")


@pytest.fixture
def cluster(empty_graph, tmp_path, monkeypatch):
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "cache"))
    with ScriptedCluster(empty_graph) as cluster:
        for name in ("uri", "user", "password", "database"):
            monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(cluster.settings, name))
        yield cluster


def alone(cluster):
    """The real server, addressed directly."""
    return Connection(replace(cluster.settings, uri=f"bolt://127.0.0.1:{cluster.server[1]}"))


def foon(*words):
    return CliRunner().invoke(app, list(words))


def test_what_writes_goes_to_the_leader_and_what_reads_to_followers(cluster):
    with Connection(cluster.settings) as connection:
        load(connection, demo_subgraphs())
        loading = cluster.told()
        with Neo4jGraph(cluster.settings) as graph, graph.reading() as view:
            assert view.video_names()
    asked = cluster.told()
    assert {member for member, reading, _ in loading if not reading} == {cluster.leader}
    assert [reading for _, reading, _ in asked] == [True]
    assert asked[0][0] is not cluster.leader


def changing(cluster, kind, number, *, loses):
    """Another member leads from that message on, with which the old leader's connection is lost, or may not be."""

    def change(member, asked, count):
        if (asked, count) != (kind, number):
            return False
        cluster.leader = next(one for one in cluster.members if one is not member)
        return loses

    cluster.loses = change


IN_A_TEST = (30, True)
"""The message at which the leader changes as a test, and whether its connection is lost; the others take a campaign."""


@pytest.mark.parametrize(
    ("at", "loses"),
    [
        pytest.param(at, loses, id=f"{at}-{said}", marks=[] if (at, loses) == IN_A_TEST else pytest.mark.campaign)
        for at in (9, 30, 57)
        for loses, said in ((False, "it steps down"), (True, "its connection is lost"))
    ],
)
def test_a_load_whose_leader_changes_in_the_middle_stores_all_of_it_once(cluster, at, loses):
    changing(cluster, RUN, at, loses=loses)
    with Connection(cluster.settings) as connection:
        report = load(connection, VIDEOS, units_per_transaction=1)
    assert len(report.inserted) == len(VIDEOS)
    assert len({member for member, reading, _ in cluster.told() if not reading}) == 2
    with alone(cluster) as connection:
        found = whole_graph(connection)
        remove(connection, [video.name for video in VIDEOS])
        load(connection, VIDEOS, units_per_transaction=1)
        assert whole_graph(connection) == found


def test_a_load_whose_leader_is_lost_while_it_stores_says_so_and_goes_on_when_it_is_done_again(cluster):
    changing(cluster, COMMIT, 4, loses=True)
    with Connection(cluster.settings) as connection:
        with pytest.raises(GraphError, match="lost while it stored") as told:
            load(connection, VIDEOS, units_per_transaction=1)
        assert "Do it again" in told.value.hint
        report = load(connection, VIDEOS, units_per_transaction=1)
        assert {*report.inserted, *report.unchanged} == {video.name for video in VIDEOS}


def test_recipes_whose_leader_changes_are_stored_and_counted_once(cluster):
    changing(cluster, RUN, 14, loses=True)
    with Connection(cluster.settings) as connection:
        prepare_for_recipes(connection)
        stored = load_recipes(connection, RECIPES, CollectionReader({}).understand, recipes_per_transaction=1)
    assert stored.inserted == len(RECIPES)
    assert cluster.leader is not cluster.members[0]
    with alone(cluster) as connection:
        assert recipe_count(connection).recipes == len(RECIPES)


@pytest.mark.slow
def test_a_plan_of_another_program_after_a_load_waits_for_a_follower_that_is_behind(cluster):
    with Connection(cluster.settings) as connection:
        load(connection, demo_subgraphs())
    cluster.behind = set(cluster.members[1:])
    cluster.told()
    with ThreadPoolExecutor(1) as pool:
        asked = pool.submit(foon, *PLAN)
        member, reading, waits = cluster.begun.get()
        held = member in cluster.behind and reading and waits
        done = asked.done()
        cluster.catch_up()
        answer = asked.result()
    assert held, "it would have been answered from what the follower had before the load"
    assert not done
    assert json.loads(answer.stdout)["units"]


def test_a_member_that_never_gets_what_was_written_is_told_with_what_to_do(cluster, tmp_path):
    with Connection(cluster.settings) as connection:
        load(connection, VIDEOS)
    cluster.stuck = set(cluster.members)
    with Neo4jGraph(cluster.settings) as graph, pytest.raises(GraphError, match="written last") as told:
        graph.snapshot()
    assert str(tmp_path / "cache" / "bookmarks") in told.value.hint
    assert told.value.code == "behind"


@pytest.mark.slow
def test_plans_are_made_where_no_member_may_be_written_to(cluster):
    with Connection(cluster.settings) as connection:
        load(connection, demo_subgraphs())
    cluster.leader = None
    cluster.told()
    answer = foon(*PLAN)
    assert answer.exit_code == 0, answer.output
    assert json.loads(answer.stdout)["units"]
    assert {reading for _, reading, _ in cluster.told()} == {True}
