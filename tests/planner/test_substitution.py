import pytest

from foon_kg.kitchen import Kitchen
from foon_kg.knowledge import MadeBy, SeenAs, Vocabulary
from foon_kg.model import RequiredIngredient
from foon_kg.substitution import Equivalents

VOCABULARY = Vocabulary(
    foods=(
        SeenAs("onion", "chopped", 4, 4),
        SeenAs("onion", "whole", 0, 5),
        SeenAs("potato", "diced", 3, 3),
        SeenAs("potato", "mashed", 1, 1),
        SeenAs("potato", "whole", 0, 3),
        SeenAs("salt", "granulated", 0, 9),
        SeenAs("sweet potato", "sliced", 2, 2),
    ),
    motions=(
        MadeBy("chopped", "chop", 4),
        MadeBy("diced", "chop", 1),
        MadeBy("diced", "dice", 3),
        MadeBy("sliced", "slice", 2),
    ),
    dish_types=("salad",),
)
PIECES = {"diced", "sliced", "chopped"}


def names(required, known):
    return {("potato", "potato"): 1.0, ("potato", "sweet potato"): 0.7, ("yam", "sweet potato"): 0.6}.get(
        (required, known), 0.1
    )


def states(a, b):
    return 0.8 if {a, b} <= PIECES or {a, b} <= {"ground", "granulated"} else 0.1


EQUIVALENTS = Equivalents(VOCABULARY, Kitchen.default(), names, states)


def test_a_food_itself_in_another_state_of_the_class_comes_before_another_food_in_the_state_asked():
    found = EQUIVALENTS.candidates(RequiredIngredient("potato", "sliced"))
    assert [(c.label, c.state) for c in found] == [("potato", "diced"), ("sweet potato", "sliced")]


def test_a_state_of_another_class_and_a_food_below_one_half_are_no_equivalents():
    found = EQUIVALENTS.candidates(RequiredIngredient("yam", "sliced"))
    assert [(c.label, c.state) for c in found] == [("sweet potato", "sliced")]
    assert EQUIVALENTS.candidates(RequiredIngredient("kiwi", "sliced")) == ()


def test_a_known_diced_potato_is_recast_as_a_sliced_one_by_slicing():
    recast, fit = EQUIVALENTS.recast(RequiredIngredient("potato", "sliced"), ["whole", "diced"], [("diced", "dice")])
    assert (recast.label, recast.states, recast.motions, fit) == ("potato", {"diced": "sliced"}, {"dice": "slice"}, 0.8)


def test_a_motion_that_makes_the_state_anyway_is_not_replaced():
    recast, _ = EQUIVALENTS.recast(RequiredIngredient("potato", "diced"), ["sliced"], [("sliced", "chop")])
    assert recast.motions == {}


@pytest.mark.parametrize(("required", "known"), [("sliced", "whole"), ("whole", "sliced"), ("mashed", "whole")])
def test_what_is_sold_never_stands_for_what_is_made_nor_the_other_way_round(required, known):
    assert EQUIVALENTS.state_confidence("potato", required, known) == 0.0


def test_a_state_that_the_line_passes_anyway_needs_no_substitution():
    recast, fit = EQUIVALENTS.recast(
        RequiredIngredient("onion", "chopped"), ["whole", "chopped"], [("chopped", "chop")]
    )
    assert (recast.states, recast.motions, fit) == ({}, {}, 1.0)


def test_the_form_in_which_something_is_sold_may_be_called_otherwise_within_its_class():
    recast, fit = EQUIVALENTS.recast(RequiredIngredient("salt", "ground"), ["granulated"], [])
    assert (recast.states, fit) == ({"granulated": "ground"}, 0.8)


def test_a_motion_named_after_the_state_stands_before_the_commonest_one_which_may_only_move_food():
    made = (MadeBy("chopped", "chop", 4), MadeBy("diced", "dice", 1), MadeBy("diced", "scoop and pour", 7))
    known = Equivalents(Vocabulary(VOCABULARY.foods, made, ("salad",)), Kitchen.default(), names, states)
    recast, _ = known.recast(RequiredIngredient("onion", "diced"), ["chopped"], [("chopped", "chop")])
    assert recast.motions == {"chop": "dice"}


@pytest.mark.parametrize(
    ("state", "known", "motion", "instead"),
    [
        ("baked", "hardboiled", "boil", {}),  # in the same water nothing is baked
        ("boiled", "baked", "bake", {}),
        ("baked", "fried", "fry", {"fry": "bake"}),
        ("warm", "hardboiled", "boil", {"boil": "heat"}),
        ("crushed", "chopped", "chop", {}),  # and nothing is blended with a knife
        ("crushed", "mashed", "mash", {"mash": "blend"}),
        ("poached", "hardboiled", "poach", {}),  # a state is made by the motion that it is named after
    ],
)
def test_a_motion_is_replaced_by_one_that_can_be_done_with_the_same_things(state, known, motion, instead):
    made = (
        ("baked", "bake"),
        ("boiled", "boil"),
        ("boiled", "pour"),
        ("warm", "broil"),
        ("warm", "heat"),
        ("crushed", "blend"),
        ("poached", "cook"),
        ("eggy", "poach"),
    )
    vocabulary = Vocabulary((), tuple(MadeBy(*row, 2) for row in made), ("salad",))
    like = Equivalents(vocabulary, Kitchen.default(), names, lambda *_: 0.8)
    recast, _ = like.recast(RequiredIngredient("egg", state), [known], [(known, motion)])
    assert recast.motions == instead
