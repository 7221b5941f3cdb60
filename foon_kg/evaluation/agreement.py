"""How far two raters agree beyond chance: Cohen's kappa, weighted by how far apart their scores are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

CATEGORIES = 3
"""The scores are 0, 1 and 2."""


@dataclass(frozen=True)
class Agreement:
    """What two raters of the same lines agree on.

    ``kappa`` is linearly weighted: 0 against 2 is twice as far apart as 1 against 2. 1 is full agreement, 0 what chance
    gives; ``None`` where chance alone must agree, because both gave one and the same score throughout. ``table[i][j]``
    counts the lines that the first rater scored i and the second j.
    """

    lines: int
    same: float
    kappa: float | None
    table: tuple[tuple[int, ...], ...]

    def to_json(self) -> dict[str, object]:
        """Return the agreement as JSON."""
        kappa = None if self.kappa is None else round(self.kappa, 6)
        table = [list(row) for row in self.table]
        return {"lines": self.lines, "same": round(self.same, 6), "weighted_kappa": kappa, "table": table}


def agreement(first: Sequence[int], second: Sequence[int]) -> Agreement:
    """Return how far two raters agree: the ``first`` and the ``second`` scored the same lines, in one order.

    Cohen (1968): 1 - sum(w * observed) / sum(w * expected), with w = |i - j|. Raises ValueError where the raters did
    not score equally many lines, or none.
    """
    if not first:
        raise ValueError("nobody scored a line")
    observed = np.zeros((CATEGORIES, CATEGORIES))
    for one, other in zip(first, second, strict=True):
        observed[one, other] += 1
    places = np.arange(CATEGORIES)
    weights = np.abs(np.subtract.outer(places, places))
    expected = np.outer(observed.sum(axis=1), observed.sum(axis=0)) / len(first)
    by_chance = float((weights * expected).sum())
    kappa = 1 - float((weights * observed).sum()) / by_chance if by_chance else None
    table = tuple(tuple(int(count) for count in row) for row in observed)
    return Agreement(len(first), float(np.trace(observed)) / len(first), kappa, table)
