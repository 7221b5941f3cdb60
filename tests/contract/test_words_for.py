"""What matters to one recipe, found without reading all words and goals: it is enough to plan as from all of them."""

from __future__ import annotations

import json

import pytest
from contract.test_equivalents import garden
from examples import examples
from foons import LABELS, STATES, foons
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import subgraph, unit
from planner.dishes import KITCHEN, questions

from foon_kg.food import singular
from foon_kg.model import Annotation, Subgraph
from foon_kg.model.errors import NoTreeError
from foon_kg.model.names import canonical
from foon_kg.planning.planner import Planner
from foon_kg.planning.recipes import IngredientWords, recipe_of
from foon_kg.planning.settings import PlanSettings
from foon_kg.planning.several_asked import names_in
from foon_kg.plans.result import PlanFailure
from foon_kg.similarity import food_similarity
from foon_kg.store.graph import Connection, Neo4jGraph, load, remove, words_for
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.snapshot import Snapshot

SETTINGS = PlanSettings(KITCHEN, time_limit=None)
ASKED = sorted({*LABELS, "shallot", "egg", "coconut milk", "onion ring", "qwxyz"} - {"bowl", "knife"})
some = examples(8)

pytestmark = pytest.mark.neo4j


@pytest.fixture
def keep(empty_graph):
    """Keep subgraphs, and no others, and answer what opens a view that has read nothing."""
    with Connection(empty_graph) as connection:
        there = []

        def keep(subgraphs):
            if there:
                remove(connection, there)
            there[:] = sorted({one.name for one in subgraphs})
            load(connection, subgraphs)
            return Neo4jGraph(empty_graph)

        yield keep


@pytest.fixture
def few_at_a_time(monkeypatch):
    """Ask for so few points that most of a small FOON is left out at first."""
    monkeypatch.setattr(words_for, "FIRST", 2)
    monkeypatch.setattr(words_for, "MORE", 2)
    monkeypatch.setattr(words_for, "MOST", 64)


def answer(planner, recipe):
    try:
        return json.dumps(planner.plan(recipe).to_json())
    except NoTreeError as error:
        return json.dumps(PlanFailure.of(recipe, error).to_json())


@some
@given(questions())
def test_a_plan_from_what_matters_is_the_plan_from_the_whole_foon(few_at_a_time, keep, question):
    subgraphs, recipe = question
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    with keep(subgraphs) as graph, graph.reading() as view:
        assert answer(Planner(view, SETTINGS), recipe) == answer(Planner(snapshot, SETTINGS, snapshot.units), recipe)


@some
@given(foons(), st.lists(st.sampled_from(ASKED), min_size=1, max_size=4))
def test_all_that_matters_to_the_asked_foods_is_there_with_all_that_is_known_of_it(
    few_at_a_time, keep, subgraphs, foods
):
    whole = Snapshot.of(subgraphs, KITCHEN).vocabulary()
    with keep(subgraphs) as graph, graph.reading() as view:
        part = view.words_for(foods, called=["Onions"])
    assert (part.motions, part.dish_types) == (whole.motions, whole.dish_types)
    assert {row.state for row in part.foods} | set(part.other_states) == {row.state for row in whole.foods}
    assert part.rows_of.items() <= whole.rows_of.items()
    assert matters(foods, whole) | {label for label in whole.labels if canonical(label) == "onion"} <= set(part.labels)


def matters(foods, vocabulary):
    """Return the labels that matter, by comparing every food with every label."""
    found = set()
    for food in foods:
        near = food_similarity().nearest(food, vocabulary.labels, limit=len(vocabulary.labels))
        fair = {other.name for other in near if other.confidence >= 0.5}
        others = [other.name for other in near if other.name != food]
        found |= fair | set(others[:4] if fair - {food} else ())
        spoken = set(singular(food).split())
        found |= {label for label in vocabulary.labels if spoken < set(singular(label).split())}
    return found


def test_the_words_of_the_units_behind_a_goal_are_added(keep):
    made = subgraph("one", "salad", "onion(whole) > chop > onion(chopped)", "onion(chopped) > mix > salad{onion}")
    whole = Snapshot.of([made], KITCHEN).vocabulary()
    with keep([made]) as graph, graph.reading() as view:
        units = view.behind([goal.node for goal in view.goals("salad")])
        part = view.words_in(units, view.words_for(["qwxyz"]))
        assert part.rows_of == {label: whole.rows_of[label] for label in ("onion", "salad")}


@pytest.mark.parametrize("texts", [["finely chopped red onions"], ["onion, whole"], ["Olive Oil", "egg yolk raw"]])
def test_ingredients_are_read_with_a_part_of_the_words_as_with_all(keep, texts):
    foods = ["onion", "red onion", "olive oil", "egg", "egg yolk", "tomato"]
    states = [f"{food}({state})" for food in foods for state in STATES[:3]]
    grown = Subgraph("garden", (Annotation(unit(f"bowl > grow > {'; '.join(states)}")),))
    snapshot = Snapshot.of([grown], KITCHEN)
    with keep([grown]) as graph, graph.reading() as view:
        part = IngredientWords(view.words_for((), names_in(texts)), KITCHEN)
        whole = IngredientWords(snapshot.vocabulary(), KITCHEN)
        assert recipe_of("salad", texts, part) == recipe_of("salad", texts, whole)


def test_a_food_of_which_nothing_is_known_has_no_point_and_is_known_all_the_same(keep, connection):
    foods = ["onion", *(f"{a}{b}orbl" for a in "bdfghjklmnprstvz" for b in "bdfghjkl")]
    with keep([garden(foods)]) as graph, graph.reading() as view:
        placed = ask_freely(connection, "MATCH (i:Ingredient) WHERE i.vector IS NOT NULL RETURN collect(i.name)")
        assert placed.rows == ((["onion"],),)
        assert {"onion", "bborbl"} == set(view.words_for(["bborbl"]).labels)
        (nearest,) = view.equivalents(["bborbl"], limit=2)
        assert nearest[0].name == "bborbl"


def test_with_points_of_other_word_lists_all_words_and_goals_are_read(keep, connection):
    made = subgraph("one", "salad", "onion(whole) > mix > salad{onion}")
    snapshot = Snapshot.of([made], KITCHEN)
    graph = keep([made])
    ask_freely(connection, "MATCH (f:Foon) SET f.words = 'others'", write=True)
    with graph, graph.reading() as view:
        assert view.words_for(["shallot"]) == snapshot.vocabulary()
        assert view.words_in(snapshot.units, view.words_for(["shallot"])) == snapshot.vocabulary()
        assert view.likely_goals("salad", ["shallot"], 1) == snapshot.likely_goals("salad", ["shallot"], 1)
