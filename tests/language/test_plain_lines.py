import random
from dataclasses import replace

import pytest
from extras import needs, reads_lines_fully
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.food import singular, words
from foon_kg.food.lists import word_list
from foon_kg.food.told_states import in_turn
from foon_kg.language.plain_lines import AGREES, amount_in_front, read_quickly
from foon_kg.language.recipe_lines import read_fully
from foon_kg.model.names import canonical
from foon_kg.similarity.groups import food_groups

pytestmark = reads_lines_fully
needs_the_parser = needs("ingredient_parser")

WORDINGS = (
    "{number} {unit} {food}",
    "{number} {unit} {state} {food}",
    "{number} {unit} {adverb} chopped {food}",
    "{number} {size} {food}, {state}",
    "{number} {size} {food}, peeled and {adverb} {cut}",
    "{number} {unit} {food}, {state}, divided",
    "{number} (14 ounce) cans {food}, drained and {state}",
    "{number} {food}, cut into 1-inch cubes",
    "{number} {unit} fresh {food} (optional)",
    "{number} pounds {food}, or to taste",
    "{food}, {state}",
    "{food}",
)
STATES = (
    "chopped",
    "minced",
    "grated",
    "peeled",
    "melted",
    "cooked",
    "drained",
    "beaten",
    "crushed",
    "toasted",
    "halved",
)
CUTS = ("sliced", "diced", "chopped", "shredded")
UNITS = ("cup", "cups", "tablespoons", "tsp", "oz", "pound", "slices", "stalks", "pinch", "package", "sprigs", "g")
NUMBERS = ("1", "2", "12", "1/2", "3/4", "1 1/2", "2 1/4")


def plain_lines(count):
    dice = random.Random(count)
    for _ in range(count):
        yield dice.choice(WORDINGS).format(
            number=dice.choice(NUMBERS),
            unit=dice.choice(UNITS),
            size=dice.choice(("small", "medium", "large")),
            state=dice.choice(STATES),
            adverb=dice.choice(("finely", "coarsely", "thinly")),
            cut=dice.choice(CUTS),
            food=dice.choice(food_groups().foods),
        )


@pytest.mark.slow
@needs_the_parser
def test_plain_lines_are_read_as_the_parser_reads_them():
    """The parser's own mistakes apart, of which a hundred lines have one: AGREES says so."""
    from foon_kg.language.recipe_lines import read_fully

    lines = list(dict.fromkeys(plain_lines(250)))
    quick = {line: answer for line in lines if (answer := read_quickly(line)) is not None}
    assert len(quick) > 0.7 * len(lines)
    differ = [line for line, answer in quick.items() if replace(read_fully(line), confidence=AGREES) != answer]
    assert len(differ) <= 2 * (1 - AGREES) * len(quick), differ


@needs_the_parser
@pytest.mark.parametrize(
    "line",
    [
        "2 cups finely chopped red onion",
        "1 (14 ounce) can cannellini beans, drained and rinsed",
        "3 cloves garlic, minced",
        "1 1/2 tbsps chopped fresh basil",
        "2 cups frozen peas",
        "1/2 cup low-sodium chicken broth, divided",
        "2 russet potatoes, peeled and cut into 1/2 inch cubes",
        "1 pound ground beef, crumbled",
        "1 teaspoon fish sauce (optional)",
        "Roasted peanuts (optional)",
        "12 ounces sifted self-rising flour",
    ],
)
def test_lines_of_every_shape_are_read_alike(line):
    from foon_kg.language.recipe_lines import read_fully

    assert read_quickly(line) == replace(read_fully(line), confidence=AGREES)


@pytest.mark.parametrize(
    "line",
    [
        "",
        "For the dressing:",
        "salt and pepper to taste",
        "1 cup sugar or honey",
        "2 cloves, ground",  # the spice
        "2 cloves onion",
        "1 cup medium salsa",
        "1 cup pasta, al gusto",
        "2-3 green onions, sliced",
        "1 (8 ounce) orange",
        "juice of 1 lemon",
        "1 cup qwxyz",
        "boiled smoked ham",  # which was first?
        "1 cup zucchini, chopped, if you like",
        "cups sugar",
        "1 zucchinis 2 onions",
    ],
)
def test_a_line_with_any_doubt_is_left_to_the_parser(line):
    assert read_quickly(line) is None


def test_ground_beef_stays_whole_and_ground_cumin_does_not():
    assert read_quickly("1 pound ground beef").object == "ground beef"
    cumin = read_quickly("1 teaspoon ground cumin")
    assert (cumin.object, cumin.state) == ("cumin", "ground")


@given(st.text(max_size=40) | st.sampled_from(WORDINGS))
def test_any_text_is_read_or_left(text):
    answer = read_quickly(text)
    assert answer is None or (answer.text == text and answer.object)


@given(st.sampled_from(food_groups().foods), st.sampled_from(STATES), st.sampled_from(UNITS), st.sampled_from(NUMBERS))
def test_what_is_read_is_what_was_written(food, state, unit, number):
    answer = read_quickly(f"{number} {unit} {food}, {state}")
    if answer is not None and answer.object is not None:  # “egg beaters” are a tool, too
        told = {singular(word) for text in (answer.object, *answer.states) for word in words(text)}
        assert set(map(singular, words(food))) <= told
        assert food.endswith(answer.object) or canonical(food).endswith(
            canonical(answer.object)
        )  # a pea is a green one
        # “boiled egg, chopped” is both; what passes (drained) is told only where nothing else is
        assert in_turn(answer.state)[-1] == state or (state in word_list("passes") and answer.states)


@pytest.mark.parametrize(
    ("line", "amount"),
    [
        ("2-3 cups of very good stock", ("2-3", "cups")),
        ("2 to 3 tablespoons oil, warmed through", ("2-3", "tablespoons")),
        ("1 1/2 teaspoon salt, to taste", ("3/2", "teaspoons")),
        ("1-1/2 cups flour (sifted twice)", ("3/2", "cups")),
        ("1\u00bd cups milk, if you like", ("3/2", "cups")),
        ("3\u20444 cup milk, if you like", ("3/4", "cups")),
        ("1 (8 ounce) package cream cheese, at room temperature", ("1", "package")),
        ("1.5 kg beef for stewing", ("3/2", "kg")),
        ("2-3 large eggs from the farm", ("2-3", "")),
        ("salt as you like it", ("", "")),
        ("7-up soda", ("", "")),
        ("100% pure orange juice", ("", "")),
        ("1,000 g flour", ("", "")),
        ("", ("", "")),
    ],
)
def test_the_amount_in_front_of_a_line_that_is_not_plain(line, amount):
    assert amount_in_front(line) == amount


@needs_the_parser
@pytest.mark.parametrize("food", ["stock from last week", "oil (the good one)", "milk, if you like"])
@pytest.mark.parametrize("unit", ["cups", "tablespoons", "ounces"])
@pytest.mark.parametrize("quantity", ["2", "2-3", "1 1/2", "2 to 3", "\u00bd"])
def test_the_amount_in_front_is_the_one_that_the_parser_reads(quantity, unit, food):
    parsed = read_fully(f"{quantity} {unit} {food}")
    assert amount_in_front(f"{quantity} {unit} {food}") == (parsed.quantity, parsed.unit)
