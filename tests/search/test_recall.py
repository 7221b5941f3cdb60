"""A tree from memory is the tree that a search finds; whatever could make it another one asks for a search."""

from __future__ import annotations

from dataclasses import replace

import pytest
from examples import examples
from hypothesis import assume, given
from hypothesis import strategies as st
from search_problems import NODES, deep_problems, problems, unit

from foon_kg.search import NoWayError, SearchProblem, UnitIndex, retrieve, retrieve_once

often = examples(60)


class Memory:
    """What was remembered, and what was asked."""

    def __init__(self):
        self.trees, self.searched = {}, 0

    def remembered(self, question):
        return self.trees.get(question)

    def remember(self, tree):
        self.searched += 1
        self.trees[tree.question] = tree


def found(problem, memory=None):
    try:
        return retrieve_once(problem, memory, time_limit=None)
    except NoWayError:
        return None


def one_target(problem):
    return replace(problem, targets=problem.targets[:1], available=frozenset())


def problem_of(problem, units=None, costs=None, there=None):
    """The same problem with other units, gap costs or things at hand."""
    index = problem.index
    costs = dict(zip(index.nodes, index.gap_costs, strict=True)) | (costs or {})
    there = dict(zip(index.nodes, index.at_hand, strict=True)) | (there or {})
    changed = UnitIndex.of(
        index.units if units is None else units, at_hand=lambda node: there.get(node, False), gap_cost=costs.get
    )
    return SearchProblem(changed, problem.targets, problem.wanted)


@pytest.mark.slow
@often
@given(problems() | deep_problems())
def test_asked_again_the_tree_is_the_same_and_nothing_is_searched(problem):
    problem, memory = one_target(problem), Memory()
    first = found(problem, memory)
    assume(first is not None)
    assert memory.searched == 1
    again = found(problem_of(problem), memory)
    assert again == first == retrieve(problem, time_limit=None)
    assert memory.searched == 1


node = st.sampled_from(NODES)
side = st.lists(node, min_size=1, max_size=2, unique=True)
changes = st.fixed_dictionaries(
    {},
    optional={
        "added": st.lists(st.builds(unit, side, side), min_size=1, max_size=2),
        "gone": st.integers(0, 8),
        "costs": st.dictionaries(node, st.sampled_from([None, 1, 7]), min_size=1, max_size=2),
        "there": st.dictionaries(node, st.booleans(), min_size=1, max_size=2),
    },
)


@pytest.mark.slow
@examples(120)
@given(problems() | deep_problems(), changes)
def test_whatever_changes_in_between_the_answer_is_that_of_a_search(problem, change):
    problem, memory = one_target(problem), Memory()
    found(problem, memory)
    units = [known for number, known in enumerate(problem.index.units) if number != change.get("gone")]
    changed = problem_of(problem, [*units, *change.get("added", ())], change.get("costs"), change.get("there"))
    assert found(changed, memory) == found(changed)


@pytest.mark.slow
@often
@given(problems())
def test_other_wishes_are_another_question(problem):
    problem, memory = one_target(problem), Memory()
    found(problem, memory)
    others = {name: 1 - number for name, number in problem.wanted.items() if number < 2}
    for wanted in ({}, {NODES[0].label: 0}, others):
        other = replace(problem, wanted=wanted)
        assert found(other, memory) == found(other)


def test_what_is_not_proven_is_not_remembered():
    units = [unit([NODES[i]], [NODES[i + 1], NODES[(i + k) % 10]], f"way {k}") for i in range(9) for k in (3, 5)]
    index = UnitIndex.of(units, at_hand={NODES[0]}.__contains__)
    problem, memory = SearchProblem(index, (NODES[9],), {"b": 0, "e": 1, "h": 2}), Memory()
    assert not retrieve_once(problem, memory, time_limit=0.0).exact
    assert not memory.trees
    assert retrieve_once(problem, memory, time_limit=None).exact
    assert len(memory.trees) == 1
