"""The tree of least weight, proven, where each unit has a weight of its own: branch and bound, as for reference trees.

Cores, landmarks, choices and LM-cut are those of :mod:`foon_kg.search`. What differs is the objective: there every unit
counts one and gaps come first; here a step weighs what it weighs, a gap as well as a unit.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field
from typing import Self

from foon_kg.search.branch import BranchAndBound, Options, Outlook
from foon_kg.search.core import Core, bits_of
from foon_kg.search.cuts import cut_bound
from foon_kg.search.deadline import Deadline
from foon_kg.search.forward import chain, cheapest_first
from foon_kg.search.partial import Partial
from foon_kg.search.reduction import Reduced

_PATIENCE = 16

Weigh = Callable[[Core], Sequence[int]]
"""Returns the weight of every step of a core, 1 or more."""

Value = tuple[int, int]
"""(weight, minus the set of steps): the order between trees, the lesser the better."""


@dataclass(frozen=True)
class LeastWeight:
    """The lightest tree found as the set ``steps`` of ``core``; no tree weighs less than ``at_least``.

    ``proven`` says that no tree is better, the keys of equally light ones included.
    """

    core: Core
    steps: int
    weight: int
    at_least: int
    proven: bool


def least_weight(core: Core, weigh: Weigh, deadline: Deadline) -> LeastWeight | None:
    """Return the lightest tree that makes the goal of ``core``; of equally light ones that with the least keys.

    The keys are those of its units; ``weigh`` gives a set of steps its weight. ``None`` where nothing makes the goal. A
    search that the ``deadline`` stops returns the best tree found so far.
    """
    order, made = chain(core)
    if not made[core.goal]:
        return None
    first = cheapest_first(core)
    search = _Search.among(Reduced.of(core, sum(core.costs), order), first, core, weigh, deadline)
    patience = _PATIENCE
    while not search.run(patience):
        if deadline.has_passed():
            return LeastWeight(search.core, search.best, search.value[0], search.bound(), proven=False)
        patience *= 2
        if search.improved:  # a lighter tree rules more out: worth starting again with less
            search = _Search.among(search.reduced, search.best, search.core, weigh, deadline)
    return LeastWeight(search.core, search.best, search.value[0], search.value[0], proven=True)


@dataclass(eq=False)
class _Search(BranchAndBound):
    """One search: the ``best`` tree so far, and what is still to be tried."""

    reduced: Reduced
    weights: Sequence[int]
    best: int
    deadline: Deadline
    untried: list[Partial] = field(default_factory=list)
    seen: dict[Hashable, Value] = field(default_factory=dict)
    improved: bool = False

    @classmethod
    def among(cls, reduced: Reduced, best: int, of: Core, weigh: Weigh, deadline: Deadline) -> Self:
        """Return a search among what may be in a tree no heavier than ``best``, a set of the steps of ``of``."""
        weight = _weight_of(weigh(of), best)
        while True:
            weights = weigh(reduced.core)
            cuts = cut_bound(reduced.web, weights, [reduced.core.goal])
            if cuts is None:
                raise AssertionError("the best tree is never thrown out")
            kept = [s for s in range(reduced.core.step_count) if cuts.least_with(reduced.core, s) <= weight]
            if len(kept) == reduced.core.step_count:
                break
            reduced = Reduced.of(reduced.core, sum(reduced.core.costs), kept)
        start = [reduced.choice.start()]
        return cls(reduced, weights, of.translated(best, reduced.core), deadline, start)

    @property
    def core(self) -> Core:
        """What is searched."""
        return self.reduced.core

    @property
    def value(self) -> Value:
        """The place of the best tree in the order of trees."""
        return self._value_of(self.best)

    def bound(self) -> int:
        """Return what no tree can be lighter than: the best found, or anything still to be tried."""
        needed = (Outlook.of(self.reduced, partial).needed for partial in self.untried)
        return min([self.value[0], *(_weight_of(self.weights, steps) for steps in needed)])

    def is_proven(self) -> bool:
        """Return False: before everything is tried another tree may be as light and have lesser keys."""
        return False

    def options(self, partial: Partial, outlook: Outlook) -> Options:
        """Return what may be chosen for the nodes that wait in ``partial``; nothing where the best is no worse.

        ``outlook`` says what all trees that grow from here weigh at least.
        """
        spare = self.value[0] - _weight_of(self.weights, outlook.needed)
        if self._is_no_better(outlook, spare) or self._seen_better(partial, outlook):
            return {}
        left = list(self.weights)
        for step in bits_of(outlook.needed):
            left[step] = 0
        cuts = cut_bound(self.reduced.web, left, partial.waiting, bits_of(partial.decided))
        if cuts is None or cuts.bound > spare:
            return {}
        found = {node: self.reduced.choice.options(partial, node) for node in partial.waiting}
        return {node: [s for s in makers if cuts.least_with(self.core, s) <= spare] for node, makers in found.items()}

    def _is_no_better(self, outlook: Outlook, spare: int) -> bool:
        """Whether what is needed leaves no weight to ``spare``, or just none and has no lesser keys than the best."""
        return spare < 0 or (spare == 0 and -outlook.needed >= self.value[1])

    def _seen_better(self, partial: Partial, outlook: Outlook) -> bool:
        key, value = outlook.same_future(partial), self._value_of(partial.chosen)
        before = self.seen.get(key)
        if before is not None and before <= value:
            return True
        self.seen[key] = value
        return False

    def offer(self, steps: int) -> None:
        """Take the tree of ``steps`` where it is lighter than the best, or as light with lesser keys."""
        if self._value_of(steps) < self.value:
            self.improved = self.improved or _weight_of(self.weights, steps) < self.value[0]
            self.best = steps

    def _value_of(self, steps: int) -> Value:
        return (_weight_of(self.weights, steps), -steps)

    def promise(self, step: int, outlook: Outlook) -> tuple[int, int]:
        """Return what ``step`` adds to the weight of what is needed in the ``outlook``; ties go to the least key."""
        extra = self.reduced.landmarks.steps_of_step[step] & ~outlook.needed
        return _weight_of(self.weights, extra), -step


def _weight_of(weights: Sequence[int], steps: int) -> int:
    return sum(weights[step] for step in bits_of(steps))
