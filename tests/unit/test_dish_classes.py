"""The dish classes of a title: the last one of its main part is sure, the others are possible."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.food.dish_classes import dish_classes
from foon_kg.model import DISH_TYPES

SURE = {
    "Chicken Noodle Soup with Bread": "soup",
    "Grandma's Potato Salad": "salad",
    "Salad with Chicken": "salad",
    "Egg Salad Sandwiches": "sandwich",
    "Beef Stir-Fry": "stir-fry",
    "Mini Meat Loaves": "meatloaf",
    "Meatball Sub": "sandwich",
    "Spinach & Feta Frittata": "omelette",
    "Iced Tea": "drinks",
    "Berry Smoothies": "drinks",
    "Coffee Cake": "cake",
    "Brownies": "cake",
    "Banana Bread": "bread",
    "Bread Pudding": "pudding",
    "French Fries": "potatoes",
    "Whoopie Pies": "cookie",
    "Cherry Pies": "pie",
    "Crème Brûlée": "pudding",
    "Tortilla Española": "omelette",
    "Macaroni and Cheese": "pasta",
    "T-Bone Steaks": "steak",
    "Hot Dogs": "sausage",
    "Sloppy Joes": "burger",
    "Pork Chops in Apple Sauce": "pork",
    "Potato Chip Cookies": "cookie",
    "CHICKEN   CASSEROLE": "casserole",
}


@pytest.mark.parametrize(("title", "sure"), SURE.items())
def test_the_sure_class_of_a_title(title, sure):
    assert [dish.name for dish in dish_classes(title) if dish.sure] == [sure]


@pytest.mark.parametrize("title", ["", "!!!", "Mom's Favourite", "Delight", "Bread Crumbs", "1234"])
def test_a_title_that_names_no_dish_has_no_class(title):
    assert dish_classes(title) == ()


def test_what_stands_beside_the_dish_is_possible_and_never_sure():
    assert [(d.name, d.sure) for d in dish_classes("Delight with Chicken and Rice")] == [
        ("chicken", False),
        ("rice", False),
    ]


def test_the_sure_class_comes_first_and_the_others_in_their_order():
    classes = [dish.name for dish in dish_classes("Chicken Noodle Soup with Bread")]
    assert classes == ["soup", "chicken", "noodle", "bread"]


@given(st.text(max_size=80))
def test_any_text_has_known_classes_at_most_one_of_them_sure_and_none_twice(title):
    classes = dish_classes(title)
    assert {dish.name for dish in classes} <= set(DISH_TYPES)
    assert sum(dish.sure for dish in classes) <= 1
    assert len({dish.name for dish in classes}) == len(classes)


@given(st.sampled_from(sorted(SURE)), st.sampled_from([str.upper, str.lower, str.title]))
def test_capitals_do_not_matter(title, change):
    assert {d.name for d in dish_classes(change(title))} == {d.name for d in dish_classes(title)}
