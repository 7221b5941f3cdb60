"""What the API of the page that teaches answers, typed."""

from __future__ import annotations

from typing import Self

from pydantic import BaseModel

from foon_kg.foon import Decision, Reason, Review
from foon_kg.formats.exports.sentences import sentence
from foon_kg.plans.kitchen import Kitchen


class CellsTold(BaseModel):
    """What the table says of a unit."""

    motion: str
    inputs: str
    outputs: str
    dish: str


class RowTold(BaseModel):
    """A row: what was ``said`` and when (``at`` is the video's address at that second), and the unit made of it.

    ``sentence`` tells the unit to a cook; ``null`` where the row is no unit. ``reasons`` are why a person should look
    at it, none where that is not needed or was done (``reviewed``).
    """

    place: int
    said: str
    moment: str
    at: str
    cells: CellsTold
    sentence: str | None
    confidence: float
    reviewed: bool
    reasons: list[Reason]

    @classmethod
    def of(cls, row: Decision) -> Self:
        """Return a ``row`` as it is told."""
        return cls(
            place=row.place,
            said=row.said,
            moment=row.moment,
            at=row.at,
            cells=CellsTold(**{name: row.cells.get(name, "") for name in CellsTold.model_fields}),
            sentence=None if row.unit is None else sentence(row.unit, Kitchen.default()),
            confidence=row.confidence,
            reviewed=row.is_reviewed,
            reasons=list(row.reasons),
        )


class ReviewTold(BaseModel):
    """The table as it is now, and its rows."""

    name: str
    table: str
    units: int
    open: int
    rows: list[RowTold]

    @classmethod
    def of(cls, review: Review) -> Self:
        """Return a ``review`` as it is told."""
        rows = list(map(RowTold.of, review.all_rows))
        return cls(name=review.name, table=review.text(), units=review.units, open=len(review.decisions), rows=rows)


class SubgraphTold(BaseModel):
    """What was decided, as FOON text that ``foon load foon`` takes, and how to name its file."""

    file: str
    text: str
