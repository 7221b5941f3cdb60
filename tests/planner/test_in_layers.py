"""Dishes in layers are laid layer on layer: nothing stirs them together before they are served."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

STIRS = {"mix", "stir", "cook and stir", "whisk", "blend", "toss", "cut"}


@pytest.mark.parametrize(
    ("dish", "title", "foods"),
    [
        ("pudding", "Berry Parfait", ("yogurt:creamy", "granola:rolled", "blueberry:berries", "honey:thick liquid")),
        ("pudding", "Trifle", ("angel food cake:cubed", "pudding:creamy", "strawberry:sliced", "cool whip:whipped")),
        ("salad", "Seven Layer Salad", ("lettuce:chopped", "peas:frozen", "mayonnaise:creamy", "cheddar:shredded")),
        ("salad", "Seven Layer Dip", ("refried beans:canned", "sour cream:creamy", "salsa:sauce", "cheddar:shredded")),
    ],
)
def test_layers_are_never_stirred(steps, dish, title, foods):
    told = steps(dish, title, *foods)
    done = [(motion, outputs[0].ingredients) for _, motion, outputs in told]
    assert not [names for motion, names in done if motion in STIRS and len(names) > 1]


def test_a_dressing_is_stirred_by_itself_and_spread_on_the_salad(steps):
    told = steps(
        "salad", "Layered Salad", "lettuce:chopped", "celery:diced", "mayonnaise:creamy", "sugar:granulated",
        "bacon:cooked, crumbled",
    )  # fmt: skip
    assert inside(told, "stir") == {"mayonnaise", "sugar"}
    assert first(told, "lettuce", "pour") < first(told, "mixture", "pour") < first(told, "bacon", "pour")


def test_breaded_slices_lie_below_their_sauce_and_cheese(steps):
    told = steps(
        "casserole", "Eggplant Parmesan", "eggplant:sliced", "egg:beaten", "breadcrumb:crumbs", "olive oil:liquid",
        "marinara sauce:sauce", "mozzarella:shredded",
    )  # fmt: skip
    assert motions(told).index("dip") < motions(told).index("cook") < first(told, "marinara sauce", "pour")
    assert first(told, "marinara sauce", "pour") < first(told, "mozzarella", "pour") < motions(told).index("bake")


def test_milk_goes_into_the_mash_that_covers_a_stew(steps):
    told = steps(
        "pie", "Cottage Pie", "ground beef:raw", "onion:chopped", "beef stock:liquid", "potato:peeled", "milk:liquid",
        "butter:unmelted",
    )  # fmt: skip
    assert inside(told, "mix") == {"potato", "milk"}
    assert first(told, "mixture", "bake") > max(p for p, (foods, _, _) in enumerate(told) if "milk" in foods)


def test_eggs_that_are_asked_boiled_and_sliced_are_sliced_wherever_they_join(steps):
    told = steps("salad", "Layered Salad", "lettuce:chopped", "egg:boiled, sliced", "mayonnaise:creamy")
    assert motions(told).index("peel") < first(told, "egg", "slice")


def test_noodles_are_boiled_when_what_they_are_laid_with_or_come_into_is_ready(steps):
    sauce = ("ground beef:raw", "onion:chopped", "marinara sauce:sauce")
    told = steps("pasta", "Lasagna", *sauce, "lasagna noodle:uncooked", "ricotta:creamy", "mozzarella:shredded")
    fried = max(place for place, one in enumerate(motions(told)) if one == "cook and stir")
    assert fried < first(told, "lasagna noodle", "boil") < first(told, "ricotta", "scoop")
    soup = ("butter:unmelted", "onion:chopped", "chicken:chopped", "stock:liquid", "salt:granulated", "noodle:uncooked")
    told = steps("noodle", "", *soup)
    assert first(told, "noodle", "pour") > first(told, "stock", "pour")
