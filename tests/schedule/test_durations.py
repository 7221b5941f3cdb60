"""How long a motion takes is what was seen, no more: medians of real sightings, and nothing where there are none."""

from __future__ import annotations

import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model import Measures, ObjectNode, Sighting
from foon_kg.plans.durations import Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.shopping import shopping_list

KITCHEN = Kitchen.default()


def test_the_median_and_its_quartiles_are_of_the_timed_sightings():
    seen = [("chop", Sighting("a", i, None, 10.0, 10.0 + s)) for i, s in enumerate((2, 4, 6, 8, 30))]
    times = Durations.of([*seen, ("chop", Sighting("a", 9)), ("stir", Sighting("a", 8, None, 5.0, None))])
    chop = times.by_motion["chop"]
    assert (chop.median, chop.low, chop.high, chop.sightings) == (6, 4, 8, 5)
    assert "stir" not in times.by_motion


def test_a_sighting_counts_once_and_time_does_not_run_backwards():
    once = ("chop", Sighting("a", 1, None, 0.0, 4.0))
    backwards = ("chop", Sighting("b", 1, None, 9.0, 3.0))
    assert Durations.of([once, once, backwards]).by_motion["chop"].sightings == 1


def test_an_action_within_one_second_takes_about_one():
    assert Durations.of([("crack", Sighting("a", 1, None, 35.0, 35.0))]).by_motion["crack"].median == 1


@pytest.mark.parametrize("motion", ["bake", "boil", "cook and stir", "cool down", "ferment"])
def test_what_cooks_or_goes_on_by_itself_is_cut_short_in_videos_and_has_no_time_from_them(motion):
    seen = [(motion, Sighting("a", 1, None, 0.0, 5.0)), ("chop", Sighting("a", 2, None, 5.0, 9.0))]
    assert list(Durations.of(seen).by_motion) == ["chop"]
    said = Durations.of(seen).of_step(motion, Measures((), 3600.0))
    assert (said.median, said.sightings) == (3600, 0)


def test_without_any_time_nothing_is_known():
    assert Durations.of([("chop", Sighting("a", 1))]) == Durations({}, None)


@given(st.lists(st.tuples(st.sampled_from(["chop", "stir"]), st.integers(1, 99)), min_size=1))
def test_medians_are_medians(rows):
    times = Durations.of((motion, Sighting("a", i, None, 0.0, float(s))) for i, (motion, s) in enumerate(rows))
    for motion in {motion for motion, _ in rows}:
        seconds = [s for other, s in rows if other == motion]
        assert times.by_motion[motion].median == pytest.approx(statistics.median(seconds))
        assert min(seconds) <= times.by_motion[motion].low <= times.by_motion[motion].high <= max(seconds)
    assert times.overall.sightings == len(rows)


def test_one_buys_foods_once_wherever_they_lie_and_neither_water_nor_knives():
    onion = ObjectNode("onion", ("whole",))
    leaves = [
        ObjectNode("knife"),
        ObjectNode("onion", ("whole",), (), "in", "bag"),
        onion,
        ObjectNode("water"),
        ObjectNode("bottle", (), ("olive oil",)),
        ObjectNode("bowl", ("empty",)),
    ]
    assert shopping_list(leaves, KITCHEN) == (ObjectNode("olive oil"), onion)
