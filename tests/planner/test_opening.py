"""Foods that are opened as a cook would do it: peeled before cut, cut before grated, and never only slit."""

from __future__ import annotations

import pytest
from kitchen_stories import node, subgraph, unit
from planner.dishes import KITCHEN, SETTINGS

from foon_kg.model import Annotation, Recipe, RequiredIngredient, Subgraph
from foon_kg.planner import plan
from foon_kg.snapshot import Snapshot

DISH = (
    "bowl(empty); salt(granulated) > sprinkle > bowl{salt}",
    "bowl{salt}; spoon > mix* > bowl{salad}; salad(mixed){salt}@bowl",
)
ON_THE_BOARD = "cutting board(empty); avocado(whole) > pick-and-place > avocado(whole)@on cutting_board"
SLIT = "avocado(whole)@on cutting_board; knife > cut > avocado(slit)@on cutting_board"
HALVED = "avocado(slit)@on cutting_board > pull apart > avocado(halved)@on cutting_board"
PEELED = "avocado(halved)@on cutting_board > peel > avocado(halved,peeled)@on cutting_board"
GRATED = "avocado(whole)@on cutting_board; grater > grate > avocado(grated)@on cutting_board"
BOILED = (
    "stove(off) > turn on > stove(on)",
    "pot(empty); stove(on); water(liquid) > heat > pot(hot){water}; water(hot)@pot",
    "pot(hot){water}; water(hot)@pot; egg(whole) > place > pot(hot){egg,water}; egg(whole)@pot",
    "pot(hot){egg,water}; egg(whole)@pot; stove(on) > boil > egg(hardboiled,whole)@pot",
)
SHELLED = "egg(hardboiled,whole)@pot > peel > egg(hardboiled,peeled,whole)@pot"


def joined(dish_type, dish, lines, food, state):
    """The node of ``food`` that joins a dish of salt where the FOON also knows ``lines``."""
    known = Subgraph("known", tuple(Annotation(unit(line)) for line in lines))
    snapshot = Snapshot.of([subgraph("dish", dish_type, *dish), known], KITCHEN)
    recipe = Recipe(dish_type, (RequiredIngredient("salt", "granulated"), RequiredIngredient(food, state)))
    units = plan(snapshot, recipe, SETTINGS).units
    into = next(u for u in units if any({"salt", food} <= {*n.ingredients} for n in u.output_nodes))
    return next(n for n in into.input_nodes if n.label == food or food in n.ingredients)


@pytest.mark.parametrize(
    ("known", "joins"),
    [
        ((SLIT,), "avocado(slit)@on cutting_board"),
        ((SLIT, HALVED), "avocado(halved)@on cutting_board"),
        ((SLIT, HALVED, PEELED), "avocado(halved,peeled)@on cutting_board"),
        ((SLIT, HALVED, GRATED), "avocado(halved)@on cutting_board"),
    ],
)
def test_a_whole_food_is_opened_as_far_as_it_is_fit_to_eat(known, joins):
    assert joined("salad", DISH, (ON_THE_BOARD, *known), "avocado", "whole") == node(joins)


def test_an_egg_that_is_boiled_in_its_shell_is_peeled_where_the_foon_peels_one():
    assert joined("salad", DISH, BOILED, "egg", "hardboiled") == node("egg(hardboiled,whole)@pot")
    assert joined("salad", DISH, (*BOILED, SHELLED), "egg", "hardboiled") == node("egg(hardboiled,peeled,whole)@pot")


FRIED = (
    "stove(off) > turn on > stove(on)",
    "frying pan(empty); stove(on) > heat > frying pan(empty,hot)",
    "beef(raw); frying pan(empty,hot) > place > frying pan(hot){beef}; beef(raw)@frying_pan",
    "frying pan(hot){beef}; beef(raw)@frying_pan; stove(on) > cook > beef(cooked)@frying_pan",
)
SOUP = (
    "pot(empty); water(liquid) > pour > pot{water}",
    "pot{water}; salt(granulated) > sprinkle > pot{salt,water}",
    "stove(off) > turn on > stove(on)",
    "pot{salt,water}; stove(on) > boil > pot{soup}; soup(cooked){salt,water}@pot",
)


BESIDE = (
    DISH[0],
    "stove(off) > turn on > stove(on)",
    "cup(empty); milk(liquid); stove(on) > boil > cup{milk}; milk(hot)@cup",
    "bowl{salt}; cup{milk}; milk(hot)@cup > pour > bowl{milk,salt}",
    "bowl{milk,salt}; spoon > mix* > bowl{salad}; salad(mixed){milk,salt}@bowl",
)
"""A salad over which something is poured that was cooked beside it."""

IN_A_HOT_PAN = (
    "stove(off) > turn on > stove(on)",
    "wok(empty); stove(on) > warm > wok(empty,hot)",
    "wok(empty,hot); salt(granulated) > sprinkle > wok(hot){salt}",
    "wok(hot){salt}; spoon > mix* > wok(hot){noodle}; noodle(mixed){salt}@wok",
)


@pytest.mark.parametrize(
    ("dish_type", "dish", "known", "joins"),
    [
        ("salad", DISH, FRIED, "beef(cooked)@frying_pan"),
        ("salad", BESIDE, FRIED, "beef(cooked)@frying_pan"),
        ("noodle", IN_A_HOT_PAN, FRIED, "beef(raw)"),
        ("salad", DISH, FRIED[:1], "beef(raw)"),
        ("soup", SOUP, FRIED, "beef(raw)"),
    ],
)
def test_raw_meat_is_cooked_for_a_dish_that_is_not_and_joins_raw_what_is_cooked_later(dish_type, dish, known, joins):
    assert joined(dish_type, dish, known, "beef", "raw") == node(joins)


CRACKED = "egg(whole); bowl(empty) > crack > bowl{egg}; egg(cracked)@bowl"


@pytest.mark.parametrize(
    ("dish_type", "dish", "known", "joins"),
    [
        ("salad", DISH, (CRACKED, *BOILED, SHELLED), "egg(hardboiled,peeled,whole)@pot"),
        ("soup", SOUP, (CRACKED, *BOILED, SHELLED), "egg(cracked)@bowl"),
        ("salad", DISH, (CRACKED,), "egg(cracked)@bowl"),
        ("soup", SOUP, (*BOILED, SHELLED), "egg(hardboiled,peeled,whole)@pot"),
    ],
)
def test_an_egg_is_boiled_for_a_salad_and_cracked_into_a_soup_where_the_foon_knows_both(dish_type, dish, known, joins):
    assert joined(dish_type, dish, known, "egg", "whole") == node(joins)


def test_what_people_eat_raw_is_not_cooked_for_a_salad_though_the_foon_knows_how():
    known = (
        "cutting board(empty); tomato(whole) > pick-and-place > tomato(whole)@on cutting_board",
        "tomato(whole)@on cutting_board; knife > dice > tomato(diced)@on cutting_board",
        "tomato(diced)@on cutting_board; pan(empty) > fry > tomato(diced,fried)@pan",
    )
    assert joined("salad", DISH, known, "tomato", "whole") == node("tomato(diced)@on cutting_board")
