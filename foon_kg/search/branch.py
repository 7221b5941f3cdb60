"""Branch and bound over "which producer for the next needed node", with proof."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Hashable
from dataclasses import dataclass, field

from foon_kg.search.core import bits_of
from foon_kg.search.cuts import cut_bound
from foon_kg.search.partial import Partial
from foon_kg.search.problem import Bound, weakest
from foon_kg.search.reduction import Reduced, Value, value_of

_CLOCK_EVERY = 16


@dataclass(eq=False)
class Search(ABC):
    """One search: the ``best`` tree so far (no steps: none of least penalty yet), and what is still to be tried."""

    reduced: Reduced
    best: int
    deadline: float | None = None
    tried: int = 0
    untried: list[Partial] = field(default_factory=list)

    def __post_init__(self) -> None:
        found = value_of(self.reduced.core, self.best)
        is_tree = self.best and found[0] == self.reduced.penalty
        self.value: Value = found if is_tree else (self.reduced.penalty + 1, 1, 0, 0)

    def run(self) -> bool:
        """Search on until the best is proven (True) or the deadline has passed (False)."""
        choice, core = self.reduced.choice, self.reduced.core
        self.untried = [choice.start()]
        while self.untried and not self.is_proven():
            self.tried += 1
            if self.deadline is not None and self.tried % _CLOCK_EVERY == 0 and time.monotonic() > self.deadline:
                return False
            partial, node, options = choice.forced(self.untried.pop())
            if node < 0:
                self._offer(partial.chosen)
            elif options:
                outlook = Outlook.of(self.reduced, partial)
                if outlook.penalty <= self.reduced.penalty and not self.is_hopeless(partial, outlook):
                    options.sort(key=lambda step: self._promise(step, outlook), reverse=True)
                    self.untried += [partial.take(core, node, step) for step in options]
        return True

    def bound(self) -> Bound:
        """Answer what no tree can be better than: the best found, or anything still to be tried."""
        bounds = [Bound(self.reduced.penalty, -self.value[1], self.value[2])]
        for partial in self.untried:
            outlook = Outlook.of(self.reduced, partial)
            units = self.reduced.core.units_in(outlook.needed)
            bounds.append(Bound(outlook.penalty, outlook.reach.bit_count(), units))
        return weakest(bounds)

    @abstractmethod
    def is_proven(self) -> bool:
        """Whether nothing can be better than the best so far."""

    @abstractmethod
    def is_hopeless(self, partial: Partial, outlook: Outlook) -> bool:
        """Whether no tree that grows from ``partial`` is better than the best so far."""

    def _offer(self, steps: int) -> None:
        value = value_of(self.reduced.core, steps)
        if value[0] == self.reduced.penalty and value < self.value:
            self.best, self.value = steps, value

    def _promise(self, step: int, outlook: Outlook) -> tuple[int, int, int, int]:
        core = self.reduced.core
        extra = self.reduced.landmarks.steps_of_step[step] & ~outlook.needed
        gain = (core.foods_of(extra) & ~outlook.foods).bit_count()
        return core.penalty_of(extra), -gain, core.units_in(extra), -step


@dataclass(frozen=True)
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
        """Look at what waits in ``partial``."""
        needed, behind, reach, around = partial.chosen, 0, 0, 0
        for node in partial.waiting:
            needed |= reduced.landmarks.steps_of_node[node]
            behind |= reduced.behind[node]
            reach |= reduced.foods[node]
            around |= reduced.around[node]
        foods = reduced.core.foods_of(needed)
        return cls(needed, reduced.core.penalty_of(needed), foods, behind, reach | foods, around)

    def same_future(self, partial: Partial) -> tuple[Hashable, ...]:
        """Answer a key: trees that are partial in different ways but have the same key can grow in the same ways."""
        above = frozenset((node, above & self.around) for node, above in partial.waiting.items())
        return (above, partial.decided & self.around, partial.chosen & self.behind)


@dataclass(eq=False)
class OverlapSearch(Search):
    """The greatest overlap among the trees of least penalty, at whatever length."""

    seen: dict[Hashable, list[int]] = field(default_factory=dict)

    def is_proven(self) -> bool:
        """Whether the best has every wanted food that any tree of least penalty could have."""
        return -self.value[1] == self.reduced.foods[self.reduced.core.goal].bit_count()

    def is_hopeless(self, partial: Partial, outlook: Outlook) -> bool:
        """Whether no wanted food can be gained, or another partial tree with the same future has them all."""
        if outlook.reach.bit_count() <= -self.value[1]:
            return True
        penalty, foods = self.reduced.core.penalty_of(partial.chosen), self.reduced.core.foods_of(partial.chosen)
        before = self.seen.setdefault((penalty, *outlook.same_future(partial)), [])
        if any(foods & ~others == 0 for others in before):
            return True
        before.append(foods)
        return False


@dataclass(eq=False)
class UnitSearch(Search):
    """The fewest units among the trees of least penalty and greatest overlap, then the least keys."""

    seen: dict[Hashable, tuple[int, int]] = field(default_factory=dict)

    def is_proven(self) -> bool:
        """Whether the best is known to be so before everything is tried: never, for the sake of the least keys."""
        return False

    def is_hopeless(self, partial: Partial, outlook: Outlook) -> bool:
        """Whether the overlap is lost, too many units are needed, or a better partial tree has the same future."""
        core, (penalty, overlap, units, steps) = self.reduced.core, self.value
        if outlook.reach.bit_count() < -overlap:
            return True
        fewest = core.units_in(outlook.needed)
        if fewest > units:
            return True
        # as many units, and no gap that could still come: what is needed is the whole tree
        if fewest == units and outlook.penalty == penalty and -outlook.needed >= steps:
            return True
        return self._seen_better(partial, outlook) or self._too_long(partial, outlook, units - fewest)

    def _too_long(self, partial: Partial, outlook: Outlook, spare: int) -> bool:
        weights = self.reduced.unit_weights(outlook.needed)
        cuts = cut_bound(self.reduced.web, weights, partial.waiting, list(bits_of(partial.decided)))
        return cuts is None or cuts.bound > spare

    def _seen_better(self, partial: Partial, outlook: Outlook) -> bool:
        core = self.reduced.core
        key = (core.penalty_of(partial.chosen), core.foods_of(partial.chosen), *outlook.same_future(partial))
        value = (core.units_in(partial.chosen), -partial.chosen)
        before = self.seen.get(key)
        if before is not None and before <= value:
            return True
        self.seen[key] = value
        return False
