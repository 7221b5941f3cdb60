"""The default similarity: evidence of several kinds, weighed into one probability."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from foon_kg.names import canonical
from foon_kg.similarity.answers import Confidences, Neighbour, best
from foon_kg.similarity.vectors import FoodVectors, food_vectors

_SLOPE, _MIDDLE = 12.0, 0.66


class FoodSimilarity:
    """Weighs the evidence for each pair of names and answers a probability."""

    def __init__(self, vectors: FoodVectors) -> None:
        self._vectors = vectors

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Answer confidences from 0 to 1, one row for each wanted name, one column for each known one."""
        rows, columns = [canonical(name) for name in wanted], [canonical(name) for name in known]
        cosines = self._vectors.embed(rows) @ self._vectors.embed(columns).T
        confidences = 1 / (1 + np.exp(-_SLOPE * (cosines - _MIDDLE)))
        same = np.array([[row == column for column in columns] for row in rows]).reshape(confidences.shape)
        return np.where(same, 1.0, np.minimum(confidences, 0.99))

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        """Answer the ``limit`` known names that can best stand for ``name``, best first, ties by name."""
        return best(known, self.matrix([name], known)[0], limit)


@lru_cache(maxsize=1)
def food_similarity() -> FoodSimilarity:
    """Answer the default similarity, made once."""
    return FoodSimilarity(food_vectors())
