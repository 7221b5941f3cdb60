"""A task tree names for each step where it was seen, in every form; the file of a tree is no video of its own."""

from __future__ import annotations

import json
from xml.etree import ElementTree as ET

import pytest
from kitchen_stories import SALAD, node, subgraph, unit
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.loaders import read_text, write_text
from foon_kg.model import Recipe, Sighting
from foon_kg.model.tree import Step
from foon_kg.plans.result import PlanResult, ReferenceSummary

GOAL = node("salad(mixed){onion,salt,tomato}@bowl")
PLACES = (
    (Sighting("greek", 4, "http://videos.org/greek", 70.0, 71.5), Sighting("bean", 2)),
    (),
    (Sighting("bean", 3), Sighting("winter", 1, "http://videos.org/winter", 5.25, 9.0)),
)
STEPS = tuple(
    Step.of_unit(unit(line), "foon", places) for line, places in zip(SALAD, (*PLACES, *[()] * 9), strict=False)
)
PLAN = PlanResult(Recipe("salad", (), id="dish"), ReferenceSummary(GOAL, 8, 1, exact=True), GOAL, STEPS, ())


def run(*words, text=None):
    answer = CliRunner().invoke(app, list(map(str, words)), input=text)
    assert answer.exit_code == 0, answer.output
    return answer


def actions(xml):
    return [action.attrib for action in ET.fromstring(xml).iterfind(".//Sequence/Action")]


@pytest.mark.parametrize("form", ["foon", "json"])
def test_the_text_of_a_plan_keeps_where_each_step_was_seen(tmp_path, form):
    written = tmp_path / "anything.txt"
    run("export", "-", "-f", form, "-o", written, "-q", text=json.dumps(PLAN.to_json()))
    told, again = (
        actions(run("export", name, "-f", "behaviour-tree", "-q", text=json.dumps(PLAN.to_json())).stdout)
        for name in ("-", written)
    )
    for name in ("video", "unit", "address", "start", "end"):
        assert [one.get(name) for one in again] == [one.get(name) for one in told]
    assert [one.get("video") for one in again][:4] == ["greek", None, "winter", None]


def test_a_step_that_was_seen_nowhere_names_no_video_and_no_file(tmp_path):
    nowhere = tmp_path / "tree.txt"
    steps = tuple(Step.of_unit(unit(line), "adapted", ()) for line in SALAD)
    never_seen = PlanResult(PLAN.recipe, PLAN.reference, GOAL, steps, ())
    nowhere.write_text(write_text(never_seen.to_subgraph()), encoding="utf-8")
    assert not any("video" in one for one in actions(run("export", nowhere, "-f", "behaviour-tree", "-q").stdout))
    assert "(tree)" not in run("export", nowhere, "-f", "markdown", "-q").stdout


def test_a_video_of_its_own_is_where_its_units_were_seen(tmp_path):
    path = tmp_path / "story.txt"
    path.write_text(write_text(subgraph("story", "salad", *SALAD)), encoding="utf-8")
    assert {one["video"] for one in actions(run("export", path, "-f", "behaviour-tree").stdout)} == {"story"}


def test_the_video_and_the_unit_are_those_of_the_json_and_the_address_is_beside_them():
    first, _, third, *_ = actions(run("export", "-", "-f", "behaviour-tree", text=json.dumps(PLAN.to_json())).stdout)
    assert (first["video"], first["unit"], first["address"], first["start"]) == (
        "greek", "4", "http://videos.org/greek", "70",
    )  # fmt: skip
    assert (third["video"], third["unit"], third["start"], third["end"]) == ("winter", "1", "5.25", "9")


@pytest.mark.parametrize(
    "line", ["# Seen in: by all", "# Seen in:\ta\tx\t\t\t", "# Seen in:\ta\t1\tnan\t2\t", "# seen"]
)
def test_other_comments_say_nothing(line):
    text = write_text(subgraph("story", "salad", *SALAD))
    assert read_text(text.replace("//\n", f"//\n{line}\n", 1), "story").subgraph == read_text(text, "story").subgraph


@pytest.fixture
def retrieved(tmp_path):
    """A retrieved tree as JSON, found with a weight of one motion."""
    (tmp_path / "files").mkdir()
    story = subgraph("story", "salad", *SALAD)
    (tmp_path / "files" / "story.txt").write_text(write_text(story), encoding="utf-8")
    (tmp_path / "weights.json").write_text('{"chop": 0.9}', encoding="utf-8")
    asked = ("retrieve", "salad", "--weights", tmp_path / "weights.json", "--files", tmp_path / "files", "-q")
    path = tmp_path / "r.json"
    path.write_text(run(*asked, "--json").stdout, encoding="utf-8")
    (tmp_path / "r.txt").write_text(run(*asked, "--foon").stdout, encoding="utf-8")
    return path


def test_a_retrieved_tree_goes_to_a_robot_with_its_videos_and_its_success(retrieved):
    answer = run("export", retrieved, "-f", "behaviour-tree")
    assert answer.stderr == ""
    told = actions(answer.stdout)
    assert {one["video"] for one in told} == {"story"}
    assert {one["ID"]: one.get("success_rate") for one in told}["ChopMotion"] == "0.1"
    assert {one.get("success_rate") for one in told} == {"0.1", None}
    assert [one["moving"] for one in told] == [
        one["moving"] for one in actions(run("export", retrieved.with_suffix(".txt"), "-f", "behaviour-tree").stdout)
    ]


def test_a_retrieved_tree_is_a_planning_problem(retrieved, tmp_path):
    steps = len(json.loads(retrieved.read_text(encoding="utf-8"))["units"])
    run("export", retrieved, "-f", "pddl", "-o", tmp_path / "pddl")
    plan = (tmp_path / "pddl" / "salad.plan").read_text(encoding="utf-8")
    assert sum(line.startswith("(") for line in plan.splitlines()) == steps > 3


def test_a_retrieved_tree_is_shown(retrieved, tmp_path):
    shown = run("show", retrieved).stdout
    assert "makes salad (mixed" in shown
    assert "Chop the onion" in shown
    run("show", retrieved, "-o", tmp_path / "tree.svg")
    assert (tmp_path / "tree.svg").stat().st_size > 1000


def test_an_answer_without_a_tree_says_so(tmp_path):
    failed = {"error": {"code": "no-way", "message": "nothing makes salad", "hint": "Ask less."}}
    for words in (("export", "-", "-f", "dot"), ("show", "-")):
        answer = CliRunner().invoke(app, list(words), input=json.dumps(failed))
        assert answer.exit_code == 3, answer.output
        assert "nothing makes salad" in answer.stderr
