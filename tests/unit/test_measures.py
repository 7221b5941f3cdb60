"""How much, how long and how hot: in words, and told of the steps that are made after a recorded dish."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.formats.exports.sentences import sentence
from foon_kg.loaders.muhai import read_muhai_text
from foon_kg.model import (
    UNMEASURED,
    AskedAmount,
    KnownUnit,
    Measures,
    ObjectNode,
    Recipe,
    RequiredIngredient,
    sightings_of,
)
from foon_kg.model.collected import CalledFor
from foon_kg.model.json_fields import Fields
from foon_kg.model.tree import Mention, Step
from foon_kg.model.tree_json import unit_from_json, unit_to_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.measures import amounts_asked, measured_words, with_asked, with_measures

BREAD = """(defparameter *recipe* '((get-kitchen ?k)
 (fetch-and-proportion ?butter ?k1 ?k ?c1 butter 60 g)
 (fetch-and-proportion ?more ?k2 ?k1 ?c2 butter 5 g)
 (transfer-contents ?x ?r1 ?k3 ?k2 ?bowl ?butter ?q1 ?u1)
 (transfer-contents ?y ?r2 ?k4 ?k3 ?x ?more ?q2 ?u2)
 (bake ?bread ?k7 ?k6 ?y ?oven 60 minute 165 degrees-celsius)))"""
SUBGRAPH = read_muhai_text(BREAD, "bread").subgraph
RECORDED = [KnownUnit(unit, (seen,)) for unit, seen in sightings_of(SUBGRAPH)]
CUP = AskedAmount("1 1/2 cups", "flour")
PLANNED = [Step.of_unit(known.unit, "foon", ()) for known in RECORDED]


@pytest.mark.parametrize(
    ("measures", "motion", "words"),
    [
        (UNMEASURED, "bake", ""),
        (Measures(seconds=3600, celsius=165), "bake", " for 60 min at 165 °C"),
        (Measures(seconds=30), "leave", " for 30 s"),
        (Measures(seconds=7200 * 4), "refrigerate", " for 8 h"),
        (Measures(celsius=18), "cool", " to 18 °C"),
        (Measures(("200 g self rising flour",)), "pour", " (recorded: 200 g self rising flour)"),
        (Measures(("3 piece egg",)), "crack", " (recorded: 3 egg)"),
        (Measures(("3 piece egg", "60 g butter")), "mix", " (recorded: 3 egg, 60 g butter)"),
        (Measures(seconds=30, asked=(CUP,)), "mix", " for 30 s (1 1/2 cups flour)"),
        (Measures(asked=(CUP, AskedAmount("3", "egg"))), "mix", " (1 1/2 cups flour, 3 egg)"),
        (Measures(("60 g butter",), asked=(CUP,)), "mix", " (1 1/2 cups flour; recorded: 60 g butter)"),
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
    boiled, elsewhere = (replace(PLANNED[-1], **{field: value}) for field, value in OTHERS)
    assert [one.measures.seconds for one in with_measures([boiled, elsewhere], RECORDED, "bread")] == [None, None]


@given(st.permutations(PLANNED))
def test_only_measures_are_added_and_none_twice(planned):
    told = with_measures(planned, RECORDED, "bread")
    assert [replace(unit, measures=UNMEASURED) for unit in told] == list(planned)
    said = [text for unit in told for text in unit.measures.amounts]
    assert len(said) == len(set(said))


def test_a_planned_step_is_read_back_with_its_measures():
    step = replace(PLANNED[-1], measures=Measures(("2 piece egg",), 30.0, -18.0, (CUP,)))
    assert unit_from_json(Fields(unit_to_json(step), "step")) == step
    assert "measures" not in unit_to_json(PLANNED[-1])


def poured(food: str, thing: int, motion: str = "pour") -> Step:
    """Return a step that pours a thing into a bowl."""
    bowl = Mention(ObjectNode("bowl"), 99)
    before, after = Mention(ObjectNode(food), thing), Mention(ObjectNode(food, ("poured",)), thing)
    return Step((before, bowl), motion, (after, bowl))


def asked(steps: list[Step], *foods: tuple[RequiredIngredient, int]) -> list[list[str]]:
    return [[one.amount for one in step.measures.asked] for step in with_asked(steps, foods)]


FLOUR = RequiredIngredient("flour", "powder", "200 g")


def test_what_was_asked_is_told_of_the_step_that_first_takes_it():
    steps = [poured("egg", 2), poured("flour", 1), poured("flour", 1, "sift")]
    assert asked(steps, (FLOUR, 1), (RequiredIngredient("egg", "whole"), 2)) == [[], ["200 g"], []]
    assert asked(steps, (FLOUR, 3)) == [[], [], []], "of what the tree does not take nothing is told"


def test_of_a_food_that_is_taken_twice_each_step_takes_a_part():
    assert asked([poured("flour", 1), poured("flour", 2)], (FLOUR, 2)) == [["part of 200 g"]] * 2
    twice = [(FLOUR, 1), (replace(FLOUR, state="sifted", amount="5 g"), 2)]
    assert asked([poured("flour", 1), poured("flour", 2)], *twice) == [["200 g"], ["5 g"]]


@pytest.mark.parametrize(
    ("quantity", "unit", "amount"),
    [
        ("3/2", "cups", "1 1/2 cups"),
        ("2-3", "cups", "2-3 cups"),
        ("1/2-3/2", "", "1/2-1 1/2"),
        ("4/2", "g", "2 g"),
        ("", "", ""),
        ("1/0", "g", "1/0 g"),
        ("", "pinch", "pinch"),
    ],
)
def test_a_loaded_recipe_asks_as_people_write_it(quantity, unit, amount):
    assert CalledFor("flour", "", "", quantity, unit).amount == amount


def test_what_is_asked_twice_is_told_together():
    recipe = Recipe("bread", (FLOUR, RequiredIngredient("egg", ""), replace(FLOUR, amount="5 g")))
    assert amounts_asked(recipe) == ["200 g and 5 g", ""]


def test_what_was_asked_goes_before_what_was_recorded():
    butter = next(place for place, one in enumerate(PLANNED) if any(n.label == "butter" for n in one.input_nodes))
    mine = replace(PLANNED[butter], measures=Measures(asked=(AskedAmount("1 stick", "butter"),)))
    told = with_measures([*PLANNED[:butter], mine, *PLANNED[butter + 1 :]], RECORDED, "bread")
    assert told[butter].measures.asked == mine.measures.asked
    assert not any(one.measures.amounts for one in told)
