"""``foon evaluate trees``: anybody's task trees, and how many of them robot and cook accept."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner
from validation.soups import SOUP, SUBGRAPHS, salad, soup, without

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import write_text
from foon_kg.validation import RULES

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "data"


@pytest.fixture
def videos(tmp_path):
    folder = tmp_path / "videos"
    (folder / "more").mkdir(parents=True)
    for one, place in zip(SUBGRAPHS, (folder, folder / "more"), strict=True):
        (place / f"{one.name}.txt").write_text(write_text(one), encoding="utf-8")
    return folder


@pytest.fixture
def evaluate(videos):
    def run(*arguments, files=videos):
        return CliRunner().invoke(app, ["evaluate", "trees", *map(str, arguments), "--files", str(files)])

    return run


@pytest.fixture
def plans(tmp_path):
    """Four answers of a planner: two good trees, one that nobody can carry out, and a failure."""
    trees = [salad(), soup(), soup(without(SOUP, 6))]
    failure = {"recipe": salad()["recipe"], "error": {"code": "no-goal", "message": "no salad here", "hint": ""}}
    path = tmp_path / "plans.jsonl"
    path.write_text("\n".join(map(json.dumps, [*trees, failure])), encoding="utf-8")
    return path


def printed(answer):
    assert answer.exit_code == 0, answer.output
    return json.loads(answer.stdout)


def test_a_folder_of_recorded_videos_is_read_whole_and_told_by_dish_type(evaluate, videos):
    value = printed(evaluate(videos, "--json"))
    assert value["evaluation"] == "trees"
    assert [(one["id"], one["dish_type"], one["accepted"], one["form"]) for one in value["trees"]] == [
        ("carrot_soup", "soup", True, True),
        ("tomato_salad", "salad", True, True),
    ]
    assert [(d["dish_type"], d["trees"], d["robot"], d["cook"], d["accepted"]) for d in value["dish_types"]] == [
        ("salad", 1, 1, 1, 1),
        ("soup", 1, 1, 1, 1),
        ("all", 2, 2, 2, 2),
    ]
    assert value["dish_types"][-1]["rules"]["C4"] == {"kept": 0, "asked": 0, "fatal": 0, "minor": 0}


def test_plan_results_of_anybody_are_counted_and_a_failure_is_no_tree(evaluate, plans):
    value = printed(evaluate(plans, "--json"))
    every = value["dish_types"][-1]
    assert {name: every[name] for name in ("trees", "robot", "cook", "accepted")} == {
        "trees": 4, "robot": 2, "cook": 3, "accepted": 2,
    }  # fmt: skip
    assert list(every["rules"]) == list(RULES)
    assert every["rules"]["W3"] == {"kept": 2, "asked": 3, "fatal": 1, "minor": 0}
    spoilt, failed = value["trees"][2:]
    assert (spoilt["where"], "W3" in spoilt["fatal"], spoilt["robot"]) == (f"{plans}:3", True, False)
    assert (failed["accepted"], failed["fatal"], failed["error"]) == (False, [], "no salad here")


def test_the_tables_say_what_json_says(evaluate, plans, videos):
    shown = evaluate(plans, videos).stdout
    accepted = shown.split("\nAccepted\n")[1].split("\n\n")[0].splitlines()
    assert [line.split()[0] for line in accepted[1:]] == ["salad", "soup", "all"]
    assert " ".join(accepted[-1].split()) == "all 6 4 (67 %) 5 (83 %) 4 (67 %) 4 (67 %) 1"
    assert ["W3", "1", "1", "5"] in [line.split() for line in shown.splitlines()]
    assert "Without a tree, accepted by nobody\n  r1  salad  no salad here" in shown


def test_the_same_bytes_twice(evaluate, plans):
    assert evaluate(plans, "--json").stdout_bytes == evaluate(plans, "--json").stdout_bytes


def test_the_judge_of_foon_check_says_the_same(evaluate, plans, videos):
    checked = CliRunner().invoke(app, ["check", str(plans), "--files", str(videos), "--json"])
    reports = [json.loads(line) for line in checked.stdout.splitlines()]
    verdicts = ("robot", "cook", "accepted", "form")
    trees = printed(evaluate(plans, "--json"))["trees"]
    assert [[tree[v] for v in verdicts] for tree in trees] == [[report[v] for v in verdicts] for report in reports]


def test_what_holds_no_tree_is_passed_over_in_a_folder_and_refused_by_name(evaluate, videos):
    (videos / "notes.txt").write_text("about these videos", encoding="utf-8")
    (videos / ".hidden.txt").write_text("", encoding="utf-8")
    (videos / "table.csv").write_text("a,b\n", encoding="utf-8")
    answer = evaluate(videos, "--json")
    assert len(printed(answer)["trees"]) == 2
    assert [line for line in answer.stderr.splitlines() if "passed over" in line] == [
        f"passed over: {videos / 'notes.txt'}: no task tree in it"
    ]
    refused = evaluate(videos / "notes.txt")
    assert (refused.exit_code, refused.stdout) == (1, "")
    assert "no task tree in it" in refused.stderr


def test_a_folder_without_trees_is_an_error(evaluate, tmp_path):
    (tmp_path / "empty").mkdir()
    answer = evaluate(tmp_path / "empty")
    assert (answer.exit_code, answer.stdout) == (1, "")
    assert "no task tree in this folder" in answer.stderr


def test_a_tree_that_names_no_dish_type_counts_as_such(evaluate, tmp_path):
    bare = write_text(SUBGRAPHS[0]).replace("tomato salad\t0\t15", "tomato salad\t0")
    (tmp_path / "bare.txt").write_text(bare, encoding="utf-8")
    value = printed(evaluate(tmp_path / "bare.txt", "--json"))
    assert (value["trees"][0]["dish_type"], value["dish_types"][0]["dish_type"]) == ("", "no dish type")


def test_reference_trees_are_passed_over_with_a_word(evaluate, tmp_path, videos):
    asked = ["retrieve", "tomato salad", "--files", str(videos), "--json", "--quiet"]
    (tmp_path / "tree.json").write_text(CliRunner().invoke(app, asked).stdout, encoding="utf-8")
    alone = evaluate(tmp_path / "tree.json")
    assert alone.exit_code == 1
    assert "there is no tree to judge" in alone.stderr
    beside = evaluate(tmp_path / "tree.json", videos, "--json")
    assert len(printed(beside)["trees"]) == 2
    assert "1 reference trees are passed over" in beside.stderr


def test_the_demo_is_judged_whole(evaluate):
    value = printed(evaluate(demo_folder(), "--json", files=demo_folder()))
    every = value["dish_types"][-1]
    assert every["trees"] == len(value["trees"]) == len(list(demo_folder().glob("*.txt")))
    assert every["accepted"] <= min(every["robot"], every["cook"])


@pytest.mark.shared_data
def test_every_recorded_video_is_judged(evaluate):
    if not SHARED.exists():
        pytest.skip(f"the public data is not at {SHARED}")
    folder = SHARED / "foon-111" / "TXT"
    value = printed(evaluate(folder, "--json", "--quiet", files=folder))
    every = value["dish_types"][-1]
    assert every["trees"] == 111
    assert sum(dish["trees"] for dish in value["dish_types"][:-1]) == 111
