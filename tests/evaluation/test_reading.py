"""A reading: which trees are drawn and how they are printed, and what readers may write."""

from __future__ import annotations

import json
from collections import Counter

import pytest
from evaluation.readings import DISHES, failure, node, plan, planned, verdicts, video, written
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
from foon_kg.evaluation.reading_page import page, words_in
from foon_kg.evaluation.reading_sheet import Verdict, read_sheet, write_sheet
from foon_kg.model.errors import ReadError
from foon_kg.plans.kitchen import Kitchen

VIDEOS = video_trees([video(f"video{number}") for number in range(4)], Kitchen.default())


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
        ("1 | yes | yes\n2 | yes | yes |\n", ":1: this is no line about a tree"),
        ("number | robot | cook | faults\n", ":1: this is no line about a tree"),
        ("1 | yes | yes |\nSo far so good\n2 | yes | yes |\n", ":2: this is no line about a tree"),
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
