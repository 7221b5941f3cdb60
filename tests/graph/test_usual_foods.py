"""Which food an operator is most often done to, and which it most often changes, is right whatever comes and goes."""

from __future__ import annotations

import random

import pytest
from kitchen_stories import SALAD, subgraph

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.store.graph import load, remove
from foon_kg.store.graph.free_cypher import ask_freely

pytestmark = pytest.mark.neo4j

KEPT = "MATCH (o:Operator) RETURN o.key, [o.most_done, o.most_changed]"
COUNTED = "MATCH (o:Operator)-[d:DONE_TO]->(m:Food) RETURN o.key, m.name, d.units, d.changed"


def kept(connection):
    return dict(ask_freely(connection, KEPT, limit=10_000).rows)


def counted(connection):
    """Return the same from all counts."""
    foods = {operator: [] for operator in kept(connection)}
    for operator, food, units, changed in ask_freely(connection, COUNTED, limit=100_000).rows:
        foods[operator].append((-units, -changed, food))
    found = {}
    for operator, rows in foods.items():
        done = min(((units, food) for units, _, food in rows), default=(0, None))[1]
        changes = min(((changed, food) for _, changed, food in rows if changed), default=(0, None))[1]
        found[operator] = [done, changes]
    return found


def test_the_usual_foods_are_those_of_all_counts(connection):
    subgraphs = [result.subgraph for result in read_paths([demo_folder()])]
    random.Random(3).shuffle(subgraphs)
    half = len(subgraphs) // 2
    for there in (subgraphs[:half], subgraphs[half:]):
        load(connection, there)
        assert kept(connection) == counted(connection)
    assert any(done != changes for done, changes in kept(connection).values())
    for gone in (subgraphs[:3], subgraphs[3:half]):
        remove(connection, [one.name for one in gone])
        assert kept(connection) == counted(connection)


def test_a_food_that_is_done_more_often_and_changed_less_often_may_be_the_usual_one(connection):
    onions = [f"onion({state}); knife > chop > onion(chopped); knife" for state in ("whole", "peeled")]
    changed = "tomato(whole); knife > chop > tomato(chopped); knife"
    as_before = [f"tomato({state}); knife > chop > tomato({state}); knife" for state in ("whole", "ripe", "raw")]
    load(connection, [subgraph("onions", "salad", *onions), subgraph("tomatoes", "salad", changed)])
    assert list(kept(connection).values()) == [["onion", "onion"]]
    load(connection, [subgraph("tomatoes", "salad", *as_before)])
    assert list(kept(connection).values()) == [["tomato", "onion"]]
    assert kept(connection) == counted(connection)


def test_an_operator_without_a_food_has_no_usual_one(connection):
    salad, shorter = subgraph("salad", "salad", *SALAD), subgraph("salad", "salad", *SALAD[:2])
    load(connection, [salad])
    load(connection, [shorter])
    assert kept(connection) == counted(connection)
