"""``foon retrieve``: data on stdout, messages on stderr, and exit codes that scripts can rely on."""

from __future__ import annotations

import json

import pytest
from kitchen_stories import unit
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.loaders import read_text, write_text
from foon_kg.model import Annotation, Subgraph

LINES = (
    "cutting board(empty); onion(whole) > pick-and-place > cutting board{onion}; onion(whole)@on cutting_board",
    "onion(whole)@on cutting_board; knife > chop > onion(chopped)@on cutting_board",
    "bowl(empty); onion(chopped)@on cutting_board > drop > bowl(full){onion}; onion(chopped)@bowl",
    "bowl(full){onion} > mix > salad(mixed){onion}",
    "onion(whole); blender(empty) > grind > salad(ground){onion}",
    "unicorn(tamed) > mix > soup(mixed){unicorn}",
)
SALAD = ["salad", "--state", "mixed", "--level", "3"]


@pytest.fixture
def folder(tmp_path):
    story = Subgraph("story", tuple(Annotation(unit(line)) for line in LINES))
    (tmp_path / "subgraphs").mkdir()
    (tmp_path / "subgraphs" / "story.txt").write_text(write_text(story), encoding="utf-8")
    weights = {"pick-and-place": 0.2, "chop": 0.9, "drop": 0.1, "mix": 0.2}
    (tmp_path / "weights.json").write_text(json.dumps(weights), encoding="utf-8")
    return tmp_path


@pytest.fixture
def retrieve(folder):
    files = ["--files", str(folder / "subgraphs")]
    return lambda *words: CliRunner().invoke(app, ["retrieve", *map(str, words), *files])


def test_steps_are_numbered_and_the_kitchen_is_named(retrieve):
    answer = retrieve(*SALAD)
    assert answer.exit_code == 0, answer.stderr
    assert "level 3, objects with states and ingredients" in answer.stdout
    assert "steps 4, proven: no tree has fewer" in answer.stdout
    for title in ("Steps", "Kitchen"):
        assert f"\n{title}\n" in answer.stdout
    assert "4 bowl (full, with onion) → MIX → salad (mixed, with onion)  [from story]" in answer.stdout
    assert "success" not in answer.stdout


def test_weights_give_every_step_and_the_tree_a_success(retrieve, folder):
    answer = retrieve("salad", "--by", "success", "--weights", folder / "weights.json")
    assert "success 0.5, proven: no tree has more; assumed without a weight: grind" in answer.stdout
    assert "[0.5; from story]" in answer.stdout
    assert "without a weight, taken as 0.5: grind" in answer.stderr


def test_json_is_one_object_with_everything(retrieve, folder):
    answer = retrieve(*SALAD, "--weights", folder / "weights.json", "--json", "--quiet")
    assert answer.stderr == ""
    result = json.loads(answer.stdout)
    assert result["asked"] == {
        "label": "salad",
        "states": ["mixed"],
        "ingredients": [],
        "container": None,
        "level": 3,
        "by": "units",
    }
    assert (result["total_units"], result["exact"], result["bound"], result["level"]) == (4, True, None, 3)
    assert result["success"] == 0.0576
    assert [(u["motion_node"], u["success"], u["seen_in"][0]["unit"]) for u in result["units"]] == [
        ("pick-and-place", 0.8, 0),
        ("chop", 0.1, 1),
        ("drop", 0.9, 2),
        ("mix", 0.8, 3),
    ]
    assert [(n["label"], n["states"]) for n in result["kitchen"]] == [
        ("cutting board", ["empty"]),
        ("onion", ["whole"]),
        ("knife", []),
        ("bowl", ["empty"]),
    ]


def test_foon_text_is_read_back_as_the_same_steps(retrieve):
    text = retrieve(*SALAD, "--foon", "--quiet").stdout
    read = read_text(text, "tree", "tree.txt")
    assert read.notices == ()
    assert [a.unit.motion for a in read.subgraph.annotations] == ["pick-and-place", "chop", "drop", "mix"]


@pytest.mark.parametrize("level", [1, 2, 3])
def test_foon_check_finds_that_the_tree_keeps_its_form(retrieve, folder, level):
    tree = folder / "tree.json"
    tree.write_text(retrieve("salad", "--level", level, "--json").stdout, encoding="utf-8")
    judged = CliRunner().invoke(app, ["check", str(tree), str(tree), "--files", str(folder / "subgraphs")])
    assert (judged.exit_code, judged.stdout.splitlines()[0]) == (0, "salad: form kept")


def test_foon_check_finds_what_was_changed_in_a_tree(retrieve, folder):
    result = json.loads(retrieve(*SALAD, "--json").stdout)
    del result["units"][1]
    tree = folder / "tree.json"
    tree.write_text(json.dumps(result), encoding="utf-8")
    judged = CliRunner().invoke(app, ["check", str(tree), "--files", str(folder / "subgraphs")])
    assert judged.exit_code == 1
    assert "C1" in judged.stdout


def test_a_kitchen_file_decides_what_is_at_hand(retrieve, folder):
    kitchen = folder / "kitchen.txt"
    kitchen.write_text("cutting board\nbowl\nblender\n", encoding="utf-8")
    without_knife = retrieve(*SALAD, "--kitchen", kitchen)
    assert (without_knife.exit_code, without_knife.stdout) == (3, "")
    assert "missing knife" in without_knife.stderr
    kitchen.write_text("cutting board\nbowl\nknife\n", encoding="utf-8")
    assert retrieve(*SALAD, "--kitchen", kitchen).exit_code == 0


def test_no_tree_is_exit_code_3_and_says_what_is_missing(retrieve):
    answer = retrieve("soup")
    assert (answer.exit_code, answer.stdout) == (3, "")
    assert "error: nothing makes soup (mixed): missing unicorn (tamed)" in answer.stderr


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["pie"], 3, "this FOON has no “pie”"),
        (["salad", "--state", "burnt"], 3, "no salad (burnt) in this FOON"),
        (["salad", "--by", "success"], 2, "there are no weights of motions"),
        (["salad", "--by", "luck"], 2, "luck"),
        (["salad", "--level", "4"], 2, "--level"),
        (["salad", "--level", "1", "--state", "mixed"], 2, "at level 1 a FOON has no states"),
        (["salad", "--ingredient", "onion"], 2, "at level 2 a FOON has no ingredients"),
        (["salad", "--weights", "lost.json"], 1, "lost.json: cannot be read"),
        ([" "], 2, "the goal has no name"),
    ],
)
def test_what_cannot_be_answered_has_its_exit_code_and_nothing_on_stdout(retrieve, words, code, message):
    answer = retrieve(*words)
    assert (answer.exit_code, answer.stdout) == (code, "")
    assert message in answer.stderr


@pytest.mark.parametrize(
    ("words", "exit_code", "code", "message"),
    [
        (["pie"], 3, "no-goal", "this FOON has no “pie”"),
        (["salad", "--by", "success"], 2, "usage", "there are no weights of motions"),
        (["salad", "--foon"], 2, "usage", "--json and --foon ask for two forms of one answer"),
        (["salad", "--weights", "lost.json"], 1, "read", "lost.json: cannot be read"),
    ],
)
def test_who_asked_for_json_gets_the_error_as_json_too(retrieve, words, exit_code, code, message):
    answer = retrieve(*words, "--json")
    assert answer.exit_code == exit_code
    error = json.loads(answer.stdout)["error"]
    assert (error["code"], message in error["message"], bool(error["hint"])) == (code, True, True)
    assert f"error: {error['message']}\nhint: {error['hint']}" in answer.stderr


def test_json_names_what_is_missing(retrieve):
    answer = retrieve("soup", "--json")
    (missing,) = json.loads(answer.stdout)["error"]["missing"]
    assert (missing["node"]["label"], missing["node"]["states"]) == ("unicorn", ["tamed"])
    assert missing["remedy"] == "have unicorn ready: tamed"


def test_an_appliance_that_videos_tell_in_two_ways_has_to_be_there_once(retrieve, folder):
    lines = (
        "stove(ready)@under pan > turn on > stove(on)@under pan",
        "stove(off)@under pan; pan(empty)@on stove > preheat > pan(hot)@on stove",
        "stove(on)@under pan; pan(hot)@on stove; egg(whole); oven(closed,off) > cook > omelette(cooked){egg}",
    )
    story = Subgraph("eggs", tuple(Annotation(unit(line)) for line in lines))
    (folder / "subgraphs" / "eggs.txt").write_text(write_text(story), encoding="utf-8")
    shown = " ".join(retrieve("omelette").stdout.partition("Kitchen")[2].split())
    assert "stove (off or ready, under pan)" in shown
    assert shown.count("stove (") == 1
    assert "oven (closed, off)" in shown  # one word for each of two things that are so, and not two for one
    assert len(json.loads(retrieve("omelette", "--json").stdout)["kitchen"]) == 5
