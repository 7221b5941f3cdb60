"""Recipes of a collection understood: the collection's own foods are believed, states are read from the lines."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.language.collection import CollectionReader, bare_headings, is_heading, state_beside
from foon_kg.model.collected import CalledFor, CollectedLine, CollectedRecipe


def recipe(*lines, title="Onion Soup", dish_type=None):
    return CollectedRecipe("a1", title, tuple(lines), "layer1.json: element 1", dish_type)


def understand(*lines, labels=None, full=False, **more):
    return CollectionReader(labels or {}, full=full).understand([recipe(*lines, **more)])[0]


@pytest.mark.parametrize(
    ("food", "text", "state"),
    [
        ("onion", "2 cups finely chopped onions", "finely chopped"),
        ("onion", "1 onion, chopped, then sauteed", "sauteed"),
        ("tomatoes", "1 (14 oz, diced) can tomatoes", ""),
        ("tomatoes", "1 can tomatoes, drained", "drained"),
        ("butter", "1/2 cup Butter, MELTED", "melted"),
        ("egg", "2 large eggs", ""),
        ("parsley", "fresh parsley", "fresh"),
    ],
)
def test_the_state_is_the_last_thing_that_the_line_says_beside_the_food(food, text, state):
    assert state_beside(food, text) == state


def test_a_food_that_is_not_in_the_line_has_no_state_beside_it():
    assert state_beside("leek", "1 chopped onion") is None
    assert state_beside("egg", "1 sliced eggplant") is None


def test_a_detected_food_goes_by_its_label_in_the_foon():
    line = CollectedLine("2 courgettes, sliced", "courgettes", "", "2", "")
    assert understand(line, labels={"zucchini": "Zucchini squash"}).ingredients == (
        CalledFor("Zucchini squash", "sliced", "2 courgettes, sliced", "2", ""),
    )


def test_a_food_that_the_foon_does_not_know_goes_by_its_canonical_name():
    assert understand(CollectedLine("3 prawns", "prawns")).ingredients[0].object == "shrimp"


def test_a_state_that_the_collection_gives_is_kept_as_it_is():
    line = CollectedLine("grated carrot", "carrot", "shaved")
    assert understand(line).ingredients[0].state == "shaved"


def test_a_line_without_a_detected_food_is_read_by_the_parser():
    (called,) = understand(CollectedLine("2 cups chopped red onion")).ingredients
    assert (called.object, called.state, called.quantity) == ("red onion", "chopped", "2")


def test_with_full_the_parser_reads_every_line():
    (called,) = understand(CollectedLine("2 cups chopped red onion", "onion"), full=True).ingredients
    assert called.object == "red onion"


def test_a_line_without_any_food_is_left_over_and_the_others_stay():
    understood = understand(CollectedLine("12345"), CollectedLine("salt", "salt"))
    assert understood.left_over == ("12345",)
    assert [called.object for called in understood.ingredients] == ["salt"]


def test_the_dish_type_of_the_collection_is_the_sure_one():
    classes = understand(CollectedLine("salt", "salt"), dish_type="salad").dish_classes
    assert [(c.name, c.sure) for c in classes] == [("salad", True), ("soup", False)]


def test_a_dish_type_that_nobody_knows_is_not_believed():
    classes = understand(CollectedLine("salt", "salt"), dish_type="gruel").dish_classes
    assert [(c.name, c.sure) for c in classes] == [("soup", True)]


@given(st.lists(st.sampled_from(["salt", "2 onions", "1 leek, sliced", "!!"]), min_size=1, max_size=6))
def test_every_line_is_called_for_or_left_over(texts):
    understood = understand(*(CollectedLine(text, text.split()[-1].strip("!") or None) for text in texts))
    called = [called.text for called in understood.ingredients]
    assert sorted([*called, *understood.left_over]) == sorted(texts)


def test_a_reader_answers_the_same_whether_it_saw_the_lines_before():
    reader = CollectionReader({})
    recipes = [recipe(CollectedLine("1 leek, sliced", "leek")), recipe(CollectedLine("salt", "salt"))]
    assert reader.understand(recipes) == reader.understand(recipes) == CollectionReader({}).understand(recipes)


def test_a_line_that_is_not_plain_keeps_its_amount_beside_the_food_that_the_collection_names():
    (called,) = understand(CollectedLine("2-3 cups chopped onions from your garden", "onions")).ingredients
    assert (called.object, called.state, called.quantity, called.unit) == ("onion", "chopped", "2-3", "cups")
    (told,) = understand(CollectedLine("2-3 cups chopped onions from your garden", "onions", "", "5", "")).ingredients
    assert (told.quantity, told.unit) == ("5", "")


@pytest.mark.parametrize(
    "text", ["TOPPING", "Filling", "For the dressing:", "FOR THE SAUCE", "** Cake batter: **", "Spices:"]
)
def test_a_heading_between_the_lines_is_no_food(text):
    understood = understand(CollectedLine(text), CollectedLine("1 onion"))
    assert [called.object for called in understood.ingredients] == ["onion"]
    assert understood.left_over == (text,)


@pytest.mark.parametrize("text", ["1 cup sauce", "tomato sauce", "SALT", "salad dressing", "1 batch filling:"])
def test_a_line_that_asks_for_something_is_no_heading(text):
    assert not is_heading(text)


@pytest.mark.parametrize("heading", ["Onion gravy", "Spice paste", "Cobbler dough", "Lemon drizzle icing"])
def test_a_part_without_an_amount_among_lines_with_amounts_is_a_heading(heading):
    lines = [CollectedLine(text) for text in ("500 g pork", "1 egg", heading, "2 onions", "1 l milk")]
    understood = understand(*lines)
    assert [called.object for called in understood.ingredients] == ["pork", "egg", "onion", "milk"]
    assert understood.left_over == (heading,)


@pytest.mark.parametrize(
    "lines",
    [
        ["500 g pork", "soy sauce", "2 onions", "1 egg"],  # a known food
        ["500 g pork", "2 onions", "1 egg", "onion gravy"],  # nothing stands below it
        ["500 g pork", "2 onions", "onion gravy", "1 egg"],  # too little for a part stands below it
        ["pork", "onion gravy", "1 onion", "1 egg", "salt", "milk", "water"],  # nobody gives amounts
        ["500 g pork", "1 jar onion gravy", "1 onion", "1 egg"],
        ["500 g pork", "hot and sour onion gravy", "1 onion", "1 egg"],
    ],
)
def test_a_part_that_is_bought_is_no_heading(lines):
    assert bare_headings(lines) == frozenset()


def test_a_heading_that_the_collection_takes_for_a_food_is_believed():
    assert [called.object for called in understand(CollectedLine("Dressing", "dressing")).ingredients] == ["dressing"]


@pytest.mark.parametrize(
    ("food", "label"), [("garlic cloves", "garlic"), ("celery stalk", "celery"), ("garlic salt", "garlic salt")]
)
def test_pieces_of_a_food_of_the_foon_are_that_food(food, label):
    labels = {"garlic": "garlic", "celery": "celery"}
    assert understand(CollectedLine(f"2 {food}", food), labels=labels).ingredients[0].object == label
    named = {**labels, "garlic clove": "garlic clove"}
    assert (
        understand(CollectedLine("2 garlic cloves", "garlic cloves"), labels=named).ingredients[0].object
        == "garlic clove"
    )
