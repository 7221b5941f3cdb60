"""Which other dishes a recipe could be made after, and a tree that is made after one of them."""

from __future__ import annotations

from dataclasses import replace

import pytest
from pictures.demo_plans import demo_foon

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings

SETTINGS = PlanSettings(time_limit=None)
WANTED = (("kohlrabi", "sliced"), ("onion", "chopped"), ("olive oil", ""))
SALAD = Recipe("salad", tuple(RequiredIngredient(*one) for one in WANTED))
DRINK = Recipe("drinks", tuple(RequiredIngredient(one, "") for one in ("syrup", "sugar", "raisin", "potato")))


def planner(after=""):
    return Planner(demo_foon(), replace(SETTINGS, after=after), demo_foon().units)


def followed(video, recipe):
    """The plan of ``recipe`` after ``video``, or why there is none."""
    try:
        return planner(video).plan(recipe), ""
    except NoTreeError as error:
        return None, error.message


@pytest.mark.parametrize("recipe", [SALAD, DRINK], ids=lambda one: one.dish_type)
def test_other_dishes_are_named_once_and_each_can_be_followed_or_says_why_not(recipe):
    result, _, considered = planner().reasons(recipe)
    goals = [one.goal for one in considered]
    assert goals
    assert len(set(goals)) == len(goals)
    assert result.reference.goal not in goals
    assert [(one.goal, one.similarity, one.why) for one in considered if one.nearer] == [
        (one.goal, one.similarity, one.why) for one in result.passed_over
    ]
    for one in considered:
        made, said = followed(one.video, recipe)
        if made is None:
            assert recipe is not SALAD
            assert f"The nearest: {one.goal.label}: " in said
        else:
            assert made.reference.videos == (one.video,)
            assert made.reference.goal == one.goal


def test_a_dish_is_followed_by_its_name_and_the_others_are_still_told():
    first = planner().plan(SALAD)
    result, _, considered = planner("winter salad").reasons(SALAD)
    assert first.reference.goal.label == "greek salad"
    assert result.reference.goal.label == "winter salad"
    assert "greek salad" in {one.goal.label for one in considered}


def test_a_dish_that_nobody_made_is_refused_with_what_suits():
    with pytest.raises(NoTreeError, match="called “moon salad”") as refused:
        planner("moon salad").plan(SALAD)
    assert refused.value.code == "no-goal"
    assert "greek salad" in refused.value.hint


def test_where_the_dish_cannot_be_what_lacks_is_told_with_the_recorded_dishes_that_are_nearest():
    foods = [("onion", "chopped"), ("cheddar", "grated"), ("cucumber", "sliced")]
    recipe = Recipe("omelette", tuple(RequiredIngredient(*one) for one in foods))
    with pytest.raises(NoTreeError, match="no omelette without egg") as refusal:
        planner().plan(recipe)
    assert refusal.value.code == "no-way"
    omelettes = {goal.node.label for goal in demo_foon().goals() if goal.dish_type == "omelette"}
    assert any(f"the nearest is “{label}” of the video " in refusal.value.hint for label in omelettes)
    assert "Asked for as salad, they suit “" in refusal.value.hint
