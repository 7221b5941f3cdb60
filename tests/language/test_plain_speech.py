"""Figures and remarks are taken out of a sentence; what is done, and to what, stays."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.language.plain_speech import plain_speech


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("Bake 20 minutes. Cool.", "Bake. Cool."),
        ("Bake for about 1 1/2 hours at 165°C.", "Bake."),
        ("Preheat oven to 350 degrees F.", "Preheat oven."),
        ("Chill for at least 2 hours or overnight.", "Chill or."),
        ("Add 2 tablespoons flour and 1 tsp. salt.", "Add flour and salt."),
        ("Shape the dough into balls of around 25g.", "Shape the dough into balls."),
        ("Place them about 5 cm apart on the sheet.", "Place them on the sheet."),
        ("Cook over medium-high heat until soft.", "Cook until soft."),
        ("Bring the water to a boil.", "boil the water."),
        ("Season to taste with salt.", "Season with salt."),
        ("Dust with confectioners' sugar.", "Dust with confectioners sugar."),
        ("Add 2 eggs.", "Add 2 eggs."),
        ("Mince the garlic.", "Mince the garlic."),
    ],
)
def test_figures_are_taken_out(said, left):
    assert plain_speech(said) == left


WORDS = st.lists(st.sampled_from(["stir", "the", "butter", "into", "bowl", "and", "bake", "cream", "eggs"]), min_size=1)


@given(WORDS)
def test_what_has_no_figures_stays_as_it_is(words):
    assert plain_speech(" ".join(words)) == " ".join(words)


@given(st.text(max_size=80))
def test_any_text_is_read_and_gets_no_longer(text):
    assert len(plain_speech(text)) <= len(text)
