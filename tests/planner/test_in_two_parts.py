"""Eggs that are asked separated: the yolks join the rest, the whites are beaten by themselves and folded in last."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

CAKE = ("sugar:granulated", "flour:powder", "baking powder:powder", "vegetable oil:liquid", "water:liquid")


@pytest.mark.parametrize(
    ("dish", "title", "foods"),
    [
        ("cake", "Chiffon Cake", CAKE),
        ("omelette", "Fluffy Omelette", ("milk:liquid", "butter:unmelted")),
        ("omelette", "Cheese Souffle", ("butter:unmelted", "flour:powder", "milk:liquid", "gruyere:grated")),
        ("cake", "Tiramisu", ("sugar:granulated", "mascarpone:creamy", "ladyfingers:whole", "espresso:liquid")),
    ],
)
def test_whites_are_beaten_by_themselves_and_folded_in(steps, dish, title, foods):
    told = steps(dish, title, "eggs:separated", *foods)
    beaten = {"bowl", "egg whites", "whisk"}
    (foam,) = [place for place, (inputs, one, _) in enumerate(told) if one == "whisk" and inputs == beaten]
    folded = max(place for place, one in enumerate(motions(told)) if one == "fold" and "egg whites" in told[place][0])
    assert first(told, "eggs", "crack") < foam < folded
    before = next(place for place, (inputs, one, _) in enumerate(told) if "egg yolks" in inputs and one != "crack")
    assert before < folded


def test_one_egg_gives_one_yolk_and_one_white(public_plans):
    plan = public_plans("cake", "Chiffon Cake", "egg:separated", *CAKE)
    labels = {node.label for unit in plan.units for node in unit.output_nodes}
    assert {"egg yolk", "egg white"} <= labels
    assert not [one for one in plan.substitutions if one.kind == "state" and one.object == "egg"]


def test_where_no_foam_is_folded_in_eggs_are_cracked_and_that_is_said(public_plans):
    foods = ("flour:powder", "yeast:powder", "egg:separated", "water:liquid", "salt:granulated")
    plan = public_plans("bread", "Plain Challah", *foods)
    (said,) = [one for one in plan.substitutions if one.object == "egg" and one.kind == "state"]
    assert (said.required, said.equivalent) == ("separated", "cracked")


def test_whites_lie_on_the_filling_of_a_meringue_pie(steps):
    told = steps(
        "pie", "Lemon Meringue Pie", "pie crust:raw", "sugar:granulated", "cornstarch:powder", "eggs:separated",
        "water:liquid", "lemon juice:juice",
    )  # fmt: skip
    assert inside(told, "whisk") >= {"cornstarch", "egg yolks"}
    assert "egg whites" not in inside(told, "whisk")
