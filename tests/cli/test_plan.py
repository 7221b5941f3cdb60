"""``foon plan``: data on stdout, messages on stderr, and exit codes that scripts can rely on."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.loaders import read_text
from foon_kg.plans.result import PlanFailure, PlanResult

SALAD = ["--dish", "salad", "chopped onion", "chopped tomato", "olive oil", "salt"]


@pytest.fixture
def foon():
    """``foon plan`` from the demo's files."""
    return lambda *arguments: CliRunner().invoke(app, ["plan", *map(str, arguments), "--files", str(demo_folder())])


def recipe_file(folder, name, **fields):
    path = folder / f"{name}.json"
    path.write_text(json.dumps(fields), encoding="utf-8")
    return path


def asked(*foods):
    return [{"object": food, "state": state} for food, state in foods]


@pytest.mark.slow
def test_a_plan_in_words_shows_steps_kitchen_and_progress(foon):
    answer = foon(*SALAD)
    assert answer.exit_code == 0, answer.stderr
    for title in ("dish", "asked", "makes", "like", "Steps", "Kitchen", "Progress of each ingredient"):
        assert f"\n{title}" in f"\n{answer.stdout}"
    assert "Chop the onion on the cutting board with the knife." in " ".join(answer.stdout.split())
    assert "no state is named for some foods, taken as usual: " in answer.stderr
    assert "olive oil (liquid)" in answer.stderr
    assert "\x1b[" not in answer.stdout
    assert not any(line.endswith(" ") for line in answer.stdout.splitlines())


def test_what_a_dish_is_called_is_read(foon, tmp_path):
    soup = ("--dish", "soup", "chopped parsnip", "chopped onion", "water", "--json", "--quiet")
    plain, creamy = (json.loads(foon(*soup, *more).stdout) for more in ((), ("--title", "Cream of parsnip soup")))
    assert "blend" not in {unit["motion_node"] for unit in plain["units"]}
    assert "blend" in {unit["motion_node"] for unit in creamy["units"]}
    assert (plain["recipe"]["title"], creamy["recipe"]["title"]) == (None, "Cream of parsnip soup")
    recipe_file(tmp_path, "1", type="salad", ingredients=asked(("onion", "chopped")))
    refused = foon(tmp_path, "--title", "a salad")
    assert (refused.exit_code, refused.stdout) == (2, "")
    assert "--title is for ingredients in words" in refused.stderr


@pytest.mark.slow
def test_json_is_one_result_on_stdout_and_quiet_keeps_stderr_empty(foon):
    answer = foon(*SALAD, "--json", "--quiet")
    assert answer.stderr == ""
    (line,) = answer.stdout.splitlines()
    result = PlanResult.from_json(json.loads(line))
    assert result.goal in result.units[-1].output_nodes
    assert [(i.object, i.state) for i in result.recipe.ingredients] == [
        ("onion", "chopped"),
        ("tomato", "chopped"),
        ("olive oil", "liquid"),
        ("salt", "granulated"),
    ]
    assert {line.ingredient for line in result.progress_lines} == {"onion", "tomato", "olive oil", "salt"}
    assert all(line.end_product == result.goal.label for line in result.progress_lines)


@pytest.mark.slow
def test_foon_text_is_read_back_as_the_same_steps(foon):
    text = foon(*SALAD, "--foon", "--quiet").stdout
    result = PlanResult.from_json(json.loads(foon(*SALAD, "--json").stdout))
    read = read_text(text, "plan", "plan.txt")
    assert read.notices == ()
    units = [annotation.unit for annotation in read.subgraph.annotations]
    assert [(u.input_nodes, u.motion, u.output_nodes) for u in units] == [
        (u.input_nodes, u.motion, u.output_nodes) for u in result.units
    ]
    assert [p.dish_type for p in units[-1].outputs if p.node == result.goal] == ["salad"]


@pytest.mark.slow
def test_the_same_question_has_the_same_answer(foon):
    assert foon(*SALAD, "--json").stdout == foon(*SALAD, "--json").stdout


@pytest.mark.slow
def test_many_recipes_are_lines_in_their_order_and_a_failure_is_a_line_too(foon, tmp_path):
    good = recipe_file(tmp_path, "b", type="salad", ingredients=asked(("onion", "chopped"), ("salt", "granulated")))
    unreadable = tmp_path / "a.json"
    unreadable.write_text("{", encoding="utf-8")
    no_goal = recipe_file(tmp_path, "c", id="Pie", type="pie", ingredients=asked(("apple", "chopped")))
    answer = foon(good, unreadable, no_goal, good, "--json")
    values = [json.loads(line) for line in answer.stdout.splitlines()]
    assert [value["recipe"]["id"] for value in values] == ["b", "a", "Pie", "b"]
    assert ["error" in value for value in values] == [False, True, True, False]
    assert [PlanFailure.from_json(values[place]).code for place in (1, 2)] == ["read", "no-goal"]
    assert values[0] == values[3]
    assert answer.exit_code == 3
    assert "error: a: " in answer.stderr
    assert "error: Pie: this FOON has no pie" in answer.stderr


@pytest.mark.slow
def test_a_folder_of_recipes_is_planned_whole(foon, tmp_path):
    for name in ("2", "1"):
        recipe_file(tmp_path, name, type="salad", ingredients=asked(("onion", "chopped")))
    answer = foon(tmp_path, "--json")
    assert [json.loads(line)["recipe"]["id"] for line in answer.stdout.splitlines()] == ["1", "2"]
    assert answer.exit_code == 0


@pytest.mark.slow
def test_a_recipe_has_the_same_tree_alone_and_among_others(foon):
    among = foon(*demo_recipes(), "--json").stdout.splitlines(keepends=True)
    assert [foon(recipe, "--json").stdout for recipe in demo_recipes()] == among


@pytest.mark.slow
def test_an_ingredient_asked_twice_stays_twice_in_the_recipe(foon, tmp_path):
    twice = asked(("onion", "chopped"), ("onion", "chopped"))
    answer = foon(recipe_file(tmp_path, "r", type="salad", ingredients=twice), "--json")
    assert json.loads(answer.stdout)["recipe"]["ingredients"] == twice


def test_an_empty_name_is_reported_and_left_out(foon, tmp_path):
    path = recipe_file(tmp_path, "r", type="salad", ingredients=asked(("", "raw"), ("onion", "chopped")))
    answer = foon(path, "--json")
    assert f"{path}: ingredients[0]: “object” is empty; the ingredient is left out" in answer.stderr
    assert json.loads(answer.stdout)["recipe"]["ingredients"] == asked(("onion", "chopped"))


def test_no_tree_is_exit_code_3_with_a_reason_and_a_hint(foon):
    answer = foon("--dish", "pie", "chopped apple")
    assert (answer.exit_code, answer.stdout) == (3, "")
    error, hint = answer.stderr.splitlines()
    assert error == "error: this FOON has no pie"
    assert hint.startswith("hint: ")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--dish", "salat", "chopped onion"], "“salat” is no dish type"),
        (["nowhere.json"], "there is no file or folder nowhere.json"),
        (["--dish", "salad", " "], "an ingredient is empty"),
        (["--dish", "salad"], "say what to plan"),
        (["--fish", "salad", "onion"], "no such option"),
    ],
)
def test_wrong_usage_is_exit_code_2_and_nothing_on_stdout(foon, arguments, message):
    answer = foon(*arguments)
    assert (answer.exit_code, answer.stdout) == (2, "")
    assert message in answer.stderr


def test_a_dish_by_its_own_name_is_of_the_type_that_it_is_known_to_be(foon, tmp_path):
    answer = foon("--dish", "Coleslaw", "chopped onion", "olive oil", "--json")
    assert "“Coleslaw” is no dish type by itself: planned as salad, called Coleslaw" in answer.stderr
    asked_for = json.loads(answer.stdout)["recipe"]
    assert (asked_for["dish_type"], asked_for["title"]) == ("salad", "Coleslaw")
    path = recipe_file(tmp_path, "r", type="coleslaw", title="mine", ingredients=asked(("onion", "chopped")))
    from_file = json.loads(foon(path, "--json").stdout)["recipe"]
    assert (from_file["dish_type"], from_file["title"]) == ("salad", "mine")


def test_two_forms_of_one_answer_are_refused_in_json(foon):
    answer = foon(*SALAD, "--json", "--foon")
    assert (answer.exit_code, json.loads(answer.stdout)["error"]["code"]) == (2, "usage")


def test_foon_text_of_many_recipes_is_refused(foon, tmp_path):
    for name in ("1", "2"):
        recipe_file(tmp_path, name, type="salad", ingredients=asked(("onion", "chopped")))
    answer = foon(tmp_path, "--foon")
    assert (answer.exit_code, answer.stdout) == (2, "")
    assert "--foon prints one tree, and these are 2 recipes" in answer.stderr


@pytest.mark.parametrize(("folder", "exit_code"), [("nowhere", 2), ("here", 1)])
def test_files_without_a_subgraph_are_an_error_that_names_them(tmp_path, folder, exit_code):
    (tmp_path / "here").mkdir()
    (tmp_path / "here" / "notes.md").write_text("hello")
    answer = CliRunner().invoke(app, ["plan", *SALAD, "--files", str(tmp_path / folder)])
    assert (answer.exit_code, answer.stdout) == (exit_code, "")
    assert str(tmp_path / folder) in answer.stderr.splitlines()[0]


@pytest.mark.slow
def test_every_recipe_of_the_demo_has_a_tree(foon):
    answer = foon(*demo_recipes(), "--json")
    assert answer.exit_code == 0, answer.stderr
    assert len(answer.stdout.splitlines()) == len(demo_recipes())


def test_the_demo_reads_its_own_foon_without_a_remark():
    assert len(demo_subgraphs()) == len(list(demo_folder().glob("*.txt"))) >= 15


@pytest.mark.slow
def test_the_papers_own_method_is_there_to_compare(foon):
    asked_for = ("--dish", "salad", "chopped onion", "chopped tomato", "liquid olive oil", "--json")
    ours, theirs = (json.loads(foon(*asked_for, "--method", name).stdout) for name in ("frames", "paper"))
    assert ours["units"][0]["phase"] == "prepare"
    assert "phase" not in theirs["units"][0]
    assert {unit["origin"] for unit in theirs["units"]} <= {"foon", "adapted"}
    assert ours == json.loads(foon(*asked_for).stdout)


@pytest.mark.parametrize(
    "wish", [("--explain",), ("--enumerate",), ("--avoid", "salt"), ("--substitute", "leek=onion"), ("--kitchen", "k")]
)
def test_the_papers_own_method_knows_nothing_of_wishes(foon, wish, tmp_path):
    wish = (wish[0], tmp_path / "k") if wish[0] == "--kitchen" else wish
    answer = foon("--dish", "salad", "chopped onion", "--method", "paper", *wish)
    assert (answer.exit_code, answer.stdout) == (2, "")
    assert f"the paper's method knows nothing of {wish[0]}" in answer.stderr
