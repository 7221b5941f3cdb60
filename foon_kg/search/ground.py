"""What all questions about one goal have in common, whatever is wanted: found once, kept for the next question."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from foon_kg.model.recent import Recent
from foon_kg.search.core import Core, bits_of, core_behind, core_behind_any, foods_of_steps
from foon_kg.search.deadline import Deadline
from foon_kg.search.penalty import LeastPenalty, within_least_penalty
from foon_kg.search.problem import ReferenceTree, SearchProblem
from foon_kg.search.reduction import Reduced
from foon_kg.search.unit_index import UnitIndex

MOST_TREES = 4096
"""How many trees are kept: one for each goal, and for each choice of foods that can be wanted of it."""

_AT_FIRST, _THEN = 4, 16
"""How many times what the dearest gap costs at least is looked at first, and then, for all the gaps of a tree."""

Goals = tuple[int, ...]
"""The numbers of nodes in an index, any one of which is to be made."""


@dataclass(frozen=True, eq=False)
class Ground:
    """What may be in a tree of least penalty; ``at_least`` is what is proven of that penalty.

    ``certain`` are the labels of the units that every such tree has, ``possible`` those of all units.
    """

    index: UnitIndex
    reduced: Reduced
    at_least: int
    certain: frozenset[str]
    possible: frozenset[str]

    @classmethod
    def behind(cls, problem: SearchProblem, goals: Goals, deadline: Deadline) -> Ground | None:
        """Return the ground behind ``goals``, whatever ``problem`` wants; ``None`` where nothing makes them.

        What is not done when the ``deadline`` passes is not proven.
        """
        nothing = SearchProblem(problem.index, problem.targets, available=problem.available)
        found = _within_limits(nothing, goals, deadline)
        if found is None:
            return None
        core, least = found
        reduced = Reduced.of(core, least.penalty, least.steps)
        needed = bits_of(reduced.landmarks.steps_of_node[reduced.core.goal])
        certain = _labels(problem.index, reduced.core, needed)
        possible = _labels(problem.index, reduced.core, range(reduced.core.step_count))
        return cls(problem.index, reduced, least.at_least, certain, possible)

    @property
    def is_proven(self) -> bool:
        """Whether no tree has a lesser penalty."""
        return self.at_least == self.reduced.penalty

    def undecided(self, wanted: Mapping[str, int]) -> dict[str, int]:
        """Return the part of ``wanted`` (names by the number of a food) that some trees have and others not.

        The choice between trees turns on no other food.
        """
        settled = {number for label, number in wanted.items() if label in self.certain}
        return {label: number for label, number in wanted.items() if number not in settled and label in self.possible}

    def wanting(self, undecided: Mapping[str, int]) -> Reduced:
        """Return what may be in a tree, with the ``undecided`` foods of its steps, one bit for the number of a food."""
        if not undecided:
            return self.reduced
        core = self.reduced.core
        return self.reduced.wanting(foods_of_steps(self.index, core.gap_nodes, core.units, undecided))


@dataclass(eq=False)
class Explored:
    """What was found in one index so far: recipes that want different things mostly get the same tree of a goal.

    There are no more ``grounds`` than goals in the index; of ``trees`` there is one for each choice of wanted foods.
    """

    grounds: dict[Goals, Ground | None] = field(default_factory=dict)
    trees: Recent[tuple[Goals, frozenset[frozenset[str]]], ReferenceTree] = field(
        default_factory=lambda: Recent(MOST_TREES)
    )

    def ground(self, problem: SearchProblem, goals: Goals, deadline: Deadline) -> Ground | None:
        """Return :meth:`Ground.behind` for the ``goals`` of ``problem``, known or found before the ``deadline``.

        What is not proven is not kept.
        """
        if goals in self.grounds:
            return self.grounds[goals]
        ground = Ground.behind(problem, goals, deadline)
        if ground is None or ground.is_proven:
            self.grounds[goals] = ground
        return ground


def _within_limits(problem: SearchProblem, goals: Goals, deadline: Deadline) -> tuple[Core, LeastPenalty] | None:
    """Find the least penalty among what may be in trees that cost little, and only else among all: most do."""
    least = _least_possible(problem, goals)
    if least == math.inf:
        return None
    limit = math.inf if problem.available else _AT_FIRST * least
    while True:
        core = _core_of(problem, goals, limit)
        found = within_least_penalty(core, deadline)
        if found is not None and found.penalty <= limit:
            return core, found
        if limit == math.inf:
            return None
        wider = _THEN * least if limit < _THEN * least else math.inf
        limit = wider if found is None else found.penalty  # a tree says how much a better one may cost


def _least_possible(problem: SearchProblem, goals: Goals) -> float:
    """Return what no tree of ``goals`` can be cheaper than: nothing is known of that where something is available."""
    if problem.available:
        return 0
    makers = {unit for goal in goals for unit in problem.index.producers[goal]}
    return min((problem.index.dearest_inputs[unit] for unit in makers), default=math.inf)


def _core_of(problem: SearchProblem, goals: Goals, limit: float) -> Core:
    if len(goals) == 1:
        return core_behind(problem, goals[0], limit=limit)
    return core_behind_any(problem, goals, limit=limit)


def _labels(index: UnitIndex, core: Core, steps: Iterable[int]) -> frozenset[str]:
    gap_count = len(core.gap_nodes)
    units = [core.units[step - gap_count] for step in steps if step >= gap_count]
    nodes = {node for unit in units for node in (*index.inputs[unit], *index.outputs[unit])}
    return frozenset(index.nodes[node].label for node in nodes)


def alike(wanted: Mapping[str, int]) -> frozenset[frozenset[str]]:
    """Return the names of ``wanted`` in groups that stand for one food each; its numbers are dropped."""
    groups: dict[int, set[str]] = {}
    for label, number in wanted.items():
        groups.setdefault(number, set()).add(label)
    return frozenset(map(frozenset, groups.values()))
