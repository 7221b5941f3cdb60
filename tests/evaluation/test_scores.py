"""One hand-made tree for each reason of the rule."""

from __future__ import annotations

import pytest
from kitchen_stories import node, unit

from foon_kg.evaluation.scores import LineScore, Reason, Rule, share_correct, without_tree
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.knowledge import MadeBy, Vocabulary
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult, ReferenceSummary

CHOP = "onion(whole); knife > chop > onion(chopped)"
ADD = "onion(chopped); bowl > pour > bowl{onion}"
MIX = "bowl{onion} > mix > salad{onion}@in bowl"
GOAL = "salad{onion}@in bowl"
VOCABULARY = Vocabulary((), (MadeBy("chopped", "chop", 3), MadeBy("grated", "grate", 1)), ("salad",))


def scores(want, *lines, goal=GOAL, vocabulary=VOCABULARY):
    food, state = want.split(", ")
    units = tuple(Step.of_unit(unit(line), "foon", ()) for line in lines)
    recipe = Recipe("salad", (RequiredIngredient(food, state),))
    result = PlanResult(recipe, ReferenceSummary(node(goal), len(units), 1, exact=True), node(goal), units, ())
    (scored,) = Rule(vocabulary, Kitchen.default()).scores(result)
    return scored.score, scored.reason


def test_a_food_that_is_chopped_by_chopping_is_worth_two():
    assert scores("onion, chopped", CHOP, ADD, MIX) == (2, Reason.DONE)


def test_a_food_that_is_sold_so_needs_no_motion():
    oil = "olive oil(liquid)@in bottle; bowl > pour > olive oil(liquid)@in bowl"
    mix = "olive oil(liquid)@in bowl > mix > salad{olive oil}@in bowl"
    assert scores("olive oil, liquid", oil, mix, goal="salad{olive oil}@in bowl") == (2, Reason.SOLD_SO)


def test_a_motion_that_never_makes_the_state_is_no_support():
    assert scores("onion, chopped", CHOP.replace("chop >", "stir >"), ADD, MIX) == (1, Reason.NOT_SUPPORTED)
    no_video = Vocabulary((), (MadeBy("grated", "chop", 9),), ("salad",))
    assert scores("onion, chopped", CHOP, ADD, MIX, vocabulary=no_video) == (1, Reason.NOT_SUPPORTED)


def test_a_food_that_lies_chopped_in_the_kitchen_is_not_prepared():
    assert scores("onion, chopped", ADD, MIX) == (1, Reason.NOT_PREPARED)


def test_a_food_that_is_never_in_the_asked_state_is_worth_one():
    assert scores("onion, grated", CHOP, ADD, MIX) == (1, Reason.NOT_SHOWN)


def test_a_food_that_comes_from_nowhere_does_not_start_in_the_kitchen():
    assert scores("onion, chopped", "wand > wave > onion(chopped)", ADD, MIX) == (1, Reason.NOT_FROM_KITCHEN)


@pytest.mark.parametrize(
    ("lines", "goal"),
    [
        ((CHOP, "tomato(whole); bowl > mix > salad{onion}@in bowl"), GOAL),
        ((CHOP, ADD, "bowl{onion} > mix > salad{tomato}@in bowl"), "salad{tomato}@in bowl"),
    ],
    ids=["nothing leads from it to the goal", "the goal does not name it"],
)
def test_a_food_that_does_not_end_in_the_dish_is_worth_nothing(lines, goal):
    assert scores("onion, chopped", *lines, goal=goal) == (0, Reason.NOT_IN_DISH)


def test_a_goal_names_a_food_in_the_plural_too():
    mix = MIX.replace("salad{onion}", "salad{onions}")
    assert scores("onion, chopped", CHOP, ADD, mix, goal="salad{onions}@in bowl") == (2, Reason.DONE)


def test_every_reason_is_worth_what_the_rule_says():
    assert {reason: reason.score for reason in Reason} == {
        Reason.DONE: 2,
        Reason.SOLD_SO: 2,
        Reason.NOT_FROM_KITCHEN: 1,
        Reason.NOT_SHOWN: 1,
        Reason.NOT_PREPARED: 1,
        Reason.NOT_SUPPORTED: 1,
        Reason.NOT_IN_DISH: 0,
        Reason.NO_TREE: 0,
    }


def test_a_recipe_without_a_tree_has_nothing_for_each_of_its_foods_once():
    onion, tomato = RequiredIngredient("onion", "chopped"), RequiredIngredient("tomato", "diced")
    found = without_tree([onion, tomato, onion])
    assert found == (LineScore(onion, Reason.NO_TREE), LineScore(tomato, Reason.NO_TREE))


@pytest.mark.parametrize(("given", "share"), [((2, 2), 1.0), ((2, 1, 0), 0.5), ((0,), 0.0), ((), 0.0)])
def test_the_share_is_the_sum_by_twice_the_lines(given, share):
    assert share_correct(given) == share
