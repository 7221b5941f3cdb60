"""The cheapest set that hits several sets, compared with trying every set; and all that are as cheap."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.search.deadline import Deadline
from foon_kg.search.hitting_set import HittingSets, ascent

MEMBERS = 8
sets_asked = st.lists(st.integers(1, 2**MEMBERS - 1), max_size=7)
prices = st.lists(st.sampled_from([1, 1, 2, 3, 7, 100]), min_size=MEMBERS, max_size=MEMBERS)
often = settings(max_examples=200, deadline=None)


def costs_of_all(sets, costs):
    """The cost of every set that hits all of ``sets``."""
    return {
        chosen: sum(cost for member, cost in enumerate(costs) if chosen >> member & 1)
        for chosen in range(2**MEMBERS)
        if all(chosen & one for one in sets)
    }


@often
@given(sets_asked, prices)
def test_no_set_that_hits_them_all_is_cheaper(sets, costs):
    found = HittingSets(costs, Deadline()).cheapest(sets)
    all_costs = costs_of_all(sets, costs)
    assert all_costs[found] == min(all_costs.values())


@often
@given(sets_asked, prices, st.integers(0, 20))
def test_none_is_found_above_the_limit(sets, costs, limit):
    found = HittingSets(costs, Deadline()).cheapest(sets, limit)
    least = min(costs_of_all(sets, costs).values())
    assert (found is None) == (least > limit)
    assert found is None or costs_of_all(sets, costs)[found] == least


@often
@given(sets_asked, prices)
def test_every_member_of_a_cheapest_set_is_named_and_no_other(sets, costs):
    all_costs = costs_of_all(sets, costs)
    least, members = min(all_costs.values()), 0
    for chosen, cost in all_costs.items():
        members |= chosen if cost == least else 0
    assert HittingSets(costs, Deadline()).members_of_cheapest(sets) == members


@often
@given(sets_asked, prices)
def test_the_ascent_is_never_above_the_cheapest_and_leaves_no_cost_below_nothing(sets, costs):
    bound, left = ascent(sets, costs)
    assert bound <= min(costs_of_all(sets, costs).values())
    assert all(0 <= rest <= costs[member] for member, rest in left.items())


@pytest.mark.parametrize("sets", [[0b011, 0b110, 0b101], [0b1]])
def test_out_of_time_nothing_is_claimed_and_every_member_is_kept(sets):
    late = HittingSets([1, 1, 1], Deadline.after(-1))
    assert late.cheapest(sets) is None
    everything = 0
    for one in sets:
        everything |= one
    assert late.members_of_cheapest(sets) == everything


@often
@given(st.lists(st.tuples(sets_asked, st.integers(0, 20)), min_size=2, max_size=4), prices)
def test_what_is_known_of_other_questions_changes_no_answer(questions, costs):
    hitting_sets = HittingSets(costs, Deadline())
    for sets, limit in questions:
        found = hitting_sets.cheapest(sets, limit)
        alone = HittingSets(costs, Deadline()).cheapest(sets, limit)
        assert (found is None) == (alone is None)
        assert found is None or costs_of_all(sets, costs)[found] == costs_of_all(sets, costs)[alone]
