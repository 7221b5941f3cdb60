"""Broad forms of dishes that the foods tell, whatever they are called: under gravy, in a wrap, on a bed, in a sauce."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, taking

pytestmark = pytest.mark.shared_data


def test_cooked_meat_is_warmed_in_its_gravy_and_the_bread_stays_open(steps):
    told = steps("sandwich", "Hot Beef Plate", "bread:sliced", "leftover roast beef:sliced", "gravy:sauce",
                 "mashed potatoes:plain")  # fmt: skip
    assert {"gravy", "leftover roast beef"} <= taking(told, "cook and stir")
    assert sum({"bread", "cutting board", "plate"} <= inputs for inputs, _, _ in told) == 1


def test_raw_rice_in_balls_swells_in_the_sauce_that_is_no_part_of_them(steps):
    told = steps("meatball", "Hedgehogs", "ground beef:raw", "rice:uncooked", "onion:chopped", "salt:granulated",
                 "tomato sauce:sauce", "water:liquid")  # fmt: skip
    assert {"tomato sauce", "water"} <= inside(told, "simmer")
    assert inside(told, "mix").isdisjoint({"tomato sauce", "water"})


def test_what_bacon_is_held_round_by_a_stick_is_rolled_in_it_and_baked(steps):
    told = steps("seafood", "", "scallops:whole", "bacon:sliced", "toothpicks:solid", "butter:melted")
    assert motions(told).index("roll") < motions(told).index("bake")
    assert "cook and stir" not in motions(told)


def test_a_joint_on_sauerkraut_stews_in_water_and_is_carved(steps):
    told = steps("pork", "", "pork:whole", "sauerkraut:shredded", "onion:sliced", "caraway:whole")
    assert {"pork", "sauerkraut", "water"} <= inside(told, "simmer")
    assert motions(told).index("simmer") < first(told, "pork", "slice")


def test_eggs_on_a_steak_are_fried_in_a_pan_of_their_own(steps):
    told = steps("steak", "Steak with Fried Eggs", "sirloin steaks:raw", "oil:liquid", "eggs:uncooked")
    assert not any({"sirloin steaks", "eggs"} <= inputs for inputs, motion, _ in told if motion == "cook")
    assert "eggs" in taking(told, "cook")


def test_corn_of_a_bean_burger_is_in_the_patty(steps):
    told = steps("burger", "", "beans:mashed", "corn:grain", "crumb:ground", "egg:whipped", "bun:halved")
    assert {"beans", "corn", "egg"} <= taking(told, "mash")


def test_the_flesh_of_a_meaty_bone_comes_back_to_the_soup(steps):
    told = steps("soup", "Split Pea Soup", "meaty ham bone:raw", "split peas:dried", "onion:chopped", "water:liquid")
    assert motions(told).index("bone") < motions(told).index("pull apart")
