"""What travels between Python and Neo4j: the rows that queries answer.

An object node travels as ``[label, states, ingredients, relation, container]``. How values of the model become rows and
rows values is in :mod:`foon_kg.store.graph.values`; what was learnt of a FOON has rows of its own, in ``method_rows``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

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
class GoneRow:
    """How many nodes and edges went."""

    gone: int
