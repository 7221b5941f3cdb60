"""In which order goals are tried, at the edges: found by mutants that other tests let live."""

from __future__ import annotations

from kitchen_stories import node

from foon_kg.goals.ranking import NEAR, RankedGoal, near_ties, rank_goals
from foon_kg.model import Goal, RequiredIngredient

FOODS = frozenset({"carrot", "egg", "egg salad", "onion", "salad", "green onion"})


def goal(text, dish_type="salad"):
    made = node(text)
    return Goal(made, dish_type, made.ingredients, ("video",))


def ranked(goals, names, confidence, dish_type="salad"):
    wants = [RequiredIngredient(name, "whole") for name in names]
    return rank_goals(goals, wants, name_confidence=confidence, known_foods=FOODS, dish_type=dish_type)


def test_scores_that_differ_by_less_than_a_hundredth_are_equal():
    surer, smaller = goal("salad{onion,x,y}"), goal("salad{carrot}")
    sure = {"onion": 0.902, "carrot": 0.9}

    def confidence(required, known):
        return sure.get(known, 0.0)

    assert [r.goal for r in ranked([surer, smaller], ["onion"], confidence)] == [smaller, surer]
    sure["onion"] = 0.91
    assert [r.goal for r in ranked([surer, smaller], ["onion"], confidence)] == [surer, smaller]


def test_a_required_food_plays_one_ingredient_only():
    both = goal("salad{carrot,onion}")
    assert ranked([both], ["onion"], lambda *_: 0.8)[0].score == 0.8
    assert ranked([both], ["onion", "leek"], lambda *_: 0.8)[0].score == 1.6


def test_a_dish_of_any_type_is_named_by_the_words_of_its_own():
    (of_salad,) = ranked([goal("egg salad{egg}")], ["onion"], lambda *_: 1.0, dish_type=None)
    assert of_salad.misnamed == ("egg",)


def test_a_label_that_is_a_food_as_a_whole_is_no_misnomer_but_its_only_word_is():
    assert ranked([goal("green onion{onion}", "soup")], ["onion"], lambda *_: 1.0, "soup")[0].misnamed == ()
    assert ranked([goal("carrot{onion}", "soup")], ["onion"], lambda *_: 1.0, "soup")[0].misnamed == ()


def near(*rows):
    goals = [RankedGoal(goal("salad{onion}"), score, misnamed) for score, misnamed in rows]
    return near_ties(goals)


def test_near_ties_are_as_truly_named_and_within_the_reach_of_the_first():
    assert near((2.0, ()), (2.0 - NEAR, ()), (1.9, ())) == 2
    assert near((2.0, ()), (2.0 - NEAR - 0.01, ()), (2.0, ())) == 1
    assert near((2.0, ()), (2.0, ("egg",))) == 1
    assert near((2.0, ("egg",)), (2.0, ("leek",))) == 2
    assert near_ties(()) == 0
