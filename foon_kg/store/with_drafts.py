"""A FOON in memory with what drafts of recipes teach, for whoever asks to plan with them.

Taken from drafts are whole dishes: goals, the units that lead to them, and the frames after which recipes are made. How
each step is done, with which tools and to which foods, is what the annotated videos say, wherever they say anything
(:mod:`foon_kg.integration.teaching.drafted_operators`); and so are the words by which foods are known.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.food import tables
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.integration.methods import Methods
from foon_kg.integration.teaching.drafted_operators import DraftedOperators
from foon_kg.integration.teaching.frames import Frame
from foon_kg.loaders.lessons import subgraphs_of
from foon_kg.model import Goal, KnownUnit, ObjectNode, Sighting
from foon_kg.model.drafted import Lesson
from foon_kg.model.knowledge import KnowledgeView, LikelyGoals, Neighbour, Vocabulary
from foon_kg.store.snapshot import Snapshot, in_plain_order
from foon_kg.store.vocabulary import FoodState


@dataclass(frozen=True)
class WithDrafts:
    """The FOON ``videos`` with its ``drafts``; implements :class:`~foon_kg.model.knowledge.KnowledgeView`.

    Make one with :meth:`of`. In ``units`` and goals videos come before drafts.
    """

    videos: Snapshot
    drafts: Snapshot
    both: Snapshot
    sureness: Mapping[str, float]

    @classmethod
    def of(cls, videos: Snapshot, lessons: Iterable[Lesson]) -> WithDrafts:
        """Put ``lessons`` beside ``videos``."""
        lessons = tuple(lessons)
        drafts = Snapshot.of(subgraphs_of(lessons), videos.kitchen)
        both = Snapshot((*videos.subgraphs, *drafts.subgraphs), _merged(videos.units, drafts.units), videos.kitchen)
        return cls(videos, drafts, both, {one.subgraph.name: one.confidence for one in lessons})

    @property
    def units(self) -> tuple[KnownUnit, ...]:
        """All units, sorted by key."""
        return self.both.units

    def reading(self) -> AbstractContextManager[KnowledgeView]:
        """Open a view: this one."""
        return nullcontext(self)

    @property
    def memory(self) -> None:
        """It keeps no reference trees."""
        return

    def moved(self) -> bool:
        """Return that it stays as it is."""
        return False

    def vocabulary(self) -> Vocabulary:
        """Return the words of the videos; dish types that only drafts have are there too."""
        return self._vocabulary

    @cached_property
    def _vocabulary(self) -> Vocabulary:
        types = {goal.dish_type for goal in self.goals()}
        return replace(self.videos.vocabulary(), dish_types=tuple(sorted(types)))

    def words_for(self, foods: Sequence[str], called: Sequence[str] = ()) -> Vocabulary:
        """Return the whole vocabulary, whatever ``foods`` are asked or ``called``."""
        del foods, called
        return self._vocabulary

    def words_in(self, units: Sequence[KnownUnit], words: Vocabulary) -> Vocabulary:
        """Return the whole vocabulary, with the foods of drafts, whatever ``units`` and ``words``."""
        del units, words
        return self.both.vocabulary()

    def words_named(self, names: Collection[str]) -> Vocabulary:
        """Return the whole vocabulary, with the foods of drafts, whatever ``names``."""
        del names
        return self.both.vocabulary()

    def goals(self, dish_type: str | None = None) -> tuple[Goal, ...]:
        """Return the goals of ``dish_type`` (of every type for ``None``), sorted by node and type."""
        return self.both.goals(dish_type)

    def likely_goals(self, dish_type: str | None, foods: Sequence[str], count: int) -> LikelyGoals:
        """Return all goals of ``dish_type``, whatever ``foods`` and ``count``."""
        return self.both.likely_goals(dish_type, foods, count)

    def behind(
        self, nodes: Collection[ObjectNode], foods: Collection[FoodState] = (), *, most: int | None = None
    ) -> tuple[KnownUnit, ...]:
        """Return every unit, however many at ``most``, that may take part in making ``nodes`` or ``foods``."""
        return self.both.behind(nodes, foods, most=most)

    def methods(self) -> Methods:
        """Return the operators of the videos, and the frames of both."""
        return self._methods

    @cached_property
    def _methods(self) -> Methods:
        taught = self.videos.methods()
        frames = sorted((*taught.frames, *self.drafts.methods().frames), key=_in_order)
        videos, drafts = (map(in_plain_order, one.units) for one in (self.videos, self.drafts))
        operators = DraftedOperators(videos, drafts, tables())
        found = Methods(operators, tuple(frames), self.goals())
        if taught.frames:
            vars(found)["joining_counts"] = taught.joining_counts
        return found

    def methods_for(self, foods: Collection[str], dish_type: str) -> Methods:
        """Return all methods, whatever ``foods`` and ``dish_type``."""
        del foods, dish_type
        return self._methods

    def equivalents(self, names: Sequence[str], *, limit: int = 5) -> tuple[tuple[Neighbour, ...], ...]:
        """Return, for each of ``names``, at most ``limit`` foods of the videos that can best stand for it."""
        return self.videos.equivalents(names, limit=limit)

    def called(self, labels: Collection[str]) -> tuple[ObjectNode, ...]:
        """Return every object node with one of ``labels``, sorted."""
        return self.both.called(labels)

    def motion_costs(self) -> MotionCosts:
        """Return no weights of motions."""
        return MotionCosts()


def _in_order(frame: Frame) -> tuple[object, ...]:
    """Return the order of the frames of methods."""
    return frame.video, frame.goal.sort_key, frame.dish_type


def _merged(videos: Sequence[KnownUnit], drafts: Sequence[KnownUnit]) -> tuple[KnownUnit, ...]:
    """Return the units of both, each once; what videos show comes before what drafts say."""
    seen: defaultdict[str, list[Sighting]] = defaultdict(list)
    first: dict[str, KnownUnit] = {}
    for known in (*videos, *drafts):
        first.setdefault(known.unit.key, known)
        seen[known.unit.key] += known.seen_in
    return tuple(KnownUnit(first[key].unit, tuple(seen[key])) for key in sorted(first))
