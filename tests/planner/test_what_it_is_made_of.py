"""Foods are handled by their matter: porridge, what is left of cooking, what has no name here, what is hard."""

from __future__ import annotations

import pytest
from planner.told_steps import first, motions, states_of

pytestmark = pytest.mark.shared_data


@pytest.mark.parametrize("meal", ["polenta", "mamaliga", "grits"])
def test_no_strainer_is_asked_to_hold_a_porridge(steps, meal):
    told = steps("pork", "Pork stew", "pork shoulder:cubed", "onion:chopped", "garlic:minced", "lard:melted",
                 "red wine:liquid", f"{meal}:cooked", "salt:granulated")  # fmt: skip
    held = [node for _, _, outputs in told for node in outputs if node.container == "strainer"]
    assert not any(meal in {node.label, *node.ingredients} for node in held)
    assert first(told, meal, "cook") < len(told)


@pytest.mark.parametrize(
    ("left", "state"),
    [("oil from frying the onions", "liquid"), ("fat from the roast", "creamy"), ("potato cooking liquid", "liquid")],
)
def test_what_cooking_leaves_is_neither_peeled_nor_cut(steps, left, state):
    told = steps(
        "salad", "Potato salad", "potato:boiled", "onion:chopped", "vinegar:liquid", "salt:granulated", f"{left}:"
    )
    states = states_of(told, left)
    assert state in states
    assert states.isdisjoint({"chopped", "peeled", "whole"})


@pytest.mark.parametrize(
    ("food", "place"), [("zorbik", "packet"), ("ugali", "container"), ("chicken curry", "container")]
)
def test_what_is_had_ready_comes_in_something(public_plans, food, place):
    result = public_plans("salad", "Salad", "tomato:chopped", "onion:chopped", "olive oil:liquid", f"{food}:")
    (node,) = [node for node in result.kitchen if node.label == food]
    assert node.container == place


@pytest.mark.parametrize(
    ("food", "motion", "tool"),
    [
        ("pistachios:slivered", "cut", "scissor"),
        ("vanilla bean:split", "cut", "scraper"),
        ("long beans:trimmed", "cut off ends", "cutter"),
    ],
)
def test_what_is_hard_is_cut_with_a_knife(steps, food, motion, tool):
    told = steps("pudding", "Pudding", food, "milk:liquid", "sugar:granulated", "cornstarch:powder")
    used = {one for inputs, _, _ in told for one in inputs}
    assert tool not in used
    assert "knife" in used


def test_what_is_grated_is_grated(steps):
    told = steps("cake", "Cake", "cassava:grated", "egg:whole", "sugar:granulated", "flour:powder", "butter:melted")
    (tools,) = [inputs for inputs, motion, _ in told if motion == "grate"]
    assert tools >= {"cassava", "grater"}


def test_boiled_pulses_are_mashed_by_a_step(steps):
    told = steps("burger", "Shami burger", "chana dal:mashed", "beef:ground", "egg:whole", "burger bun:whole")
    assert "mash" in motions(told)


def test_seeds_are_ground_by_a_step_though_nobody_ground_such_seeds(steps):
    told = steps("salad", "Potato salad", "potato:boiled", "sesame seeds:ground", "onion:chopped", "lemon:juice")
    ground = next(motion for inputs, motion, _ in told if "sesame seeds" in inputs)
    assert "grind" in ground


def test_nobody_stirs_a_joint_in_one_piece(steps):
    told = steps("beef", "Rawon", "beef brisket:whole", "oil:liquid", "onion:chopped", "garlic:minced", "water:liquid")
    stirring = [inputs for inputs, motion, _ in told if "stir" in motion.split()]
    assert not any("beef brisket" in inputs for inputs in stirring)
    cut = steps("beef", "Rawon", "beef brisket:cubed", "oil:liquid", "onion:chopped", "garlic:minced", "water:liquid")
    assert any("beef brisket" in inputs and "stir" in motion.split() for inputs, motion, _ in cut)


def test_what_is_strewn_on_a_steak_is_not_flipped(steps):
    told = steps("steak", "Steak", "sirloin steak:raw", "butter:melted", "salt:granulated", "black pepper:ground")
    assert "flipped" in states_of(told, "sirloin steak")
    assert not {"flipped"} & (states_of(told, "salt") | states_of(told, "black pepper"))


@pytest.mark.parametrize("food", ["clams:chopped", "coconut:chopped", "coconut:"])
def test_nothing_is_cut_in_its_shell(public_plans, steps, food):
    label = food.partition(":")[0]
    asked = ("soup", "Soup", food, "chicken stock:liquid", "potato:diced", "onion:chopped")
    assert not any(label in inputs and motion == "peel" for inputs, motion, _ in steps(*asked))
    (node,) = [node for node in public_plans(*asked).kitchen if node.label == label]
    assert node.states == ("meat",)


def test_bread_is_not_cored_to_be_trimmed(steps):
    told = steps(
        "sandwich", "Hot Brown", "Texas toast:trimmed", "turkey breast:sliced", "cheddar:grated", "butter:soft"
    )
    assert "core" not in motions(told)
