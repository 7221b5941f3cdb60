"""A dish whose name asks for a craft that no video of a like dish has is made by the technique that is called so."""

from __future__ import annotations

import pytest
from planner.public_foon import public_snapshot
from planner.told_steps import planned_steps

pytestmark = pytest.mark.shared_data


@pytest.fixture(scope="module")
def steps():
    return planned_steps(public_snapshot())


def motions(told):
    return [motion for _, motion, _ in told]


def first(told, food, motion):
    return next(place for place, (inputs, one, _) in enumerate(told) if food in inputs and one == motion)


def test_a_kugel_is_boiled_noodles_baked_in_eggs(steps):
    told = steps("pudding", "Noodle Kugel", "egg noodles:uncooked", "eggs:uncooked", "sour cream:creamy",
                 "sugar:granulated", "raisins:whole")  # fmt: skip
    assert first(told, "egg noodles", "boil") < first(told, "eggs", "whisk") < first(told, "egg noodles", "fold")
    assert motions(told)[-4:] == ["put inside", "bake", "turn off", "remove"]


def inside(told, motion):
    """The foods of what the first such motion works on."""
    (outputs, *_) = [outputs for _, one, outputs in told if one == motion]
    return {food for node in outputs for food in node.ingredients}


def test_ravioli_are_filled_closed_and_boiled_before_their_sauce_takes_them(steps):
    told = steps("pasta", "Ricotta Ravioli", "flour:powder", "eggs:uncooked", "ricotta cheese:creamy",
                 "butter:unmelted", "sage leaves:leaf")  # fmt: skip
    order = ["knead", "roll", "fold and pinch", "boil", "melt"]
    assert [motion for motion in dict.fromkeys(motions(told)) if motion in order] == order
    assert inside(told, "fold and pinch") == {"eggs", "flour", "ricotta cheese"}


def test_wontons_come_into_the_broth_when_it_is_hot(steps):
    told = steps("soup", "Wonton Soup", "wonton wrappers:raw", "ground pork:raw", "soy sauce:liquid",
                 "chicken broth:liquid", "bok choy:chopped")  # fmt: skip
    assert inside(told, "fold and pinch") == {"wonton wrappers", "ground pork", "soy sauce"}
    assert motions(told).index("fold and pinch") < motions(told).index("simmer") < first(told, "parcel", "simmer")


def test_bought_wrappers_are_not_kneaded(steps):
    told = steps("pork", "Pork Jiaozi", "dumpling wrappers:raw", "ground pork:raw", "egg:uncooked", "vinegar:liquid")
    assert "knead" not in motions(told)
    assert inside(told, "fold and pinch") == {"dumpling wrappers", "ground pork", "egg"}


def test_leaves_are_taken_off_a_cabbage_that_was_boiled_and_rolled_around_their_filling(steps):
    told = steps("vegetables", "Cabbage Rolls", "cabbage:whole", "ground beef:raw", "rice:cooked", "tomato sauce:sauce")
    assert first(told, "cabbage", "cook") < first(told, "cabbage", "tear apart") < motions(told).index("roll")
    assert inside(told, "roll") == {"cabbage", "ground beef", "rice"}


def test_a_dish_of_a_type_that_no_video_has_is_made_by_its_technique(steps):
    told = steps("meatloaf", "Meatloaf", "ground beef:raw", "egg:uncooked", "breadcrumbs:crumbs", "ketchup:sauce")
    assert inside(told, "shape") == {"ground beef", "egg", "breadcrumbs"}
    assert first(told, "ketchup", "pour") < motions(told).index("bake")
