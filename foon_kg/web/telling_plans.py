"""How the API answers a plan, typed: the OpenAPI document is made from this."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel

from foon_kg.web.telling import Near, Node, RecipeTold, Unit, Wanted


class Step(Unit):
    """A unit of a plan, and whether it is of the reference tree, of elsewhere, or has something substituted."""

    origin: Literal["foon", "adapted"]


class Reference(BaseModel):
    """The reference tree in figures."""

    goal: Node
    units: int
    overlap: int
    exact: bool


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
