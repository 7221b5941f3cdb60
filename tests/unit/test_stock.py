"""A kitchen that a person named: what it has for a search, and which leaves of a tree it lacks."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import node

from foon_kg.plans.kitchen import Kitchen, LeafFault
from foon_kg.plans.stock import ALWAYS_THERE, StockedKitchen

EVERYBODY = Kitchen.default()


def kitchen(*things):
    return StockedKitchen.of(EVERYBODY, [node(thing) for thing in things])


@pytest.mark.parametrize(
    ("named", "leaf", "lacking"),
    [
        ("knife", "bowl(empty)", True),
        ("knife", "knife(clean)", False),
        ("knife", "onion(whole)", False),  # of foods nothing is said
        ("onion", "bowl(empty)", False),  # of utensils nothing is said
        ("onion", "tomato(whole)", True),
        ("onion", "onion(whole)@on cutting_board", False),
        ("onion", "onion(chopped)", True),
        ("onion(chopped)", "onion(chopped)", False),
        ("onion(chopped)", "onion(chopped,raw)", False),
        ("onion(chopped)", "onion(whole)", True),
        ("onion(chopped)", "onion(chopped,fried)", True),
        ("onion(chopped)", "onion", True),
        ("egg@in carton", "egg(whole)@in carton", False),
        ("egg@in carton", "egg(whole)", False),
        ("egg@in carton", "egg(whole)@in bowl", True),
        ("egg@in carton", "bowl{egg}", True),
        ("knife", "shaker{salt}", False),  # storage comes with what it holds
        ("onion", "shaker{salt}", True),
        ("salt", "shaker{salt}", False),
        ("salt@in jar", "shaker{salt}", True),
        ("onion", "faucet{water}", False),
        ("onion", "water(liquid)", False),
        ("knife", "sink", False),
        ("oven(preheated)", "oven(off)", True),
        ("oven(preheated)", "oven(preheated)", False),
        ("Onions", "onion(whole)", False),
    ],
)
def test_a_leaf_is_lacking_where_nothing_that_was_named_is_it(named, leaf, lacking):
    assert kitchen(named).lacks(node(leaf)) is lacking


@pytest.mark.parametrize(
    ("named", "there"),
    [
        ("onion(chopped)", "onion(chopped)"),
        ("onion(chopped)@on cutting_board", "onion(chopped)@on cutting_board"),
        ("onion(chopped)@on cutting_board", "cutting board{onion}"),
        ("oven(preheated)", "oven(preheated)"),
        ("egg", "egg(whole)@in carton"),
        ("dough", "dough{flour,water}"),
    ],
)
def test_a_search_has_what_was_named_as_it_was_named(named, there):
    assert kitchen(named).has(node(there))


def test_a_search_has_a_food_in_an_odd_place_only_where_it_was_named_to_be_there():
    assert not kitchen("onion").has(node("onion(whole)@on cutting_board"))
    assert not EVERYBODY.has(node("onion(chopped)@on cutting_board"))


def test_what_is_there_in_a_processed_state_is_a_start_and_stands_ready():
    there = kitchen("onion(chopped)", "egg")
    assert there.is_start_state("onion", "chopped")
    assert not there.is_start_state("onion", "whole")
    assert there.stands_ready("onions", "chopped")
    assert not there.stands_ready("egg", "whole")
    assert there.is_start_state("tomato", "whole")  # it is not there, but so it is sold


@pytest.mark.parametrize(
    ("named", "made", "stands"),
    [
        (["egg(cracked)@in bowl"], ("cracked",), ("cracked",)),
        (["egg(cracked)", "egg"], (), ()),
        (["onion(chopped)"], ("chopped",), ()),  # who asks for a whole one finds none
        (["rice(cooked)"], ("cooked",), ()),
        (["egg"], (), ()),
        ([], (), ()),
    ],
)
def test_a_food_that_is_only_there_opened_stands_for_one_as_it_is_sold(named, made, stands):
    there = kitchen(*named, "salt")
    assert there.made_so(there.foods_named[0].label) == made
    assert there.stands_as(there.foods_named[0].label, ("whole",)) == stands


def test_what_was_named_as_contents_alone_is_there_beside_all_that_is_sold():
    rice = node("rice(cooked)@pot")
    named = [node("pot{rice}"), node("knife")]
    there = StockedKitchen.of(EVERYBODY, named, inside=[rice])
    assert there.ready_in("rice", "cooked") == "pot"
    assert not any(there.lacks(node(leaf)) for leaf in ("onion(whole)", "rice(uncooked)", "rice(cooked)@pot"))
    assert there.is_start_state("rice", "uncooked")
    more = StockedKitchen.of(EVERYBODY, [*named, node("onion")], inside=[rice])
    assert more.lacks(node("tomato(whole)"))
    assert not more.lacks(rice)


def test_a_utensil_that_is_hot_already_needs_nobody_to_heat_it():
    hot = node("oven(preheated)")
    assert kitchen("oven(preheated)").leaf_fault(hot) is None
    assert kitchen("oven").leaf_fault(hot) is LeafFault.RUNNING


def test_a_vessel_may_hold_the_food_that_was_named_to_be_in_it():
    assert kitchen("egg@in bowl").leaf_fault(node("bowl{egg}")) is None
    assert kitchen("egg").leaf_fault(node("bowl{egg}")) is LeafFault.HELD


def test_places_and_hands_need_not_be_named():
    assert not any(kitchen("knife").lacks(node(place)) for place in ALWAYS_THERE)
    assert all(map(EVERYBODY.is_utensil, ALWAYS_THERE))


def test_every_food_is_there_again_for_the_search_of_a_reference():
    there = kitchen("knife", "onion").with_every_food()
    assert there.has(node("tomato(whole)"))
    assert not there.has(node("bowl(empty)"))


def test_wishes_of_a_recipe_keep_what_was_named():
    assert kitchen("onion").with_foods(["cooking spray"]).lacks(node("cooking spray"))


def test_of_both_kinds_just_what_was_named_is_there():
    both = kitchen("knife", "onion")
    assert [both.lacks(node(leaf)) for leaf in ("bowl(empty)", "tomato(whole)", "knife", "onion(whole)")] == [
        True,
        True,
        False,
        False,
    ]


leaves = st.sampled_from(
    [
        "knife",
        "bowl(empty)",
        "onion(whole)",
        "onion(chopped)",
        "salt(granulated)",
        "shaker{salt}",
        "egg(whole)@in carton",
    ]
).map(node)


@given(st.lists(leaves, min_size=1), leaves)
def test_what_was_named_is_never_lacking_and_naming_more_takes_nothing_away(named, other):
    there = StockedKitchen.of(EVERYBODY, named)
    assert not any(there.lacks(thing) for thing in named if not thing.ingredients)
    more = StockedKitchen.of(EVERYBODY, [*named, other])
    kinds = {EVERYBODY.is_food(thing) for thing in named}
    if EVERYBODY.is_food(other) in kinds:
        assert not any(more.lacks(leaf) for leaf in named if not there.lacks(leaf))


def test_what_is_called_as_a_utensil_is_there_for_who_asks_for_it_as_a_food():
    named = kitchen("apple", "cooking_spray", "cooking_spray(liquid)@in cooking_spray")
    asked = named.with_foods(["apple", "cooking spray"])
    assert not asked.lacks(node("cooking_spray(liquid)@in cooking_spray"))
    assert kitchen("apple", "knife").with_foods(["cooking spray"]).lacks(node("cooking_spray(liquid)"))
