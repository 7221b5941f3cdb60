"""What ``foon suggest`` claims, against a search through everything that can be made."""

from __future__ import annotations

import random

import pytest
from demo_foon import demo_foon, demo_subgraphs
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import SALAD, node, subgraph
from planner.dishes import FRESH, KITCHEN, SOLD_IN, UNKNOWN, LikeByKind, foons

from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.planning.suggestion import suggest
from foon_kg.plans.stock import StockedKitchen
from foon_kg.search.gaps import mixtures
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.snapshot import Snapshot

SIMILARITY = LikeByKind()
SNAPSHOT = Snapshot.of([subgraph("salad", "salad", *SALAD)], KITCHEN)
FAIR = 0.5


def suggested(snapshot, *things, most=10):
    kitchen = StockedKitchen.of(KITCHEN, [node(thing) for thing in things])
    return suggest(snapshot, kitchen, most=most, similarity=SIMILARITY, time_limit=None)


def only(snapshot, *things):
    (one,) = suggested(snapshot, *things).found
    return one


def test_a_dish_of_which_all_is_there_takes_it_and_lacks_nothing():
    one = only(SNAPSHOT, "onion", "tomato", "salt")
    assert [taken.own for taken in one.taken] == ["onion", "salt", "tomato"]
    assert (one.missing, one.assumed, one.unused, one.share, one.exact) == ((), (), (), 1.0, True)
    assert one.goal.dish_type == "salad"
    assert one.units == len(SALAD)


def test_what_is_missing_and_what_is_left_over_is_said():
    one = only(SNAPSHOT, "onion", "egg", "tomato")
    assert (one.missing, one.unused, one.share) == (("salt",), ("egg",), 0.67)


def test_a_food_that_is_like_one_of_the_dish_stands_for_it_with_its_confidence():
    one = only(SNAPSHOT, "leek", "tomato", "salt")
    assert [(t.food, t.own, t.confidence) for t in one.taken if t.food != t.own] == [("onion", "leek", 0.8)]
    assert one.share == pytest.approx(0.93)


def test_a_food_that_is_there_in_another_state_only_has_to_be_ready():
    one = only(SNAPSHOT, "onion(fried)", "tomato", "salt")
    assert one.missing == ()
    assert {leaf.label for leaf in one.assumed} == {"onion"}


def test_a_utensil_that_nobody_has_is_missing_too():
    assert only(SNAPSHOT, "onion", "tomato", "salt", "bowl", "spoon", "knife").missing == ("cutting board",)


def test_foods_of_which_no_dish_takes_any_suggest_nothing():
    with pytest.raises(NoTreeError, match="no dish of this FOON takes any of dragon fruit") as refused:
        suggested(SNAPSHOT, "dragon fruit")
    assert refused.value.hint
    with pytest.raises(UsageError, match="no food is at hand"):
        suggested(SNAPSHOT, "bowl")


OWN = (*FRESH, *SOLD_IN, *UNKNOWN)
some = examples(30)


@pytest.mark.slow
@some
@given(foons(), st.lists(st.sampled_from(OWN), min_size=1, max_size=5, unique=True))
def test_nothing_is_missing_exactly_where_the_dish_can_be_made_of_these_foods(subgraphs, own):
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    mixed = mixtures(KITCHEN, snapshot.vocabulary())
    try:
        found = suggested(snapshot, *own).found
    except NoTreeError:
        return
    for one in found:
        assert (one.missing == ()) is can_be_made(snapshot, one.goal.node, set(own), mixed)
        assert {taken.own for taken in one.taken} | set(one.unused) == set(own)
        assert {taken.own for taken in one.taken}.isdisjoint(one.unused)
        assert all(taken.confidence >= FAIR for taken in one.taken)
        assert one.exact
    assert [one.rank for one in found] == sorted(one.rank for one in found)


def can_be_made(snapshot, goal, own, mixed):
    """Execute every unit whose inputs are there, again and again, from all that takes no other food than these."""
    nodes = {n for known in snapshot.units for n in (*known.unit.input_nodes, *known.unit.output_nodes)}
    have = {n for n in nodes if n != goal and all(is_there(name, own, mixed) for name in foods_of(n))}
    while True:
        made = {
            n for known in snapshot.units if have.issuperset(known.unit.input_nodes) for n in known.unit.output_nodes
        } - have
        if goal in made:
            return True
        if not made:
            return False
        have |= made


def foods_of(thing):
    names = (thing.label, *thing.ingredients)
    return [name for name in names if not KITCHEN.is_utensil(name) and not KITCHEN.is_free(name)]


def is_there(name, own, mixed):
    return name in own or (name not in mixed and SIMILARITY.matrix([name], sorted(own)).max() >= FAIR)


@pytest.mark.slow
@some
@given(foons(), st.lists(st.sampled_from(OWN), min_size=1, max_size=4, unique=True), st.integers(0, 99))
def test_a_shuffle_of_files_and_foods_changes_nothing(subgraphs, own, seed):
    def answer(found, foods):
        try:
            return suggested(Snapshot.of(found, KITCHEN), *foods)
        except NoTreeError as error:
            return error.message

    shuffle = random.Random(seed)
    assert answer(shuffle.sample(subgraphs, len(subgraphs)), shuffle.sample(own, len(own))) == answer(subgraphs, own)


DEMO = demo_subgraphs()


def test_a_dish_of_the_demo_is_suggested_first_to_who_has_all_of_its_foods():
    snapshot = demo_foon()
    goal = next(goal for goal in snapshot.goals("salad") if goal.node.label == "greek salad")
    kitchen = StockedKitchen.of(KITCHEN, [node(name) for name in goal.ingredients])
    first = suggest(snapshot, kitchen, most=3, time_limit=None).found[0]
    assert (first.goal, first.missing, first.unused) == (goal, (), ())


@pytest.mark.neo4j
def test_neo4j_and_memory_suggest_the_same(empty_graph):
    kitchen = StockedKitchen.of(KITCHEN, [node(name) for name in ("egg", "onion", "milk", "salt")])
    with Connection(empty_graph) as connection:
        load(connection, DEMO)
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        before = view.round_trips
        in_memory = suggest(demo_foon(), kitchen, most=3, time_limit=None)
        assert suggest(view, kitchen, most=3, time_limit=None) == in_memory
        assert view.round_trips == before + 5  # words, goals, their foods, what is behind the best, and its units
