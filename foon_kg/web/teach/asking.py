"""What is asked of the API of the page that teaches, typed and bounded. The service keeps nothing of it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from foon_kg.web.asking import Asked

LONGEST_TABLE = 500_000
LONGEST_CELL = 2_000

Cell = Annotated[str, Field(max_length=LONGEST_CELL, pattern=r"^[^\x00-\x1f\x7f]*$")]


class CellsAsked(Asked):
    """The cells of a unit as a person wrote them."""

    motion: Cell = Field(examples=["chop"])
    inputs: Cell = Field(examples=["onion (peeled) on cutting board; knife"])
    outputs: Cell = Field(examples=["onion (chopped) on cutting board"])
    dish: Cell = Field("", description="Where the unit makes the dish: its type.", examples=[""])


class DecisionAsked(Asked):
    """What a person decides about one row."""

    place: int = Field(ge=0, le=5_000, description="Which row, from 0.", examples=[0])
    what: Literal["accept", "edit", "drop"] = Field(examples=["accept"])
    cells: CellsAsked | None = Field(None, description="With “edit”: what the row says from now on.")


class TableAsked(Asked):
    """A draft, or the plain table of a video, as CSV."""

    name: str = Field(min_length=1, max_length=100, pattern=r"^[\w.-]+$", examples=["P01_01"])
    table: str = Field(
        min_length=1,
        max_length=LONGEST_TABLE,
        pattern=r"^[^\x00-\x08\x0b\x0c\x0e-\x1f\x7f]*$",
        examples=['start,end,motion,inputs,outputs\n,,chop,"onion; knife",onion (chopped)\n'],
    )


class ReviewAsked(TableAsked):
    """A table to look at, or to decide on one row of."""

    decision: DecisionAsked | None = None
