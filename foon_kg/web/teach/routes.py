"""The API of the page that teaches: a table comes with every question and goes back with the answer."""

from __future__ import annotations

from fastapi import APIRouter

from foon_kg.foon import Review
from foon_kg.loaders.text_writer import write_text
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.web.teach.asking import DecisionAsked, ReviewAsked, TableAsked
from foon_kg.web.teach.telling import ReviewTold, SubgraphTold

router = APIRouter(prefix="/teach")


@router.post("/review")
def review(asked: ReviewAsked) -> ReviewTold:
    """Return the rows of a draft with why each should be looked at, after one decision where there is one.

    The decisions are the same as those of `foon draft review`, and so is the table that comes back: either goes on
    with what the other left.
    """
    read = _read(asked)
    return ReviewTold.of(read if asked.decision is None else _decided(read, asked.decision))


@router.post("/subgraph")
def subgraph(asked: TableAsked) -> SubgraphTold:
    """Return the units of a table as FOON text."""
    read = _read(asked)
    return SubgraphTold(file=f"{asked.name}.txt", text=write_text(read.subgraph()))


def _decided(read: Review, decision: DecisionAsked) -> Review:
    if decision.what == "edit":
        if decision.cells is None:
            raise UsageError("there is nothing to edit it to", hint="Send the cells.")
        cells = decision.cells.model_dump()
        return read.edited(decision.place, {name: text for name, text in cells.items() if name in read.columns})
    return read.accepted(decision.place) if decision.what == "accept" else read.dropped(decision.place)


def _read(asked: TableAsked) -> Review:
    try:
        return Review.of(asked.table, asked.name)
    except ReadError as error:  # it is the question that cannot be read
        raise UsageError(error.message, hint=error.hint) from error
