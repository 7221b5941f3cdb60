import subprocess
import sys
from dataclasses import replace

import pytest
from extras import needs, reads_lines_fully
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from foon_kg.language import recipe_lines
from foon_kg.language.recipe_lines import LineReader, RecipeLine, read_fully, read_recipe_lines
from foon_kg.model.errors import FoonError

# looked for, not imported: an import before ours would try to download a tagger
pytestmark = [needs("ingredient_parser"), reads_lines_fully]


def read(line):
    return read_fully(line)


@pytest.mark.parametrize(
    ("line", "food", "state", "quantity", "unit"),
    [
        ("2 cups finely chopped red onion", "red onion", "finely chopped", "2", "cups"),
        ("3 cloves garlic, minced", "garlic", "minced", "3", "cloves"),
        ("2 large eggs, beaten", "eggs", "beaten", "2", ""),
        ("1 medium carrot, peeled and grated", "carrot", "grated", "1", ""),
        ("1 cup shredded cheddar cheese", "cheddar cheese", "shredded", "1", "cup"),
        ("1/4 cup half-and-half", "half-and-half", "", "1/4", "cups"),
        ("1 1/2 teaspoons ground cumin", "cumin", "ground", "3/2", "teaspoons"),
        ("1 cup powdered sugar, sifted", "powdered sugar", "sifted", "1", "cup"),
        ("1 can diced tomatoes, drained", "tomatoes", "drained", "1", "can"),
        ("1 can diced tomatoes", "tomatoes", "canned", "1", "can"),
        ("8 eggs, hard-boiled and chopped", "eggs", "boiled, chopped", "8", ""),
        ("1 cup bean sprouts, chopped", "bean sprouts", "chopped", "1", "cup"),
        ("1 lb ground beef", "ground beef", "", "1", "lb"),
        ("1 head romaine lettuce, torn into bite-size pieces", "romaine lettuce", "torn", "1", "head"),
        ("juice of 1 lemon", "lemon", "juice", "1", ""),
        ("juice of half a lemon", "lemon", "juice", "1/2", ""),
        ("juice from 1/2 a lime", "lime", "juice", "1/2", ""),
        ("half an onion, chopped", "onion", "chopped", "1/2", ""),
    ],
)
def test_a_line_becomes_food_state_quantity_and_unit(line, food, state, quantity, unit):
    answer = read(line)
    assert (answer.object, answer.state, answer.quantity, answer.unit) == (food, state, quantity, unit)
    assert answer.text == line
    assert answer.confidence > 0.8


@pytest.mark.parametrize(
    ("line", "food"),
    [
        ("1 1/2 cups glutinous (sweet) rice", "glutinous rice"),
        ("1 cup sticky (glutinous) rice flour", "sticky rice flour"),
        ("8 ounces reshteh (Persian noodles)", "reshteh"),
    ],
)
def test_what_stands_in_brackets_within_a_name_takes_none_of_it_away(line, food):
    answer = read(line)
    assert answer.object == food
    assert line[line.index("(") : line.index(")") + 1] in answer.left_over


def test_of_several_brackets_none_stays_in_the_name():
    answer = read("2 cups sweet rice (glutinous) (short grain), rinsed")
    assert (answer.object, answer.states) == ("sweet rice", ("rinsed",))
    assert {"(glutinous)", "(short grain)"} <= set(answer.left_over)


@pytest.mark.parametrize(
    ("line", "food", "state"),
    [
        ("4 fried eggs, to serve", "eggs", "fried"),
        ("Fried eggs and avocado slices, to serve", "eggs", "fried"),
        ("2 cups fried rice", "fried rice", ""),  # is made of more than rice
    ],
)
def test_a_dish_that_is_one_food_cooked_is_that_food_in_a_state(line, food, state):
    assert (read(line).object, read(line).state) == (food, state)


def test_all_states_are_kept_in_their_order():
    assert read("1 avocado, pitted, peeled and mashed").states == ("pitted", "peeled", "mashed")
    assert read("1 package frozen chopped spinach, thawed").states == ("frozen", "chopped", "thawed")


def test_states_without_a_comma_are_all_kept_and_the_first_was_done_last():
    assert read("1/2 cup chopped peeled seeded cantaloupe").states == ("seeded", "peeled", "chopped")


@pytest.mark.parametrize(
    ("line", "food"),
    [
        ("2/3 cup whole wheat couscous", "whole wheat couscous"),
        ("3 tablespoons reduced fat peanut butter", "reduced fat peanut butter"),
        ("2 cups reduced-sodium chicken broth", "reduced-sodium chicken broth"),
        ("2 cups multi-grain penne pasta", "multi-grain penne pasta"),
        ("6 white potatoes", "white potatoes"),
        ("1 pound ground chicken, crumbled", "ground chicken"),
    ],
)
def test_words_of_a_name_are_no_states(line, food):
    assert read(line).object == food


def test_what_is_divided_is_used_twice_and_not_cut():
    answer = read("4 tablespoons butter, melted, divided")
    assert (answer.states, answer.left_over) == (("melted",), ("divided",))


def test_the_size_is_kept():
    assert read("2 large eggs, beaten").size == "large"


def test_a_range_is_kept_as_one():
    assert read("2-3 green onions, thinly sliced").quantity == "2-3"


@pytest.mark.parametrize("rest", ["cups chopped onion", "cup sugar", "large eggs, beaten", "(14 ounce) cans tomatoes"])
@pytest.mark.parametrize(
    ("number", "quantity"), [("3", "3"), ("1 1/2", "3/2"), ("1/4", "1/4"), ("1", "1"), ("12", "12")]
)
def test_a_line_that_differs_only_in_its_number_is_read_as_if_it_came_alone(rest, number, quantity):
    alone = recipe_lines._parse(f"{number} {rest}")
    answer = read_fully(f"{number} {rest}")
    assert replace(answer, confidence=0) == replace(alone, confidence=0)
    assert answer.quantity == quantity


@pytest.mark.slow
def test_a_reader_of_collections_reads_as_line_by_line(monkeypatch):
    """In two processes, for what is not plain; every line of the first collection comes again in the second."""
    monkeypatch.setattr(recipe_lines, "_MANY", 5)
    lines = ["2 cups chopped onion", "1 cup sugar or honey", "***", "6 stems thyme", "1 firm apple, peeled"]
    lines += ["1 lime sorbet", "2 cups cold water to cover", "4 pods black cardamom", "***", "1 cup sugar or honey"]
    with LineReader(jobs=2) as reader:
        assert reader.read(lines) == read_recipe_lines(lines)
        assert reader.read(lines[::-1]) == read_recipe_lines(lines[::-1])


def test_a_process_that_is_ended_is_told(monkeypatch):
    monkeypatch.setattr(recipe_lines, "_MANY", 1)
    monkeypatch.setattr(recipe_lines, "read_fully", eval)  # so that a line can end the process that reads it
    with LineReader(jobs=2) as reader, pytest.raises(FoonError, match="ended from outside"):
        reader.read(["__import__('os')._exit(1)"])


def test_foods_in_place_of_each_other_are_no_two_foods():
    answer = read("1 cup sugar or honey")
    assert answer.others == ("honey",)
    assert [one.object for one in answer.foods] == ["sugar"]


@pytest.mark.parametrize(
    ("line", "foods"),
    [
        ("salt and pepper, to taste", [("salt", ""), ("pepper", "")]),
        ("salt and freshly ground black pepper", [("salt", ""), ("black pepper", "ground")]),
        ("salt, pepper and oil", [("salt", ""), ("pepper", ""), ("oil", "")]),
        ("lettuce, tomato and onion for serving", [("lettuce", ""), ("tomato", ""), ("onion", "")]),
        ("zest and juice of 1 lemon", [("lemon", "zest"), ("lemon", "juiced")]),
        ("1 lemon, zested and juiced", [("lemon", "zested"), ("lemon", "juiced")]),
        ("4 cups chicken or vegetable stock", [("chicken stock", "")]),
        ("1/2 cup half and half", [("half and half", "")]),
        ("To serve: cranberry sauce and bread dumplings", [("cranberry sauce", ""), ("bread dumplings", "")]),
        ("2 nests medium egg noodles", [("egg noodles", "")]),
    ],
)
def test_a_line_asks_for_each_of_its_foods(line, foods):
    (answer,) = read_recipe_lines([line])
    assert [(one.object, one.state) for one in answer.foods] == foods


@pytest.mark.parametrize(
    ("line", "food", "state"),
    [
        ("Hot cooked rice, for serving", "rice", "cooked"),
        ("hot mashed potatoes, for serving", "potatoes", "mashed"),
        ("1/2 cup reserved pasta cooking water", "pasta cooking water", ""),
        ("crusty bread, for serving", "bread", ""),
        ("2 sprigs thyme", "thyme", "sprig"),
        ("1/2 tsp cloves", "cloves", "ground"),
        ("1 teaspoon ginger", "ginger", "ground"),
        ("1 tsp ginger, grated", "ginger", "grated"),
        ("4 cloves", "cloves", ""),
        ("1 tbsp ginger", "ginger", ""),
        ("1/4 cup extra virgin olive oil", "extra virgin olive oil", ""),
        ("hot sauce", "hot sauce", ""),
    ],
)
def test_a_food_is_called_by_no_word_that_says_only_how_it_is(line, food, state):
    (answer,) = read_recipe_lines([line])
    assert (answer.object, answer.state) == (food, state)


def test_what_is_not_understood_is_kept():
    assert "at room temperature" in read("6 ounces cream cheese, at room temperature").left_over
    assert any("14 ounce" in part for part in read("1 (14 ounce) can diced tomatoes").left_over)


@pytest.mark.parametrize("line", ["For the dressing:", "12", "***", ""])
def test_a_line_without_a_food_is_answered_and_kept(line):
    answer = read(line)
    assert answer.object is None
    assert answer.text == line
    assert " ".join(answer.left_over) == line


def test_every_line_has_its_answer_in_order():
    lines = ["1 onion, diced", "***", "salt", "1 onion, diced"]
    answers = read_recipe_lines(lines)
    assert [answer.text for answer in answers] == lines
    assert answers[0] == answers[3]


@settings(max_examples=40, suppress_health_check=[HealthCheck.too_slow], deadline=None)
@given(st.text(max_size=30))
def test_any_text_is_answered(text):
    answer = read(text)
    assert isinstance(answer, RecipeLine)
    assert answer.text == text
    assert answer.object is None or answer.object


@pytest.mark.parametrize("line", ["inf", "infinity", "1/0 eggs of nobody", "0/0 cups onion"])
def test_what_only_looks_like_a_number_ends_no_reading(line):
    answer = read_fully(line)
    assert answer.text == line
    assert answer.object or answer.left_over


def test_nan_is_a_bread():
    answer = read_fully("2 Nan, sliced")
    assert (answer.text, answer.object, answer.state, answer.quantity) == ("2 Nan, sliced", "naan", "sliced", "2")


@pytest.mark.slow
def test_nothing_is_downloaded():
    program = (
        "import urllib.request, nltk\n"
        "def refuse(*a, **k): raise SystemExit('tried to download')\n"
        "nltk.download = nltk.downloader.download = urllib.request.urlopen = refuse\n"
        "from foon_kg.language.recipe_lines import read_recipe_lines\n"
        "print(read_recipe_lines(['1 onion, diced'])[0].object)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "onion", done.stdout + done.stderr


def test_a_utensil_is_no_food():
    skewers, skewered = read_recipe_lines(["12 bamboo skewers", "1 lb chicken breast, cut into strips"])
    assert (skewers.object, skewers.left_over) == (None, ("bamboo skewers",))
    assert skewered.object == "chicken breast"
