"""Whatever is asked of whatever FOON: a sound tree, or an error that says why there is none; always the same."""

from __future__ import annotations

import json
import random

import pytest
from examples import examples
from hypothesis import event, given
from hypothesis import strategies as st
from planner.dishes import KITCHEN, SETTINGS, questions
from planner.judged import fatal

from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.plans.result import PlanFailure, PlanResult
from foon_kg.store.snapshot import Snapshot

for_many_questions = examples(60)
for_some_questions = examples(25)


def answer(planner, recipe):
    """A tree, or the failure that stands in its place; anything else that is raised is a bug."""
    try:
        return planner.plan(recipe)
    except NoTreeError as error:
        return PlanFailure.of(recipe, error)


def text(planner, recipe):
    """The answer as JSON text: what must not depend on anything but the question."""
    return json.dumps(answer(planner, recipe).to_json(), ensure_ascii=False)


@pytest.mark.slow
@for_many_questions
@given(questions())
def test_the_answer_is_a_sound_tree_or_a_reason_why_there_is_none(question):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    found = answer(Planner(snapshot, SETTINGS), recipe)
    event(found.code if isinstance(found, PlanFailure) else "tree")
    if isinstance(found, PlanFailure):
        assert found.code in {"no-goal", "no-way"}
        assert found.message
        assert found.hint
    else:
        assert fatal(found, snapshot) == []
        assert PlanResult.from_json(json.loads(json.dumps(found.to_json()))) == found


@pytest.mark.slow
@for_some_questions
@given(questions(), st.randoms(use_true_random=False))
def test_the_order_in_which_a_foon_is_read_does_not_matter(question, chance: random.Random):
    subgraphs, recipe = question
    shuffled = chance.sample(subgraphs, len(subgraphs))
    one, other = Snapshot.of(subgraphs, KITCHEN), Snapshot.of(shuffled, KITCHEN)
    assert text(Planner(one, SETTINGS), recipe) == text(Planner(other, SETTINGS), recipe)
    units = chance.sample(other.units, len(other.units))
    assert text(Planner(one, SETTINGS, one.units), recipe) == text(Planner(other, SETTINGS, units), recipe)


@pytest.mark.slow
@for_some_questions
@given(questions(), st.data())
def test_a_recipe_has_one_answer_alone_and_after_others_in_part_of_the_foon_and_in_the_whole(question, data):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    among = Planner(snapshot, SETTINGS, snapshot.units)
    text(among, data.draw(questions().map(lambda other: other[1])))
    assert text(among, recipe) == text(Planner(snapshot, SETTINGS), recipe)
