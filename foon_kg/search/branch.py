"""Branch and bound over "which producer for the next needed node", with proof."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable
from dataclasses import dataclass, field

from foon_kg.model.values import made_often
from foon_kg.search.core import bits_of
from foon_kg.search.cuts import cut_bound
from foon_kg.search.deadline import Deadline
from foon_kg.search.partial import Partial
from foon_kg.search.problem import Bound, weakest
from foon_kg.search.reduction import Reduced, Value, value_of

Options = dict[int, list[int]]
"""The steps that may be chosen for each waiting node; empty where the tree is given up."""

_CLOCK_EVERY = 16  # trees are tried between two looks at the clock


class BranchAndBound(ABC):
    """The search itself, depth first: which partial tree is tried next. What makes a tree better is for its children.

    ``untried`` are the partial trees that are still to be tried, the next one last.
    """

    reduced: Reduced
    deadline: Deadline
    untried: list[Partial]

    def run(self, patience: int | None = None) -> bool:
        """Search until the best is proven (True), or ``patience`` trees were tried or the deadline passed (False)."""
        choice, core = self.reduced.choice, self.reduced.core
        tried = 0
        while self.untried and not self.is_proven():
            if tried == patience or (tried % _CLOCK_EVERY == 0 and self.deadline.has_passed()):
                return False
            tried += 1
            partial = choice.forced(self.untried.pop())
            if partial is None:
                continue
            if not partial.waiting:
                self.offer(partial.chosen)
                continue
            outlook = Outlook.of(self.reduced, partial)
            options = self.options(partial, outlook)
            if options:
                node = min(options, key=lambda waiting: (len(options[waiting]), waiting))
                ordered = sorted(options[node], key=lambda step: self.promise(step, outlook), reverse=True)
                self.untried += [partial.take(core, node, step) for step in ordered]
        return True

    @abstractmethod
    def is_proven(self) -> bool:
        """Whether nothing can be better than the best so far."""

    @abstractmethod
    def options(self, partial: Partial, outlook: Outlook) -> Options:
        """Return what may be chosen for the nodes that wait in ``partial``; nothing where the branch is cut.

        It is cut where no tree that grows from here is better than the best so far; ``outlook`` is what is known of
        these trees.
        """

    @abstractmethod
    def offer(self, steps: int) -> None:
        """Take the tree of ``steps``, one bit a step, as the best where it is better than the best so far."""

    @abstractmethod
    def promise(self, step: int, outlook: Outlook) -> tuple[int, ...]:
        """Return how a choice of ``step`` (by number) is ranked in a tree of that ``outlook``, the least first."""


@dataclass(eq=False)
class Search(BranchAndBound):
    """A search for a reference tree: the ``best`` one so far (no steps: none of least penalty yet)."""

    reduced: Reduced
    best: int
    deadline: Deadline
    untried: list[Partial] = field(default_factory=list)

    def __post_init__(self) -> None:
        found = value_of(self.reduced.core, self.best)
        is_tree = self.best and found[0] == self.reduced.penalty
        self.value: Value = found if is_tree else (self.reduced.penalty + 1, 1, 0, 0)
        self.untried.append(self.reduced.choice.start())

    def bound(self) -> Bound:
        """Return what no tree can be better than: the best found, or anything still to be tried."""
        bounds = [Bound(self.reduced.penalty, -self.value[1], self.value[2])]
        for partial in self.untried:
            outlook = Outlook.of(self.reduced, partial)
            units = self.reduced.core.units_in(outlook.needed)
            bounds.append(Bound(self.reduced.penalty, outlook.reach.bit_count(), units))
        return weakest(bounds)

    def affordable(self, partial: Partial, outlook: Outlook) -> Options:
        """Return what may be chosen for the nodes that wait in ``partial`` without more than the least penalty.

        ``outlook`` is what is known of all trees that grow from here.
        """
        spare = self.reduced.penalty - outlook.penalty
        if spare < 0:
            return {}
        options = {node: self.reduced.choice.options(partial, node) for node in partial.waiting}
        if self.reduced.gaps_are_settled:
            return options
        return self._within(spare, self.reduced.gap_weights(outlook.needed), partial, options)

    def _within(self, spare: int, weights: list[int], partial: Partial, options: Options) -> Options:
        """Leave out of ``options`` what no tree can have that weighs at most ``spare``."""
        decided = bits_of(partial.decided)
        cuts = cut_bound(self.reduced.web, weights, partial.waiting, decided, limit=spare)
        if cuts is None:
            return {}
        core = self.reduced.core
        return {
            node: [step for step in steps if cuts.least_with(core, step) <= spare] for node, steps in options.items()
        }

    def offer(self, steps: int) -> None:
        """Take the tree of ``steps`` where it is of least penalty and better than the best so far."""
        value = value_of(self.reduced.core, steps)
        if value[0] == self.reduced.penalty and value < self.value:
            self.best, self.value = steps, value

    def promise(self, step: int, outlook: Outlook) -> tuple[int, int, int, int]:
        """Return what ``step`` adds to the ``outlook``: gaps, wanted foods, units; ties go to the least key."""
        core = self.reduced.core
        extra = self.reduced.landmarks.steps_of_step[step] & ~outlook.needed
        gain = (core.foods_of(extra) & ~outlook.foods).bit_count()
        return core.penalty_of(extra), -gain, core.units_in(extra), -step


@made_often()
class Outlook:
    """What is known of all trees that grow from a partial one.

    They have all steps in ``needed`` (those chosen among them) and so at least that ``penalty`` and these ``foods``;
    they may have the steps ``behind`` and the foods ``reach``. ``around`` are the nodes that can still matter.
    """

    needed: int
    penalty: int
    foods: int
    behind: int
    reach: int
    around: int

    @classmethod
    def of(cls, reduced: Reduced, partial: Partial) -> Outlook:
        """Return what is known of all trees of ``reduced`` that grow from ``partial``, by what still waits in it."""
        needed, behind, reach, around = partial.chosen, 0, 0, 0
        for node in partial.waiting:
            needed |= reduced.landmarks.steps_of_node[node]
            behind |= reduced.behind[node]
            reach |= reduced.foods[node]
            around |= reduced.around[node]
        foods = reduced.core.foods_of(needed)
        return cls(needed, reduced.core.penalty_of(needed), foods, behind, reach | foods, around)

    def same_future(self, partial: Partial) -> tuple[Hashable, ...]:
        """Return a key: trees that are partial in different ways but have the same key can grow in the same ways."""
        above = frozenset((node, above & self.around) for node, above in partial.waiting.items())
        return (above, partial.decided & self.around, partial.chosen & self.behind)


@dataclass(eq=False)
class OverlapSearch(Search):
    """The greatest overlap among the trees of least penalty, at whatever length."""

    seen: dict[Hashable, list[int]] = field(default_factory=dict)

    def is_proven(self) -> bool:
        """Whether the best has every wanted food that any tree of least penalty could have."""
        return -self.value[1] == self.reduced.foods[self.reduced.core.goal].bit_count()

    def options(self, partial: Partial, outlook: Outlook) -> Options:
        """Return the options of ``partial``; none where it can gain no wanted food, or its like has them all.

        Its like is another partial tree with the same future. ``outlook`` says which foods the trees that grow from
        here can still gain.
        """
        if outlook.reach.bit_count() <= -self.value[1]:
            return {}
        penalty, foods = self.reduced.core.penalty_of(partial.chosen), self.reduced.core.foods_of(partial.chosen)
        before = self.seen.setdefault((penalty, *outlook.same_future(partial)), [])
        if any(foods & ~others == 0 for others in before):
            return {}
        before.append(foods)
        return self.affordable(partial, outlook)


@dataclass(eq=False)
class UnitSearch(Search):
    """The fewest units among the trees of least penalty and greatest overlap, then the least keys."""

    seen: dict[Hashable, tuple[int, int]] = field(default_factory=dict)

    @classmethod
    def from_tree(cls, reduced: Reduced, best: int, deadline: Deadline) -> UnitSearch:
        """Return a search in what is left of ``reduced`` if no tree may have more units than ``best``, a set of steps.

        ``deadline`` ends it.
        """
        less = reduced.without_longer_than(reduced.core.units_in(best))
        return cls(less, reduced.core.translated(best, less.core), deadline)

    def is_proven(self) -> bool:
        """Whether the best is known to be so before everything is tried: never, for the sake of the least keys."""
        return False

    def options(self, partial: Partial, outlook: Outlook) -> Options:
        """Return the options of ``partial``; none where a tree is known that is not worse than all that grow from it.

        ``outlook`` says how many units those trees have at least.
        """
        if self._is_worse(outlook) or self._seen_better(partial, outlook):
            return {}
        options = self.affordable(partial, outlook)
        spare = self.value[2] - self.reduced.core.units_in(outlook.needed)
        return options and self._within(spare, self.reduced.unit_weights(outlook.needed), partial, options)

    def _is_worse(self, outlook: Outlook) -> bool:
        penalty, overlap, units, steps = self.value
        fewest = self.reduced.core.units_in(outlook.needed)
        if outlook.reach.bit_count() < -overlap or fewest > units:
            return True
        # as many units, and no gap that could still come: what is needed is the whole tree
        return fewest == units and outlook.penalty == penalty and -outlook.needed >= steps

    def _seen_better(self, partial: Partial, outlook: Outlook) -> bool:
        core = self.reduced.core
        key = (core.penalty_of(partial.chosen), core.foods_of(partial.chosen), *outlook.same_future(partial))
        value = (core.units_in(partial.chosen), -partial.chosen)
        before = self.seen.get(key)
        if before is not None and before <= value:
            return True
        self.seen[key] = value
        return False
