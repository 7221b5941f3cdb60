"""Algorithm 3 as the paper defines it: every path through the Cartesian product of producers. Exponential.

This is the definition that :func:`foon_kg.search.retrieve` is measured against, and what a person reads to see between
which trees the choice was. It works on nodes and units as they are and shares no search with the everyday one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice, product

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.search.problem import ReferenceTree, SearchProblem
from foon_kg.search.schedule import schedule

Choices = Mapping[ObjectNode, KnownUnit | None]
"""The producer chosen for each needed node; ``None`` takes the node as a gap."""


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
    looked_at, paths = 0, _all_paths(problem)
    for tree in islice(paths, limit):
        looked_at += 1
        if tree is not None:
            trees.setdefault(tree.rank, tree)
    complete = looked_at < limit or next(paths, paths) is paths
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


def _all_paths(problem: SearchProblem) -> Iterator[ReferenceTree | None]:
    for target in sorted(set(problem.targets), key=lambda node: node.sort_key):
        if target in problem.available:
            yield _tree(problem, target, {})
        elif target in problem.index.number_of:
            for choices in _paths(problem, target, {}, (target,)):
                yield None if choices is None else _tree(problem, target, choices)


def _paths(
    problem: SearchProblem, goal: ObjectNode, choices: Choices, needed: tuple[ObjectNode, ...]
) -> Iterator[Choices | None]:
    """Every path on from the tree node that chose ``choices`` and needs ``needed``; ``None`` for a dead end."""
    if not needed:
        yield choices
        return
    for combination in product(*(_candidates(problem, goal, node) for node in needed)):
        child = {**choices, **dict(zip(needed, combination, strict=True))}
        if _goes_in_circles(child, goal):
            yield None
        else:
            yield from _paths(problem, goal, child, _open_inputs(problem, goal, child))


def _candidates(problem: SearchProblem, goal: ObjectNode, node: ObjectNode) -> list[KnownUnit | None]:
    number = problem.index.number_of[node]
    candidates: list[KnownUnit | None] = [problem.index.units[unit] for unit in problem.index.producers[number]]
    if node != goal and problem.index.gap_costs[number] is not None:
        candidates.append(None)
    return candidates


def _open_inputs(problem: SearchProblem, goal: ObjectNode, choices: Choices) -> tuple[ObjectNode, ...]:
    inputs = {node for unit in choices.values() if unit for node in unit.unit.input_nodes}
    waiting = {node for node in inputs if node not in choices and not _is_there(problem, goal, node)}
    return tuple(sorted(waiting, key=lambda node: node.sort_key))


def _is_there(problem: SearchProblem, goal: ObjectNode, node: ObjectNode) -> bool:
    at_hand = problem.index.at_hand[problem.index.number_of[node]]
    return node != goal and (at_hand or node in problem.available)


def _goes_in_circles(choices: Choices, goal: ObjectNode) -> bool:
    """Whether a chosen producer needs, through the producers chosen below it, what it makes."""
    above, done = set[ObjectNode](), set[ObjectNode]()

    def returns(node: ObjectNode) -> bool:
        if node in above:
            return True
        producer = choices.get(node)
        if node in done or producer is None:
            return False
        above.add(node)
        found = any(map(returns, producer.unit.input_nodes))
        above.remove(node)
        done.add(node)
        return found

    return returns(goal)


def _tree(problem: SearchProblem, goal: ObjectNode, choices: Choices) -> ReferenceTree:
    """Return the tree that was chosen, its units still in no order."""
    units = {unit.unit.key: unit for unit in choices.values() if unit is not None}
    gaps = tuple(sorted((node for node, unit in choices.items() if unit is None), key=lambda node: node.sort_key))
    costs = (problem.index.gap_costs[problem.index.number_of[gap]] for gap in gaps)
    return ReferenceTree(
        goal=goal,
        units=tuple(units.values()),
        gaps=gaps,
        penalty=sum(cost or 0 for cost in costs),
        covered=_covered(problem, units.values()),
        exact=False,
    )


def _covered(problem: SearchProblem, units: Iterable[KnownUnit]) -> tuple[int, ...]:
    """Return the numbers of the wanted foods that ``units`` name, sorted."""
    labels = {node.label for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    return tuple(sorted({problem.wanted[label] for label in labels if label in problem.wanted}))


def _scheduled(problem: SearchProblem, tree: ReferenceTree) -> ReferenceTree:
    """Return ``tree`` with its units in an order in which they can be executed."""
    inputs = {node for known in tree.units for node in known.unit.input_nodes}
    there = {node for node in inputs if _is_there(problem, tree.goal, node)}
    return replace(tree, units=schedule(tree.units, there.union(tree.gaps), tree.goal))
