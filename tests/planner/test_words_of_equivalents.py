"""What the words of a FOON may stand for, at the edges: found by mutants that other tests let live."""

from __future__ import annotations

import pytest

from foon_kg.kitchen import Kitchen
from foon_kg.knowledge import MadeBy, SeenAs, Vocabulary
from foon_kg.model import RequiredIngredient
from foon_kg.substitution import FAIR, SAME_CLASS, Equivalents

VOCABULARY = Vocabulary(
    foods=(
        SeenAs("egg", "whole", 0, 5),
        SeenAs("egg", "cracked", 1, 1),
        SeenAs("egg", "beaten", 4, 4),
        SeenAs("egg white", "raw", 2, 2),
        SeenAs("egg yolk", "beaten", 1, 1),
        SeenAs("onion", "", 2, 2),
        SeenAs("onion", "chopped", 3, 3),
        SeenAs("onion", "sliced", 3, 4),
        SeenAs("leek", "sliced", 1, 1),
        SeenAs("salt", "granulated", 0, 9),
    ),
    motions=(MadeBy("sliced", "slice", 1), MadeBy("sliced", "cut", 3), MadeBy("beaten", "beat", 2)),
    dish_types=("salad",),
)
LIKE = {("onion", "onion"): 1.0, ("onion", "leek"): FAIR, ("shallot", "onion"): 0.9, ("shallot", "leek"): FAIR - 0.01}


def names(required, known):
    return LIKE.get((required, known), 1.0 if required == known else 0.1)


def states(one, other):
    return {frozenset({"chopped", "sliced"}): SAME_CLASS, frozenset({"diced", "sliced"}): 0.8}.get(
        frozenset({one, other}), 0.2
    )


@pytest.fixture
def words():
    return Equivalents(VOCABULARY, Kitchen.default(), names, states)


def found(candidates):
    return [(c.label, c.state, round(c.confidence, 3)) for c in candidates]


def test_an_equivalent_that_is_just_fair_in_a_state_just_of_the_class_is_one(words):
    wanted = RequiredIngredient("onion", "chopped")
    assert found(words.candidates(wanted)) == [
        ("onion", "chopped", 1.0),
        ("onion", "sliced", 0.5),
        ("leek", "sliced", 0.25),
    ]
    assert found(words.candidates(RequiredIngredient("shallot", "sliced"))) == [
        ("onion", "sliced", 0.9),
        ("onion", "chopped", 0.45),
    ]


def test_no_more_candidates_are_answered_than_asked_for_the_surest_first(words):
    wanted = RequiredIngredient("onion", "chopped")
    assert found(words.candidates(wanted, limit=1)) == [("onion", "chopped", 1.0)]
    assert len(words.candidates(wanted)) == 3


def test_a_food_whose_state_nobody_wrote_down_stands_for_what_is_sold_and_for_nothing_made(words):
    assert words.state_confidence("onion", "whole", "") == SAME_CLASS
    assert words.state_confidence("onion", "chopped", "") == 0.0


def test_a_line_without_states_plays_a_food_that_is_sold(words):
    recast, fit = words.recast(RequiredIngredient("onion", "whole"), [], [])
    assert (recast.label, recast.states, recast.motions, fit) == ("onion", {"": "whole"}, {}, SAME_CLASS)


def test_a_food_asked_in_no_state_plays_any_line_under_its_own_name(words):
    recast, fit = words.recast(RequiredIngredient("shallot", ""), ["sliced"], [("sliced", "cut")])
    assert (recast.label, recast.states, recast.motions, fit) == ("shallot", {}, {}, 1.0)


def test_a_line_whose_states_are_too_unlike_plays_nothing(words):
    assert words.recast(RequiredIngredient("onion", "beaten"), ["sliced"], [("sliced", "cut")]) is None


def test_a_line_that_was_not_seen_being_made_keeps_its_motions(words):
    recast, fit = words.recast(RequiredIngredient("onion", "sliced"), ["chopped"], [])
    assert (recast.states, recast.motions, fit) == ({"chopped": "sliced"}, {}, SAME_CLASS)


def test_a_motion_stays_where_no_motion_of_the_foon_makes_the_state(words):
    recast, _ = words.recast(RequiredIngredient("onion", "diced"), ["sliced"], [("sliced", "cut")])
    assert (recast.states, recast.motions) == ({"sliced": "diced"}, {})


def test_motions_stay_as_they_are_where_they_are_not_to_be_chosen():
    plain = Equivalents(VOCABULARY, Kitchen.default(), names, states, choose_motions=False)
    recast, _ = plain.recast(RequiredIngredient("onion", "sliced"), ["chopped"], [("chopped", "chop")])
    assert (recast.states, recast.motions) == ({"chopped": "sliced"}, {})


def test_a_state_that_no_motion_is_named_after_is_made_by_the_commonest_motion():
    made = (MadeBy("julienne", "whip", 2), MadeBy("julienne", "shave", 5), MadeBy("chopped", "chop", 4))
    vocabulary = Vocabulary(VOCABULARY.foods, made, ("salad",))
    words = Equivalents(vocabulary, Kitchen.default(), names, lambda *_: 0.8)
    recast, _ = words.recast(RequiredIngredient("onion", "julienne"), ["chopped"], [("chopped", "chop")])
    assert recast.motions == {"chop": "shave"}


def test_other_foods_are_named_by_how_sure_they_are_then_by_name(words):
    like = words.labels_like("onion")
    assert like[0] == ("leek", FAIR)
    assert like[1:] == (("egg", 0.1), ("egg white", 0.1), ("egg yolk", 0.1), ("salt", 0.1))
    assert words.labels_like("onion") is like


def test_an_answer_says_what_the_names_say_where_a_person_chose_otherwise():
    words = Equivalents(VOCABULARY, Kitchen.default(), lambda *_: 1.0, states, names)
    assert words.labels_like("onion")[0] == ("leek", FAIR)


def test_the_states_of_a_known_food_are_named_by_how_well_they_fit(words):
    assert words.states_like("shallot", "sliced", "onion") == (("sliced", 1.0), ("chopped", SAME_CLASS))
    assert words.states_like("shallot", "sliced", "nectar") == ()


def test_motions_are_named_with_their_shares_the_most_frequent_first(words):
    assert words.motions_like("sliced") == (("cut", 0.75), ("slice", 0.25))
    assert words.motions_like("molten") == ()


def test_the_states_that_a_foon_makes_are_named_by_how_often_then_by_name(words):
    assert words.states_known("egg") == ("beaten", "cracked")
    assert words.states_known("onion") == ("chopped", "sliced")
    assert words.states_known("salt") == ()


def test_the_parts_of_a_food_are_raw_foods_that_are_called_after_it_with_more_words(words):
    assert words.parts("egg") == (("egg white", "raw"),)
    assert words.parts("white") == (("egg white", "raw"),)
    assert words.parts("egg white") == ()
    assert words.parts("kiwi") == ()


def test_the_makings_of_a_sold_food_are_the_states_in_which_it_is_opened_and_its_parts(words):
    assert words.makings(RequiredIngredient("egg", "whole")) == (
        ("egg", "beaten"),
        ("egg", "cracked"),
        ("egg white", "raw"),
    )


def test_the_makings_of_a_processed_food_are_its_equivalents(words):
    assert words.makings(RequiredIngredient("onion", "chopped")) == (
        ("leek", "sliced"),
        ("onion", "chopped"),
        ("onion", "sliced"),
    )
