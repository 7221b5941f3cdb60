"""An asked state is attained: a step makes it, by hand or by heat, before the food joins what would not give it."""

from __future__ import annotations

import pytest
from planner.told_steps import first

from foon_kg.food import tables
from foon_kg.food.workings import working

pytestmark = pytest.mark.shared_data


def states_of(told, food):
    """Return all states in which a food is seen."""
    return {state for _, _, outputs in told for node in outputs if node.label == food for state in node.states}


@pytest.mark.parametrize(
    ("dish", "food", "motion", "rest"),
    [
        ("rice", "basmati rice:soaked", "soak", ("chicken:cubed", "onion:sliced", "chicken stock:liquid")),
        ("noodle", "rice vermicelli:soaked", "soak", ("shrimp:raw", "carrot:julienned", "oil:liquid")),
        ("seafood", "shrimp:deveined", "devein", ("garlic:minced", "butter:unmelted")),
        ("chicken", "chicken leg:skinned", "skin", ("onion:chopped", "oil:liquid", "water:liquid")),
        ("soup", "lemongrass:bruised", "bruise", ("coconut milk:liquid", "chicken:sliced", "salt:granulated")),
        ("pasta", "spaghetti:broken", "break", ("tomato sauce:sauce", "onion:chopped", "oil:liquid")),
        ("cookie", "egg yolk:beaten", "beat", ("flour:powder", "sugar:granulated", "butter:softened")),
        ("sauce", "guajillo chile:seeded", "core", ("garlic:minced", "water:liquid", "salt:granulated")),
        ("soup", "red lentil:rinsed", "rinse", ("onion:chopped", "vegetable stock:liquid")),
        ("beef", "potato:fried", "cook and stir", ("beef:cubed", "onion:sliced", "oil:liquid", "water:liquid")),
        ("soup", "tomato:roasted", "bake", ("onion:chopped", "vegetable stock:liquid")),
        ("soup", "cumin seed:toasted", "cook and stir", ("carrot:diced", "vegetable stock:liquid")),
    ],
)
def test_a_state_is_given_before_the_food_joins(steps, dish, food, motion, rest):
    label, _, state = food.partition(":")
    told = steps(dish, "", food, *rest)
    made = first(told, label, motion)
    assert state in states_of(told[: made + 1], label)
    before = [node.ingredients for _, _, outputs in told[:made] for node in outputs if label in node.ingredients]
    assert all(len(foods) <= 1 + len({"water", "oil"} & {*foods}) for foods in before)


def test_a_spice_is_toasted_without_fat_and_then_ground(steps):
    told = steps("stir-fry", "", "cumin seed:toasted, ground", "lamb:sliced", "garlic:sliced", "oil:liquid")
    toasted, ground = first(told, "cumin seed", "cook and stir"), first(told, "cumin seed", "grind")
    assert toasted < ground
    assert "oil" not in told[toasted][0]
    assert {"mortar", "pestle"} <= told[ground][0]


def test_what_is_bruised_is_lifted_out_whole(steps):
    told = steps("soup", "", "galangal:bruised", "coconut milk:liquid", "chicken:sliced", "salt:granulated")
    assert not states_of(told, "galangal") & {"sliced", "chopped"}
    (lifted,) = [outputs for _, motion, outputs in told if motion == "remove"]
    assert "galangal" in {node.label for node in lifted}
    assert "galangal" not in {food for node in told[-1][2] for food in node.ingredients}


def test_what_is_cooked_in_a_dry_pan_there_is_not_cooked_twice(steps):
    told = steps("stir-fry", "", "tofu:fried", "garlic:sliced", "oil:liquid", "carrot:sliced")
    assert [motion for inputs, motion, _ in told if "tofu" in inputs].count("cook and stir") == 1


def test_a_working_is_of_some_kinds_only():
    foods = tables().foods
    assert working("deveined", foods.food("shrimp", ["raw"])) is not None
    assert working("deveined", foods.food("lobster", ["raw"])) is None
    assert working("skinned", foods.food("smoked salmon")) is None
    assert working("sliced", foods.food("shrimp", ["raw"])) is None
