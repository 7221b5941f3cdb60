"""Every path through the Cartesian product of producers, written as the paper tells it and as slow as that is.

The oracle of ``enumerate_paths``: it walks nodes and whole combinations, and shares nothing with what it is beside.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice, product

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.search import ReferenceTree, SearchProblem

Choices = Mapping[ObjectNode, KnownUnit | None]


def paths_by_definition(problem: SearchProblem, limit: int) -> tuple[list[ReferenceTree], bool, int]:
    """The distinct trees of the first ``limit`` combinations, whether these are all, and how many were looked at."""
    trees: dict[tuple[object, ...], ReferenceTree] = {}
    looked_at, paths = 0, all_paths(problem)
    for tree in islice(paths, limit):
        looked_at += 1
        if tree is not None:
            trees.setdefault(tree.rank, tree)
    complete = looked_at < limit or next(paths, paths) is paths
    return [trees[rank] for rank in sorted(trees)], complete, looked_at


def all_paths(problem: SearchProblem) -> Iterator[ReferenceTree | None]:
    for target in sorted(set(problem.targets), key=lambda node: node.sort_key):
        if target in problem.available:
            yield tree_of(problem, target, {})
        elif target in problem.index.number_of:
            for choices in further(problem, target, {}, (target,)):
                yield None if choices is None else tree_of(problem, target, choices)


def further(
    problem: SearchProblem, goal: ObjectNode, choices: Choices, needed: tuple[ObjectNode, ...]
) -> Iterator[Choices | None]:
    if not needed:
        yield choices
        return
    for combination in product(*(candidates(problem, goal, node) for node in needed)):
        child = {**choices, **dict(zip(needed, combination, strict=True))}
        if in_circles(child, goal):
            yield None
        else:
            yield from further(problem, goal, child, still_needed(problem, goal, child))


def candidates(problem: SearchProblem, goal: ObjectNode, node: ObjectNode) -> list[KnownUnit | None]:
    number = problem.index.number_of[node]
    found: list[KnownUnit | None] = [problem.index.units[unit] for unit in problem.index.producers[number]]
    if node != goal and problem.index.gap_costs[number] is not None:
        found.append(None)
    return found


def still_needed(problem: SearchProblem, goal: ObjectNode, choices: Choices) -> tuple[ObjectNode, ...]:
    inputs = {node for known in choices.values() if known for node in known.unit.input_nodes}
    at_hand = dict(zip(problem.index.nodes, problem.index.at_hand, strict=True))
    there = {node for node in inputs if node != goal and (at_hand[node] or node in problem.available)}
    return tuple(sorted(inputs.difference(there, choices), key=lambda node: node.sort_key))


def in_circles(choices: Choices, goal: ObjectNode, above: frozenset[ObjectNode] = frozenset()) -> bool:
    if goal in above:
        return True
    known = choices.get(goal)
    return known is not None and any(in_circles(choices, node, above | {goal}) for node in known.unit.input_nodes)


def tree_of(problem: SearchProblem, goal: ObjectNode, choices: Choices) -> ReferenceTree:
    units = tuple({known.unit.key: known for known in choices.values() if known is not None}.values())
    gaps = tuple(sorted((node for node, known in choices.items() if known is None), key=lambda node: node.sort_key))
    costs = dict(zip(problem.index.nodes, problem.index.gap_costs, strict=True))
    labels = {node.label for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    covered = tuple(sorted({problem.wanted[label] for label in labels if label in problem.wanted}))
    return ReferenceTree(goal, units, gaps, sum(costs[gap] or 0 for gap in gaps), covered, exact=False)
