"""Weighted kappa against its formula, written out otherwise, and a value worked out by hand."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.evaluation.agreement import agreement

pairs = st.lists(st.tuples(st.integers(0, 2), st.integers(0, 2)), min_size=1, max_size=40)


def kappa_by_pairs(pairs):
    """1 - (mean distance of the pairs as they are) / (mean distance of every first with every second score)."""
    count = len(pairs)
    seen = Fraction(sum(abs(a - b) for a, b in pairs), count)
    by_chance = Fraction(sum(abs(a - b) for a, _ in pairs for _, b in pairs), count * count)
    return None if by_chance == 0 else 1 - seen / by_chance


@pytest.mark.slow
@given(pairs)
def test_kappa_is_what_distances_say(pairs):
    found = agreement([a for a, _ in pairs], [b for _, b in pairs])
    expected = kappa_by_pairs(pairs)
    assert found.kappa == (None if expected is None else pytest.approx(float(expected)))
    assert found.same == sum(a == b for a, b in pairs) / len(pairs)
    assert sum(map(sum, found.table)) == found.lines == len(pairs)


def test_a_value_worked_out_by_hand():
    first, second = [2] * 6 + [1] * 3 + [0], [2] * 5 + [1] + [1, 1, 2] + [0]
    # seen: two pairs of ten one apart = 0.2; by chance: (6*3*1 + 6*1*2 + 3*6*1 + 3*1*1 + 1*6*2 + 1*3*1) / 100 = 0.66
    assert agreement(first, second).kappa == pytest.approx(1 - 0.2 / 0.66)


def test_full_agreement_is_one_and_one_score_throughout_is_undefined():
    assert agreement([0, 1, 2], [0, 1, 2]).kappa == 1
    assert agreement([2, 2], [2, 2]).kappa is None


def test_nothing_scored_is_refused():
    with pytest.raises(ValueError, match="nobody"):
        agreement([], [])
