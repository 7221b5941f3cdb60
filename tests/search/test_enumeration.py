"""Enumeration beside the exact search: what ``foon plan --enumerate`` shows."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from search.test_exactness import NODES, PATHS, answer, deep_problems, problems, unit

from foon_kg.search import SearchProblem, UnitIndex, enumerate_paths, with_gaps_of


@pytest.mark.slow
@settings(max_examples=100, deadline=None)
@given(problems() | deep_problems())
def test_with_no_other_gaps_than_the_best_trees_the_best_is_the_same(problem):
    best = answer(problem)
    if best is None:
        return
    fewer = with_gaps_of(problem, best)
    found = enumerate_paths(fewer, limit=PATHS)
    if not found.complete:
        return
    assert found.trees[0] == best
    assert answer(fewer) == best
    assert all(set(tree.gaps) <= set(best.gaps) for tree in found.trees)


@settings(max_examples=60, deadline=None)
@given(problems())
def test_candidates_are_in_order_and_executable(problem):
    found = enumerate_paths(problem, limit=200)
    ranks = [tree.rank for tree in found.trees]
    assert ranks == sorted(set(ranks))
    assert [tree.exact for tree in found.trees] == [found.complete and not n for n in range(len(ranks))]
    assert found.first(2) == found.trees[:2]
    assert [tree.rank for tree in found.found] == ranks
    index = problem.index
    there = {n for n, has in zip(index.nodes, index.at_hand, strict=True) if has} | problem.available
    for tree in found.trees:
        have = there.union(tree.gaps) - {tree.goal}
        for known in tree.units:
            assert have.issuperset(known.unit.input_nodes)
            have.update(known.unit.output_nodes)


def wide(count):
    """A goal made of one object that ``count`` units make."""
    goal, made = NODES[0], NODES[1]
    units = [unit([made], [goal]), *(unit([NODES[k]], [made]) for k in range(2, 2 + count))]
    return SearchProblem(UnitIndex.of(units, at_hand=set(NODES[2:]).__contains__), (goal,))


@pytest.mark.parametrize(("limit", "complete"), [(0, False), (6, False), (7, True), (8, True)])
def test_it_looks_at_no_more_combinations_than_allowed_and_says_whether_these_were_all(limit, complete):
    found = enumerate_paths(wide(7), limit=limit)
    assert (found.complete, found.looked_at, len(found.trees)) == (complete, min(limit, 7), min(limit, 7))


def test_a_tree_that_was_found_before_all_were_looked_at_is_not_called_the_best():
    for limit, problem in itertools.product(range(1, 7), [wide(7)]):
        assert not any(tree.exact for tree in enumerate_paths(problem, limit=limit).trees)
