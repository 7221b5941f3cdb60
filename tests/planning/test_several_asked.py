"""Words that name several foods ask for each of them, in a command as in a line of a recipe file."""

from __future__ import annotations

import json

from demo_foon import demo_foon
from hypothesis import assume, given
from hypothesis import strategies as st

from foon_kg.food import tables
from foon_kg.foon import Foon
from foon_kg.foon.demo import demo_folder
from foon_kg.planning.batch import Question
from foon_kg.planning.recipes import IngredientWords, read_recipe
from foon_kg.planning.several_asked import each_food
from foon_kg.plans.kitchen import Kitchen

WORDS = IngredientWords(demo_foon().vocabulary(), Kitchen.default())
PLAIN = sorted(name for name in tables().foods.kind_of if " and " not in name and "," not in name and "&" not in name)
WITH_AND = sorted(name for name in tables().foods.kind_of if " and " in name and name != "salt and pepper")

foods = st.sampled_from(PLAIN)
amounts = st.sampled_from(["", "2 ", "400 g ", "a handful of "])


@given(st.lists(st.tuples(amounts, foods), min_size=2, max_size=2), st.sampled_from([" and ", " & ", " AND "]))
def test_two_foods_are_two_unless_they_are_one_by_name(asked, between):
    told = tuple(f"{amount}{food}" for amount, food in asked)
    both = " and ".join(food for _, food in asked)
    assume(not any(name in both for name in WITH_AND))
    first, second = (food.split()[-1] for _, food in asked)
    assume(not tables().foods.is_listed(f"{first} {second}"))  # "onion and garlic powder" is onion powder, too
    assert each_food(between.join(told)) == told


def test_what_would_be_two_foods_of_one_word_is_two_as_they_are_written():
    assert each_food("mandarin orange and vegetable juice") == ("mandarin orange", "vegetable juice")


@given(amounts, foods, st.sampled_from(["", ", peeled and chopped", ", washed and dried"]))
def test_one_food_is_one(amount, food, state):
    assert each_food(f"{amount}{food}{state}") == (f"{amount}{food}{state}",)


def test_names_with_and_are_one():
    assert [each_food(f"1 cup {name}") for name in WITH_AND] == [(f"1 cup {name}",) for name in WITH_AND]


def test_a_food_in_front_of_a_food_is_no_list():
    for text in ("ham and cheese sandwich", "chicken and apple sausage", "bread and butter pudding"):
        assert each_food(text) == (text,)


def test_all_that_is_said_of_them_holds_and_the_reading_is_told(tmp_path):
    text = "400 g chopped onion and 2 tomatoes, diced"
    path = tmp_path / "salad.json"
    path.write_text(json.dumps({"type": "salad", "ingredients": [text, "parsley and lemon wedges, for serving"]}))
    read = read_recipe(path, WORDS)
    asked = [(one.object, one.state, one.amount, one.part) for one in read.recipe.ingredients]
    assert asked[0] == ("onion", "chopped", "400 g", "")
    assert asked[1][1:] == ("diced", "2", "")
    assert [one[0] for one in asked[2:]] == ["parsley", "lemon wedges"]
    assert [one[3] for one in asked[2:]] == ["serving", "serving"]
    assert sum("is read as 2 foods" in note for note in read.notes) == 2
    assert {"onion", "tomatoes"} <= set(Question(path).names()[1])  # so that a graph is asked for these words


def test_a_plan_has_both():
    with Foon.from_files(demo_folder()) as foon:
        plan = foon.plan("salad", ["chopped onion and sliced tomato", "olive oil"])
    assert {one.object for one in plan.result.recipe.ingredients} == {"onion", "tomato", "olive oil"}
    assert any("is read as 2 foods" in note for note in plan.notes)
