"""What a command reads is never written over by it, and what is no file for it is told with what takes it."""

from __future__ import annotations

import json
import unicodedata

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.draft_session import review_in_person
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders.video_tables import read_video_table, read_videos
from foon_kg.model.errors import UsageError

TABLE = """start,end,motion,inputs,outputs,dish
0:12,0:31,chop,tomato (whole); cutting board (empty); knife,tomato (chopped) on cutting board; cutting board {tomato},
0:40,0:44,serve,tomato (chopped) on cutting board; cutting board {tomato}; plate,salad {tomato} on plate,salad
"""


def foon(*words):
    result = CliRunner().invoke(app, list(map(str, words)))
    return result.exit_code, result.output.replace("\n", " ")


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "my_salad.csv"
    path.write_text(TABLE)
    return path


@pytest.mark.parametrize("read", ["my_salad.csv", "."])
def test_a_report_is_not_written_over_what_is_loaded(table, tmp_path, read):
    link = tmp_path / "link.jsonl"
    link.symlink_to(table)
    for report in (table, link) if read != "." else (table,):
        code, said = foon("load", "videos", tmp_path / read, "--dry-run", "--report", report)
        assert (code, "is read, and would be written over" in said) == (2, True)
    assert table.read_text() == TABLE
    assert foon("load", "videos", tmp_path / read, "--dry-run", "--report", tmp_path / "odd.jsonl")[0] == 0
    assert foon("load", "videos", tmp_path / read, "--dry-run", "--report", tmp_path / "odd.jsonl")[0] == 0  # once more


def test_no_other_output_is_written_over_what_is_read(tmp_path):
    plan = tmp_path / "plan.json"
    asked = ("plan", "--files", demo_folder(), "--dish", "salad", "chopped tomato", "--json")
    plan.write_text(CliRunner().invoke(app, list(map(str, asked))).stdout)
    before = plan.read_text()
    for words in (["show", plan, "-o", plan], ["export", plan, "-o", plan], ["check", plan, "--recipe", plan]):
        code, said = foon(*words)
        assert code != 0
        assert plan.read_text() == before
        assert ("would be written over" in said) == (words[0] != "check")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "there is nothing in its first line"),
        (TABLE.replace(",", ";", 5), "separated by semicolons"),
        (TABLE.replace(",", "\t"), "separated by tabs"),
        (TABLE.replace("motion", "move"), "not there: motion"),
    ],
)
def test_a_wrong_heading_is_told_as_what_it_is(tmp_path, content, said):
    path = tmp_path / "odd.csv"
    path.write_text(content)
    (result,) = read_video_table(path)
    assert said in str(result.notices[0])


def test_what_takes_another_file_is_named(table, tmp_path):
    (tmp_path / "sheet.xlsx").write_bytes(b"PK")
    assert "foon load videos" in foon("load", "foon", table)[1]
    assert "foon load videos" in foon("load", "foon", tmp_path)[1]
    assert "Save the table as CSV" in foon("load", "foon", tmp_path / "sheet.xlsx")[1]
    assert "foon draft videos" in foon("draft", "text", table, "-o", tmp_path / "drafts")[1]
    code, said = foon("plan", "--files", demo_folder(), "--dish", "salad", "tomato", table)
    assert (code, "is a file, and no ingredient" in said) == (2, True)


def test_a_dry_run_refuses_two_videos_of_one_name_as_a_load_does(tmp_path):
    for folder, food in (("a", "tomato"), ("b", "onion")):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "salad.csv").write_text(TABLE.replace("tomato", food))
    code, said = foon("load", "videos", tmp_path / "a", tmp_path / "b", "--dry-run")
    assert (code, "two different subgraphs are called “salad”" in said) == (1, True)


def test_a_name_is_one_however_a_file_system_writes_it(tmp_path):
    names = set()
    for number, form in enumerate(("NFC", "NFD")):
        folder = tmp_path / str(number)
        folder.mkdir()
        for ending, text in ((".csv", TABLE), (".json", json.dumps({"units": []}))):
            (folder / (unicodedata.normalize(form, "crème brûlée") + ending)).write_text(text)
        names |= {one.subgraph.name for one in read_videos([folder]) if one.subgraph is not None}
    assert names == {unicodedata.normalize("NFC", "crème brûlée")}


@pytest.mark.parametrize(
    "words", [["load", "foon", ""], ["plan", "--dish", "salad", "onion", "--files", ""], ["stats", "--files="]]
)
def test_an_empty_path_is_not_the_folder_one_is_in(words):
    code, said = foon(*words)
    assert (code, "a path is empty" in said) == (2, True)


def test_a_dish_type_that_is_misspelled_is_guessed(tmp_path):
    text = tmp_path / "cake.txt"
    text.write_text("Beat the egg.")
    assert "Did you mean cake?" in foon("draft", "text", text, "--dish", "caek")[1]


def test_what_is_decided_goes_into_foon_text(table, tmp_path):
    with pytest.raises(UsageError, match="what is decided is FOON text"):
        review_in_person(table, tmp_path / "decided.csv")
    assert table.read_text() == TABLE
