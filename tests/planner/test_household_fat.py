"""Fat that nobody asked for: where food would stick in a dry pan, where nobody may have any, and that it is told."""

from __future__ import annotations

import pytest
from planner.public_foon import public_snapshot

from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.planning.avoidance import household_fat
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.stock import StockedKitchen

pytestmark = pytest.mark.shared_data

OMELETTE = ("egg:whole raw", "onion:chopped", "mushroom:sliced", "salt:granulated")


def fats(result):
    """Return the vessels into which oil came out of its bottle."""
    return [
        next(node.container for node in unit.output_nodes if node.label == "oil")
        for unit in result.units
        if any((node.label, node.container) == ("oil", "bottle") for node in unit.input_nodes)
    ]


def test_what_is_fried_comes_into_the_oil_of_the_household_which_is_told(public_plans):
    result = public_plans("omelette", "Mushroom Omelette", *OMELETTE)
    assert len(fats(result)) == 1
    (told,) = [one for one in result.assumptions if one.node.label == "oil"]
    assert told.node == ObjectNode("oil", ("liquid",), (), "in", "bottle")
    assert "nobody asked for fat" in told.why
    assert "oil" in result.goal.ingredients


@pytest.mark.parametrize(
    ("dish", "title", "asked"),
    [
        ("burger", "Salmon Burgers", ("salmon:canned", "egg:whole", "breadcrumb:crumbs", "bun:halved")),
        ("steak", "Steak", ("steak:raw", "salt:granulated", "black pepper:ground")),
        ("casserole", "Green Bean Casserole", ("green bean:canned", "mushroom soup:canned", "onion:fried")),
    ],
)
def test_patties_flesh_and_onions_are_fried_in_it(public_plans, dish, title, asked):
    assert fats(public_plans(dish, title, *asked))


@pytest.mark.parametrize(
    ("dish", "title", "asked"),
    [
        ("omelette", "Omelette", (*OMELETTE, "butter:stick")),
        ("omelette", "Omelette", (*OMELETTE, "bacon:raw")),
        ("omelette", "Omelette", (*OMELETTE, "sausage:crumbled")),
        ("omelette", "Fat-Free Omelette", OMELETTE),
        ("salad", "Salad", ("sesame seed:toasted", "lettuce:whole", "vinegar:liquid")),
        ("sauce", "Berry Compote", ("strawberry:quartered", "raspberry:berries", "sugar:granulated")),
        ("soup", "Vegetable Soup", ("water:liquid", "carrot:diced", "chicken stock:liquid")),
        ("noodle", "Noodles with Mince", ("beef:ground", "noodle:dried", "soy sauce:liquid")),
    ],
)
def test_there_is_none_where_fat_comes_anyhow_or_nothing_sticks(public_plans, dish, title, asked):
    result = public_plans(dish, title, *asked)
    assert fats(result) == []
    assert not [one for one in result.assumptions if "nobody asked for fat" in one.why]


def omelette(settings):
    snapshot = public_snapshot()
    foods = tuple(RequiredIngredient(*food.split(":")) for food in OMELETTE)
    return Planner(snapshot, settings, snapshot.units).plan(Recipe("omelette", foods, "x", "Omelette"))


@pytest.mark.parametrize("avoided", ["oil", "fat"])
def test_who_avoids_it_gets_none(avoided):
    assert fats(omelette(PlanSettings(time_limit=None, avoided=(avoided,)))) == []


def in_a_kitchen_with(*named, **wishes):
    """Return the omelette as a kitchen with its foods and those ``named`` makes it."""
    foods = [ObjectNode(food.partition(":")[0]) for food in OMELETTE]
    kitchen = StockedKitchen.of(Kitchen.default(), [*foods, *map(ObjectNode, named)])
    return omelette(PlanSettings(kitchen=kitchen, time_limit=None, **wishes))


def told_fats(result):
    return [one.node.label for one in result.assumptions if "nobody asked for fat" in one.why]


@pytest.mark.parametrize(
    ("named", "avoided", "fat"),
    [
        ((), (), []),
        (("oil",), (), ["oil"]),
        (("olive oil",), (), ["olive oil"]),
        (("olive oil", "oil"), (), ["oil"]),
        (("butter", "sunflower oil"), (), ["sunflower oil"]),
        (("butter",), (), ["butter"]),
        (("lard",), (), ["lard"]),
        (("butter",), ("dairy",), []),
        (("butter", "lard"), ("dairy",), ["lard"]),
        (("mayonnaise",), (), []),
    ],
)
def test_a_named_kitchen_fries_in_whatever_fat_it_has_and_the_wishes_allow(named, avoided, fat):
    result = in_a_kitchen_with(*named, avoided=avoided)
    assert told_fats(result) == fat
    assert set(fat) <= set(result.goal.ingredients)


def test_the_fat_of_a_kitchen_is_taken_as_it_is_there():
    kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("butter", ("stick",), (), "in", "bowl")])
    fat = household_fat((), "", kitchen, (), public_snapshot().methods().operators)
    assert fat is not None
    assert (fat.leaf, fat.storage, fat.stands) == (("stick",), "bowl", True)


def test_oil_of_the_household_is_told_for_each_pan_into_which_it_comes(public_plans):
    result = public_plans(
        "burger", "Blue Cheese Stuffed Burgers",
        "ground beef:uncooked", "blue cheese:crumbled", "Worcestershire sauce:sauce", "garlic powder:ground",
        "onion:caramelized", "kaiser rolls:split", "arugula:leaves",
    )  # fmt: skip
    assert len(fats(result)) > 1
    assert len([one for one in result.assumptions if one.node.label == "oil"]) == len(fats(result))


def test_fat_is_hot_before_food_comes_to_it_and_fried_potatoes_are_lifted_out_of_it(public_plans):
    asked = ("pork loin:diced", "clam:whole", "garlic:crushed", "white wine:liquid", "lard:creamy", "potatoes:fried")
    told = [(unit.motion, unit.input_nodes) for unit in public_plans("pork", "Pork and Clams", *asked).units]
    (melted, fried) = [
        motion for motion, nodes in told for node in nodes if (node.label, node.container) == ("lard", "cooking pan")
    ][:2]
    assert (melted, fried) == ("melt", "cook and stir")
    (out,) = [nodes for motion, nodes in told if motion == "remove" and any(node.label == "tong" for node in nodes)]
    assert {"potatoes", "lard"} & {node.label for node in out} == {"potatoes"}
