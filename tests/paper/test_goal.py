"""Algorithms 1 and 2: which goal, and how alike two ingredient lists are."""

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import node
from paper.see_through import Told, foon, recipe, told

from foon_kg.model import Goal
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.planning.paper import plan_by_the_paper
from foon_kg.planning.paper.reference import compute_similarity, identify_goal_node

NAMES = ("onion", "leek", "salt", "egg")
lists = st.lists(st.sampled_from(NAMES), max_size=5)
figures = st.dictionaries(
    st.frozensets(st.sampled_from(NAMES), min_size=2, max_size=2), st.sampled_from((0.0, 0.89, 0.90, 0.91, 1.0))
)


def goal(text):
    made = node(text)
    return Goal(made, "salad", made.ingredients, ("video",))


@given(lists, lists, figures)
def test_every_pair_above_the_threshold_counts_also_where_a_food_is_in_several(required, known, pairs):
    expected = sum(i == j or pairs.get(frozenset({i, j}), 0.1) > 0.90 for i, j in product(required, known))
    assert compute_similarity(required, known, Told(pairs)) == expected


def test_the_goal_with_more_similar_pairs_is_taken_and_of_equals_the_first():
    few, many, same = goal("a{onion,salt}"), goal("b{leek,onion}"), goal("c{leek,onion}")
    assert identify_goal_node([few, many, same], ["onion", "leek"], told()) is many
    assert identify_goal_node([few, many, same], ["onion"], told(onion_leek=0.9)) is few
    assert identify_goal_node([few, many, same], ["onion"], told(onion_leek=0.91)) is many


def test_only_goals_of_the_asked_dish_type_count():
    known = foon(("onion(whole); bowl > mix > salad{onion}@bowl",))
    with pytest.raises(NoTreeError, match="no soup") as no_goal:
        plan_by_the_paper(known, recipe("whole onion", dish_type="soup"))
    assert (no_goal.value.code, "salad" in no_goal.value.hint) == ("no-goal", True)
    assert plan_by_the_paper(known, recipe("whole onion", dish_type="")).recipe.dish_type == "salad"


def test_a_recipe_without_ingredients_is_no_question():
    with pytest.raises(UsageError):
        plan_by_the_paper(foon(("onion(whole); bowl > mix > salad{onion}@bowl",)), recipe())
