"""The parts of a recipe whose list has no headings are found by what it names one after another, and what again.

Each list here is written with its parts, which are dropped: what is found must be one of them, whole.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.food import tables
from foon_kg.food.listed import runs
from foon_kg.integration.composing.headed import Inferred
from foon_kg.integration.composing.listed import parts_inferred, with_parts_said
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import Recipe, RequiredIngredient

Parts = tuple[tuple[str, str], ...]

FOUND: dict[tuple[str, str], Parts] = {
    ("cake", "Revani"): (
        ("", "eggs, sugar, yogurt, semolina, baking powder, lemon zest"),
        ("syrup", "sugar, water, lemon juice"),
    ),
    ("cake", "Rum cake"): (
        ("", "butter, caster sugar, eggs, flour, baking powder, almonds"),
        ("syrup", "sugar, water, dark rum"),
    ),
    ("bread", "Rum babas"): (
        ("", "flour, yeast, sugar, eggs, butter, salt"),
        ("syrup", "sugar, water, orange juice, rum"),
    ),
    ("pudding", "Date pudding"): (
        ("", "dates, baking soda, butter, brown sugar, eggs, self-raising flour"),
        ("sauce", "butter, brown sugar, double cream"),
    ),
    ("cookie", "Iced cocoa biscuits"): (
        ("", "butter, sugar, flour, cocoa, cornflakes"),
        ("icing", "icing sugar, cocoa, butter"),
    ),
    ("stir-fry", "Pork with peppers"): (
        ("", "pork, cornflour, green pepper, onion, oil"),
        ("sauce", "soy sauce, sugar, rice vinegar, cornflour, water"),
    ),
    ("noodle", "Fried noodles"): (
        ("", "egg noodles, chicken breast, cabbage, carrot, oil"),
        ("sauce", "oyster sauce, soy sauce, sugar"),
    ),
    ("casserole", "Aubergine bake"): (
        ("", "aubergines, olive oil, onion, lamb mince, tomatoes, cinnamon"),
        ("sauce", "butter, flour, milk, nutmeg"),
    ),
    ("casserole", "Shepherd's pie"): (
        ("", "oil, onion, carrots, lamb mince, beef stock"),
        ("mash", "potatoes, butter, milk"),
        ("", "cheddar"),
    ),
    ("sandwich", "Kofta pittas"): (
        ("", "lamb mince, onion, garlic, cumin, pitta breads, tomatoes"),
        ("sauce", "yogurt, garlic, lemon juice, mint"),
    ),
    ("steak", "Fried steak"): (
        ("", "steaks, flour, paprika, eggs, milk, oil"),
        ("gravy", "flour, milk, black pepper"),
    ),
    ("steak", "Steak from the grill"): (
        ("", "skirt steak, salt, olive oil"),
        ("chimichurri", "parsley, oregano, garlic, olive oil, red wine vinegar"),
    ),
    ("pie", "Butter tarts"): (
        ("pastry", "flour, lard, water"),
        ("filling", "brown sugar, corn syrup, butter, raisins, flour"),
    ),
    ("pie", "Chard pie"): (
        ("pastry", "flour, olive oil, salt, water"),
        ("filling", "chard, onion, ricotta, nutmeg, salt"),
        ("", "egg"),
    ),
    ("pie", "Tart of berries"): (
        ("pastry", "flour, icing sugar, butter, egg yolk"),
        ("filling", "milk, egg yolks, sugar, cornflour, vanilla extract"),
        ("topping", "strawberries, blueberries, apricot jam"),
    ),
    ("pizza", "Pizza with peppers"): (
        ("dough", "flour, yeast, water, salt"),
        ("topping", "red peppers, onions, tomatoes, salt"),
    ),
    ("bread", "Plaited loaf"): (
        ("", "milk, yeast, sugar, salt, eggs, flour, butter"),
        ("wash", "egg"),
        ("topping", "almonds, pearl sugar"),
    ),
    ("bread", "Loaf on semolina"): (
        ("", "flour, semolina, salt, yeast, water, oil"),
        ("dusting", "semolina"),
    ),
    ("cake", "Semolina cake"): (
        ("", "semolina, flour, eggs, sugar, yogurt, baking powder"),
        ("syrup", "sugar, water"),
        ("garnish", "pistachios"),
    ),
    ("cake", "Honey cake with cream"): (
        ("", "honey, butter, sugar, eggs, flour, baking soda"),
        ("cream", "double cream, icing sugar, vanilla extract"),
    ),
    ("pudding", "Apples under a sponge"): (
        ("filling", "apples, demerara sugar, lemon zest, water"),
        ("", "butter, caster sugar, eggs, self-raising flour, almonds"),
    ),
    ("pie", "Cherry cobbler"): (
        ("filling", "cherries, sugar, cornflour"),
        ("", "flour, sugar, baking powder, butter, milk"),
    ),
    ("stir-fry", "Tender pork"): (
        ("marinade", "pork fillet, baking soda, soy sauce, cornflour"),
        ("", "oil, ginger, spring onions, oyster sauce"),
    ),
    ("soup", "Soup with balls of meat"): (
        ("meatballs", "minced pork, onion, egg, flour, salt"),
        ("", "oil, onion, carrots, beef stock, tomatoes"),
    ),
}  # fmt: skip

NOT_FOUND = {
    ("cake", "Sponge"): "butter, sugar, eggs, flour, baking powder, milk, vanilla extract",
    ("cake", "Honey cake"): "honey, butter, sugar, eggs, flour, baking soda, water",
    ("pudding", "Rice pudding"): "rice, milk, sugar, butter, cream, nutmeg",
    ("chicken", "Yogurt chicken"): "chicken, yogurt, lemon juice, garlic, cumin, salt",
    ("sandwich", "Roll with pork"): "pork, fish sauce, garlic, baguettes, mayonnaise, cucumber, coriander, red chilli",
    ("meatball", "Frikadeller"): "minced pork, onion, eggs, flour, milk, salt, pepper, butter",
    ("pie", "Apple pie"): "pie crust, apples, sugar, flour, butter, cinnamon",
    ("casserole", "Hotpot"): "lamb, onions, carrots, lamb stock, potatoes, butter",
    ("noodle", "Noodles"): "noodles, pork, tomatoes, tomato paste, cumin, soy sauce, vinegar, lamb stock, basil",
    ("pizza", "Margherita"): "flour, yeast, water, olive oil, tomatoes, mozzarella, basil",
    ("bread", "Brioche"): "flour, yeast, milk, sugar, salt, eggs, egg yolk, butter",
    ("pudding", "Brown betty"): "apples, sugar, cinnamon, breadcrumbs, butter, sugar",
    ("pudding", "Self-saucing pudding"): "self-raising flour, cocoa, sugar, milk, egg, brown sugar, cocoa, water",
    ("soup", "Pea soup"): "peas, water, ham, onion, carrot, salt",
}  # fmt: skip


def wants(*foods: str, part: str = "") -> tuple[Want, ...]:
    """Return foods as a list names them, one place each."""
    known = tables().foods
    return tuple(
        Want(place, food, "", known.food(food), (), "", part=part, places=(place - 1,))
        for place, food in enumerate(foods, start=1)
    )


def found(dish_type: str, title: str, foods: str) -> tuple[Inferred, ...]:
    return parts_inferred(wants(*foods.split(", ")), Recipe(dish_type, (), "x", title))


@pytest.mark.parametrize(("dish", "parts"), FOUND.items(), ids=lambda one: one[1] if isinstance(one[0], str) else "")
def test_parts_are_found_where_the_list_names_them_one_after_another(dish, parts):
    foods = ", ".join(named for _, named in parts)
    listed = foods.split(", ")
    told = {(one.part, ", ".join(listed[place] for place in one.places)) for one in found(*dish, foods)}
    assert told == {one for one in parts if one[0]}


@pytest.mark.parametrize(("dish", "foods"), NOT_FOUND.items(), ids=lambda one: one[1] if isinstance(one, tuple) else "")
def test_no_part_is_found_where_the_list_tells_of_none(dish, foods):
    assert found(*dish, foods) == ()


def test_what_a_list_with_headings_says_is_left_alone():
    foods = (*wants("eggs", "sugar", "semolina", part="cake"), *wants("sugar", "water"))
    assert parts_inferred(foods, Recipe("cake", (), "x", "Revani")) == ()


def test_what_makes_flesh_tender_is_found_above_the_first_heading():
    foods = ["chicken", "baking soda", "oil", "onion", "soy sauce", "cornflour"]
    listed = [replace(want, part="sauce" if want.label in {"soy sauce", "cornflour"} else "") for want in wants(*foods)]
    (one,) = parts_inferred(listed, Recipe("stir-fry", (), "x", "Chop suey"))
    assert one == Inferred("marinade", (0, 1))


def test_what_is_said_of_one_food_is_no_heading():
    foods = ["eggs", "sugar", "semolina", "baking powder", "sugar", "water"]
    served = Want(9, "cream", "", tables().foods.food("cream"), (), "", part="serving", places=(6,))
    (one,) = parts_inferred((*wants(*foods), served), Recipe("cake", (), "x", "Revani"))
    assert one == Inferred("syrup", (4, 5))


def test_a_recipe_says_the_part_of_each_food_by_its_place():
    recipe = Recipe("cake", tuple(RequiredIngredient(food, "") for food in ("sugar", "", "flour", "sugar")))
    said = with_parts_said(recipe, (Inferred("syrup", (2,)),))
    assert [food.part for food in said.ingredients] == ["", "", "", "syrup"]


def test_what_is_said_of_one_food_moves_no_other_out_of_its_part():
    served = RequiredIngredient("cream", "", part="serving")
    recipe = Recipe("cake", (served, *(RequiredIngredient(food, "") for food in ("flour", "sugar", "water"))))
    said = with_parts_said(recipe, (Inferred("syrup", (2, 3)),))
    assert [food.part for food in said.ingredients] == ["serving", "", "syrup", "syrup"]


@given(st.data())
def test_each_food_is_for_one_part_at_most_and_something_is_left_or_filled(data):
    names = sorted({food for parts in FOUND.values() for _, named in parts for food in named.split(", ")})
    foods = data.draw(st.lists(st.sampled_from(names), min_size=1, max_size=12))
    types = sorted({one for run in runs() for one in run.technique.types})
    dish_type = data.draw(st.sampled_from(types))
    parts = parts_inferred(wants(*foods), Recipe(dish_type, (), "x", ""))
    places = [place for one in parts for place in one.places]
    assert len(places) == len(set(places))
    assert set(places) <= set(range(len(foods)))
    assert not parts or len(places) < len(foods) or any(run.rest in {one.part for one in parts} for run in runs())
