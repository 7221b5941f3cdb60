"""Rows of which few places are filled: a name is of some ten kinds out of thousands, and there are many names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

Table = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]
Places = npt.NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class SparseRows:
    """A matrix as its filled places, row after row: ``counts`` of each row, and ``places`` and ``values`` of all."""

    counts: Places
    places: Places
    values: Table
    width: int

    @classmethod
    def of(cls, rows: Sequence[Mapping[int, float]], width: int) -> SparseRows:
        """Return the matrix of ``width`` columns whose ``rows`` say what stands in which column."""
        counts = np.array([len(row) for row in rows], dtype=np.int64)
        places = np.array([place for row in rows for place in row], dtype=np.int64)
        values = np.array([value for row in rows for value in row.values()], dtype=np.float64)
        return cls(counts, places, values, width)

    @cached_property
    def filled(self) -> Flags:
        """Whether each row has anything in it."""
        return np.asarray(self.counts > 0, dtype=np.bool_)

    def dense(self) -> Table:
        """Return the whole matrix."""
        return self.folded(self.width)

    def folded(self, width: int) -> Table:
        """Return the matrix in at most ``width`` columns: column n is added to column n modulo ``width``."""
        rows = np.repeat(np.arange(len(self.counts)), self.counts)
        cells = np.bincount(rows * width + self.places % width, self.values, len(self.counts) * width)
        return cells.astype(np.float64, copy=False).reshape(len(self.counts), width)

    @property
    def used(self) -> Places:
        """The columns in which any row has anything, ascending."""
        return np.flatnonzero(np.bincount(self.places))

    def columns(self, columns: Places) -> Table:
        """Return just these ``columns``, ascending, of the matrix."""
        rows = np.repeat(np.arange(len(self.counts)), self.counts)
        place = np.searchsorted(columns, self.places)
        there = np.isin(self.places, columns)
        table = np.zeros((len(self.counts), len(columns)))
        table[rows[there], place[there]] = self.values[there]
        return table

    def product(self, table: Table) -> Table:
        """Return ``table @ matrix.T`` for the rows of a dense ``table``."""
        product = np.zeros((len(table), len(self.counts)))
        if len(self.places):
            starts = (np.cumsum(self.counts) - self.counts)[self.filled]
            product[:, self.filled] = np.add.reduceat(table[:, self.places] * self.values, starts, axis=1)
        return product
