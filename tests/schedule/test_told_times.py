"""A schedule says what is known of its times, and “unknown” where nobody timed anything."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from foon_kg.foon.demo import demo_folder
from foon_kg.formats.pictures.gantt import schedule_svg
from foon_kg.formats.views.schedule import schedule_view, summary
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.loaders import read_text
from foon_kg.model import Measures
from foon_kg.plans.durations import Duration, Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.schedule import Schedule, schedule

FILE = demo_folder() / "greek_salad.txt"
TREE = ShownTree.of_subgraph(read_text(FILE.read_text(encoding="utf-8"), FILE.stem, str(FILE)).subgraph)
MOTIONS = sorted({unit.motion for unit in TREE.units})
USUAL = Duration(median=7.0, low=6.0, high=8.0, sightings=3)


def planned(motions) -> Schedule:
    """The schedule of the tree where only these motions were ever timed."""
    durations = Durations(dict.fromkeys(motions, USUAL), USUAL if motions else None)
    return schedule(TREE.units, TREE.kitchen, durations, Kitchen.default())


def printed(plan: Schedule) -> str:
    console = Console(width=140, color_system=None)
    with console.capture() as seen:
        console.print(schedule_view(TREE, plan))
    return seen.get()


def svg_words(plan: Schedule) -> str:
    return " ".join(re.findall(r">([^<]+)<", schedule_svg(TREE, plan)))


def test_where_all_was_timed_every_time_is_told():
    plan = planned(MOTIONS)
    assert "unknown" not in printed(plan)
    assert "with one pair of hands" in summary(plan)
    assert plan.to_json()["untimed"] == 0
    assert "nobody knows" not in svg_words(plan)


def test_where_nothing_was_timed_there_is_no_time_at_all():
    plan = planned([])
    text = printed(plan)
    assert (
        summary(plan)
        == f"How long it takes is unknown: no video of this FOON times any of its {len(TREE.units)} steps."
    )
    assert not re.search(r"\d:\d\d", text)
    assert not re.search(r"\d:\d\d", svg_words(plan))
    assert plan.to_json()["untimed"] == len(TREE.units)


@given(st.sets(st.sampled_from(MOTIONS)))
def test_a_time_is_told_only_where_all_before_it_was_timed(motions):
    plan = planned(motions)
    rows = [line for line in printed(plan).splitlines() if re.search(r"\d [A-Z][a-z]+ ", line)]
    known = True
    for step, row in zip(plan.steps, rows, strict=True):
        earlier = [one for one in plan.steps if one.start < step.start]
        if any(one.duration is None for one in earlier):
            assert not re.match(r"\s*\d+:\d\d", row)
            known = False
    assert known or plan.untimed
    assert ("unknown" in summary(plan)) == (plan.untimed > 0)


@pytest.mark.parametrize("hands", [1, 2])
def test_what_was_timed_is_summed_without_what_was_not(hands):
    plan = schedule(TREE.units, TREE.kitchen, Durations({MOTIONS[0]: USUAL}, USUAL), Kitchen.default(), hands)
    timed = sum(unit.motion == MOTIONS[0] for unit in TREE.units)
    told = summary(plan)
    assert f"nothing tells how long {len(TREE.units) - timed} of its {len(TREE.units)} steps take" in told
    assert told.endswith(f"The others take {7 * timed // 60}:{7 * timed % 60:02} in all.")


def test_what_a_recipe_says_is_the_time_of_a_step():
    units = tuple(replace(unit, measures=Measures((), 1500.0)) for unit in TREE.units[:1])
    plan = schedule(units, TREE.kitchen, Durations({}, None), Kitchen.default())
    assert (plan.length, plan.untimed) == (1500, 0)
    assert "25:00, as a recipe says" in printed(plan)
