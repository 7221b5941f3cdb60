"""Every required food is explained, and what is said is what the tree does."""

from __future__ import annotations

from dataclasses import replace

import pytest
from examples import examples
from hypothesis import given
from kitchen_stories import CHOP_ONION, subgraph
from planner.dishes import KITCHEN, SETTINGS, questions
from planner.test_demo_dishes import SNAPSHOT, every_recipe
from planner.test_overrides import SALAD
from rich.console import Console

from foon_kg.formats.views.explanation import explanation_view
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.explanation import Explanation, Joining, PassedOver
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import Substitute
from foon_kg.store.snapshot import Snapshot


def explain(asked, *substitutes):
    wishes = replace(SETTINGS, substitutes=tuple(Substitute(*pair) for pair in substitutes))
    result, explanations, _ = Planner(SNAPSHOT, wishes, SNAPSHOT.units).reasons(asked)
    return result, {one.want.object: one for one in explanations}


def printed(*explanations):
    console = Console(width=200, highlight=False)
    with console.capture() as capture:
        console.print(explanation_view(explanations))
    return "\n".join(line.rstrip() for line in capture.get().splitlines())


@every_recipe
def test_a_plan_is_the_same_explained_or_not(recipe):
    planner = Planner(SNAPSHOT, SETTINGS, SNAPSHOT.units)
    assert planner.reasons(recipe).result.to_json() == planner.plan(recipe).to_json()


@examples(20)
@given(questions())
def test_what_is_said_is_what_the_tree_does(question):
    subgraphs, asked = question
    try:
        result, explanations, _ = Planner(Snapshot.of(subgraphs, KITCHEN), SETTINGS).reasons(asked)
    except NoTreeError:
        return
    assert [one.want for one in explanations] == list(dict.fromkeys(asked.ingredients))
    equivalents = {(s.required, s.equivalent) for s in result.substitutions if s.kind == "object"}
    assumed = {node.label for node in (entry.node for entry in result.assumptions)}
    for one in explanations:
        assert one.how != "missing"
        assert 0 < one.confidence <= 1
        if one.how in {"played", "made"} and one.label != one.want.object:
            assert (one.want.object, one.label) in equivalents
        if one.how == "assumed":
            assert one.want.object in assumed
        if one.joins is not None and one.joins.step is not None:
            assert result.units[one.joins.step - 1].seen_in
        assert printed(one)


def test_a_food_of_the_reference_is_played_by_its_own_line():
    result, told = explain(SALAD)
    salt = told["salt"]
    assert (salt.how, salt.label, salt.confidence, salt.chosen) == ("played", "salt", 1.0, False)
    unit = result.units[salt.joins.step - 1]
    assert unit.motion == salt.joins.motion
    assert any("salt" in (node.label, *node.ingredients) for node in unit.input_nodes)


def test_a_food_that_foon_has_not_seen_names_what_it_is_made_like_and_what_was_passed_over():
    result, told = explain(SALAD)
    kohlrabi = told["kohlrabi"]
    assert (kohlrabi.label, kohlrabi.confidence) == ("carrot", 0.8)
    assert {unit.seen_in[0].video for unit in result.units} >= set(kohlrabi.videos)
    assert "potato" in {other.label for other in kohlrabi.passed_over}


def test_a_choice_is_said_to_be_one_and_others_are_passed_over_for_it():
    _, told = explain(SALAD, ("kohlrabi", "onion"))
    kohlrabi = told["kohlrabi"]
    assert (kohlrabi.label, kohlrabi.chosen, kohlrabi.confidence) == ("onion", True, 0.1)
    carrot = next(other for other in kohlrabi.passed_over if other.label == "carrot")
    assert (carrot.confidence, carrot.why) == (0.8, "you chose another")


@pytest.mark.parametrize(
    ("explanation", "words"),
    [
        (
            Explanation(
                RequiredIngredient("leek", "sliced"),
                "played",
                "onion",
                0.6,
                renamed=(("juice", "liquid"),),
                videos=("a",),
            ),
            "and is handled as FOON handles onion in a, 0.60 sure (“juice” is read as liquid)",
        ),
        (
            Explanation(RequiredIngredient("leek", "sliced"), "made", "leek", joins=Joining(4, "pour", "onion", 0.83)),
            "joins the others in step 4 (pour), where onion joins in the recorded dish (0.83 like it)",
        ),
        (
            Explanation(
                RequiredIngredient("leek", "whole"), "sold", joins=Joining(4, "add", "egg", 0.01, ("egg", "ham"))
            ),
            "joins the others in step 4 (add), in the place of egg, ham, which nobody asked for",
        ),
        (
            Explanation(
                RequiredIngredient("leek", "sliced"),
                "made",
                "leek",
                passed_over=(
                    PassedOver("onion", "diced", 0.41, "less sure"),
                    PassedOver("chive", "cut", 0.6, "takes more steps"),
                    PassedOver("ramp", "", 0.4, "less sure"),
                ),
            ),
            "not like diced onion (0.41), ramp (0.40): less sure\n    not like cut chive (0.60): takes more steps",
        ),
        (
            Explanation(RequiredIngredient("leek", "sliced"), "made", "bread", 0.02, chosen=True),
            "is made ready as FOON makes bread, 0.02 sure, as you chose",
        ),
        (Explanation(RequiredIngredient("leek", "burnt"), "assumed"), "is assumed to be there"),
        (Explanation(RequiredIngredient("leek", "whole"), "missing"), "does not get into this dish"),
    ],
)
def test_the_view_says_it_in_a_sentence(explanation, words):
    assert words in printed(explanation)


SALAD_FROM_A_BOWL = (
    "salad bowl(empty); shaker{salt}; salt(granulated)@shaker > pour > salad bowl{salt}; salt(granulated)@salad_bowl",
    "salad bowl{salt}; bowl{onion}; onion(chopped)@bowl > pour > salad bowl{onion,salt}; onion(chopped)@salad_bowl",
    "salad bowl{onion,salt}; onion(chopped)@salad_bowl; spoon > mix > salad(mixed){onion,salt}@salad_bowl",
)
"""The onion is in its bowl from the start, chopped by nobody."""


def test_a_food_that_plays_a_line_and_is_made_apart_names_the_video_in_which_it_is_made():
    videos = [subgraph("salads", "salad", *SALAD_FROM_A_BOWL), subgraph("chopping", "vegetables", *CHOP_ONION)]
    wanted = (RequiredIngredient("onion", "chopped"), RequiredIngredient("salt", "granulated"))
    planner = Planner(Snapshot.of(videos, KITCHEN), SETTINGS)
    result, (onion, _), _ = planner.reasons(Recipe("salad", wanted))
    assert "chop" in [unit.motion for unit in result.units]
    assert (onion.how, onion.videos) == ("played", ("chopping", "salads"))
    assert onion.passed_over == ()
