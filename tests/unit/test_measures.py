"""How much, how long and how hot: in words, and told of the steps that are made after a recorded dish."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.formats.exports.sentences import sentence
from foon_kg.loaders.muhai import read_muhai_text
from foon_kg.model import UNMEASURED, KnownUnit, Measures
from foon_kg.model.json_fields import Fields
from foon_kg.model.tree import TreeUnit
from foon_kg.model.tree_json import unit_from_json, unit_to_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.measures import measured_words, with_measures
from foon_kg.store.snapshot import sightings_of

BREAD = """(defparameter *recipe* '((get-kitchen ?k)
 (fetch-and-proportion ?butter ?k1 ?k ?c1 butter 60 g)
 (fetch-and-proportion ?more ?k2 ?k1 ?c2 butter 5 g)
 (transfer-contents ?x ?r1 ?k3 ?k2 ?bowl ?butter ?q1 ?u1)
 (transfer-contents ?y ?r2 ?k4 ?k3 ?x ?more ?q2 ?u2)
 (bake ?bread ?k7 ?k6 ?y ?oven 60 minute 165 degrees-celsius)))"""
SUBGRAPH = read_muhai_text(BREAD, "bread").subgraph
RECORDED = [KnownUnit(unit, (seen,)) for unit, seen in sightings_of(SUBGRAPH)]
PLANNED = [TreeUnit.of(known.unit, "foon", ()) for known in RECORDED]


@pytest.mark.parametrize(
    ("measures", "motion", "words"),
    [
        (UNMEASURED, "bake", ""),
        (Measures(seconds=3600, celsius=165), "bake", " for 60 min at 165 °C"),
        (Measures(seconds=30), "leave", " for 30 s"),
        (Measures(seconds=7200 * 4), "refrigerate", " for 8 h"),
        (Measures(celsius=18), "cool", " to 18 °C"),
        (Measures(("200 g self rising flour",)), "pour", " (recorded: 200 g)"),
        (Measures(("3 piece egg",)), "crack", " (recorded: 3)"),
        (Measures(("3 piece egg", "60 g butter")), "mix", " (recorded: 3 egg, 60 g butter)"),
    ],
)
def test_measures_are_told_at_the_end_of_a_sentence(measures, motion, words):
    assert measured_words(measures, motion) == words


def test_a_step_is_told_with_its_measures():
    bake = RECORDED[-1].unit
    told = sentence(bake, Kitchen.default(), Measures(seconds=3600, celsius=165))
    assert told.endswith(" for 60 min at 165 °C.")
    assert sentence(bake, Kitchen.default()) == told.replace(" for 60 min at 165 °C", "")


def test_steps_are_told_what_the_recorded_ones_say_each_amount_once():
    told = [unit.measures for unit in with_measures(PLANNED, RECORDED, "bread")]
    assert told[:2] == [Measures(("60 g butter",)), Measures(("5 g butter",))]
    assert not any(one.amounts for one in told[2:]), "what is carried on was measured before"
    assert told[-2:] == [Measures(celsius=165), Measures(seconds=3600, celsius=165)]


OTHERS = (("motion", "boil"), ("inputs", ()))


def test_another_video_another_motion_and_other_things_say_nothing():
    assert with_measures(PLANNED, RECORDED, "cake") == tuple(PLANNED)
    step = PLANNED[-1].step
    boiled, elsewhere = (replace(PLANNED[-1], step=replace(step, **{field: value})) for field, value in OTHERS)
    assert [one.measures.seconds for one in with_measures([boiled, elsewhere], RECORDED, "bread")] == [None, None]


@given(st.permutations(PLANNED))
def test_only_measures_are_added_and_none_twice(planned):
    told = with_measures(planned, RECORDED, "bread")
    assert [replace(unit, measures=UNMEASURED) for unit in told] == list(planned)
    said = [text for unit in told for text in unit.measures.amounts]
    assert len(said) == len(set(said))


def test_a_planned_step_is_read_back_with_its_measures():
    step = replace(PLANNED[-1], measures=Measures(("2 piece egg",), 30.0, -18.0))
    assert unit_from_json(Fields(unit_to_json(step), "step")) == step
    assert "measures" not in unit_to_json(PLANNED[-1])
