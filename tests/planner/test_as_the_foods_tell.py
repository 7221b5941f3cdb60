"""Dishes that nobody's name tells: what foods of some kinds become together, and the water that nobody lists."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, taking

from foon_kg.food import tables

pytestmark = pytest.mark.shared_data


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Kyckling i vin", ("chicken:cut", "butter:unmelted", "shallots:chopped", "white wine:liquid")),
        ("Kedjenou", ("guinea fowl:cut", "onions:sliced", "tomatoes:chopped", "garlic:crushed", "thyme:sprig")),
    ],
)
def test_a_bird_in_what_is_wet_is_stewed_and_not_baked_raw(steps, title, foods):
    told = steps("chicken", title, *foods)
    assert "simmer" in motions(told)
    assert "bake" not in motions(told)


def test_a_title_that_asks_for_the_oven_has_it(steps):
    told = steps("chicken", "Baked chicken", "chicken thighs:raw", "onion:sliced", "white wine:liquid", "oil:liquid")
    assert "bake" in motions(told)


def test_flesh_without_any_liquid_is_boiled_in_water_and_carved(steps):
    told = steps("beef", "Kochfleisch", "beef rump cap:whole", "carrots:chopped", "celeriac:chopped",
                 "bay leaves:whole", "peppercorns:whole", "salt:granulated")  # fmt: skip
    assert {"water", "beef rump cap", "carrots"} <= inside(told, "simmer")
    assert first(told, "beef rump cap", "simmer") < first(told, "beef rump cap", "slice")


def test_a_stock_cube_takes_no_place_of_the_water_of_a_soup(steps):
    told = steps("soup", "Egusi soup", "goat meat:chopped", "palm oil:liquid", "egusi:ground", "onion:chopped",
                 "seasoning cubes:whole", "spinach:leaves")  # fmt: skip
    assert "water" in inside(told, "simmer")


def test_a_soup_of_which_no_liquid_is_listed_boils_in_water(steps):
    told = steps("soup", "Kapustnica", "sauerkraut:drained", "pork neck:chopped", "onion:chopped", "lard:creamy",
                 "sweet paprika:ground")  # fmt: skip
    assert "water" in inside(told, "simmer")


def test_raw_flesh_and_rice_come_into_one_pot(steps):
    told = steps("rice", "Galinhada", "chicken pieces:raw", "oil:liquid", "onion:chopped", "tomatoes:chopped",
                 "long-grain rice:uncooked", "water:hot")  # fmt: skip
    assert {"chicken pieces", "long-grain rice"} <= taking(told, "simmer")
    assert "drain" not in motions(told)


def test_flour_and_water_become_noodles(steps):
    told = steps("stir-fry", "Tsuivan (fried noodles with mutton)", "flour:powder", "water:liquid", "mutton:cut",
                 "oil:liquid", "onion:sliced", "cabbage:shredded")  # fmt: skip
    assert {"knead", "roll", "boil"} <= set(motions(told))
    assert "flour" not in taking(told, "cook and stir")


def test_noodles_with_granules_for_a_broth_get_the_water(steps):
    told = steps("noodle", "Hoto", "hoto noodles:uncooked", "kabocha squash:cut", "daikon:sliced", "dashi:granulated",
                 "miso:paste")  # fmt: skip
    assert {"water", "dashi", "kabocha squash"} <= inside(told, "simmer")


def test_no_strainer_holds_polenta(steps):
    told = steps("pork", "Tochitura (stew)", "pork shoulder:cut", "lard:creamy", "onion:chopped", "white wine:liquid",
                 "polenta:uncooked", "salt:granulated")  # fmt: skip
    assert all("polenta" not in inputs for inputs, motion, _ in told if motion == "drain")


def test_yeast_for_a_drink_is_not_boiled(steps):
    told = steps("drinks", "Sima", "water:liquid", "sugar:granulated", "lemons:sliced", "yeast:fresh", "raisins:whole")
    assert "ferment" in motions(told)
    assert "yeast" not in inside(told, "cook")


def test_what_is_left_of_cooking_is_not_the_food_itself():
    food = tables().foods.food
    assert food("beetroot cooking liquid").is_a("liquid")
    assert food("oil from frying the onions").is_a("oil")


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("bread", "Lahoh (pan bread)", "flour:plain,sorghum flour:powder,yeast:powder,water:warm,oil:liquid"),
        ("omelette", "Hangtown fry", "bacon:raw,oysters:drained,eggs:uncooked,butter:unmelted"),
        ("vegetables", "Chillies and cheese", "green chillies:halved,onion:sliced,water:liquid,datshixyz:crumbled"),
        ("drinks", "Rompope", "whole milk:liquid,sugar:granulated,baking soda:powder,egg yolks:uncooked,rum:liquid"),
    ],
)
def test_there_is_a_tree_though_a_name_says_little(steps, dish_type, title, foods):
    assert steps(dish_type, title, *foods.split(","))


def test_a_soup_with_a_tin_of_thick_milk_boils_in_water(steps):
    told = steps("soup", "Chupe", "prawns:peeled", "oil:liquid", "onion:chopped", "rice:uncooked", "potatoes:cubed",
                 "evaporated milk:liquid", "salt:granulated")  # fmt: skip
    assert "water" in taking(told, "simmer") | inside(told, "simmer")


def test_potatoes_in_quarters_are_mashed_before_they_are_shaped(steps):
    told = steps("potatoes", "Maakouda (fried potato cakes)", "potatoes:quartered", "garlic:minced", "egg:beaten",
                 "flour:plain", "vegetable oil:liquid")  # fmt: skip
    assert motions(told).index("mash") < motions(told).index("shape")


def test_wine_in_a_roll_is_cooked_with_the_steak(steps):
    told = steps("sandwich", "Prego no pao", "beef steaks:uncooked", "garlic:sliced", "white wine:liquid",
                 "lard:creamy", "papo-secos rolls:whole", "yellow mustard:creamy")  # fmt: skip
    assert "white wine" in taking(told, "cook and stir")
    assert "yellow mustard" not in taking(told, "cook and stir")


def test_a_filling_is_fried_and_closed_in_dough_that_rose(steps):
    told = steps("pizza", "Pizza di scarola (escarole pie)", "flour:plain", "yeast:powder", "water:liquid",
                 "salt:granulated", "escarole:trimmed", "olive oil:liquid", "raisins:whole")  # fmt: skip
    made = motions(told)
    assert {"escarole", "raisins"} <= taking(told, "cook and stir")
    assert made.index("ferment") < made.index("fold and pinch") < made.index("bake")


def test_porridge_is_folded_into_thin_dough(steps):
    told = steps("pie", "Karjalanpiirakat (Karelian rice pasties)", "short-grain rice:uncooked", "milk:liquid",
                 "rye flour:powder", "water:cold", "salt:granulated", "butter:melted")  # fmt: skip
    assert {"short-grain rice", "milk"} <= taking(told, "simmer") | inside(told, "simmer")
    assert "short-grain rice" not in taking(told, "knead")
    assert motions(told).index("fold and pinch") < motions(told).index("bake")
