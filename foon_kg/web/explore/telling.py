"""What the API of the explorer answers, typed; things and what is known of them are the explorer's own values."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, JsonValue

from foon_kg.web.explore.about import About, Place
from foon_kg.web.explore.network import Edge, Thing


class Told(BaseModel):
    """A body that is answered; made from the explorer's own values."""

    model_config = ConfigDict(json_schema_serialization_defaults_required=True)  # all that there is to tell is told


class NeighbourhoodTold(Told):
    """A thing (the first), what is around it, and how many neighbours of each are not shown."""

    things: list[Thing]
    edges: list[Edge]
    more: dict[str, int]
    about: About


class StopTold(Told):
    """Where a food is on its way, and what it is called by then."""

    thing: Thing
    name: str


class StepTold(Told):
    """What is done on the way, and where that is seen."""

    thing: Thing
    places: list[Place]


class WayTold(Told):
    """The stops of a food and the steps between them, and the edges to draw."""

    stops: list[StopTold]
    steps: list[StepTold]
    edges: list[Edge]


class BeginTold(Told):
    """What can be filtered by, and what to begin with."""

    videos: list[str]
    motions: list[str]
    dish_types: list[str]
    begin: list[Thing]


class QuestionTold(Told):
    """A question that comes with foon-kg: its parameters with their types, and values to begin with."""

    name: str
    answers: str
    text: str
    parameters: dict[str, str]
    examples: dict[str, str]


class QuestionsTold(Told):
    """Whether questions in Cypher are allowed here, and those that come with foon-kg."""

    allowed: bool
    questions: list[QuestionTold]


class AnswerTold(Told):
    """An answer as a table (``cut``: there were more rows), and what of it can be drawn."""

    columns: list[str]
    rows: list[list[JsonValue]]
    cut: bool
    things: list[Thing]
    edges: list[Edge]
