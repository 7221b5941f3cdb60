"""A FOON in Neo4j, as the planner asks it: each question one named query, all of a view in one read transaction."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import chain, groupby
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import neo4j

from foon_kg.food import singular, words
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import DISH_TYPES, Goal, KnownUnit, ObjectNode, Subgraph
from foon_kg.model.drafted import MOST_OF_A_DISH_TYPE, DraftedRecipe, Lesson
from foon_kg.model.errors import SchemaError, TooManyUnitsError
from foon_kg.model.knowledge import Gathering, LikelyGoals, MadeBy, Neighbour, RetrievedTree, Vocabulary
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import food_similarity
from foon_kg.similarity.confidences import nearest_of_each
from foon_kg.store.graph.edition import Edition
from foon_kg.store.graph.equivalents import find_equivalents
from foon_kg.store.graph.kept_rows import KeptRows
from foon_kg.store.graph.known_units import known_units
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.method_rows import FrameReadValue
from foon_kg.store.graph.methods import CommonMethods, LearntDishes, methods_of
from foon_kg.store.graph.rows import StateRow
from foon_kg.store.graph.schema import check_readable
from foon_kg.store.graph.statements import (
    BEHIND,
    BEHIND_ONE,
    EQUIVALENTS,
    FOOD_ROWS,
    FRAMES,
    FRAMES_READ,
    GOALS,
    KNOWN_UNITS,
    LIKELY_GOALS,
    METHODS,
    METHODS_ASKED,
    METHODS_COMMON,
    MOTION_COSTS,
    NODES_CALLED,
    REMEMBERED,
    SCHEMA_STATE,
    SUBGRAPHS,
    SURE_DRAFTS,
    VIDEO_NAMES,
    VOCABULARY,
    WORDS_FOR,
    R,
    Statement,
    ask,
)
from foon_kg.store.graph.values import goal_of, node_of, subgraph_of
from foon_kg.store.graph.words_for import WordsFound, find_words, seen_as

if TYPE_CHECKING:
    from foon_kg.integration.methods import Methods

MOST_LEARNT_ANEW = 500
"""Of so many videos what another program learnt is learnt anew to read it, which takes some ten seconds."""

UNITS_AT_ONCE = 1_000
"""So many units are asked for in one question: ten thousand take more memory than a server of ours has for it."""


FOODS_AT_ONCE = 5_000
"""Of so many foods the rows are asked for in one question."""


class GraphView:
    """One read transaction on the graph; implements :class:`~foon_kg.model.knowledge.KnowledgeView`.

    ``round_trips`` counts the queries that were sent: for the units behind something one that finds them and one that
    fetches those which no view of this ``edition`` has fetched yet, else one a question, or none where it was asked
    before. Neo4j reads what is committed when a query starts: a load that ends between two questions shows in the
    second.
    """

    def __init__(self, transaction: neo4j.Transaction, edition: Edition | None = None) -> None:
        self._transaction = transaction
        self._edition = edition or Edition()
        self._kitchen = Kitchen.default()
        self._learnt_by: str | None = methods_key()
        self.round_trips = 0
        self.retrieved: list[RetrievedTree] = []
        self._fetched: list[tuple[Statement[Any], dict[str, object], list[Any]]] = []

    def vocabulary(self) -> Vocabulary:
        """Return the words that the FOON knows."""
        if self._edition.vocabulary is None:
            self._edition.vocabulary = self._read_vocabulary()
        return self._edition.vocabulary

    def _read_vocabulary(self) -> Vocabulary:
        (row,) = self._ask_once(VOCABULARY)
        motions = (MadeBy(*motion) for motion in sorted(row.motions))
        gatherings = tuple(Gathering(*verb) for verb in sorted(row.verbs))
        foods, dish_types = sorted(seen_as(row.foods)), sorted(row.dish_types)
        return Vocabulary(tuple(foods), tuple(motions), tuple(dish_types), gatherings=gatherings)

    def words_for(self, foods: Sequence[str], called: Sequence[str] = ()) -> Vocabulary:
        """Return what of the vocabulary matters to a recipe for ``foods``, and to foods ``called`` by other names."""
        found = self._words_found(foods, called)
        return self.vocabulary() if found is None else found.vocabulary

    def _words_found(self, foods: Sequence[str], called: Sequence[str] = ()) -> WordsFound | None:
        asked = tuple(sorted(set(foods))), tuple(sorted(set(called)))
        if asked not in self._edition.words:
            self._edition.words[asked] = find_words(lambda question: self._ask(WORDS_FOR, **question), *asked)
        return self._edition.words[asked]

    def words_in(self, units: Sequence[KnownUnit], words: Vocabulary) -> Vocabulary:
        """Return ``words`` with all that is known of the foods in ``units``."""
        if words is self._edition.vocabulary:
            return words
        nodes = {node for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
        names = {name for node in nodes for name in (node.label, *node.ingredients)} & self._edition.rows_of.keys()
        more = chain.from_iterable(self._edition.rows_of[name] for name in names - words.rows_of.keys())
        return replace(words, foods=tuple(sorted((*words.foods, *more))))

    def words_named(self, names: Collection[str]) -> Vocabulary:
        """Return what the FOON knows of the foods with these ``names``; of words nothing else."""
        missing = sorted(set(names) - self._edition.rows_of.keys())
        for start in range(0, len(missing), FOODS_AT_ONCE):
            some = missing[start : start + FOODS_AT_ONCE]
            (row,) = self._ask(FOOD_ROWS, names=some)
            self._keep_rows(some, row.foods)
        rows = chain.from_iterable(self._edition.rows_of[name] for name in set(names))
        return Vocabulary(tuple(sorted(rows)), (), ())

    def _keep_rows(self, names: Iterable[str], rows: Sequence[StateRow]) -> None:
        """Keep all that is known of the foods with these ``names``; utensils among them have no rows."""
        self._edition.rows_of.update((name, ()) for name in names)
        found = groupby(sorted(seen_as(rows)), key=attrgetter("label"))
        self._edition.rows_of.update((label, tuple(some)) for label, some in found)

    def goals(self, dish_type: str | None = None) -> tuple[Goal, ...]:
        """Return the goals of ``dish_type`` (of every type for ``None``), sorted by node and type."""
        if dish_type is None:
            return self._read_goals(DISH_TYPES)
        if dish_type not in self._edition.goals:
            self._edition.goals[dish_type] = self._read_goals((dish_type,))
        return self._edition.goals[dish_type]

    def _read_goals(self, asked: Sequence[str]) -> tuple[Goal, ...]:
        (row,) = self._ask_once(GOALS, dish_types=list(asked))
        return tuple(sorted(map(goal_of, row.goals), key=lambda goal: (goal.node.sort_key, goal.dish_type)))

    def likely_goals(self, dish_type: str | None, foods: Sequence[str], count: int) -> LikelyGoals:
        """Return the ``count`` goals of ``dish_type``, or some more, that may score highest for ``foods``."""
        asked = dish_type, tuple(sorted(set(foods))), count
        if asked not in self._edition.likely:
            self._edition.likely[asked] = self._read_likely_goals(*asked)
        return self._edition.likely[asked]

    def _read_likely_goals(self, dish_type: str | None, foods: Sequence[str], count: int) -> LikelyGoals:
        found = self._words_found(foods)
        if found is None:
            return LikelyGoals(self.goals(dish_type), frozenset(map(singular, self.vocabulary().rows_of)))
        near = [{"food": food, "name": name, "gain": sure} for food, name, sure in found.pairs]
        asked = DISH_TYPES if dish_type is None else (dish_type,)
        (row,) = self._ask(LIKELY_GOALS, dish_types=list(asked), near=near, count=count)
        goals = tuple(map(goal_of, row.goals))
        gain = (row.least_gain or 0.0) if len({goal.node for goal in goals}) == count else 0.0
        most = None if row.are_all else gain
        return LikelyGoals(goals, frozenset(row.foods_named), most)

    def behind(
        self, nodes: Collection[ObjectNode], foods: Collection[tuple[str, str]] = (), *, most: int | None = None
    ) -> tuple[KnownUnit, ...]:
        """Return every unit that may take part in making ``nodes`` or ``foods``, sorted by key.

        Raises TooManyUnitsError for more than ``most``, where that is a number.
        """
        keys = sorted({node.key for node in nodes})
        asked = [{"label": label, "state": state} for label, state in sorted(set(foods))]
        one = len(keys) == 1 and not asked
        (row,) = self._ask(BEHIND_ONE, node=keys[0]) if one else self._ask(BEHIND, nodes=keys, foods=asked)
        if most is not None and len(row.keys) > most:
            raise TooManyUnitsError(most)
        return self._units(sorted(row.keys))

    def _units(self, keys: Sequence[str]) -> tuple[KnownUnit, ...]:
        units = self._edition.units
        missing = [key for key in keys if key not in units]
        for start in range(0, len(missing), UNITS_AT_ONCE):
            (row,) = self._ask(KNOWN_UNITS, keys=missing[start : start + UNITS_AT_ONCE])
            units.update((known.unit.key, known) for known in known_units(row))
            self._keep_rows({name for node in row.nodes for name in (node[2], *node[4])}, row.foods)
        return tuple(units[key] for key in keys if key in units)  # one that went meanwhile is not behind it any more

    def equivalents(self, names: Sequence[str], *, limit: int = 5) -> tuple[tuple[Neighbour, ...], ...]:
        """Return, for each of ``names``, the ``limit`` known foods that can best stand for it; by the vector index.

        Where the graph was written with other word lists than this program's, its foods are compared in memory.
        """
        found = find_equivalents(lambda asked: self._ask(EQUIVALENTS, **asked), dict.fromkeys(names), limit)
        if found is None:
            return nearest_of_each(food_similarity(), names, self.vocabulary().labels, limit)
        return tuple(found[name] for name in names)

    def called(self, labels: Collection[str]) -> tuple[ObjectNode, ...]:
        """Return every object node with one of ``labels``, sorted."""
        (row,) = self._ask(NODES_CALLED, labels=sorted(set(labels)))
        return tuple(sorted(map(node_of, row.nodes), key=lambda node: node.sort_key))

    @property
    def is_learnt_by_this_program(self) -> bool:
        """Whether what the graph teaches was learnt as this program learns, so that it can be asked for in parts."""
        return self._learnt_by == methods_key()

    def methods(self) -> Methods:
        """Return what this FOON teaches. Where another program learnt it, it is learnt anew, in memory."""
        if self._edition.methods is None:
            self._edition.methods = self._read_methods()
        return self._edition.methods

    def methods_for(self, foods: Collection[str], dish_type: str) -> Methods:
        """Return what this FOON teaches of making a dish of ``foods``.

        That are the operators done to ``foods``, to those like one of them at all, or to their kinds.
        """
        del dish_type
        if not self.is_learnt_by_this_program or not all(map(words, foods)):
            return self.methods()
        matters = self._edition.matters.for_foods(
            {singular(food) for food in (*foods, *self._kitchen.free_foods)},
            lambda asked: self._ask(METHODS_ASKED, **asked),
        )
        if matters is None:
            return self.methods()
        if self._edition.common is None:
            self._edition.common = CommonMethods(*self._ask_once(METHODS_COMMON))
        if self._edition.dishes is None:
            self._edition.dishes = LearntDishes(*self._ask_once(FRAMES))
        return self._edition.common.methods_with(matters, self._edition.dishes, self._read_frames)

    def _read_frames(self, keys: Sequence[str]) -> list[FrameReadValue]:
        (row,) = self._ask(FRAMES_READ, keys=sorted(keys))
        return row.frames

    def _read_methods(self) -> Methods:
        if not self.is_learnt_by_this_program:
            names = self.video_names()
            if len(names) > MOST_LEARNT_ANEW:
                raise SchemaError(
                    "the operators and frames of the graph were learnt by another foon-kg",
                    hint="Load any FOON, even one that is there already: foon load foon PATH learns them anew.",
                )
            from foon_kg.store.snapshot import Snapshot  # noqa: PLC0415 - slow to import, and few views learn anything

            return Snapshot.of(self.subgraphs(names), self._kitchen).methods()
        (row,) = self._ask_once(METHODS)
        return methods_of(row, self.goals())

    def motion_costs(self) -> MotionCosts:
        """Return the weights of motions that were loaded, none where there are none."""
        (row,) = self._ask(MOTION_COSTS)
        return MotionCosts(dict(zip(row.motions, row.costs, strict=True)))

    @property
    def edition(self) -> str | None:
        """The name of the edition that this view reads; ``None`` where the graph does not tell editions apart."""
        return self._edition.name

    @property
    def sureness(self) -> Mapping[str, float]:
        """Nothing: what drafts teach is asked for apart (:meth:`lessons`)."""
        return {}

    @property
    def memory(self) -> GraphView:
        """The graph itself keeps reference trees."""
        return self

    def remembered(self, question: str) -> RetrievedTree | None:
        """Return the reference tree that is kept for ``question``."""
        for row in self._ask(REMEMBERED, question=question):
            return RetrievedTree(row.question, row.grounds, row.goal, tuple(row.units), tuple(row.gaps))
        return None

    def remember(self, tree: RetrievedTree) -> None:
        """Have ``tree`` kept when the view is closed."""
        self.retrieved.append(tree)

    def video_names(self) -> tuple[str, ...]:
        """Return the names of all videos, sorted."""
        return tuple(sorted(row.name for row in self._ask(VIDEO_NAMES)))

    def subgraphs(self, names: Collection[str]) -> tuple[Subgraph, ...]:
        """Return those of the named videos that the graph has, sorted by name, with all that was loaded."""
        rows = self._ask(SUBGRAPHS, names=sorted(set(names)))
        return tuple(sorted(map(subgraph_of, rows), key=lambda subgraph: subgraph.name))

    def lessons(self, most: int = MOST_OF_A_DISH_TYPE) -> tuple[Lesson, ...]:
        """Return what the ``most`` surest drafts of each dish type teach, sorted by name."""
        from foon_kg.loaders.lessons import lessons_of  # noqa: PLC0415 - the readers of all files, for few who ask

        rows = self._ask(SURE_DRAFTS, dish_types=list(DISH_TYPES), most=most)
        return lessons_of(
            DraftedRecipe(row.id, row.title, row.dish_type, row.table, row.units, row.left_out, row.confidence)
            for row in rows
        )

    def begin(self, kitchen: Kitchen, known: Edition) -> Edition:
        """Return which edition this view of a ``kitchen`` reads: ``known``, or a new one.

        Raises SchemaError or GraphError unless the graph is a FOON that this program can read.
        """
        state = next(iter(self._ask(SCHEMA_STATE)), None)
        check_readable(state, kitchen)
        self._kitchen, self._learnt_by = kitchen, state.methods if state else None
        self._edition = known.still(state.edition if state else None)
        return self._edition

    def moved(self) -> bool:
        """Return whether somebody wrote since the view began; then it begins anew, as :meth:`begin` does.

        Neo4j shows a transaction what others commit meanwhile. Where nothing but the edition was asked nothing moved.
        """
        state = next(iter(self._ask(SCHEMA_STATE)), None) if self.round_trips > 1 else None
        if state is None or state.edition == self._edition.name:
            return False
        self.begin(self._kitchen, self._edition)  # who wrote may be another foon-kg, or have another kitchen
        self.retrieved.clear()
        self._fetched.clear()
        return True

    def keep(self) -> None:
        """Keep on disk what was fetched for good, where the graph is still of the edition with which this view began.

        A write between two questions would have been seen by the second: what was fetched is then of no edition.
        """
        state = next(iter(self._ask(SCHEMA_STATE)), None) if self._fetched else None
        if state and state.edition and state.edition == self._edition.name:
            for statement, parameters, rows in self._fetched:
                KeptRows(state.edition).write(statement, parameters, rows)
        self._fetched.clear()

    def ask(self, statement: Statement[R], **parameters: object) -> list[R]:
        """Return the rows of a ``statement`` that reads, in one round trip."""
        return self._ask(statement, **parameters)

    def units_of(self, keys: Sequence[str]) -> tuple[KnownUnit, ...]:
        """Return the units with these ``keys`` that are there, in their order."""
        return self._units(keys)

    def _ask_once(self, statement: Statement[R], **parameters: object) -> list[R]:
        """Return what no program of this user asks twice of one edition."""
        if self._edition.name is None:
            return self._ask(statement, **parameters)
        rows = KeptRows(self._edition.name).read(statement, parameters)
        if rows is None:
            rows = self._ask(statement, **parameters)
            self._fetched.append((statement, parameters, rows))
        return rows

    def _ask(self, statement: Statement[R], **parameters: object) -> list[R]:
        self.round_trips += 1
        return ask(self._transaction, statement, **parameters)
