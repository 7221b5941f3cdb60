"""What is asked of a FOON, whoever answers: Neo4j through Cypher, or a snapshot in memory.

What it teaches of making dishes is :class:`foon_kg.integration.methods.TeachingView`.

One suite of contract tests (``tests/contract``) runs against every implementation.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

from foon_kg.model import Goal, KnownUnit, ObjectNode


class SeenAs(NamedTuple):
    """How often a food is seen in a state: so many units make it so or use it so (a unit counts once).

    ``state`` is ``""`` for nodes without any state; such a row keeps the food known. A large FOON has a hundred
    thousand of these, and tuples are made several times as quickly as dataclasses.
    """

    label: str
    state: str
    made: int
    used: int


@dataclass(frozen=True, order=True)
class MadeBy:
    """How often units with this ``motion`` give ``state`` to a food: an output has it, and no input of that food."""

    state: str
    motion: str
    count: int


@dataclass(frozen=True, order=True)
class Gathering:
    """How many units have this ``motion``, and how many of them take ``several`` foods."""

    motion: str
    units: int
    several: int


@dataclass(frozen=True)
class Vocabulary:
    """The words that a FOON knows. Every table is sorted, so that two graphs with the same content answer alike.

    ``foods``: labels (utensils apart) with their states. ``motions``: which motion makes which state.
    ``dish_types``: the classes that have at least one goal node. ``gatherings``: how often the units of each motion
    take several foods. Where ``foods`` are only those that matter to a
    question (:meth:`KnowledgeView.words_for`), ``other_states`` are the states of all others.
    """

    foods: tuple[SeenAs, ...]
    motions: tuple[MadeBy, ...]
    dish_types: tuple[str, ...]
    other_states: tuple[str, ...] = ()
    gatherings: tuple[Gathering, ...] = ()

    @property
    def labels(self) -> list[str]:
        """Return the known foods by name, sorted.

        >>> seen = (SeenAs("onion", "chopped", 1, 2), SeenAs("onion", "whole", 0, 3))
        >>> words = Vocabulary(seen, (), (), ("salad",))
        >>> words.labels
        ['onion']
        """
        return sorted(self.rows_of)

    @cached_property
    def rows_of(self) -> Mapping[str, tuple[SeenAs, ...]]:
        """Return the rows about each known food, in their order.

        >>> seen = (SeenAs("onion", "chopped", 1, 2), SeenAs("onion", "whole", 0, 3))
        >>> words = Vocabulary(seen, (), (), ("salad",))
        >>> [row.state for row in words.rows_of["onion"]]
        ['chopped', 'whole']
        """
        rows: dict[str, list[SeenAs]] = {}
        for row in self.foods:
            rows.setdefault(row.label, []).append(row)
        return {label: tuple(found) for label, found in rows.items()}

    def gathers(self, motion: str) -> float:
        """Return how likely the next unit with ``motion`` takes several foods (0..1): half where none was seen yet.

        >>> Vocabulary((), (), (), gatherings=(Gathering("mix", 8, 8),)).gathers("mix")
        0.9
        """
        row = self._gathering_of.get(motion)
        return 0.5 if row is None else (row.several + 1) / (row.units + 2)  # the rule of succession

    @cached_property
    def _gathering_of(self) -> Mapping[str, Gathering]:
        return {row.motion: row for row in self.gatherings}


UNLIKE = 0.1
"""Below this confidence a food is like nothing that is known: less than one cook in ten takes it, and confidences
below it are 0."""

FAIR = 0.5
"""From this confidence on a cook would rather accept a food for another one than not."""


@dataclass(frozen=True, order=True)
class Neighbour:
    """A known name, and how sure we are (0 to 1) that a cook would accept it for the name asked.

    >>> max(Neighbour("onion", 0.9), Neighbour("leek", 0.4), key=lambda one: one.confidence).name
    'onion'
    """

    name: str
    confidence: float


@dataclass(frozen=True)
class LikelyGoals:
    """Goals among which the likest to a recipe are sought (:mod:`foon_kg.goals.choice`).

    No other goal of the asked dish types scores more than ``most``; ``None`` where there is no other. ``known_foods``
    has every known food that the label of one of ``goals`` names, each word in the singular.
    """

    goals: tuple[Goal, ...]
    known_foods: frozenset[str]
    most: float | None = None


@dataclass(frozen=True)
class RetrievedTree:
    """A reference tree that was retrieved and proven, as it is kept for who asks again.

    ``question`` names what was asked, ``grounds`` all that the answer depends on: asked the same on the same grounds, a
    search would find these ``units`` and ``gaps`` again. ``goal``, units and gaps are named by their keys.
    """

    question: str
    grounds: str
    goal: str
    units: tuple[str, ...]
    gaps: tuple[str, ...]


class TreeMemory(Protocol):
    """Where reference trees are kept once they were retrieved."""

    def remembered(self, question: str) -> RetrievedTree | None:
        """Return the tree that is kept for ``question``, whatever its grounds are."""
        ...

    def remember(self, tree: RetrievedTree) -> None:
        """Keep ``tree``, sooner or later or not at all: nothing may depend on it."""
        ...


class KnowledgeView(Protocol):
    """A FOON as it stands at one moment. All answers of one view describe the same state of the graph."""

    @property
    def sureness(self) -> Mapping[str, float]:
        """How sure each draft of a recipe is (0 to 1), by the name by which it is evidence; nothing without drafts."""
        ...

    @property
    def memory(self) -> TreeMemory | None:
        """Where the reference trees that are retrieved from this FOON are kept, if anywhere."""
        ...

    def moved(self) -> bool:
        """Return whether somebody wrote since the view began, so that its answers may be of two states.

        From then on it is a view of the new state: who asked several things asks them again.
        """
        ...

    def vocabulary(self) -> Vocabulary:
        """Return the words that the FOON knows."""
        ...

    def words_for(self, foods: Sequence[str], called: Sequence[str] = ()) -> Vocabulary:
        """Return what of the vocabulary matters to a recipe that asks for ``foods``; it may be more, up to all of it.

        States, motions and dish types are all there. Of the foods there are, with all that is known of them, those
        that have an equal canonical name (``foon_kg.model.names``) with one of ``foods`` or of ``called``, those named
        after one of ``foods`` with more words, and all that the default similarity takes for a fair equivalent of one
        of them; where there is one, the four best at least, itself apart.
        """
        ...

    def words_in(self, units: Sequence[KnownUnit], words: Vocabulary) -> Vocabulary:
        """Return ``words``, which :meth:`words_for` answered, with all that is known of the foods in ``units``.

        ``units`` were answered by :meth:`behind`.
        """
        ...

    def words_named(self, names: Collection[str]) -> Vocabulary:
        """Return what is known of the foods with just these ``names``; it may be more, up to the whole vocabulary."""
        ...

    def goals(self, dish_type: str | None = None) -> tuple[Goal, ...]:
        """Return the goals of ``dish_type`` (of every type for ``None``), sorted by node."""
        ...

    def likely_goals(self, dish_type: str | None, foods: Sequence[str], count: int) -> LikelyGoals:
        """Return the ``count`` goals, or some more, that may score highest for a recipe of ``foods``, in no order.

        They are of ``dish_type``, of any for ``None``. The score is that of the default similarity. All of the goals
        are returned where they are few.
        """
        ...

    def behind(self, nodes: Collection[ObjectNode], foods: Collection[tuple[str, str]] = ()) -> tuple[KnownUnit, ...]:
        """Return every unit that may take part in making any of ``nodes``, or any node of one of ``foods``.

        A food is (label, state): every node with that label which has that state. Answered are the units that
        output such a node, the units that output any of *their* inputs, and so on; a node that is at hand
        in the default kitchen (``foon_kg.plans.kitchen``) is never expanded, the asked ones apart. Sorted by unit key.
        """
        ...

    def equivalents(self, names: Sequence[str], *, limit: int = 5) -> tuple[tuple[Neighbour, ...], ...]:
        """Return, for each of ``names``, at most ``limit`` known foods that can best stand for it.

        They are those of the default similarity (``foon_kg.similarity``), best first, ties by name; fewer only where
        the FOON knows fewer. A name need not be known.
        """
        ...


class KnowledgeGraph(Protocol):
    """Where a FOON is kept."""

    def reading(self) -> AbstractContextManager[KnowledgeView]:
        """Open a view; everything asked of it happens in one read transaction."""
        ...
