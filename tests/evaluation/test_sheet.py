"""The sheet that people fill: written, read back, and what is wrong on it told by file and line."""

from __future__ import annotations

import csv
import io

import pytest

from foon_kg.evaluation.figures import RecipeFigures
from foon_kg.evaluation.scores import LineScore, Reason
from foon_kg.evaluation.sheet import read_sheet, scored_by_both, write_sheet
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.errors import ReadError
from foon_kg.plans.progress import ProgressLine, ProgressStep

ONION, OIL = RequiredIngredient("onion", "chopped"), RequiredIngredient('oil, "virgin"', "liquid")
LINE = ProgressLine("onion", (ProgressStep(("whole",), "on", "board", "chop", "onion"),), "salad")
RECIPES = (
    RecipeFigures(
        Recipe("salad", (ONION, OIL), "one"),
        (LineScore(ONION, Reason.DONE, LINE), LineScore(OIL, Reason.NOT_IN_DISH, ProgressLine("oil", (), None))),
    ),
    RecipeFigures(Recipe("soup", (ONION,), "two"), (LineScore(ONION, Reason.NO_TREE),), error="no way"),
)
HEAD = "recipe,dish_type,ingredient,state,progress_line,score\n"


def filled(tmp_path, *scores):
    """The sheet of the recipes with these scores filled in."""
    rows = list(csv.reader(io.StringIO(write_sheet(RECIPES))))
    for row, score in zip(rows[1:], scores, strict=True):
        row[-1] = score
    path = tmp_path / "sheet.csv"
    with path.open("w", newline="", encoding="utf-8-sig") as file:
        csv.writer(file).writerows(rows)
    return path


def written(tmp_path, text):
    path = tmp_path / "sheet.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_a_sheet_has_a_line_for_each_line_of_a_tree_and_no_score():
    rows = list(csv.DictReader(io.StringIO(write_sheet(RECIPES))))
    assert [(row["recipe"], row["ingredient"], row["score"]) for row in rows] == [
        ("one", "onion", ""),
        ("one", 'oil, "virgin"', ""),
    ]
    assert rows[0]["progress_line"] == "whole onion on board → chop → salad"


def test_what_people_filled_is_set_beside_the_rule(tmp_path):
    path = filled(tmp_path, "1", " 0 ")
    assert scored_by_both(RECIPES, read_sheet(path)) == ([2, 0], [1, 0])


def test_what_is_left_open_is_counted(tmp_path):
    path = filled(tmp_path, "", "2")
    sheet = read_sheet(path)
    assert sheet.left_open == 1
    assert scored_by_both(RECIPES, sheet) == ([0], [2])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (HEAD + "one,salad,onion,chopped,,2\none,salad,oil,liquid,,3\n", ":3: “3” is no score"),
        (HEAD + "one,salad,onion,chopped,,good\n", ":2: “good” is no score"),
        (HEAD + "one,salad,onion,chopped,,2\n" * 2, ":3: one: onion, chopped is scored twice"),
        (HEAD + "one,salad,onion,chopped,,\n", ": nothing is scored"),
        (HEAD.replace("state", "status"), ":1: the column “state” is missing"),
        (HEAD.replace(",", ";"), ":1: the column “recipe” is missing"),
        ("", ":1: the column “recipe” is missing"),
        (HEAD + "one,salad,onion,chopped,,2,3\n", ":2: more values than columns"),
        (HEAD + 'one,salad,"onion\n', "not CSV"),
        ("café".encode("latin-1"), "not UTF-8"),
    ],
)
def test_what_is_wrong_is_told_by_file_and_line(tmp_path, text, said):
    path = written(tmp_path, text)
    with pytest.raises(ReadError) as caught:
        read_sheet(path)
    assert caught.value.message.startswith(str(path))
    assert said in caught.value.message
    assert caught.value.hint


def test_a_sheet_that_is_not_there_is_told(tmp_path):
    with pytest.raises(ReadError, match="No such file"):
        read_sheet(tmp_path / "none.csv")


def test_a_line_of_another_evaluation_is_refused(tmp_path):
    path = written(tmp_path, HEAD + "three,salad,onion,chopped,,2\n")
    with pytest.raises(ReadError, match="three: onion, chopped is not in this evaluation"):
        scored_by_both(RECIPES, read_sheet(path))
