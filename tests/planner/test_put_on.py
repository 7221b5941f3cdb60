"""What is spread, stuck on, shaped under a heading, or set in the cold: found missing by people who read trees."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_butter_is_mixed_with_what_is_spread_with_it(steps):
    told = steps("bread", "Garlic Bread", "baguette:halved", "butter:softened", "garlic:minced", "parsley:chopped")
    assert inside(told, "mix") == {"butter", "garlic", "parsley"}
    assert motions(told).index("spread") < motions(told).index("bake")


def test_what_sticks_comes_between_flesh_and_its_crust(steps):
    told = steps("seafood", "Honey Mustard Salmon", "salmon fillet:raw", "butter:melted", "mustard:creamy",
                 "honey:thick liquid", "breadcrumb:dry", "pecan:chopped")  # fmt: skip
    mixed = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "mix"]
    assert mixed[0] == {"mustard", "honey"}
    assert {"breadcrumb", "pecan"} <= mixed[1]
    assert motions(told).index("spread") < motions(told).index("bake")


def test_a_crust_is_turned_in_what_sticks_where_it_is_called_baked(steps):
    told = steps("seafood", "Baked Honey Mustard Salmon", "salmon fillet:raw", "butter:melted", "mustard:creamy",
                 "honey:thick liquid", "breadcrumb:dry", "pecan:chopped")  # fmt: skip
    mixed = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "mix"]
    assert mixed == [{"butter", "mustard", "honey"}, {"breadcrumb", "pecan"}]


def test_all_that_is_listed_for_patties_is_mixed_into_them(steps):
    patties = ("ground beef:raw:patties", "breadcrumb:dry:patties", "egg:uncooked:patties", "ketchup:sauce:patties",
               "worcestershire sauce:sauce:patties", "salt:granulated:patties")  # fmt: skip
    told = steps("beef", "Salisbury Steak", *patties, "butter:unmelted:gravy", "flour:powder:gravy",
                 "beef stock:liquid:gravy")  # fmt: skip
    assert inside(told, "mix") == {one.partition(":")[0] for one in patties}


def test_jelly_is_dissolved_hot_and_set_in_the_cold(steps):
    told = steps("salad", "Lime Gelatin Salad", "gelatin:powder", "water:liquid", "cottage cheese:creamy",
                 "canned pear:canned")  # fmt: skip
    assert first(told, "gelatin", "cook and stir") < motions(told).index("stir") < motions(told).index("chill")


def test_tea_that_is_asked_in_leaves_is_steeped_and_strained_off(steps):
    told = steps("drinks", "", "tea:leaves", "water:liquid", "milk:liquid", "sugar:granulated")
    assert first(told, "tea", "cook and stir") < motions(told).index("pour and strain")
    assert "tea" not in told[-1][2][0].ingredients


@pytest.mark.parametrize(
    ("dish_type", "foods", "named"),
    [
        ("drinks", ("yogurt:creamy", "banana:whole fruit", "avocado:whole", "spinach:leaves", "soymilk:juice",
                    "cashew:whole", "water:juice", "ice:solid"), "drinks"),  # no cocktail of three of these
        ("bread", ("baguette:halved", "butter:softened", "garlic:minced", "parsley:chopped"), "garlic bread"),
    ],
)  # fmt: skip
def test_nothing_untitled_is_called_by_a_dish_most_of_whose_foods_it_has_not(public_plans, dish_type, foods, named):
    assert public_plans(dish_type, "", *foods).goal.label == named


def test_nothing_without_tomatoes_is_a_bloody_mary(public_plans):
    green = ("kale:leaves", "apple:halved", "cucumber:whole veg", "celery:whole veg", "lemon:juice", "water:juice")
    assert public_plans("drinks", "", *green).goal.label != "bloody mary"


def test_bread_of_a_salad_that_no_fat_is_listed_beside_is_toasted_dry(steps):
    told = steps("salad", "", "lettuce:whole leafy", "oil:liquid", "mustard:creamy", "bread:sliced")
    assert inside(told, "bake") == {"bread"}
    assert "bread" not in inside(told, "mix")


def test_what_was_stirred_in_a_saucepan_is_poured_and_no_turner_lifts_it(steps):
    told = steps("pudding", "Banana Pudding", "sugar:granulated", "flour:powder", "egg:separated", "milk:liquid",
                 "vanilla extract:liquid", "vanilla wafers:whole", "banana:sliced")  # fmt: skip
    moved = [motion for things, motion, _ in told if {"baking dish", "saucepan"} <= things]
    assert moved == ["pour"]


def test_flour_is_sifted_out_of_its_bag_through_a_sieve(steps):
    told = steps("cake", "Sponge cake", "flour:sifted", "sugar:granulated", "eggs:beaten", "butter:softened")
    sifted = motions(told).index("sift")
    assert {"bag", "strainer"} <= told[sifted - 1][0]
    assert {"strainer", "bowl"} <= told[sifted][0]


def test_fries_beside_mussels_are_baked_by_themselves(steps):
    told = steps("seafood", "Moules frites", "mussels:raw", "white wine:liquid", "shallot:minced", "butter:unmelted",
                 "parsley:chopped", "fries:frozen")  # fmt: skip
    assert inside(told, "bake") == {"fries"}
