"""The rules for ties between goals, as docs/ties.md states them, each with a FOON on which it decides."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kitchen_stories import node, subgraph
from planner.dishes import KITCHEN, SETTINGS, LikeByKind, questions

from foon_kg import goals
from foon_kg.errors import NoTreeError
from foon_kg.goals.ranking import NEAR, RankedGoal, near_ties
from foon_kg.model import Goal, Recipe, RequiredIngredient
from foon_kg.planner import plan
from foon_kg.question import FIRST_GOALS
from foon_kg.result import PlanFailure
from foon_kg.snapshot import Snapshot

CHOPPED = (
    "cutting board(empty); onion(whole) > pick-and-place > cutting board{onion}; onion(whole)@on cutting_board",
    "onion(whole)@on cutting_board; knife > chop > onion(chopped)@on cutting_board",
)


def salad(vessel, food="onion", *, also="", chilled=False):
    """The units of a salad of ``food`` and ``also`` in ``vessel``, with one step more where it is chilled."""
    others = f"; {also}(granulated)" if also else ""
    inside = ",".join(sorted(filter(None, (food, also))))
    pour = (
        f"{vessel}(empty); cutting board{{{food}}}; {food}(chopped)@on cutting_board{others}"
        f" > pour* > {vessel}{{{inside}}}; {food}(chopped)@{vessel}; cutting board(empty)"
    )
    mix = (
        f"{vessel}{{{inside}}}; {food}(chopped)@{vessel}; spoon"
        f" > mix* > {vessel}{{salad}}; salad(mixed){{{inside}}}@{vessel}"
    )
    chill = (
        f"{vessel}{{salad}}; salad(mixed){{{inside}}}@{vessel}; fridge(closed)"
        f" > chill > {vessel}{{salad}}; salad(chilled){{{inside}}}@{vessel}"
    )
    units = (*CHOPPED, pour, mix, chill) if chilled else (*CHOPPED, pour, mix)
    return tuple(line.replace("onion", food) for line in units)


class Like(LikeByKind):
    """A similarity by a table; foods that it does not name are not alike."""

    def __init__(self, table):
        self.table = table

    def matrix(self, wanted, known):
        rows = [[1.0 if w == k else self.table.get((w, k), 0.0) for k in known] for w in wanted]
        return np.array(rows).reshape(len(wanted), len(known))


def planned(*subgraphs, foods=(("onion", "chopped"),), alike=None):
    recipe = Recipe("salad", tuple(RequiredIngredient(*food) for food in foods))
    return plan(Snapshot.of(subgraphs, KITCHEN), recipe, replace(SETTINGS, similarity=Like(alike or {})))


def ranked(score, misnamed=(), name="salad"):
    return RankedGoal(Goal(node(name), "salad", (), ()), score, misnamed)


@pytest.mark.parametrize(
    ("scores", "near"),
    [([], 0), ([2.0], 1), ([2.0, 2.0, 1.0], 2), ([2.0, 2.0 - NEAR, 2.0 - NEAR - 0.01], 2), ([2.0, 1.0, 2.0], 1)],
)
def test_goals_are_near_ties_as_long_as_their_scores_are_close_to_the_first(scores, near):
    assert near_ties([ranked(score) for score in scores]) == near


def test_a_misnamed_goal_is_no_near_tie_of_a_truly_named_one():
    assert near_ties([ranked(2.0), ranked(2.0, ("potato",))]) == 1


def test_of_near_ties_the_shorter_tree_wins(monkeypatch):
    long, short = subgraph("a", "salad", *salad("bowl", chilled=True)), subgraph("b", "salad", *salad("pot"))
    assert planned(long, short).goal.container == "pot"
    monkeypatch.setattr(goals, "NEAR", -1)
    assert planned(long, short).goal.container == "bowl"


def test_of_near_ties_the_greater_overlap_wins_before_the_shorter_tree():
    both = subgraph("b", "salad", *salad("pot", "leek", also="pepper", chilled=True))
    one = subgraph("a", "salad", *salad("bowl"))
    half = {("onion", "leek"): 0.5, ("salt", "pepper"): 0.5}
    foods = (("onion", "chopped"), ("salt", "granulated"))
    result = planned(both, one, foods=foods, alike=half)
    assert (result.goal.container, result.reference.overlap) == ("pot", 2)


def test_of_near_ties_the_surer_tree_wins_where_overlap_and_units_are_the_same():
    sure, unsure = subgraph("b", "salad", *salad("pot")), subgraph("a", "salad", *salad("bowl", "leek"))
    result = planned(sure, unsure, alike={("onion", "leek"): 1 - NEAR})
    assert (result.goal.container, result.substitutions) == ("pot", ())


def test_of_trees_that_are_alike_in_all_this_the_one_with_the_least_goal_node_wins():
    twins = [subgraph(name, "salad", *salad(vessel)) for name, vessel in (("a", "pot"), ("b", "bowl"))]
    assert planned(*twins).goal.container == planned(*reversed(twins)).goal.container == "bowl"


def test_no_more_near_ties_are_compared_than_the_first_question_looks_behind():
    longer = [subgraph(vessel, "salad", *salad(vessel, chilled=True)) for vessel in ("bowl", "cup", "mug", "pan")]
    assert len(longer) > FIRST_GOALS
    assert planned(*longer, subgraph("pot", "salad", *salad("pot"))).goal.container == "bowl"


def test_without_a_dish_type_the_goal_most_like_the_foods_of_any_type_is_taken_and_named():
    soup = subgraph("a", "soup", *(line.replace("salad", "soup") for line in salad("pot", also="salt")))
    other = subgraph("b", "salad", *salad("bowl"))
    snapshot = Snapshot.of([soup, other], KITCHEN)
    foods = (RequiredIngredient("onion", "chopped"), RequiredIngredient("salt", "granulated"))
    assert plan(snapshot, Recipe("", foods), SETTINGS).recipe == Recipe("soup", foods)
    assert plan(snapshot, Recipe("", foods[:1]), SETTINGS).recipe.dish_type == "salad"


@settings(max_examples=40, deadline=None)
@given(questions(), st.integers(0, 99), st.booleans())
def test_a_shuffle_of_files_and_rows_changes_nothing(question, seed, any_dish):
    subgraphs, recipe = question
    recipe = replace(recipe, dish_type="" if any_dish else recipe.dish_type)

    def answer(found):
        snapshot = Snapshot.of(found, KITCHEN)
        try:
            return plan(snapshot, recipe, SETTINGS).to_json()
        except NoTreeError as error:
            return PlanFailure.of(recipe, error).to_json()

    shuffled = random.Random(seed).sample(subgraphs, len(subgraphs))
    assert answer(shuffled) == answer(subgraphs)
