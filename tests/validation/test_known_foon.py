"""The FOON as the judge looks things up in it: sightings, units, labels of motions, end products, operators, levels."""

from __future__ import annotations

import pytest
from validation.judging import ONE_TOMATO, foon_of

from foon_kg.model import FunctionalUnit, Goal, KnownUnit, ObjectNode, Participant, Sighting
from foon_kg.model.levels import Level
from foon_kg.validation import KnownFoon

TEXT = f"""
name: tomatoes
{ONE_TOMATO}
tomatoes (sliced; on plate) + bowl (empty) → POUR → tomatoes (sliced; in bowl) + bowl ({{tomato}})
---
name: apples
dish: pie
goal: apple pie ({{apple}})
apple (whole) + bowl (clean) + knife → DICE → apple (diced, wet) + bowl (filled)
---
name: more_apples
dish: pie
goal: apple tart ({{apple}})
apple (diced) + wibble (raw) → BAKE → apple (diced, baked) + wibble (baked)
"""


@pytest.fixture
def foon():
    """The FOON of the text, read anew: it keeps what it was asked."""
    return foon_of(TEXT)


MARKED = KnownFoon.of(
    KnownUnit(
        FunctionalUnit((), motion, (Participant(ObjectNode(label), dish_type=dish), Participant(ObjectNode("bowl")))),
        (Sighting(motion, 0),),
    )
    for motion, label, dish in (("mix", "salad", "salad"), ("stir", "soup", "soup"), ("toss", "green salad", "salad"))
)
"""A FOON without goals, whose units carry their dish classes."""


def test_a_unit_is_found_by_video_and_place(foon):
    assert foon.by_sighting["tomatoes", 1].motion == "pour"
    assert foon.by_sighting["apples", 0].motion == "dice"
    assert ("tomatoes", 2) not in foon.by_sighting
    assert ("pears", 0) not in foon.by_sighting


def test_a_unit_is_found_by_what_it_does_to_what(foon):
    unit = foon.by_sighting["apples", 0]
    assert foon.by_key[frozenset(unit.input_nodes), "dice", frozenset(unit.output_nodes)] is unit
    assert (frozenset(unit.output_nodes), "dice", frozenset(unit.input_nodes)) not in foon.by_key
    assert len(foon.by_key) == 4


def test_labels_of_a_motion_are_what_its_units_take_or_make_in_the_singular(foon):
    assert foon.labels_of_motion["pour"] == {"tomato", "bowl"}
    assert foon.labels_of_motion["bake"] == {"apple", "wibble"}
    assert set(foon.labels_of_motion) == {"slice", "pour", "dice", "bake"}


def test_labels_of_a_motion_are_gathered_from_all_its_units():
    foon = foon_of("a → MIX → b\nc → MIX → d")
    assert foon.labels_of_motion == {"mix": {"a", "b", "c", "d"}}


def test_end_products_are_the_labels_of_the_goals_by_dish_type(foon):
    assert foon.end_products == {"pie": {"apple pie", "apple tart"}}


def test_without_goals_the_marks_of_the_units_tell_the_end_products():
    assert MARKED.end_products == {"salad": {"salad", "green salad"}, "soup": {"soup"}}


def test_goals_come_before_the_marks_of_the_units():
    goal = Goal(ObjectNode("stew"), "soup", (), ())
    assert KnownFoon.of(MARKED.units, [goal]).end_products == {"soup": {"stew"}}


def test_operators_are_the_states_that_a_unit_gives_to_a_food_and_to_its_kind(foon):
    assert {("apple", "diced"), ("apple", "wet")} <= foon.operators
    assert ("tomato", "sliced") in foon.operators
    assert len({name for name, state in foon.operators if state == "diced"}) == 2


def test_a_state_that_was_there_before_is_given_by_no_operator(foon):
    assert ("tomato", "whole") not in foon.operators
    assert not [state for _, state in foon.operators if state in {"whole", "raw"}]
    assert ("apple", "baked") in foon.operators


def test_utensils_have_no_operators(foon):
    assert not [name for name, _ in foon.operators if name in {"bowl", "plate", "knife"}]
    assert ("bowl", "filled") not in foon.operators


def test_what_comes_out_without_having_gone_in_has_no_operator():
    assert foon_of("water (liquid) → BREW → tea (hot)").operators == frozenset()


def test_units_stand_in_the_order_of_their_keys_whatever_the_order_of_the_files(foon):
    assert KnownFoon.of(reversed(foon.units), foon.goals) == foon
    assert [known.unit.key for known in foon.units] == sorted(known.unit.key for known in foon.units)


def test_at_its_own_level_a_foon_is_itself(foon):
    assert foon.at(Level.INGREDIENTS) is foon


@pytest.mark.parametrize("level", [Level.OBJECTS, Level.STATES])
def test_a_lower_level_is_made_once(foon, level):
    assert foon.at(level) is foon.at(level)


def test_at_a_lower_level_nodes_and_goals_say_less(foon):
    objects, states = foon.at(Level.OBJECTS), foon.at(Level.STATES)
    assert objects.by_sighting["tomatoes", 0].input_nodes[0] == ObjectNode("tomato")
    assert ObjectNode("bowl") in states.by_sighting["tomatoes", 1].output_nodes
    assert ObjectNode("apple", ("whole",)) in states.by_sighting["apples", 0].input_nodes
    assert [goal.node for goal in objects.goals] == [ObjectNode("apple pie"), ObjectNode("apple tart")]
    assert [goal.node for goal in states.goals] == [goal.node for goal in objects.goals]
    assert objects.end_products == foon.end_products
