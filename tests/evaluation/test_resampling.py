"""Bootstrap intervals on distributions whose answer is known."""

from __future__ import annotations

import math
from statistics import NormalDist

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.evaluation.resampling import bootstrap_mean, paired_difference, share

shares = st.lists(st.floats(0, 1), min_size=1, max_size=8)


def test_equal_values_leave_no_doubt():
    found = bootstrap_mean([0.25] * 7, seed=3)
    assert (found.mean, found.low, found.high) == pytest.approx((0.25, 0.25, 0.25))


def test_of_many_values_the_interval_is_the_normal_one():
    values = np.random.default_rng(5).normal(10, 2, size=400)
    found = bootstrap_mean(values.tolist(), seed=1)
    half = NormalDist().inv_cdf(0.975) * values.std() / math.sqrt(len(values))
    assert found.mean == pytest.approx(values.mean())
    assert (found.low, found.high) == pytest.approx((values.mean() - half, values.mean() + half), abs=0.02)


@pytest.mark.parametrize("seed", [0, 7])
def test_the_interval_is_that_of_scipy_with_the_same_draws(seed):
    from scipy.stats import bootstrap  # as long to import as all other tests of this folder

    values = np.random.default_rng(seed).uniform(0, 1, size=30)
    found = bootstrap_mean(values.tolist(), seed)
    known = bootstrap((values,), np.mean, n_resamples=10_000, method="percentile", rng=seed).confidence_interval
    assert (found.low, found.high) == pytest.approx((known.low, known.high), abs=1e-12)


def test_of_zero_and_one_the_samples_are_known():
    found = bootstrap_mean([0.0, 1.0], seed=0)  # means 0, 1/2 and 1 come up 1, 2 and 1 times in 4
    assert (found.mean, found.low, found.high) == (0.5, 0.0, 1.0)


@given(shares, st.integers(0, 5))
@settings(max_examples=20, deadline=None)
def test_the_mean_lies_between_its_bounds_and_these_between_the_values(values, seed):
    found = bootstrap_mean(values, seed)
    small = 1e-9
    assert min(values) - small <= found.low <= found.high <= max(values) + small
    assert found.mean == pytest.approx(sum(values) / len(values))
    assert found == bootstrap_mean(values, seed)


def test_weights_make_the_mean_that_of_all_lines():
    found = bootstrap_mean([1.0, 0.0], seed=0, weights=[3, 1])
    assert (found.mean, found.low, found.high) == (0.75, 0.0, 1.0)
    assert bootstrap_mean([1.0, 0.0], seed=0, weights=[0, 0]).mean == 0.0


def test_no_values_have_no_mean():
    assert bootstrap_mean([], seed=0).mean == 0.0


def test_a_difference_is_drawn_in_pairs():
    before = np.random.default_rng(2).uniform(0, 0.9, size=60)
    paired = paired_difference((before + 0.01).tolist(), before.tolist(), seed=0)
    assert (paired.low, paired.high) == pytest.approx((0.01, 0.01))
    assert paired.apart_from_zero
    assert not paired_difference([1.0, 0.0], [0.0, 1.0], seed=0).apart_from_zero
    with pytest.raises(ValueError, match="longer"):
        paired_difference([1.0], [1.0, 0.5], seed=0)


def test_intervals_hold_the_truth_about_as_often_as_they_say():
    draw = np.random.default_rng(11)
    held = [
        (found := bootstrap_mean(draw.uniform(0, 1, size=40).tolist(), seed)).low <= 0.5 <= found.high
        for seed in range(100)
    ]
    assert 88 <= sum(held) <= 100


@given(st.integers(1, 400).flatmap(lambda of: st.tuples(st.integers(0, of), st.just(of))))
def test_the_interval_of_a_share_is_wilson_s(counted):
    from scipy.stats import binomtest

    count, of = counted
    found, known = share(count, of), binomtest(count, of).proportion_ci(0.95, method="wilson")
    assert found.mean == count / of
    assert (found.low, found.high) == pytest.approx((known.low, known.high), abs=1e-9)
    assert 0 <= found.low <= found.mean <= found.high <= 1


@pytest.mark.parametrize(("count", "of"), [(0, 0), (3, 2), (-1, 4)])
def test_what_is_no_share_has_no_interval(count, of):
    with pytest.raises(ValueError, match="is no share"):
        share(count, of)
