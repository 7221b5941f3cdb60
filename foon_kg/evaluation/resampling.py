"""How sure a mean is: bootstrap intervals, alone and paired (Efron's percentile method), from a given seed.

A share of few trees has an interval of its own (:func:`share`), which needs no draw.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from statistics import NormalDist

import numpy as np
import numpy.typing as npt

ROUNDS = 10_000
"""How many samples are drawn."""

LEVEL = 0.95
"""How much of them an interval holds."""

_AT_ONCE = 1_000_000
"""So many drawn places are in memory at a time (8 MB): recipes may be hundreds of thousands."""


@dataclass(frozen=True)
class Interval:
    """A mean with its bounds at ``LEVEL``.

    Of a bootstrap they hold that much of the means of samples drawn again from the same values; of a share they are
    Wilson's.
    """

    mean: float
    low: float
    high: float

    @property
    def apart_from_zero(self) -> bool:
        """Whether it does not hold 0: a difference that is more than chance."""
        return self.low > 0 or self.high < 0

    def to_json(self) -> dict[str, float]:
        """Return the interval as JSON, to six decimals."""
        return {"mean": _short(self.mean), "low": _short(self.low), "high": _short(self.high)}


def bootstrap_mean(values: Sequence[float], seed: int, weights: Sequence[float] | None = None) -> Interval:
    """Return the mean of ``values`` with its interval; ``weights`` makes it the weighted mean.

    Recipes weigh what they have lines, so that their mean is the share of all lines. All 0 where there are no values
    (or no weight). The same values in the same order with one seed give the same interval.
    """
    if not values:
        return Interval(0.0, 0.0, 0.0)
    heavy = np.ones(len(values)) if weights is None else np.asarray(weights, dtype=float)
    means = _means(np.asarray(values, dtype=float), heavy, seed)
    low, high = np.quantile(means, [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    total = float(heavy.sum())
    return Interval(float(np.dot(values, heavy)) / total if total else 0.0, float(low), float(high))


def paired_difference(ours: Sequence[float], theirs: Sequence[float], seed: int) -> Interval:
    """Return the mean of ``ours - theirs`` with its interval, drawn in pairs: the same question answered by both.

    ``seed`` draws the samples. Raises ValueError where they are not equally many.
    """
    return bootstrap_mean([one - other for one, other in zip(ours, theirs, strict=True)], seed)


def share(count: int, of: int) -> Interval:
    """Return the share ``count / of`` with its score interval (Wilson 1927), which is sound for few and for none, too.

    Raises ValueError where there is nothing of which it could be a share.
    """
    if not 0 <= count <= of or not of:
        raise ValueError(f"{count} of {of} is no share")
    z = NormalDist().inv_cdf((1 + LEVEL) / 2)
    mean, pull = count / of, z * z / of
    middle = (mean + pull / 2) / (1 + pull)
    half = sqrt(pull * (mean * (1 - mean) + pull / 4)) / (1 + pull)
    return Interval(mean, min(mean, max(0.0, middle - half)), max(mean, min(1.0, middle + half)))


def _means(values: npt.NDArray[np.float64], weights: npt.NDArray[np.float64], seed: int) -> npt.NDArray[np.float64]:
    """Return the weighted mean of each sample; as many samples at a time as memory easily holds."""
    draw, count = np.random.default_rng(seed), len(values)
    weighted, found = values * weights, []
    rows = max(1, min(ROUNDS, _AT_ONCE // count))
    for start in range(0, ROUNDS, rows):
        chosen = draw.integers(0, count, size=(min(rows, ROUNDS - start), count))
        total = weights[chosen].sum(axis=1)
        found.append(np.divide(weighted[chosen].sum(axis=1), total, out=np.zeros(len(total)), where=total > 0))
    return np.concatenate(found)


def _short(number: float) -> float:
    return round(number, 6)
