"""What comes of the sheets of a reading: shares, agreement, and the program that draws and compares."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction

import pytest
from evaluation.readings import BUT, NO, PROGRAM, YES, plan, planned, verdicts, written
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.evaluation.reading import (
    ReadingTree,
)
from foon_kg.evaluation.reading_figures import ALL_READERS, ASPECTS, JUDGE, compare, judged
from foon_kg.evaluation.reading_sheet import Verdict, write_sheet
from foon_kg.validation import Finding, Report

# the figures

ROBOT_ONLY, COOK_ONLY = Verdict(True, False, False, "raw"), Verdict(False, True, True, "1 gone")
TREES = [
    ReadingTree("a", "soup", plan("a")),
    ReadingTree("v", "soup"),
    ReadingTree("b", "soup", plan("b")),
    ReadingTree("c", "rice", plan("c")),
    ReadingTree("d", "rice", plan("d")),
]
ONE = (YES, YES, BUT, ROBOT_ONLY, NO)
TWO = (YES, NO, COOK_ONLY, YES, NO)
JUDGED = (YES, YES, YES, ROBOT_ONLY, NO)


def shares(reading, kind, dish_type):
    """Of each rater: how many trees, and how many of them it accepts as robot, as cook, plainly, and in both roles."""
    return {
        one.rater: (
            one.trees,
            *(
                None if figure is None else round(figure.mean * one.trees)
                for figure in (one.robot, one.cook, one.plain, one.accepted)
            ),
        )
        for one in reading.shares
        if (one.kind, one.dish_type) == (kind, dish_type)
    }


def test_shares_of_a_case_made_by_hand():
    found = compare(TREES, [ONE, TWO], JUDGED)
    assert shares(found, "planned", "all") == {
        "reader 1": (4, 3, 2, 1, 2),
        "reader 2": (4, 2, 3, 3, 2),
        JUDGE: (4, 3, 2, None, 2),
        ALL_READERS: (4, 2, 2, 1, 1),
    }
    assert shares(found, "planned", "rice")[ALL_READERS] == (2, 1, 0, 0, 0)
    assert shares(found, "recorded", "all") == shares(found, "recorded", "soup")
    assert shares(found, "recorded", "all")[ALL_READERS] == (1, 0, 0, 0, 0)
    assert {(one.kind, one.dish_type) for one in found.shares} == {
        ("planned", "all"),
        ("planned", "rice"),
        ("planned", "soup"),
        ("recorded", "all"),
        ("recorded", "soup"),
    }


def test_agreement_of_a_case_made_by_hand():
    found = {(one.kind, one.aspect, one.raters): one for one in compare(TREES, [ONE, TWO], JUDGED).agreements}
    readers = ("reader 1", "reader 2")
    assert len(found) == 2 * 3 * 3
    # accepted: one yes yes no no, other yes no yes no: half is the same, as chance has it
    accepted = found["planned", "accepted", readers]
    assert (accepted.trees, accepted.same.mean, accepted.kappa) == (4, 0.5, 0.0)
    # robot: yes yes yes no beside yes no yes no: 3 of 4, and 1/2 by chance
    robot = found["planned", "robot", readers]
    assert (robot.same.mean, robot.kappa) == (0.75, pytest.approx(0.5))
    assert found["planned", "cook", ("reader 1", JUDGE)].kappa == 1
    assert found["recorded", "cook", ("reader 1", JUDGE)].kappa is None  # both said yes to all there is
    assert found["recorded", "cook", ("reader 2", JUDGE)].same.mean == 0


@pytest.mark.slow
@given(st.lists(st.tuples(verdicts, verdicts), min_size=1, max_size=12))
def test_kappa_is_what_counting_pairs_says(pairs):
    trees = [ReadingTree(str(number), "soup") for number in range(len(pairs))]
    one, two = zip(*pairs, strict=True)
    for found in compare(trees, [one, two]).agreements:
        said = [(getattr(a, found.aspect), getattr(b, found.aspect)) for a, b in pairs]
        same = Fraction(sum(a == b for a, b in said), len(said))
        chance = Fraction(sum(a == b for a, _ in said for _, b in said), len(said) ** 2)
        assert found.same.mean == float(same)
        assert found.kappa == (None if chance == 1 else pytest.approx(float((same - chance) / (1 - chance)), abs=1e-9))


def test_trees_on_which_the_judge_and_a_reader_differ_are_listed_with_what_they_say():
    found = compare(TREES, [ONE, TWO], JUDGED).differing
    assert [(one.number, one.name, one.recorded, one.aspects) for one in found] == [
        (2, "v", True, ASPECTS),
        (3, "b", False, ("robot", "accepted")),
        (4, "c", False, ("cook", "accepted")),
    ]
    assert found[1].verdicts == {"reader 1": BUT, "reader 2": COOK_ONLY, JUDGE: YES}
    assert compare(TREES, [ONE, TWO]).differing == ()


def test_the_judge_s_words_are_the_rules_broken():
    minor = [Finding("W5", "waits", 1, minor=True), Finding("W5", "waits", 2, minor=True), Finding("K2", "unpeeled")]
    fatal = [Finding("W1", "gone", 1), Finding("C5", "more")]
    assert judged(Report("a", (*minor, *fatal))) == Verdict(False, False, None, "C5, W1, K2; 2 minor (W5)")
    assert judged(Report("a", ())) == Verdict(True, True, None, "")


def test_figures_as_json():
    found = json.loads(json.dumps(compare(TREES, [ONE, TWO], JUDGED).to_json()))
    judge = next(one for one in found["shares"] if one["rater"] == JUDGE)
    assert (judge["kind"], judge["dish_type"], judge["trees"], judge["plain"]) == ("planned", "all", 4, None)
    assert judge["robot"] == {"mean": 0.75, "low": pytest.approx(0.300642), "high": pytest.approx(0.954413)}
    assert found["agreements"][0]["raters"] == ["reader 1", "reader 2"]
    assert found["differing"][1]["verdicts"]["reader 2"] == {
        "robot": False,
        "cook": True,
        "accepted": False,
        "words": "1 gone",
    }


def test_sheets_that_do_not_fit_are_refused():
    with pytest.raises(ValueError, match="nobody read"):
        compare(TREES, [])
    with pytest.raises(ValueError, match="zip"):
        compare(TREES, [ONE[:-1]])


# the program


def run(folder, arguments):
    done = subprocess.run(
        [sys.executable, PROGRAM, *arguments.split()], cwd=folder, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.slow
def test_the_program_draws_and_compares(tmp_path):
    written(tmp_path, "\n".join(json.dumps(tree.plan) for tree in planned(3)), "plans.jsonl")
    written(tmp_path, "> Read.\n", "words.md")
    drawing = "draw plans.jsonl --seed 7 --each 2 --words words.md --out trees.txt --key key.json"
    assert run(tmp_path, drawing) == (0, "", "6 trees of 3 dish types, 0 videos\n")
    assert (tmp_path / "trees.txt").read_text(encoding="utf-8").count("=== tree") == 6
    written(tmp_path, write_sheet((YES,) * 6), "one.txt")
    written(tmp_path, write_sheet((YES,) * 3 + (NO,) * 3), "two.txt")
    code, said, _ = run(tmp_path, "compare key.json --sheet one.txt --sheet two.txt --json")
    found = json.loads(said)["shares"]
    assert code == 0
    assert [one["accepted"]["mean"] for one in found[:3]] == [1.0, 0.5, 0.5]
    code, _, said = run(tmp_path, "compare key.json --sheet words.md")
    assert (code, said.splitlines()[0]) == (1, "words.md:1: this is no line about a tree")


@pytest.mark.shared_data
def test_the_judge_is_set_beside_readers_of_recorded_videos(tmp_path):
    written(tmp_path, json.dumps(plan("one")), "plans.jsonl")
    drawing = "draw plans.jsonl --seed 7 --each 1 --videos 3 --out trees.txt --key key.json"
    assert run(tmp_path, drawing) == (0, "", "1 trees of 1 dish types, 3 videos\n")
    written(tmp_path, write_sheet((YES,) * 4), "one.txt")
    code, said, _ = run(tmp_path, "compare key.json --sheet one.txt --judge --json")
    counted = {
        (one["kind"], one["rater"]): one["trees"] for one in json.loads(said)["shares"] if one["dish_type"] == "all"
    }
    assert code == 0
    assert counted["planned", JUDGE] == 1
    assert counted["recorded", JUDGE] == 3
