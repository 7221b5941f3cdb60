"""How things are moved, cut and cooled in trees of the public FOON."""

from __future__ import annotations

import pytest
from planner.public_foon import answers_to

from foon_kg.food import tables
from foon_kg.model import Recipe, RequiredIngredient

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]

KNOWN = tables()


def units(dish_type, title, **foods):
    """Return the units of a recipe's tree; its foods with the states in which they are asked."""
    asked = tuple(RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items())
    (answer,) = answers_to([Recipe(dish_type, asked, "x", title)])
    return answer.units


def motions(found, food):
    """Return the motions in which a food takes part, in their order."""
    return [unit.motion for unit in found if food in {node.label for node in unit.input_nodes}]


def labels(unit):
    return {node.label for node in unit.input_nodes}


def brought(found, food, vessel):
    """Return how a food comes into or onto a vessel."""
    return next(
        unit.motion for unit in found
        if food in labels(unit) and any(n.label == food and n.container == vessel for n in unit.output_nodes)
        and not any(n.label == food and n.container == vessel for n in unit.input_nodes)
    )  # fmt: skip


@pytest.fixture(scope="module")
def burger():
    return units(
        "burger", "Cheeseburger", ground_beef="", red_onion="sliced", shallot="minced",
        cheddar_cheese="sliced", bun="", ketchup="", salt="",
    )  # fmt: skip


def test_slices_are_laid_on_a_plate_and_not_poured(burger):
    assert brought(burger, "cheddar cheese", "plate") == "pick-and-place"
    assert brought(burger, "red onion", "plate") == "pick-and-place"


def test_what_is_asked_in_slices_lies_on_a_patty_and_what_is_minced_is_in_it(burger):
    mixing = next(unit for unit in burger if unit.motion == "mix")
    assert {"ground beef", "shallot"} <= labels(mixing)
    assert "red onion" not in labels(mixing)


def test_a_pan_is_hot_when_a_patty_comes_into_it_and_a_tool_lifts_that_out(burger):
    on = next(number for number, unit in enumerate(burger) if unit.motion == "turn on")
    held = [{n.container for n in unit.output_nodes if n.label == "patties"} for unit in burger]
    in_the_pan = next(number for number, containers in enumerate(held) if "cooking pan" in containers)
    assert on < in_the_pan
    lifted = next(number for number, containers in enumerate(held) if number > in_the_pan and "plate" in containers)
    assert "turner" in labels(burger[lifted])


def test_small_pieces_are_poured_and_never_picked_up_one_by_one():
    found = units(
        "chicken", "Chicken Curry", chicken_thigh="cut", onion="chopped", tomato="diced", oil="",
        cumin="ground", coconut_milk="",
    )  # fmt: skip
    picked = {label for unit in found if unit.motion == "pick-and-place" for label in labels(unit)}
    assert picked.isdisjoint({"onion", "tomato", "cumin", "coconut milk"})


@pytest.mark.parametrize("title", ["Banana Smoothie", "Mango Lassi"])
def test_what_is_called_so_is_blended_though_its_fruit_is_asked_cut(title):
    found = units("drinks", title, banana="sliced", mango="chopped", yogurt="", milk="", honey="")
    assert "blend" in motions(found, "banana")


def test_whatever_is_asked_grated_is_grated_with_a_grater():
    found = units("salad", "Slaw", apple="grated", beet="grated", garlic="grated", mayonnaise="")
    for food in ("apple", "beet", "garlic"):
        assert any("grater" in labels(unit) for unit in found if food in labels(unit))


def test_what_only_gives_its_taste_is_in_the_dressing():
    found = units(
        "salad", "Caesar Salad", romaine_lettuce="chopped", garlic="minced", anchovy="mashed", egg_yolk="",
        olive_oil="", lemon_juice="", crouton="",
    )  # fmt: skip
    dressing = next(unit for unit in found if unit.motion == "mix" and "olive oil" in labels(unit))
    assert {"garlic", "anchovy", "egg yolk"} <= labels(dressing)


def test_what_is_boiled_for_a_cold_salad_is_cooled_under_water():
    found = units(
        "salad", "Pasta Salad", rotini="", cherry_tomato="halved", olive="sliced", italian_dressing="",
        green_bean="blanched",
    )  # fmt: skip
    for food in ("rotini", "green bean"):
        done = motions(found, food)
        assert "rinse" in done
        assert not {"fry", "cook and stir"} & set(done)


def test_flesh_without_fat_is_fried_before_what_it_is_tossed_with():
    found = units(
        "noodle", "Pad Thai", rice_noodle="", shrimp="peeled", egg="beaten", fish_sauce="", sugar="",
        bean_sprout="",
    )  # fmt: skip
    hot = [labels(unit) for unit in found if KNOWN.motion(unit.motion).does & {"heat"}]
    shrimp = next(number for number, there in enumerate(hot) if "shrimp" in there)
    assert "rice noodle" not in hot[shrimp]


def test_what_is_asked_ready_made_needs_no_parts():
    found = units("sandwich", "Falafel Pita", pita_bread="", falafel="", tahini="", tomato="sliced")
    assert "falafel" in set().union(*map(labels, found))


def test_a_soup_that_is_called_chilled_is_not_heated():
    found = units(
        "soup", "Chilled Cucumber Avocado Soup", cucumber="chopped", avocado="", buttermilk="", lime_juice="",
    )  # fmt: skip
    assert not [unit for unit in found if KNOWN.motion(unit.motion).does & {"heat"}]


def test_flesh_in_pieces_is_fried_with_its_vegetables_and_then_laid_on_bread():
    found = units(
        "chicken", "Chicken Fajitas", chicken_breast="sliced", bell_pepper="sliced", onion="sliced", oil="",
        tortilla="",
    )  # fmt: skip
    hot = [labels(unit) for unit in found if KNOWN.motion(unit.motion).does & {"heat"}]
    assert {"chicken breast", "bell pepper", "onion"} <= hot[-1]
    assert not any("tortilla" in there for there in hot)


def test_meat_that_is_done_is_not_cooked_again_for_bread():
    found = units("sandwich", "Roast Beef Sandwich", rye_bread="", roast_beef="sliced", cheese="", tomato="sliced")
    assert not [unit for unit in found if KNOWN.motion(unit.motion).does & {"heat"}]


SPOONED = {
    "fruit": ("Summer pudding", {"raspberry": "", "redcurrant": "", "sugar": "granulated", "white_bread": "sliced"}),
    "custard": ("Banana pudding", {"egg_yolk": "", "whole_milk": "liquid", "flour": "", "sugar": "granulated",
                                   "vanilla_wafer": "", "banana": "sliced"}),
}  # fmt: skip
"""Puddings of what was cooked in a saucepan and has no form."""


@pytest.mark.parametrize(("title", "foods"), SPOONED.values(), ids=SPOONED)
def test_nobody_lifts_out_of_a_saucepan_with_a_turner_what_has_no_form(title, foods):
    found = units("pudding", title, **foods)
    emptied = [unit for unit in found if any(n.label == "saucepan" and "empty" in n.states for n in unit.output_nodes)]
    assert emptied
    assert all("turner" not in labels(unit) for unit in emptied)


def test_what_was_baked_firm_is_poured_out_of_its_dish_by_no_name():
    found = units(
        "pudding", "Cherry clafoutis", cherries="pitted", butter="unmelted", caster_sugar="granulated", eggs="whole",
        flour="plain", whole_milk="liquid", double_cream="creamy", vanilla_extract="liquid", icing_sugar="powder",
    )  # fmt: skip
    emptied = [unit for unit in found if any("hot" in n.states and "empty" in n.states for n in unit.output_nodes)]
    assert emptied
    assert all(unit.motion != "pour" for unit in emptied)
