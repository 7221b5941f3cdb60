"""The tree with the greatest product of success rates, proven."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.search import SearchProblem, schedule
from foon_kg.search.classic.effort import efforts
from foon_kg.search.classic.least_weight import LeastWeight, least_weight
from foon_kg.search.core import Core, bits_of, core_behind
from foon_kg.search.deadline import Deadline
from foon_kg.search.unit_index import UnitIndex


@dataclass(frozen=True)
class LikeliestTree:
    """``units`` in an order of execution; ``bound`` is there where it is not proven: no tree has a greater success."""

    goal: ObjectNode
    units: tuple[KnownUnit, ...]
    bound: float | None


@dataclass(frozen=True, eq=False)
class _Efforts:
    """The effort of every unit of an index: by the success rates, and one more for each unit, to decide between equals.

    ``unit`` is the rate by which ``scale`` is known.
    """

    of_unit: Sequence[int]
    steepest: Fraction
    scale: int

    @classmethod
    def of(cls, problem: SearchProblem, costs: MotionCosts) -> _Efforts:
        """Return the efforts of the units in the problem's index, whose success rates are above 0."""
        index = problem.index
        longest = min(len(index.units), index.at_hand.count(False) + len(problem.targets))  # one producer a node
        rates = [costs.success(known.unit.motion) for known in index.units]
        effort = efforts(set(rates), longest)
        beside = longest + 1  # more than all units of a tree count together
        steepest = min(rates)
        return cls([effort[rate] * beside + 1 for rate in rates], steepest, effort[steepest] * beside)

    def weigh(self, core: Core) -> list[int]:
        """Return the weight of each step of a core without gaps."""
        return [self.of_unit[unit] for unit in core.units]

    def success(self, weight: int) -> float:
        """Return the success rate, rounded, of a tree that weighs ``weight``."""
        return math.exp(math.log(self.steepest) * (weight / self.scale)) if self.scale else 1.0


def likeliest_tree(problem: SearchProblem, costs: MotionCosts, deadline: Deadline) -> LikeliestTree | None:
    """Return the tree of greatest success for one of the targets of ``problem``; ``None`` where nothing makes any.

    ``costs`` has the success rate (over 0, to 1) of each unit's motion; the rates of a tree multiply. Of equal rates,
    exactly, the tree with the fewest units is the best, then that with the lexicographically least sorted keys of its
    units, then the least target. Past the ``deadline`` it is the best found.
    """
    index = problem.index
    if not index.units:
        return None
    effort = _Efforts.of(problem, costs)
    found: list[_Candidate] = []
    targets = {node for node in problem.targets if node in index.number_of}
    for target in sorted(targets, key=lambda node: node.sort_key):
        least = least_weight(core_behind(problem, index.number_of[target]), effort.weigh, deadline)
        if least is not None:
            found.append(_Candidate(target, least, index))
    if not found:
        return None
    best = min(found, key=lambda one: one.rank)
    at_least = min(one.least.at_least for one in found)
    return LikeliestTree(best.goal, best.ordered(), None if _decided(found, best) else effort.success(at_least))


@dataclass(frozen=True, eq=False)
class _Candidate:
    """The lightest tree of one target."""

    goal: ObjectNode
    least: LeastWeight
    index: UnitIndex

    @cached_property
    def units(self) -> list[KnownUnit]:
        """The units of the tree, in no order of execution."""
        return [self.index.units[self.least.core.units[step]] for step in bits_of(self.least.steps)]

    @cached_property
    def rank(self) -> tuple[int, list[str], tuple[object, ...]]:
        """What decides between trees: the weight, then the keys of the units, then the target."""
        return self.least.weight, sorted(known.unit.key for known in self.units), self.goal.sort_key

    def ordered(self) -> tuple[KnownUnit, ...]:
        """Return the units in an order in which they can be executed."""
        index = self.index
        inputs = {node for known in self.units for node in known.unit.input_nodes}
        there = {node for node in inputs if index.at_hand[index.number_of[node]]}
        return schedule(self.units, there - {self.goal}, self.goal)


def _decided(found: Iterable[_Candidate], best: _Candidate) -> bool:
    """Whether it is proven that none of the trees ``found`` may be as light as the best, or lighter."""
    return all(one.least.proven or one.least.at_least > best.least.weight for one in found)
