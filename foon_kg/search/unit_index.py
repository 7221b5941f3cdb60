"""A FOON in integers: built once, asked many times."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from heapq import heapify, heappop, heappush

from foon_kg.model import KnownUnit, ObjectNode


@dataclass(frozen=True, eq=False)
class UnitIndex:
    """The units of a FOON, or of the part behind some goals, numbered for searching.

    Make one with :meth:`of`. Units are numbered in the order of their keys, nodes in their own order, so that
    equal contents get equal numbers whatever order they came in. ``inputs`` and ``outputs`` hold, for each unit,
    the numbers of its nodes; ``producers``, for each node, the units that output it; ``units_naming``, for each label,
    the units that have it among their nodes. ``at_hand`` and ``gap_costs`` are the kitchen: which nodes are there,
    and what it costs to take one that is not.
    """

    units: tuple[KnownUnit, ...]
    nodes: tuple[ObjectNode, ...]
    number_of: dict[ObjectNode, int]
    inputs: tuple[tuple[int, ...], ...]
    outputs: tuple[tuple[int, ...], ...]
    producers: tuple[tuple[int, ...], ...]
    at_hand: tuple[bool, ...]
    gap_costs: tuple[int | None, ...]
    units_naming: dict[str, tuple[int, ...]]

    @classmethod
    def of(
        cls,
        units: Iterable[KnownUnit],
        *,
        at_hand: Callable[[ObjectNode], bool],
        gap_cost: Callable[[ObjectNode], int | None] = lambda _: None,
    ) -> UnitIndex:
        """Return the index of ``units``, which may come in any order and more than once.

        ``at_hand`` says what the kitchen has (``Kitchen.has``). ``gap_cost`` answers, for a node that it has not,
        the penalty (1 or more) of taking it all the same where there is no way round, or ``None`` for never; without
        it there are no gaps. A unit whose outputs are all among its inputs makes nothing and is left out (C3).

        Raises ValueError for a gap cost below 1.
        """
        by_key = {known.unit.key: known for known in units}
        kept = tuple(by_key[key] for key in sorted(by_key) if _makes_something(by_key[key]))
        nodes = _nodes_of(kept)
        number_of = {node: number for number, node in enumerate(nodes)}
        outputs = tuple(_numbers(known.unit.output_nodes, number_of) for known in kept)
        there = tuple(map(at_hand, nodes))
        costs = [None if has else _checked(gap_cost(node), node) for node, has in zip(nodes, there, strict=True)]
        return cls(
            units=kept,
            nodes=nodes,
            number_of=number_of,
            inputs=tuple(_numbers(known.unit.input_nodes, number_of) for known in kept),
            outputs=outputs,
            producers=_producers(outputs, len(nodes)),
            at_hand=there,
            gap_costs=tuple(costs),
            units_naming=_units_naming(kept),
        )

    @cached_property
    def least_penalties(self) -> tuple[float, ...]:
        """Return for each node what having it costs at least, in gaps: infinite where nothing makes it.

        The dearest input of a unit counts, and the cheapest way to a node: h^max (Bonet and Geffner: Planning as
        heuristic search, 2001), by Dijkstra's algorithm.
        """
        users, missing = self._users_and_missing()
        least = [0 if there else math.inf for there in self.at_hand]
        waiting = self._costs_at_once(missing)
        heapify(waiting)
        while waiting:
            cost, node = heappop(waiting)
            if cost >= least[node]:
                continue
            least[node] = cost
            for unit in users[node]:
                missing[unit] -= 1
                for made in self.outputs[unit] if not missing[unit] else ():  # its last input is its dearest
                    heappush(waiting, (cost, made))
        return tuple(least)

    def _costs_at_once(self, missing: Sequence[int]) -> list[tuple[int, int]]:
        """Return the nodes that are taken at a cost, and those made by a unit of which no input is ``missing``."""
        gaps = [(cost, node) for node, cost in enumerate(self.gap_costs) if cost is not None]
        return gaps + [(0, node) for unit, count in enumerate(missing) if not count for node in self.outputs[unit]]

    def _users_and_missing(self) -> tuple[list[list[int]], list[int]]:
        """Return which units take each node that nobody has, and how many such inputs each unit has."""
        users: list[list[int]] = [[] for _ in self.nodes]
        missing = [0] * len(self.units)
        for unit, nodes in enumerate(self.inputs):
            for node in nodes:
                if not self.at_hand[node]:
                    users[node].append(unit)
                    missing[unit] += 1
        return users, missing

    @cached_property
    def dearest_inputs(self) -> tuple[float, ...]:
        """Return for each unit what its dearest input costs at least, in gaps."""
        least = self.least_penalties
        return tuple(max((least[node] for node in nodes), default=0) for nodes in self.inputs)


def _makes_something(known: KnownUnit) -> bool:
    return not set(known.unit.output_nodes) <= set(known.unit.input_nodes)


def _numbers(nodes: Iterable[ObjectNode], number_of: dict[ObjectNode, int]) -> tuple[int, ...]:
    return tuple([number_of[node] for node in nodes])


def _nodes_of(units: Iterable[KnownUnit]) -> tuple[ObjectNode, ...]:
    nodes = {node for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    # no relation and an empty one sort alike, and are not the same node
    return tuple(sorted(nodes, key=lambda node: (node.sort_key, node.relation is None, node.container is None)))


def _producers(outputs: tuple[tuple[int, ...], ...], node_count: int) -> tuple[tuple[int, ...], ...]:
    producers: list[list[int]] = [[] for _ in range(node_count)]
    for unit, made in enumerate(outputs):
        for node in made:
            producers[node].append(unit)
    return tuple(map(tuple, producers))


def _units_naming(units: Iterable[KnownUnit]) -> dict[str, tuple[int, ...]]:
    naming: dict[str, list[int]] = {}
    for number, known in enumerate(units):
        for label in {node.label for node in (*known.unit.input_nodes, *known.unit.output_nodes)}:
            naming.setdefault(label, []).append(number)
    return {label: tuple(numbers) for label, numbers in naming.items()}


def _checked(cost: int | None, node: ObjectNode) -> int | None:
    if cost is not None and cost < 1:
        raise ValueError(f"the gap cost of {node} is {cost}; it must be 1 or more, or None")
    return cost
