"""``foon export``: which format, from what, to where."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from kitchen_stories import SALAD, node, subgraph, unit
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.formats.exports.formats import ENDINGS
from foon_kg.loaders import read_json, read_text, read_weights, write_json, write_text
from foon_kg.model import Recipe, RequiredIngredient, Sighting
from foon_kg.model.tree import Step
from foon_kg.plans.result import PlanFailure, PlanResult, ReferenceSummary
from foon_kg.store.graph import Connection, load, load_weights

STORY = subgraph("story", "salad", *SALAD)
SALAD_NODE = node("salad(mixed){onion,salt,tomato}@bowl")
PLAN = PlanResult(
    Recipe("salad", (RequiredIngredient("onion", "chopped"),), id="dish/1"),
    ReferenceSummary(SALAD_NODE, 8, 1, exact=True),
    SALAD_NODE,
    tuple(Step.of_unit(unit(line), "foon", (Sighting("story", place),)) for place, line in enumerate(SALAD)),
    (node("onion(whole)"), node("tomato(whole)"), node("knife")),
)
FAILURE = PlanFailure(Recipe("pie", ()), "no-goal", "no pie is known")


@pytest.fixture
def export(tmp_path):
    def run(*words, **options):
        return CliRunner().invoke(app, ["export", *map(str, words)], **options)

    return run


@pytest.fixture
def story(tmp_path):
    path = tmp_path / "story.txt"
    path.write_text(write_text(STORY), encoding="utf-8")
    return path


@pytest.fixture
def plans(tmp_path):
    path = tmp_path / "plans.jsonl"
    path.write_text("".join(json.dumps(one.to_json()) + "\n" for one in (PLAN, FAILURE, PLAN)), encoding="utf-8")
    return path


def test_foon_text_and_json_go_round(export, story, tmp_path):
    there = export(story, "--output", tmp_path / "story.json")
    assert (there.exit_code, there.output) == (0, "")
    assert read_json((tmp_path / "story.json").read_text(encoding="utf-8"), "story").subgraph == STORY
    back = export(tmp_path / "story.json", "--format", "foon")
    assert read_text(back.stdout, "story").subgraph == STORY
    assert back.stdout == story.read_text(encoding="utf-8")


def test_the_ending_chooses_the_format(export, story, tmp_path):
    begins = {".dot": "digraph", ".mmd": "---", ".graphml": "<?xml", ".md": "# ", ".xml": "<?xml", ".foon": "//"}
    for ending, begin in begins.items():
        output = tmp_path / f"deep/tree{ending}"
        assert export(story, "-o", output).exit_code == 0
        assert output.read_text(encoding="utf-8").startswith(begin)


def test_many_trees_are_files_of_their_own_and_what_is_no_tree_is_told(export, plans, tmp_path):
    answer = export(plans, "--format", "pddl", "--output", tmp_path / "out")
    assert answer.exit_code == 0
    assert answer.stderr == f"{plans}:2: no tree: no pie is known\n"
    written = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert len(written) == 6
    assert {"dish_1-domain.pddl", "dish_1-problem.pddl", "dish_1.plan", "dish_1-2.plan"} <= set(written)


def test_standard_input_is_read_and_standard_output_written(export):
    answer = export("-", "-f", "markdown", input=json.dumps(PLAN.to_json()))
    assert (answer.exit_code, answer.stderr) == (0, "")
    assert "\n5. Chop the onion on the cutting board with the knife." in answer.stdout


def test_amounts_come_from_the_recipe(export, plans, tmp_path):
    recipe = tmp_path / "recipe.json"
    onion = {"object": "Onions", "state": "chopped", "quantity": 2, "unit": "cups"}
    recipe.write_text(json.dumps({"type": "salad", "ingredients": [onion]}), encoding="utf-8")
    answer = export(plans, "-f", "markdown", "--recipe", recipe, "-o", tmp_path / "out/")
    assert answer.exit_code == 0
    assert "- 2 cups onion, chopped\n" in (tmp_path / "out/dish_1.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("form", ["foon", "json", "dot", "mermaid", "graphml", "csv"])
def test_a_whole_foon_is_exported_from_files(export, story, tmp_path, form):
    output = tmp_path / "out"
    output.mkdir()
    answer = export("--files", story, "--format", form, "--output", output, "-q")
    assert (answer.exit_code, answer.stderr) == (0, "")
    assert all(path.stat().st_size for path in output.iterdir())


def test_weights_go_round_and_are_on_the_motion_nodes(export, story, tmp_path):
    given = tmp_path / "weights.json"
    given.write_text('{"chop": 0.25, "pour": 1, "bird\'s nest": 0}', encoding="utf-8")
    written = tmp_path / "motion_cost.json"
    answer = export("--files", story, "--weights", given, "-f", "weights", "-o", written)
    assert (answer.exit_code, answer.output) == (0, "")
    assert read_weights(written) == read_weights(given)
    for source in ((story,), ("--files", story)):
        drawn = export(*source, "--weights", written, "-f", "graphml")
        assert '<data key="success_rate">0.75</data>' in drawn.stdout


def test_weights_of_a_file_need_no_foon(export, tmp_path, monkeypatch):
    def refused(_):
        raise AssertionError("a Neo4j was asked for")

    monkeypatch.setattr("foon_kg.store.server.connection_settings", refused)
    given = tmp_path / "weights.json"
    given.write_text('{"chop": 0.25}', encoding="utf-8")
    answer = export("--weights", given, "-f", "weights", "-o", tmp_path / "again.json")
    assert (answer.exit_code, answer.output) == (0, "")
    assert read_weights(tmp_path / "again.json") == read_weights(given)


@pytest.mark.neo4j
def test_stored_weights_are_exported_with_the_graph(export, empty_graph, tmp_path, monkeypatch):
    costs = MotionCosts({"chop": 0.25})
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    with Connection(empty_graph) as connection:
        load(connection, [STORY])
        assert export("-f", "weights").exit_code == 2
        load_weights(connection, costs)
    answer = export("-f", "weights", "-o", tmp_path / "weights.json", "-q")
    assert (answer.exit_code, answer.output) == (0, "")
    assert read_weights(tmp_path / "weights.json") == costs
    assert '<data key="success_rate">0.75</data>' in export("-f", "graphml", "-q").stdout


def test_a_problem_of_the_whole_foon_has_what_the_kitchen_file_names(export, story, tmp_path):
    kitchen = tmp_path / "kitchen.txt"
    kitchen.write_text("onion\nknife\n", encoding="utf-8")
    words = ("--files", story, "-f", "pddl", "--goal", "salad", "-o", tmp_path / "out", "-q")
    assert export(*words).exit_code == 0
    everything = (tmp_path / "out/salad-problem.pddl").read_text(encoding="utf-8")
    assert export(*words, "--kitchen", kitchen).exit_code == 0
    little = (tmp_path / "out/salad-problem.pddl").read_text(encoding="utf-8")
    assert everything.count("(at_hand") > little.count("(at_hand") > 1
    assert "tomato_whole" in everything
    assert "tomato_whole" not in little


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("{story}",), "say in which format"),
        (("{story}", "-f", "yaml"), "there is no format “yaml”"),
        (("{story}", "-f", "csv", "-o", "{folder}/x"), "a task tree cannot be written as csv"),
        (("--files", "{story}", "-f", "markdown"), "a whole FOON cannot be written as markdown"),
        (("--files", "{story}", "-f", "pddl"), "needs a goal"),
        (("--files", "{story}", "-f", "pddl", "--goal", "pie", "-o", "{folder}/x"), "FOON is called “pie”"),
        (("{story}", "-f", "pddl"), "these are 3 files"),
        (("{story}", "-f", "dot", "--goal", "salad"), "--goal means nothing for task trees"),
        (("--files", "{story}", "-f", "csv", "-o", "{folder}/x", "--goal", "pie"), "--goal means nothing for csv"),
        (("--files", "{story}", "-f", "dot", "--kitchen", "{story}"), "--kitchen means nothing for dot"),
        (("{story}", "-f", "dot", "--recipe", "{story}"), "--recipe means nothing for dot"),
        (("{story}", "-f", "dot", "--weights", "{story}"), "--weights means nothing for dot"),
        (("--files", "{story}", "-f", "weights"), "has no weights of motions"),
        (("{story}", "-f", "weights"), "a task tree cannot be written as weights"),
        (("{story}", "-f", "pddl", "-o", "{story}"), "is read, and would be written over"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_wrong_usage_and_says_why(export, story, tmp_path, words, says):
    answer = export(*(word.format(story=story, folder=tmp_path) for word in words))
    assert answer.exit_code == 2, answer.output
    assert says in answer.stderr
    assert "hint: " in answer.stderr
    assert not (tmp_path / "x").exists()


def test_an_answer_without_a_tree_is_told_as_such(export):
    answer = export("-", "-f", "dot", input=json.dumps(FAILURE.to_json()))
    assert answer.exit_code == 3
    assert "no pie is known" in answer.stderr


def test_what_is_no_tree_names_its_file_and_line(export, tmp_path):
    path = tmp_path / "broken.json"
    path.write_text('{"recipe": {},\n "units": [}', encoding="utf-8")
    answer = export(path, "-f", "dot")
    assert answer.exit_code == 1
    assert f"{path}:2: " in answer.stderr


@pytest.mark.slow
def test_equal_trees_are_equal_files_in_every_run(story, tmp_path):
    whole = tmp_path / "whole"
    whole.mkdir()
    (whole / "a.json").write_text(write_json(STORY), encoding="utf-8")
    program = (
        "import sys, hashlib; from pathlib import Path\n"
        "from typer.testing import CliRunner; from foon_kg.cli import app\n"
        "run = lambda *w: CliRunner().invoke(app, ['export', *w])\n"
        "story, whole, out = sys.argv[1:]\n"
        "for f in ('foon', 'json', 'dot', 'mermaid', 'graphml', 'markdown', 'behaviour-tree', 'pddl'):\n"
        "    assert run(story, '-f', f, '-o', out + '/tree-' + f + '/').exit_code == 0, f\n"
        "for f in ('json', 'dot', 'mermaid', 'graphml', 'csv'):\n"
        "    assert run('--files', whole, '-f', f, '-o', out + '/' + f + '/').exit_code == 0, f\n"
        "for path in sorted(Path(out).rglob('*.*')): print(path.name, hashlib.sha256(path.read_bytes()).hexdigest())\n"
    )
    answers = set()
    for seed in ("1", "2"):
        command = [sys.executable, "-c", program, str(story), str(whole), str(tmp_path / seed)]
        environment = os.environ | {"PYTHONHASHSEED": seed}
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        assert done.returncode == 0, done.stderr
        answers.add(done.stdout)
    assert len(answers) == 1
    assert len(answers.pop().splitlines()) > len(ENDINGS)


def test_going_on_is_for_robots_and_for_numbered_things(export, story, plans, tmp_path):
    for words, why in (
        ((plans, "--format", "behaviour-tree", "--after-step", 2), "its things have no numbers"),
        ((story, "--format", "pddl", "--after-step", 2), "its things have no numbers"),
        ((story, "--format", "dot", "--after-step", 2), "--after-step means nothing for dot"),
        ((story, "--format", "pddl", "--after-step", len(SALAD)), "none is left"),
        (("--format", "pddl", "--after-step", 2), "--after-step means nothing for a whole FOON"),
    ):
        answer = export(*words, "--output", tmp_path / "rest")
        assert answer.exit_code in {1, 2}
        assert why in answer.stderr
    assert not (tmp_path / "rest").exists()
