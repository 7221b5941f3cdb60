"""What a food of which nothing is known is taken for, where its dish lacks what it cannot be without."""

from __future__ import annotations

import pytest

from foon_kg.food import tables
from foon_kg.model import DISH_TYPES
from foon_kg.model.errors import NoTreeError
from foon_kg.world.becoming import meets

REST = ("onion:sliced", "olive oil:liquid", "salt:granulated")


@pytest.mark.shared_data
@pytest.mark.parametrize(
    ("dish_type", "called", "does"),
    [("steak", "zorbik steak", "cook"), ("noodle", "zorbik noodle", "boil"), ("rice", "zorbik rice", "cook")],
)
def test_the_one_food_that_nobody_knows_is_the_core(public_plans, dish_type, called, does):
    result = public_plans(dish_type, "Zorbik", "zorbik:whole", *REST)
    (told,) = [one.why for one in result.assumptions if "“zorbik”" in one.why]
    assert "the only such food" in told
    motions = {
        unit.motion for unit in result.units for node in unit.input_nodes if called in {node.label, *node.ingredients}
    }
    assert any(does in motion for motion in motions)


@pytest.mark.shared_data
def test_the_first_of_several_is_the_core_and_how_sure_that_is_is_told(public_plans):
    result = public_plans("sandwich", "Zorbik", "zorbik:whole", "ham:sliced", "quimmo:chopped")
    (told,) = [one.why for one in result.assumptions if "“zorbik”" in one.why]
    assert "confidence 0.50" in told
    names = {name for node in result.kitchen for name in (node.label, *node.ingredients)}
    assert {"zorbik bread", "quimmo"} <= names


@pytest.mark.shared_data
def test_nothing_is_taken_for_the_core_of_a_dish_that_has_it(public_plans):
    result = public_plans("steak", "Steak", "beefsteak:raw", "zorbik:chopped", *REST)
    assert "zorbik" in {name for node in result.kitchen for name in (node.label, *node.ingredients)}
    assert not [one.why for one in result.assumptions if "nothing is known of" in one.why]


@pytest.mark.shared_data
def test_a_dish_of_known_foods_without_its_core_is_refused_still(public_plans):
    with pytest.raises(NoTreeError, match="no steak without"):
        public_plans("steak", "Steak", *REST)


@pytest.mark.shared_data
def test_an_unknown_food_beside_other_meat_is_no_pork(public_plans):
    with pytest.raises(NoTreeError, match="no pork without"):
        public_plans("pork", "Pork", "zorbik:chopped", "lamb:raw", *REST)


@pytest.mark.parametrize("dish_type", tables().cores)
def test_what_an_unknown_food_is_taken_for_is_what_the_dish_needs(dish_type):
    known = tables()
    assert dish_type in DISH_TYPES
    food = known.foods.food(known.cores[dish_type])
    assert all(any(meets(need, food, known) for need in needs) for needs in known.dishes[dish_type].needs)
