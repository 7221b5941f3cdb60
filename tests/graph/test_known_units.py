"""Units as the graph answers them: in memory that grows with them, and also while somebody removes them."""

from __future__ import annotations

from copy import deepcopy

import pytest

from foon_kg.cli.demo import demo_subgraphs
from foon_kg.cypher import named_query
from foon_kg.store.graph import Neo4jGraph, load, reading
from foon_kg.store.graph.known_units import known_units
from foon_kg.store.graph.rows import KnownUnitsRow


def test_a_unit_that_goes_while_the_graph_answers_is_left_out():
    gone = (None, None, None, [], [], [])
    assert list(known_units(KnownUnitsRow([(None, None, None, None)], [gone], []))) == []


def edges_without_properties(_, unit):
    for sighting in unit[-1]:
        sighting[1:] = [None] * (len(sighting) - 1)


def an_input_less(_, unit):
    unit[3].pop()


def an_output_less(_, unit):
    unit[4].pop()


def no_sightings(_, unit):
    unit[-1].clear()


def a_node_untold(row, unit):
    row.nodes[:] = [node for node in row.nodes if node[0] != unit[4][0]]


@pytest.mark.neo4j
@pytest.mark.parametrize("torn", [edges_without_properties, an_input_less, an_output_less, no_sightings, a_node_untold])
def test_what_goes_while_the_graph_answers_takes_nothing_else_with_it(connection, torn):
    load(connection, demo_subgraphs())
    with connection.session() as session:
        keys = session.run("MATCH (m:Motion) RETURN m.key AS key ORDER BY key").value()
        told = session.run(named_query("known_units").text, keys=keys).single(strict=True).data()
    whole = {known.unit.key: known for known in known_units(KnownUnitsRow(**deepcopy(told)))}
    assert whole.keys() == set(keys)
    for place in range(0, len(keys), 17):
        row = KnownUnitsRow(**deepcopy(told))
        torn(row, row.units[place])
        left = {known.unit.key: known for known in known_units(row)}
        assert row.units[place][0] not in left
        assert all(known == whole[key] for key, known in left.items())
        assert torn is a_node_untold or len(left) == len(keys) - 1


def memory_for(connection, keys):
    """Return the bytes of memory that the server takes for these units."""
    with connection.session() as session, session.begin_transaction() as transaction:
        result = transaction.run(f"PROFILE {named_query('known_units').text}", keys=keys)
        return max(numbers(result.consume().profile))


def numbers(operator):
    yield operator["args"].get("GlobalMemory") or 0
    for child in operator.get("children", ()):
        yield from numbers(child)


MOST_OF_A_UNIT = 20_000
"""Bytes; one takes 2,000, and took 170,000 where all nodes were in the key of each group, growing with their number."""


@pytest.mark.neo4j
def test_units_take_memory_by_their_number(connection):
    load(connection, demo_subgraphs())
    with connection.session() as session:
        keys = session.run("MATCH (m:Motion) RETURN m.key AS key ORDER BY key").value()
    assert len(keys) > 100
    assert 0 < memory_for(connection, keys) <= MOST_OF_A_UNIT * len(keys)


@pytest.mark.neo4j
def test_in_how_many_questions_units_are_asked_for_changes_none(connection, graph, empty_graph, monkeypatch):
    load(connection, demo_subgraphs())
    goals = [node for one in demo_subgraphs() for node in one.annotations[-1].unit.output_nodes]
    with graph.reading() as view:
        whole = view.behind(goals)
    monkeypatch.setattr(reading, "UNITS_AT_ONCE", 7)
    with Neo4jGraph(empty_graph) as another, another.reading() as view:
        assert view.behind(goals) == whole
        assert view.round_trips > 10


@pytest.mark.neo4j
def test_in_how_many_questions_foods_are_asked_for_loses_none(connection, graph, empty_graph, monkeypatch):
    load(connection, demo_subgraphs())
    with graph.reading() as view:
        whole = view.vocabulary()
        assert view.words_named(whole.labels).foods == whole.foods
    monkeypatch.setattr(reading, "FOODS_AT_ONCE", 7)
    with Neo4jGraph(empty_graph) as another, another.reading() as view:
        assert view.words_named(whole.labels).foods == whole.foods
        assert view.round_trips > 3
