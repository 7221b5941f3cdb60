"""Whatever is asked of the demo's FOON: a tree in which the judge finds nothing fatal, or a reason; always the same."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from demo_foon import demo_subgraphs
from examples import examples
from hypothesis import assume, event, example, given
from hypothesis import strategies as st
from integration.told import subgraphs
from planner.judged import fatal

import foon_kg
from foon_kg.food import singular, tables
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.planning.avoidance import names_avoided
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings, Substitute
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanFailure
from foon_kg.plans.shortage import ShortageError
from foon_kg.plans.stock import StockedKitchen
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()
DEMO = demo_subgraphs()
CLOSING = """
name: closing
stove (on; under pot) → TURN OFF → stove (off; under pot)
stove (on; under pan) → TURN OFF → stove (off; under pan)
"""
SUBGRAPHS = [*DEMO, *subgraphs(CLOSING)]
SNAPSHOT = Snapshot.of(SUBGRAPHS, KITCHEN)
SETTINGS = PlanSettings(KITCHEN, time_limit=None)
PLANNER = Planner(SNAPSHOT, SETTINGS, SNAPSHOT.units)
TYPES = ("salad", "soup", "omelette", "drinks", "")
STATES = (
    "whole", "chopped", "sliced", "diced", "grated", "minced", "peeled", "halved", "shredded", "mashed", "beaten",
    "raw", "boiled", "cooked", "baked", "toasted", "melted", "liquid", "juice", "creamy", "ground", "dried", "canned",
    "frozen",
)  # fmt: skip


@cache
def every_food():
    """Every food that the table lists, and nearer at hand those that the demo has."""
    table = tomllib.loads((Path(foon_kg.__file__).parent / "food" / "foods.toml").read_text(encoding="utf-8"))
    words = (word for row in table["kinds"].values() for word in row.get("words", ()))
    return sorted(word for word in words if not word.startswith("*"))


demo_foods = st.deferred(lambda: st.sampled_from(sorted(SNAPSHOT.methods().operators.foods)))


@st.composite
def wanted(draw):
    """A food in a state in which it is sold, in none, or in any."""
    food = draw(st.one_of(demo_foods, st.deferred(lambda: st.sampled_from(every_food()))))
    state = draw(st.one_of(st.sampled_from(("", tables().foods.food(food).sold_as)), st.sampled_from(STATES)))
    return RequiredIngredient(food, state)


def recipes(least=2, most=5):
    foods = st.lists(wanted(), min_size=least, max_size=most, unique_by=lambda one: singular(one.object))
    return st.builds(Recipe, st.sampled_from(TYPES), foods.map(tuple), st.just("asked"))


SURE = (
    Recipe("salad", (RequiredIngredient("kohlrabi", "grated"), RequiredIngredient("tomato", "diced"))),
    Recipe("salad", (RequiredIngredient("feta", "diced"), RequiredIngredient("leek", "sliced"))),
    Recipe("soup", (RequiredIngredient("parsnip", "diced"), RequiredIngredient("vegetable stock", "liquid"))),
    Recipe("drinks", (RequiredIngredient("mango", "sliced"), RequiredIngredient("milk", "liquid"))),
    Recipe("", (RequiredIngredient("egg", "beaten"), RequiredIngredient("chive", "chopped"))),
)
"""Recipes that surely have a tree, so that nothing is shown of failures alone."""

ICED = Recipe("drinks", tuple(RequiredIngredient(food, "") for food in ("bacon", "ice", "egg replacer")))
"""Ice is in a pot as water is, and no evidence of boiling water is of it (found by a campaign)."""

MASHED = Recipe("salad", (RequiredIngredient("apple", ""), RequiredIngredient("potato", "mashed")))
"""Nothing in the demo mashes: that is assumed, and a kitchen that has it has it ready (found by a campaign)."""

FRIED_IF_MASHED = replace(MASHED, ingredients=(MASHED.ingredients[0], RequiredIngredient("fish fillet", "mashed")))
"""What stands ready is cooked in another way, with what that kitchen lacks (found by a campaign)."""


def answer(recipe, planner=PLANNER):
    try:
        return planner.plan(recipe)
    except (NoTreeError, UsageError) as error:
        return PlanFailure.of(recipe, error)


def text(recipe, planner=PLANNER):
    return json.dumps(answer(recipe, planner).to_json(), ensure_ascii=False)


def tree(recipe, planner=PLANNER):
    """Return the tree of a recipe that has one."""
    result = answer(recipe, planner)
    assume(not isinstance(result, PlanFailure))
    return result


def nodes(result):
    return {node for unit in result.units for node in (*unit.input_nodes, *unit.output_nodes)}


some = examples(30)
few = examples(8)
any_recipe = st.one_of(recipes(), st.sampled_from(SURE))


WATER_BY_ANOTHER_NAME = Recipe(
    "soup", (RequiredIngredient("boiling water", ""), RequiredIngredient("capellini", "")), "asked"
)
"""Water whose evidence is that of water, and not its own."""


@pytest.mark.slow
@examples(60)
@given(recipes())
@example(WATER_BY_ANOTHER_NAME)
@example(ICED)
def test_the_answer_is_a_tree_without_a_fatal_finding_or_a_reason(recipe):
    result = answer(recipe)
    event("no tree" if isinstance(result, PlanFailure) else "tree")
    if isinstance(result, PlanFailure):
        assert result.code in {"no-goal", "no-way"}
        assert result.message
        assert result.hint
    else:
        assert fatal(result, SNAPSHOT) == []


def test_a_dish_of_one_food_is_called_as_a_dish():
    assert fatal(PLANNER.plan(Recipe("salad", (RequiredIngredient("celery", "sliced"),))), SNAPSHOT) == []


@pytest.mark.parametrize("recipe", SURE, ids=lambda recipe: recipe.dish_type or "any")
def test_what_surely_has_a_tree_has_one(recipe):
    result = PLANNER.plan(recipe)
    assert fatal(result, SNAPSHOT) == []
    assert result.units


def test_the_demo_makes_a_soup_by_itself():
    assert Planner(Snapshot.of(DEMO, KITCHEN), SETTINGS).plan(SURE[2]).units


@pytest.mark.slow
@some
@given(any_recipe)
def test_no_asked_food_is_lost(recipe):
    result = tree(recipe)
    assert {one.object for one in recipe.ingredients} <= set(result.goal.ingredients)
    assert [line.ingredient for line in result.progress_lines] == [one.object for one in recipe.ingredients]


@pytest.mark.slow
@some
@given(any_recipe)
def test_nothing_is_on_at_the_end_and_what_is_on_was_turned_on(recipe):
    result = tree(recipe)
    power = {}
    for unit in result.units:
        for node, *things in unit.outputs:
            row = tables().utensil(node.label)
            if row is not None and row.role == "appliance" and not row.always_on and {"on", "off"} & set(node.states):
                power[tuple(things) if row.power == "vessel" else things[0]] = "on" in node.states
    assert not any(power.values())
    turned = [unit.motion for unit in result.units if unit.motion in {"turn on", "turn off"}]
    assert turned.count("turn on") == turned.count("turn off")


@pytest.mark.slow
@some
@given(any_recipe)
def test_only_asked_and_free_foods_are_leaves_and_every_leaf_is_in_a_plain_state(recipe):
    result = tree(recipe)
    foods = [node for node in result.kitchen if tables().utensil(node.label) is None]
    told = {one.node.label for one in result.assumptions}  # the fat that a pan needs and nobody asked for
    assert {node.label for node in foods} <= {one.object for one in recipe.ingredients} | KITCHEN.free_foods | told
    assumed = {one.node for one in result.assumptions}
    assert all(not node.ingredients for node in foods if node not in assumed)


@pytest.mark.slow
@few
@given(any_recipe, st.randoms(use_true_random=False))
def test_the_order_of_videos_and_units_does_not_matter(recipe, chance: random.Random):
    shuffled = Snapshot.of(chance.sample(SUBGRAPHS, len(SUBGRAPHS)), KITCHEN)
    units = chance.sample(shuffled.units, len(shuffled.units))
    assert text(recipe, Planner(shuffled, SETTINGS, units)) == text(recipe)


@pytest.mark.slow
@few
@given(any_recipe, any_recipe)
def test_what_was_asked_before_does_not_matter(recipe, other):
    alone = Planner(SNAPSHOT, SETTINGS)
    among = Planner(SNAPSHOT, SETTINGS, SNAPSHOT.units)
    text(other, among)
    assert text(recipe, among) == text(recipe, alone)


ASK = """
import json
from planning.test_any_question import SURE, text
print(json.dumps([text(recipe) for recipe in SURE]))
"""


@pytest.mark.slow
def test_the_seed_of_hashes_does_not_matter():
    def told(seed):
        paths = os.pathsep.join([str(Path(__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])])
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": paths}
        done = subprocess.run([sys.executable, "-c", ASK], env=environment, capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    assert told("1") == told("2") == [text(recipe) for recipe in SURE]


TEA = Recipe("soup", (RequiredIngredient("tomato", ""), RequiredIngredient("black tea", "liquid")))


def full(result):
    """Return the vessels that a tree takes full or hot from the kitchen: what foods are sold in apart."""
    rows = [(node, tables().utensil(node.label)) for node in result.kitchen]
    vessels = [node for node, row in rows if row is not None and row.role != "storage"]
    return [node for node in vessels if node.ingredients or "hot" in node.states]


def test_no_vessel_of_the_kitchen_is_filled():
    assert full(PLANNER.plan(TEA)) == []


# --- wishes ---


@few
@given(any_recipe, st.sampled_from(("dairy product", "eggs", "nuts", "onions", "salt", "vegetables")))
def test_nothing_avoided_is_in_a_tree(recipe, avoided):
    result = tree(recipe, Planner(SNAPSHOT, replace(SETTINGS, avoided=(avoided,)), SNAPSHOT.units))
    assume(len(result.recipe.ingredients) > 1)
    assert not any(names_avoided(node, (avoided,)) for node in nodes(result))
    assert fatal(result, SNAPSHOT) == []


def test_even_the_free_water_is_avoided():
    asked = Recipe("salad", (RequiredIngredient("potato", "boiled"), RequiredIngredient("onion", "chopped")))
    assert "water" in {node.label for node in PLANNER.plan(asked).kitchen}
    found = answer(asked, Planner(SNAPSHOT, replace(SETTINGS, avoided=("water",)), SNAPSHOT.units))
    assert isinstance(found, PlanFailure) or not any(names_avoided(node, ("water",)) for node in nodes(found))


def test_an_avoided_food_is_left_out_of_the_recipe():
    planner = Planner(SNAPSHOT, replace(SETTINGS, avoided=("tomato",)), SNAPSHOT.units)
    result = planner.plan(Recipe("salad", (*SURE[0].ingredients, RequiredIngredient("onion", "chopped"))))
    assert [one.object for one in result.recipe.ingredients] == ["kohlrabi", "onion"]


def test_a_recipe_of_avoided_foods_alone_is_wrong_usage():
    planner = Planner(SNAPSHOT, replace(SETTINGS, avoided=("vegetable", "tomato", "kohlrabi")), SNAPSHOT.units)
    with pytest.raises(UsageError):
        planner.plan(SURE[0])


def substituted(food, like, recipe):
    chosen = replace(SETTINGS, substitutes=(Substitute(food, like),))
    return Planner(SNAPSHOT, chosen, SNAPSHOT.units).plan(recipe)


def test_a_chosen_substitute_is_what_the_evidence_comes_from():
    usual = {one.equivalent for one in PLANNER.plan(SURE[0]).substitutions if one.object == "kohlrabi"}
    assert "cucumber" not in usual
    result = substituted("kohlrabi", "cucumber", SURE[0])
    told = {one.equivalent: one for one in result.substitutions if one.object == "kohlrabi"}
    assert "cucumber" in told
    assert fatal(result, SNAPSHOT) == []


@few
@given(any_recipe, st.data())
def test_a_tree_with_any_chosen_substitute_is_as_sound(recipe, data):
    food = data.draw(st.sampled_from([one.object for one in recipe.ingredients]))
    try:
        result = substituted(food, data.draw(demo_foods), recipe)
    except NoTreeError:
        return
    assert fatal(result, SNAPSHOT) == []


# --- kitchens that a person named ---


def in_kitchen(things):
    kitchen = StockedKitchen.of(KITCHEN, things)
    return kitchen, Planner(SNAPSHOT, replace(SETTINGS, kitchen=kitchen), SNAPSHOT.units)


@few
@given(any_recipe)
@example(MASHED)
@example(FRIED_IF_MASHED)
def test_whoever_has_all_that_a_tree_takes_gets_that_tree(recipe):
    result = tree(recipe)
    assume(not full(result))
    kitchen, planner = in_kitchen(result.kitchen)
    found = planner.plan(recipe)
    assert fatal(found, SNAPSHOT, kitchen) == []
    if result.assumptions:  # what no unit makes stands ready in that kitchen, and what was done before is not done
        assert len(found.units) <= len(result.units)
    else:
        assert [unit.motion for unit in found.units] == [unit.motion for unit in result.units]


@few
@given(any_recipe, st.data())
def test_whoever_lacks_something_is_told_what_or_gets_a_tree_without_it(recipe, data):
    leaves = tree(recipe).kitchen
    gone = data.draw(st.sampled_from(sorted({node.label for node in leaves})))
    named = [node for node in leaves if node.label != gone]
    assume(named)
    kitchen, planner = in_kitchen(named)
    found = answer(recipe, planner)
    if isinstance(found, PlanFailure):
        assert found.code in {"missing", "no-way"}
        assert all(kitchen.lacks(node) for node in found.missing)
        return
    assert not any(kitchen.lacks(node) for node in found.kitchen)
    assert fatal(found, SNAPSHOT, kitchen) == []


def test_a_missing_food_and_a_missing_tool_are_named():
    leaves = PLANNER.plan(SURE[0]).kitchen
    for label in ("tomato", "knife"):
        _, planner = in_kitchen([node for node in leaves if node.label != label])
        with pytest.raises(ShortageError) as error:
            planner.plan(SURE[0])
        assert label in {node.label for node in error.value.missing}
