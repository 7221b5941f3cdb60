"""Enumeration beside the exact search: what ``foon plan --enumerate`` shows."""

from __future__ import annotations

import itertools
from dataclasses import replace

import pytest
from examples import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from search.paths_by_definition import paths_by_definition
from search.test_exactness import NODES, PATHS, answer, deep_problems, problems, unit

from foon_kg.search import SearchProblem, UnitIndex, enumerate_paths, with_gaps_of


@examples(80)
@given(problems() | deep_problems() | problems(max_units=14, max_nodes=10), st.sampled_from([0, 1, 3, 10, 50, PATHS]))
def test_trees_their_order_and_what_was_looked_at_are_those_of_the_definition(problem, limit):
    trees, complete, looked_at = paths_by_definition(problem, limit)
    found = enumerate_paths(problem, limit=limit)
    assert (found.complete, found.looked_at) == (complete, looked_at)
    assert [replace(tree, exact=False) for tree in found.found] == trees


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


def test_what_a_later_choice_needs_of_an_earlier_one_is_seen_when_that_goes_in_circles():
    goal, first, second, below, there = NODES[:5]
    units = [unit([first, second], [goal]), unit([below], [first]), unit([first], [second])]
    units += [unit([second], [below]), unit([there], [below])]
    problem = SearchProblem(UnitIndex.of(units, at_hand={there}.__contains__), (goal,))
    found = enumerate_paths(problem, limit=PATHS)
    assert (len(found.trees), found.looked_at) == (1, 2)
    assert units[3] not in found.trees[0].units
