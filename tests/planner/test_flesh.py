"""Flesh is marinated before it is cooked, and roasts, braises and steaks get what their names promise in its time."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

_MARINADE = ("olive oil:liquid", "lemon juice:juice", "garlic:minced", "oregano:dried", "salt:granulated")


def test_yogurt_marinates_the_meat_of_a_curry_before_anything_is_hot(steps):
    told = steps("chicken", "Chicken Tikka Masala", "chicken thighs:cut", "yogurt:plain", "garam masala:ground",
                 "oil:liquid", "onion:chopped", "garlic:minced", "tomato sauce:sauce", "cream:creamy")  # fmt: skip
    assert {"yogurt", "chicken thighs", "garam masala"} <= inside(told, "chill")
    assert motions(told).index("chill") < motions(told).index("heat") < first(told, "onion", "pour")


def test_what_a_recipe_says_is_for_the_sauce_is_in_no_marinade(steps):
    told = steps("chicken", "Butter Chicken", "chicken thighs:cut:marinade", "yogurt:plain:marinade",
                 "turmeric:ground:marinade", "butter:unmelted:sauce", "garlic:minced:sauce",
                 "canned tomatoes:canned:sauce", "salt:granulated:sauce")  # fmt: skip
    assert inside(told, "chill") == {"chicken thighs", "yogurt", "turmeric"}
    assert first(told, "garlic", "pour") > motions(told).index("melt")


@pytest.mark.parametrize(
    ("dish_type", "title", "meat", "heat"),
    [
        ("chicken", "Greek Grilled Chicken", "chicken breasts:raw", "broil"),
        ("chicken", "Greek Chicken", "chicken breasts:raw", "cook"),
        ("chicken", "Greek Chicken", "chicken drumsticks:raw", "bake"),
        ("pork", "Greek Pork", "pork loin:cubed", "cook and stir"),
        ("pork", "Souvlaki", "pork loin:cubed", "broil"),
    ],
)
def test_flesh_with_nothing_but_what_marinates_it_lies_in_that_first(steps, dish_type, title, meat, heat):
    told = steps(dish_type, title, meat, *_MARINADE, "pita:plain:serving")
    assert {"lemon juice", "garlic", meat.partition(":")[0]} <= inside(told, "chill")
    assert "pita" not in inside(told, "chill")
    assert motions(told).index("chill") < motions(told).index(heat)


def test_vegetables_of_fajitas_are_fried_with_what_was_marinated(steps):
    told = steps("steak", "Steak Fajitas", "skirt steak:raw", "lime juice:juice", "oil:liquid", "cumin:ground",
                 "bell peppers:sliced", "onion:sliced", "flour tortillas:plain", "salsa:sauce:serving")  # fmt: skip
    assert inside(told, "chill") == {"skirt steak", "lime juice", "oil", "cumin"}
    assert {"bell peppers", "onion"} <= inside(told[first(told, "onion", "pour") :], "cook and stir")


def test_no_stew_or_tagine_is_marinated_and_baked(steps):
    told = steps(
        "chicken",
        "Chicken Tagine",
        "chicken thighs:raw",
        "lemon:sliced",
        "olive oil:liquid",
        "onions:sliced",
        "ginger:ground",
    )
    assert "chill" not in motions(told)
