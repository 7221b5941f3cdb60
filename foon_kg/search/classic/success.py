"""The tree with the greatest product of success rates, proven."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.search import SearchProblem, schedule
from foon_kg.search.classic.effort import efforts
from foon_kg.search.classic.least_weight import LeastWeight, least_weight
from foon_kg.search.core import Core, bits_of, core_behind
from foon_kg.search.deadline import Deadline


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
    targets = sorted((n for n in set(problem.targets) if n in index.number_of), key=lambda node: node.sort_key)
    if not index.units:
        return None
    effort = _Efforts.of(problem, costs)
    found: list[tuple[int, list[str], tuple[object, ...], ObjectNode, LeastWeight]] = []
    for target in targets:
        least = least_weight(core_behind(problem, index.number_of[target]), effort.weigh, deadline)
        if least is not None:
            keys = sorted(index.units[unit].unit.key for unit in _units_of(least))
            found.append((least.weight, keys, target.sort_key, target, least))
    if not found:
        return None
    weight, _, _, goal, best = min(found, key=lambda entry: entry[:3])
    at_least = min(least.at_least for *_, least in found)
    open_still = any(not least.proven and least.at_least <= weight for *_, least in found)
    units = [index.units[unit] for unit in _units_of(best)]
    there = {node for known in units for node in known.unit.input_nodes if index.at_hand[index.number_of[node]]}
    ordered = schedule(units, there - {goal}, goal)
    return LikeliestTree(goal, ordered, effort.success(at_least) if open_still else None)


def _units_of(least: LeastWeight) -> list[int]:
    return [least.core.units[step] for step in bits_of(least.steps)]
