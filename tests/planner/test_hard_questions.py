"""Questions at the edge: nothing asked, one food, odd names, utensils as foods, foods that are dishes."""

from __future__ import annotations

import pytest
from kitchen_stories import SALAD, subgraph
from planner.dishes import KITCHEN, SETTINGS
from planner.judged import fatal

from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.planning.planner import plan
from foon_kg.store.snapshot import Snapshot

JUICE = (
    "orange(whole); knife > halve > orange(halved)",
    "orange(halved); glass(empty) > squeeze > glass{orange juice}; orange juice(liquid){orange}@glass",
    (
        "glass{orange juice}; orange juice(liquid){orange}@glass; bottle{water}; water(liquid)@bottle"
        " > pour > glass{orange juice,water}; orange juice(liquid){orange}@glass; water(liquid)@glass"
    ),
    (
        "glass{orange juice,water}; orange juice(liquid){orange}@glass; water(liquid)@glass; spoon"
        " > stir > glass{orange juice}; orange juice(mixed){orange,water}@glass"
    ),
)
WASHED = (
    "faucet(off) > turn on > faucet(on)",
    "faucet(on); water(liquid)@from faucet; lettuce(whole) > wash > lettuce(washed)",
    "lettuce(washed); cutting board(empty); knife > chop > lettuce(chopped)@on cutting_board",
    "lettuce(chopped)@on cutting_board; bowl(empty) > pour > bowl{lettuce}; lettuce(chopped)@bowl",
    "bowl{lettuce}; shaker{salt}; salt(granulated)@shaker > sprinkle > bowl{lettuce,salt}; salt(granulated)@bowl",
    (
        "bowl{lettuce,salt}; lettuce(chopped)@bowl; salt(granulated)@bowl; spoon"
        " > mix* > bowl{salad}; salad(mixed){lettuce,salt}@bowl"
    ),
)
SNAPSHOT = Snapshot.of([subgraph("salad", "salad", *SALAD), subgraph("juice", "drinks", *JUICE)], KITCHEN)


def recipe(dish_type, *foods):
    wanted = (text.rsplit(" ", 1) for text in foods)
    return Recipe(dish_type, tuple(RequiredIngredient(food, state) for food, state in wanted), "asked")


def planned(dish_type, *foods):
    """The tree of a recipe, after it was found sound."""
    result = plan(SNAPSHOT, recipe(dish_type, *foods), SETTINGS)
    assert fatal(result, SNAPSHOT, KITCHEN.with_foods(f.rsplit(" ", 1)[0] for f in foods)) == []
    return result


def test_a_recipe_without_ingredients_is_wrong_usage():
    with pytest.raises(UsageError, match="names no ingredient") as refused:
        plan(SNAPSHOT, Recipe("salad", ()), SETTINGS)
    assert refused.value.hint


@pytest.mark.parametrize(("asked", "meant"), [("salat", "salad"), ("drink", "drinks"), ("xyz", "omelette")])
def test_an_unknown_dish_type_is_wrong_usage_and_the_hint_names_those_there_are(asked, meant):
    with pytest.raises(UsageError, match=f"“{asked}” is no dish type") as refused:
        plan(SNAPSHOT, recipe(asked, "onion chopped"), SETTINGS)
    assert refused.value.code == "unknown-dish-type"
    assert meant in refused.value.hint


def test_a_dish_type_without_goals_has_no_tree_and_the_hint_names_those_with_goals():
    with pytest.raises(NoTreeError) as refused:
        plan(SNAPSHOT, recipe("pie", "onion chopped"), SETTINGS)
    assert (refused.value.code, refused.value.message) == ("no-goal", "this FOON has no pie")
    assert "drinks, salad" in refused.value.hint


def test_a_foon_without_units_has_no_tree():
    with pytest.raises(NoTreeError, match="this FOON has no salad") as refused:
        plan(Snapshot.of([], KITCHEN), recipe("salad", "onion chopped"), SETTINGS)
    assert (refused.value.code, refused.value.hint) == ("no-goal", "It is empty: foon load foon PATH…")


def test_one_ingredient_alone_is_a_dish_without_the_others():
    result = planned("salad", "onion chopped")
    assert result.goal == ObjectNode("salad", (), ("onion",), "in", "bowl")
    assert {"tomato", "salt"}.isdisjoint(node.label for unit in result.units for node in unit.input_nodes)
    assert [unit.motion for unit in result.units if unit.motion in {"chop", "dice"}] == ["chop"]


def test_one_food_in_two_states_is_made_twice():
    result = planned("salad", "onion chopped", "onion diced", "tomato diced")
    made = {(node.label, state) for unit in result.units for node in unit.output_nodes for state in node.states}
    assert {("onion", "chopped"), ("onion", "diced")} <= made


def test_a_food_asked_twice_in_one_state_is_taken_once_and_stays_twice_in_the_recipe():
    result = planned("salad", "onion chopped", "onion chopped", "tomato diced")
    assert result.units == planned("salad", "onion chopped", "tomato diced").units
    assert len(result.recipe.ingredients) == 3


def test_a_food_that_the_list_of_utensils_names_is_a_food_when_it_is_asked():
    result = planned("salad", "tomato diced", "cooking spray oily")
    assert "cooking spray" in result.goal.ingredients


def test_water_that_is_asked_is_in_the_dish_and_free_water_goes_with_what_it_served():
    assert "water" in planned("drinks", "orange whole", "water liquid").goal.ingredients
    assert "onion" in planned("salad", "onion chopped", "water liquid").goal.ingredients


def test_water_that_is_asked_is_not_taken_again_for_washing():
    washing = Snapshot.of([subgraph("washed", "salad", *WASHED)], KITCHEN)

    units = plan(washing, recipe("salad", "lettuce chopped", "salt granulated", "water liquid"), SETTINGS).units
    waters = [thing for unit in units for node, thing, _ in unit.inputs if node.label == "water"]
    assert len(set(waters)) == 1


def test_water_for_washing_comes_from_the_one_tap_of_the_kitchen_which_is_a_thing_of_the_step():
    washing = Snapshot.of([subgraph("washed", "salad", *WASHED)], KITCHEN)
    units = plan(washing, recipe("salad", "lettuce washed", "spinach washed", "salt granulated"), SETTINGS).units
    taken = [one for unit in units for one in unit.inputs]
    waters = [one for one in taken if one.node.label == "water"]
    assert len(waters) == 2
    assert {one.container_thing for one in waters} == {one.thing for one in taken if one.node.label == "faucet"}
    assert len({one.container_thing for one in waters}) == 1


def test_an_ingredient_that_is_called_like_the_dish_is_an_ingredient():
    result = planned("drinks", "orange juice liquid", "orange whole")
    assert "orange juice" in result.goal.ingredients


@pytest.mark.parametrize(
    "name", ["crème fraîche", "7-up", "half & half", "日本酒", "a{b}c; > d", "o'brien (mix)", "%s"]
)
def test_a_name_of_odd_letters_is_kept_as_it_is_written(name):
    result = planned("salad", "tomato diced", f"{name} liquid")
    assert name in result.goal.ingredients
    assert any(node.label == name for node in result.kitchen)


def test_a_food_that_only_one_place_can_take_comes_in_before_the_mixing():
    result = planned("salad", "tomato diced", "kohlrabi raw")
    enters = [place for place, unit in enumerate(result.units) if any(n.label == "kohlrabi" for n in unit.input_nodes)]
    mixes = [place for place, unit in enumerate(result.units) if unit.motion == "mix"]
    assert enters
    assert enters[0] <= mixes[-1]


def test_what_foon_cannot_make_is_assumed_with_a_reason():
    result = planned("salad", "tomato diced", "seitan cured")
    assert [(a.node.label, a.node.states) for a in result.assumptions] == [("seitan", ("cured",))]
    assert "no step of this FOON makes seitan cured" in result.assumptions[0].why
