"""What two trees have in common, against counting by hand."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import node, unit

from foon_kg.evaluation.tree_overlap import in_common, main_object, overlap
from foon_kg.model import FunctionalUnit, Participant
from foon_kg.plans.kitchen import Kitchen

KITCHEN = Kitchen.default()
CHOP = unit("knife; onion(whole) > chop > onion(chopped)")
DICE = unit("knife; onion(whole) > dice > onion(diced)")
CHOP_PEELED = unit("knife; onion(peeled) > chop > onion(chopped)")
POUR = unit("bowl{onion}; pan > pour > pan{onion}")
LINES = (CHOP, DICE, CHOP_PEELED, POUR)
trees = st.lists(st.sampled_from(LINES), max_size=6)


def figures(ours, truth):
    found = overlap(ours, truth, KITCHEN)
    return found.units, found.units_with_states, found.triples


def test_the_main_object_is_the_food_then_the_vessel_with_food():
    assert main_object(CHOP, KITCHEN) == node("onion(whole)")
    assert main_object(POUR, KITCHEN) == node("bowl{onion}")
    assert main_object(unit("oven; pan > heat > pan(hot)"), KITCHEN) == node("oven")


def test_what_moves_comes_before_what_stands():
    parts = (Participant(node("tomato")), Participant(node("onion"), moving=True))
    assert main_object(FunctionalUnit(parts, "place", ()), KITCHEN) == node("onion")


def test_states_tell_units_apart_only_where_they_count():
    assert figures([CHOP], [CHOP_PEELED]) == (1, 0, 0)
    assert figures([CHOP, POUR], [POUR, DICE]) == (1 / 3, 1 / 3, 0)


def test_a_unit_done_twice_counts_twice():
    assert figures([CHOP, CHOP], [CHOP]) == (1 / 2, 1 / 2, 1)


def test_no_tree_has_nothing_in_common():
    assert figures([], [CHOP]) == figures([], []) == (0, 0, 0)


@given(trees, trees)
def test_an_overlap_is_the_same_both_ways_and_whole_only_with_itself(one, other):
    assert figures(one, other) == figures(other, one)
    assert all(0 <= figure <= 1 for figure in figures(one, other))
    if one:
        assert figures(one, list(reversed(one)))[:2] == (1, 1)


@given(st.lists(st.integers(0, 4)), st.lists(st.integers(0, 4)))
def test_common_over_all_is_what_taking_away_one_by_one_gives(one, other):
    rest, both = list(other), 0
    for item in one:
        if item in rest:
            rest.remove(item)
            both += 1
    union = len(one) + len(other) - both
    assert in_common(Counter(one), Counter(other)) == pytest.approx(both / union if union else 0)
