"""Collections of recipes are read whole or refused, and whatever is odd in them is told with its place."""

from __future__ import annotations

import json
import subprocess
import sys

import pandas as pd
import pytest

from foon_kg.language.collection import CollectionReader, classes_of
from foon_kg.loaders.notices import NoticeKind, Severity
from foon_kg.loaders.recipe1m import MOST_INGREDIENTS
from foon_kg.loaders.recipe_collections import RecipeCollections
from foon_kg.loaders.recipe_tables import MOST_COLUMNS
from foon_kg.model.collected import LONGEST_ID, LONGEST_LINE, CollectedLine
from foon_kg.model.errors import ReadError, UsageError


def texts(*words):
    return [{"text": word} for word in words]


def recipe(recipe_id="a1", **more):
    return {"id": recipe_id, "title": "Onion Soup", "ingredients": texts("2 onions", "salt"), **more}


def detected(recipe_id="a1", valid=(True, True), foods=("onion", "salt")):
    return {"id": recipe_id, "valid": list(valid), "ingredients": texts(*foods)}


@pytest.fixture
def folder(tmp_path):
    """Write a folder of Recipe1M+ with these lists; bytes are written as they are."""

    def write(layer1, beside=None, nutrition=None):
        files = {
            "layer1.json": layer1,
            "det_ingrs.json": beside,
            "recipes_with_nutritional_info.json": nutrition,
        }
        for name, content in files.items():
            if content is not None:
                raw = content if isinstance(content, bytes) else json.dumps(content).encode()
                (tmp_path / name).write_bytes(raw)
        return tmp_path

    return write


def read(*paths):
    """Return the recipes and the notices; the check must say how many there are."""
    notices = []
    with RecipeCollections(paths, notices.append) as collections:
        count = collections.check()
        recipes = list(collections)
    assert count == len(recipes)
    return recipes, notices


def test_the_three_files_are_one_recipe_whatever_their_order(folder):
    amounts = [{"id": "a1", "ingredients": texts("x", "y"), "quantity": texts("2", "1"), "unit": texts("", "pinch")}]
    layer1 = [recipe("b2", partition="val", url="http://x.example"), recipe("a1")]
    (second, first), notices = read(
        folder(layer1, [detected("a1"), detected("b2", foods=("shallot", "salt"))], amounts)
    )
    assert first.lines == (
        CollectedLine("2 onions", "onion", "", "2", ""),
        CollectedLine("salt", "salt", "", "1", "pinch"),
    )
    assert second.lines == (CollectedLine("2 onions", "shallot"), CollectedLine("salt", "salt"))
    assert (second.partition, second.url, second.title) == ("val", "http://x.example", "Onion Soup")
    assert notices == []


def test_a_food_that_is_not_valid_is_not_believed(folder):
    ([read_recipe], _) = read(folder([recipe()], [detected(valid=(False, True))]))
    assert [line.detected for line in read_recipe.lines] == [None, "salt"]


def test_without_the_files_beside_only_the_lines_are_known(folder):
    ([read_recipe], notices) = read(folder([recipe()]))
    assert read_recipe.lines == (CollectedLine("2 onions"), CollectedLine("salt"))
    assert notices == []


def test_a_file_beside_with_another_number_of_lines_is_told_and_not_used(folder):
    ([read_recipe], [notice]) = read(folder([recipe()], [detected(valid=(True,), foods=("onion",))]))
    assert notice.kind is NoticeKind.LISTS_DIFFER
    assert [line.detected for line in read_recipe.lines] == [None, None]


@pytest.mark.parametrize(
    ("bad", "kind"),
    [
        ("text", NoticeKind.BAD_FIELD),
        ([1], NoticeKind.BAD_FIELD),
        ({"title": "no id", "ingredients": texts("x")}, NoticeKind.BAD_FIELD),
        (recipe("", title="empty id"), NoticeKind.BAD_FIELD),
        (recipe(7), NoticeKind.BAD_FIELD),
        (recipe("x", title=["Soup"]), NoticeKind.BAD_FIELD),
        (recipe("x", ingredients="salt"), NoticeKind.BAD_FIELD),
        (recipe("x", ingredients=[{"text": 3}]), NoticeKind.BAD_FIELD),
        (recipe("x", ingredients=[]), NoticeKind.NO_INGREDIENTS),
        (recipe("x", ingredients=texts(*["salt"] * 10_000)), NoticeKind.TOO_MANY_INGREDIENTS),
        (recipe("a1", title="the same again"), NoticeKind.SAME_RECIPE),
        (recipe("x", title="Soup \ud83d"), NoticeKind.BAD_FIELD),
        (recipe("x\ud83d"), NoticeKind.BAD_FIELD),
        (recipe("x", ingredients=texts("\ude0b salt")), NoticeKind.BAD_FIELD),
    ],
)
def test_an_element_that_is_no_recipe_is_rejected_with_its_place_and_the_others_stay(folder, bad, kind):
    (recipes, [notice]) = read(folder([recipe("a1"), bad, recipe("z9")]))
    assert [r.id for r in recipes] == ["a1", "z9"]
    assert (notice.kind, notice.severity) == (kind, Severity.REJECTED)
    assert notice.file.endswith("layer1.json: element 2")


def test_just_as_many_ingredients_as_any_dish_has_are_fine(folder):
    (recipes, notices) = read(folder([recipe("x", ingredients=texts(*["salt"] * MOST_INGREDIENTS))]))
    assert len(recipes[0].lines) == MOST_INGREDIENTS
    assert notices == []


GOOD = json.dumps([recipe("a1"), recipe("b2")]).encode()


@pytest.mark.parametrize(
    ("raw", "place", "hint"),
    [
        (GOOD[:-1], "element 3", "ends in the middle"),
        (GOOD[:-20], "element 2", "ends in the middle"),
        (GOOD.replace(b"Onion Soup", b"Onion\xff", 1), ":1: byte 29 (0xff) is not UTF-8", "UTF-8"),
        (b'{"id": 1}', ":1: no JSON list", "one list"),
        (b"", "it is empty", "one list"),
        (GOOD.decode().encode("utf-16"), ":1: byte 0 (0xff) is not UTF-8", "Save it as UTF-8"),
        (b"[1, 2,, 3]", "element 3", "Mend"),
        (b"[" * 200_000, "element 1: the value that begins here is nested too deeply", "Mend"),
        (b'[1,\n{"id": ' + b"9" * 10_000 + b"}]", ":2: element 2: in the value", "Mend"),
        (b'[{"id": "a1"}] []', "something follows", "Mend"),
    ],
)
def test_a_broken_file_is_refused_before_anything_is_answered(folder, raw, place, hint):
    with RecipeCollections([folder(raw)], lambda _: None) as collections, pytest.raises(ReadError) as told:
        collections.check()
    assert "layer1.json" in told.value.message
    assert place in told.value.message
    assert hint in told.value.hint


@pytest.mark.parametrize("name", ["det_ingrs.json", "recipes_with_nutritional_info.json"])
def test_a_broken_file_beside_is_refused_as_well(folder, name):
    path = folder([recipe()])
    (path / name).write_bytes(b'[{"id": "a1", ')
    with RecipeCollections([path], lambda _: None) as collections, pytest.raises(ReadError, match=name):
        collections.check()


def test_a_byte_order_mark_does_no_harm(folder):
    (recipes, _) = read(folder(b"\xef\xbb\xbf" + GOOD))
    assert len(recipes) == 2


@pytest.mark.parametrize("title", ["", "  ", "!!! 123"])
def test_a_title_without_words_is_told_and_the_recipe_kept(folder, title):
    ([kept], [notice]) = read(folder([recipe(title=title)]))
    assert kept.title == title
    assert notice.kind is NoticeKind.TITLE_WITHOUT_WORDS
    assert notice.severity is not Severity.REJECTED
    assert notice.file.endswith("layer1.json: element 1")


def test_of_what_stands_beside_twice_the_last_counts(folder):
    ([kept], _) = read(folder([recipe()], [detected(foods=("leek", "salt")), detected()]))
    assert [line.detected for line in kept.lines] == ["onion", "salt"]


def test_names_that_carry_cypher_or_markup_stay_as_they_are(folder):
    title = "Soup'}) DETACH DELETE n //<b>"
    ([read_recipe], notices) = read(folder([recipe(title=title, ingredients=texts("<i>salt</i>"))]))
    assert read_recipe.title == title
    assert read_recipe.lines[0].text == "<i>salt</i>"
    assert notices == []


QUERY = {"id": "q1", "type": "salad", "ingredients": [{"object": "onion", "state": "chopped"}, "olive oil"]}
LINES = (CollectedLine("chopped onion", "onion", "chopped"), CollectedLine("olive oil"))


def test_our_own_recipe_file_json_lines_csv_and_parquet_give_the_same(tmp_path):
    row = {**QUERY, "ingredients": json.dumps(QUERY["ingredients"])}
    (tmp_path / "one.json").write_text(json.dumps(QUERY), encoding="utf-8")
    (tmp_path / "list.json").write_text(json.dumps([QUERY]), encoding="utf-8")
    (tmp_path / "lines.jsonl").write_text(json.dumps(QUERY) + "\n\n", encoding="utf-8")
    pd.DataFrame([row]).to_csv(tmp_path / "table.csv", index=False)
    pd.DataFrame([row]).to_parquet(tmp_path / "table.parquet", index=False)
    for path in sorted(tmp_path.iterdir()):
        ([read_recipe], notices) = read(path)
        assert (read_recipe.id, read_recipe.dish_type, read_recipe.lines) == ("q1", "salad", LINES), path
        assert notices == []


@pytest.mark.parametrize("cell", ["2 onions|salt", "2 onions; salt", "2 onions\nsalt\n", '["2 onions", "salt"]'])
def test_a_cell_of_a_table_lists_ingredients_in_several_ways(tmp_path, cell):
    pd.DataFrame([{"title": "Onion Soup", "ingredients": cell}]).to_csv(tmp_path / "t.csv", index=False)
    ([read_recipe], _) = read(tmp_path / "t.csv")
    assert [line.text for line in read_recipe.lines] == ["2 onions", "salt"]
    assert read_recipe.id == "t-1"


@pytest.mark.parametrize(
    ("columns", "steps"),
    [
        (("title", "ingredients", "directions", "link"), '["Chop the onions.", "Boil them."]'),  # RecipeNLG
        (("name", "ingredients", "steps", "link"), "['Chop the onions.', 'Boil them.']"),  # food.com
        (("Title", " Ingredients", "Instructions", "URL"), "Chop the onions.\nBoil them."),
    ],
)
def test_columns_of_public_collections_are_known_by_their_own_names(tmp_path, columns, steps):
    values = ("Onion Soup", "['2 onions', \"baker's salt\"]", steps, "https://example.org/soup")
    pd.DataFrame([dict(zip(columns, values, strict=True))]).to_csv(tmp_path / "t.csv", index=False)
    ([recipe], notices) = read(tmp_path / "t.csv")
    assert notices == []
    assert (recipe.title, recipe.url) == ("Onion Soup", "https://example.org/soup")
    assert [line.text for line in recipe.lines] == ["2 onions", "baker's salt"]
    assert recipe.instructions == ("Chop the onions.", "Boil them.")


@pytest.mark.parametrize(
    "cell", ["['2 onions'", "[" * 5_000, "[__import__('os').getcwd()]", "['a', 1]", "['" + "a" * 200_000]
)
def test_a_cell_that_writes_no_list_is_told(tmp_path, cell):
    pd.DataFrame([{"title": "Onion Soup", "ingredients": cell}]).to_csv(tmp_path / "t.csv", index=False)
    (recipes, [notice]) = read(tmp_path / "t.csv")
    assert recipes == []
    assert "“ingredients” is no list" in notice.message


def test_an_ingredient_without_a_name_is_left_out_and_told(tmp_path):
    wanted = [{"object": "", "state": "whole"}, {"object": "salt"}]
    (tmp_path / "r.json").write_text(json.dumps({"type": "soup", "ingredients": wanted}), encoding="utf-8")
    ([read_recipe], [notice]) = read(tmp_path / "r.json")
    assert [line.detected for line in read_recipe.lines] == ["salt"]
    assert (notice.kind, notice.severity) == (NoticeKind.MISSING_NAME, Severity.ASSUMED)
    assert "ingredients[0]" in notice.message


def test_of_two_recipes_with_one_id_in_two_files_the_first_counts(tmp_path):
    for name, title in (("a.json", "first"), ("b.json", "second")):
        (tmp_path / name).write_text(json.dumps({**QUERY, "title": title}), encoding="utf-8")
    ([read_recipe], [notice]) = read(tmp_path)
    assert read_recipe.title == "first"
    assert notice.kind is NoticeKind.SAME_RECIPE
    assert "b.json" in notice.file


@pytest.mark.parametrize(
    ("name", "raw"),
    [
        ("r.json", b"{"),
        ("r.json", b"\xff{"),
        ("r.jsonl", b'{"ingredients": ["x"]}\n{'),
        ("r.jsonl", b'{"ingredients": ["x"]}\n\xff'),
        ("r.json", b'{"a":' * 100_000),
        ("r.jsonl", b"[" * 100_000),
        ("r.jsonl", b"9" * 10_000),
        ("r.csv", b""),
        ("r.csv", b"title,ingredients\n\xff,x\n"),
        ("r.csv", b'title,ingredients\na,b,c\n"d'),
        ("r.parquet", b"PAR1 is not enough"),
    ],
)
def test_a_broken_table_is_an_error_that_names_the_file(tmp_path, name, raw):
    (tmp_path / name).write_bytes(raw)
    with RecipeCollections([tmp_path / name], lambda _: None) as collections, pytest.raises(ReadError, match=name):
        collections.check()


def test_a_line_that_is_no_text_is_named_though_the_lines_before_it_were_read_with_it(tmp_path):
    (tmp_path / "r.jsonl").write_bytes(b'{"ingredients": ["salt"]}\n' * 3 + b'{"ingredients": ["\xff"]}\n')
    with pytest.raises(ReadError, match=r"r\.jsonl:4: not UTF-8"):
        read(tmp_path / "r.jsonl")


def test_a_dish_type_that_there_is_none_is_told_and_the_title_counts(tmp_path):
    (tmp_path / "r.json").write_text(json.dumps({**QUERY, "type": "sushi", "title": "Rice Salad"}), encoding="utf-8")
    ([kept], [notice]) = read(tmp_path / "r.json")
    assert [dish.name for dish in classes_of(kept)] == ["salad", "rice"]
    assert (notice.kind, notice.severity) == (NoticeKind.ODD_CLASS, Severity.ASSUMED)
    assert "sushi" in notice.message


@pytest.mark.parametrize("wanted", [{"object": 5}, {"object": ["salt"]}, {"text": True}])
def test_a_food_of_another_type_than_text_is_left_out_and_told(tmp_path, wanted):
    (tmp_path / "r.json").write_text(json.dumps({**QUERY, "ingredients": [wanted, "salt"]}), encoding="utf-8")
    ([kept], [notice]) = read(tmp_path / "r.json")
    assert [line.text for line in kept.lines] == ["salt"]
    assert notice.kind is NoticeKind.MISSING_NAME


def test_an_id_longer_than_any_is_rejected_as_no_index_could_hold_it(folder):
    (recipes, [notice]) = read(folder([recipe("r" * (LONGEST_ID + 1)), recipe("s" * LONGEST_ID)]))
    assert [len(kept.id) for kept in recipes] == [LONGEST_ID]
    assert (notice.kind, notice.severity) == (NoticeKind.ODD_NAME, Severity.REJECTED)


@pytest.mark.parametrize("lines", [("salt" * LONGEST_LINE, "salt"), ("salt", "salt" * LONGEST_LINE)])
def test_a_line_longer_than_any_is_told_and_kept_unread(folder, lines):
    text, food = lines
    path = folder([recipe(ingredients=texts(text))], [detected(valid=(True,), foods=(food,))])
    ([kept], [notice]) = read(path)
    assert notice.kind is NoticeKind.LONG_CELL
    (understood,) = CollectionReader({}).understand([kept])
    assert (understood.ingredients, understood.left_over) == ((), (text,))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('title,ingredients\nSoup,salt\nPie,"2 cups\n', ":3: a quote begins here and does not end"),
        ("title,ingredients\nSoup,salt\nPie,2 cups, water\n", ":3: 3 cells under 2 columns"),
        ('title,ingredients\nSoup,"salt\nwater"\n\nPie,"2 cups\n', ":5: a quote begins here and does not end"),
        ('title,ingredients\nSoup,"salt\nwater"\n\nPie,2 cups, water\n', ":5: 3 cells under 2 columns"),
        ("", ": the file is empty"),
        ("ingredients" + ",c" * MOST_COLUMNS + "\nsalt\n", ": 1001 columns, and 1000 are the most"),
        ('"ingredients\n"' + ",c" * MOST_COLUMNS + "\nsalt\n", ": 1001 columns, and 1000 are the most"),
    ],
)
def test_a_broken_table_is_told_with_its_line(tmp_path, text, told):
    (tmp_path / "r.csv").write_text(text, encoding="utf-8")
    with pytest.raises(ReadError) as error, RecipeCollections([tmp_path / "r.csv"], lambda _: None) as collections:
        collections.check()
    assert error.value.message == f"{tmp_path / 'r.csv'}{told}"


def test_a_table_of_columns_that_is_too_wide_is_refused(tmp_path):
    pandas = pytest.importorskip("pandas")
    pandas.DataFrame([{f"c{n}": "salt" for n in range(MOST_COLUMNS + 1)}]).to_parquet(tmp_path / "r.parquet")
    with pytest.raises(ReadError, match="1001 columns"), RecipeCollections([tmp_path], lambda _: None) as collections:
        collections.check()


@pytest.mark.parametrize("name", ["missing", "empty", "notes.txt"])
def test_a_path_without_recipes_is_wrong_usage(tmp_path, name):
    (tmp_path / "empty").mkdir()
    (tmp_path / "notes.txt").write_text("x", encoding="utf-8")
    with pytest.raises(UsageError, match=name), RecipeCollections([tmp_path / name], lambda _: None) as collections:
        collections.check()


def test_the_program_reads_tables_though_it_starts_without_what_reads_them(tmp_path):
    (tmp_path / "r.csv").write_text("title,ingredients\nOnion soup,2 onions|salt\n", encoding="utf-8")
    program = [sys.executable, "-c", "from foon_kg.cli import main; main()"]
    command = [*program, "load", "recipes", str(tmp_path / "r.csv"), "--dry-run", "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stderr == ""
    assert json.loads(done.stdout) == {"recipes": 1, "rejected_recipes": 0}
