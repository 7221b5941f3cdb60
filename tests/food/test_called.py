"""Dishes by their own names: of which of the 30 dish types they are."""

from __future__ import annotations

from collections import Counter

import pytest

from foon_kg.food import singular
from foon_kg.food.called import dish_type_called
from foon_kg.food.shipped import shipped
from foon_kg.model import DISH_TYPES


@pytest.mark.parametrize(
    ("name", "dish_type"),
    [
        ("mushroom risotto", "rice"),
        ("Tacos", "sandwich"),
        ("fries", "potatoes"),
        ("shepherd's pie", "pie"),
        ("rice pudding", "pudding"),
        ("chicken fried steak", "steak"),
        ("potato salad", "salad"),
        ("Drink", "drinks"),
        ("stir fry", "stir-fry"),
        ("xyzzy", None),
        ("risotto xyzzy", None),
        ("", None),
    ],
)
def test_the_longest_name_at_the_end_says_the_type(name, dish_type):
    assert dish_type_called(name) == dish_type


def test_every_name_is_of_one_type_that_is_there_and_of_no_other():
    rows = shipped("called")["dish_types"]
    assert set(rows) <= set(DISH_TYPES)
    names = Counter(singular(name) for names in rows.values() for name in names)
    assert {name for name, times in names.items() if times > 1} == set()
    assert set(names).isdisjoint(map(singular, DISH_TYPES))
