"""Other names of foods: each reaches the food that it is taken for, and takes nothing from the listed ones."""

from __future__ import annotations

from collections import Counter

import pytest

from foon_kg.food import tables, words
from foon_kg.food.rows import Match
from foon_kg.food.shipped import shipped

NAMES = shipped("names")["names"]
FOODS = tables().foods


def test_every_food_that_names_are_taken_for_is_listed():
    assert [meant for meant in NAMES if meant not in FOODS.kind_of] == []


def test_every_name_is_the_food_that_it_is_taken_for():
    # a table that lists one knows more of it
    own = [(name, meant) for meant, names in NAMES.items() for name in names if name not in FOODS.kind_of]
    assert own
    answers = [(name, FOODS.find(name), (FOODS.kind_of[meant], meant, Match.NAME)) for name, meant in own]
    assert [(name, found, wanted) for name, found, wanted in answers if found != wanted] == []


def test_names_stand_as_names_of_foods_are_compared():
    assert [name for names in NAMES.values() for name in names if name != " ".join(words(name))] == []


def test_no_name_is_of_two_foods():
    counted = Counter(name for names in NAMES.values() for name in names)
    assert [name for name, times in counted.items() if times > 1] == []


def test_no_name_is_a_utensil():
    assert [name for names in NAMES.values() for name in names if tables().utensil(name)] == []


@pytest.mark.parametrize(
    ("asked", "kind"),
    [
        ("fagioli", "dry pulse"),
        ("Pandesal", "bun"),
        ("bifes de nalga", "meat"),
        ("lacón curado", "corned beef"),
        ("chorizos asturianos", "raw sausage"),
        ("leftover smoked brisket", "cooked meat"),
        ("smoked brisket", "ready meat"),
        ("deli corned beef", "ready meat"),
        ("cooked chicken thighs", "cooked meat"),
        ("roasted tomatoes", "tomato"),  # no table knows those as another food
        ("leftover chili", "cooked dish"),
        ("chili", "hot pepper"),
        ("7-Up", "soda"),
        ("home-made caldo de pollo", "stock"),  # no chicken
        ("aceite de oliva", "oil"),  # no olive
        ("disco de pizza", "flatbread"),
        ("fresh hiyamugi noodles", "dry pasta"),
        ("mamaliga", "dry grain"),
        ("papaya", "peel fruit"),
        ("garden eggs", "eggplant"),
    ],
)
def test_names_of_many_lands_are_known(asked, kind):
    assert FOODS.food(asked).kind == kind


@pytest.mark.parametrize(
    ("asked", "kind"),
    [
        ("miel de acacia", "syrup"),  # honey, and in Romanian alone a lamb
        ("rosmarino", "woody herb"),  # and a pasta
        ("oleo", "butter"),
        ("malai", "cream"),
        ("gata", "plant milk"),
        ("filetto di merluzzo", "fish"),
        ("polpa di maiale", "meat"),
        ("mango maduro", "peel fruit"),  # only ripe
        ("cherries glacé", "dried fruit"),  # no ice cream
        ("peanut butter crunchy", "nut butter"),
        ("steak tartare", "meat"),
    ],
)
def test_no_name_takes_another_food(asked, kind):
    assert FOODS.food(asked).kind == kind


@pytest.mark.parametrize(
    ("other", "listed"),
    [
        ("bacalao salado", "salt cod"),
        ("mejillones", "mussel"),
        ("pulpo", "squid"),
        ("alimango", "crab"),
        ("tteokbokki rice cakes", "tteok"),
        ("kho qua", "bitter melon"),
        ("dudhi", "bottle gourd"),
        ("molokheya", "jute leaf"),
        ("papadom", "papad"),
        ("friarielli", "rapini"),
        ("canned corn", "canned peas"),
        ("tinned sardines", "sardine"),
        ("konbu", "kombu"),
        ("omani limes", "dried lime"),
    ],
)
def test_what_is_the_same_food_is_of_one_kind(other, listed):
    assert FOODS.food(other).kind == FOODS.food(listed).kind


def test_another_name_has_what_its_states_make_of_the_food():
    assert FOODS.food("fagioli", ["canned"]).kind == FOODS.food("dried bean", ["canned"]).kind == "canned pulse"
    assert FOODS.food("elote", ["frozen"]).kind == FOODS.food("corn", ["frozen"]).kind


@pytest.mark.parametrize(
    ("name", "state", "kind"),
    [
        ("mustard", "dry", "ground spice"),
        ("flake", "pieces", "ground spice"),
        ("chili flakes", "whole", "ground spice"),
        ("currant", "jelly", "jam"),
        ("sesame", "oily", "oil"),
        ("crab", "pieces", "ready shellfish"),
        ("pork rind", "raw", "meat"),
        ("pork rinds", "crushed", "snack"),
        ("taro leaves", "dried", "dried green"),
        ("matchstick carrots", "whole", "shredded salad mix"),
    ],
)
def test_a_state_tells_what_of_that_name_is_meant(name, state, kind):
    assert FOODS.food(name, [state]).kind == kind
