"""What the API answers, typed: the OpenAPI document is made from this."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel


class Node(BaseModel):
    """An object node."""

    label: str
    states: list[str]
    ingredients: list[str]
    relation: str | None
    container: str | None


class SeenIn(BaseModel):
    """Where a unit was seen: the place in the video, from 0, and seconds from its start."""

    video: str
    unit: int
    source: str | None
    start: float | None
    end: float | None


class Unit(BaseModel):
    """A functional unit."""

    input_nodes: list[Node]
    motion_node: str
    output_nodes: list[Node]
    seen_in: list[SeenIn]


class Step(Unit):
    """A unit of a plan, and whether it is of the reference tree, of elsewhere, or has something substituted."""

    origin: Literal["reference", "foon", "substituted"]


class Wanted(BaseModel):
    """A food in a state."""

    object: str
    state: str


class RecipeTold(BaseModel):
    """The recipe as it was understood."""

    id: str | None
    title: str | None
    dish_type: str
    ingredients: list[Wanted]


class Reference(BaseModel):
    """The reference tree in figures."""

    goal: Node
    units: int
    overlap: int
    exact: bool


class Near(BaseModel):
    """A known name, and how sure it is (0 to 1) that a cook would accept it."""

    name: str
    confidence: float


class NearAndWhy(Near):
    """The same with what speaks for it."""

    why: list[str]


class SubstitutionTold(BaseModel):
    """What stood in the FOON (``equivalent``) where the recipe wants ``required``."""

    kind: Literal["object", "state", "motion"]
    object: str
    required: str
    equivalent: str
    confidence: float
    alternatives: list[Near]


class AssumptionTold(BaseModel):
    """A leaf that is taken to be there, and why."""

    node: Node
    why: str


class Stage(BaseModel):
    """One stage in the life of an ingredient, and the motion that ends it."""

    states: list[str]
    relation: str | None
    container: str | None
    motion: str


class Line(BaseModel):
    """The life of one ingredient."""

    ingredient: str
    steps: list[Stage]
    end_product: str | None


class PassedOverTold(BaseModel):
    """A known food that might have stood for the required one, and why it does not."""

    label: str
    state: str
    confidence: float
    why: str


class JoiningTold(BaseModel):
    """Where a food joins the others (the step from 1), and why there."""

    step: int | None
    motion: str
    like: str
    likeness: float
    left_open: list[str]


class Renamed(BaseModel):
    """A state or motion as the FOON has it, and what stands for it now."""

    known: str
    now: str


class ExplanationTold(BaseModel):
    """Why one ingredient is made as it is."""

    want: Wanted
    how: Literal["played", "made", "sold", "assumed", "missing"]
    label: str
    confidence: float
    chosen: bool
    renamed: list[Renamed]
    videos: list[str]
    joins: JoiningTold | None
    passed_over: list[PassedOverTold]


class DurationTold(BaseModel):
    """Seconds that a motion takes: the median of its sightings, and the quartiles around it."""

    median: float
    low: float
    high: float
    sightings: int


class ScheduledTold(BaseModel):
    """When a unit (its place in the plan, from 0) is done, in seconds from the beginning.

    ``hands`` is which pair of hands does it (from 0), or null where it goes on by itself; ``duration`` is what videos
    show of its motion, or null where nobody has timed it: then it is given the time of a usual step.
    """

    unit: int
    start: float
    end: float
    hands: int | None
    duration: DurationTold | None


class ScheduleTold(BaseModel):
    """Who does what when, for so many pairs of hands. ``alone`` is how long the steps take one after the other.

    ``shortest`` says that no schedule with these durations can be shorter.
    """

    hands: int
    length: float
    alone: float
    shortest: bool
    steps: list[ScheduledTold]


class Pictures(BaseModel):
    """SVG texts; a schedule for each that was asked."""

    tree: str
    progress: str
    schedules: list[str]


class PlanTold(BaseModel):
    """A plan: what ``foon plan --json`` prints, and more.

    ``shopping`` are the foods of the kitchen as one buys them; ``videos`` has for each unit the web address of the
    second in which it is seen, or null. Explanations, schedules and pictures are there where they are asked.
    """

    recipe: RecipeTold
    reference: Reference
    goal: Node
    units: list[Step]
    kitchen: list[Node]
    substitutions: list[SubstitutionTold]
    assumptions: list[AssumptionTold]
    progress_lines: list[Line]
    notes: list[str]
    explanations: list[ExplanationTold] | None = None
    schedules: list[ScheduleTold] | None = None
    shopping: list[Node]
    videos: list[str | None]
    pictures: Pictures | None = None


class TakenTold(BaseModel):
    """A food that a dish takes, and the food of one's own that stands for it."""

    food: str
    own: str
    confidence: float


class SuggestionTold(BaseModel):
    """A dish, and what of it is there."""

    goal: Node
    dish_type: str
    videos: list[str]
    units: int
    share: float
    taken: list[TakenTold]
    missing: list[str]
    assumed: list[Node]
    unused: list[str]
    exact: bool


class SuggestionsTold(BaseModel):
    """The best dishes, best first."""

    suggestions: list[SuggestionTold]
    considered: int
    proven: int
    notes: list[str]


class SimilarTold(BaseModel):
    """A name, and the known foods that can best stand for it."""

    name: str
    nearest: list[NearAndWhy]


class Summary(BaseModel):
    """How large the FOON is."""

    dish_types: list[str]
    units: int
    videos: int
    foods: int


class UnitsTold(BaseModel):
    """Some units with the web addresses (or null) of where they are seen, and how many there are."""

    count: int
    units: list[Unit]
    videos: list[str | None]


class ObjectTold(BaseModel):
    """What the FOON has around an object."""

    label: str
    utensil: bool
    nodes: list[Node]
    made_by: UnitsTold
    taken_by: UnitsTold
    videos: list[str]


class MissingTold(BaseModel):
    """Something that is not at hand, and what to do about it."""

    node: Node
    remedy: str


class ErrorTold(BaseModel):
    """What is wrong, as a word for programs and a sentence for people, and what to do about it."""

    code: str
    message: str
    hint: str
    missing: list[MissingTold] | None = None


class Refusal(BaseModel):
    """The body of every answer that is an error."""

    error: ErrorTold
    recipe: RecipeTold | None = None
    notes: list[str] | None = None
