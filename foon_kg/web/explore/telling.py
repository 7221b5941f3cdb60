"""What the API of the explorer answers, typed."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, JsonValue

from foon_kg.web.explore.network import ThingKind


class Told(BaseModel):
    """A body that is answered; made from the explorer's own values."""

    model_config = ConfigDict(from_attributes=True)


class ThingTold(Told):
    """Something in the picture, by its id; ``steps``: in how many it takes part. The note of a step is a sentence."""

    id: str
    kind: ThingKind
    name: str
    states: list[str]
    note: str
    steps: int
    vessel: bool
    empty: bool


class EdgeTold(Told):
    """What joins two things."""

    source: str
    target: str
    kind: str


class FactTold(Told):
    """Something that is known of a thing: a heading, and words below it."""

    name: str
    words: list[str]


class PlaceTold(Told):
    """Where a thing is seen: video, place of the step from 0, second, web address."""

    video: str
    step: int
    start: float | None
    address: str | None


class AboutTold(Told):
    """What a thing is."""

    text: str
    facts: list[FactTold]
    links: list[ThingTold]
    places: list[PlaceTold]


class NeighbourhoodTold(Told):
    """A thing (the first), what is around it, and how many neighbours of each are not shown."""

    things: list[ThingTold]
    edges: list[EdgeTold]
    more: dict[str, int]
    about: AboutTold


class StopTold(Told):
    """Where a food is on its way, and what it is called by then."""

    thing: ThingTold
    name: str


class StepTold(Told):
    """What is done on the way, and where that is seen."""

    thing: ThingTold
    places: list[PlaceTold]


class WayTold(Told):
    """The stops of a food and the steps between them, and the edges to draw."""

    stops: list[StopTold]
    steps: list[StepTold]
    edges: list[EdgeTold]


class BeginTold(Told):
    """What can be filtered by, and what to begin with."""

    videos: list[str]
    motions: list[str]
    dish_types: list[str]
    begin: list[ThingTold]


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
    things: list[ThingTold]
    edges: list[EdgeTold]
