"""How much a graph holds, as Neo4j counts it: what the whole FOON in memory would count, whatever happened before."""

from __future__ import annotations

import pytest
from foons import foons
from hypothesis import HealthCheck, given, settings
from kitchen_stories import SALAD, subgraph

from foon_kg.model.errors import GraphError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import load, remove
from foon_kg.store.graph.counting import count
from foon_kg.store.graph.statements import SIZE, ask
from foon_kg.store.snapshot import Snapshot
from foon_kg.store.statistics import Statistics

pytestmark = pytest.mark.neo4j

salad = subgraph("salad", "salad", *SALAD)
shorter = subgraph("salad", "salad", *SALAD[:3])
omelette = subgraph("other", "omelette", *SALAD[2:])


def in_memory(*subgraphs):
    return Statistics.of(Snapshot.of(subgraphs, Kitchen.default()))


def test_what_a_video_showed_is_counted_no_longer_once_it_is_replaced_or_removed(connection):
    load(connection, [salad, omelette])
    assert count(connection) == in_memory(salad, omelette)
    load(connection, [shorter])
    assert count(connection) == in_memory(shorter, omelette)
    remove(connection, ["other"])
    assert count(connection) == in_memory(shorter)


def test_states_are_counted_with_each_load_and_not_looked_for(connection):
    load(connection, [salad, omelette])
    with connection.session(writing=True) as session:
        found = session.run(
            "MATCH (f:Foon) UNWIND range(0, size(f.states) - 1) AS place "
            "RETURN f.states[place] AS state, f.state_objects[place] AS objects"
        ).values()
        counted = session.run(
            "MATCH (o:Object) UNWIND o.states AS state RETURN state, count(*) ORDER BY state"
        ).values()
        assert found == counted
        session.run("MATCH (f:Foon) SET f.states = ['hot'], f.state_objects = [1]").consume()
    assert count(connection).states == 1


def test_states_that_nobody_counted_are_looked_for_and_stay_uncounted(connection):
    load(connection, [salad])
    with connection.session(writing=True) as session:
        session.run("MATCH (f:Foon) REMOVE f.states, f.state_objects").consume()
    load(connection, [omelette])
    assert count(connection) == in_memory(salad, omelette)


def foods_kept_and_there(connection):
    with connection.session() as session:
        kept, there = session.run(
            "MATCH (f:Foon) RETURN f.foods, COUNT { MATCH (i:Ingredient) WHERE EXISTS { (i)-[:SEEN_AS]->() } RETURN i }"
        ).single()
    return kept, there


def test_foods_are_counted_with_each_load_and_where_nobody_did_they_are_looked_for(connection):
    load(connection, [salad, omelette])
    kept, there = foods_kept_and_there(connection)
    assert kept == there > 0
    with connection.session(writing=True) as session:
        session.run("MATCH (f:Foon) SET f.foods = 1").consume()
        assert session.execute_read(ask, SIZE)[0].foods == 1
        session.run("MATCH (f:Foon) REMOVE f.foods").consume()
        assert session.execute_read(ask, SIZE)[0].foods == there
    remove(connection, ["other"])
    assert foods_kept_and_there(connection)[0] is None


@settings(max_examples=8, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(foons())
def test_any_foon_is_counted_as_in_memory(connection, subgraphs):
    load(connection, subgraphs)
    assert count(connection) == in_memory(*subgraphs)
    kept, there = foods_kept_and_there(connection)
    assert kept == there
    for one in subgraphs:
        remove(connection, [one.name])
        kept, there = foods_kept_and_there(connection)
        assert kept == there


def test_a_graph_without_a_foon_is_said_to_be_empty(connection):
    with pytest.raises(GraphError, match="holds no FOON yet"):
        count(connection)
