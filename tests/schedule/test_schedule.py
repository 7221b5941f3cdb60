"""A schedule keeps the order of steps, gives nobody two things to do at once, and is never slower than one by one."""

from __future__ import annotations

import itertools

import pytest
from foons import units as any_units
from hypothesis import given, settings
from hypothesis import strategies as st

from foon_kg.model import ObjectNode
from foon_kg.model.errors import UsageError
from foon_kg.model.tree import Mention, Step, leaves_of
from foon_kg.plans.durations import Duration, Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.schedule import UNTIMED, WITHOUT_HANDS, schedule
from foon_kg.plans.step_order import earlier_steps

KITCHEN = Kitchen.default()


def took(seconds):
    return Duration(float(seconds), float(seconds), float(seconds), 3)


TIMES = Durations({"chop": took(8), "mix": took(5), "bake": took(60), "boil": took(30)}, took(7))


def step(motion, inputs, outputs):
    nodes = [
        tuple(ObjectNode(*one) if isinstance(one, tuple) else ObjectNode(one) for one in s) for s in (inputs, outputs)
    ]
    return Step.of(nodes[0], motion, nodes[1], "foon", ())


def planned(units, hands=1, times=TIMES):
    return schedule(units, leaves_of(tuple(units)), times, KITCHEN, hands)


SALAD = (
    step("chop", ["onion"], [("onion", ("chopped",))]),
    step("chop", ["tomato"], [("tomato", ("chopped",))]),
    step("mix", [("onion", ("chopped",)), ("tomato", ("chopped",))], ["salad"]),
)


def test_two_pairs_of_hands_chop_side_by_side():
    one, two = planned(SALAD), planned(SALAD, hands=2)
    assert (one.length, two.length, two.alone) == (21, 13, 21)
    assert one.shortest
    assert two.shortest
    assert {done.hands for done in two.steps[:2]} == {0, 1}


def test_one_knife_is_in_one_hand_and_a_second_helps():
    units = [
        step("chop", [food, knife], [(food, ("chopped",)), knife])
        for food, knife in (("onion", "knife"), ("tomato", "knife"))
    ]
    assert planned(units, hands=2).length == 16
    units[1] = step("chop", ["tomato", ("knife", ("clean",))], [("tomato", ("chopped",))])
    assert planned(units, hands=2).length == 8


def test_what_bakes_by_itself_leaves_the_hands_free():
    units = (
        step("chop", ["onion"], [("onion", ("chopped",))]),
        step("bake", ["bread"], [("bread", ("baked",))]),
        step("mix", [("onion", ("chopped",)), ("bread", ("baked",))], ["salad"]),
    )
    plan = planned(units)
    assert plan.length == 65
    assert [done.hands for done in plan.steps] == [0, None, 0] or [done.hands for done in plan.steps] == [None, 0, 0]


def test_the_order_of_the_tree_is_kept_where_another_is_no_shorter():
    units = [step(motion, [food], [(food, ("done",))]) for motion, food in (("mix", "a"), ("chop", "b"), ("mix", "c"))]
    assert [done.place for done in planned(units).steps] == [0, 1, 2]


def test_an_appliance_is_turned_off_as_soon_as_it_is_done():
    stove = ("stove", ("off",)), ("stove", ("on",))
    units = [
        step("turn on", [stove[0]], [stove[1]]),
        step("boil", [stove[1], "egg"], [stove[1], ("egg", ("cooked",))]),
        *(step("chop", [food], [(food, ("chopped",))]) for food in "abcdef"),
        step("turn off", [stove[1], ("egg", ("cooked",))], [stove[0], ("egg", ("cooked",))]),
    ]
    when = {done.place: done for done in planned(units).steps}
    assert when[8].start - when[1].end < 8  # the hands end what they have begun


def test_a_motion_that_nobody_timed_takes_as_long_as_a_usual_step_and_says_so():
    (done,) = planned([step("flambé", ["pear"], ["dessert"])]).steps
    assert (done.end, done.duration) == (7, None)
    assert planned([step("flambé", ["pear"], ["dessert"])], times=Durations({}, None)).length == UNTIMED


def test_nobody_cooks_without_hands():
    with pytest.raises(UsageError, match="0 pairs of hands"):
        planned(SALAD, hands=0)


units = st.lists(any_units, min_size=1, max_size=6)
motions = st.sampled_from(["chop", "mix", "bake", "pour"])


@st.composite
def trees(draw):
    return [Step.of(unit.input_nodes, draw(motions), unit.output_nodes, "foon", ()) for unit in draw(units)]


def at(plan, moment):
    return [done for done in plan.steps if done.start <= moment < done.end]


@pytest.mark.slow
@given(trees(), st.integers(1, 3))
def test_every_schedule_can_be_carried_out(tree, hands):
    plan = planned(tree, hands)
    assert sorted(done.place for done in plan.steps) == list(range(len(tree)))
    ends = {done.place: done.end for done in plan.steps}
    before = earlier_steps(tree)
    leaves = leaves_of(tuple(tree))
    for done in plan.steps:
        assert all(ends[earlier] <= done.start for earlier in before[done.place])
        together = at(plan, done.start)
        busy = [other.hands for other in together if other.hands is not None]
        assert len(busy) == len(set(busy)) <= hands
        assert all((other.hands is None) == (tree[other.place].motion in WITHOUT_HANDS) for other in together)
        for label in {node.label for other in together for node in tree[other.place].input_nodes}:
            if KITCHEN.is_utensil(label):
                users = [o for o in together if any(n.label == label for n in tree[o.place].input_nodes)]
                assert len(users) <= max(1, sum(leaf.label == label for leaf in leaves))
    assert plan.length == max(ends.values()) <= plan.alone


def in_this_order(tree, order, hands):
    """How long it takes when the steps of ``order`` begin one by one, none before the one in front of it: an oracle."""
    before, leaves, running, clock = earlier_steps(tree), leaves_of(tuple(tree)), {}, 0.0
    seconds = [TIMES.by_motion.get(unit.motion, TIMES.overall).median for unit in tree]
    labels = [{n.label for n in unit.input_nodes if KITCHEN.is_utensil(n.label)} for unit in tree]

    def may_start(i):
        now = [j for j, end in running.items() if end > clock]
        handy = [j for j in now if tree[j].motion not in WITHOUT_HANDS]
        free = tree[i].motion in WITHOUT_HANDS or len(handy) < hands
        tools = all(
            sum(label in labels[j] for j in now) < max(1, sum(leaf.label == label for leaf in leaves))
            for label in labels[i]
        )
        return free and tools and all(j in running and running[j] <= clock for j in before[i])

    for i in order:
        while not may_start(i):
            later = [end for end in running.values() if end > clock]
            if not later:
                return float("inf")  # an order that does not wait as it should
            clock = min(later)
        running[i] = clock + seconds[i]
    return max(running.values())


@settings(max_examples=40)
@given(st.lists(st.tuples(any_units, motions), min_size=1, max_size=5), st.integers(1, 2))
def test_a_schedule_that_says_it_is_the_shortest_is(rows, hands):
    tree = [Step.of(u.input_nodes, motion, u.output_nodes, "foon", ()) for u, motion in rows]
    plan = planned(tree, hands)
    best = min(in_this_order(tree, order, hands) for order in itertools.permutations(range(len(tree))))
    assert plan.length >= best
    if plan.shortest:
        assert plan.length == best


def on_the_stove(vessel, stove="stove"):
    """What boils in a vessel on a stove that has the number 9."""
    source = ObjectNode(stove, ("on",), (), "under" if stove == "stove" else None, "pot")
    taken = (
        Mention(ObjectNode("water"), vessel + 10, vessel),
        Mention(source, 9, vessel if stove == "stove" else None),
    )
    made = (Mention(ObjectNode("water", ("boiling",)), vessel + 10, vessel),)
    return Step(taken, "boil", made, "foon", ())


def test_a_stove_has_a_burner_for_each_vessel_and_an_oven_is_there_once():
    assert planned([on_the_stove(1), on_the_stove(2)]).length == 30
    assert planned([on_the_stove(1, "oven"), on_the_stove(2, "oven")]).length == 60
