"""The exact reference tree of a goal for a recipe (algorithm 3), as the search finds it, and kept once it was found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from foon_kg.model import Goal, KnownUnit, ObjectNode
from foon_kg.model.knowledge import KnowledgeView, Vocabulary
from foon_kg.model.recent import Recent
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.result import ReferenceSummary
from foon_kg.search import Explored, ReferenceTree, SearchProblem, UnitIndex, retrieve_once
from foon_kg.search.gaps import ABSENT, gap_cost, mixtures

_NONE = Vocabulary((), (), ())
MOST_TREES = 4096
"""How many reference trees are kept."""


class References:
    """Reference trees from one view; ``units``, all of the FOON, are numbered once for many recipes."""

    def __init__(self, view: KnowledgeView, settings: PlanSettings, units: Sequence[KnownUnit] | None) -> None:
        self.view = view
        self.settings = settings
        self.units = units
        self._explored = Explored()
        self._index: UnitIndex | None = None
        self._kept: Recent[tuple[ObjectNode, tuple[tuple[str, int], ...]], ReferenceTree] = Recent(MOST_TREES)

    def tree(self, goal: Goal, wanted: Mapping[str, int]) -> ReferenceTree:
        """Return the best tree of ``goal``; ``wanted`` maps its ingredients to the foods for which they stand."""
        key = (goal.node, tuple(sorted(wanted.items())))
        found = self._kept.find(key)
        if found is None:
            problem = self.problem(goal, wanted)
            explored = self._explored if self.units is not None else Explored()
            found = self._kept[key] = retrieve_once(
                problem, self.view.memory, time_limit=self.settings.time_limit, explored=explored
            )
        return found

    def problem(self, goal: Goal, wanted: Mapping[str, int]) -> SearchProblem:
        """Return what is asked of the search where :meth:`tree` is: ``goal`` with the ``wanted`` foods.

        Each food has its weight.
        """
        return SearchProblem(self._index_for(goal), (goal.node,), wanted=dict(wanted))

    def summary(
        self, goal: Goal, wanted: Mapping[str, int], videos: tuple[str, ...], core: tuple[str, ...]
    ) -> ReferenceSummary:
        """Return the reference tree of ``goal`` for the ``wanted`` foods in figures.

        ``videos`` and ``core`` are the videos that it is made after and the foods that the final tree takes over.
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
        kitchen = self.settings.kitchen.with_every_food()  # foods of a reference are exchanged: the final tree is asked
        cost = gap_cost(kitchen, units, mixtures(kitchen, self.view.words_in(units, _NONE), units))
        return UnitIndex.of(
            units,
            at_hand=kitchen.has,
            gap_cost=lambda node: ABSENT if kitchen.lacks(node) else cost(node),
        )
