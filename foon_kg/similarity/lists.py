"""Two ingredient lists compared: Algorithm 2 of the paper as written, and as a matching."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from foon_kg.similarity.confidences import Confidences, Similarity
from foon_kg.similarity.food import food_similarity


@dataclass(frozen=True)
class Pair:
    """One required food and the known one that stands for it."""

    required: str
    known: str
    confidence: float


def count_similar(
    required: Sequence[str],
    known: Sequence[str],
    similarity: Similarity | None = None,
    *,
    threshold: float = 0.90,
) -> int:
    """Return how many pairs (i, j), i required and j known, are more similar than ``threshold`` (Algorithm 2).

    As written there: one food may count in many pairs. ``similarity`` is ``food_similarity()`` where none is given.
    """
    return int((_similarities(required, known, similarity) > threshold).sum())


def matching(
    required: Sequence[str], known: Sequence[str], similarity: Similarity | None = None
) -> tuple[float, tuple[Pair, ...]]:
    """Return the pairs of greatest total confidence in which each food counts once, and that total.

    Pairs of a ``required`` and a ``known`` food come in the order of ``required``; pairs of no confidence at all are
    left out. ``similarity`` is ``food_similarity()`` where none is given. It stands for the count of algorithm 2 (Sakib
    et al. 2021), in which one food may count in many pairs.
    """
    weights = _similarities(required, known, similarity)
    pairs = tuple(
        Pair(required[row], known[column], float(weights[row, column]))
        for row, column in heaviest_matching(weights)
        if weights[row, column] > 0
    )
    return sum(pair.confidence for pair in pairs), pairs


def _similarities(required: Sequence[str], known: Sequence[str], similarity: Similarity | None) -> Confidences:
    return (similarity or food_similarity()).matrix(required, known)


def heaviest_matching(weights: Confidences) -> list[tuple[int, int]]:
    """Return (row, column) pairs, each row and column at most once, of the greatest total weight; rows ascending.

    ``weights`` are not negative. The Hungarian method in Jonker's and Volgenant's form (1987): for each row the
    shortest augmenting path under reduced costs; O(rows² · columns). scipy has it, and would be needed for this alone.
    """
    if weights.shape[0] > weights.shape[1]:
        return sorted((row, column) for column, row in heaviest_matching(weights.T))
    costs = -weights
    rows, columns = costs.shape
    row_price, column_price = np.zeros(rows), np.zeros(columns)
    row_of = np.full(columns, -1)
    for row in range(rows):
        _augment(row, costs, row_price, column_price, row_of)
    return sorted((int(row), column) for column, row in enumerate(row_of) if row >= 0)


def _augment(
    start: int, costs: Confidences, row_price: Confidences, column_price: Confidences, row_of: npt.NDArray[np.int64]
) -> None:
    """Give row ``start`` a column along the cheapest path of exchanges, and keep every reduced cost >= 0."""
    columns = costs.shape[1]
    distance, came_from = np.full(columns, np.inf), np.full(columns, -1)
    done = np.zeros(columns, dtype=bool)
    row, column, lowest = start, -1, 0.0
    while row >= 0:
        reduced = lowest + costs[row] - row_price[row] - column_price
        nearer = ~done & (reduced < distance)
        distance[nearer], came_from[nearer] = reduced[nearer], column
        column = int(np.argmin(np.where(done, np.inf, distance)))
        lowest, done[column] = float(distance[column]), True
        row = int(row_of[column])
    passed = done.copy()
    passed[column] = False
    row_price[start] += lowest
    row_price[row_of[passed]] += lowest - distance[passed]
    column_price[passed] -= lowest - distance[passed]
    while column >= 0:
        row_of[column] = start if came_from[column] < 0 else row_of[came_from[column]]
        column = int(came_from[column])
