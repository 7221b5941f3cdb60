"""The reference tree of a goal for a recipe (algorithm 3): the best one found in the time there is.

It is exact where the search came to its end; only such a tree is kept.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from foon_kg.model import Goal, KnownUnit, ObjectNode
from foon_kg.model.knowledge import KnowledgeView, Vocabulary
from foon_kg.model.recent import Recent
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.result import ReferenceSummary
from foon_kg.search import Explored, ReferenceTree, SearchProblem, UnitIndex, retrieve_once
from foon_kg.search.gaps import ABSENT, gap_cost, mixtures

_NO_WORDS = Vocabulary((), (), ())
MOST_TREES = 4096
"""How many reference trees are kept."""


_Asked = tuple[ObjectNode, tuple[tuple[str, int], ...]]
"""A goal, and which labels stand for which required ingredient."""


class References:
    """Reference trees from one view, by the kitchen and the time limit of ``settings``.

    ``units`` are all of the FOON, numbered once for many recipes; without them the view is asked for those behind each
    goal.
    """

    def __init__(self, view: KnowledgeView, settings: PlanSettings, units: Sequence[KnownUnit] | None) -> None:
        self.view = view
        self.settings = settings
        self.units = units
        self._explored = Explored()
        self._index: UnitIndex | None = None
        self._kept: Recent[_Asked, ReferenceTree] = Recent(MOST_TREES)
        self._last: tuple[_Asked, ReferenceTree] | None = None

    def tree(self, goal: Goal, wanted: Mapping[str, int]) -> ReferenceTree:
        """Return the best tree of ``goal`` that is found in time, ``exact`` where there is no better one.

        ``wanted`` maps labels of foods to the number (from 0) of the required ingredient for which each stands; several
        may stand for one. Raises what the view raises.
        """
        key = self._key(goal, wanted)
        found = self._kept.find(key)
        if found is None:
            problem = self.problem(goal, wanted)
            # what was explored holds numbers of one index, and without all units each goal has an index of its own
            explored = self._explored if self.units is not None else Explored()
            found = retrieve_once(problem, self.view.memory, time_limit=self.settings.time_limit, explored=explored)
            if found.exact:  # one that time cut short may be better the next time
                self._kept[key] = found
        self._last = key, found
        return found

    @staticmethod
    def _key(goal: Goal, wanted: Mapping[str, int]) -> _Asked:
        return goal.node, tuple(sorted(wanted.items()))

    def searched(self, goal: Goal, wanted: Mapping[str, int]) -> ReferenceTree:
        """Return what :meth:`tree` found last for this ``goal`` and ``wanted``, be it cut short by time; else ask it.

        So of one answer no tree is searched twice, and all that is told of its reference is of one tree.
        """
        asked, found = self._last if self._last is not None else (None, None)
        return found if found is not None and asked == self._key(goal, wanted) else self.tree(goal, wanted)

    def problem(self, goal: Goal, wanted: Mapping[str, int]) -> SearchProblem:
        """Return what :meth:`tree` asks of the search: ``goal`` with the foods ``wanted`` there."""
        return SearchProblem(self._index_for(goal), (goal.node,), wanted=dict(wanted))

    def summary(
        self, goal: Goal, wanted: Mapping[str, int], videos: tuple[str, ...], core: tuple[str, ...]
    ) -> ReferenceSummary:
        """Return the reference tree of ``goal`` for the ``wanted`` foods in figures.

        ``videos`` and ``core`` are the videos that it is made after and the foods that the final tree takes over. It is
        as sure as the least sure draft among these videos; ``None`` where none of them is a draft.
        """
        tree = self.tree(goal, wanted)
        sure = [self.view.sureness[video] for video in videos if video in self.view.sureness]
        return ReferenceSummary(
            goal.node, len(tree.units), tree.overlap, tree.exact, videos, core, min(sure) if sure else None
        )

    def _index_for(self, goal: Goal) -> UnitIndex:
        if self.units is None:
            return self._numbered(self.view.behind([goal.node]))
        if self._index is None:
            self._index = self._numbered(self.units)
        return self._index

    def _numbered(self, units: Sequence[KnownUnit]) -> UnitIndex:
        # a food that is missing may be substituted yet: what is really there is asked of the final tree
        kitchen = self.settings.kitchen.with_every_food()
        cost = gap_cost(kitchen, units, mixtures(kitchen, self.view.words_in(units, _NO_WORDS), units))
        return UnitIndex.of(
            units,
            at_hand=kitchen.has,
            gap_cost=lambda node: ABSENT if kitchen.lacks(node) else cost(node),
        )
