"""The picture of a tree shows every step, marks what was never seen, and needs nothing but itself."""

from __future__ import annotations

import re
from xml.etree import ElementTree as ET

import pytest
from foons import subgraphs_named
from hypothesis import given, settings
from pictures.demo_plans import demo_plan, demo_recipe_names

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.formats.exports.phrases import motion_said
from foon_kg.formats.pictures.png import png_of
from foon_kg.formats.pictures.progress import progress_svg
from foon_kg.formats.pictures.scene import MotionBox, ObjectBox, scene_of
from foon_kg.formats.pictures.tree import tree_svg
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult

KITCHEN = Kitchen.default()
SVG = "{http://www.w3.org/2000/svg}"
every_demo_recipe = pytest.mark.parametrize("name", demo_recipe_names())


def shown(name):
    return ShownTree.of_result(demo_plan(name))


def texts(svg):
    return [element.text for element in ET.fromstring(svg).iter(f"{SVG}text")]


@every_demo_recipe
@pytest.mark.parametrize("folded", [True, False])
def test_every_step_leads_on_to_the_goal(name, folded):
    tree = shown(name)
    scene = scene_of(tree.units, tree.goal, KITCHEN, folded=folded)
    goal = [place for place, box in enumerate(scene.boxes) if isinstance(box, ObjectBox) and box.part == "goal"]
    assert len(goal) == 1
    leads_on = set(goal)
    for before, after in sorted(scene.arrows, reverse=True, key=lambda arrow: arrow[1]):
        if after in leads_on:
            leads_on.add(before)
    while new := {before for before, after in scene.arrows if after in leads_on} - leads_on:
        leads_on |= new
    steps = [place for place, box in enumerate(scene.boxes) if isinstance(box, MotionBox)]
    assert [scene.boxes[place].number for place in steps] == list(range(1, len(tree.units) + 1))
    assert set(steps) <= leads_on


@every_demo_recipe
def test_folding_hides_utensils_but_names_them_and_hides_no_food_that_a_step_takes(name):
    tree = shown(name)
    folded = scene_of(tree.units, tree.goal, KITCHEN)
    whole = scene_of(tree.units, tree.goal, KITCHEN, folded=False)
    assert len(folded.boxes) < len(whole.boxes)
    drawn = {box.node for box in folded.boxes if isinstance(box, ObjectBox)}
    tools = {name for box in folded.boxes if isinstance(box, MotionBox) for name in box.tools}
    for node in (node for unit in tree.units for node in unit.input_nodes):
        if KITCHEN.is_food(node):
            assert node in drawn
        elif not KITCHEN.foods_in(node):
            assert node in drawn or node.label in tools


def test_words_of_every_step_and_node_are_in_the_picture():
    tree = shown("kohlrabi_salad")
    words = texts(tree_svg(tree, KITCHEN))
    for number, unit in enumerate(tree.units, start=1):
        assert any(text.removeprefix("+ ") == f"{number} {motion_said(unit.motion)}" for text in words)
    assert tree.title in words
    assert tree.goal.label in words


def test_an_unseen_food_is_blue_and_dashed_and_says_what_stands_for_it():
    tree = shown("kohlrabi_salad")
    (like,) = tree.unseen.values()
    root = ET.fromstring(tree_svg(tree, KITCHEN))
    assert f"like {like.equivalent} {like.confidence:.2f}" in [e.text for e in root.iter(f"{SVG}text")]
    named = [g for g in root.iter(f"{SVG}g") if any(e.text == "~kohlrabi" for e in g.findall(f"{SVG}text"))]
    assert named
    for group in named:
        box = group.find(f"{SVG}rect")
        assert "unseen-box" in box.get("class")
        assert box.get("stroke-dasharray")
    plain = [g for g in root.iter(f"{SVG}g") if not any("~" in (e.text or "") for e in g.findall(f"{SVG}text"))]
    kitchen = [box for g in plain if (box := g.find(f"{SVG}rect")) is not None and box.get("class") == "kitchen"]
    assert kitchen
    assert not any(box.get("stroke-dasharray") for box in kitchen)


@settings(max_examples=30)
@given(subgraphs_named("any"))
def test_any_subgraph_with_a_unit_can_be_drawn(subgraph):
    if not subgraph.annotations:
        return
    tree = ShownTree.of_subgraph(subgraph)
    for folded in (True, False):
        words = texts(tree_svg(tree, KITCHEN, folded=folded))
        for number, unit in enumerate(tree.units, start=1):
            assert f"{number} {unit.motion}" in words


def test_every_video_of_the_demo_can_be_drawn():
    for subgraph in demo_subgraphs():
        tree = ShownTree.of_subgraph(subgraph)
        assert len(re.findall("<title>", tree_svg(tree, KITCHEN))) > len(tree.units)


def test_words_that_mean_something_in_xml_are_only_words():
    strange = ObjectNode('<b>"&\x00', ("a<b",), ("x&y",))
    units = (Step.of((strange,), "mix & <stir>", (ObjectNode("soup"),), "foon", ()),)
    svg = tree_svg(ShownTree("<title>", units, ObjectNode("soup"), (strange,), ()), KITCHEN)
    assert '<b>"&\ufffd' in texts(svg)
    assert "1 mix & <stir>" in texts(svg)


@every_demo_recipe
def test_pictures_need_nothing_from_elsewhere(name):
    for svg in (tree_svg(shown(name), KITCHEN), progress_svg(shown(name))):
        assert re.findall(r"https?://[^\"<]*", svg) == ["http://www.w3.org/2000/svg"]
        assert not re.search(r"<(image|use|script|foreignObject)|@import|url\((?!#)", svg)


def test_the_progress_picture_has_a_row_for_each_line_with_its_motions():
    tree = shown("kohlrabi_salad")
    words = texts(progress_svg(tree))
    for line in tree.lines:
        assert {line.ingredient, f"~{line.ingredient}"} & set(words)
    motions = [f"{step.motion} →" for line in tree.lines for step in line.steps]
    assert [text for text in words if text.endswith(" →")] == motions


@every_demo_recipe
def test_a_plan_that_was_read_back_shows_the_same_progress(name):
    plan = demo_plan(name)
    again = ShownTree.of_result(PlanResult.from_json(plan.to_json()))
    told = [[step.object for step in line.steps] for line in again.lines]
    assert told == [[step.object for step in line.steps] for line in plan.progress_lines]


def test_a_png_is_as_large_as_asked():
    png = png_of(progress_svg(shown("courgette_salad")), scale=1)
    assert png.startswith(b"\x89PNG")
    assert int.from_bytes(png[16:20], "big") == 1180
