"""What the planner lays before the judge is what the judge reads in the JSON of the same plan."""

from __future__ import annotations

from hypothesis import assume, given, settings
from planner.dishes import KITCHEN, SETTINGS, questions

from foon_kg.errors import NoTreeError
from foon_kg.form import TaskTree
from foon_kg.planner import Planner
from foon_kg.snapshot import Snapshot
from foon_kg.submission import submitted


@settings(max_examples=40, deadline=None)
@given(questions())
def test_the_judge_gets_what_it_would_read_in_the_json(question):
    subgraphs, recipe = question
    try:
        result = Planner(Snapshot.of(subgraphs, KITCHEN), SETTINGS).plan(recipe)
    except NoTreeError:
        assume(False)
    assert submitted(result) == TaskTree.from_json(result.to_json())
