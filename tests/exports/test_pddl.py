"""A PDDL problem means what executing a tree means, whatever its names hold: with numbered things a real kitchen."""

from __future__ import annotations

import re

import pytest
from exports.odd_trees import plans, trees
from hypothesis import given, settings
from kitchen_stories import SALAD, node, subgraph
from pictures.demo_plans import demo_plan

from foon_kg.formats.exports.pddl import foon_to_pddl, tree_to_pddl
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model.errors import FormatError, UsageError
from foon_kg.model.tree import nodes_of
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()
NAME = re.compile(r"[a-z][a-z0-9_-]*")
TOKEN = re.compile(r"[()]|[^\s()]+")


def read(text):
    """Read one PDDL expression as nested lists, comments left out, in lower case as PDDL knows no other."""
    bare = "\n".join(line.partition(";")[0] for line in text.split("\n"))
    stack = [[]]
    for token in TOKEN.findall(bare.lower()):
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    assert len(stack) == 1, "brackets do not match"
    (expression,) = stack[0]
    return expression


def parts(expression, key):
    return [part[1:] for part in expression if isinstance(part, list) and part[0] == key]


def facts(condition):
    assert condition[0] == "and"
    return {fact[1] for fact in condition[1:]}


class Problem:
    """What a planner knows after reading the files: an interpreter of STRIPS without deleting, ten lines long."""

    def __init__(self, written):
        domain, problem = read(written.domain), read(written.problem)
        self.constants = [word for word in parts(domain, ":constants")[0] if NAME.fullmatch(word)]
        self.actions = {}
        for name, *body in parts(domain, ":action"):
            fields = dict(zip(body[::2], body[1::2], strict=True))
            assert fields[":parameters"] == []
            self.actions[name] = (facts(fields[":precondition"]), facts(fields[":effect"]))
        self.begin = {fact[1] for fact in parts(problem, ":init")[0]}
        self.goal = parts(problem, ":goal")[0][0]
        assert parts(domain, "domain") == parts(problem, ":domain")

    def reaches_the_goal_by(self, steps):
        there = set(self.begin)
        for step in steps:
            needs, makes = self.actions[step]
            if not needs <= there:
                return False
            there |= makes
        goals = self.goal[1:] if self.goal[0] == "or" else [self.goal]
        return any(name in there for _, name in goals)


def steps_of(plan):
    return [line.strip("()") for line in plan.splitlines() if line.startswith("(")]


def is_executable(plan):
    there = set(plan.kitchen)
    for unit in plan.units:
        if not there.issuperset(unit.input_nodes):
            return False
        there.update(unit.output_nodes)
    return plan.goal in there


@settings(max_examples=50, deadline=None)
@given(plans())
def test_our_order_is_a_valid_plan_exactly_when_every_input_is_there(plan):
    written = tree_to_pddl(ExportedTree.of_plan(plan))
    assert Problem(written).reaches_the_goal_by(steps_of(written.plan)) == is_executable(plan)


@settings(max_examples=25, deadline=None)
@given(trees)
def test_every_name_is_legal_and_unique_and_its_original_stands_beside_it(tree):
    if tree.goal is None:
        return
    written = tree_to_pddl(tree)
    problem = Problem(written)
    listed = [line.split() for line in written.domain.splitlines() if re.fullmatch(r"    n\d+\S* - \w+", line)]
    nodes = nodes_of(known.unit for known in tree.units)
    assert len(listed) == len({name for name, _, _ in listed}) == len({*nodes, *tree.kitchen, tree.goal})
    assert all(NAME.fullmatch(name) for name in problem.actions)
    assert len(problem.actions) == len(tree.units)
    assert steps_of(written.plan) == list(problem.actions)
    assert "".join(written.domain.split("\n")).isprintable()


def test_a_recorded_dish_becomes_a_problem_that_its_own_order_solves():
    tree = ExportedTree.of_subgraph(subgraph("salad", "salad", *SALAD), KITCHEN)
    written = tree_to_pddl(tree)
    problem, steps = Problem(written), steps_of(written.plan)
    assert steps[0] == "step_1_pick_and_place"
    assert problem.reaches_the_goal_by(steps)
    assert not problem.reaches_the_goal_by(steps[1:])
    assert not problem.reaches_the_goal_by(reversed(steps))


def test_types_tell_foods_from_utensils():
    tree = ExportedTree.of_subgraph(subgraph("salad", "salad", *SALAD), KITCHEN)
    domain = tree_to_pddl(tree).domain
    assert "; onion (chopped) [on: cutting board]\n    n" in domain
    assert re.search(r"n\d+_onion_chopped_on_cutting_board - food", domain)
    assert re.search(r"n\d+_knife - utensil", domain)


def test_a_tree_that_names_no_goal_is_no_problem():
    tree = ExportedTree.of_subgraph(subgraph("x", None, "onion(whole); knife > chop > onion(chopped)"), KITCHEN)
    with pytest.raises(FormatError, match="needs a goal"):
        tree_to_pddl(tree)


def test_of_a_whole_foon_any_goal_of_the_name_will_do_and_the_kitchen_has_what_it_has():
    foon = Snapshot.of(
        [
            subgraph("a", "salad", *SALAD),
            subgraph("b", "salad", "tomato(whole); knife > slice > salad(plain){tomato}@plate"),
            subgraph("c", "soup", "water > boil > soup{water}"),
        ],
        KITCHEN,
    )
    written = foon_to_pddl(foon, "salad")
    problem = Problem(written)
    assert written.plan is None
    assert problem.goal[0] == "or"
    assert len(problem.goal) == 3
    assert ":disjunctive-preconditions" in written.domain
    assert len(problem.actions) == len(foon.units)
    (slicing,) = [name for name in problem.actions if name.endswith("slice")]
    assert problem.reaches_the_goal_by([slicing])
    assert not problem.reaches_the_goal_by([])


def test_an_unknown_dish_is_answered_with_those_that_are_known():
    foon = Snapshot.of([subgraph("a", "salad", *SALAD)], KITCHEN)
    with pytest.raises(UsageError, match="no dish of this FOON is called “cake”") as raised:
        foon_to_pddl(foon, "cake")
    assert "salad" in raised.value.hint


def test_where_nobody_knows_which_bowl_is_which_nothing_is_used_up():
    tree = ExportedTree.of_subgraph(subgraph("salad", "salad", *SALAD), KITCHEN)
    assert "(not" not in tree_to_pddl(tree).domain
    assert node("onion(whole)") in tree.kitchen


def test_a_vessel_that_nobody_fills_is_at_hand_beside_its_food_and_a_mixture_that_nobody_makes_is_not():
    foon = Snapshot.of(
        [
            subgraph("a", "soup", "bowl{onion}; onion(whole)@bowl > boil > soup{onion}@pot"),
            subgraph("b", "salad", "egg mixture{egg,milk} > toss > salad{egg}@plate"),
        ],
        KITCHEN,
    )
    soup, salad = (Problem(foon_to_pddl(foon, goal)) for goal in ("soup", "salad"))
    assert any(soup.reaches_the_goal_by([step]) for step in soup.actions)
    assert not any(salad.reaches_the_goal_by([step]) for step in salad.actions)


def effects(expression):
    """What an effect makes, and what it ends."""
    assert expression[0] == "and"
    ends = {tuple(fact[1]) for fact in expression[1:] if fact[0] == "not"}
    return {tuple(fact) for fact in expression[1:] if fact[0] != "not"}, ends


class UsedKitchen:
    """An interpreter of STRIPS with deleting."""

    def __init__(self, written):
        domain, problem = read(written.domain), read(written.problem)
        self.actions = {}
        for name, *body in parts(domain, ":action"):
            fields = dict(zip(body[::2], body[1::2], strict=True))
            needs = {tuple(fact) for fact in fields[":precondition"][1:]}
            self.actions[name] = (needs, *effects(fields[":effect"]))
        self.begin = {tuple(fact) for fact in parts(problem, ":init")[0]}
        self.goal = {tuple(fact) for fact in parts(problem, ":goal")[0][0][1:]}

    def reaches_the_goal_by(self, steps):
        there = set(self.begin)
        for step in steps:
            needs, makes, ends = self.actions[step]
            if not needs <= there:
                return False
            there = (there - ends) | makes
        return self.goal <= there


@pytest.fixture(scope="module", params=["tomato_salad", "limeade"])
def kitchen_and_steps(request):
    written = tree_to_pddl(ExportedTree.of_plan(demo_plan(request.param)))
    return UsedKitchen(written), steps_of(written.plan)


def test_in_a_kitchen_of_numbered_things_our_order_is_a_plan_and_no_step_can_be_left_out(kitchen_and_steps):
    kitchen, steps = kitchen_and_steps
    assert kitchen.reaches_the_goal_by(steps)
    for step in steps:
        assert not kitchen.reaches_the_goal_by([other for other in steps if other != step])


def test_what_is_taken_is_gone_from_where_it_was(kitchen_and_steps):
    kitchen, steps = kitchen_and_steps
    there = set(kitchen.begin)
    for step in steps:
        _, makes, ends = kitchen.actions[step]
        there = (there - ends) | makes
        forms, places = ([fact[1] for fact in there if fact[0] in names] for names in (("is",), ("at", "unplaced")))
        assert len(forms) == len(set(forms))
        assert len(places) == len(set(places))
