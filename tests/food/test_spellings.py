"""What an unknown word may mean: the closest spelling is sought among few words, and is what difflib gives of all."""

import difflib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.food.unknown import Spellings
from tests.examples import examples

WORDS = st.text("abcñÀà 乐", max_size=9)


@examples(300)
@given(WORDS, st.lists(WORDS, max_size=12), st.sampled_from((0.3, 0.6, 0.75, 0.85, 1.0)))
def test_the_closest_word_is_what_difflib_gives(word, words, near):
    expected = next(iter(difflib.get_close_matches(word, words, 1, near)), "")
    assert Spellings(words).closest(word, near) == expected


@pytest.mark.parametrize(
    ("allowed", "closest"), [({"tomato", "potato"}, "tomato"), ({"potato"}, "potato"), (set(), "")]
)
def test_only_an_allowed_word_is_returned(allowed, closest):
    assert Spellings(["tomato", "potato", "onion"]).closest("tomatoo", 0.6, allowed.__contains__) == closest
