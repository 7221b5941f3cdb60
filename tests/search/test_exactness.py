"""The everyday search against two oracles that share nothing with it: all paths, and all subsets of units."""

import itertools
from collections.abc import Iterator
from dataclasses import replace
from operator import attrgetter

import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from search_problems import NODES, deep_problems, problems, unit

from foon_kg.model import ObjectNode
from foon_kg.search import Explored, NoWayError, ReferenceTree, SearchProblem, UnitIndex, enumerate_paths, retrieve

PATHS = 5_000


def answer(problem: SearchProblem, explored: Explored | None = None) -> ReferenceTree | None:
    try:
        return retrieve(problem, time_limit=None, explored=explored)
    except NoWayError:
        return None


@pytest.mark.slow
@examples(120)
@given(problems() | deep_problems())
def test_the_search_gives_the_tree_that_enumerating_every_path_gives(problem):
    enumeration = enumerate_paths(problem, limit=PATHS)
    found = answer(problem)
    if not enumeration.complete:
        return
    assert found == (enumeration.trees[0] if enumeration.trees else None)


@pytest.mark.slow
@examples(60)
@given(problems() | deep_problems())
def test_out_of_time_the_answer_is_a_tree_and_what_is_said_to_be_proven_holds(problem):
    best = answer(problem)
    if best is None:
        return
    hurried = retrieve(problem, time_limit=-1.0)
    assert hurried.rank >= best.rank
    if hurried.exact:
        assert hurried == best
        return
    assert hurried.bound.penalty <= best.penalty
    assert hurried.bound.overlap >= best.overlap
    assert hurried.bound.units <= len(best.units)


@examples(40)
@given(problems(), st.lists(st.sampled_from(NODES[:8]), min_size=2, max_size=5))
def test_the_best_of_several_targets_is_the_best_of_each_alone(problem, targets):
    alone = [answer(replace(problem, targets=(target,), wanted={})) for target in targets]
    trees = [tree for tree in alone if tree is not None]
    best = answer(replace(problem, targets=tuple(targets), wanted={}))
    assert best == min(trees, key=attrgetter("rank"), default=None)


@examples(24)
@given(problems(), st.lists(st.dictionaries(st.sampled_from("abcdefgh"), st.integers(0, 3)), min_size=2, max_size=5))
def test_what_was_found_for_one_question_changes_no_answer_to_the_next(problem, wishes):
    explored = Explored()
    for wanted in wishes:
        question = replace(problem, wanted=wanted)
        assert answer(question, explored) == answer(question)


@examples(60)
@given(problems(max_units=7, max_nodes=7))
def test_no_subset_of_the_units_is_a_better_tree(problem):
    ranks = [rank for target in set(problem.targets) for rank in ranks_of_all_subsets(problem, target)]
    found = answer(problem)
    assert (None if found is None else found.rank) == min(ranks, default=None)


def ranks_of_all_subsets(problem: SearchProblem, goal: ObjectNode) -> Iterator[tuple]:
    """The rank of every valid tree, found by trying every set of units and gaps with every choice of producers."""
    if goal in problem.available:
        yield (0, 0, 0, (), (), goal.sort_key)
        return
    index = problem.index
    there = {n for n, has in zip(index.nodes, index.at_hand, strict=True) if has} | problem.available
    costs = {n: cost for n, cost in zip(index.nodes, index.gap_costs, strict=True) if cost and n not in there | {goal}}
    for units in subsets(index.units):
        inputs = {n for known in units for n in known.unit.input_nodes}
        needed = ({goal} | inputs) - (there - {goal})
        for gaps in subsets([n for n in index.nodes if n in costs and n in needed]):
            if some_choice_uses_all(needed.difference(gaps), units, goal):
                nodes = inputs | {n for known in units for n in known.unit.output_nodes}
                covered = {problem.wanted[n.label] for n in nodes if n.label in problem.wanted}
                keys = tuple(sorted(known.unit.key for known in units))
                penalty = sum(costs[n] for n in gaps)
                yield (penalty, -len(covered), len(units), keys, tuple(n.sort_key for n in gaps), goal.sort_key)


def some_choice_uses_all(needed, units, goal) -> bool:
    nodes = sorted(needed, key=lambda n: n.sort_key)
    producers = [[known for known in units if node in known.unit.output_nodes] for node in nodes]
    for choice in itertools.product(*producers):
        if set(choice) == set(units) and can_be_ordered(dict(zip(nodes, choice, strict=True)), goal):
            return True
    return False


def can_be_ordered(choice, goal) -> bool:
    """Whether the chosen producers can be run one after another, and each is needed on the way to the goal."""
    made: set[ObjectNode] = set()
    while True:
        more = {n for n, known in choice.items() if all(i in made or i not in choice for i in known.unit.input_nodes)}
        if more <= made:
            break
        made |= more
    reached, waiting = {goal}, [goal]
    while waiting:
        for node in choice[waiting.pop()].unit.input_nodes:
            if node in choice and node not in reached:
                reached.add(node)
                waiting.append(node)
    return made == set(choice) == reached


def subsets(items):
    return itertools.chain.from_iterable(itertools.combinations(items, n) for n in range(len(items) + 1))


@pytest.mark.slow
@examples(60)
@given(problems(max_units=14, max_nodes=10) | deep_problems())
def test_every_tree_is_executable_connected_and_ends_with_its_goal(problem):
    tree = answer(problem)
    if tree is None or tree.goal in problem.available:
        return
    index = problem.index
    have = {n for n, has in zip(index.nodes, index.at_hand, strict=True) if has} | problem.available | set(tree.gaps)
    have -= {tree.goal}
    for known in tree.units:
        assert have.issuperset(known.unit.input_nodes)
        have.update(known.unit.output_nodes)
    assert tree.goal in tree.units[-1].unit.output_nodes
    keys = [known.unit.key for known in tree.units]
    assert len(keys) == len(set(keys))
    useful, apart = {tree.goal}, list(tree.units)  # C3 asks for a chain to the goal, whichever unit makes a node first
    while leading := [known for known in apart if not useful.isdisjoint(known.unit.output_nodes)]:
        useful.update(node for known in leading for node in known.unit.input_nodes)
        apart = [known for known in apart if known not in leading]
    assert apart == []


@pytest.mark.slow
@examples(60)
@given(problems(), st.randoms(use_true_random=False))
def test_the_order_of_the_units_does_not_matter(problem, random):
    units = list(problem.index.units)
    random.shuffle(units)
    there = dict(zip(problem.index.nodes, problem.index.at_hand, strict=True))
    costs = dict(zip(problem.index.nodes, problem.index.gap_costs, strict=True))
    index = UnitIndex.of([*units, *units[:2]], at_hand=there.__getitem__, gap_cost=costs.get)
    shuffled = SearchProblem(index, tuple(reversed(problem.targets)), problem.wanted, problem.available)
    assert answer(shuffled) == answer(problem)


@pytest.mark.parametrize("limit", [0, 3])
def test_an_enumeration_that_is_cut_off_says_so(limit):
    goal, made = NODES[0], NODES[1]
    units = [unit([made], [goal]), *(unit([NODES[k]], [made]) for k in range(2, 9))]
    problem = SearchProblem(UnitIndex.of(units, at_hand=set(NODES[2:]).__contains__), (goal,))
    assert not enumerate_paths(problem, limit=limit).complete
    assert len(enumerate_paths(problem, limit=7).trees) == 7
