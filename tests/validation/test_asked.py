"""K6 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.dishes import heated, lines, recipe, served
from validation.judging import ONE_TOMATO, found

# --- K6 asked ---


def test_what_only_gives_its_taste_may_be_taken_out_again_but_has_to_be_in_it_first():
    """A bay leaf that was never in the pot is not in the dish."""
    out = """
soup (cooked; {bay leaf, leek, water}; in pot) + pot (hot; {soup}; on stove) + plate (empty) + tong → REMOVE
  → soup (cooked; {leek, water}; in pot) + pot (hot; {soup}; on stove) + bay leaf (cooked; on plate)
  + plate ({bay leaf})
"""
    asked = recipe("soup", "leek; bay leaf; water")
    assert found("K6", asked + heated("soup", "leek", "bay leaf", "water", motion="SIMMER") + out) == []
    assert len(found("K6", asked + heated("soup", "leek", "water", motion="SIMMER"))) == 1


def test_k2_what_only_gave_its_taste_is_taken_out_before_the_dish_is_served():
    left = "K2 (minor): bay leaf is in the dish, and nobody eats it"
    assert found("K2", heated("soup", "bay leaf", "water")) == [left]
    lifted = "soup ({bay leaf, water}; in pot) + plate (empty) → REMOVE → soup ({water}; in pot) + bay leaf (on plate)"
    assert found("K2", heated("soup", "bay leaf", "water") + lifted) == []


def test_k2_a_leaf_is_in_one_piece_and_leaves_that_were_plucked_off_a_stem_are_not():
    def left(food):
        return found("K2", heated("soup", food, "water").replace(f"{food} (whole", f"{food} (leaves"))

    assert left("bay leaf") == ["K2 (minor): bay leaf is in the dish, and nobody eats it"]
    assert left("rosemary") == []
    assert found("K2", heated("soup", "thyme leaf", "water")) == []
    assert len(found("K2", heated("soup", "thyme", "water"))) == 1


def test_k2_what_is_asked_whole_in_a_dish_that_has_it_so_is_whole():
    olives = served("salad", "olive", "tomato")
    assert "K2 (minor): olive is in the dish with its stone" in found("K2", olives)
    kept = found("K2", recipe("salad", "olive (whole); tomato") + olives)
    assert not [one for one in kept if "olive" in one]
    other = found("K2", recipe("bread", "olive (whole); tomato") + olives.replace("salad", "bread"))
    assert [one for one in other if "olive" in one]


def test_k6_an_asked_food_is_in_the_dish():
    assert found("K6", recipe("salad", "tomato; salt") + served("salad", "tomato", "salt")) == []
    assert found("K6", recipe("salad", "tomato; leek") + served("salad", "tomato", "salt")) == [
        "K6 salad ({salt, tomato}; on plate): leek was asked for and is not in the dish"
    ]


@pytest.mark.parametrize("food", ["broth", "chicken broth", "clear chicken broth"])
def test_k6_in_the_same_words_or_a_word_more_or_less(food):
    assert found("K6", recipe("soup", "chicken broth") + served("soup", food, "leek")) == []


@pytest.mark.parametrize("food", ["beef broth", "chicken", "chicken broth powder"])
def test_k6_in_other_words_it_is_another_food(food):
    assert len(found("K6", recipe("soup", "chicken broth") + served("soup", food, "leek"))) == 1


def test_k6_several_foods_are_told_in_the_order_of_their_names():
    told = found("K6", recipe("salad", "radish; leek; leek (sliced)") + served("salad", "tomato", "salt"))
    assert [line.partition(": ")[2].split()[0] for line in told] == ["leek", "radish"]


def test_k6_food_that_lies_beside_on_the_same_plate_is_in_the_dish():
    beside = "leek (whole) + plate ({salad}) → PUT → leek (whole; on plate) + plate ({leek, salad})"
    text = recipe("salad", "tomato; leek") + "goal: salad ({salt, tomato}; on plate)\n"
    assert found("K6", text + lines(served("salad", "tomato", "salt"), beside)) == []


def test_k6_what_is_asked_in_two_parts_comes_apart():
    asked = recipe("cake", "egg (separated); sugar")
    whole = "egg (whole) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({egg})"
    told = found("K6", lines(asked, whole, served("cake", "egg", "sugar")))
    assert told == ["K6 (minor): egg is asked separated, and egg white, egg yolk are never apart"]
    apart = (
        "egg (whole) + bowl (empty) + cup (empty) → CRACK → egg yolk (separated; in bowl) + bowl ({egg yolk})"
        " + egg white (separated; in cup) + cup ({egg white})"
    )
    assert found("K6", lines(asked, apart, served("cake", "egg white", "egg yolk", "sugar"))) == []


def test_k6_without_a_dish_nothing_is_asked():
    assert found("K6", recipe("salad", "leek") + f"goal: soup\n{ONE_TOMATO}") == []


def on_top(food, state="mixed", state_of_food="sliced"):
    """A mixed salad, onto which another food comes at the end."""
    salad = served("salad", "radish", "salt", states=state)
    add = f"{food} ({state_of_food}) + salad ({state}; {{radish, salt}}; on plate) → PUT"
    return lines(salad, f"{add} → salad ({state}; {{{food}, radish, salt}}; on plate) + plate ({{salad}})")


def test_k6_an_asked_food_that_lies_unmixed_on_what_is_mixed():
    assert found("K6", recipe("salad", "cucumber; radish") + on_top("cucumber")) == [
        "K6 step 2: cucumber is not mixed with the rest"
    ]


@pytest.mark.parametrize(
    "food",
    [
        "parsley", "bacon", "guava", "lard", "cream", "egg white", "canned tomato", "spice blend", "topping",
        "sour cream", "sugar", "olive oil", "milk", "almond",
    ],
)  # fmt: skip
def test_k6_what_is_strewn_or_poured_over_a_dish_need_not_be_mixed_in(food):
    assert found("K6", recipe("salad", f"{food}; radish") + on_top(food)) == []


def test_k6_where_the_dish_is_not_mixed_nothing_need_be():
    assert found("K6", recipe("salad", "cucumber; radish") + on_top("cucumber", "ready")) == []


def test_k6_food_that_was_mixed_in_later_is_mixed():
    all_in = "{cucumber, radish, salt}; on plate)"
    mix = f"salad (mixed; {all_in} + spoon → TOSS → salad (mixed, tossed; {all_in}"
    assert found("K6", recipe("salad", "cucumber; radish") + lines(on_top("cucumber"), mix)) == []


def test_k6_a_food_of_which_some_was_mixed_in_is_mixed():
    both = on_top("cucumber").replace("radish", "cucumber", 1)
    assert found("K6", recipe("salad", "cucumber") + both) == []
