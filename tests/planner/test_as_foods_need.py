"""What is done to single foods, whatever the dish: soaked, cut, taken out again, fried in their turn."""

from __future__ import annotations

import pytest
from planner.told_steps import first, motions

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]


def lifted(told):
    """Return what is removed from what it was cooked in."""
    removed = [node for _, motion, outputs in told for node in outputs if motion == "remove"]
    return {node.label for node in removed if node.container == "plate"}


def alone_in_heat(told, food):
    """Return what else is worked on in the first step over heat in which a food takes part."""
    return next(inputs - {food} for inputs, motion, _ in told if motion.startswith("cook") and food in inputs)


def test_what_is_dried_hard_soaks_before_it_is_cut_or_cooked(steps):
    told = steps("soup", "Soup", "porcini:dried", "kidney bean:dried", "onion:chopped", "oil:liquid", "stock:liquid")
    assert first(told, "porcini", "soak") < first(told, "porcini", "chop")
    hot = next(place for place, (inputs, _, _) in enumerate(told) if {"kidney bean", "stove"} <= inputs)
    assert first(told, "kidney bean", "soak") < hot


def test_lentils_and_sheets_of_seaweed_are_not_soaked_but_loose_seaweed_is(steps):
    told = steps("soup", "Lentil Soup", "lentil:dried", "onion:chopped", "oil:liquid", "stock:liquid", "nori:sheet")
    assert "soak" not in motions(told)
    told = steps("salad", "Seaweed Salad", "wakame:dried", "cucumber:sliced", "rice vinegar:liquid", "soy sauce:liquid")
    assert "soak" in motions(told)


def test_a_carrot_asked_in_sticks_is_peeled_and_then_cut(steps):
    told = steps("salad", "", "carrot:sticks", "cabbage:shredded", "oil:juice", "vinegar:juice")
    assert first(told, "carrot", "peel") < first(told, "carrot", "cut")


def test_what_was_dried_in_large_pieces_is_cut_and_coarse_leaves_lose_their_ends(steps):
    told = steps("salad", "Kale Salad", "kale:leaves", "sun-dried tomato:whole", "olive oil:liquid", "vinegar:liquid")
    assert first(told, "kale", "cut off ends") < first(told, "kale", "chop")
    assert any("sun-dried tomato" in inputs and "knife" in inputs for inputs, _, _ in told)


def test_whole_spices_are_taken_out_by_whatever_word_they_are_asked(steps):
    told = steps(
        "rice", "", "rice:grain", "oil:juice", "onion:chopped", "cinnamon:sticks", "cardamom:pods", "clove:whole",
        "water:juice", "salt:ground",
    )  # fmt: skip
    assert lifted(told) == {"cinnamon", "cardamom", "clove"}


def test_no_fresh_pepper_comes_from_a_mill(steps):
    told = steps("chicken", "Jerk Chicken", "chicken thigh:raw", "scotch bonnet pepper:", "oil:liquid", "lime:juice")
    assert not any("pepper mill" in inputs for inputs, _, _ in told)


def test_bacon_is_fried_alone_then_flesh_and_then_the_rest(steps):
    told = steps(
        "beef", "Beef Stew", "bacon:raw", "beef chuck:cubed", "onion:chopped", "carrot:sliced", "red wine:liquid",
        "beef stock:liquid",
    )  # fmt: skip
    assert alone_in_heat(told, "bacon").isdisjoint({"beef chuck", "onion", "carrot"})
    assert alone_in_heat(told, "beef chuck").isdisjoint({"onion", "carrot"})
    assert first(told, "bacon", "chop") < first(told, "beef chuck", "cook and stir")


def test_bacon_is_fried_and_cut_before_it_is_stirred_into_what_is_baked(steps):
    told = steps(
        "bread", "", "flour:ground", "cheddar:whole", "buttermilk:juice", "egg:whole raw", "baking powder:ground",
        "salt:ground", "bacon:raw",
    )  # fmt: skip
    assert first(told, "bacon", "cook") < first(told, "bacon", "chop") < first(told, "bacon", "mix")
