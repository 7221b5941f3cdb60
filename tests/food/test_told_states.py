"""What is asked of a food of which several things are said."""

from __future__ import annotations

import pytest

from foon_kg.food import tables
from foon_kg.food.told_states import asked_state, in_turn


@pytest.mark.parametrize(
    ("states", "asked"),
    [
        ((), ""),
        (("chopped",), "chopped"),
        (("peeled", "chopped"), "chopped"),
        (("melted", "cooled"), "melted"),
        (("grated", "dry", "squeezed"), "grated"),
        (("cold",), "cold"),
        (("boiled", "peeled", "chopped"), "boiled, chopped"),
        (("cooked", "crumbled"), "cooked, crumbled"),
        (("sliced", "toasted"), "toasted"),
        (("drained", "chopped"), "chopped"),
        (("drained",), "drained"),
        (("diced", "drained"), "diced"),
        (("canned", "drained"), "drained"),
        (("canned", "drained", "chopped"), "canned, chopped"),
        (("sliced", "cooked"), "sliced, cooked"),
        (("frozen", "chopped", "thawed", "drained"), "thawed"),
    ],
)
def test_what_stays_is_asked_and_what_heat_made_of_it_before(states, asked):
    assert asked_state(states, tables()) == asked


def test_states_come_about_in_turn():
    assert in_turn("boiled, chopped") == ("boiled", "chopped")
    assert in_turn("soft mass") == ("soft mass",)
    assert in_turn("") == ()
