"""What is baked: a batter comes together in its order, its parts are made apart, and a bake ends in the oven."""

from __future__ import annotations

import pytest
from planner.public_foon import public_planner

from foon_kg.food import tables
from foon_kg.integration.composing.parts import parts_of
from foon_kg.integration.joining.batters import is_of_batter, is_of_dough
from foon_kg.integration.preparing.understanding import wants_of
from foon_kg.integration.teaching.operators import Operators
from foon_kg.model import Recipe, RequiredIngredient

KNOWN = tables()
CAKE = {
    "flour": "", "sugar": "", "vegetable oil": "", "egg": "", "baking soda": "", "carrot": "grated",
    "walnut": "chopped", "lemon juice": "",
}  # fmt: skip
FROSTING = {"cream cheese": "softened", "butter": "softened", "powdered sugar": ""}
BREAD = {"flour": "", "yeast": "", "water": "", "olive oil": "", "salt": "", "cherry tomato": "halved"}


def asked(**foods):
    return [RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items()]


def wants(foods):
    return wants_of(asked(**foods), KNOWN, Operators(()))


def names(part):
    return {want.label for want in part.wants}


@pytest.fixture(scope="module")
def planner():
    return public_planner()


def steps(planner, dish_type, title, foods):
    """Return each step as its motion, the labels that go in, and those that come out."""
    units = planner.plan(Recipe(dish_type, tuple(asked(**foods)), "one", title)).units
    return [
        (unit.motion, {node.label for node in unit.input_nodes}, {node.label for node in unit.output_nodes})
        for unit in units
    ]


def place(told, food, motions):
    """Return the first step of such a motion that a food is in."""
    return next(n for n, (motion, into, _) in enumerate(told) if motion in motions and food in into)


def test_flour_without_yeast_makes_a_batter_and_with_it_a_dough():
    assert is_of_batter(wants(CAKE))
    assert not is_of_batter(wants(BREAD))
    assert is_of_dough(wants(BREAD))
    assert not is_of_batter(wants({"bread": "sliced", "flour": "", "egg": ""}))


def test_soft_cheese_with_icing_sugar_and_a_second_fat_is_a_part():
    rest, (part,) = parts_of(wants(CAKE | FROSTING), "cake", "", (), KNOWN)
    assert names(part) == {*FROSTING}
    assert {want.label for want in rest} == {*CAKE}


def test_the_only_sugar_and_the_only_fat_are_the_batters():
    foods = {"flour": "", "powdered sugar": "", "butter": "", "tahini": ""}
    assert parts_of(wants(foods), "cookie", "", (), KNOWN)[1] == ()


def test_of_a_food_listed_twice_a_second_portion_belongs_to_the_part():
    foods = CAKE | {"cream cheese": "", "butter": ""}
    rest, (part,) = parts_of(wants(foods), "cake", "", {"sugar", "butter"}, KNOWN)
    assert names(part) == {"cream cheese", "butter", "sugar"}
    assert {"sugar", "butter"} <= {want.label for want in rest}
    assert not {want.number for want in part.wants} & {want.number for want in rest}


@pytest.mark.parametrize(("title", "count"), [("glazed lemon cake", 2), ("lemon cake", 1)])
def test_icing_sugar_is_stirred_to_a_glaze_where_the_title_says_so_and_dusted_else(title, count):
    _, (part,) = parts_of(wants(CAKE | {"powdered sugar": ""}), "cake", title, (), KNOWN)
    assert len(part.wants) == count


def test_only_what_is_baked_in_a_tin_has_parts():
    assert parts_of(wants(CAKE | FROSTING), "soup", "", (), KNOWN)[1] == ()


def test_tomatoes_lie_on_a_dough():
    _, (part,) = parts_of(wants(BREAD), "bread", "", (), KNOWN)
    assert part.baked
    assert names(part) == {"cherry tomato"}


@pytest.mark.slow
@pytest.mark.parametrize("dish_type", ["cake", "muffin", "cookie", "bread"])
def test_juice_joins_what_runs_and_pieces_are_folded_in_last(planner, dish_type):
    told = steps(planner, dish_type, "", CAKE)
    mixing = {"mix", "stir", "beat", "blend", "fold", "whisk"}
    dry = place(told, "baking soda", mixing)
    assert not {"lemon juice", "walnut", "carrot", "vegetable oil"} & told[dry][1]
    assert place(told, "walnut", mixing) > place(told, "lemon juice", mixing)
    assert place(told, "vegetable oil", mixing) < place(told, "walnut", mixing)


@pytest.mark.slow
def test_a_cake_is_covered_when_it_has_cooled(planner):
    told = steps(planner, "cake", "carrot cake", CAKE | FROSTING)
    motions = [motion for motion, _, _ in told]
    assert motions.index("bake") < motions.index("cool down")
    assert motions[-1] == "spread"


def test_cream_asked_whipped_is_whipped_by_itself_and_comes_onto_the_cake_when_it_has_cooled(planner):
    told = steps(planner, "cake", "cream cake", CAKE | {"heavy cream": "whipped"})
    motions = [motion for motion, _, _ in told]
    whipped = next(n for n, (motion, into, _) in enumerate(told) if motion == "beat" and "heavy cream" in into)
    assert told[whipped][1] - {"heavy cream"} == {"bowl", "whisk"}
    assert "heavy cream" in told[-1][1]
    assert motions.index("cool down") < len(told) - 1


def test_a_bake_comes_into_the_oven_with_its_crumbs_on_top(planner):
    foods = {"rice": "", "broccoli": "chopped", "milk": "", "butter": "", "cheddar cheese": "grated"}
    told = steps(planner, "rice", "broccoli rice bake", foods)
    baked = place(told, "cheddar cheese", {"bake"})
    assert told[baked][1] >= {"baking dish", "oven"}


@pytest.mark.parametrize(("title", "tin"), [("soft pita", "baking tray"), ("white loaf", "loaf pan")])
def test_a_dough_rises_once_and_is_baked_in_what_suits_it(planner, title, tin):
    told = steps(planner, "bread", title, BREAD)
    motions = [motion for motion, _, _ in told]
    assert motions.count("knead") == 1
    assert ("press" in motions) == (tin == "baking tray")
    assert any(motion == "bake" and tin in into for motion, into, _ in told)


CHEESECAKE = {"graham cracker crumbs": "", "butter": "melted", "cream cheese": "softened", "sugar": "", "egg": ""}


def test_crumbs_with_butter_are_pressed_in_the_tin_before_what_is_baked_on_them(planner):
    told = steps(planner, "cake", "cheesecake", CHEESECAKE)
    mixed = place(told, "graham cracker crumbs", {"mix", "stir"})
    assert "cream cheese" not in told[mixed][1]
    assert [motion for motion, _, _ in told].count("bake") == 1


def test_what_is_not_to_be_baked_sets_in_the_cold(planner):
    foods = {food: state for food, state in CHEESECAKE.items() if food != "egg"}
    motions = [motion for motion, _, _ in steps(planner, "cake", "no-bake cheesecake", foods)]
    assert "bake" not in motions
    assert "chill" in motions


@pytest.mark.parametrize(
    "foods",
    [
        {"shredded coconut": "", "egg white": "", "sugar": "", "vanilla extract": ""},
        {"peanut butter": "", "sugar": "", "egg": "", "baking soda": ""},
    ],
)
def test_a_batter_without_flour_is_set_on_a_tray_with_a_spoon(planner, foods):
    told = steps(planner, "cookie", "", foods)
    assert any(motion == "scoop and pour" and "baking tray" in into for motion, into, _ in told)


@pytest.mark.parametrize(("title", "cuts"), [("white loaf", False), ("dinner rolls", True)])
def test_a_dough_is_shaped_and_rolls_are_cut_before(planner, title, cuts):
    foods = {"flour": "", "yeast": "", "water": "", "salt": "", "olive oil": ""}
    motions = [motion for motion, _, _ in steps(planner, "bread", title, foods)]
    assert motions.index("shape") < motions.index("bake")
    assert ("cut" in motions) == cuts


def test_an_omelette_is_folded_and_scrambled_eggs_are_not(planner):
    foods = {"egg": "", "butter": "", "salt": ""}
    assert "fold" in [motion for motion, _, _ in steps(planner, "omelette", "plain omelette", foods)]
    assert "fold" not in [motion for motion, _, _ in steps(planner, "omelette", "scrambled eggs", foods)]
