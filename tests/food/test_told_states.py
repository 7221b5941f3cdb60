"""What is asked of a food of which several things are said."""

from __future__ import annotations

import tomllib
from importlib.resources import files

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
    assert in_turn("peeled and deveined") == ("peeled", "deveined")
    assert in_turn("juice and zest") == ("juice and zest",)


@pytest.mark.parametrize(
    ("word", "state"),
    [("julienne", "julienned"), ("Slices", "sliced"), ("cut into thin slivers", "slivered"), ("rings", "ring shaped")],
)
def test_another_word_for_a_cut_means_the_listed_state_and_says_as_much_of_a_food(word, state):
    assert tables().state_called(word) == state
    assert tables().state(word).earns == tables().state(state).earns


@pytest.mark.parametrize(
    ("told", "asked"),
    [
        (["smoked", "sliced"], "smoked, sliced"),
        (["leftover", "chopped"], "leftover, chopped"),
        (["fresh", "sliced"], "sliced"),
    ],
)
def test_what_is_bought_smoked_and_cut_then_is_asked_both(told, asked):
    assert asked_state(told, tables()) == asked


@pytest.mark.parametrize("word", ["sliced", "smoky", "", "leaves", "skin on"])
def test_what_is_listed_or_no_cut_is_left_as_it_is_said(word):
    assert tables().state_called(word) == word


def test_each_other_word_stands_for_a_listed_state_and_is_none_itself():
    called = tomllib.loads(files("foon_kg.food").joinpath("states.toml").read_text(encoding="utf-8"))["called"]
    assert set(called.values()) <= tables().states.keys()
    assert not called.keys() & tables().states.keys()
