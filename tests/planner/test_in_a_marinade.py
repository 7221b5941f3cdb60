"""Flesh stands in its marinade before it is cooked, under a heading or where a list begins with both."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

REST = ("oil:liquid", "onion:sliced", "tomatoes:chopped", "coconut milk:liquid")


@pytest.mark.parametrize("part", [":marinade", ""])
def test_flesh_stands_in_what_is_sour_and_is_fried_before_the_onions(steps, part):
    foods = ("chicken:cut", "lemon juice:juice", "garlic:crushed", "turmeric:ground")
    told = steps("chicken", "Chicken curry", *(f"{food}{part}" for food in foods), *REST)
    assert inside(told, "stir") == {"lemon juice", "garlic", "turmeric"}
    assert inside(told, "mix") == {"lemon juice", "garlic", "turmeric", "chicken"}
    done = motions(told)
    assert done.index("stir") < done.index("mix") < done.index("chill") < done.index("cook and stir")
    assert "onion" not in inside(told, "cook and stir")


def test_fish_in_its_marinade_comes_when_the_rest_is_cooked(steps):
    told = steps("seafood", "Fish curry", "fish fillets:raw", "lime juice:juice", "garlic:crushed", "salt:", *REST)
    assert inside(told, "chill") == {"fish fillets", "lime juice", "garlic", "salt"}
    assert first(told, "onion", "pour") < motions(told).index("simmer")
    assert "fish fillets" not in inside(told, "cook and stir")


def test_what_an_oven_bakes_stands_in_its_marinade_first(steps):
    told = steps("roast", "Roast lamb", "leg of lamb:raw:marinade", "yogurt:creamy:marinade", "garlic:minced:marinade",
                 "potatoes:quartered", "salt:granulated")  # fmt: skip
    assert motions(told).index("chill") < motions(told).index("bake")


def test_salt_and_pepper_are_no_marinade(steps):
    told = steps("chicken", "Chicken stew", "chicken:cut", "salt:granulated", "black pepper:ground", *REST)
    assert "chill" not in motions(told)


def test_what_is_eaten_raw_is_no_flesh_that_waits_for_a_pan(steps):
    told = steps("seafood", "Tuna poke", "ahi tuna:cubed", "soy sauce:liquid", "sesame oil:liquid", "onion:sliced",
                 "rice:cooked", "avocado:diced")  # fmt: skip
    assert "cook and stir" not in motions(told)
