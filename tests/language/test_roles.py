"""What foods do in a dish: in a slot for it one is taken for another, be they unlike otherwise."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.food import tables
from foon_kg.integration.joining.places import NATURAL
from foon_kg.integration.preparing.understanding import wants_of
from foon_kg.integration.teaching.operators import LIKE_AT_ALL, Operators
from foon_kg.model import RequiredIngredient
from foon_kg.model.errors import UsageError
from foon_kg.model.knowledge import UNLIKE
from foon_kg.planning.likes import FoodLikes
from foon_kg.similarity import cosine_similarity, food_similarity
from foon_kg.similarity.in_role import in_role
from foon_kg.similarity.roles import roles, roles_of

KNOWN = ["broth", "water", "chicken", "shrimp", "butter", "olive oil", "sugar", "onion", "bread", "xyzzy"]


@pytest.mark.parametrize(("food", "role"), [
    ("broth", "liquid"), ("water", "liquid"), ("shrimp", "protein"), ("tofu", "protein"), ("honey", "sweetener"),
    ("olive oil", "fat"), ("lime juice", "acid"), ("heavy cream", "milk"),
])  # fmt: skip
def test_foods_do_what_the_table_says(food, role):
    assert role in roles_of(food)


@pytest.mark.parametrize(("one", "other", "role"), [("broth", "water", "liquid"), ("chicken", "shrimp", "protein")])
def test_in_a_slot_one_is_taken_for_another_that_is_unlike_it(one, other, role):
    assert food_similarity().matrix([one], [other])[0, 0] < LIKE_AT_ALL
    assert food_similarity().in_slot(one, [other], role)[0] > LIKE_AT_ALL + 0.1


@given(st.sampled_from(KNOWN), st.sampled_from(roles()))
def test_only_what_does_the_same_is_answered(name, role):
    found = dict(zip(KNOWN, food_similarity().in_slot(name, KNOWN, role), strict=True))
    for other, sure in found.items():
        assert sure == 0 or {role} <= roles_of(name) & roles_of(other)
        assert sure == 0 or UNLIKE <= sure <= 1
    assert found[name] == (1.0 if role in roles_of(name) else 0.0)


def test_a_role_that_nobody_knows_is_refused():
    with pytest.raises(UsageError, match="colour") as refused:
        in_role("broth", KNOWN, "colour", 3)
    assert "liquid" in refused.value.hint


@pytest.mark.parametrize("known", [[], ["chicken"], ["water", "onion"]])
def test_of_a_part_of_a_foon_a_slot_takes_what_it_takes_of_the_whole(known):
    asked = [RequiredIngredient("shrimp", ""), RequiredIngredient("stock", "")]
    wants = wants_of(asked, tables(), Operators((), tables()))
    whole = FoodLikes(food_similarity(), KNOWN).of_recipe(wants)
    part = FoodLikes(food_similarity(), known).of_recipe(wants)
    part.meet(KNOWN)
    likely = [(want.label, food) for want in wants for food in KNOWN if whole.in_slot(want.label, food) >= NATURAL]
    assert {("shrimp", "chicken"), ("stock", "water")} <= set(likely)
    assert [part.in_slot(*pair) for pair in likely] == [whole.in_slot(*pair) for pair in likely]


def test_a_slot_of_a_dish_takes_what_does_the_same_and_nothing_less_than_it_did():
    likes = FoodLikes(food_similarity(), KNOWN).of_recipe([])
    assert likes.in_slot("shrimp", "chicken") > likes.alike("shrimp", "chicken")
    assert likes.in_slot("onion", "chicken") == likes.alike("onion", "chicken")
    raw = FoodLikes(cosine_similarity(), KNOWN).of_recipe([])
    assert raw.in_slot("shrimp", "chicken") == raw.alike("shrimp", "chicken")
