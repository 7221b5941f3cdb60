"""K5 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.dishes import heated, lines, recipe, served
from validation.judging import ONE_TOMATO, foon_of, found, report

from foon_kg.model import ObjectNode
from foon_kg.model.tree import TaskTree
from foon_kg.validation import check

# --- K5 dish: what makes it ---


@pytest.mark.parametrize(
    ("label", "foods", "lack"),
    [
        ("omelette", ("tofu", "butter"), "egg"),
        ("mushroom soup", ("leek", "water"), "mushroom"),
        ("fried rice", ("leek", "oil"), "rice"),
        ("bread", ("leek", "water"), "flour"),
        ("cake", ("leek", "sugar"), "flour"),
        ("garlic bread", ("leek", "butter"), "garlic"),
    ],
)
def test_k5_what_makes_the_named_dish_is_not_in_it(label, foods, lack):
    told = found("K5", heated(label, *foods))
    assert told
    assert all(line.startswith(f"K5 {label} (") for line in told)
    assert any(lack in line.partition("” without ")[2] for line in told)


@pytest.mark.parametrize(
    ("label", "foods"),
    [
        ("omelette", ("egg", "butter")),
        ("mushroom soup", ("mushroom", "water")),
        ("fried rice", ("rice", "oil")),
        ("bread", ("flour", "water")),
        ("cake", ("flour", "sugar")),
        ("garlic bread", ("garlic", "bread")),
    ],
)
def test_k5_what_makes_the_named_dish_is_in_it(label, foods):
    assert found("K5", heated(label, *foods)) == []


def test_k5_what_is_missing_is_told_with_what_would_do():
    (told,) = found("K5", heated("garlic bread", "bread", "butter"))
    assert told.startswith("K5 garlic bread (cooked; {bread, butter}; in pot): “garlic bread” without ")
    assert told.endswith(" without garlic or garlic powder or garlic salt")


def test_k5_a_dish_that_only_the_title_or_the_dish_type_names_counts():
    tree = heated("stew", "leek", "water")
    assert found("K5", tree) == []
    titled = found("K5", recipe("soup", "leek; water", "Mushroom Soup") + tree)
    assert any("without mushroom" in line for line in titled)
    typed = found("K5", recipe("omelette", "leek; water") + tree)
    assert any("“stew” without egg" in line for line in typed)


def test_k5_a_longer_name_takes_the_place_of_those_within_it():
    assert found("K5", served("salad dressing", "oil", "vinegar")) == []
    assert found("K5", heated("crab cake", "crab", "egg")) == []


@pytest.mark.parametrize(
    ("label", "foods", "lacks"),
    [
        ("leek salad", ("tomato", "salt"), ["leek"]),
        ("leek salad", ("leek", "salt"), []),
        ("leek salad", ("baby leek", "salt"), []),
        ("baby leek salad", ("leek", "salt"), []),
        ("leek and radish salad", ("tomato", "salt"), ["leek", "radish"]),
        ("savoy cabbage salad", ("cabbage", "salt"), []),
        ("big salad", ("tomato", "salt"), []),
        ("salad", ("tomato", "salt"), []),
        ("radishes salad", ("radish", "salt"), []),
    ],
)
def test_k5_a_food_after_which_the_dish_is_called_is_in_it(label, foods, lacks):
    told = found("K5", served(label, *foods))
    assert [line.rpartition(" without ")[2] for line in told] == lacks


def test_k5_a_dish_that_is_a_food_that_a_shop_sells_is_not_called_after_itself():
    assert found("K5", served("half and half", "tomato")) == []
    assert found("K5", served("half and half salad", "tomato")) != []


@pytest.mark.parametrize("label", ["onion salad", "green onion salad"])
def test_k5_a_food_whose_words_other_dishes_have_too_is_in_it(label):
    assert found("K5", served(label, "tomato", "salt")) != []


def test_k5_a_kind_in_the_name_is_there_where_one_of_it_is():
    assert found("K5", served("herb salad", "parsley", "salt")) == []
    assert found("K5", served("herb salad", "tomato", "salt")) != []


# --- K5 dish: finished ---


@pytest.mark.parametrize("label", ["dough", "pizza dough", "pancake batter", "batter", "meat mixture", "egg wash"])
def test_k5_a_dough_or_batter_is_no_finished_dish(label):
    told = found("K5", served(label, "flour", "egg", "beef"))
    assert any(line.endswith(f": “{label}” is no finished dish") for line in told)
    assert all(line.startswith(f"K5 {label} (") for line in told)


def test_k5_a_dish_with_dough_inside_its_name_is_finished():
    assert not [line for line in found("K5", served("dough balls", "flour", "egg")) if "no finished dish" in line]


@pytest.mark.parametrize("state", ["uncooked", "raw", "uncook", "partly cooked", "half cooked", "undercooked"])
def test_k5_a_dish_that_is_uncooked_or_half_cooked(state):
    (told,) = found("K5", served("salad", "tomato", "salt", states=state))
    assert told == f"K5 salad ({state}; {{salt, tomato}}; on plate): the dish is {state}"


@pytest.mark.parametrize("state", ["cooked", "mixed", "cold", "ready"])
def test_k5_a_dish_in_any_other_state_is_finished(state):
    assert found("K5", served("salad", "tomato", "salt", states=state)) == []


def test_k5_nothing_was_heated_in_a_dish_that_is_eaten_hot():
    cold = served("soup", "leek", "water")
    (told,) = found("K5", cold)
    assert told == "K5 soup ({leek, water}; on plate): “soup”, and nothing in it was heated"
    assert found("K5", heated("soup", "leek", "water")) == []


SAUCE = ("onion", "tomato", "oil")


def test_k5_a_sauce_of_raw_roots_and_tomatoes_was_never_heated():
    asked = recipe("sauce", "; ".join(SAUCE), "Sauce of the House")
    (told,) = found("K5", asked + served("sauce", *SAUCE))
    assert told.endswith("a sauce with raw onion, and nothing in it was heated")
    assert found("K5", asked + heated("sauce", *SAUCE)) == []


def test_k5_a_sauce_that_is_eaten_raw_by_its_name_or_foods_is_not_to_be_heated():
    assert found("K5", recipe("sauce", "; ".join(SAUCE), "Fresh Salsa") + served("sauce", *SAUCE)) == []
    with_nuts = (*SAUCE, "almond")
    assert found("K5", recipe("sauce", "; ".join(with_nuts), "House Sauce") + served("sauce", *with_nuts)) == []


def test_k5_of_type_and_title_too():
    cold = served("lunch", "leek", "water")
    assert found("K5", cold) == []
    assert found("K5", recipe("soup", "leek; water") + cold)[-1].endswith(": “soup”, and nothing in it was heated")
    titled = found("K5", recipe("salad", "leek; water", "Leek Soup") + cold)
    assert titled[-1].endswith(": “soup”, and nothing in it was heated")


def test_k5_a_cold_dish_need_not_be_heated():
    assert found("K5", served("salad", "leek", "water")) == []
    assert found("K5", served("smoothie", "banana", "milk")) == []


def in_oven(label, *foods, motion="BAKE", appliance="oven"):
    """Steps that make a dish of some foods on a tray in an appliance."""
    holds = "{" + ", ".join(sorted(foods)) + "}"
    return f"""
{" + ".join(foods)} + tray (empty) + spoon → MIX → stuff ({holds}; on tray) + tray ({{stuff}})
tray ({{stuff}}) + {appliance} (off) → PUT → tray ({{stuff}}; in {appliance}) + {appliance} (off)
{appliance} (off) → TURN ON → {appliance} (on)
stuff ({holds}; on tray) + tray ({{stuff}}; in {appliance}) + {appliance} (on) → {motion} → {label} ({holds}; on tray)
"""


NEVER_BAKED = "“bread”, and it was never baked"


@pytest.mark.parametrize(
    "tree",
    [
        in_oven("bread", "flour", "yeast"),
        in_oven("bread", "flour", "yeast", motion="COOK"),
        in_oven("bread", "flour", "yeast", motion="COOK", appliance="microwave"),
        in_oven("bread", "flour", "yeast", appliance="grill"),
    ],
)
def test_k5_what_is_baked_stood_in_an_oven_or_in_dry_heat(tree):
    assert found("K5", recipe("bread", "flour; yeast") + tree) == []


@pytest.mark.parametrize(
    "tree",
    [
        in_oven("bread", "flour", "yeast", motion="COOK", appliance="grill"),
        heated("bread", "flour", "yeast"),
        heated("bread", "flour", "yeast", motion="FRY"),
    ],
)
def test_k5_what_is_baked_was_not_boiled_or_fried(tree):
    (told,) = found("K5", recipe("bread", "flour; yeast") + tree)
    assert told.endswith(f": {NEVER_BAKED}")


def rolled_and_fried(*foods):
    """Steps that roll out a dough of some foods and fry it."""
    holds = "{" + ", ".join(sorted(foods)) + "}"
    return f"""
{" + ".join(foods)} + board (empty) + spoon → MIX → dough ({holds}; on board) + board ({{dough}})
dough ({holds}; on board) + board ({{dough}}) + rolling pin → ROLL → dough (flattened; {holds}; on board)
pan (empty) + stove (off) → PUT → pan (empty; on stove) + stove (off; under pan)
dough (flattened; {holds}; on board) + pan (empty; on stove) → PUT → dough (flattened; {holds}; in pan)
stove (off; under pan) → TURN ON → stove (on; under pan)
dough (flattened; {holds}; in pan) + stove (on; under pan) → FRY → bread (fried; {holds}; in pan)
"""


def test_k5_bread_that_nothing_raises_is_rolled_and_fried():
    assert found("K5", recipe("bread", "flour; salt") + rolled_and_fried("flour", "salt")) == []
    (told,) = found("K5", recipe("bread", "flour; yeast") + rolled_and_fried("flour", "yeast"))
    assert told.endswith(f": {NEVER_BAKED}")
    (told,) = found("K5", recipe("bread", "flour; salt") + heated("bread", "flour", "salt"))
    assert told.endswith(f": {NEVER_BAKED}")


def test_k5_a_cake_of_ready_biscuits_sets_cold_and_one_with_flour_does_not():
    assert found("K5", recipe("cake", "ladyfinger; mascarpone") + served("cake", "ladyfinger", "mascarpone")) == []
    told = found("K5", recipe("cake", "ladyfinger; flour") + served("cake", "ladyfinger", "flour"))
    assert told[-1].endswith(": “cake”, and it was never baked")


def test_k5_a_title_may_say_that_a_dish_is_baked_and_a_goal_alone_does_not():
    tree = heated("bread", "flour", "yeast")
    assert found("K5", tree) == []
    (told,) = found("K5", recipe("soup", "flour; yeast", "Bread").replace("soup", "salad") + tree)
    assert told.endswith(f": {NEVER_BAKED}")


def test_k5_warming_is_heating():
    assert found("K5", heated("soup", "leek", "water", motion="HEAT")) == []


def test_k5_the_dish_type_of_a_tree_without_a_recipe_is_that_of_its_goal_in_the_foon():
    foon = foon_of(f"name: v\ndish: soup\ngoal: lunch\n{ONE_TOMATO}")
    cold = served("lunch", "leek", "water")
    assert found("K5", cold, foon)[-1].endswith(": “soup”, and nothing in it was heated")
    assert found("K5", served("supper", "leek", "water"), foon) == []


def test_k5_a_goal_that_nothing_becomes():
    tree = TaskTree("nothing", (), goal=ObjectNode("soup"))
    assert [str(one) for one in check(tree).of(["K5", "K6"])] == ["K5 soup: nothing becomes the dish"]
    assert found("K5", f"goal: soup\n{ONE_TOMATO}") == ["K5 soup: nothing becomes the dish"]


def test_k5_a_tree_without_food_has_no_dish_to_ask_of():
    assert found("K5", "stove (on) → TURN OFF → stove (off)") == []


def test_k5_findings_are_fatal():
    judged = report(served("soup", "leek", "water"))
    assert (judged.fatal.count("K5"), judged.cook, judged.robot) == (1, False, True)


def turned_over(said, motion):
    """A cake that is called so, baked, and then brought or turned onto a plate."""
    told = recipe("cake", "flour; pineapple", f"Pineapple {said} Cake") + in_oven("cake", "flour", "pineapple")
    inputs, outputs = ("cake ({flour, pineapple}; " + where for where in ("on tray)", "on plate)"))
    return f"{told}{inputs} + plate (empty) → {motion} → {outputs} + plate ({{cake}})"


def test_k5_a_step_does_what_the_title_names():
    assert any("“upside down”" in line for line in found("K5", turned_over("Upside-Down", "PICK-AND-PLACE")))
    assert found("K5", turned_over("Upside-Down", "FLIP AND PLACE")) == []
    assert found("K5", turned_over("Plain", "PICK-AND-PLACE")) == []


@pytest.mark.parametrize(("called", "faults"), [("noodle", 1), ("mixture", 0)])
def test_k5_nothing_is_called_by_the_dish_before_what_makes_it_is_in_it(called, faults):
    tossed = f"""
{called} (cooked; {{leek, water}}; in pot) + pot (hot; {{{called}}}; on stove) + spaghetti (cooked) + spoon → STIR
  → noodle (cooked, mixed; {{leek, spaghetti, water}}; in pot) + pot (hot; {{noodle}}; on stove)
""".replace("\n  →", " →")
    told = found("K5", lines(heated(called, "leek", "water"), tossed))
    assert [line for line in told if "before dry pasta is in it" in line] == told
    assert len(told) == faults


def test_k5_what_lies_in_layers_is_not_all_stirred_together():
    asked = recipe("pudding", "yogurt; strawberry", "Strawberry Parfait")
    assert found("K5", lines(asked, served("pudding", "strawberry", "yogurt"))) == [
        "K5 step 1 pudding ({strawberry, yogurt}; on plate): “parfait”, and all of it is stirred together"
    ]
    assert (
        found("K5", lines(recipe("drinks", "yogurt; milk", "Parfait Shake"), served("drinks", "milk", "yogurt"))) == []
    )
    laid = served("pudding", "strawberry", "yogurt").replace("MIX", "POUR").replace(" + spoon", "")
    assert found("K5", lines(asked, laid)) == []


@pytest.mark.parametrize(("food", "refused"), [("cucumber", False), ("carrot", True)])
def test_k5_a_soup_that_is_blended_of_raw_cucumber_may_be_cold(food, refused):
    tree = (
        f"{food} (chopped; in blender jar) + blender jar ({{{food}}}) → BLEND → "
        f"soup (blended; {{{food}}}; in blender jar) + blender jar ({{{food}}})"
    )
    told = [line for line in found("K5", recipe("soup", food) + tree) if "nothing in it was heated" in line]
    assert bool(told) is refused


def test_k5_a_cake_that_was_steamed_needs_no_oven():
    steamed = """
flour (powder; in bag) + egg (beaten; in bowl) + cake pan (empty) → POUR → batter ({egg, flour}; in cake pan)
pot ({water}; on stove) + stove (off; under pot) → TURN ON → stove (on; under pot)
batter ({egg, flour}; in cake pan) + pot ({water}; on stove) + stove (on; under pot) → {MOTION}
  → cake ({egg, flour}; in cake pan)
"""
    head = "dish: cake\nasked: flour (powder); egg (beaten)\n"
    assert "“cake”, and it was never baked" in str(found("K5", head + steamed.replace("{MOTION}", "BOIL")))
    assert "never baked" not in str(found("K5", head + steamed.replace("{MOTION}", "STEAM")))
