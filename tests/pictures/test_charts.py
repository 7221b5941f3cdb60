"""The chart of a schedule and the picture of what changed have a word for every step."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import pytest
from pictures.demo_plans import demo_foon, demo_plan

pytest.importorskip("altair", reason="the extra “pictures” is not installed")
from foon_kg.durations import Duration, Durations
from foon_kg.kitchen import Kitchen
from foon_kg.pictures.gantt import schedule_svg
from foon_kg.pictures.step_changes import step_changes_svg
from foon_kg.planner import Planner
from foon_kg.schedule import schedule
from foon_kg.settings import PlanSettings
from foon_kg.step_changes import step_changes
from foon_kg.views.shown_tree import ShownTree

SVG = "{http://www.w3.org/2000/svg}"


def texts(svg):
    return ["".join(element.itertext()) for element in ET.fromstring(svg).iter(f"{SVG}text")]


def test_a_chart_has_a_row_a_step_and_says_which_were_never_timed():
    tree = ShownTree.of_result(demo_plan("kohlrabi_salad"))
    chop = Duration(8.0, 6.0, 12.0, 5)
    plan = schedule(tree.units, tree.kitchen, Durations({"chop": chop}, chop), Kitchen.default(), 2)
    words = texts(schedule_svg(tree, plan))
    for number, unit in enumerate(tree.units, start=1):
        assert any(text.split()[:2] == [str(number), unit.motion_node.split()[0]] for text in words)
    chopped = sum(unit.motion_node == "chop" for unit in tree.units)
    assert words.count("never timed") == len(tree.units) - chopped
    assert {"pair of hands 1", "pair of hands 2", "by itself"} <= set(words)


def test_the_picture_of_changes_has_both_trees():
    tree = ShownTree.of_result(demo_plan("kohlrabi_salad"))
    with demo_foon().reading() as view:
        reference = Planner(view, PlanSettings()).reference_tree(tree.result.recipe, tree.result.reference.goal)
    assert len(reference) == tree.result.reference.units
    words = texts(step_changes_svg(tree, step_changes(reference, tree.units)))
    for number, known in enumerate(reference, start=1):
        assert f"{number} {known.unit.motion}" in words
    for number, unit in enumerate(tree.units, start=1):
        assert f"{number} {unit.motion_node}" in words
    assert any(text.startswith("- carrot") for text in words)
