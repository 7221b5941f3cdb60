"""Words for parts and headings that stand in a list as if they were foods."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from foon_kg.integration.composing.headed import without_headings
from foon_kg.model import Recipe, RequiredIngredient

FOODS = st.builds(RequiredIngredient, st.sampled_from(["flour", "onion", "tofu", "forel", "tomato"]), st.just("whole"))
HEADINGS = st.sampled_from(["For the gravy", "for the sauce:", "To serve", "For the lemon glaze"]).map(
    lambda text: RequiredIngredient(text, "")
)


def recipe(*foods: RequiredIngredient) -> Recipe:
    return Recipe("cake", foods)


@given(st.lists(FOODS))
def test_a_list_without_headings_stays_as_it_is(foods):
    asked = recipe(*foods)
    assert without_headings(asked) is asked


@given(st.lists(st.one_of(FOODS, HEADINGS)))
def test_no_food_is_lost_and_no_heading_is_left(listed):
    kept = without_headings(recipe(*listed)).ingredients
    foods = [one for one in listed if not one.object.lower().startswith(("for ", "to "))]
    assert [one.object for one in kept] == [one.object for one in foods]


@given(st.lists(FOODS), HEADINGS, st.lists(FOODS, min_size=1))
def test_what_follows_a_heading_is_for_its_part_and_what_stands_above_is_not(above, heading, below):
    kept = without_headings(recipe(*above, heading, *below)).ingredients
    assert {one.part for one in kept[: len(above)]} <= {""}
    assert len({one.part for one in kept[len(above) :]}) == 1
    assert all(one.part for one in kept[len(above) :])


def test_what_is_said_to_be_for_something_else_ends_a_heading():
    foods = (RequiredIngredient("egg", "", part="batter"), RequiredIngredient("For the gravy", "", part="gravy"))
    below = (RequiredIngredient("onion", "", part="batter"), RequiredIngredient("parsley", "", part="serving"))
    kept = without_headings(recipe(*foods, *below)).ingredients
    assert [(one.object, one.part) for one in kept] == [("egg", "batter"), ("onion", "gravy"), ("parsley", "serving")]
