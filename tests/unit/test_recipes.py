"""What people ask is read as they meant it, and whatever was decided on the way is said."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.knowledge import SeenAs, Vocabulary
from foon_kg.planning.recipes import IngredientWords, foods_named, read_recipe, recipe_files, recipe_of
from foon_kg.plans.kitchen import Kitchen

FOODS = (
    SeenAs("apple", "whole", made=0, used=1),
    SeenAs("garlic powder", "ground", made=0, used=1),
    SeenAs("olive oil", "liquid", made=1, used=9),
    SeenAs("olive oil", "solid", made=0, used=2),
    SeenAs("onion", "chopped", made=4, used=4),
    SeenAs("onion", "peeled", made=2, used=2),
    SeenAs("onion", "raw", made=0, used=1),
    SeenAs("onion", "whole", made=0, used=3),
    SeenAs("sauce", "thick liquid", made=1, used=1),
    SeenAs("stock", "", made=1, used=1),
)
WORDS = IngredientWords(Vocabulary(FOODS, (), ()), Kitchen.default())


@pytest.mark.parametrize(
    ("text", "amount", "food", "state"),
    [
        ("500 g onion", "500 g", "onion", "whole"),
        ("2 onions", "2", "onion", "whole"),
        ("2 large onions", "2", "onion", "large"),
        ("½ cup chopped onion", "½ cup", "onion", "chopped"),
        ("1 1/2 cups chopped onion", "1 1/2 cups", "onion", "chopped"),
        ("2 to 3 cups chopped onion", "2 to 3 cups", "onion", "chopped"),
        ("1 lb. chopped onion", "1 lb.", "onion", "chopped"),
        ("handful of chopped onion", "handful", "onion", "chopped"),
        ("a pinch of chopped onion", "a pinch", "onion", "chopped"),
        ("an ounce of chopped onion", "an ounce", "onion", "chopped"),
        ("slices of onion", "slices", "onion", "whole"),
        ("2 cups of dragon fruit", "2 cups", "dragon fruit", "whole"),
        ("2 cups dragon fruit, chopped", "2 cups", "dragon fruit", "chopped"),
        ("1 can green beans", "1 can", "green beans", "canned"),
        ("2 Tins of corn", "2 Tins", "corn", "canned"),
        ("1 can chopped tomatoes", "1 can", "tomatoes", "chopped"),
        ("1 can coconut milk", "1 can", "coconut milk", "liquid"),
        ("2 cups corn", "2 cups", "corn", "whole"),
        ("chopped onion", "", "onion", "chopped"),
        ("cream of onion", "", "onion", "cream of"),
    ],
)
def test_an_amount_is_no_state_and_no_part_of_a_name_and_is_kept(text, amount, food, state):
    wanted, notes = WORDS.read(text)
    assert (wanted.amount, wanted.object, wanted.state) == (amount, food, state)
    assert not any(note.endswith(" is left out") for note in notes)


def test_a_known_name_keeps_its_number():
    words = IngredientWords(Vocabulary((SeenAs("7 up", "liquid", made=0, used=1),), (), ()), Kitchen.default())
    assert words.read("7 up")[0] == RequiredIngredient("7 up", "liquid")


@pytest.mark.parametrize(
    ("text", "food", "state"),
    [
        ("chopped onion", "onion", "chopped"),
        ("Chopped Onions", "onion", "chopped"),
        ("onion, chopped", "onion", "chopped"),
        ("chopped white onion", "white onion", "chopped"),
        ("chopped dragon fruit", "dragon fruit", "chopped"),
        ("spiralized onion", "onion", "spiralized"),
        ("ground garlic powder", "garlic powder", "ground"),
        ("thick liquid sauce", "sauce", "thick liquid"),
    ],
)
def test_a_state_and_a_food_are_told_apart(text, food, state):
    assert WORDS.read(text) == (RequiredIngredient(food, state), ())


@pytest.mark.parametrize(
    ("text", "food", "state"),
    [
        ("olive oil", "olive oil", "liquid"),
        ("onions", "onion", "whole"),
        ("stock", "stock", "liquid"),
        ("dragon fruit", "dragon fruit", "whole"),
    ],
)
def test_a_food_without_a_state_is_taken_as_it_is_usually_sold_and_this_is_said(text, food, state):
    wanted, (note,) = WORDS.read(text)
    assert wanted == RequiredIngredient(food, state)
    assert note == f"“{food}” names no state: taken as {state}"


def test_of_several_states_the_last_processed_one_counts_and_the_others_are_named():
    wanted, (note,) = WORDS.read("peeled finely chopped raw onion")
    assert wanted == RequiredIngredient("onion", "chopped")
    assert "“peeled raw finely” is left out" in note


@pytest.mark.parametrize("text", ["", "  ", ","])
def test_an_empty_ingredient_is_refused(text):
    with pytest.raises(UsageError, match="an ingredient is empty"):
        WORDS.read(text)


SOME_WORDS = ["chopped", "raw", "onion", "olive", "oil", "finely", "whole", "thick", "liquid"]


@given(st.lists(st.sampled_from(SOME_WORDS), min_size=1, max_size=5))
def test_no_word_of_an_ingredient_is_lost_unsaid(words):
    wanted, notes = WORDS.read(" ".join(words))
    said = " ".join([wanted.object, wanted.state, *notes]).split()
    assert wanted.object
    assert wanted.state
    assert {word.strip("“”,:") for word in said} >= set(words)


def test_a_recipe_in_words_keeps_the_order_and_what_is_asked_twice():
    read = recipe_of("salad", ["chopped onion", "apple", "chopped onion"], WORDS)
    onion = RequiredIngredient("onion", "chopped")
    assert read.recipe == Recipe("salad", (onion, RequiredIngredient("apple", "whole"), onion))
    assert len(read.notes) == 1


def write(folder, name, value):
    path = folder / name
    path.write_text(value if isinstance(value, str) else json.dumps(value), encoding="utf-8")
    return path


def test_a_recipe_file_is_read_with_every_decision_noted(tmp_path):
    ingredients = [
        {"object": "onion", "state": "chopped"},
        {"object": " ", "state": "raw"},
        {"object": "olive oil", "state": ""},
        {"object": "onion", "state": "chopped"},
    ]
    path = write(tmp_path, "17.json", {"type": "salad", "ingredients": ingredients})
    read = read_recipe(path, WORDS)
    onion = RequiredIngredient("onion", "chopped")
    assert read.recipe == Recipe("salad", (onion, RequiredIngredient("olive oil", "liquid"), onion), id="17")
    assert read.notes == (
        f"{path}: ingredients[1]: “object” is empty; the ingredient is left out",
        f"{path}: ingredients[2]: “olive oil” names no state: taken as liquid",
    )


def test_a_recipe_file_says_how_much_in_fields_and_in_lines(tmp_path):
    onion = {"object": "onion", "state": "chopped"}
    fields = [
        onion | {"amount": "1 cup"},
        onion | {"quantity": 2.5, "unit": "kg"},
        onion | {"quantity": "3", "unit": ""},
        onion | {"quantity": 1234567, "unit": "g"},
        onion | {"quantity": 2.0},
    ]
    path = write(tmp_path, "17.json", {"type": "salad", "ingredients": [*fields, "200 g chopped onion", onion, " "]})
    read = read_recipe(path, WORDS)
    assert [one.amount for one in read.recipe.ingredients] == ["1 cup", "2.5 kg", "3", "1234567 g", "2", "200 g", ""]
    assert set(read.recipe.ingredients) == {RequiredIngredient("onion", "chopped")}
    assert read.notes == (f"{path}: ingredients[7]: the line is empty; the ingredient is left out",)
    assert foods_named(path) == (("onion",) * 6, ("200 g chopped onion", " "))


def test_the_recipe_of_a_plan_result_is_a_recipe_file_too(tmp_path):
    path = write(tmp_path, "r.json", {"id": "a", "title": "B", "dish_type": "soup", "ingredients": []})
    assert read_recipe(path, WORDS).recipe == Recipe("soup", (), id="a", title="B")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ('{\n"type": "salad",\n}', r"bad\.json:3: not JSON"),
        ("[]", r"bad\.json: expected a JSON object"),
        ('{"ingredients": []}', "“type” is missing"),
        ('{"type": "salad", "ingredients": [5]}', r"ingredients\[0\]: expected a JSON object"),
    ],
)
def test_a_file_that_is_no_recipe_is_refused_with_its_place(tmp_path, content, message):
    with pytest.raises(ReadError, match=message) as caught:
        read_recipe(write(tmp_path, "bad.json", content), WORDS)
    assert caught.value.hint


def test_a_recipe_that_is_not_utf8_is_refused(tmp_path):
    path = tmp_path / "latin.json"
    path.write_bytes('{"title": "Crème"}'.encode("latin-1"))
    with pytest.raises(ReadError, match="not UTF-8"):
        read_recipe(path, WORDS)


def test_a_folder_stands_for_its_recipes_by_name_and_paths_keep_their_order(tmp_path):
    for name in ("b.json", "a.json", "c.txt"):
        write(tmp_path, name, {})
    last = write(tmp_path, "a.json", {})
    assert [path.name for path in recipe_files([tmp_path, last])] == ["a.json", "b.json", "a.json"]


def test_a_path_that_is_not_there_or_has_no_recipes_is_wrong_usage(tmp_path):
    with pytest.raises(UsageError, match="no file or folder"):
        list(recipe_files([tmp_path / "nowhere"]))
    with pytest.raises(UsageError, match="has no recipes"):
        list(recipe_files([tmp_path]))


def test_a_word_that_is_misspelled_is_told_with_what_may_be_meant():
    _, notes = WORDS.read("choped oinon")
    assert notes[-1] == "no food is called “choped oinon”: did you mean “chopped onion”?"
    assert WORDS.read("1 tbsp buter")[1][-1] == "no food is called “buter”: did you mean “butter”?"
    assert not any("taken at its word" in note for note in WORDS.read("2 kohlrabis")[1])
    _, notes = WORDS.read("slised tomatoes")
    assert notes[-1] == "“slised tomatoes” is taken at its word; if you mean “sliced tomatoes”, write that"
    _, notes = WORDS.read("xyzzy")
    assert notes[-1] == "no food is called “xyzzy”, nor anything like it"
    assert not any("mean" in note for note in WORDS.read("chopped onion")[1])


def test_a_recipe_of_which_nothing_is_known_is_refused():
    with pytest.raises(UsageError, match="nothing is known of what is asked") as refused:
        recipe_of("salad", ["choped oinon", "xyzzy"], WORDS)
    assert "chopped onion" in str(refused.value)
    assert recipe_of("salad", ["xyzzy", "olive oil"], WORDS).recipe.ingredients


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("choped onion", ": did you mean “chopped”?"),
        ("onion, mincd", ": did you mean “minced”?"),
        ("xqz onion", ", nor anything like it"),
        ("please make something nice with onion", ", nor anything like it"),
        ("chopped onion", ""),
        ("baby onion", ""),
    ],
)
def test_a_state_that_nobody_knows_is_told_with_what_may_be_meant(text, meant):
    _, notes = WORDS.read(text)
    told = [note for note in notes if note.startswith("no state is called")]
    assert len(told) == bool(meant)
    assert all(note.endswith(f"”{meant}") for note in told)


@pytest.mark.parametrize(
    ("text", "food", "part"),
    [
        ("powdered sugar, for the glaze", "powdered sugar", "glaze"),
        ("salt, for sprinkling on top", "salt", "sprinkling"),
        ("chopped onion, to serve", "onion", "serving"),
        ("salt", "salt", ""),
    ],
)
def test_what_a_food_is_for_is_no_part_of_its_name_and_is_kept(text, food, part):
    wanted, _ = WORDS.read(text)
    assert (wanted.object, wanted.part) == (food, part)
