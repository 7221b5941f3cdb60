"""Whatever is asked of whatever FOON: a sound tree, or an error that says why there is none; always the same."""

from __future__ import annotations

import json
import random

from hypothesis import given, settings
from hypothesis import strategies as st
from planner.dishes import KITCHEN, SETTINGS, questions

from foon_kg.errors import NoTreeError
from foon_kg.planner import Planner, plan
from foon_kg.result import PlanFailure, PlanResult
from foon_kg.snapshot import Snapshot
from foon_kg.validation import CONTRACT, KnownFoon, TaskTree, check

for_many_questions = settings(max_examples=150, deadline=None)
for_some_questions = settings(max_examples=50, deadline=None)


def judge(result, snapshot):
    return check(TaskTree.from_json(result.to_json()), KnownFoon.of(snapshot.units, snapshot.goals()), KITCHEN)


def answered(planner, recipe):
    """The answer as JSON text, a failure included: what must not depend on anything but the question."""
    try:
        found = planner.plan(recipe)
    except NoTreeError as error:
        found = PlanFailure.of(recipe, error)
    return json.dumps(found.to_json(), ensure_ascii=False)


@for_many_questions
@given(questions())
def test_the_answer_is_a_sound_tree_or_an_error_that_says_why(question):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    try:
        result = plan(snapshot, recipe, SETTINGS)
    except NoTreeError as error:
        assert error.code in {"no-goal", "no-way", "left-out"}
        assert error.message
        assert error.hint
        return
    assert judge(result, snapshot).of(CONTRACT) == ()
    assert PlanResult.from_json(json.loads(json.dumps(result.to_json()))) == result


@for_some_questions
@given(questions(), st.randoms(use_true_random=False))
def test_the_order_in_which_a_foon_is_read_does_not_matter(question, chance: random.Random):
    subgraphs, recipe = question
    shuffled = chance.sample(subgraphs, len(subgraphs))
    one, other = Snapshot.of(subgraphs, KITCHEN), Snapshot.of(shuffled, KITCHEN)
    assert answered(Planner(one, SETTINGS), recipe) == answered(Planner(other, SETTINGS), recipe)
    units = chance.sample(other.units, len(other.units))
    assert answered(Planner(one, SETTINGS, one.units), recipe) == answered(Planner(other, SETTINGS, units), recipe)


@for_some_questions
@given(questions(), st.data())
def test_a_recipe_has_one_answer_alone_and_after_others_in_part_of_the_foon_and_in_the_whole(question, data):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    among = Planner(snapshot, SETTINGS, snapshot.units)
    answered(among, data.draw(questions().map(lambda other: other[1])))
    assert answered(among, recipe) == answered(Planner(snapshot, SETTINGS), recipe)
