"""One food on its own: what is done to it before it joins, in which order, what is read and what is assumed."""

from __future__ import annotations

import pytest
from integration.school import PLANNER, SNAPSHOT, life_of, planned
from integration.told import KITCHEN
from planner.judged import fatal

from foon_kg.food import Level, tables
from foon_kg.integration.preparing.preparation import owed
from foon_kg.integration.preparing.understanding import understood, wants_of
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError
from foon_kg.similarity import food_similarity

BOILED_WHOLE = "boil, drain, rinse, peel"
MOVES = {"pick-and-place", "pour", "sprinkle"}

PREPARED = [
    # --- shells ---
    ("egg", "boiled", f"{BOILED_WHOLE}, slice", ""),
    ("egg", "whole", f"{BOILED_WHOLE}, slice", ""),
    ("egg", "chopped", f"{BOILED_WHOLE}, chop", ""),
    ("shrimp", "boiled", BOILED_WHOLE, ""),
    # --- roots and other vegetables ---
    ("carrot", "grated", "peel, grate", ""),
    ("carrot", "diced", "peel, dice", ""),
    ("beet", "grated", "peel, grate", ""),
    ("potato", "boiled", "peel, chop, boil, drain", ""),
    ("potato", "diced", "peel, dice, boil, drain", ""),
    ("potato", "whole", "peel, chop, boil, drain", ""),
    ("sweet potato", "boiled", "peel, chop, boil, drain", ""),
    ("pumpkin", "diced", "peel, core, dice, boil, drain", ""),
    ("onion", "diced", "peel, dice", ""),
    ("onion", "whole", "peel, dice", ""),
    ("shallot", "diced", "peel, dice", ""),
    ("garlic", "minced", "peel, mince", ""),
    ("tomato", "diced", "dice", ""),
    ("mushroom", "sliced", "slice", ""),
    # --- fruit ---
    ("avocado", "whole", "pit, peel, chop", ""),
    ("avocado", "sliced", "pit, peel, slice", ""),
    ("mango", "sliced", "pit, peel, slice", ""),
    ("apple", "chopped", "core, chop", ""),
    ("pear", "chopped", "core, chop", ""),
    ("pear", "halved", "core, cut, chop", ""),
    ("tomato", "halved", "cut, chop", ""),
    ("radish", "halved", "cut", ""),
    ("strawberry", "berries", "core", ""),
    ("date", "whole", "pit, chop", ""),
    ("olive", "pitted", "pit", ""),
    # --- leaves and stalks ---
    ("leek", "sliced", "slice, rinse, boil, drain", ""),
    ("bok choy", "leaves", "chop", ""),
    ("artichoke", "whole", "", "canned"),
    # --- meat ---
    ("chicken", "whole", "boil, drain, slice", ""),
    ("banana", "sliced", "peel, slice", ""),
    ("lemon", "juiced", "cut, squeeze", "juice"),
    ("raspberry", "berries", "", ""),
    # --- from cans, boxes and bags ---
    ("bean", "canned", "drain", ""),
    ("chickpea", "canned", "drain", ""),
    ("chickpea", "drained", "drain", ""),
    ("chickpea", "rinsed", "drain, rinse", ""),
    ("mushroom", "cleaned", "rinse, chop", ""),
    ("rice", "boiled", "boil, drain", ""),
    ("pasta", "boiled", "boil, drain, rinse", ""),
    ("walnut", "chopped", "chop", ""),
    ("walnut", "whole", "", ""),
    # --- milk, fat, meat ---
    ("cheese", "grated", "grate", ""),
    ("cheddar", "shredded", "grate", ""),
    ("butter", "melted", "melt", ""),
    ("butter", "softened", "", ""),
    ("yogurt", "creamy", "", ""),
    ("chicken", "diced", "dice, boil, drain", ""),
    # --- crude words of recipes ---
    ("olive oil", "juice", "", "liquid"),
    ("milk", "juice", "", "liquid"),
    ("salt", "ground", "", "granulated"),
    ("sugar", "ground", "", "granulated"),
    ("cocoa", "ground", "", "powder"),
    ("black pepper", "ground", "", ""),
]


def treatments(life):
    """Return what is done to a food before it is mixed into the rest; where it is only brought does not count."""
    motions = [motion for motion, _ in life]
    assert motions[-1] == "mix"
    return ", ".join(motion for motion in motions[:-1] if motion not in MOVES)


@pytest.mark.parametrize(("food", "state", "motions", "read"), PREPARED)
def test_a_food_is_prepared_as_it_is_asked_and_as_it_needs(food, state, motions, read):
    result = planned(food, state)
    life = life_of(food, result)
    assert treatments(life) == motions
    states = [(one.required, one.equivalent) for one in result.substitutions if one.kind == "state"]
    assert states == ([(state, read)] if read else [])
    assert result.assumptions == ()
    taken = {s for unit in result.units for node in unit.input_nodes if node.label == food for s in node.states}
    assert read or state in taken or any(state in states for _, states in life)
    assert fatal(result, SNAPSHOT, KITCHEN) == []


@pytest.mark.parametrize(
    ("food", "state", "motions"),
    [
        ("carrot", "sliced", "peel, slice"),
        ("celery", "rib", "slice"),
        ("chicken", "fried", "fry, chop"),
        pytest.param("bacon", "fried", "fry", marks=pytest.mark.xfail(reason="boiled")),
        pytest.param("lemon", "squeezed", "cut, squeeze", marks=pytest.mark.xfail(reason="taken squeezed: no tree")),
    ],
)
def test_what_the_foon_shows_is_done_as_it_is_asked(food, state, motions):
    assert treatments(life_of(food, planned(food, state))) == motions


def test_a_potato_is_boiled_before_it_is_mashed():
    motions = [motion for motion, _ in life_of("potato", planned("potato", "mashed"))]
    assert motions.index("boil") < motions.index("mash")


def test_what_nobody_can_do_is_assumed_and_said():
    result = planned("feta", "crumbled")
    (assumed,) = result.assumptions
    assert (assumed.node.label, assumed.node.states) == ("feta", ("crumbled",))
    assert "no step of this FOON makes feta crumbled" in assumed.why
    assert [motion for motion, _ in life_of("feta", result)] == ["pick-and-place", "mix"]


def test_what_a_food_is_handled_like_is_told_with_its_confidence_and_the_next_best():
    result = planned("pear", "chopped")
    (told,) = (one for one in result.substitutions if one.object == "pear")
    assert told.equivalent == "apple"
    assert told.confidence == pytest.approx(food_similarity().matrix(["pear"], ["apple"])[0, 0], abs=1e-4)
    alone = [unit.motion for unit in result.units if unit.grounding == "motion"]
    assert alone == ["chop", "pour"], "nothing that is chopped is like a pear, and nothing is named"
    (grated,) = [one for one in planned("beet", "grated").substitutions if one.equivalent == "carrot"]
    assert grated.kind == "object"


@pytest.mark.parametrize(
    ("food", "state", "motion"),
    [
        ("milk", "liquid", "pour"), ("olive oil", "liquid", "pour"), ("salt", "granulated", "sprinkle"),
        ("sugar", "granulated", "sprinkle"), ("cherry tomato", "whole", "pick-and-place"), ("tomato", "diced", "pour"),
    ],
)  # fmt: skip
def test_a_food_is_brought_as_its_form_asks(food, state, motion):
    assert life_of(food, planned(food, state))[-2][0] == motion


def test_a_food_that_nobody_knows_is_taken_at_its_word():
    assert [motion for motion, _ in life_of("zeppelin", planned("zeppelin", "chopped"))] == ["chop", "pour", "mix"]


def test_tools_lie_in_the_tree_and_food_comes_out_of_what_it_is_sold_in():
    result = planned("carrot", "grated")
    assert {"peeler", "grater"} <= {node.label for node in result.kitchen}
    leaves = {(node.label, node.states, node.container) for node in result.kitchen}
    assert ("carrot", ("whole",), None) in leaves
    assert ("salt", ("granulated",), "shaker") in leaves


# --- how a required food is understood, before anything is done ---


def want(food, state=""):
    return understood(1, RequiredIngredient(food, state), tables(), PLANNER.teaching_for((), "").methods.operators)


@pytest.mark.parametrize(
    ("food", "state", "leaf", "make"),
    [
        ("egg", "", "whole", ""),
        ("egg", "boiled", "whole", "boiled"),
        ("egg", "beaten", "whole", "beaten"),
        ("potato", "diced", "whole", "diced"),
        ("onion", "whole", "whole", ""),
        ("olive oil", "liquid", "liquid", ""),
        ("olive oil", "juice", "liquid", ""),
        ("salt", "ground", "granulated", ""),
        ("butter", "melted", "stick", "melted"),
        ("chicken", "raw", "raw", ""),
        ("bean", "canned", "canned", ""),
        ("lemon", "juiced", "whole", "juiced"),
        ("lemon", "zested", "whole", "zest"),
        ("orange", "minced", "whole", "zest"),
        ("carrot", "grated", "whole", "grated"),
        ("pork chop", "beaten", "flattened", ""),
        ("steak", "pounded", "flattened", ""),
    ],
)
def test_a_state_is_as_it_is_sold_or_made_or_a_crude_word(food, state, leaf, make):
    found = want(food, state)
    assert (found.leaf, found.make) == ((leaf,), make)


@pytest.mark.parametrize(
    ("food", "state", "due"),
    [
        ("potato", "whole", {"cook", "cut", "peel"}),
        ("avocado", "whole", {"cut", "peel", "stone"}),
        ("egg", "whole", {"cook", "shell"}),
        ("salt", "granulated", set()),
        ("bean", "canned", set()),
        ("strawberry", "whole", {"core"}),
        ("raspberry", "berries", set()),
    ],
)
def test_a_cook_owes_to_a_food_what_the_table_says(food, state, due):
    assert owed(want(food, state), tables()) == due


def test_advice_is_not_owed_and_only_what_is_fatal_is_owed_in_a_hurry():
    potato = want("potato", "whole")
    assert potato.facts.owes["wash"] is Level.ADVICE
    assert owed(potato, tables(), Level.FATAL) == {"cook"}


def test_what_is_asked_twice_in_one_state_is_one_food_and_nameless_ones_are_none():
    pepper, chopped = RequiredIngredient("pepper", "ground"), RequiredIngredient("pepper", "chopped")
    asked = [pepper, RequiredIngredient("", "whole"), chopped, pepper]
    found = wants_of(asked, tables(), PLANNER.teaching_for((), "").methods.operators)
    assert [(one.number, one.label, one.asked) for one in found] == [(1, "pepper", "ground"), (2, "pepper", "chopped")]


def test_a_refusal_says_why():
    with pytest.raises(NoTreeError, match="this FOON has no cake"):
        PLANNER.plan(Recipe("cake", (RequiredIngredient("tomato", "diced"),)))
