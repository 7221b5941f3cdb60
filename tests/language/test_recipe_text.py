"""A recipe as a text: its ingredients, and what to do."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from foon_kg.language.drafting.larder import Larder
from foon_kg.language.recipe_text import recipe_text
from foon_kg.model.narration import Mention

STEPS = ("Beat the eggs.", "Bake.")


def test_lines_with_amounts_at_the_top_are_ingredients():
    assert recipe_text(("2 eggs", "- 1/2 cup milk", "½ tsp salt", *STEPS)) == (
        ("2 eggs", "- 1/2 cup milk", "½ tsp salt"),
        STEPS,
    )


def test_a_title_of_one_word_and_a_food_without_an_amount_stand_with_the_amounts():
    assert recipe_text(("Brownies", "200 g butter", "3 eggs", "salt", *STEPS)) == (
        ("200 g butter", "3 eggs", "salt"),
        STEPS,
    )


def test_headings_tell_the_parts_apart():
    lines = ("Ingredients:", "2 eggs", "salt", "## Directions", *STEPS)
    assert recipe_text(lines) == (("2 eggs", "salt"), STEPS)
    assert recipe_text(("Method", *STEPS)) == ((), STEPS)


def test_a_title_is_neither_an_ingredient_nor_a_step():
    assert recipe_text(("Sunday pancakes", "2 eggs", *STEPS)) == (("2 eggs",), STEPS)
    assert recipe_text(("Roast chicken with potatoes", *STEPS)) == ((), STEPS)
    assert recipe_text(("Pancakes", "Ingredients", "2 eggs", "Method", *STEPS)) == (("2 eggs",), STEPS)
    for listed in (("sea salt", "2 eggs", *STEPS), ("salt", *STEPS), ("Chop onion", "Fry it")):
        assert listed[0] in (*recipe_text(listed).ingredients, *recipe_text(listed).instructions)


def test_numbered_steps_are_no_ingredients():
    numbered = ("1. Beat the eggs.", "2) Bake.")
    assert recipe_text(numbered) == ((), numbered)
    assert recipe_text(("2 eggs", *numbered)) == (("2 eggs",), numbered)


@given(st.lists(st.sampled_from(("2 eggs", "salt", "1. Stir.", "Ingredients", "Method", "Bake.")), min_size=1))
def test_no_line_is_lost_or_read_twice(lines):
    listed, told = recipe_text(lines)
    assert sorted((*listed, *told)) == sorted(line for line in lines if line not in {"Ingredients", "Method"})


def test_an_ingredient_is_taken_by_the_words_that_people_use_of_it():
    larder = Larder.of((Mention("black beans", ("rinsed",)), Mention("red onion"), Mention("salt")))
    assert larder.take("beans") == Mention("black beans", ("rinsed",))
    assert larder.take("sliced red onion") == Mention("red onion")
    assert larder.take("bean sprouts") is None
    assert larder.left() == (Mention("salt"),)
    larder.take("salt")
    assert larder.left() == ()


def test_a_shorter_name_speaks_of_the_ingredient_that_begins_with_it():
    larder = Larder.of([Mention("chicken thighs"), Mention("soy sauce")])
    assert larder.take("chicken") == Mention("chicken thighs")
    assert larder.names(["chicken"])
    assert not larder.names(["turkey"])
