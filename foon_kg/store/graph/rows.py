"""What travels between Python and Neo4j: the rows that queries answer.

An object node travels as ``[label, states, ingredients, relation, container]``. How values of the model become rows and
rows values is in :mod:`foon_kg.store.graph.values`; what was learnt of a FOON has rows of its own, in ``method_rows``.
"""

from __future__ import annotations

from typing import Any, ClassVar, dataclass_transform

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


@dataclass_transform(frozen_default=True)
class Row:
    """A row; its columns are what is annotated in its class, in this order.

    There are fifty kinds of rows, and each command imports them all. A data class takes half a millisecond to be made,
    for methods that no row needs; these share theirs.
    """

    columns: ClassVar[tuple[str, ...]] = ()

    def __init_subclass__(cls) -> None:
        """Take down the columns of a kind of rows."""
        cls.columns = tuple(cls.__annotations__)

    def __init__(self, *values: object, **named: object) -> None:
        """Take the values of the columns; raises TypeError where there are too many or others, or one is missing."""
        known = vars(self)
        known.update(zip(self.columns, values, strict=False), **named)
        fits = len(values) + len(named) == len(known) and all(hasattr(self, name) for name in self.columns)
        if not fits or (named and not named.keys() <= set(self.columns)):
            raise TypeError(f"{type(self).__name__} has the columns {', '.join(self.columns)}")

    def __setattr__(self, name: str, value: object) -> None:
        """Raise AttributeError: a row stays as it is, since its hash is that of its values."""
        raise AttributeError(f"{type(self).__name__} stays as it is: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        """Raise AttributeError, as where a value is set."""
        raise AttributeError(f"{type(self).__name__} stays as it is: {name} cannot be deleted")

    def __eq__(self, other: object) -> bool:
        """Whether the other one is such a row with the same values."""
        return type(other) is type(self) and all(getattr(self, name) == getattr(other, name) for name in self.columns)

    def __hash__(self) -> int:
        """Return the hash of its values; raises TypeError where one is a list."""
        return hash(tuple(getattr(self, name) for name in self.columns))

    def __repr__(self) -> str:
        """Return the row as it is written in Python."""
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in self.columns)})"


class Nothing(Row):
    """The row of a statement that answers nothing."""


class SchemaState(Row):
    """Which schema, kitchen and word lists a graph was written with; no ``words`` where it has no vectors yet.

    Every write that may change an answer gives the FOON a new ``edition``, a name that no other state of any graph has.
    ``methods`` says by which program its operators and frames were learnt; ``None`` where it has none yet.
    """

    version: int
    kitchen: str
    words: str | None = None
    edition: str | None = None
    methods: str | None = None


class UnitsCountRow(Row):
    """How many units a FOON has."""

    units: int


class SizeRow(Row):
    """How many units, videos and foods a FOON has, and its dish types."""

    units: int
    videos: int
    foods: int
    dish_types: list[str]


class NamesLikeRow(Row):
    """Names that a text may become; of a food also whether it is seen in the asked state."""

    foods: list[tuple[str, bool]]
    objects: list[str]
    goals: list[str]


class AroundLabelRow(Row):
    """How many units make and take an object, the keys of some of them, some of its nodes and videos."""

    nodes: list[NodeRow]
    made: list[str]
    made_count: int
    taken: list[str]
    taken_count: int
    videos: list[str]


class SomethingRow(Row):
    """Whether a database holds anything."""

    something: bool


class KeyRow(Row):
    """The key of one unit or object node."""

    key: str


class KeysRow(Row):
    """The keys of units or object nodes, in no order."""

    keys: list[str]


class StatesRow(Row):
    """The states of one object node."""

    states: list[str]


class NameRow(Row):
    """The name of one video or food."""

    name: str


class ShownRow(Row):
    """The key of one unit, and the videos that show it."""

    key: str
    videos: list[str]


class ContentRow(Row):
    """A video that the graph has, and the hash of its content."""

    name: str
    content: str


class DraftRow(Row):
    """A draft: the fields of a ``DraftedRecipe``."""

    id: str
    title: str
    dish_type: str
    table: str
    units: int
    left_out: int
    confidence: float


class UnitRow(Row):
    """A unit without anything that a video says about it."""

    key: str
    verb: str
    accepts_any: bool
    inputs: list[NodeRow]
    outputs: list[NodeRow]


class BehindRow(Row):
    """The keys of all units at once: one long row travels several times faster than many short ones."""

    keys: list[str]


class KnownUnitsRow(Row):
    """Units, each of their nodes once, and what the vocabulary has about their foods."""

    nodes: list[KeyedNode]
    units: list[KnownUnitValue]
    foods: list[StateRow]


class SubgraphRow(Row):
    """A video with its units in order."""

    name: str
    sources: list[str]
    units: list[SeenUnit]


class VocabularyRow(Row):
    """The tables of the vocabulary, in no order; of each state the labels of its foods, and their counts."""

    foods: list[StateRow]
    motions: list[tuple[str, str, int]]
    verbs: list[tuple[str, int, int]]
    dish_types: list[str]


class FoodRowsRow(Row):
    """What the vocabulary has about some foods, in no order."""

    foods: list[StateRow]


class StatisticsRow(Row):
    """Counts of the whole FOON; of verbs and dish types by name, of ``motions`` by state and verb, in no order."""

    videos: int
    units: int
    object_nodes: int
    labels: int
    states: int
    verbs: Counted
    goals: Counted
    motions: list[tuple[str, str, int]]


class WordsForRow(Row):
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


class PlanRow(Row):
    """A reference tree that was retrieved before: the fields of a ``RetrievedTree``."""

    question: str
    grounds: str
    goal: str
    units: list[str]
    gaps: list[str]


class EquivalentsRow(Row):
    """The known foods named like the asked one, and those near it: name, whether it is a food at all, cosine."""

    name: str
    equal: list[str]
    nearest: list[tuple[str, bool, float]]


class NodesRow(Row):
    """Object nodes, all in one row."""

    nodes: list[NodeRow]


class MotionCostsRow(Row):
    """The weights of motions: as many ``costs`` as ``motions``, in the same order."""

    motions: list[str]
    costs: list[float]


class VerbCostRow(Row):
    """A verb with how many units have it, and whether it has a weight now."""

    verb: str
    units: int
    has_cost: bool


class GoalsRow(Row):
    """All goals at once: their nodes, dish types, and the videos that make them."""

    goals: list[GoalValue]


class LikelyGoalsRow(Row):
    """Goals as in :class:`GoalsRow`, the known foods that their labels name, and the least gain among them."""

    goals: list[GoalValue]
    foods_named: list[str]
    are_all: bool
    least_gain: float | None


class GoneRow(Row):
    """How many nodes and edges went."""

    gone: int
