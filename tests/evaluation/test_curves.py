"""Curves and histograms against counting by hand, in whole numbers."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.evaluation.curves import THRESHOLDS, histogram, recipes_over

marks = st.lists(
    st.integers(1, 40).flatmap(lambda n: st.tuples(st.integers(0, n), st.just(n))), min_size=1, max_size=30
)


@pytest.mark.slow
@given(marks)
def test_a_curve_counts_the_recipes_at_or_over_each_threshold(marks):
    counted = [
        Fraction(sum(100 * points >= threshold * most for points, most in marks), len(marks))
        for threshold in THRESHOLDS
    ]
    assert list(recipes_over([points / most for points, most in marks])) == [float(share) for share in counted]


def test_a_curve_without_recipes_is_flat():
    assert set(recipes_over([])) == {0.0}


@given(st.lists(st.integers(0, 1000), max_size=50))
def test_every_confidence_is_in_the_tenth_that_begins_at_or_below_it(thousandths):
    expected = [0] * 10
    for number in thousandths:
        expected[min(number // 100, 9)] += 1
    assert list(histogram([number / 1000 for number in thousandths])) == expected
