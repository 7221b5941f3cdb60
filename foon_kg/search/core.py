"""The part of a FOON that one question turns on, as masks of bits."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.search.problem import SearchProblem
from foon_kg.search.unit_index import UnitIndex


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
        """Answer the core of nothing but ``steps``, numbered anew in the same order, and of their inputs."""
        kept, gap_count = sorted(steps), len(self.gap_nodes)
        nodes = sorted({self.goal, *(node for step in kept for node in self.inputs[step])})
        place = {node: number for number, node in enumerate(nodes)}
        return Core(
            goal=place[self.goal],
            nodes=tuple(self.nodes[node] for node in nodes),
            gap_nodes=tuple(self.gap_nodes[step] for step in kept if step < gap_count),
            units=tuple(self.units[step - gap_count] for step in kept if step >= gap_count),
            inputs=tuple(tuple(place[node] for node in self.inputs[step]) for step in kept),
            outputs=tuple(tuple(place[node] for node in self.outputs[step] if node in place) for step in kept),
            costs=tuple(self.costs[step] for step in kept if step < gap_count),
            foods=tuple(self.foods[step] for step in kept),
        )

    def translated(self, steps: int, other: Core) -> int:
        """Answer the set ``steps`` of this core as a set of the steps of ``other``, which has them all."""
        place = {name: step for step, name in enumerate(other.names)}
        return sum(1 << place[self.names[step]] for step in bits_of(steps))

    def units_in(self, steps: int) -> int:
        """How many units are in the set ``steps``."""
        return (steps >> len(self.gap_nodes)).bit_count()

    def penalty_of(self, steps: int) -> int:
        """Answer the sum of the costs of the gaps in the set ``steps``."""
        gaps = steps & ((1 << len(self.gap_nodes)) - 1)
        return sum(self.costs[gap] for gap in bits_of(gaps)) if gaps else 0

    def foods_of(self, steps: int) -> int:
        """Answer the set of the wanted foods that occur in the set ``steps``."""
        found = 0
        for step in bits_of(steps):
            found |= self.foods[step]
        return found


def bits_of(mask: int) -> Iterator[int]:
    """Answer the numbers in a set, the least first."""
    while mask:
        low = mask & -mask
        yield low.bit_length() - 1
        mask ^= low


def core_behind(problem: SearchProblem, goal: int) -> Core:
    """Collect everything that may take part in making the node ``goal`` (its number in the index)."""
    index = problem.index
    available = {index.number_of[node] for node in problem.available if node in index.number_of} - {goal}
    nodes, units = _behind(index, goal, available)
    gaps = [n for n in sorted(nodes, reverse=True) if n != goal and index.gap_costs[n] is not None]
    return _numbered(index, goal, sorted(nodes), gaps, sorted(units, reverse=True), problem.wanted)


def _behind(index: UnitIndex, goal: int, available: set[int]) -> tuple[set[int], set[int]]:
    waiting, nodes, units = [goal], {goal}, set[int]()
    for node in waiting:  # grows while it is read
        for unit in index.producers[node]:
            if unit not in units:
                units.add(unit)
                fresh = [
                    n for n in index.inputs[unit] if n not in nodes and not index.at_hand[n] and n not in available
                ]
                nodes.update(fresh)
                waiting.extend(fresh)
    return nodes, units


def _numbered(  # noqa: PLR0917 - the columns of one table
    index: UnitIndex,
    goal: int,
    nodes: Sequence[int],
    gaps: Sequence[int],
    units: Sequence[int],
    wanted: Mapping[str, int],
) -> Core:
    foods = _foods_by_unit(index, wanted)
    place = {node: number for number, node in enumerate(nodes)}

    def local(numbers: Iterable[int]) -> tuple[int, ...]:
        return tuple(place[n] for n in numbers if n in place)

    return Core(
        goal=place[goal],
        nodes=tuple(nodes),
        gap_nodes=tuple(gaps),
        units=tuple(units),
        inputs=((),) * len(gaps) + tuple(local(index.inputs[unit]) for unit in units),
        outputs=tuple(local([gap]) for gap in gaps) + tuple(local(index.outputs[unit]) for unit in units),
        costs=tuple(index.gap_costs[gap] or 0 for gap in gaps),
        foods=(0,) * len(gaps) + tuple(foods.get(unit, 0) for unit in units),
    )


def _foods_by_unit(index: UnitIndex, wanted: Mapping[str, int]) -> dict[int, int]:
    foods: dict[int, int] = {}
    for label, number in wanted.items():
        for unit in index.units_naming.get(label, ()):
            foods[unit] = foods.get(unit, 0) | 1 << number
    return foods
