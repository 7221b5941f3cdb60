"""A word of a title that names a method or a form is followed: in the oven, in bacon, closed, frozen, creamed."""

from __future__ import annotations

import pytest
from planner.told_steps import first, last, motions, states_of

pytestmark = pytest.mark.shared_data

OMELET = ("eggs:uncooked", "milk:liquid", "ham:diced", "cheddar cheese:grated", "butter:unmelted", "salt:granulated")


@pytest.mark.parametrize("title", ["Oven Omelet with Ham", "Baked Omelette", "Sheet Pan Omelet"])
def test_an_omelet_of_the_oven_is_baked_and_not_stirred_on_the_stove(steps, title):
    told = steps("omelette", title, *OMELET)
    assert "bake" in motions(told)
    assert not any("egg mixture" in inputs and motion == "cook and stir" for inputs, motion, _ in told)


def test_an_omelet_whose_title_says_nothing_of_an_oven_stays_on_the_stove(steps):
    assert "bake" not in motions(steps("omelette", "Ham Omelet", *OMELET))


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("seafood", "Bacon Wrapped Scallops", ("scallops:raw", "bacon:sliced", "maple syrup:liquid")),
        ("vegetables", "Bacon Wrapped Asparagus", ("asparagus:whole", "bacon:sliced", "black pepper:ground")),
        ("seafood", "Prosciutto Wrapped Shrimp", ("shrimp:peeled", "prosciutto:sliced", "olive oil:liquid")),
        ("sausage", "Sausages in Blankets", ("sausages:raw", "crescent roll dough:raw", "mustard:creamy")),
    ],
)
def test_what_is_wrapped_is_rolled_up_before_it_is_baked(steps, dish_type, title, foods):
    told = motions(steps(dish_type, title, *foods))
    assert told.index("roll") < told.index("bake")


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Stuffed Pizza", ("pizza dough:whole", "mozzarella:grated", "spinach:chopped", "tomato sauce:sauce")),
        ("Fugazzeta", ("flour:powder", "yeast:powder", "water:liquid", "salt:granulated", "onions:sliced",
                       "mozzarella:sliced", "olive oil:liquid")),
    ],
)  # fmt: skip
def test_a_stuffed_pizza_is_closed_over_its_cheese(steps, title, foods):
    told = steps("pizza", title, *foods)
    closed = first(told, "mozzarella", "fold and pinch")
    assert closed < motions(told).index("bake")


def test_joints_that_are_fried_see_no_oven(steps):
    told = steps("chicken", "Deep Fried Chicken Wings", "chicken wings:raw", "flour:powder", "paprika:ground",
                 "oil:liquid", "hot sauce:sauce")  # fmt: skip
    assert first(told, "chicken wings", "dip") < first(told, "chicken wings", "cook")
    assert "bake" not in motions(told)
    assert last(told, "hot sauce") < first(told, "chicken wings", "dip")


def test_what_is_creamed_is_heated_in_a_sauce_of_flour_and_milk(steps):
    told = steps("seafood", "Creamed Tuna on Toast", "tuna:canned", "butter:unmelted", "flour:powder",
                 "milk:liquid", "bread:slices")  # fmt: skip
    assert first(told, "butter", "melt") < first(told, "flour", "cook and stir") < first(told, "milk", "cook and stir")
    assert "baked" in states_of(told, "bread")


def test_poached_eggs_are_opened_into_boiling_water_and_never_beaten(steps):
    told = steps("omelette", "Poached Eggs with Tomato Sauce", "eggs:uncooked", "tomatoes:canned", "onion:chopped",
                 "olive oil:liquid")  # fmt: skip
    assert {"eggs", "water", "pot"} <= set().union(*(inputs for inputs, motion, _ in told if motion == "boil"))
    assert not {"beat", "whisk"} & set(motions(told))


@pytest.mark.parametrize("filling", ["peanut butter:creamy", "lemonade concentrate:frozen"])
def test_a_frozen_pie_is_frozen(steps, filling):
    told = steps("pie", "Frozen Pie", "graham cracker crust:whole", filling, "sweetened condensed milk:thick liquid")
    assert "freeze" in motions(told)
    assert "chill" not in motions(told)


def test_fruit_that_is_flamed_is_heated_with_the_spirits_and_served_with_the_ice(public_plans):
    made = public_plans("pudding", "Bananas Flambe", "banana:sliced", "butter:unmelted", "brown sugar:granulated",
                        "rum:liquid", "vanilla ice cream:frozen")  # fmt: skip
    hot = [{node.label for node in unit.input_nodes} for unit in made.units if unit.motion == "cook and stir"]
    assert any({"banana", "rum"} <= labels for labels in hot)
    assert not any("vanilla ice cream" in labels for labels in hot)
    assert any("flambe" in one.why for one in made.assumptions)


@pytest.mark.parametrize(
    ("food", "state"),
    [("pineapple", "chunks"), ("bell pepper", "chunks"), ("broccoli", "florets"), ("onion", "rings")],
)
def test_the_forms_into_which_foods_are_cut_are_made_with_a_knife(steps, food, state):
    told = steps("stir-fry", "Stir Fry", f"{food}:{state}", "chicken breast:cubed", "soy sauce:liquid", "oil:liquid")
    assert state in states_of(told, food)
    assert any(food in inputs and "knife" in inputs for inputs, _, _ in told)
