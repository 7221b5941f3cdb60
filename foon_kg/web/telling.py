"""What the API answers, typed: the OpenAPI document is made from this."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict

from foon_kg.foon import Taken


def _left_out(schema: dict[str, Any]) -> None:
    """Say in the ``schema`` of a model that what need not be there is left out, and never null."""
    for name, member in schema.get("properties", {}).items():
        if name not in schema.get("required", ()):
            member.pop("default", None)
            kinds = [kind for kind in member.pop("anyOf", ()) if kind != {"type": "null"}]
            member.update(kinds[0] if len(kinds) == 1 else {"anyOf": kinds} if kinds else {})


class Told(BaseModel):
    """What is told as JSON. A member with a default is there only where it says something, as the commands print it."""

    model_config = ConfigDict(json_schema_extra=_left_out)


class Node(Told):
    """An object node."""

    label: str
    states: list[str]
    ingredients: list[str]
    relation: str | None
    container: str | None


class AmountTold(Told):
    """How much of a food was asked, in the words of who asked ("1 1/2 cups", "flour")."""

    amount: str
    food: str


class MeasuresTold(Told):
    """How much, as it was recorded ("200 g flour") and as it was asked, how long and how hot.

    What nobody says is left out.
    """

    amounts: list[str] | None = None
    seconds: float | None = None
    celsius: float | None = None
    asked: list[AmountTold] | None = None


class SeenIn(Told):
    """Where a unit was seen: the place in the video, from 0, and seconds from its start."""

    video: str
    unit: int
    source: str | None
    start: float | None
    end: float | None
    measures: MeasuresTold | None = None


class Unit(Told):
    """A functional unit."""

    input_nodes: list[Node]
    motion_node: str
    output_nodes: list[Node]
    seen_in: list[SeenIn]


class Wanted(Told):
    """A food in a state, and how much of it and for what of the dish, where that was asked."""

    object: str
    state: str
    amount: str | None = None
    part: str | None = None


class RecipeTold(Told):
    """The recipe as it was understood."""

    id: str | None
    title: str | None
    dish_type: str
    ingredients: list[Wanted]


class NearAndWhy(Told):
    """A known name, how sure it is (0 to 1) that a cook would accept it, and what speaks for it."""

    name: str
    confidence: float
    why: list[str]


class SuggestionTold(Told):
    """A dish, and what of it is there."""

    goal: Node
    dish_type: str
    videos: list[str]
    units: int
    share: float
    taken: list[Taken]
    missing: list[str]
    assumed: list[Node]
    unused: list[str]
    exact: bool


class SuggestionsTold(Told):
    """The best dishes, best first."""

    suggestions: list[SuggestionTold]
    considered: int
    proven: int
    notes: list[str]


class SimilarTold(Told):
    """A name, and the known foods that can best stand for it."""

    name: str
    nearest: list[NearAndWhy]


class Summary(Told):
    """How large the FOON is; ``drafted_types`` are dish types that only ``drafts`` of recipes have."""

    dish_types: list[str]
    units: int
    videos: int
    foods: int
    drafts: int
    drafted_types: list[str]


class Example(Told):
    """A dish that a ``video`` of the FOON makes, its ``ingredients`` as a cook asks for them, and its plan's steps."""

    name: str
    dish_type: str
    ingredients: list[str]
    foods: list[str]
    video: str
    units: int


class Examples(Told):
    """Dishes to begin with."""

    examples: list[Example]


class UnitsTold(Told):
    """Some units with the web addresses (or null) of where they are seen, and how many there are."""

    count: int
    units: list[Unit]
    videos: list[str | None]


class ObjectTold(Told):
    """What the FOON has around an object."""

    label: str
    utensil: bool
    nodes: list[Node]
    made_by: UnitsTold
    taken_by: UnitsTold
    videos: list[str]


class MissingTold(Told):
    """Something that is not at hand, and what to do about it."""

    node: Node
    remedy: str


class ErrorTold(Told):
    """What is wrong, as a word for programs and a sentence for people, and what to do about it."""

    code: str
    message: str
    hint: str
    missing: list[MissingTold] | None = None


class Refusal(Told):
    """The body of every answer that is an error."""

    error: ErrorTold
    recipe: RecipeTold | None = None
    notes: list[str] | None = None
