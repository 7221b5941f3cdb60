"""Algorithm 3 as the paper defines it: every path through the Cartesian product of producers. Exponential.

This is the definition that :func:`foon_kg.search.retrieve` is measured against, and what a person reads to see between
which trees the choice was. It works on nodes and units as they are and shares no search with the everyday one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from foon_kg.model import ObjectNode
from foon_kg.search.problem import ReferenceTree, SearchProblem
from foon_kg.search.schedule import schedule

GAP = -1
"""What is chosen in place of a producer where a node is taken as a gap."""

Choices = Mapping[int, int]
"""The producer chosen for each needed node, or ``GAP``: numbers of nodes and units in the index."""


@dataclass(frozen=True, eq=False)
class Enumeration:
    """The distinct trees of a problem, best first.

    ``found`` has them with their units in no order yet, :meth:`first` and ``trees`` as they can be executed.
    ``looked_at`` are the combinations of producers of which each gave a tree or came to a dead end; ``complete`` says
    that these were all.
    """

    problem: SearchProblem
    found: tuple[ReferenceTree, ...]
    complete: bool
    looked_at: int

    def first(self, most: int) -> tuple[ReferenceTree, ...]:
        """Return the at most ``most`` best trees, each with its units in an order in which they can be executed."""
        return tuple(_scheduled(self.problem, tree) for tree in self.found[:most])

    @cached_property
    def trees(self) -> tuple[ReferenceTree, ...]:
        """All trees, each with its units in an order in which they can be executed."""
        return self.first(len(self.found))


def enumerate_paths(problem: SearchProblem, *, limit: int) -> Enumeration:
    """Return all trees of ``problem``, after at most ``limit`` combinations of producers have been looked at.

    From the goal, a *tree node* is one combination of producers for all objects that the tree node before it needs; a
    path from the root to a tree node that needs nothing more is a task tree, if it is well-founded (Sakib, Paulius,
    Sun 2021, Algorithm 3). The paper first drops the producers that overlap nothing wanted; that can lose the best
    tree, so here overlap decides between whole trees only.
    """
    trees: dict[tuple[object, ...], ReferenceTree] = {}
    looked_at, complete = 0, True
    for tree, combinations in _all_paths(problem):
        if looked_at < limit and tree is not None:
            trees.setdefault(tree.rank, tree)
        complete = looked_at + combinations <= limit
        looked_at = min(looked_at + combinations, limit)
        if not complete:
            break
    ranked = [trees[rank] for rank in sorted(trees)]
    if complete and ranked:
        ranked[0] = replace(ranked[0], exact=True)
    return Enumeration(problem, tuple(ranked), complete, looked_at)


def with_gaps_of(problem: SearchProblem, tree: ReferenceTree) -> SearchProblem:
    """Return ``problem`` with no other gaps than those that ``tree`` takes.

    Nearly every node may be a gap, at its cost, and a path for each of these choices is more than anybody wants
    to read. Where ``tree`` is the best one, the best of what is left is ``tree`` as well.
    """
    index, gaps = problem.index, set(tree.gaps)
    costs = tuple(cost if node in gaps else None for node, cost in zip(index.nodes, index.gap_costs, strict=True))
    return replace(problem, index=replace(index, gap_costs=costs))


def _all_paths(problem: SearchProblem) -> Iterator[tuple[ReferenceTree | None, int]]:
    """Yield every tree with 1; for dead ends ``None``, with the number of combinations that come to one together."""
    for target in sorted(set(problem.targets), key=lambda node: node.sort_key):
        if target in problem.available:
            yield ReferenceTree(goal=target, units=(), gaps=(), penalty=0, covered=(), exact=False), 1
        elif target in problem.index.number_of:
            ways = _Ways(problem, target)
            for choices, combinations in ways.paths():
                yield None if choices is None else ways.tree(choices), combinations


@dataclass(frozen=True, eq=False)
class _TreeNode:
    """What is ``needed``, and the ``candidates`` for each of that.

    ``after`` tells, for each needed node, how many combinations there are of the candidates of those that come later.
    """

    needed: Sequence[int]
    candidates: Sequence[Sequence[int]]
    after: Sequence[int]


@dataclass(frozen=True, eq=False)
class _Way:
    """A way from the goal: all ``choices`` up to ``tree_node``, and of that for the first ``place`` needed nodes.

    ``untried`` are candidates for the node at ``place``. ``above`` has each node of the way and those that are still to
    be made, with what they are needed for, directly or not: a number with a bit for each such node.
    """

    choices: Choices
    above: Mapping[int, int]
    tree_node: _TreeNode
    place: int
    untried: Iterator[int]


@dataclass(frozen=True, eq=False)
class _Ways:
    """All ways to make ``goal``. What was found out about units and nodes is kept."""

    problem: SearchProblem
    goal: ObjectNode
    _to_make: dict[int, tuple[int, ...]] = field(default_factory=dict)
    _covered: dict[int, frozenset[int]] = field(default_factory=dict)

    def paths(self) -> Iterator[tuple[Choices | None, int]]:
        """Yield the choices of every path with 1; for dead ends ``None``, with how many combinations they are.

        A producer that needs what it makes, through those chosen before it, is a dead end whatever is chosen for the
        needed nodes after it: these combinations are counted and not tried.
        """
        ways = [self._next_tree_node({}, {self.problem.index.number_of[self.goal]: 0})]
        while ways:
            way = ways[-1]
            chosen = next(way.untried, None)
            if chosen is None:
                ways.pop()
            elif (further := self._further(way, chosen)) is None:
                yield None, way.tree_node.after[way.place]
            elif further.tree_node.needed:
                ways.append(further)
            else:
                yield further.choices, 1

    def _further(self, way: _Way, chosen: int) -> _Way | None:
        """Return ``way`` with what is chosen for its next node; ``None`` where that goes in circles."""
        tree_node, place = way.tree_node, way.place + 1
        node = tree_node.needed[way.place]
        above = way.above if chosen == GAP else self._above(way, node, chosen)
        if above is None:
            return None
        choices = {**way.choices, node: chosen}
        if place == len(tree_node.needed):
            return self._next_tree_node(choices, above)
        return _Way(choices, above, tree_node, place, iter(tree_node.candidates[place]))

    def _next_tree_node(self, choices: Choices, above: Mapping[int, int]) -> _Way:
        needed = sorted(above.keys() - choices.keys())
        candidates = [self._candidates(node) for node in needed]
        after = [math.prod(map(len, candidates[place:])) for place in range(1, len(needed) + 1)]
        untried = candidates[0] if all(candidates) and candidates else ()
        return _Way(choices, above, _TreeNode(needed, candidates, after), 0, iter(untried))

    def _candidates(self, node: int) -> Sequence[int]:
        index = self.problem.index
        if index.gap_costs[node] is None or index.nodes[node] == self.goal:
            return index.producers[node]
        return (*index.producers[node], GAP)

    def _above(self, way: _Way, node: int, unit: int) -> Mapping[int, int] | None:
        """Return what lies above each node once ``unit`` makes ``node``; ``None`` where that goes in circles."""
        inputs = self._inputs_to_make(unit)
        more = way.above[node] | 1 << node
        if any(more >> made & 1 for made in inputs):
            return None
        above, waiting = dict(way.above), list(inputs)
        while waiting:
            below = waiting.pop()
            before = above.get(below, 0)
            above[below] = before | more
            maker = way.choices.get(below, GAP)
            if maker != GAP and above[below] != before:
                waiting.extend(self._inputs_to_make(maker))
        return above

    def _inputs_to_make(self, unit: int) -> tuple[int, ...]:
        """Return the inputs of ``unit`` that are not there."""
        if unit not in self._to_make:
            index = self.problem.index
            inputs = index.inputs[unit]
            self._to_make[unit] = tuple(n for n in inputs if not _is_there(self.problem, self.goal, index.nodes[n]))
        return self._to_make[unit]

    def tree(self, choices: Choices) -> ReferenceTree:
        """Return the tree that was chosen, its units still in no order."""
        index = self.problem.index
        units = [unit for unit in dict.fromkeys(choices.values()) if unit != GAP]
        gaps = sorted(node for node, unit in choices.items() if unit == GAP)
        return ReferenceTree(
            goal=self.goal,
            units=tuple(index.units[unit] for unit in units),
            gaps=tuple(index.nodes[gap] for gap in gaps),
            penalty=sum(index.gap_costs[gap] or 0 for gap in gaps),
            covered=tuple(sorted(frozenset[int]().union(*map(self._covered_by, units)))),
            exact=False,
        )

    def _covered_by(self, unit: int) -> frozenset[int]:
        """Return the numbers of the wanted foods that ``unit`` names."""
        if unit not in self._covered:
            known, wanted = self.problem.index.units[unit].unit, self.problem.wanted
            labels = {node.label for node in (*known.input_nodes, *known.output_nodes)}
            self._covered[unit] = frozenset(wanted[label] for label in labels if label in wanted)
        return self._covered[unit]


def _is_there(problem: SearchProblem, goal: ObjectNode, node: ObjectNode) -> bool:
    """Return whether nobody has to make ``node`` on the way to ``goal``, which somebody has to."""
    at_hand = problem.index.at_hand[problem.index.number_of[node]]
    return node != goal and (at_hand or node in problem.available)


def _scheduled(problem: SearchProblem, tree: ReferenceTree) -> ReferenceTree:
    """Return ``tree`` with its units in an order in which they can be executed."""
    inputs = {node for known in tree.units for node in known.unit.input_nodes}
    there = {node for node in inputs if _is_there(problem, tree.goal, node)}
    return replace(tree, units=schedule(tree.units, there.union(tree.gaps), tree.goal))
