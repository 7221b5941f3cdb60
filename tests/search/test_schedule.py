"""The order of execution: what spoils a node waits for those that need it."""

import itertools

import pytest

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
