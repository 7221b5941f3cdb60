"""What a step goes back to: foods that stand for those of the video, and no others."""

from __future__ import annotations

from pictures.demo_plans import demo_foon, demo_plan, demo_recipe_names

from foon_kg.web.evidence import by_place, stands_in


def test_every_place_of_the_foon_has_its_unit():
    places = by_place(demo_foon().units)
    for subgraph in demo_foon().subgraphs:
        for number, annotation in enumerate(subgraph.annotations):
            assert places[subgraph.name, number].unit.motion == annotation.unit.motion


def test_a_food_stands_for_one_that_the_video_shows_and_the_step_does_not_have_by_chance():
    places = by_place(demo_foon().units)
    found = 0
    for name in demo_recipe_names():
        plan = demo_plan(name)
        for unit in plan.units:
            own = {
                label for node in (*unit.input_nodes, *unit.output_nodes) for label in (node.label, *node.ingredients)
            }
            for one in stands_in(unit, plan.substitutions, places):
                found += 1
                assert one["object"] in own
                shown = {
                    label
                    for seen in unit.seen_in
                    for part in [places[seen.video, seen.position].unit]
                    for node in (*part.input_nodes, *part.output_nodes)
                    for label in (node.label, *node.ingredients)
                }
                assert one["equivalent"] in shown
                assert one["object"] not in shown
            if unit.origin == "foon":
                assert stands_in(unit, plan.substitutions, places) == []
    assert found, "some step is done to a like food"
