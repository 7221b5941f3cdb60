"""What is cooked in one open vessel joins in the order in which a cook would do it."""

from __future__ import annotations

import pytest
from demo_foon import demo_subgraphs
from integration.told import KITCHEN

from foon_kg.food import tables
from foon_kg.integration.joining.additions import phase_of
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.store.snapshot import Snapshot

KNOWN = tables()


@pytest.fixture(scope="module")
def planner():
    read = demo_subgraphs()
    snapshot = Snapshot.of(read, KITCHEN)
    return Planner(snapshot, PlanSettings(KITCHEN, time_limit=None), snapshot.units)


def planned(planner, dish_type, **foods):
    asked = tuple(RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items())
    return planner.plan(Recipe(dish_type, asked, "x", None)).units


def into_heat(units, *foods):
    """Return the number of the first heating at which each food is there."""
    hot = [unit for unit in units if "heat" in KNOWN.motion(unit.motion).does]
    names = [{node.label for node in unit.input_nodes} for unit in hot]
    return [next((place for place, there in enumerate(names) if food in there), None) for food in foods]


@pytest.mark.parametrize(
    ("food", "phase"),
    [
        ("onion", "is fried"),
        ("bacon", "is fried"),
        ("garlic", "is stirred into the fat"),
        ("flour", "is stirred into the fat"),
        ("chicken broth", "cooks in the liquid"),
        ("dried oregano", "cooks in the liquid"),
        ("spinach", "is done soon"),
        ("shrimp", "is done soon"),
        ("heavy cream", "is stirred in last"),
        ("rose water", "is stirred in last"),
        ("cheddar", "is stirred in last"),
    ],
)
def test_a_food_joins_by_its_kind(food, phase):
    assert phase_of(KNOWN.foods.food(food)) == phase


def test_onions_fry_before_the_liquid_comes_and_cream_comes_last(planner):
    units = planned(
        planner, "soup", potato="diced", onion="chopped", flour="powder", butter="stick", chicken_broth="liquid",
        heavy_cream="liquid",
    )  # fmt: skip
    onion, flour, broth, cream = into_heat(units, "onion", "flour", "chicken broth", "heavy cream")
    assert onion < flour < broth < cream


def test_bacon_is_fried_before_it_is_boiled(planner):
    units = planned(planner, "soup", potato="diced", bacon="chopped", onion="chopped", chicken_broth="liquid")
    bacon, broth = into_heat(units, "bacon", "chicken broth")
    assert bacon < broth


def test_vegetables_fry_before_eggs_set_around_them(planner):
    units = planned(planner, "omelette", egg="whole", onion="chopped", mushroom="sliced", butter="stick")
    hot = [unit for unit in units if "heat" in KNOWN.motion(unit.motion).does]
    assert into_heat(units, "onion", "mushroom") == [0, 0]
    assert not any("egg" in {node.label, *node.ingredients} for node in hot[0].input_nodes)


def test_no_soup_is_made_without_a_liquid(planner):
    units = planned(planner, "soup", beet="grated", potato="diced", carrot="grated", vinegar="liquid")
    assert any(node.label == "water" for unit in units for node in unit.input_nodes)


def test_no_knife_goes_through_a_bone(planner):
    units = planned(planner, "soup", oxtail="raw", lentil="dried", onion="chopped", water="liquid")
    cuts = [unit for unit in units if "cut" in KNOWN.motion(unit.motion).does]
    assert not any(node.label == "oxtail" for unit in cuts for node in unit.input_nodes)


def test_potatoes_come_when_tough_meat_is_nearly_done(planner):
    units = planned(
        planner, "soup", beef_chuck="cubed", potato="diced", onion="chopped", olive_oil="liquid", beef_broth="liquid"
    )
    broth, potato = into_heat(units, "beef broth", "potato")
    assert broth < potato


def test_potatoes_come_with_the_liquid_where_nothing_takes_longer(planner):
    units = planned(planner, "soup", chicken="chopped", potato="diced", onion="chopped", chicken_broth="liquid")
    broth, potato = into_heat(units, "chicken broth", "potato")
    assert broth == potato


def test_tender_steak_is_simmered_no_longer_than_the_rest(planner):
    units = planned(planner, "soup", sirloin_steak="sliced", potato="diced", onion="chopped", beef_broth="liquid")
    broth, potato = into_heat(units, "beef broth", "potato")
    assert broth == potato


def test_what_is_soft_in_minutes_comes_after_what_is_hard(planner):
    units = planned(
        planner, "soup", pork_belly="cubed", taro="halved", okra="trimmed", eggplant="sliced", onion="quartered",
        water="liquid",
    )  # fmt: skip
    pork, taro, okra, eggplant = into_heat(units, "pork belly", "taro", "okra", "eggplant")
    assert pork < taro < okra == eggplant


def test_dry_beans_have_their_time_before_potatoes_come(planner):
    units = planned(planner, "soup", chickpea="dried", potato="diced", onion="chopped", olive_oil="liquid")
    chickpea, potato = into_heat(units, "chickpea", "potato")
    assert chickpea < potato


def test_whole_spices_come_into_the_hot_fat_first(planner):
    units = planned(
        planner, "soup", lentil="dried", onion="sliced", cinnamon_stick="whole", cumin_seed="whole", ghee="liquid",
        water="liquid",
    )  # fmt: skip
    cinnamon, cumin, onion, lentil = into_heat(units, "cinnamon stick", "cumin seed", "onion", "lentil")
    assert cinnamon == cumin <= onion < lentil


def test_milk_comes_when_what_cooks_in_the_stock_is_done(planner):
    units = planned(
        planner, "soup", potato="diced", onion="chopped", butter="stick", chicken_broth="liquid", milk="liquid"
    )
    potato, broth, milk = into_heat(units, "potato", "chicken broth", "milk")
    assert potato == broth < milk


def test_what_cooks_in_milk_alone_has_it_from_the_start(planner):
    units = planned(planner, "soup", potato="diced", onion="chopped", butter="stick", milk="liquid")
    potato, milk = into_heat(units, "potato", "milk")
    assert potato == milk
