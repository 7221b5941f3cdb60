"""How a name is looked up, whatever it is: in the singular, the longest phrase first, and exact names for good."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.food import Match, Tables, foods, singular, tables, words

FOODS = tables().foods
UTENSILS = tables().utensils
LISTED = st.sampled_from(sorted(FOODS.kind_of))
PLAIN = LISTED.filter(lambda name: {"al", "con", "d", "de", "di"}.isdisjoint(name.split()))
"""Names in which nothing says "of" in another language, so that their last word is the food."""
KINDS = st.sampled_from(sorted(FOODS.kinds))
NONSENSE = st.from_regex(r"[qxz]{2}[a-z]{2,6}q", fullmatch=True)
"""Words that no table has, and that end as no food does."""


ODD_PLURALS = ("ch", "sh", "lf", "fe", "af", "ie", "che", "she", "sse", "xe", "oe")


def has_a_plain_plural(name):
    """Whether an s makes the plural, and taking it off the singular: "quiches" may be of a quiche or of a quich."""
    last = name.split()[-1]
    return len(last) > 2 and last[-1] not in "sxziuoy" and not last.endswith(ODD_PLURALS)


@given(LISTED.filter(has_a_plain_plural))
def test_one_food_and_many_are_the_same(name):
    assert FOODS.find(f"{name}s") == FOODS.find(name)


@given(LISTED)
def test_capitals_and_spaces_say_nothing(name):
    assert FOODS.find(f"  {name.title()} ") == FOODS.find(name)


@given(st.text())
def test_any_text_is_looked_up(text):
    kind, taken_for, match = FOODS.find(text)
    assert kind in {*FOODS.kinds, "unknown"}
    assert (match is Match.UNKNOWN) == (kind == "unknown")
    assert (match is Match.NAME) == FOODS.is_listed(text)
    assert FOODS.food(text).taken_for == taken_for


@given(LISTED)
def test_a_listed_name_is_itself(name):
    assert FOODS.find(name) == (FOODS.kind_of[name], name, Match.NAME)


@given(st.lists(NONSENSE, min_size=1, max_size=3), LISTED)
def test_words_before_a_name_do_not_hide_it(before, name):
    kind, taken_for, match = FOODS.find(" ".join([*before, name]))
    assert (kind, taken_for, match) == (FOODS.kind_of[name], name, Match.HEAD)


@given(NONSENSE, PLAIN, NONSENSE)
def test_a_name_in_the_middle_is_a_guess(before, name, after):
    kind, taken_for, match = FOODS.find(f"{before} {name} {after}")
    assert match is Match.PART
    assert (kind, taken_for) == (FOODS.kind_of[name], name)


@given(st.lists(PLAIN, min_size=2, max_size=3))
def test_the_longest_phrase_at_the_end_wins(names):
    name = " ".join(names)
    own = words(name)
    endings = [" ".join(own[start:]) for start in range(len(own))]
    _, taken_for, _ = FOODS.find(name)
    longest = next(ending for ending in endings if FOODS.is_listed(ending))
    # a name with a kind of its own is itself, also where it is another name of a food
    assert taken_for == (longest if longest in FOODS.kind_of else FOODS.called[longest])


@given(st.lists(NONSENSE, min_size=1, max_size=2).map(" ".join), st.lists(LISTED, max_size=1), KINDS, LISTED)
def test_a_word_more_never_changes_what_is_listed(new, after, kind, name):
    added = " ".join([new, *after])
    more = replace(FOODS, kind_of={**FOODS.kind_of, singular(added): kind}, _known={}, _found={})
    assert more.find(name) == FOODS.find(name)
    assert more.find(added) == (kind, singular(added), Match.NAME)
    assert more.food(name).kind == FOODS.food(name).kind


@given(st.sampled_from(sorted(UTENSILS)))
def test_a_utensil_is_found_by_its_name_alone(name):
    assert tables().utensil(name.title()) is UTENSILS[name]
    assert tables().utensil(f"{name} soup") is None


@given(LISTED, st.lists(st.sampled_from(sorted(tables().states)), max_size=3))
def test_every_food_in_every_state_is_of_a_kind_with_all_broader_ones(name, states):
    food = FOODS.food(name, states)
    assert food.kind in FOODS.kinds
    assert food.kinds == FOODS.broader(food.kind)
    assert food.known


def test_what_strangers_ask_is_not_remembered_for_ever(monkeypatch):
    monkeypatch.setattr(foods, "MOST_LOOKED_UP", 10)
    table = Tables()
    for number in range(100):
        name = f"zeppelin {chr(97 + number % 26)}{chr(97 + number // 26)}"
        assert table.foods.food(name).kind == "unknown"
        assert table.state(name).fine is None
        assert not table.motion(name).does
    assert len(table.foods._known) <= 10
    assert len(table.foods._found) <= 10
    assert max(len(table._states), len(table._motions)) <= 10


def test_a_plural_that_is_not_listed_is_of_the_vegetable_and_the_bone_is_no_food():
    for label in ("Hungarian wax peppers", "Hungarian wax peppers (sliced)"):
        assert FOODS.food(label).kind == "sweet pepper"
    assert FOODS.food("black peppers").kind == FOODS.food("hill pepper").kind == "black pepper"
    assert FOODS.food("pork loin on the bone").is_a("joint")


def test_letters_of_their_own_are_read_as_plain_ones():
    assert words("\u0130mam bay\u0131ld\u0131, gołąbki") == words("Imam bayildi, golabki")


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("fat from the roast", "fat"),
        ("oil from frying the onions", "oil"),
        ("mushroom soaking liquid", "water"),
        ("leaves from thyme", "dried herb"),
        ("meat from 2 crabs", "crab"),
    ],
)
def test_what_is_left_of_cooking_is_not_what_was_cooked(name, kind):
    assert FOODS.food(name).kind == kind
