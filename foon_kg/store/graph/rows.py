"""What travels between Python and Neo4j: the rows that queries answer, and the values of the model in and out of them.

An object node travels as ``[label, states, ingredients, relation, container]``. What one video says about a unit beside
its identity (order, moving flags, dish classes, time) is kept on the ``SEEN_IN`` edge. A side of the unit is written
there as the ranks of its participants among the distinct nodes of that side in their total order.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from foon_kg.model import Annotation, FunctionalUnit, Measures, ObjectNode, Participant, Timing

NodeRow = tuple[str, list[str], list[str], str | None, str | None]
Properties = dict[str, Any]
GoalValue = tuple[NodeRow, str, list[str]]
"""``[node, dish_type, videos]``."""

SeenUnit = tuple[str, str, bool, list[NodeRow], list[NodeRow], Properties]
"""``[key, verb, accepts_any, inputs, outputs, properties]``: a unit as one video has it."""

KeyedNode = tuple[int, str, str, list[str], list[str], str | None, str | None]
"""``[number, key, label, states, ingredients, relation, container]``; numbers hold for one answer."""

KnownUnitValue = tuple[str, str, bool, list[int], list[int], list[list[Any]]]
"""``[key, verb, accepts_any, inputs, outputs, sightings]``, the nodes by their numbers. A sighting has the values of a
``Sighting`` (its measures are one list), then those of ``inputs``, ``inputs_moving``, ``inputs_dish``, ``outputs``, …
on its ``SEEN_IN`` edge."""


StateRow = tuple[str, list[str], list[int], list[int]]
"""``[state, labels, made, used]``: foods that are seen in a state, and how many units make and use each of them so."""


SightingValue = tuple[str, int, str | None, float | None, float | None]
"""The values of a ``Sighting``: video, position, source, start and end."""

EvidenceValue = tuple[int, int, list[str], list[str]]
"""``[units, changed, seen, changes]``: how many units of an operator are done to a matter, how many
change it, and the texts of the first sightings of either."""

MatterValue = tuple[str, list[tuple[int, EvidenceValue]], list[tuple[int, str, int]], list[str]]
"""``[name, evidence, brings, states]`` of a matter: see :class:`MethodsAskedRow`."""

FrameValue = tuple[str, str, str, list[str], list[str], list[str]]
"""``[key, dish_type, label, foods, kinds, ends]`` of a frame."""

FrameReadValue = tuple[str, str, list[str]]
"""``[key, text, videos]`` of a frame; the videos are those that show a way to its goal."""

Counted = list[tuple[str, int]]
"""Names with their counts."""


@dataclass(frozen=True)
class Nothing:
    """The row of a statement that answers nothing."""


@dataclass(frozen=True)
class SchemaState:
    """Which schema, kitchen and word lists a graph was written with; no ``words`` where it has no vectors yet.

    Every write that may change an answer gives the FOON a new ``edition``, a name that no other state of any graph has.
    ``methods`` says by which program its operators and frames were learnt; ``None`` where it has none yet.
    """

    version: int
    kitchen: str
    words: str | None = None
    edition: str | None = None
    methods: str | None = None


@dataclass(frozen=True)
class UnitsCountRow:
    """How many units a FOON has."""

    units: int


@dataclass(frozen=True)
class SizeRow:
    """How many units, videos and foods a FOON has, and its dish types."""

    units: int
    videos: int
    foods: int
    dish_types: list[str]


@dataclass(frozen=True)
class NamesLikeRow:
    """Names that a text may become; of a food also whether it is seen in the asked state."""

    foods: list[tuple[str, bool]]
    objects: list[str]
    goals: list[str]


@dataclass(frozen=True)
class AroundLabelRow:
    """How many units make and take an object, the keys of some of them, some of its nodes and videos."""

    nodes: list[NodeRow]
    made: list[str]
    made_count: int
    taken: list[str]
    taken_count: int
    videos: list[str]


@dataclass(frozen=True)
class SomethingRow:
    """Whether a database holds anything."""

    something: bool


@dataclass(frozen=True)
class KeyRow:
    """The key of one unit or object node."""

    key: str


@dataclass(frozen=True)
class StatesRow:
    """The states of one object node."""

    states: list[str]


@dataclass(frozen=True)
class NameRow:
    """The name of one video or food."""

    name: str


@dataclass(frozen=True)
class ShownRow:
    """The key of one unit, and the videos that show it."""

    key: str
    videos: list[str]


@dataclass(frozen=True)
class ContentRow:
    """A video that the graph has, and the hash of its content."""

    name: str
    content: str


@dataclass(frozen=True)
class DraftRow:
    """A draft: the fields of a ``DraftedRecipe``."""

    id: str
    title: str
    dish_type: str
    table: str
    units: int
    left_out: int
    confidence: float


@dataclass(frozen=True)
class UnitRow:
    """A unit without anything that a video says about it."""

    key: str
    verb: str
    accepts_any: bool
    inputs: list[NodeRow]
    outputs: list[NodeRow]


@dataclass(frozen=True)
class BehindRow:
    """The keys of all units at once: one long row travels several times faster than many short ones."""

    keys: list[str]


@dataclass(frozen=True)
class KnownUnitsRow:
    """Units, each of their nodes once, and what the vocabulary has about their foods."""

    nodes: list[KeyedNode]
    units: list[KnownUnitValue]
    foods: list[StateRow]


@dataclass(frozen=True)
class SubgraphRow:
    """A video with its units in order."""

    name: str
    sources: list[str]
    units: list[SeenUnit]


@dataclass(frozen=True)
class VocabularyRow:
    """The tables of the vocabulary, in no order; of each state the labels of its foods, and their counts."""

    foods: list[StateRow]
    motions: list[tuple[str, str, int]]
    verbs: list[tuple[str, int, int]]
    dish_types: list[str]


@dataclass(frozen=True)
class FoodRowsRow:
    """What the vocabulary has about some foods, in no order."""

    foods: list[StateRow]


@dataclass(frozen=True)
class StatisticsRow:
    """Counts of the whole FOON; of verbs and dish types by name, of ``motions`` by state and verb, in no order."""

    videos: int
    units: int
    object_nodes: int
    labels: int
    states: int
    verbs: Counted
    goals: Counted
    motions: list[tuple[str, str, int]]


@dataclass(frozen=True)
class WordsForRow:
    """A part of the vocabulary, in no order, with mere ingredients among its ``names``.

    ``nearest`` says of each asked food how many points were near it, and the cosine of the furthest of them.
    """

    nearest: list[tuple[str, int, float]]
    names: list[str]
    all_placed: bool
    foods: list[StateRow]
    states: list[str]
    motions: list[tuple[str, str, int]]
    verbs: list[tuple[str, int, int]]
    dish_types: list[str]


@dataclass(frozen=True)
class PlanRow:
    """A reference tree that was retrieved before: the fields of a ``RetrievedTree``."""

    question: str
    grounds: str
    goal: str
    units: list[str]
    gaps: list[str]


@dataclass(frozen=True)
class EquivalentsRow:
    """The known foods named like the asked one, and those near it: name, whether it is a food at all, cosine."""

    name: str
    equal: list[str]
    nearest: list[tuple[str, bool, float]]


@dataclass(frozen=True)
class NodesRow:
    """Object nodes, all in one row."""

    nodes: list[NodeRow]


@dataclass(frozen=True)
class MotionCostsRow:
    """The weights of motions: as many ``costs`` as ``motions``, in the same order."""

    motions: list[str]
    costs: list[float]


@dataclass(frozen=True)
class VerbCostRow:
    """A verb with how many units have it, and whether it has a weight now."""

    verb: str
    units: int
    has_cost: bool


@dataclass(frozen=True)
class GoalsRow:
    """All goals at once: their nodes, dish types, and the videos that make them."""

    goals: list[GoalValue]


@dataclass(frozen=True)
class LikelyGoalsRow:
    """Goals as in :class:`GoalsRow`, the known foods that their labels name, and the least gain among them."""

    goals: list[GoalValue]
    foods_named: list[str]
    are_all: bool
    least_gain: float | None


@dataclass(frozen=True)
class AttestedRow:
    """For each unit its key, that of its operator, what it is done to, and what of that it changes."""

    attested: list[tuple[str, str, list[str], list[str]]]


@dataclass(frozen=True)
class EvidenceRow:
    """For operators and matters the texts of the sightings that are kept: of all units, and of those that change it."""

    kept: list[tuple[str, str, list[str], list[str]]]


@dataclass(frozen=True)
class FirstSightingsRow:
    """Where an operator was first seen done to a matter, and first seen to change it."""

    operator: str
    matter: str
    seen: list[SightingValue]
    changes: list[SightingValue]


@dataclass(frozen=True)
class GoneRow:
    """How many nodes and edges went."""

    gone: int


@dataclass(frozen=True)
class TextRow:
    """The text of one frame."""

    text: str


PostCount = tuple[str, str, str, str, bool, int]
"""``[kind, dish_type, work, heated, joins, count]``."""


@dataclass(frozen=True)
class MethodsCommonRow:
    """What of the methods matters to every question, in no order. Operators go by their numbers in the store.

    ``operators``: number, motion, tools, and evidence for anything. ``usual``: the foods that each is most often done
    to, and most often changes.
    """

    operators: list[tuple[int, str, list[str], EvidenceValue]]
    usual: list[tuple[int, str, EvidenceValue]]
    gives: list[tuple[int, str, int]]
    places: list[tuple[int, str, int]]
    appliances: list[tuple[int, str, int]]
    brings: list[tuple[int, str, str, int]]
    states: list[tuple[str, list[str]]]
    posts: list[PostCount]
    beside: list[tuple[str, str, int]]
    cooked: list[tuple[str, str, int]]


@dataclass(frozen=True)
class MethodsAskedRow:
    """For each asked food the number of points looked at, the cosine of the furthest, and the names of the near ones.

    For each matter the evidence of its operators, from where they bring it (number, role, count), and its states.
    """

    near: list[tuple[str, int, float | None, list[str]]]
    matters: list[MatterValue]


@dataclass(frozen=True)
class FramesRow:
    """All frames, in no order."""

    frames: list[FrameValue]


@dataclass(frozen=True)
class FramesReadRow:
    """Frames that are looked at closely, in no order."""

    frames: list[FrameReadValue]


@dataclass(frozen=True)
class MethodsRow:
    """What was learnt of a FOON, in no order. The first seven columns have a value for each operator.

    Of ``brings`` matter, role and count; of ``posts`` kind, dish type, the three parts of the post, and count.
    """

    operators: list[tuple[str, list[str]]]
    evidence: list[list[tuple[str, EvidenceValue]]]
    gives: list[Counted]
    brings: list[list[tuple[str, str, int]]]
    places: list[Counted]
    appliances: list[Counted]
    states: list[tuple[str, list[str]]]
    posts: list[PostCount]
    beside: list[tuple[str, str, int]]
    cooked: list[tuple[str, str, int]]
    frames: list[str]


def node_of(row: NodeRow) -> ObjectNode:
    """Return the object node that travelled as ``row``."""
    label, states, ingredients, relation, container = row
    return ObjectNode(label, tuple(states), tuple(ingredients), relation, container)


def row_of(node: ObjectNode) -> NodeRow:
    """Return ``node`` as it travels."""
    return (node.label, list(node.states), list(node.ingredients), node.relation, node.container)


def unit_of(
    verb: str, inputs: Iterable[NodeRow], outputs: Iterable[NodeRow], seen: Properties, *, accepts_any: bool
) -> FunctionalUnit:
    """Return the unit ``verb`` as one video has it, with its ``inputs``, its ``outputs`` and how it was ``seen``.

    ``accepts_any`` says that it may take any number of inputs.
    """
    ins, outs = _participants(inputs, seen, "inputs"), _participants(outputs, seen, "outputs")
    return FunctionalUnit(ins, verb, outs, accepts_any)


def bare_unit_of(row: UnitRow) -> FunctionalUnit:
    """Return the unit of a ``row`` without anything that a video says about it."""
    inputs, outputs = (tuple(Participant(node_of(node)) for node in side) for side in (row.inputs, row.outputs))
    return FunctionalUnit(inputs, row.verb, outputs, row.accepts_any)


def timing_of(seen: Properties) -> Timing:
    """Return the time in the properties with which a unit was ``seen``, as :func:`properties_of` wrote it."""
    return Timing(tuple(zip(seen["span_starts"], seen["span_ends"], strict=True)), seen["assumed"])


def measures_of(amounts: Sequence[str] | None, seconds: float | None, celsius: float | None) -> Measures:
    """Return ``amounts``, ``seconds`` and ``celsius`` as measures, as :func:`properties_of` wrote them."""
    return Measures(tuple(amounts or ()), seconds, celsius)


def properties_of(annotation: Annotation, position: int) -> Properties:
    """Return what the ``SEEN_IN`` edge of ``annotation`` at a ``position`` (from 0) keeps."""
    unit, timing, measures = annotation.unit, annotation.timing, annotation.measures
    return {
        "position": position,
        "start": timing.start,
        "end": timing.end,
        "assumed": timing.assumed,
        "span_starts": [float(start) for start, _ in timing.spans],
        "span_ends": [float(end) for _, end in timing.spans],
        **_side_as_properties(unit.inputs, "inputs"),
        **_side_as_properties(unit.outputs, "outputs"),
        "amounts": list(measures.amounts) or None,
        "seconds": measures.seconds,
        "celsius": measures.celsius,
    }


def _side_as_properties(participants: Sequence[Participant], side: str) -> Properties:
    distinct = sorted({p.node for p in participants}, key=lambda node: order(row_of(node)))
    ranks = {node: rank for rank, node in enumerate(distinct)}
    return {
        side: [ranks[p.node] for p in participants],
        f"{side}_moving": [p.moving for p in participants],
        f"{side}_dish": [p.dish_type or "" for p in participants],
    }


def _participants(rows: Iterable[NodeRow], seen: Properties, side: str) -> tuple[Participant, ...]:
    nodes = [node_of(row) for row in sorted(rows, key=order)]
    columns = zip(seen[side], seen[f"{side}_moving"], seen[f"{side}_dish"], strict=True)
    return tuple(Participant(nodes[rank], moving, dish or None) for rank, moving, dish in columns)


def order(row: NodeRow) -> tuple[object, ...]:
    """Return the order of a ``row`` that ranks count in; no two nodes are equal in it."""
    label, states, ingredients, relation, container = row
    return (label, states, ingredients, relation is not None, relation or "", container is not None, container or "")
