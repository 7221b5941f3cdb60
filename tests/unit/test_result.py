"""A plan result is what it is before and after it was JSON, and says where a document is not one."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model import FunctionalUnit, ObjectNode, Participant, Recipe, RequiredIngredient, Sighting
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.errors import NoTreeError, ReadError
from foon_kg.model.json_fields import Fields
from foon_kg.model.tree import Mention, Step
from foon_kg.model.tree_json import unit_from_json, unit_to_json
from foon_kg.plans.progress import ProgressLine, ProgressStep
from foon_kg.plans.result import PlanFailure, PlanResult, ReferenceSummary

words = st.text(st.characters(codec="utf-8", exclude_characters="\x00"), min_size=1, max_size=8)
confidences = st.floats(0, 1)
seconds = st.none() | st.floats(0, 1e5)
nodes = st.builds(
    ObjectNode, words, st.tuples(words) | st.just(()), st.lists(words, max_size=3).map(tuple), st.none() | words
)
sightings = st.builds(Sighting, words, st.integers(0, 99), st.none() | words, seconds, seconds)
numbers = st.none() | st.integers(0, 9)
sides = st.lists(st.builds(Mention, nodes, numbers, numbers), max_size=3).map(tuple)
units = st.builds(
    Step,
    sides,
    words,
    sides,
    st.sampled_from(["foon", "adapted"]),
    st.lists(sightings, max_size=2).map(tuple),
)
recipes = st.builds(
    Recipe,
    words,
    st.lists(st.builds(RequiredIngredient, words, words), max_size=3).map(tuple),
    st.none() | words,
    st.none() | words,
)
substitutions = st.builds(
    Substitution,
    st.sampled_from(["object", "state", "motion"]),
    words,
    words,
    words,
    confidences,
    st.lists(st.builds(Alternative, words, confidences), max_size=2).map(tuple),
)
steps = st.builds(ProgressStep, st.lists(words, max_size=2).map(tuple), st.none() | words, st.none() | words, words)
lines = st.builds(ProgressLine, words, st.lists(steps, max_size=3).map(tuple), st.none() | words)
results = st.builds(
    PlanResult,
    recipes,
    st.builds(ReferenceSummary, nodes, st.integers(0, 99), st.integers(0, 9), st.booleans()),
    nodes,
    st.lists(units, max_size=4).map(tuple),
    st.lists(nodes, max_size=4).map(tuple),
    st.lists(substitutions, max_size=2).map(tuple),
    st.lists(st.builds(Assumption, nodes, words), max_size=2).map(tuple),
    st.lists(lines, max_size=2).map(tuple),
)

onion = ObjectNode("onion", ("whole",))
chopped = ObjectNode("onion", ("chopped",))
board = ObjectNode("cutting board")
salad = ObjectNode("salad", ("mixed",), ("onion",), "in", "bowl")


def small_result() -> PlanResult:
    chop = FunctionalUnit((Participant(onion, moving=True), Participant(board)), "chop", (Participant(chopped),))
    toss = FunctionalUnit((Participant(chopped, moving=True),), "toss", (Participant(salad),), accepts_any=True)
    return PlanResult(
        recipe=Recipe("salad", (RequiredIngredient("onion", "chopped"),), title="A salad"),
        reference=ReferenceSummary(salad, 2, 1, exact=True),
        goal=salad,
        units=(
            Step.of_unit(chop, "foon", (Sighting("0001-a", 3, "https://example.org/a", 1.0, 2.0),)),
            Step.of_unit(toss, "foon", (Sighting("0002-b", 0),)),
        ),
        kitchen=(board, onion),
    )


@pytest.mark.slow
@given(results)
def test_what_was_written_as_json_is_read_back_the_same(result):
    value = json.loads(json.dumps(result.to_json()))
    back = PlanResult.from_json(value)
    assert back == result
    assert back.to_json() == value  # a sighting's times take no part in equality


@given(recipes, words, words, st.text())
def test_a_failure_is_read_back_the_same(recipe, code, message, hint):
    failure = PlanFailure(recipe, code, message, hint)
    assert PlanFailure.from_json(json.loads(json.dumps(failure.to_json()))) == failure


def test_the_json_has_exactly_the_agreed_fields():
    value = small_result().to_json()
    assert list(value) == [
        "recipe", "reference", "goal", "units", "kitchen", "substitutions", "assumptions", "progress_lines",
        "passed_over",
    ]  # fmt: skip
    assert value["goal"] == {
        "label": "salad",
        "states": ["mixed"],
        "ingredients": ["onion"],
        "relation": "in",
        "container": "bowl",
    }
    assert list(value["units"][0]) == ["input_nodes", "motion_node", "output_nodes", "origin", "seen_in"]
    assert value["units"][0]["seen_in"] == [
        {"video": "0001-a", "unit": 3, "source": "https://example.org/a", "start": 1.0, "end": 2.0}
    ]


def test_a_failure_has_no_units_and_keeps_what_the_error_said():
    recipe = Recipe("sushi", ())
    failure = PlanFailure.of(recipe, NoTreeError("no goal of type sushi", hint="Ask for salad.", code="no-goal"))
    assert failure.to_json() == {
        "recipe": {"id": None, "title": None, "dish_type": "sushi", "ingredients": []},
        "error": {"code": "no-goal", "message": "no goal of type sushi", "hint": "Ask for salad."},
    }


def test_the_goal_is_marked_where_it_is_made_though_a_stove_is_turned_off_after_it():
    plan = small_result()
    off = Step.of((ObjectNode("stove", ("on",)),), "turn off", (ObjectNode("stove", ("off",)),), "foon", ())
    units = [note.unit for note in replace(plan, units=(*plan.units, off)).to_subgraph().annotations]
    assert [p.dish_type for unit in units for p in unit.outputs] == [None, "salad", None]


def test_things_keep_their_numbers_and_steps_their_phase_and_grounding():
    taken, made = (Mention(chopped, 1, 2), Mention(board, 3)), (Mention(salad, 4),)
    unit = Step(taken, "toss", made, "adapted", (Sighting("0002-b", 0),), "like", "finish")
    value = unit_to_json(unit)
    assert [node.get("thing") for node in value["input_nodes"]] == [1, 3]
    assert [node.get("container_thing") for node in value["input_nodes"]] == [2, None]
    assert (value["phase"], value["grounding"]) == ("finish", "like")
    assert unit_from_json(Fields(json.loads(json.dumps(value)), "unit")) == unit
    assert [one.identity for one in unit.inputs] == [1, 3]


def test_the_subgraph_of_a_plan_keeps_stars_and_flags_and_marks_only_the_goal():
    subgraph = small_result().to_subgraph()
    chop, toss = (annotation.unit for annotation in subgraph.annotations)
    assert [p.moving for p in chop.inputs] == [True, False]
    assert toss.accepts_any
    assert [p.dish_type for p in (*chop.outputs, *toss.outputs)] == [None, "salad"]
    assert (subgraph.name, subgraph.sources) == ("A salad", ("https://example.org/a",))


@pytest.mark.parametrize(
    ("spoil", "place"),
    [
        (lambda v: v.pop("goal"), "“goal” is missing"),
        (lambda v: v["units"][1].update(origin="dreamt"), "units[1]: “origin” should be one of foon"),
        (lambda v: v["units"][0]["seen_in"][0].update(unit=True), "seen_in[0]: “unit” should be a whole number"),
        (lambda v: v["kitchen"][0].update(states=["raw", 3]), "kitchen[0]: “states[1]” should be text, found 3"),
        (lambda v: v["reference"].update(exact="yes"), "reference: “exact” should be true or false"),
        (lambda v: v.update(units={}), "“units” should be a list"),
    ],
)
def test_a_document_that_is_no_plan_is_refused_with_its_place(spoil, place):
    value = small_result().to_json()
    spoil(value)
    with pytest.raises(ReadError) as caught:
        PlanResult.from_json(value, "plan.json")
    assert "plan.json" in caught.value.message
    assert place in caught.value.message
    assert caught.value.hint
