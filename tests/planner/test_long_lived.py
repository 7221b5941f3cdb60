"""A planner that lives long: it keeps a little of what it worked out, and answers as if it kept all or nothing."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from planner.dishes import KITCHEN, SETTINGS, questions

from foon_kg.integration.joining import joiners, places
from foon_kg.integration.teaching import operators
from foon_kg.model import Recipe
from foon_kg.model.errors import NoTreeError
from foon_kg.planning import likes, references
from foon_kg.planning.planner import Planner
from foon_kg.plans.result import PlanFailure
from foon_kg.search import ground
from foon_kg.store.snapshot import Snapshot
from foon_kg.world import reading

ROOM = (
    (references, "MOST_TREES"), (ground, "MOST_TREES"), (likes, "MOST_KEPT"), (operators, "MOST_KEPT"),
    (joiners, "MOST_JOINERS"), (places, "MOST_JOINED"), (reading, "MOST_READ"),
)  # fmt: skip


def answer(planner: Planner, recipe: Recipe) -> str:
    try:
        return json.dumps(planner.plan(recipe).to_json())
    except NoTreeError as error:
        return json.dumps(PlanFailure.of(recipe, error).to_json())


@settings(max_examples=25, deadline=None)
@given(st.lists(questions(), min_size=2, max_size=3))
def test_how_much_a_planner_keeps_does_not_change_its_answers(asked):
    snapshot = Snapshot.of(asked[0][0], KITCHEN)
    recipes = [recipe for _, recipe in asked] * 2
    roomy = Planner(snapshot, SETTINGS, snapshot.units)
    with pytest.MonkeyPatch.context() as patch:
        for module, name in ROOM:
            patch.setattr(module, name, 1)
        forgetful = Planner(snapshot, SETTINGS, snapshot.units)
        little = [answer(forgetful, recipe) for recipe in recipes]
    assert little == [answer(roomy, recipe) for recipe in recipes]
