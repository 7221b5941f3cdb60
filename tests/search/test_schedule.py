"""The order of execution: what spoils a node waits for those that need it."""

import itertools
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from search_problems import NODES
from search_problems import unit as known_unit

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant
from foon_kg.search import schedule


def unit(inputs: str, motion: str, outputs: str) -> KnownUnit:
    sides = (tuple(Participant(ObjectNode(name)) for name in side.split()) for side in (inputs, outputs))
    return KnownUnit(FunctionalUnit(next(sides), motion, next(sides)), ())


def motions(units, there: str, goal: str) -> list[str]:
    return [k.unit.motion for k in schedule(units, {ObjectNode(name) for name in there.split()}, ObjectNode(goal))]


def test_a_unit_that_uses_a_node_up_waits_for_those_that_need_it():
    make = unit("raw", "make", "dough")
    taste = unit("dough", "taste", "dough opinion")
    bake = unit("dough", "bake", "bread")
    serve = unit("bread opinion", "serve", "dish")
    assert motions([bake, serve, taste, make], "raw", "dish") == ["make", "taste", "bake", "serve"]


def test_the_makers_of_the_goal_come_last_even_if_they_could_run_before():
    early = unit("raw", "early", "half goal")
    last = unit("half", "last", "goal other")
    assert motions([last, early], "raw", "goal") == ["early", "last"]


def test_the_order_does_not_depend_on_the_order_of_asking():
    units = [unit("raw", f"cut{k}", f"piece{k}") for k in range(4)]
    units.append(unit("piece0 piece1 piece2 piece3", "mix", "dish"))
    orders = {tuple(motions(order, "raw", "dish")) for order in itertools.permutations(units)}
    assert len(orders) == 1


def test_a_line_of_work_is_carried_on():
    units = [unit(f"raw{k}", f"wash{k}", f"clean{k}") for k in range(3)]
    units += [unit(f"clean{k}", f"chop{k}", f"cut{k}") for k in range(3)]
    units.append(unit("cut0 cut1 cut2", "mix", "dish"))
    order = motions(units, "raw0 raw1 raw2", "dish")
    assert [motion[-1] for motion in order[:-1]] in [
        [*"xxyyzz".translate(str.maketrans("xyz", "".join(p)))] for p in itertools.permutations("012")
    ]


def test_units_that_wait_for_each_other_have_no_order():
    with pytest.raises(ValueError, match="no order"):
        motions([unit("b", "one", "a"), unit("a", "two", "b"), unit("a", "end", "goal")], "", "goal")


def test_nothing_to_do_is_an_order():
    assert motions([], "raw", "raw") == []


side = st.lists(st.sampled_from(NODES), min_size=1, max_size=3, unique=True)
some_units = st.lists(
    st.builds(known_unit, side, side, st.sampled_from("xyz")), min_size=1, max_size=9, unique_by=lambda k: k.unit.key
)


@settings(max_examples=200, deadline=None)
@given(some_units, st.sets(st.sampled_from(NODES), min_size=2), st.sampled_from(NODES))
def test_the_order_is_the_one_that_asking_every_unit_before_every_step_gives(units, there, goal):
    there = there - {goal}
    expected = order_by_scanning(units, there, goal)
    if expected is None:
        with pytest.raises(ValueError, match="no order"):
            schedule(units, there, goal)
    else:
        assert list(schedule(units, there, goal)) == expected


def order_by_scanning(units, there, goal):
    by_key = sorted(units, key=lambda known: known.unit.key)
    for last in by_key:
        others = [known for known in by_key if known is not last]
        if goal in last.unit.output_nodes and scanned(others, last, there, patient=False) is not None:
            order = [*scanned(others, last, there, patient=False), last]
            leads_on = (
                any(set(known.unit.output_nodes) & set(later.unit.input_nodes) for later in order[place + 1 :])
                for place, known in enumerate(order[:-1])
            )
            return order if all(leads_on) else [*scanned(others, last, there, patient=True), last]
    return None


def scanned(others, last, there, *, patient):
    """Before every step, ask every unit whether it can run and how urgent it is."""
    waiting, have, order, fresh = list(others), set(there), [], set()
    while waiting:
        ready = [known for known in waiting if have.issuperset(known.unit.input_nodes)]
        needed = Counter(node for known in (*waiting, last) for node in known.unit.input_nodes)

        def urgency(known, needed=needed, fresh=fresh, waiting=tuple(waiting)):
            inputs = known.unit.input_nodes
            late = patient and any(set(o.unit.output_nodes) & set(inputs) for o in waiting if o is not known)
            gone = [node for node in inputs if node not in known.unit.output_nodes]
            made = sum(needed[node] - 1 for node in gone if node not in there)
            found = sum(needed[node] - 1 for node in gone if node in there)
            return late, made, found, fresh.isdisjoint(inputs), known.unit.key

        if not ready:
            return None
        order.append(min(ready, key=urgency))
        waiting.remove(order[-1])
        fresh = set(order[-1].unit.output_nodes)
        have |= fresh
    return order
