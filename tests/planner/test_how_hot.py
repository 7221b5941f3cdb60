"""What joins what, and how hot: nothing hot comes on what is eaten cold, and nothing dry makes lumps."""

from __future__ import annotations

import pytest
from planner.told_steps import first, motions

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]


@pytest.mark.parametrize(
    ("food", "beside"),
    [
        ("walnut:toasted", "apple:diced celery:chopped mayonnaise:creamy"),
        ("chicken breast:cooked", "lettuce:chopped cucumber:sliced yogurt:creamy"),
        ("rice:cooked", "pea:thawed onion:chopped mayonnaise:creamy"),
        ("potato:diced", "celery:chopped mayonnaise:creamy mustard:creamy"),
        ("bacon:fried", "spinach:leaves onion:sliced olive_oil:liquid vinegar:liquid"),
    ],
)
def test_what_is_cooked_for_a_salad_cools_before_it_meets_the_rest(steps, food, beside):
    told = steps("salad", "", food, *(one.replace("_", " ") for one in beside.split()))
    label = food.partition(":")[0]
    assert {"cool", "cool down"} & {one for inputs, one, _ in told if label in inputs}, motions(told)


def test_what_was_rinsed_is_cold_and_a_warm_salad_does_not_cool(steps):
    foods = "egg:hard boiled", "celery:chopped", "mayonnaise:creamy"
    assert not {"cool", "cool down"} & set(motions(steps("salad", "Egg Salad", *foods)))
    warm = steps("salad", "Warm Chicken Salad", "chicken breast:cooked", "lettuce:chopped", "olive oil:liquid")
    assert not {"cool", "cool down"} & set(motions(warm))


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("soup", "", "onion:dried cornstarch:powder bouillon:granulated basil:dried"),
        ("beef", "Pot Roast", "chuck_roast:raw oil:liquid potato:cut carrot:cut beef_broth:liquid cornstarch:powder"),
        ("noodle", "", "noodle:uncooked butter:stick milk:liquid cornstarch:powder cheddar:shredded"),
    ],
)
def test_starch_is_stirred_smooth_with_cold_water_before_it_comes_to_a_hot_liquid(steps, dish_type, title, foods):
    told = steps(dish_type, title, *(food.replace("_", " ") for food in foods.split()))
    stirred = first(told, "cornstarch", "stir")
    assert told[stirred][0] == {"cornstarch", "water", "bowl", "spoon"}
    assert "faucet" in told[stirred - 1][0]


def test_flour_measured_by_its_video_is_stirred_into_the_fat_before_the_liquid_comes(steps):
    told = steps(
        "soup", "", "broccoli:peeled", "onion:chopped", "water:liquid", "pea:thawed", "butter:softened", "flour:ground",
        "half and half:liquid", "chive:minced",
    )  # fmt: skip
    assert first(told, "flour", "cook and stir") < next(n for n, one in enumerate(told) if one[0] >= {"water", "pot"})


@pytest.mark.parametrize("fat", ["butter:stick", "margarine:creamy", "butter:melted"])
def test_what_greases_a_tin_lay_out_of_the_refrigerator(public_plans, fat):
    units = public_plans("cake", "Plain Cake", "flour:ground", "egg:whole", "sugar:ground", "milk:liquid", fat).units
    spread = next(unit for unit in units if unit.motion == "spread")
    assert {"softened"} == {state for n in spread.input_nodes if n.label in fat for state in n.states}


def test_what_cooks_is_stirred_with_a_tool(public_plans):
    foods = "rice:grain", "oil:liquid", "shallot:chopped", "garlic:chopped", "cream:liquid", "turmeric:ground"
    stirred = [unit for unit in public_plans("rice", "", *foods).units if unit.motion == "cook and stir"]
    assert stirred
    assert all({"spoon", "spatula", "turner"} & {node.label for node in unit.input_nodes} for unit in stirred)


def test_water_is_for_the_grain_of_a_salad_or_thins_its_dressing(steps):
    rice = steps("salad", "", "water:liquid", "rice:grain", "onion:chopped", "ham:sliced", "mayonnaise:creamy")
    boiled = [inputs for inputs, motion, _ in rice if "water" in inputs and motion in {"pour", "pick-and-place"}]
    assert boiled == [{"water", "pot", "faucet"}]
    assert not {"drain", "rinse"} & {motion for inputs, motion, _ in rice if "rice" in inputs}
    thinned = steps(
        "salad", "", "water:liquid", "vinegar:liquid", "oil:liquid", "tomato:sliced", "celery:sliced", "olive:chopped"
    )
    mixed = [set(outputs[0].ingredients) for _, motion, outputs in thinned if motion in {"mix", "stir", "whisk"}]
    assert {"oil", "vinegar", "water"} in mixed


BROTH = "chicken:chopped", "onion:chopped", "carrot:chopped", "noodle:uncooked", "oil:liquid"


@pytest.mark.parametrize(
    ("title", "foods", "boiled"),
    [
        ("", ("stock:liquid",), {"stock"}),
        ("", ("water:liquid", "soy sauce:liquid"), {"soy sauce"}),
        ("Chicken Noodle Soup", ("broth:liquid",), {"broth"}),
    ],
)
def test_noodles_are_boiled_in_the_broth_that_they_are_eaten_in(public_plans, title, foods, boiled):
    units = public_plans("noodle", title, *BROTH, *foods).units
    assert "strainer" not in {node.label for unit in units for node in unit.input_nodes}
    (pot,) = {food for unit in units if "noodle" in {n.label for n in unit.input_nodes} and unit.motion == "pour"
              for node in unit.output_nodes if node.label == "pot" for food in node.ingredients} & boiled  # fmt: skip
    assert {pot} == boiled


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Chicken Lo Mein", ("stock:liquid", "soy sauce:liquid")),
        ("", ("stock:liquid", "cream:liquid")),
        ("", ("stock:liquid", "cheddar:shredded")),
        ("", ("stock:liquid", "cornstarch:powder")),
        ("", ("soy sauce:liquid",)),
    ],
)
def test_noodles_with_a_sauce_are_boiled_by_themselves(public_plans, title, foods):
    units = public_plans("noodle", title, *BROTH, *foods).units
    assert "strainer" in {node.label for unit in units for node in unit.input_nodes}


def test_noodles_that_are_asked_done_are_boiled_in_their_broth_too_and_leftovers_are_not(public_plans):
    def boiled(state):
        foods = (*(food for food in BROTH if not food.startswith("noodle")), f"noodle:{state}", "stock:liquid")
        return "strainer" not in {
            node.label for one in public_plans("noodle", "", *foods).units for node in one.input_nodes
        }

    assert boiled("cooked")
    assert boiled("baked")
    assert not boiled("leftover")
