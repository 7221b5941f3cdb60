"""A heading of a name of its own, that is no known part of a dish, tells what is made beside it."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

from foon_kg.food.words import heading_part

pytestmark = pytest.mark.shared_data


def _together(told, motion):
    """Return the foods of all that such a motion ever works on."""
    return {food for _, one, outputs in told if one == motion for node in outputs for food in node.ingredients}


@pytest.mark.parametrize(
    ("heading", "part"),
    [
        ("For the tomato chutney:", "sauce"),
        ("For the pickle:", "pickled"),
        ("To top:", "topping"),
        ("For the pineapple jam:", "filling"),
        ("For the adobo:", "marinade"),
        ("For the sambal:", "sambal"),
        ("For the apple horseradish:", "horseradish"),
        ("For the:", ""),
    ],
)
def test_a_heading_is_read_as_the_part_that_it_names_or_as_its_last_word(heading, part):
    assert heading_part(heading) == part


def test_what_is_stirred_raw_beside_boiled_meat_is_not_cooked_with_it(steps):
    told = steps(
        "beef", "Boiled beef", "beef:raw", "onions:halved", "carrots:peeled", "salt:granulated",
        *(f"{food}:horseradish" for food in ("apples:grated", "horseradish:grated", "lemon juice:juice")),
    )  # fmt: skip
    hot = _together(told, "cook and stir") | _together(told, "simmer") | _together(told, "boil")
    assert "onions" in hot
    assert hot.isdisjoint({"apples", "horseradish", "lemon juice"})
    assert {"apples", "horseradish", "lemon juice"} <= _together(told, "stir")


def test_a_sambal_is_ground_and_fried_and_not_boiled_with_the_rice(steps):
    told = steps(
        "rice", "Coconut rice", "rice:rinsed", "coconut milk:liquid", "water:liquid", "oil:liquid",
        *(f"{one}:sambal" for one in ("red chillies:dried", "shallots:whole", "tamarind juice:juice", "sugar:")),
    )  # fmt: skip
    assert "shallots" in inside(told, "blend")
    assert {"shallots", "tamarind juice"} <= _together(told, "cook and stir")
    assert "shallots" not in _together(told, "simmer")


def test_a_raw_salad_under_its_heading_is_stirred_before_it_comes_into_a_sandwich(steps):
    told = steps(
        "sandwich", "Picnic loaf", "bread:split", "salami:sliced", "provolone:sliced",
        *(f"{food}:salad" for food in ("green olives:chopped", "capers:whole", "olive oil:liquid", "vinegar:liquid")),
    )  # fmt: skip
    assert {"green olives", "capers", "olive oil", "vinegar"} <= inside(told, "stir")


def test_what_a_heading_calls_as_the_title_does_is_the_dish_itself(steps):
    foods = ("beef:cubed", "onion:chopped", "carrot:sliced", "beef stock:liquid")
    plain = steps("soup", "Beef goulash", *foods, "potatoes:diced", "paprika:ground")
    assert steps("soup", "Beef goulash", *foods, "potatoes:diced:goulash", "paprika:ground:goulash") == plain


def test_the_s_of_whose_dish_it_is_ends_no_name(steps):
    foods = [f"{food}:horseradish" for food in ("apples:grated", "horseradish:grated", "lemon juice:juice")]
    asked = ("beef:raw", "onions:halved", "carrots:peeled", "salt:granulated", *foods)
    named = steps("beef", "Horseradish beef", *asked)
    assert steps("beef", "Tom's horseradish beef", *asked) == named
    assert steps("beef", "Beef s horseradish", *asked) != named  # a Slavic "with"


def test_flour_under_the_heading_of_noodles_is_a_dough(steps):
    told = steps(
        "noodle", "Hand-pulled noodles with lamb", "lamb:sliced", "onion:sliced", "tomatoes:chopped", "oil:liquid",
        *(f"{food}:noodles" for food in ("flour:powder", "salt:granulated", "water:liquid")),
    )  # fmt: skip
    assert {"flour", "salt"} <= inside(told, "knead")
    assert motions(told).index("knead") < motions(told).index("roll")


def test_fruit_under_the_heading_of_a_jam_is_cooked_before_a_dough_is_closed_around_it(steps):
    told = steps(
        "cookie", "Nastar", "pineapple:grated:filling", "sugar:granulated:filling",
        *(f"{food}:cookies" for food in ("butter:softened", "icing sugar:powder", "egg yolks:uncooked", "flour:plain")),
        "egg yolk:beaten:glaze",
    )  # fmt: skip
    assert {"pineapple", "sugar"} <= inside(told, "cook and stir")
    assert inside(told, "knead").isdisjoint({"pineapple", "sugar"})
    assert "brush" in motions(told)


def test_what_comes_from_another_work_is_no_food_that_is_peeled_and_chopped(steps):
    told = steps(
        "pie", "Empanada gallega", "flour:plain:dough", "yeast:fresh:dough", "oil from frying the onions:liquid:dough",
        "water:warm:dough", "onions:chopped:filling", "red pepper:chopped:filling", "tuna:drained:filling",
    )  # fmt: skip
    touched = {motion for inputs, motion, _ in told if "oil from frying the onions" in inputs}
    assert touched.isdisjoint({"peel", "chop", "slice", "mince"})
    assert "onions" in _together(told, "cook and stir")


def test_the_liquid_of_a_food_is_taken_from_the_pot_in_which_that_boiled(steps):
    told = steps(
        "salad", "Rosolli", "beetroots:boiled, diced", "potatoes:boiled, diced", "onion:chopped", "gherkins:diced",
        *(f"{food}:liquid:dressing" for food in ("whipping cream", "white wine vinegar", "beetroot cooking liquid")),
    )  # fmt: skip
    (taken,) = [place for place, (_, _, outputs) in enumerate(told) if _is_taken(outputs)]
    drained = next(place for place, (inputs, _, _) in enumerate(told) if {"beetroots", "strainer"} <= inputs)
    assert first(told, "beetroots", "cook") < taken < drained


def test_onions_of_a_puree_are_fried_before_they_come_into_it(steps):
    told = steps(
        "vegetables", "Pumpkin puree", "pumpkin:cubed", "oil:liquid", "onion:chopped", "garlic:crushed", "salt:"
    )
    assert {"onion", "garlic"} <= _together(told, "cook and stir")
    assert {"onion", "garlic", "pumpkin"} <= inside(told, "mash")


def _is_taken(outputs):
    """Return whether a step takes some of the water out of a pot."""
    labels = {node.label for node in outputs}
    return {"pot", "measuring cup"} <= labels
