"""Curves and histograms of an evaluation, as plain numbers."""

from __future__ import annotations

from collections.abc import Sequence

THRESHOLDS: tuple[int, ...] = tuple(range(0, 101, 5))
"""The thresholds of a curve, in per cent; the paper quotes the one at 85."""

BINS = 10
"""How many bins a histogram of confidences has, each a tenth wide."""

_EXACTLY = 1e-9
"""Less than any share of lines, more than what floating point loses: 17 of 20 is 85 per cent."""


def recipes_over(shares: Sequence[float]) -> tuple[float, ...]:
    """Return for each of ``THRESHOLDS`` the share of recipes that are at least so correct; 0 for no recipes.

    ``shares`` are between 0 and 1; 17 of 20 is at least 85 per cent, whatever floating point makes of it.
    """
    if not shares:
        return (0.0,) * len(THRESHOLDS)
    return tuple(sum(share >= threshold / 100 - _EXACTLY for share in shares) / len(shares) for threshold in THRESHOLDS)


def histogram(confidences: Sequence[float]) -> tuple[int, ...]:
    """Return how many of ``confidences`` (0 to 1) are in each tenth; 1 is in the last, a border in the upper one."""
    counts = [0] * BINS
    for confidence in confidences:
        counts[max(0, min(BINS - 1, int(confidence * BINS + _EXACTLY)))] += 1
    return tuple(counts)
