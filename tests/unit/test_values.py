"""Values that are made often: dataclasses like others, but nobody watches over them while they run."""

from __future__ import annotations

import pickle
from dataclasses import replace

from foon_kg.model.values import made_often


@made_often()
class Pair:
    left: int
    right: int = 0


@made_often(eq=False)
class Thing:
    name: str


def test_two_with_equal_fields_are_one_in_a_set():
    assert {Pair(1), Pair(1, 0), Pair(1, 2)} == {Pair(1), Pair(1, 2)}


def test_one_without_equality_is_equal_to_itself_alone():
    cup = Thing("cup")
    assert cup != Thing("cup")
    assert {cup, Thing("cup"), cup} - {cup} != set()


def test_equal_ones_are_equal_whoever_made_them():
    assert Pair(1, 2) == Pair(left=1, right=2)
    assert Pair(1, 2) != Pair(2, 1)


def test_they_are_replaced_and_travel_between_processes():
    assert replace(Pair(1), right=3) == Pair(1, 3)
    assert pickle.loads(pickle.dumps(Pair(1, 3))) == Pair(1, 3)
