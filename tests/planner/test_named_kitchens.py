"""Planning from what a person named as at hand: no tree takes anything else, and where there is none it is said why."""

from __future__ import annotations

from dataclasses import replace

import pytest
from demo_foon import demo_foon, demo_subgraphs
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import SALAD, node, subgraph
from planner.dishes import KITCHEN, SETTINGS, questions
from planner.judged import fatal

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError
from foon_kg.planning import planner
from foon_kg.planning.candidates import reference_question
from foon_kg.planning.planner import Planner, plan
from foon_kg.planning.references import References
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.result import PlanFailure
from foon_kg.plans.shortage import ShortageError, nearest_first, remedies, remedy
from foon_kg.plans.stock import StockedKitchen
from foon_kg.search import enumerate_paths, retrieve, with_gaps_of
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.snapshot import Snapshot

SNAPSHOT = Snapshot.of([subgraph("salad", "salad", *SALAD)], KITCHEN)
WANTED = Recipe(
    "salad",
    (RequiredIngredient("onion", "chopped"), RequiredIngredient("tomato", "diced"), RequiredIngredient("salt", "")),
    "asked",
)
FOODS = ("onion", "tomato", "salt")
UTENSILS = ("cutting board", "knife", "bowl", "spoon")


def planned(*things, snapshot=SNAPSHOT, recipe=WANTED):
    kitchen = StockedKitchen.of(KITCHEN, [node(thing) if isinstance(thing, str) else thing for thing in things])
    return plan(snapshot, recipe, replace(SETTINGS, kitchen=kitchen))


def refused(*things, **question):
    with pytest.raises(ShortageError) as error:
        planned(*things, **question)
    return error.value


def motions(result):
    return [unit.motion for unit in result.units]


def test_naming_all_that_a_dish_takes_changes_nothing():
    assert planned(*FOODS, *UTENSILS).to_json() == plan(SNAPSHOT, WANTED, SETTINGS).to_json()


def test_what_is_at_hand_chopped_is_not_chopped_again():
    result = planned("onion(chopped)", "tomato", "salt")
    assert "chop" in motions(planned("onion", "tomato", "salt"))
    assert "chop" not in motions(result)
    assert node("onion(chopped)") in result.kitchen
    assert result.assumptions == ()


def test_what_is_at_hand_whole_as_well_as_chopped_is_taken_chopped():
    assert "chop" not in motions(planned("onion", "onion(chopped)", "tomato", "salt"))


def leaves(result):
    return set(map(str, result.kitchen))


def test_what_lies_on_a_board_is_taken_from_that_board():
    result = planned(node("onion(chopped)@on cutting_board"), "tomato", "salt")
    assert "chop" not in motions(result)
    assert {"onion (chopped; on cutting board)", "cutting board ({onion})"} <= leaves(result)


def test_what_stands_in_a_vessel_is_taken_out_of_it_before_it_is_cut():
    result = planned("onion", node("tomato@bowl"), "salt")
    assert "bowl ({tomato})" in leaves(result)
    assert not any(leaf.label == "tomato" and leaf.container is None for leaf in result.kitchen)


@pytest.mark.parametrize("pot", ["bowl{egg}", "bowl(dirty)", "bowl(hot)"])
def test_a_vessel_that_holds_something_or_is_used_is_no_empty_one(pot):
    error = refused(*FOODS, "cutting board", "knife", "spoon", pot)
    assert [thing.label for thing in error.missing] == ["bowl"]
    assert f"there is {node(pot)}" in error.message


def test_what_is_together_with_others_is_not_taken_by_itself():
    together = (node("onion(chopped)@pot"), node("tomato(diced)@pot"), "salt")
    error = refused(*together, *UTENSILS, "pot{onion,tomato}")
    assert {thing.label for thing in error.missing} == {"onion", "tomato"}
    assert "there is onion (chopped; in pot)" in error.message


def test_what_is_named_in_a_vessel_fills_it_though_nobody_named_that():
    error = refused(*FOODS, node("egg@bowl"), "cutting board", "knife", "spoon")
    assert [thing.label for thing in error.missing] == ["bowl"]


def numbered(**numbers):
    names = {name.replace("_", " "): number for name, number in numbers.items()}
    return StockedKitchen.of(KITCHEN, [node(thing) for thing in (*FOODS, *UTENSILS)], names)


def test_a_plan_tells_how_many_of_a_thing_are_found_so():
    result = plan(SNAPSHOT, WANTED, SETTINGS)
    things = {entry["label"]: entry["things"] for entry in result.to_json()["kitchen"] if entry["label"] != "salt"}
    first = {one.thing: one.node.label for unit in reversed(result.units) for one in unit.inputs}
    assert len(things["cutting board"]) == 2
    assert all(first[number] == label for label, numbers in things.items() for number in numbers)


def test_of_what_is_numbered_there_are_no_more():
    kitchen = numbered(cutting_board=1)
    with pytest.raises(ShortageError) as error:
        plan(SNAPSHOT, WANTED, replace(SETTINGS, kitchen=kitchen))
    assert [thing.label for thing in error.value.missing] == ["cutting board"]
    assert "a cutting board (2 are needed, 1 there)" in error.value.message
    enough = plan(SNAPSHOT, WANTED, replace(SETTINGS, kitchen=numbered(cutting_board=2, bowl=1)))
    assert enough == plan(SNAPSHOT, WANTED, SETTINGS)


def test_an_appliance_that_is_on_is_none_that_is_off():
    kitchen = StockedKitchen.of(KITCHEN, [node("pot(empty)@stove"), node("stove(on)")])
    assert kitchen.lacks(node("stove(off)"))
    assert kitchen.lacks(node("stove"))
    assert not kitchen.lacks(node("stove(on)"))
    assert not kitchen.lacks(node("pot(empty)"))


def test_a_missing_food_is_named_with_what_to_do_and_nothing_is_assumed():
    error = refused("onion", "salt")
    assert {thing.label for thing in error.missing} == {"tomato"}
    assert (error.code, error.exit_code) == ("missing", 3)
    assert "tomato" in error.message
    assert error.hint.startswith("Buy tomato")


def test_a_food_at_hand_that_is_like_the_missing_one_is_proposed():
    assert "or ask for leek instead (0.80 like it)" in refused("leek", "tomato", "salt").hint
    assert "instead" not in refused("egg", "tomato", "salt").hint


def test_missing_utensils_are_named_nearest_to_the_dish_first():
    error = refused("bowl")
    assert [thing.label for thing in error.missing] == ["spoon", "cutting board", "knife"]
    assert error.message == "the kitchen lacks a spoon, a cutting board and a knife for salad"
    assert error.hint.startswith("Get a spoon, a cutting board and a knife.")


def test_what_is_missing_is_a_list_for_programs():
    failure = PlanFailure.of(WANTED, refused("onion", "salt"))
    (entry,) = failure.to_json()["error"]["missing"]
    assert (entry["node"]["label"], entry["remedy"]) == ("tomato", "buy tomato")
    assert PlanFailure.from_json(failure.to_json()) == failure


def test_a_failure_for_another_reason_lists_nothing():
    with pytest.raises(NoTreeError) as error:
        plan(SNAPSHOT, replace(WANTED, dish_type="pie"), SETTINGS)
    assert "missing" not in PlanFailure.of(WANTED, error.value).to_json()["error"]


def test_another_dish_is_made_where_the_likeliest_takes_a_utensil_that_is_not_there():
    plate = [line.replace("bowl", "plate") for line in SALAD]
    both = Snapshot.of([subgraph("salad", "salad", *SALAD), subgraph("on a plate", "salad", *plate)], KITCHEN)
    for vessel in ("bowl", "plate"):
        result = planned("cutting board", "knife", "spoon", vessel, snapshot=both)
        assert result.goal.container == vessel


LEEK = [line.replace("bowl", "plate").replace("onion", "leek") for line in SALAD]
UNLIKELIER = Snapshot.of([subgraph("salad", "salad", *SALAD), subgraph("on a plate", "salad", *LEEK)], KITCHEN)


def test_of_dishes_that_lack_a_utensil_so_many_are_tried(monkeypatch):
    at_hand = (*FOODS, "cutting board", "knife", "spoon", "plate")
    assert planned(*at_hand, snapshot=UNLIKELIER).goal.container == "plate"
    monkeypatch.setattr(planner, "MOST_TRIES", 1)
    assert [thing.label for thing in refused(*at_hand, snapshot=UNLIKELIER).missing] == ["bowl"]


def test_of_dishes_that_all_lack_something_the_one_that_lacks_least_is_told():
    at_hand = ("onion", "salt", "cutting board", "knife", "spoon", "plate")
    assert {thing.label for thing in refused(*at_hand, snapshot=UNLIKELIER).missing} == {"tomato"}


def test_what_is_missing_is_told_before_any_search_and_of_all_that_are_tried_one_dish_is_searched(monkeypatch):
    searched = []
    problem = References.problem
    monkeypatch.setattr(References, "problem", lambda *asked: searched.append(asked[1].node.label) or problem(*asked))
    refused(*FOODS, "bowl", "spoon", snapshot=UNLIKELIER)
    assert searched == []
    result = planned(*FOODS, "cutting board", "knife", "spoon", "plate", snapshot=UNLIKELIER)
    assert searched == [result.reference.goal.label]
    assert (result.reference.units, result.reference.exact) == (len(LEEK), True)


@pytest.mark.parametrize(
    ("leaf", "what"),
    [
        ("tomato(whole)", "buy tomato"),
        ("onion(chopped)", "have onion ready: chopped"),
        ("egg mixture(beaten){egg,milk}", "buy or make egg mixture"),
        ("shaker{salt}", "buy salt (shaker)"),
        ("bowl(empty)", "get a bowl"),
    ],
)
def test_every_missing_leaf_has_a_remedy(leaf, what):
    assert remedy(node(leaf)) == what


def test_what_comes_in_its_storage_is_bought_once():
    sold = [node(leaf) for leaf in ("shaker{salt}", "salt(granulated)@in shaker", "onion(whole)", "salt(granulated)")]
    assert remedies(sold[:3]) == "Buy salt (shaker) and onion"
    assert remedies(sold) == "Buy salt (shaker), onion and salt"


def test_the_nearest_leaf_is_the_one_with_the_fewest_units_between():
    a, b, c, goal = map(node, ("a", "b", "c", "salad"))
    units = [((a,), (node("x"),)), ((node("x"), b), (node("y"),)), ((node("y"), c), (goal,))]
    assert nearest_first([a, b, c], units, goal) == (c, b, a)


some_questions = examples(30)


@pytest.mark.slow
@some_questions
@given(questions(), st.data())
def test_a_tree_takes_only_what_was_named_and_the_judge_agrees(question, data):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    try:
        leaves = plan(snapshot, recipe, SETTINGS).kitchen
    except NoTreeError:
        return
    named = data.draw(st.lists(st.sampled_from(leaves), min_size=1, unique=True))
    kitchen = StockedKitchen.of(KITCHEN, named)
    missing, result = (), None
    try:
        result = planned(*named, snapshot=snapshot, recipe=recipe)
    except ShortageError as error:
        missing = error.missing
    except NoTreeError:
        return
    if result is None:
        assert missing
        assert all(kitchen.lacks(leaf) for leaf in missing)
        return
    assert not any(kitchen.lacks(leaf) for leaf in result.kitchen)
    assert fatal(result, snapshot, kitchen) == []


@pytest.mark.slow
@some_questions
@given(questions(), st.randoms(use_true_random=False))
def test_the_order_in_which_things_are_named_does_not_matter(question, random):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    things = [want.object for want in recipe.ingredients] + ["bowl", "pot", "frying pan", "knife", "cutting board"]

    def answer(named):
        try:
            return planned(*named, snapshot=snapshot, recipe=recipe).to_json()
        except NoTreeError as error:
            return PlanFailure.of(recipe, error).to_json()

    shuffled = random.sample(things, len(things))
    assert answer(things) == answer(shuffled)


DEMO = demo_subgraphs()
ASKED = [
    Recipe("salad", (RequiredIngredient("onion", "chopped"), RequiredIngredient("tomato", "chopped"))),
    Recipe("", (RequiredIngredient("egg", "beaten"), RequiredIngredient("onion", "chopped"))),
]


@pytest.mark.neo4j
def test_neo4j_and_memory_plan_and_enumerate_the_same_in_a_named_kitchen(empty_graph):
    snapshot = demo_foon()
    things = ("onion", "tomato", "egg", "knife", "cutting board", "salad bowl", "bowl", "spoon", "whisk")
    own = replace(PlanSettings(), kitchen=StockedKitchen.of(KITCHEN, [node(thing) for thing in things]))

    def answers(view):
        planning = Planner(view, own)
        for recipe in ASKED:
            try:
                yield planning.plan(recipe).to_json()
                goal, problem = reference_question(planning, recipe)
                found = enumerate_paths(with_gaps_of(problem, retrieve(problem)), limit=20)
                yield goal, found.trees, found.complete
            except NoTreeError as error:
                yield PlanFailure.of(recipe, error).to_json()

    with Connection(empty_graph) as connection:
        load(connection, DEMO)
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        assert list(answers(view)) == list(answers(snapshot))
