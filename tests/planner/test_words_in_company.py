"""A word that means another food beside others: soda with flour is what bakes, and else a drink."""

from __future__ import annotations

import pytest
from planner.public_foon import public_snapshot

from foon_kg.model import RequiredIngredient
from foon_kg.planning.planner import Planner
from foon_kg.planning.recipes import IngredientWords, recipe_of
from foon_kg.planning.settings import PlanSettings

pytestmark = pytest.mark.shared_data


def plan(dish, title, *texts):
    snapshot = public_snapshot()
    recipe = recipe_of(dish, texts, IngredientWords(snapshot.vocabulary(), snapshot.kitchen), title).recipe
    return Planner(snapshot, PlanSettings(time_limit=None), snapshot.units).plan(recipe)


def taken(result, food):
    """Return how a food is taken from the kitchen: its states and what it is in."""
    return {(node.states, node.container) for node in result.kitchen if node.label == food}


@pytest.mark.parametrize("line", ["1 teaspoon soda", "soda", "soda, powder"])
def test_soda_beside_flour_is_what_bakes(line):
    result = plan("cake", "Buttermilk Cake", "2 cups flour", "sugar", "2 eggs", "butter", line, "buttermilk")
    assert taken(result, "soda") == {(("powder",), "box")}
    likes = [one.equivalent for one in result.substitutions if (one.kind, one.object) == ("object", "soda")]
    assert likes == ["baking soda"]
    (joined,) = [unit for unit in result.units if any(node.container == "box" for node in unit.input_nodes)]
    assert {"flour", "soda"} <= {name for node in joined.output_nodes for name in node.ingredients}


@pytest.mark.parametrize(
    ("dish", "title", "texts"),
    [
        ("drinks", "Lemon Soda", ("soda", "lemon juice", "sugar")),
        ("cake", "Soda Cake", ("flour", "sugar", "egg", "butter", "club soda")),
    ],
)
def test_other_soda_is_a_drink(dish, title, texts):
    result = plan(dish, title, *texts)
    assert {place for food in ("soda", "club soda") for _, place in taken(result, food)} == {"bottle"}


def test_who_says_that_it_is_liquid_beside_no_flour_gets_a_drink():
    result = plan("drinks", "Float", "soda, liquid", "vanilla ice cream")
    assert taken(result, "soda") == {(("liquid",), "bottle")}
    assert RequiredIngredient("soda", "liquid") in result.recipe.ingredients
