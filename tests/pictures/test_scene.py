"""When each box of a picture is needed, and of which foods it is."""

from __future__ import annotations

import itertools

import pytest
from pictures.demo_plans import demo_plan, demo_recipe_names

from foon_kg.formats.pictures.scene import MotionBox, foods_of, phases_of, scene_of
from foon_kg.plans.kitchen import Kitchen

KITCHEN = Kitchen.default()
ORDER = ("prepare", "heat", "finish")


@pytest.mark.parametrize("name", demo_recipe_names())
def test_what_is_made_has_the_phase_of_its_maker_and_what_is_taken_that_of_its_taker(name):
    plan = demo_plan(name)
    scene = scene_of(plan.units, plan.goal, KITCHEN)
    phases = phases_of(scene)
    assert len(phases) == len(scene.boxes)
    makers = {end: start for start, end in scene.arrows}
    takers = dict(scene.arrows)
    for place, box in enumerate(scene.boxes):
        if isinstance(box, MotionBox):
            assert ORDER[phases[place]] == box.unit.phase
        elif place in makers:
            assert phases[place] == phases[makers[place]]
        else:
            assert phases[place] == phases[takers[place]]
    if len(set(phases)) > 1:
        crossing = [(a, b) for a, b in scene.arrows if phases[a] != phases[b]]
        assert crossing
        assert not any(isinstance(scene.boxes[a], MotionBox) for a, _ in crossing), "it is made before it is taken on"


def test_a_tree_without_phases_has_no_bands():
    plan = demo_plan("limeade")
    plain = [unit.of_unit(unit.as_unit(), "foon", unit.seen_in) for unit in plan.units]
    assert phases_of(scene_of(plain, plan.goal, KITCHEN)) == ()


@pytest.mark.parametrize("name", demo_recipe_names())
def test_a_box_is_of_the_foods_that_it_names_and_of_no_utensil(name):
    plan = demo_plan(name)
    scene = scene_of(plan.units, plan.goal, KITCHEN)
    for box, foods in zip(scene.boxes, foods_of(scene, KITCHEN), strict=True):
        nodes = (*box.unit.input_nodes, *box.unit.output_nodes) if isinstance(box, MotionBox) else (box.node,)
        named = set(itertools.chain.from_iterable((node.label, *node.ingredients) for node in nodes))
        assert foods == {label for label in named if not KITCHEN.is_utensil(label)}
