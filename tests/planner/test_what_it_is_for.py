"""Lists say flat what cooks keep apart: what lies under or beside a dish, and what is one part of it."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

HOT = {"bake", "boil", "cook", "cook and stir", "fry", "simmer"}


def heated(told):
    """Return all that is in a vessel while anything is heated."""
    return {name for _, motion, outputs in told if motion in HOT for node in outputs for name in node.ingredients}


def joins_last(told, food):
    """Whether a food joins the rest after all that is heated."""
    hot = max(place for place, motion in enumerate(motions(told)) if motion in HOT)
    return max(place for place, (inputs, _, _) in enumerate(told) if food in inputs) > hot


# ---------------------------------------------------------------- eaten with it


@pytest.mark.parametrize(
    ("dish_type", "foods", "beside"),
    [
        (
            "seafood",
            ("mussels:whole", "white wine:liquid", "shallot:minced", "butter:solid", "cream:liquid"),
            "baguette:sliced",
        ),
        (
            "chicken",
            ("chicken thigh:cubed", "onion:chopped", "curry powder:ground", "coconut milk:liquid"),
            "naan:whole",
        ),
        (
            "sausage",
            ("sausage:whole", "lentils:dried", "carrot:diced", "onion:diced", "stock:liquid"),
            "crusty bread:sliced",
        ),
        ("pork", ("pork chop:raw", "apple:sliced", "butter:solid", "cider:liquid"), "coleslaw:mixed"),
    ],
)
def test_what_is_eaten_with_a_dish_is_never_heated_in_it(steps, dish_type, foods, beside):
    told = steps(dish_type, "", *foods, beside)
    label = beside.partition(":")[0]
    assert label not in heated(told)
    assert joins_last(told, label)


def test_bread_that_binds_minced_meat_is_no_side(steps):
    told = steps("beef", "", "ground beef:raw", "egg:uncooked", "bread:soaked", "onion:chopped", "oil:liquid")
    assert "bread" in heated(told)


def test_a_roll_is_filled_with_what_was_fried(steps):
    told = steps("sausage", "", "sausage:sliced", "pepper:sliced", "onion:sliced", "tomato:diced", "roll:whole")
    assert "roll" not in heated(told)
    assert first(told, "roll", "pick-and-place") < len(told) - 1


def test_a_sauce_of_sausage_comes_over_split_biscuits(steps):
    told = steps("sausage", "", "sausage:ground", "flour:powder", "milk:liquid", "pepper:ground", "biscuits:baked")
    assert "biscuits" not in inside(told, "simmer")
    assert {"sausage", "flour", "milk"} <= inside(told, "simmer")


def test_a_joint_beside_buns_is_stewed_and_pulled_to_shreds_for_them(steps):
    told = steps("pork", "", "pork shoulder:whole", "root beer:liquid", "barbecue sauce:thick sauce", "bun:whole")
    assert motions(told).index("simmer") < motions(told).index("pull apart") < first(told, "bun", "pick-and-place")
    assert "bun" not in heated(told)


def test_sticks_and_a_dip_lie_beside_wings_that_are_tossed_in_their_sauce(steps):
    foods = ("chicken:wing", "hot sauce:sauce", "butter:melted", "flour:powder", "oil:liquid")
    told = steps("chicken", "", *foods, "celery:stick", "dressing:creamy")
    assert {"celery", "dressing"}.isdisjoint(heated(told))
    assert {"butter", "hot sauce"} <= inside(told, "cook and stir")


# ---------------------------------------------------------------- a part of it

BATTER = ("flour:powder", "sugar:granulated", "baking powder:powder", "egg:uncooked", "milk:liquid", "oil:liquid")


@pytest.mark.parametrize(
    ("dish_type", "word", "foods"),
    [
        ("cake", "frosting:creamy", ("cream cheese:softened", "butter:softened", "sugar:granulated")),
        ("cookie", "icing:creamy", ("powdered sugar:powder", "milk:liquid", "butter:solid")),
        ("muffin", "frosting:creamy", ("butter:softened", "powdered sugar:powder")),
    ],
)
def test_a_word_for_a_part_is_made_of_what_is_listed_behind_it(public_plans, dish_type, word, foods):
    plan = public_plans(dish_type, "", *BATTER, word, *foods)
    label = word.partition(":")[0]
    assert label not in {one.object for one in plan.recipe.ingredients}
    assert any(f"for the {label}" in one.why for one in plan.assumptions)
    done = [one.motion for one in plan.units]
    made = next(place for place, one in enumerate(plan.units) if one.motion == "bake")
    names = {food.partition(":")[0] for food in foods} - {"sugar", "milk"}
    baked = {name for node in plan.units[made].input_nodes for name in (node.label, *node.ingredients)}
    assert names.isdisjoint(baked)
    assert done.index("spread") > made


def test_a_crumble_takes_flour_and_sugar_once_more(public_plans):
    plan = public_plans(
        "muffin", "", "blueberries:berries", *BATTER, "topping:crumbs", "butter:cubed", "cinnamon:ground"
    )
    crumbs = {"butter", "cinnamon", "flour", "sugar"}
    mixed = [{*node.ingredients} for one in plan.units if one.motion == "mix" for node in one.output_nodes]
    assert crumbs in mixed
    assert not any({"milk", "cinnamon"} <= foods for foods in mixed)


def test_a_word_for_a_part_with_nothing_behind_it_is_bought(public_plans):
    plan = public_plans("cake", "", *BATTER, "frosting:creamy")
    assert "frosting" in {one.object for one in plan.recipe.ingredients}


def test_a_heading_in_a_list_is_no_food_and_its_foods_stay_together(public_plans):
    foods = ("sausages:raw", "oil:liquid", "flour:plain:batter", "eggs:uncooked:batter", "milk:liquid:batter")
    gravy = ("onions:sliced:batter", "butter:solid:batter", "plain flour:powder:batter", "beef stock:hot:batter")
    plan = public_plans("sausage", "Toad in the Hole with Onion Gravy", *foods, "For the gravy:", *gravy)
    baked = next(
        one for one in plan.units if one.motion == "bake" and any("eggs" in n.ingredients for n in one.input_nodes)
    )
    assert not any({"onions", "beef stock"} & {*node.ingredients} for node in baked.input_nodes)
    assert "For the gravy" not in {one.object for one in plan.recipe.ingredients}


def test_whites_beside_yolks_are_beaten_and_baked_on_a_pie(steps):
    told = steps(
        "pie", "", "pie crust:baked", "lemon juice:juice", "condensed milk:thick liquid", "egg yolk:raw",
        "egg white:raw", "sugar:granulated", "cream of tartar:powder",
    )  # fmt: skip
    assert "egg white" not in inside(told, "cook and stir")
    whisked = [{*node.ingredients} for _, motion, outputs in told if motion == "whisk" for node in outputs]
    assert {"egg white", "cream of tartar", "sugar"} in whisked
    assert not any({"egg white", "egg yolk"} <= foods for foods in whisked)


def test_an_egg_over_fruit_is_brushed_on_the_dough(steps):
    told = steps("pie", "", "pastry:raw", "rhubarb:diced", "strawberries:sliced", "sugar:granulated", "egg:beaten")
    assert "egg" in inside(told, "brush")


def test_all_of_a_marinade_reaches_the_steak_before_it_is_fried(steps):
    told = steps(
        "steak", "", "flank steak:raw", "soy sauce:sauce", "oil:liquid", "honey:liquid", "vinegar:liquid",
        "garlic powder:powder", "scallion:chopped",
    )  # fmt: skip
    assert {"soy sauce", "honey", "vinegar", "garlic powder"} <= inside(told, "stir")
    assert "scallion" not in heated(told)


def test_what_covers_a_loaf_of_meat_is_not_kneaded_into_it(steps):
    meat = ("ground beef:raw", "oats:rolled", "onion:chopped", "egg:beaten", "salt:granulated")
    told = steps("meatloaf", "", *meat, "ketchup:thick sauce", "brown sugar:granulated", "mustard:creamy")
    assert {"ketchup", "brown sugar", "mustard"} <= inside(told, "stir")
    assert {"ketchup", "brown sugar", "mustard"}.isdisjoint(inside(told, "mix"))


def test_roots_soured_for_a_sandwich_are_apart_from_what_is_spread_on_it(steps):
    told = steps(
        "sandwich", "", "baguette:whole", "pork:sliced", "carrot:julienned", "daikon:julienned", "vinegar:liquid",
        "sugar:granulated", "mayonnaise:creamy", "soy sauce:sauce", "pate:paste",
    )  # fmt: skip
    stirred = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "stir"]
    assert {"carrot", "daikon", "sugar", "vinegar"} in stirred
    assert not any({"mayonnaise", "carrot"} <= foods for foods in stirred)
