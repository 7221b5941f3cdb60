"""Words that no table has: which they are, what they are taken for, and that a load says so."""

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.food.unknown import UnknownWord, WordKind, by_one_another, unknown_words
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
        (ObjectNode("spoonn"), (), "spoon"),
        (ObjectNode("mixing bowll"), (), "mixing bowl"),
        (ObjectNode("choclate chip"), (), "chocolate chip"),
    ],
)
def test_a_slip_of_the_pen_is_told_with_what_may_be_meant(node, motions, meant):
    (word,) = unknown_words([node], motions)
    assert word.meant == meant
    assert f"(is “{meant}” meant?)" in str(word)


def test_a_slip_of_a_tool_is_a_tool_that_no_table_has():
    (word,) = unknown_words([ObjectNode("spoonn")])
    assert (word.kind, word.taken_for) == (WordKind.UTENSIL, "a food")


def test_a_slip_of_what_more_files_have_is_told_and_never_the_other_way_round():
    often, slip, other = (unknown_words([ObjectNode(name)])[0] for name in ("quorblette", "quorblete", "zzyxap"))
    told = by_one_another({often: 3, slip: 1, other: 1})
    assert [told[word].meant for word in (often, slip, other)] == ["", "quorblette", ""]
    assert by_one_another({often: 1, slip: 1}) == {often: often, slip: slip}, "nobody knows which"


def test_a_name_of_listed_words_is_no_slip_of_another():
    (word,) = unknown_words([ObjectNode("garden salad")])
    assert word.meant == ""


def test_a_typing_error_that_the_tables_understand_is_told():
    assert told(ObjectNode("cinammon", ("choppped",), (), "in", "baking try")) == [
        "“cinammon” is a typing error (is “cinnamon” meant?): taken for “cinnamon”",
        "“choppped” is a typing error (is “chopped” meant?): taken for “chopped”",
        "“baking try” is a typing error (is “baking tray” meant?): taken for “baking tray”",
    ]


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


TABLE = """start,end,motion,inputs,outputs
0:01,0:02,chop,onion (peeled) on cutting board; spoonn,onion (choppped) on cutting board
0:03,0:04,mixx *,bowl {onion}; spoon,onion (zorged) in bowl
"""

TOLD = [
    "3: “mixx” is not in the table of motions (is “mix” meant?): taken for one of which nothing is known",
    "2: “choppped” is a typing error (is “chopped” meant?): taken for “chopped”",
    "3: “zorged” is not in the table of states: taken for one that says nothing of the food",
    "2: “spoonn” is not in the table of utensils (is “spoon” meant?): taken for a food",
]


@pytest.mark.parametrize("command", [("load", "videos", "--dry-run"), ("diff", "--files", "FOON")])
def test_what_no_table_has_is_told_by_line_before_it_is_loaded(folder, command):
    table = folder / "odd.csv"
    table.write_text(TABLE, encoding="utf-8")
    words = [str(folder / "odd.txt") if word == "FOON" else word for word in command]
    answer = foon(*words, table)
    assert answer.exit_code == 0, answer.stderr
    assert [line for line in answer.stderr.splitlines() if str(table) in line] == [f"{table}:{told}" for told in TOLD]


SLIPS = (
    "O\tonion\t0\nS\twhole\nO\tknife\t0\nM\tchop\t<0:01-0:02>\nO\tonion\t0\nS\tchoped\n//\n"
    "O\ttomatoe\t0\nS\twhole\nO\tbowl\t0\nS\tempty\nM\tpoor\t<0:03-0:04>\nO\tbowl\t0\nS\tcontains\t{tomatoe}\n//\n"
)


def test_a_word_is_told_on_the_line_where_it_stands_and_a_short_motion_with_what_is_meant(folder):
    file = folder / "slips.txt"
    file.write_text(SLIPS, encoding="utf-8")
    answer = foon("load", "foon", "--dry-run", file)
    told = [line.removeprefix(f"{file}:").partition(": taken for")[0] for line in answer.stderr.splitlines()]
    assert set(told) >= {
        "6: “choped” is not in the table of states (is “chopped” meant?)",
        "8: “tomatoe” is not in the table of foods (is “tomato” meant?)",
        "12: “poor” is not in the table of motions (is “pour” meant?)",
    }


def test_what_the_foon_has_is_meant_where_no_table_has_it(folder):
    (folder / "own.csv").write_text(TABLE.replace("spoonn", "quorblette"), encoding="utf-8")
    (folder / "odd.csv").write_text(TABLE.replace("spoonn", "quorblete"), encoding="utf-8")
    answer = foon("diff", folder / "odd.csv", "--files", folder / "own.csv")
    assert "“quorblete” is not in the table of foods (is “quorblette” meant?)" in answer.stderr


def test_a_load_says_what_no_table_has(folder):
    report = folder / "notices.jsonl"
    answer = foon("load", "foon", folder / "odd.txt", "--dry-run", "--report", report)
    assert answer.exit_code == 0
    notices = [json.loads(line) for line in report.read_text(encoding="utf-8").splitlines()]
    assert [(one["kind"], one["line"], one["action"]) for one in notices] == [
        ("unknown-food", 1, "taken for a food of no known kind"),
        ("unknown-motion", 4, "taken for one of which nothing is known"),
        ("unknown-state", 2, "taken for one that says nothing of the food"),
    ]
    assert all(one["file"].endswith("odd.txt") and one["severity"] == "assumed" for one in notices)
    assert len([line for line in answer.stderr.splitlines() if "in the table" in line]) == len(notices)


def test_of_many_words_those_that_look_misspelled_are_told_one_by_one(folder):
    labels = [f"xylo{place * 'x'}carp" for place in range(11)]
    unit = "O\t{}\t1\nO\tspoonn\t0\nM\tchop\t<0:01-0:02>\nO\t{}\t1\nS\tchopped\n//\n"
    (folder / "odd.txt").write_text("".join(unit.format(one, one) for one in labels), encoding="utf-8")
    lines = foon("load", "foon", folder / "odd.txt", "--dry-run").stderr.splitlines()
    assert lines[0].endswith(
        "odd.txt:2: “spoonn” is not in the table of utensils (is “spoon” meant?): taken for a food"
    )
    assert lines[1].startswith("12 words are in no table of foon-kg (--report FILE lists them): 11 foods")
    assert len(lines) == 2


def test_a_command_that_reads_files_says_so_too(folder):
    answer = foon("stats", "--files", folder)
    assert "3 words in no table in these files" in answer.stderr
    assert "xylocarp" not in foon("stats", "--files", folder, "--quiet").stderr
