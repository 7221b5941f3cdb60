"""A reading: which trees are drawn and how they are printed, what readers may write, and what comes of their sheets."""

from __future__ import annotations

import json
import subprocess
import sys
from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.evaluation.reading import (
    ReadingTree,
    draw,
    key_to_json,
    names_in,
    planned_trees,
    read_key,
    video_trees,
)
from foon_kg.evaluation.reading_figures import ALL_READERS, ASPECTS, JUDGE, compare, judged
from foon_kg.evaluation.reading_page import page, words_in
from foon_kg.evaluation.reading_sheet import Verdict, read_sheet, write_sheet
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Subgraph
from foon_kg.model.errors import ReadError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.validation import Finding, Report

PROGRAM = Path(__file__).parents[2] / "benchmarks" / "reading.py"
DISHES = ("salad", "soup", "rice")


def node(label, *states, inside=None):
    relation = "in" if inside else None
    return {"label": label, "states": list(states), "ingredients": [], "relation": relation, "container": inside}


def plan(name, dish_type="salad", **more):
    """A plan result of one step."""
    return {
        "recipe": {
            "id": name,
            "title": None,
            "dish_type": dish_type,
            "ingredients": [{"object": "egg", "state": "raw"}],
        },
        "goal": node(dish_type),
        "units": [
            {
                "input_nodes": [node("egg", "whole"), node("knife")],
                "motion_node": "chop",
                "output_nodes": [node("egg", "chopped", inside="bowl")],
                "origin": "adapted",
                "seen_in": [{"video": "secret-video", "unit": 3, "source": None, "start": 1.0, "end": 2.0}],
            }
        ],
        "kitchen": [node("egg", "whole")],
        "substitutions": [],
        "assumptions": [],
        **more,
    }


def failure(name):
    given = plan(name)
    return {"recipe": given["recipe"], "error": {"code": "no-goal", "message": "no way", "hint": ""}}


def planned(count, dishes=DISHES):
    names = [(f"{dish}{number}", dish) for dish in dishes for number in range(count)]
    return [ReadingTree(name, dish, plan(name, dish)) for name, dish in names]


def video(name, dish_type="soup"):
    taken = (Participant(ObjectNode("onion", ("chopped",))), Participant(ObjectNode("egg", ("beaten",))))
    goal = Participant(ObjectNode("omelette", ("cooked",), ("egg", "onion")), dish_type=dish_type)
    return Subgraph(name, (Annotation(FunctionalUnit(taken, "cook", (goal,))),))


VIDEOS = video_trees([video(f"video{number}") for number in range(4)], Kitchen.default())


def written(tmp_path, text, name="file"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


# what is drawn


@given(st.integers(0, 5), st.integers(1, 4), st.integers(0, 4), st.randoms())
def test_a_seed_draws_the_same_in_whatever_order_trees_are_given(seed, each, recorded, shuffle):
    trees, videos = planned(4), list(VIDEOS.items())
    first = draw(trees, VIDEOS, seed=seed, each=each, recorded=recorded)
    shuffle.shuffle(trees)
    shuffle.shuffle(videos)
    assert draw(trees, dict(videos), seed=seed, each=each, recorded=recorded) == first
    counts = Counter("video" if tree.recorded else tree.dish_type for tree in first)
    assert counts == dict.fromkeys(DISHES, each) | ({"video": recorded} if recorded else {})


def test_another_seed_draws_others_in_another_order():
    draws = [[tree.name for tree in draw(planned(20), {}, seed=seed, each=5)] for seed in range(4)]
    assert len({frozenset(names) for names in draws}) == 4
    assert all(names != sorted(names) for names in draws)


def test_what_was_read_before_is_not_drawn_again(tmp_path):
    trees = planned(6)
    first = draw(trees, VIDEOS, seed=1, each=2, recorded=2)
    key = written(tmp_path, json.dumps(key_to_json(1, first)), "key.json")
    names = written(tmp_path, json.dumps(["soup0", "video0"]), "names.json")
    before = names_in(key) | names_in(names)
    assert before == {tree.name for tree in first} | {"soup0", "video0"}
    second = draw(trees, VIDEOS, seed=1, each=6, recorded=4, without=before)
    assert {tree.name for tree in second} == ({tree.name for tree in trees} | set(VIDEOS)) - before


def test_two_trees_of_one_name_are_refused():
    with pytest.raises(ReadError, match="salad0: two trees"):
        draw([*planned(2), *planned(1)], {}, seed=0, each=1)
    with pytest.raises(ReadError, match="video0: two trees"):
        draw([ReadingTree("video0", "soup", plan("video0"))], VIDEOS, seed=0, each=1)


def test_plan_results_without_a_tree_are_not_drawn(tmp_path):
    lines = [json.dumps(plan("one", "soup")), "", json.dumps(failure("two")), json.dumps(plan("three\u2028"))]
    trees = planned_trees(written(tmp_path, "\n".join(lines)))
    assert [(tree.name, tree.dish_type, tree.has_steps) for tree in trees] == [
        ("one", "soup", True),
        ("two", "salad", False),
        ("three\u2028", "salad", True),
    ]
    assert {tree.name for tree in draw(trees, {}, seed=0, each=9)} == {"one", "three\u2028"}


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("{", ":2: no JSON"),
        ("[]", ":2: expected a JSON object"),
        (json.dumps({**plan("x"), "units": 3}), ":2: “units” should be a list"),
        (json.dumps({**plan("x"), "level": 1}), ":2: it answers no recipe"),
    ],
)
def test_what_is_no_plan_result_is_told_by_line(tmp_path, line, said):
    path = written(tmp_path, json.dumps(plan("one")) + "\n" + line + "\n")
    with pytest.raises(ReadError) as caught:
        planned_trees(path)
    assert caught.value.message.startswith(str(path) + said)


def test_a_video_that_marks_no_dish_cannot_be_drawn():
    assert video_trees([video("none", dish_type=None)], Kitchen.default()) == {}


# the key


def test_a_key_gives_back_what_was_drawn(tmp_path):
    trees = draw(planned(2), VIDEOS, seed=3, each=1, recorded=1)
    assert read_key(written(tmp_path, json.dumps(key_to_json(3, trees)))) == trees


@pytest.mark.parametrize(
    ("trees", "said"),
    [
        ([{"number": 2, "id": "a", "dish_type": "soup", "plan": None}], "trees[0]: its number should be 1"),
        ([{"number": 1, "dish_type": "soup", "plan": None}], "trees[0]: the field “id” is missing"),
        ([{"number": 1, "id": "a", "dish_type": "soup", "plan": {}}], "trees[0]: plan: the field “recipe” is missing"),
        (["a"], "trees[0]: expected a JSON object"),
    ],
)
def test_what_is_no_key_is_told(tmp_path, trees, said):
    with pytest.raises(ReadError) as caught:
        read_key(written(tmp_path, json.dumps({"seed": 1, "trees": trees})))
    assert said in caught.value.message


def test_a_video_that_is_not_there_is_told():
    with pytest.raises(ReadError, match="video9: no such video"):
        ReadingTree("video9", "soup").tree(VIDEOS)


# the page


def test_a_page_has_the_words_and_each_tree_as_a_person_reads_it(tmp_path):
    more = {
        "substitutions": [
            {
                "kind": "state",
                "object": "egg",
                "required": "raw",
                "equivalent": "whole",
                "confidence": 0.75,
                "alternatives": [],
            },
            {"kind": "object", "object": "egg", "required": "egg"},
        ],
        "assumptions": [{"node": node("egg", "whole"), "why": "nobody knows"}],
    }
    words = words_in(written(tmp_path, "# Title\n\n> Read **this**,\n> and *that*.\n\nNot this.\n"))
    trees = [ReadingTree("secret-name", "salad", plan("secret-name", **more)), ReadingTree("video0", "soup")]
    assert page(words, [tree.tree(VIDEOS) for tree in trees]) == (
        "Read **this**,\nand *that*.\n\n"
        "=== tree 1\n"
        "dish type: salad; title: -\n"
        "asked: egg (raw)\n"
        "1. egg (whole) + knife → CHOP → egg (chopped; in bowl)\n"
        "substitutions: egg: raw handled like whole (state, 0.75); egg: egg handled like ? (object, ?)\n"
        "assumptions: egg (whole): nobody knows\n\n"
        "=== tree 2\n"
        "dish type: soup; title: -\n"
        "asked: egg (beaten); onion (chopped)\n"
        "1. onion (chopped) + egg (beaten) → COOK → omelette (cooked; {egg, onion})\n"
        "substitutions: none\n"
        "assumptions: none\n"
    )


def test_a_file_that_quotes_nothing_has_no_words(tmp_path):
    with pytest.raises(ReadError, match="nothing is quoted"):
        words_in(written(tmp_path, "Read this.\n"))


# the sheets

YES, BUT, NO = Verdict(True, True, True), Verdict(True, True, False), Verdict(False, False, False)
words = st.text(st.characters(exclude_categories=("C", "Z")) | st.just(" "), max_size=20).map(str.strip)
verdicts = st.builds(
    lambda robot, cook, said: Verdict(robot, cook != "no", cook == "yes", said),
    st.booleans(),
    st.sampled_from(["yes", "yes, but", "no"]),
    words,
)


@given(sheet=st.lists(verdicts, min_size=1, max_size=6), order=st.randoms())
def test_a_sheet_is_read_as_it_was_written_in_any_order(tmp_path_factory, sheet, order):
    lines = write_sheet(tuple(sheet)).splitlines(keepends=True)
    order.shuffle(lines)
    path = written(tmp_path_factory.mktemp("sheet"), "".join(lines))
    assert read_sheet(path, len(sheet)) == tuple(sheet)


def test_a_line_is_read_as_people_write_it(tmp_path):
    path = written(tmp_path, "\n 2|No | YES,  but|3 a | b; c\r\n\n1 | yes | no |\n")
    assert read_sheet(path, 2) == (Verdict(True, False, False, ""), Verdict(False, True, False, "3 a | b; c"))


@pytest.mark.parametrize("rest", ["---\n3 trees\n", "\nCounts by dish type\n| soup | 1 | 2 |\n2 of 2 | odd\n"])
def test_what_follows_the_last_tree_is_the_reader_s_own(tmp_path, rest):
    assert len(read_sheet(written(tmp_path, "1 | yes | yes |\n2 | no | no | 1 raw\n" + rest), 2)) == 2


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("1 | yes | yes |\n2 | maybe | no | x\n", ":2: robot says “maybe”"),
        ("1 | yes | yes |\n\n2 | yes | but | x\n", ":3: cook says “but”"),
        ("1 | yes, but | yes | x\n2 | yes | yes |\n", ":1: robot says “yes, but”"),
        ("1 | yes | yes\n2 | yes | yes |\n", ":1: no line of a tree"),
        ("number | robot | cook | faults\n", ":1: no line of a tree"),
        ("1 | yes | yes |\nSo far so good\n2 | yes | yes |\n", ":2: no line of a tree"),
        ("1 | yes | yes |\n3 | yes | yes |\n", ":2: there is no tree 3"),
        ("0 | yes | yes |\n", ":1: there is no tree 0"),
        ("1 | yes | yes |\n1 | yes | no | x\n", ":2: tree 1 is there twice"),
        ("1 | yes | yes |\n2 | yes | yes |\ncounts\n2 | no | no | x\n", ":4: tree 2 is there twice"),
        ("2 | yes | yes |\n---\n1 | yes | yes |\n", ": nothing is said of trees 1"),
        ("", ": nothing is said of trees 1, 2"),
    ],
)
def test_what_is_wrong_on_a_sheet_is_told_by_line(tmp_path, text, said):
    path = written(tmp_path, text)
    with pytest.raises(ReadError) as caught:
        read_sheet(path, 2)
    assert caught.value.message.startswith(str(path) + said)
    assert caught.value.hint


def test_a_sheet_that_is_no_text_is_told(tmp_path):
    path = tmp_path / "sheet"
    path.write_bytes("café".encode("latin-1"))
    with pytest.raises(ReadError, match="cannot be read"):
        read_sheet(path, 1)
    with pytest.raises(ReadError, match="cannot be read"):
        read_sheet(tmp_path / "none", 1)


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
    assert (code, said.splitlines()[0]) == (1, "words.md:1: no line of a tree")


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
