"""The chart of a schedule and the picture of what changed have a word for every step."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import pytest
from pictures.demo_plans import demo_foon, demo_plan

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
from foon_kg.formats.exports.phrases import motion_said
from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.pictures.gantt import schedule_svg
from foon_kg.formats.pictures.step_changes import step_changes_svg
from foon_kg.formats.pictures.svg import text_width
from foon_kg.formats.views.schedule import clock
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.durations import Duration, Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.schedule import schedule
from foon_kg.plans.step_changes import step_changes

SVG = "{http://www.w3.org/2000/svg}"


def texts(svg):
    return ["".join(element.itertext()) for element in ET.fromstring(svg).iter(f"{SVG}text")]


def test_a_chart_has_a_row_a_step_and_says_which_were_never_timed():
    tree = ShownTree.of_result(demo_plan("kohlrabi_salad"))
    chop = Duration(8.0, 6.0, 12.0, 5)
    plan = schedule(tree.units, tree.kitchen, Durations({"chop": chop}, chop), Kitchen.default(), 2)
    words = texts(schedule_svg(tree, plan))
    for number, unit in enumerate(tree.units, start=1):
        said = sentence(unit.as_unit(), Kitchen.default())
        assert any(text.startswith(f"{number} {said[:30]}") for text in words)
    titles = [one.text for one in ET.fromstring(schedule_svg(tree, plan, 640)).iter(f"{SVG}title")][1:]
    for step, title in zip(plan.steps, titles, strict=True):
        known = step.end <= plan.known_until
        assert title.startswith(f"{clock(step.start)} to {clock(step.end)}: " if known else "nobody knows when: ")
    chopped = sum(unit.motion == "chop" for unit in tree.units)
    assert words.count("unknown") == len(tree.units) - chopped
    assert {"pair of hands 1", "pair of hands 2"} <= set(words)
    by_itself = any(step.hands is None for step in plan.steps)
    assert ("by itself" in words) == by_itself


@pytest.mark.parametrize("width", [280, 326, 640, 1180])
def test_bars_of_a_chart_stand_where_their_times_are_and_on_the_paper(width):
    tree = ShownTree.of_result(demo_plan("kohlrabi_salad"))
    plan = schedule(tree.units, tree.kitchen, Durations.of_units(demo_foon().units), Kitchen.default(), 2)
    picture = ET.fromstring(schedule_svg(tree, plan, width))
    assert float(picture.get("width")) == width
    rows = picture.findall(f"{SVG}g")
    bars = [row.find(f"{SVG}rect") for row in rows]
    starts = [float(bar.get("x")) for bar in bars]
    scale = (max(starts) - min(starts)) / max(step.start for step in plan.steps)
    for row, bar, step in zip(rows, bars, plan.steps, strict=True):
        assert float(bar.get("x")) == pytest.approx(min(starts) + scale * step.start, abs=0.2)
        assert float(bar.get("width")) == pytest.approx(max(scale * (step.end - step.start), 2), abs=0.2)
        assert float(bar.get("x")) + float(bar.get("width")) <= width
        assert plan.untimed == len(plan.steps), "nothing in the demo was ever timed"
        told = f"nobody knows when: step {step.place + 1}"
        assert row.find(f"{SVG}title").text.startswith(told)


@pytest.mark.parametrize("width", [280, 326, 1180])
def test_a_chart_tells_every_step_in_full_and_no_row_lies_on_another(width):
    tree = ShownTree.of_result(demo_plan("kohlrabi_salad"))
    plan = schedule(tree.units, tree.kitchen, Durations.of_units(demo_foon().units), Kitchen.default())
    rows = ET.fromstring(schedule_svg(tree, plan, width)).findall(f"{SVG}g")
    last = 0.0
    for row, step in zip(rows, plan.steps, strict=True):
        said = [("".join(text.itertext()), float(text.get("y"))) for text in row.iter(f"{SVG}text")]
        words = " ".join(text for text, _ in said if text != "unknown")
        assert words == f"{step.place + 1} {sentence(tree.units[step.place].as_unit(), Kitchen.default())}"
        assert min(y for _, y in said) - 11 > last
        assert all(text_width(text, 12) < width - 24 for text, _ in said)
        last = max(y for _, y in said)


def test_the_picture_of_changes_has_both_trees():
    tree = ShownTree.of_result(demo_plan("kohlrabi_salad"))
    with demo_foon().reading() as view:
        reference = Planner(view, PlanSettings()).reference_tree(tree.result.recipe, tree.result.reference.goal)
    assert len(reference) == tree.result.reference.units
    words = texts(step_changes_svg(tree, step_changes(reference, tree.units)))
    for number, known in enumerate(reference, start=1):
        assert f"{number} {motion_said(known.unit.motion)}" in words
    for number, unit in enumerate(tree.units, start=1):
        assert f"{number} {motion_said(unit.motion)}" in words
    assert any(text.startswith("- carrot") for text in words)
