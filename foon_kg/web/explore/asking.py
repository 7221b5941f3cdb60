"""What is asked of the API of the explorer, typed and bounded."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, JsonValue

from foon_kg.model import DISH_TYPES
from foon_kg.web.asking import MOST_LETTERS, Asked, DishType
from foon_kg.web.explore.network import Filters

MOST_SHOWN = 500
"""So many things a page may say that it draws already: it is told of at most 150 new ones at a time."""
LONGEST_ID = 400
"""An id is a kind and a name: files may have long ones."""

LONGEST_QUESTION = 5_000

Id = Annotated[str, Field(min_length=1, max_length=LONGEST_ID, pattern=r"^[^\x00-\x1f\x7f]+$")]
Names = Annotated[list[Id], Field(max_length=50)]


class FiltersAsked(Asked):
    """Which steps count; an empty list lets all through."""

    videos: Names = Field([], description="Only steps seen in one of these videos.", examples=[[]])
    motions: Names = Field([], description="Only steps of these motions.", examples=[["chop"]])
    dish_types: list[DishType] = Field(
        [], max_length=len(DISH_TYPES), description="Only steps of videos of such dishes.", examples=[["salad"]]
    )
    utensils: bool = Field(default=False, description="Also the empty utensils that a step takes.")

    def filters(self) -> Filters:
        """Return them as the explorer takes them."""
        return Filters(frozenset(self.videos), frozenset(self.motions), frozenset(self.dish_types), self.utensils)


class AroundAsked(FiltersAsked):
    """What is around a thing."""

    id: Id = Field(examples=["food:onion"])
    depth: int = Field(1, ge=1, le=3, description="How many edges away.")
    most: int = Field(30, ge=1, le=150, description="How many new things at most.")
    shown: list[Id] = Field(
        [], max_length=MOST_SHOWN, description="What is in the picture already: edges to it are told.", examples=[[]]
    )


class WayAsked(FiltersAsked):
    """From which state of a food to which: in words (“whole potato”) or by the ids of objects."""

    start: Id = Field(examples=["whole potato"], max_length=MOST_LETTERS)
    end: Id = Field(examples=["boiled potato"], max_length=MOST_LETTERS)


class CypherAsked(Asked):
    """A question in Cypher that only looks at the graph, with values for its ``$parameters``."""

    text: str = Field(
        min_length=1, max_length=LONGEST_QUESTION, examples=["MATCH (v:Video) RETURN v.name ORDER BY v.name"]
    )
    parameters: dict[str, JsonValue] = Field({}, max_length=50, examples=[{}])
    limit: int = Field(200, ge=1, le=1000, description="How many rows at most.")
