"""A plan result shows itself in a notebook, and its steps are a table."""

from __future__ import annotations

import sys

import pytest

from foon_kg.formats.views.notebook import plan_html, steps_frame
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient, Sighting
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.errors import UsageError
from foon_kg.model.tree import Step
from foon_kg.plans.result import PlanResult, ReferenceSummary

KOHLRABI, GRATED = ObjectNode("kohlrabi", ("whole",)), ObjectNode("kohlrabi", ("grated",), (), "in", "bowl")
SALAD = ObjectNode("salad", ("mixed",), ("kohlrabi",))
CREAM = ObjectNode("cream <sour>", ("whipped",))
PLAN = PlanResult(
    recipe=Recipe("salad", (RequiredIngredient("kohlrabi", "grated"),), title="Kohlrabi & cream"),
    reference=ReferenceSummary(SALAD, 7, 0, exact=True),
    goal=SALAD,
    units=(
        Step.of((KOHLRABI,), "grate", (GRATED,), "adapted", (Sighting("carrot", 2, None, 5.0, 9.0),)),
        Step.of((GRATED, CREAM), "toss", (SALAD,), "foon", ()),
    ),
    kitchen=(KOHLRABI, CREAM),
    substitutions=(Substitution("object", "kohlrabi", "kohlrabi", "carrot", 0.534, (Alternative("celery", 0.2),)),),
    assumptions=(Assumption(CREAM, "nothing makes it"),),
)


def test_a_notebook_shows_steps_substitutions_and_assumptions():
    html = plan_html(PLAN.to_json())
    assert "<b>Kohlrabi &amp; cream</b>" in html
    for told in ("grate", "toss", "~kohlrabi", "0.53", "like carrot", "or celery 0.20", "nothing makes it"):
        assert told in html
    assert "cream &lt;sour&gt;" in html
    assert "<sour>" not in html
    assert html.count("<tr>") == 1 + len(PLAN.units)


def test_a_frame_has_a_row_a_step():
    pytest.importorskip("pandas", reason="pandas is not installed")
    frame = steps_frame(PLAN.to_json())
    assert list(frame.index) == [1, 2]
    assert list(frame.columns) == ["motion", "inputs", "outputs", "origin", "video", "start", "end"]
    assert frame.loc[1, "inputs"] == ["kohlrabi (whole)"]
    assert frame.loc[1, "outputs"] == ["kohlrabi (grated; in bowl)"]
    assert tuple(frame.loc[1, ["video", "start", "end"]]) == ("carrot", 5.0, 9.0)
    assert frame.loc[2, ["video", "start", "end"]].isna().all()


def test_without_pandas_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(UsageError, match="needs pandas") as raised:
        steps_frame(PLAN.to_json())
    assert "pip install 'foon-kg[recipes]'" in raised.value.hint
