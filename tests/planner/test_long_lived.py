"""A planner that lives long: it keeps a little of what it worked out, and answers as if it kept all or nothing."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from planner.dishes import KITCHEN, SETTINGS, questions

from foon_kg import likeness, planner, preparation, reading, script, substitution, workshop
from foon_kg.errors import NoTreeError
from foon_kg.form import foon
from foon_kg.model import Recipe
from foon_kg.planner import Planner
from foon_kg.result import PlanFailure
from foon_kg.search import ground
from foon_kg.snapshot import Snapshot

ROOM = ((workshop, "MOST_TREES"), (workshop, "MOST_KITCHENS"), (ground, "MOST_TREES"))
ROOM += ((reading, "MOST_READINGS"), (reading, "MOST_FOODS"), (preparation, "MOST_WANTS"))
ROOM += ((script, "MOST_SCENES"), (script, "MOST_PERFORMANCES"), (script, "_MOST_TIMES"), (foon, "MOST_DERIVATIONS"))
ROOM += ((planner, "MOST_UNITS"), (planner, "MOST_KITCHENS"), (substitution, "MOST_FOODS"))
ROOM += ((likeness, "LEAST_KEPT"), (likeness, "MOST_KEPT"))


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
        assert forgetful.whole is not None
        assert len(forgetful.whole.references) <= 1
        assert len(forgetful.likeness.rows) <= 1
    assert little == [answer(roomy, recipe) for recipe in recipes]
