"""The edit distance of trees, against its definition where graphs are small, and by hand."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kitchen_stories import unit

from foon_kg.evaluation.edit_distance import EditDistance, UnitGraph, edit_distance, unit_graph


@st.composite
def graphs(draw, most=5):
    names = tuple(draw(st.lists(st.sampled_from("ab"), max_size=most)))
    pairs = [(start, end) for end in range(len(names)) for start in range(end)]
    return UnitGraph(names, frozenset(draw(st.sets(st.sampled_from(pairs), max_size=6)) if pairs else ()))


def least_edits(one, other):
    """The definition: of all ways to lay units onto units of their name, or onto nothing, the one with least edits."""
    least = len(one.names) + len(one.ways) + len(other.names) + len(other.ways)
    nothing = [None] * len(one.names)
    for laid in set(itertools.permutations([*range(len(other.names)), *nothing], len(one.names))):
        pairs = [(place, there) for place, there in enumerate(laid) if there is not None]
        if any(one.names[place] != other.names[there] for place, there in pairs):
            continue
        kept = {(laid[start], laid[end]) for start, end in one.ways} & other.ways
        apart = len(one.names) + len(other.names) - 2 * len(pairs)
        least = min(least, apart + len(one.ways) + len(other.ways) - 2 * len(kept))
    return least


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(graphs(most=4), graphs(most=4))
def test_the_distance_is_the_least_of_all_ways_to_lay_one_graph_onto_the_other(one, other):
    found = edit_distance(one, other)
    assert found.proven
    assert found.edits == least_edits(one, other)
    assert edit_distance(other, one).edits == found.edits


@given(graphs(most=8))
def test_a_graph_is_no_edit_away_from_itself(graph):
    found = edit_distance(graph, graph)
    assert found.edits == 0
    assert found.closeness == (1 if graph.names else 0)


def test_ways_lead_from_the_last_unit_that_made_a_node():
    units = [unit("onion > chop > onion(chopped)"), unit("onion(peeled) > chop > onion(chopped)")]
    units.append(unit("onion(chopped); pan > fry > onion(fried)"))
    assert unit_graph(units, "abc") == UnitGraph(("a", "b", "c"), frozenset({(1, 2)}))


def test_a_unit_more_in_the_middle_costs_itself_and_its_ways():
    short = UnitGraph(("chop", "fry"), frozenset({(0, 1)}))
    long = UnitGraph(("chop", "pour", "fry"), frozenset({(0, 1), (1, 2)}))
    found = edit_distance(short, long)
    assert found == EditDistance(edits=4, size=8)
    assert found.closeness == 0.5


def test_a_search_that_is_given_up_says_so_and_answers_what_it_found():
    many = UnitGraph(("pour",) * 6, frozenset((start, end) for end in range(6) for start in range(end)))
    found = edit_distance(many, many, most_steps=5)
    assert not found.proven
    assert 0 <= found.edits <= found.size
    assert edit_distance(many, many).proven
