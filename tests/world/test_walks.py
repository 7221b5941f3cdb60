"""What the judge says of random walks through a kitchen, of walks with one fault, and of steps that mean nothing."""

from __future__ import annotations

import random
import sys
from collections import Counter
from dataclasses import replace
from textwrap import dedent

import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from world.corruption import (
    doubled,
    dropped,
    left_whole,
    poured_twice,
    renamed,
    swapped,
    unlit,
)
from world.kitchen_things import VESSELS
from world.kitchen_walk import walks, without_numbers

from foon_kg.model import ObjectNode
from foon_kg.model.tree import TaskTree
from foon_kg.validation import TABLE, WORLD, check
from foon_kg.validation.notation import read_tree, write_tree
from foon_kg.world import Mention, Step, World

ROBOT = ("W1", "W2", "W3", "W4", "K4")

TO_BE_MENDED = frozenset({"same food in two", "between two of a kind"})
"""Operators at which the judge still refuses what is possible."""

NOT_TOLD_YET = frozenset(
    {
        ("a new state dropped", True), ("a new state dropped", False), ("a move dropped", False),
        ("a move between others dropped", True), ("a move between others dropped", False),
        ("a move between others swapped", False), ("a product dropped", True), ("a product dropped", False),
    }
)  # fmt: skip
"""Faults that the judge does not always see yet: of which kind, and whether in trees with numbers."""

MOST_CALLS = 600_000
"""How many functions may be called for a tree of 60 steps: walks take 35 000."""

possible = walks(TO_BE_MENDED)
numbered_or_not = pytest.mark.parametrize("numbered", [True, False])


def tree(lines, goal=None, *, numbered=True):
    told = lines if numbered else map(without_numbers, lines)
    return TaskTree("walk", tuple(map(step, told)), goal)


def step(line):
    inputs, outputs = (
        dict.fromkeys(Mention(told.node, told.thing, told.inside) for told in side)
        for side in (line.inputs, line.outputs)
    )
    return Step(tuple(inputs), line.motion, tuple(outputs))


def judged(walk, lines, *, numbered):
    return check(tree(lines, walk.goal, numbered=numbered))


def counted(report, fault):
    """How often the report tells what may tell the fault."""
    return Counter(finding.rule for finding in report.of(fault.rules) if fault.mild or not finding.minor)


@pytest.mark.slow
@numbered_or_not
@given(walk=possible)
def test_what_is_possible_is_never_refused(walk, numbered):
    report = judged(walk, walk.lines, numbered=numbered)
    refused = [finding for finding in report.of(ROBOT) if not finding.minor or finding.rule in {"W1", "W2"}]
    assert not refused, write_tree(tree(walk.lines, numbered=numbered))


@pytest.mark.slow
@numbered_or_not
@pytest.mark.parametrize("corrupt", [dropped, doubled, swapped, unlit, renamed, poured_twice, left_whole])
@examples(10)  # of each of fourteen kinds
@given(walk=possible, data=st.data())
def test_every_single_fault_is_told(walk, corrupt, numbered, data):
    faults = [fault for fault in corrupt(walk) if (fault.kind, numbered) not in NOT_TOLD_YET]
    if not faults:
        return
    fault = data.draw(st.sampled_from(faults))
    before = counted(judged(walk, walk.lines, numbered=numbered), fault)
    found = counted(judged(walk, fault.lines, numbered=numbered), fault)
    assert found - before, f"{fault.kind}: {fault.line}\n{write_tree(tree(fault.lines, numbered=numbered))}"


@pytest.mark.slow
@numbered_or_not
@given(walk=possible, chance=st.integers(0, 2**32).map(random.Random))
def test_the_order_of_inputs_and_outputs_does_not_matter(walk, numbered, chance):
    def shuffled(line):
        inputs, outputs = (tuple(chance.sample(side, len(side))) for side in (line.inputs, line.outputs))
        return replace(line, inputs=inputs, outputs=outputs)

    one = judged(walk, walk.lines, numbered=numbered)
    other = judged(walk, tuple(map(shuffled, walk.lines)), numbered=numbered)
    assert said(other) == said(one)


def said(report):
    return {(finding.rule, finding.step, finding.minor) for finding in report.of((*WORLD, *TABLE))}


words = st.sampled_from(
    ("tomato", "egg", "salt", "water", "flour", "dough", "salad", "soup", "omelette", "pasta", "lemon juice", *VESSELS,
     "shaker", "bottle", "spoon", "knife", "grater", "blender", "stove", "oven", "faucet", "fridge", "lid", "foil", "")
) | st.text(max_size=6)  # fmt: skip
states = st.sampled_from(
    ("whole", "raw", "chopped", "grated", "mixed", "cooked", "boiled", "hot", "empty", "on", "off", "covered", "liquid",
     "remains", "skin", "in [bowl]", "on [stove]", "covered [pot lid]", "ready")
) | st.text(max_size=4)  # fmt: skip
motions = st.sampled_from(
    ("pour", "pick-and-place", "sprinkle", "scoop and pour", "mix", "cut", "grate", "peel", "crack", "squeeze", "drain",
     "boil", "bake", "fry", "heat", "blend", "turn on", "turn off", "attach", "detach", "cover", "uncover", "remove",
     "throw away", "open", "separate", "knead", "")
) | st.text(max_size=6)  # fmt: skip
nodes = st.builds(
    ObjectNode,
    words,
    st.lists(states, max_size=3).map(tuple),
    st.lists(words, max_size=4).map(tuple),
    st.none() | st.sampled_from(("in", "on", "under", "with", "from", "attached to", "covered")),
    st.none() | words,
)
numbers = st.none() | st.integers(0, 5)
sides = st.lists(st.builds(Mention, nodes, numbers, numbers), max_size=5).map(tuple)
units = st.builds(Step, sides, motions, sides)


@pytest.mark.slow
@given(st.lists(units, max_size=8).map(tuple), st.none() | nodes)
def test_steps_that_mean_nothing_are_judged_as_well_and_twice_alike(steps, goal):
    one = TaskTree("noise", steps, goal)
    report = check(one)
    assert report.accepted == (report.robot and report.cook)
    assert check(one) == report == check(TaskTree("noise", steps, goal))


@pytest.mark.slow
@given(walk=possible)
def test_a_walk_is_accepted_where_robot_and_cook_both_accept_it(walk):
    report = judged(walk, walk.lines, numbered=True)
    assert report.robot
    assert report.accepted == report.cook
    assert report == judged(walk, walk.lines, numbered=True)


@pytest.mark.slow
@examples(20)
@given(st.lists(units, min_size=1, max_size=6))
def test_the_work_for_sixty_steps_is_bounded(steps):
    """Six steps that go on from each other again and again: what grows with every round would show."""
    one = TaskTree("rounds", tuple((steps * 60)[:60]))
    assert calls_of(lambda: check(one)) < MOST_CALLS


def calls_of(work):
    """Count the calls of functions, and give up where they are too many."""
    called = 0

    def count(_frame, event, _argument):
        nonlocal called
        called += event == "call"
        if called > MOST_CALLS:
            sys.setprofile(None)
            raise AssertionError("it never ends")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        work()
    finally:
        sys.setprofile(before)
    return called


def test_what_is_divided_and_joined_again_does_not_grow():
    told = """
        dough (raw; {egg, flour}; in bowl) + bowl ({dough}) → DIVIDE → crust (in bowl) + bread (in bowl)
        crust (in bowl) + bread (in bowl) + bowl ({bread, crust}) → KNEAD
          → dough (raw; {egg, flour}; in bowl) + bowl ({dough})
    """
    world = World()
    for unit in read_tree(dedent(told)).units * 30:
        world.play(unit)
    assert len(world.supply.parts) < 5 * 60
