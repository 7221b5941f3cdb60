"""A person decides on the doubtful rows of a draft, a sentence at a time, and the file says so."""

from __future__ import annotations

import csv
import io
from collections.abc import Collection
from dataclasses import dataclass
from itertools import groupby

from foon_kg.language.drafting.drafts import DraftFile, DraftRow
from foon_kg.language.drafting.review import SURE, unresolved
from foon_kg.loaders.csv_table import columns_of, raw_rows


@dataclass(frozen=True)
class Decision:
    """What is decided at once: the doubtful rows of what was said."""

    said: str
    rows: tuple[DraftRow, ...]

    @property
    def lines(self) -> frozenset[int]:
        """The lines of the rows in their file."""
        return frozenset(row.line for row in self.rows)


def decisions(draft: DraftFile, sure: float = SURE) -> tuple[Decision, ...]:
    """Return what has to be decided before a draft can be accepted, in the order in which it was said."""
    together = groupby(unresolved(draft, sure), key=lambda row: row.said)
    return tuple(Decision(said, tuple(rows)) for said, rows in together)


def decided(text: str, right: Collection[int], wrong: Collection[int]) -> str:
    """Return the table ``text`` in which the rows in the lines ``right`` are right, and those in ``wrong`` are gone.

    A row that is right loses its doubt; one that is no unit is rightly none, and goes. All others stay as they are.
    """
    columns = columns_of(text)
    motion, doubt = columns.index("motion"), columns.index("doubt")
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    for line, cells in raw_rows(text):
        if line in wrong or (line in right and not cells[motion].strip()):
            continue
        without = [*cells[:doubt], "", *cells[doubt + 1 :]]
        writer.writerow(without if line in right else cells)
    return stream.getvalue()
