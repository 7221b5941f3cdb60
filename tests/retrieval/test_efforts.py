"""Sums of efforts order products of success rates, exactly."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.search.classic.effort import coprime_base, efforts

rates = st.one_of(
    st.integers(1, 20).map(lambda share: Fraction(share, 20)),
    st.floats(0.001, 1).map(lambda rate: Fraction(repr(rate))),
)


@settings(deadline=None)
@given(st.data())
def test_the_greater_product_has_the_lesser_sum_and_equal_products_have_equal_sums(data):
    known = data.draw(st.lists(rates, min_size=1, max_size=6))
    one, other = (data.draw(st.lists(st.sampled_from(known), max_size=8)) for _ in range(2))
    effort = efforts(known, 8)
    sums = [sum(effort[rate] for rate in tree) for tree in (one, other)]
    products = [math.prod(tree, start=Fraction(1)) for tree in (one, other)]
    assert (sums[0] < sums[1], sums[0] == sums[1]) == (products[0] > products[1], products[0] == products[1])


def test_products_that_differ_in_the_last_digit_are_told_apart():
    near, far = Fraction("0.1234567890123457"), Fraction("0.1234567890123456")
    effort = efforts([near, far], 30)
    assert 29 * effort[near] + effort[far] > 30 * effort[near]


def test_what_is_certain_costs_nothing_and_what_never_happens_is_refused():
    assert efforts([Fraction(1)], 5) == {Fraction(1): 0}
    for rate in (Fraction(0), Fraction(3, 2)):
        with pytest.raises(ValueError, match="success rate"):
            efforts([rate], 5)


@given(st.lists(st.integers(1, 10**6), max_size=6))
def test_a_coprime_base_shares_no_factor_and_makes_up_every_number(numbers):
    base = coprime_base(numbers)
    assert all(math.gcd(one, other) == 1 for place, one in enumerate(base) for other in base[:place])
    for number in numbers:
        rest = number
        for part in base:
            while rest % part == 0:
                rest //= part
        assert rest == 1
