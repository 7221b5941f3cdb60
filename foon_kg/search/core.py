"""The part of a FOON that one question turns on, as masks of bits."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

from foon_kg.search.problem import SearchProblem
from foon_kg.search.unit_index import UnitIndex

T = TypeVar("T")

ANY_GOAL = -1
"""The number of the goal in a core that makes any one of several nodes."""


@dataclass(frozen=True, eq=False)
class Core:
    """Steps and nodes behind one goal, numbered from 0.

    A *step* makes nodes: it is a unit, or a gap (a node that is simply taken, at its cost). Gaps come first, then the
    units from the greatest key to the least; so of two sets of steps, each an integer with one bit a step, the one
    with the greater integer has the lexicographically lesser sorted keys, as long as they have equally many units.
    ``inputs`` and ``outputs`` leave out what is at hand or available. ``foods`` are the wanted foods of a step.
    """

    goal: int
    nodes: tuple[int, ...]
    gap_nodes: tuple[int, ...]
    units: tuple[int, ...]
    inputs: tuple[tuple[int, ...], ...]
    outputs: tuple[tuple[int, ...], ...]
    costs: tuple[int, ...]
    foods: tuple[int, ...]

    @property
    def step_count(self) -> int:
        """How many steps there are, gaps and units."""
        return len(self.inputs)

    @cached_property
    def names(self) -> tuple[int, ...]:
        """What the steps are called in every core of one index: a unit by its number, a gap by its node's, negated."""
        return (*(-1 - node for node in self.gap_nodes), *self.units)

    def only(self, steps: Iterable[int]) -> Core:
        """Return the core of nothing but ``steps`` (by number) and their inputs, numbered anew in the same order."""
        kept = sorted(steps)
        nodes = sorted({self.goal, *(node for step in kept for node in self.inputs[step])})
        gaps = [step for step in kept if step < len(self.gap_nodes)]
        units = [step - len(self.gap_nodes) for step in kept[len(gaps) :]]
        place = {node: number for number, node in enumerate(nodes)}
        return Core(
            goal=place[self.goal],
            nodes=_at(nodes, self.nodes),
            gap_nodes=_at(gaps, self.gap_nodes),
            units=_at(units, self.units),
            inputs=tuple(_at(self.inputs[step], place) for step in kept),
            outputs=tuple(_known(self.outputs[step], place) for step in kept),
            costs=_at(gaps, self.costs),
            foods=_at(kept, self.foods),
        )

    def translated(self, steps: int, other: Core) -> int:
        """Return the set ``steps``, one bit a step, as a set of the steps of ``other``, which has them all."""
        place = {name: step for step, name in enumerate(other.names)}
        return sum(1 << place[self.names[step]] for step in bits_of(steps))

    def units_in(self, steps: int) -> int:
        """Return the number of units in the set ``steps`` (one bit a step); gaps are none."""
        return (steps >> len(self.gap_nodes)).bit_count()

    def penalty_of(self, steps: int) -> int:
        """Return the gap penalty of the set ``steps`` (one bit a step): the sum of the costs of its gaps."""
        gaps = steps & ((1 << len(self.gap_nodes)) - 1)
        return sum([self.costs[gap] for gap in bits_of(gaps)]) if gaps else 0

    @cached_property
    def has_foods(self) -> bool:
        """Whether any step has a wanted food."""
        return any(self.foods)

    def foods_of(self, steps: int) -> int:
        """Return the wanted foods that occur in the set ``steps`` (one bit a step), one bit a food."""
        if not self.has_foods:
            return 0
        found = 0
        for step in bits_of(steps):
            found |= self.foods[step]
        return found


def _at(places: Iterable[int], of: Sequence[T] | Mapping[int, T]) -> tuple[T, ...]:
    """Return what is at each of ``places``."""
    return tuple([of[place] for place in places])


def _known(numbers: Iterable[int], place: Mapping[int, int]) -> tuple[int, ...]:
    """Return the new numbers of those that have one, by their ``place``."""
    return tuple([there for number in numbers if (there := place.get(number)) is not None])


def bits_of(mask: int) -> list[int]:
    """Return the numbers of the bits that are set in ``mask``, the least first."""
    found = []
    while mask:
        low = mask & -mask
        found.append(low.bit_length() - 1)
        mask ^= low
    return found


def core_behind(problem: SearchProblem, goal: int, *, limit: float = math.inf) -> Core:
    """Return the core of all that may take part in making the node ``goal`` (its number in the index of ``problem``).

    With a ``limit`` (a gap penalty) that is everything that may be in a tree whose gaps cost no more; nothing may be
    available then.
    """
    return _numbered(problem, goal, _behind(problem, goal, problem.index.producers[goal], limit), limit)


def core_behind_any(problem: SearchProblem, goals: Iterable[int], *, limit: float = math.inf) -> Core:
    """Return the core of all that may take part in making one of the nodes ``goals``, whichever it is.

    ``goals`` are numbers in the index of ``problem``, ``limit`` is a gap penalty as in :func:`core_behind`. The goal of
    the core is ``ANY_GOAL``: every unit makes it that makes one of ``goals``. These are nodes like others, and so a
    tree of this core may take one of them to make the same one again.
    """
    makers = sorted({unit for goal in goals for unit in problem.index.producers[goal]})
    found = _behind(problem, ANY_GOAL, makers, limit)
    return _numbered(problem, ANY_GOAL, found, limit, makers=frozenset(makers))


def _behind(problem: SearchProblem, goal: int, makers: Iterable[int], limit: float) -> tuple[set[int], set[int]]:
    """Return the nodes and the units behind ``goal``, which ``makers`` make; nothing dearer than ``limit``."""
    index = problem.index
    dearest = None if limit == math.inf else index.dearest_inputs
    known = {index.number_of[node] for node in problem.available if node in index.number_of}
    nodes, units = {goal}, set(_cheap(makers, dearest, limit))
    waiting = list(units)
    for unit in waiting:  # grows while it is read
        for node in index.inputs[unit]:
            if not (index.at_hand[node] or node in nodes or node in known):
                nodes.add(node)
                fresh = set(_cheap(index.producers[node], dearest, limit)) - units
                units |= fresh
                waiting.extend(fresh)
    return nodes, units


def _cheap(makers: Iterable[int], dearest: Sequence[float] | None, limit: float) -> Iterable[int]:
    """Return those of ``makers`` whose ``dearest`` input costs at most ``limit``; all where that is ``None``."""
    return makers if dearest is None else [maker for maker in makers if dearest[maker] <= limit]


def _numbered(
    problem: SearchProblem,
    goal: int,
    found: tuple[set[int], set[int]],
    limit: float,
    *,
    makers: frozenset[int] = frozenset(),
) -> Core:
    """Return the core of the nodes and units ``found``; each of ``makers`` makes the goal beside its outputs."""
    index, (nodes, units) = problem.index, found
    costs = {node: cost for node in nodes if node != goal and (cost := index.gap_costs[node]) is not None}
    gaps = sorted((node for node, cost in costs.items() if cost <= limit), reverse=True)
    falling = sorted(units, reverse=True)
    place = {node: number for number, node in enumerate(sorted(nodes))}

    def made(unit: int) -> tuple[int, ...]:
        outputs = _known(index.outputs[unit], place)
        return (*outputs, place[goal]) if unit in makers else outputs

    return Core(
        goal=place[goal],
        nodes=tuple(sorted(nodes)),
        gap_nodes=tuple(gaps),
        units=tuple(falling),
        inputs=((),) * len(gaps) + tuple(_known(index.inputs[unit], place) for unit in falling),
        outputs=tuple((place[gap],) for gap in gaps) + tuple(map(made, falling)),
        costs=tuple(costs[gap] for gap in gaps),
        foods=foods_of_steps(index, gaps, falling, problem.wanted),
    )


def foods_of_steps(
    index: UnitIndex, gaps: Sequence[int], units: Sequence[int], wanted: Mapping[str, int]
) -> tuple[int, ...]:
    """Return the wanted foods of each step of a core, one bit a food: none for a gap, those that it names for a unit.

    ``gaps`` are nodes and ``units`` units by their numbers in ``index``; ``wanted`` gives names the number of a food.
    """
    foods: dict[int, int] = {}
    for label, number in wanted.items():
        for unit in index.units_naming.get(label, ()):
            foods[unit] = foods.get(unit, 0) | 1 << number
    return (*[0] * len(gaps), *(foods.get(unit, 0) for unit in units))
