"""Words that no table has: which they are, what they are taken for, and that a load says so."""

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.food.unknown import UnknownWord, WordKind, unknown_words
from foon_kg.model import ObjectNode


def told(*nodes, motions=()):
    return [str(word) for word in unknown_words(nodes, motions)]


def test_what_the_tables_have_is_not_told():
    onion = ObjectNode("onion", ("chopped",), (), "in", "bowl")
    bowl = ObjectNode("bowl", ("empty",), ("onions", "red peppers"))
    assert told(onion, bowl, motions=("scoop and pour", "pick-and-place")) == []


def test_a_food_of_which_nothing_is_known():
    assert told(ObjectNode("xylocarp")) == [
        "“xylocarp” is not in the table of foods: taken for a food of no known kind"
    ]


@pytest.mark.parametrize(
    ("node", "motions", "meant"),
    [
        (ObjectNode("onion", ("sllliced",)), (), "sliced"),
        (ObjectNode("onion"), ("whissk",), "whisk"),
        (ObjectNode("tomatoo"), (), "tomato"),
    ],
)
def test_a_slip_of_the_pen_is_told_with_what_may_be_meant(node, motions, meant):
    (word,) = unknown_words([node], motions)
    assert word.meant == meant
    assert f"(is “{meant}” meant?)" in str(word)


def test_a_food_whose_last_words_are_known_is_hardly_a_guess():
    (word,) = unknown_words([ObjectNode("garden pepper")])
    assert (word.kind, word.taken_for, word.nearly) == (WordKind.FOOD, "“pepper”", True)


def test_a_food_known_by_its_ending_or_by_a_part_of_its_name_is_a_guess():
    ending, part = unknown_words([ObjectNode("cloudyberry"), ObjectNode("tomato xyz")])
    assert (ending.taken_for, ending.nearly) == ("a kind of berry by its ending “berry”", False)
    assert (part.taken_for, part.nearly) == ("“tomato”", False)


@pytest.mark.parametrize(
    ("node", "why"),
    [
        (ObjectNode("soup", (), (), "in", "karahi"), "something is in it or on it"),
        (ObjectNode("karahi", ("empty",)), "it is empty"),
        (ObjectNode("magic karahi pan"), "its name says pan"),
    ],
)
def test_what_looks_like_a_utensil_and_is_none(node, why):
    (word,) = unknown_words([node])
    assert (word.kind, word.taken_for) == (WordKind.UTENSIL, "a food")
    assert f"though {why}" in str(word)


def test_a_bread_on_which_something_lies_is_a_food():
    assert told(ObjectNode("butter", ("melted",), (), "on", "bread")) == []


def test_states():
    onion = ObjectNode("onion", ("thinly sliced", "sliced oddly", "wobbly", "on [stem]"))
    assert told(onion, ObjectNode("stove", ("on",))) == [
        "“sliced oddly” is not in the table of states: taken for “sliced”",
        "“wobbly” is not in the table of states: taken for one that says nothing of the food",
    ]


def test_motions():
    assert told(motions=("zib", "zib and pour", "pour", "stir in the bowl")) == [
        "“stir in the bowl” is not in the table of motions: taken for “stir”",
        "“zib” is not in the table of motions: taken for one of which nothing is known",
        "“zib and pour” is not in the table of motions: taken for “pour”",
    ]


def test_each_word_is_told_once_by_kind_and_name():
    words = unknown_words([ObjectNode("xylocarp", ("wobbly",)), ObjectNode("xylocarps")] * 2, ["zib"] * 2)
    assert [(word.kind, word.word) for word in words] == [
        (WordKind.FOOD, "xylocarp"),
        (WordKind.MOTION, "zib"),
        (WordKind.STATE, "wobbly"),
    ]


def test_words_are_values():
    assert UnknownWord(WordKind.FOOD, "a", "b") == UnknownWord(WordKind.FOOD, "a", "b")


UNIT = "O\txylocarp\t1\nS\twobbly\nO\tknife\t0\nM\tzib\t<0:01-0:02>\nO\txylocarp\t1\nS\tchopped\n//\n"


def foon(*words):
    return CliRunner().invoke(app, list(map(str, words)))


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "odd.txt").write_text(UNIT, encoding="utf-8")
    return tmp_path


def test_a_load_says_in_one_line_what_no_table_has(folder):
    report = folder / "notices.jsonl"
    answer = foon("load", "foon", folder / "odd.txt", "--dry-run", "--report", report)
    assert answer.exit_code == 0
    (line,) = [line for line in answer.stderr.splitlines() if "no table" in line]
    assert line.endswith("1 food (xylocarp), 1 motion (zib), 1 state (wobbly)")
    notices = [json.loads(line) for line in report.read_text(encoding="utf-8").splitlines()]
    assert [(one["kind"], one["action"]) for one in notices] == [
        ("unknown-food", "taken for a food of no known kind"),
        ("unknown-motion", "taken for one of which nothing is known"),
        ("unknown-state", "taken for one that says nothing of the food"),
    ]
    assert all(one["file"].endswith("odd.txt") and one["severity"] == "assumed" for one in notices)


def test_a_command_that_reads_files_says_so_too(folder):
    answer = foon("stats", "--files", folder)
    assert "3 words in no table in these files" in answer.stderr
    assert "xylocarp" not in foon("stats", "--files", folder, "--quiet").stderr
