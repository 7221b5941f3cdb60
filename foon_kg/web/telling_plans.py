"""How the API answers a plan, typed: the OpenAPI document is made from this.

Values of the plan stand here by themselves where their JSON is all of their fields. The others leave fields out that
say nothing, or are written in another way, and so have a type of their own; a test holds answers to it.
"""

from __future__ import annotations

from typing import Literal

from foon_kg.foon import PassedOver
from foon_kg.formats.exports.files import ExportFile
from foon_kg.model.knowledge import Neighbour
from foon_kg.plans.durations import Duration
from foon_kg.web.telling import MeasuresTold, Node, RecipeTold, SeenIn, Told, Wanted


class NumberedNode(Node):
    """An object node of a plan; the same thing in two steps has the same number, and two bowls have two.

    ``container_thing`` is the number of what it is in or on.
    """

    thing: int | None = None
    container_thing: int | None = None


class Found(Node):
    """An object node that has to be there before; ``things`` are the numbers of all that are found so."""

    things: list[int] | None = None


class PlanUnitTold(Told):
    """A unit of a plan: as the FOON has it or adapted, when it is done, and how near its evidence is.

    ``grounding``: the same food, a like one, one of its kind, or the motion alone.
    """

    input_nodes: list[NumberedNode]
    motion_node: str
    output_nodes: list[NumberedNode]
    phase: Literal["prepare", "heat", "finish"] | None = None
    origin: Literal["foon", "adapted"]
    grounding: Literal["food", "like", "kind", "motion"] | None = None
    seen_in: list[SeenIn]
    measures: MeasuresTold | None = None


class Reference(Told):
    """The reference tree in figures.

    ``videos`` are those after which the plan is made, ``core`` the foods of theirs that the recipe has too. Where the
    order of the steps is that of foon-kg's own tables, ``technique`` names it; a draft has its ``draft_confidence``.
    """

    goal: Node
    units: int
    overlap: int
    exact: bool
    videos: list[str]
    core: list[str]
    draft_confidence: float | None = None
    technique: str | None = None


class GoalPassedOver(Told):
    """A dish that is nearer by its ingredients, how near that is (0..1), and why it was not taken."""

    goal: Node
    similarity: float
    why: str


class StandsTold(Told):
    """A food of a step, the one that a video shows in its place, and how sure it is (0..1) that a cook accepts it."""

    object: str
    equivalent: str
    confidence: float


class ConsideredTold(Told):
    """Another dish that was considered: how near its foods are (0..1; ``nearer`` than the taken one's), why not it."""

    goal: Node
    video: str
    dish_type: str
    similarity: float
    nearer: bool
    why: str


class SubstitutionTold(Told):
    """What stood in the FOON (``equivalent``) where the recipe wants ``required``."""

    kind: Literal["object", "state", "motion", "tool", "vessel"]
    object: str
    required: str
    equivalent: str
    confidence: float
    alternatives: list[Neighbour]


class AssumptionTold(Told):
    """A leaf that is taken to be there, and why."""

    node: Node
    why: str


class Stage(Told):
    """One stage in the life of an ingredient, and the motion that ends it."""

    states: list[str]
    relation: str | None
    container: str | None
    motion: str


class Line(Told):
    """The life of one ingredient."""

    ingredient: str
    steps: list[Stage]
    end_product: str | None


class Renamed(Told):
    """An asked state, and what it was read as."""

    asked: str
    read_as: str


class JoiningTold(Told):
    """Where a food joins the others: the ``step`` (from 1), left out where it is in none, and its ``motion``.

    It comes in the place of ``like``, a food of the recorded dish ("": where its kind does), and is ``likeness`` (0..1)
    like it; ``left_open`` are the foods whose place it takes, which nobody asked for.
    """

    step: int | None = None
    motion: str
    like: str
    likeness: float
    left_open: list[str]


class ExplanationTold(Told):
    """Why one ingredient is made as it is; ``joins`` is left out where it joins nothing."""

    want: Wanted
    how: Literal["played", "made", "sold", "assumed", "missing"]
    label: str
    confidence: float
    chosen: bool
    renamed: list[Renamed]
    videos: list[str]
    joins: JoiningTold | None = None
    passed_over: list[PassedOver]


class ScheduledTold(Told):
    """When a unit (its place in the plan, from 0) is done, in seconds from the beginning.

    ``hands`` is which pair of hands does it (from 0), or null where it goes on by itself; ``duration`` is what videos
    show of its motion, or null where nobody has timed it: then it is given the time of a usual step.
    """

    unit: int
    start: float
    end: float
    hands: int | None
    duration: Duration | None


class ScheduleTold(Told):
    """Who does what when, for so many pairs of hands. ``alone`` is how long the steps take one after the other.

    ``shortest`` says that no schedule with these durations can be shorter. With ``untimed`` steps nobody knows how long
    it takes.
    """

    hands: int
    length: float
    alone: float
    shortest: bool
    untimed: int
    steps: list[ScheduledTold]


class Pictures(Told):
    """SVG texts; a schedule for each that was asked."""

    tree: str
    progress: str
    schedules: list[str]


class FindingTold(Told):
    """What the judge objects to: a ``rule`` of docs/contract.md, and the ``unit`` (from 0; null: the whole)."""

    rule: str
    level: Literal["minor", "fatal"]
    unit: int | None
    nodes: list[Node]
    reason: str


class NotAsked(Told):
    """A rule that could not be asked in full."""

    rule: str
    why: str


class JudgedTold(Told):
    """Whether a ``robot`` could carry the plan out and a ``cook`` would serve it, and what the judge found."""

    name: str
    accepted: bool
    robot: bool
    cook: bool
    form: bool
    findings: list[FindingTold]
    not_asked: list[NotAsked]
    notes: list[str]


class PlanTold(Told):
    """A plan: what ``foon plan --json`` prints, and more.

    ``shopping`` are the foods of the kitchen as one buys them; ``seen`` has for each unit the place to look at, in the
    video that the plan is made after where that shows it, ``videos`` the web address of its second, or null, ``stands``
    the foods that stand for others in what was seen, ``sentences`` what a cook does; ``amounts`` how much of each
    ingredient of the recipe was asked, or "". Explanations with the dishes
    considered and the judge's findings, schedules, pictures and the files of an export are there where they are asked.
    """

    recipe: RecipeTold
    reference: Reference
    goal: Node
    units: list[PlanUnitTold]
    kitchen: list[Found]
    substitutions: list[SubstitutionTold]
    assumptions: list[AssumptionTold]
    progress_lines: list[Line]
    passed_over: list[GoalPassedOver]
    notes: list[str]
    explanations: list[ExplanationTold] | None = None
    considered: list[ConsideredTold] | None = None
    judged: JudgedTold | None = None
    schedules: list[ScheduleTold] | None = None
    files: list[ExportFile] | None = None
    shopping: list[Node]
    seen: list[SeenIn | None]
    videos: list[str | None]
    stands: list[list[StandsTold]]
    sentences: list[str]
    amounts: list[str]
    pictures: Pictures | None = None
