"""A whole FOON in memory: the same answers as Neo4j, without a database."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from foon_kg.food import singular, tables
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.integration.methods import Methods
from foon_kg.integration.teaching.derivation import frames_of
from foon_kg.integration.teaching.frames import Frame
from foon_kg.integration.teaching.operators import Operators
from foon_kg.model import FunctionalUnit, Goal, KnownUnit, ObjectNode, Participant, Sighting, Subgraph, sightings_of
from foon_kg.model.knowledge import KnowledgeView, LikelyGoals, Neighbour, Vocabulary
from foon_kg.model.nodes import distinct_by_name
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import food_similarity
from foon_kg.similarity.confidences import nearest_of_each
from foon_kg.store.vocabulary import FoodState, WordCounts, food_states


@dataclass(frozen=True)
class Snapshot:
    """The union of some subgraphs, each distinct unit once, with indexes for the planner's questions.

    Implements both :class:`~foon_kg.model.knowledge.KnowledgeGraph` and the view that it opens, as nothing in it ever
    changes. Make one with :meth:`of`. ``subgraphs`` are sorted by name, ``units`` by key.
    """

    subgraphs: tuple[Subgraph, ...]
    units: tuple[KnownUnit, ...]
    kitchen: Kitchen

    @classmethod
    def of(cls, subgraphs: Iterable[Subgraph], kitchen: Kitchen) -> Snapshot:
        """Return the FOON of ``subgraphs`` in a ``kitchen``; they may come in any order and more than once.

        Raises :class:`~foon_kg.model.errors.ReadError` when two that differ have one name.
        """
        distinct = distinct_by_name(subgraphs)
        return cls(distinct, tuple(_known_units(distinct)), kitchen)

    def without(self, name: str) -> Snapshot:
        """Return this FOON without the video ``name``; what the others teach is followed once, whichever is left out.

        >>> whole = Snapshot.of([Subgraph("salad", ()), Subgraph("soup", ())], Kitchen.default())
        >>> [video.name for video in whole.without("soup").subgraphs]
        ['salad']
        """
        rest = Snapshot.of((one for one in self.subgraphs if one.name != name), self.kitchen)
        frames = tuple(frame for frame in self.methods().frames if frame.video != name)
        vars(rest)["_methods"] = _taught(rest, frames)
        return rest

    def reading(self) -> AbstractContextManager[KnowledgeView]:
        """Open a view: the snapshot itself."""
        return nullcontext(self)

    @property
    def sureness(self) -> Mapping[str, float]:
        """Nothing: all of it are videos."""
        return {}

    @property
    def memory(self) -> None:
        """A snapshot keeps no reference trees: it is gone with the program that has it."""
        return

    def moved(self) -> bool:
        """Return that it stays as it is."""
        return False

    def vocabulary(self) -> Vocabulary:
        """Return the words that the FOON knows."""
        return self._vocabulary

    def goals(self, dish_type: str | None = None) -> tuple[Goal, ...]:
        """Return the goals of ``dish_type`` (of every type for ``None``), sorted by node and type."""
        return tuple(goal for goal in self._goals if dish_type in (None, goal.dish_type))

    def words_for(self, foods: Sequence[str], called: Sequence[str] = ()) -> Vocabulary:
        """Return the whole vocabulary, whatever ``foods`` are asked or ``called``: it is here."""
        del foods, called
        return self._vocabulary

    def words_in(self, units: Sequence[KnownUnit], words: Vocabulary) -> Vocabulary:
        """Return the whole vocabulary, with whatever ``units`` and ``words``: it is here."""
        del units, words
        return self._vocabulary

    def words_named(self, names: Collection[str]) -> Vocabulary:
        """Return the whole vocabulary, with whatever ``names``: it is here."""
        del names
        return self._vocabulary

    def likely_goals(self, dish_type: str | None, foods: Sequence[str], count: int) -> LikelyGoals:
        """Return all goals of ``dish_type``, whatever ``foods`` and ``count``: they are here."""
        del foods, count
        return LikelyGoals(self.goals(dish_type), self._known_foods)

    def behind(
        self, nodes: Collection[ObjectNode], foods: Collection[FoodState] = (), *, most: int | None = None
    ) -> tuple[KnownUnit, ...]:
        """Return every unit, however many at ``most``, that may help to make ``nodes`` or ``foods``.

        Linear in the answer.
        """
        del most  # all are here
        asked = {*nodes, *(node for food in foods for node in self._outputs_by_food.get(food, ()))}
        waiting, seen, found = list(asked), set(asked), dict[str, KnownUnit]()
        while waiting:
            for known in self._producers.get(waiting.pop(), ()):
                if known.unit.key in found:
                    continue
                found[known.unit.key] = known
                for node in known.unit.input_nodes:
                    if node not in seen and not self.kitchen.has(node):
                        seen.add(node)
                        waiting.append(node)
        return tuple(found[key] for key in sorted(found))

    def equivalents(self, names: Sequence[str], *, limit: int = 5) -> tuple[tuple[Neighbour, ...], ...]:
        """Return, for each of ``names``, the ``limit`` known foods that can best stand for it."""
        return nearest_of_each(food_similarity(), names, self.vocabulary().labels, limit)

    def called(self, labels: Collection[str]) -> tuple[ObjectNode, ...]:
        """Return every object node with one of ``labels``, sorted."""
        found = (node for label in set(labels) for node in self._nodes_by_label.get(label, ()))
        return tuple(sorted(found, key=lambda node: node.sort_key))

    def methods(self) -> Methods:
        """Return what this FOON teaches: operators and frames."""
        return self._methods

    @cached_property
    def _methods(self) -> Methods:
        frames = chain.from_iterable(frames_in(subgraph, self.kitchen) for subgraph in self.subgraphs)
        return _taught(self, tuple(frames))

    def methods_for(self, foods: Collection[str], dish_type: str) -> Methods:
        """Return all that this FOON teaches, whatever ``foods`` and ``dish_type``: it is here."""
        del foods, dish_type
        return self._methods

    def motion_costs(self) -> MotionCosts:
        """Return no weights of motions: FOON files have none."""
        return MotionCosts()

    @cached_property
    def _nodes_by_label(self) -> Mapping[str, set[ObjectNode]]:
        nodes: defaultdict[str, set[ObjectNode]] = defaultdict(set)
        for known in self.units:
            for node in (*known.unit.input_nodes, *known.unit.output_nodes):
                nodes[node.label].add(node)
        return dict(nodes)

    @cached_property
    def _vocabulary(self) -> Vocabulary:
        counts = WordCounts(self.kitchen.is_utensil)
        counts.count(known.unit for known in self.units)
        dish_types = {goal.dish_type for goal in self._goals}
        return Vocabulary(
            tuple(counts.seen_as()),
            tuple(counts.made_by()),
            tuple(sorted(dish_types)),
            gatherings=tuple(counts.gatherings()),
        )

    @cached_property
    def _known_foods(self) -> frozenset[str]:
        return frozenset(map(singular, self._vocabulary.rows_of))

    @cached_property
    def _goals(self) -> tuple[Goal, ...]:
        videos: defaultdict[tuple[ObjectNode, str], set[str]] = defaultdict(set)
        for subgraph in self.subgraphs:
            for goal in goals_of(subgraph, self.kitchen):
                videos[goal].add(subgraph.name)
        found = (Goal(node, dish, node.ingredients, tuple(sorted(names))) for (node, dish), names in videos.items())
        return tuple(sorted(found, key=lambda goal: (goal.node.sort_key, goal.dish_type)))

    @cached_property
    def _producers(self) -> Mapping[ObjectNode, list[KnownUnit]]:
        producers: defaultdict[ObjectNode, list[KnownUnit]] = defaultdict(list)
        for known in self.units:
            for node in known.unit.output_nodes:
                producers[node].append(known)
        return dict(producers)

    @cached_property
    def _outputs_by_food(self) -> Mapping[FoodState, list[ObjectNode]]:
        outputs: defaultdict[FoodState, list[ObjectNode]] = defaultdict(list)
        for node in self._producers:
            for food in food_states((node,), is_utensil=lambda _: False):
                outputs[food].append(node)
        return dict(outputs)


def _taught(foon: Snapshot, frames: tuple[Frame, ...]) -> Methods:
    """Return what the units of a ``foon`` teach, and the ``frames`` of its videos."""
    return Methods(Operators(map(in_plain_order, foon.units), tables()), frames, foon.goals())


def goals_of(subgraph: Subgraph, kitchen: Kitchen) -> tuple[tuple[ObjectNode, str], ...]:
    """Return the (node, dish type) of each goal of ``subgraph``, sorted: outputs marked with a dish class.

    A utensil of the ``kitchen`` that is marked too (the glass beside the juice) is a vessel of the dish and no goal.
    """
    outputs = (p for annotation in subgraph.annotations for p in annotation.unit.outputs)
    marked = {(p.node, p.dish_type) for p in outputs if p.dish_type and not kitchen.is_utensil(p.node.label)}
    return tuple(sorted(marked, key=lambda goal: (goal[0].sort_key, goal[1])))


def frames_in(subgraph: Subgraph, kitchen: Kitchen) -> tuple[Frame, ...]:
    """Return how ``subgraph`` makes each of its goals in ``kitchen``, sorted: this depends on no other video."""
    units = [annotation.unit for annotation in subgraph.annotations]
    return frames_of(units, goals_of(subgraph, kitchen), subgraph.name, tables())


def in_plain_order(known: KnownUnit) -> KnownUnit:
    """Return a ``known`` unit with its nodes sorted: what it teaches must not depend on which video wrote it first."""
    written = known.unit
    unit = FunctionalUnit(
        _sorted(written.input_nodes), written.motion, _sorted(written.output_nodes), written.accepts_any
    )
    vars(unit)["key"] = written.key  # which does not depend on the order, and takes long to hash
    return KnownUnit(unit, known.seen_in)


def _sorted(nodes: Iterable[ObjectNode]) -> tuple[Participant, ...]:
    return tuple(Participant(node) for node in sorted(nodes, key=lambda node: node.sort_key))


def _known_units(subgraphs: Iterable[Subgraph]) -> Iterator[KnownUnit]:
    """Merge equal units; each is written as its first sighting has it. ``subgraphs`` are sorted by name."""
    first: dict[str, FunctionalUnit] = {}
    places: defaultdict[str, list[Sighting]] = defaultdict(list)
    for subgraph in subgraphs:
        for unit, sighting in sightings_of(subgraph):
            first.setdefault(unit.key, unit)
            places[unit.key].append(sighting)
    for key in sorted(first):
        yield KnownUnit(first[key], tuple(places[key]))
