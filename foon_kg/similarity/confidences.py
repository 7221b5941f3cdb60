"""What every similarity gives: a matrix of confidences, and out of it the nearest known names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from foon_kg.model.knowledge import Neighbour

Confidences = npt.NDArray[np.float64]

DECIMALS = 6
"""Confidences are rounded to this, so that the last bits of a matrix product, which depend on its shape, decide no
tie (C9)."""


class Similarity(Protocol):
    """Says how well known foods can stand for wanted ones."""

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Return confidences from 0 to 1, one row for each wanted name, one column for each known one."""
        ...

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        """Return the ``limit`` known names that can best stand for ``name``, best first, ties by name.

        Fewer where fewer are like it, and none where nothing is.
        """
        ...

    def why(self, name: str, known: str) -> tuple[str, ...]:
        """Return in a few words each what speaks for ``known`` standing for ``name``, the weightiest first."""
        ...


def nearest_of_each(
    similarity: Similarity, names: Sequence[str], known: Sequence[str], limit: int
) -> tuple[tuple[Neighbour, ...], ...]:
    """Return the at most ``limit`` of ``known`` that ``similarity`` finds nearest to each of ``names``, in one product.

    Each list is :meth:`Similarity.nearest` of its name.
    """
    return tuple(best(known, row, limit) for row in similarity.matrix(names, known))


def best(known: Sequence[str], confidences: Confidences, limit: int) -> tuple[Neighbour, ...]:
    """Return the at most ``limit`` greatest of a row of ``confidences`` above 0, best first, ties by name (C9).

    The row has a confidence for each of ``known``, in their order.
    """
    like = [(name, sure) for name, sure in zip(known, confidences.tolist(), strict=True) if sure > 0]
    rows = sorted(like, key=lambda row: (-row[1], row[0]))
    return tuple(Neighbour(name, confidence) for name, confidence in rows[: max(limit, 0)])
