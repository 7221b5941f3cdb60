"""``foon evaluate recipes`` on the demo: figures, sheets, comparisons, and the same bytes whatever the way."""

from __future__ import annotations

import csv
import json
import shutil

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes


def evaluate(*arguments):
    return CliRunner().invoke(
        app, ["evaluate", "recipes", *map(str, arguments), "--files", str(demo_folder()), "--jobs", "1"]
    )


def printed(answer):
    assert answer.exit_code == 0, answer.output
    return json.loads(answer.stdout)


@pytest.fixture(scope="module")
def salads(tmp_path_factory):
    """Two dishes of the demo, one of a food that nobody knows, and a dish type of which the demo has no goal."""
    folder = tmp_path_factory.mktemp("recipes")
    for number, path in enumerate(sorted(demo_recipes())[:2]):
        recipe = json.loads(path.read_text(encoding="utf-8")) | {"id": f"recipe {number}"}
        (folder / f"{number}.json").write_text(json.dumps(recipe), encoding="utf-8")
    dish = json.loads((folder / "0.json").read_text())["type"]
    for name, dish_type in (("bare", dish), ("sausage", "sausage")):
        recipe = {"id": name, "type": dish_type, "ingredients": [{"object": "moon dust", "state": "polymerised"}]}
        (folder / f"{name}.json").write_text(json.dumps(recipe), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def answer(salads):
    return evaluate(salads, "--json")


def test_figures_are_those_of_the_recipes(answer):
    value = printed(answer)
    every = value["dish_types"][-1]
    lines = [line["score"] for recipe in value["recipes"] for line in recipe["lines"]]
    assert every["dish_type"] == "all"
    assert every["lines"] == len(lines)
    assert every["correct"]["mean"] == pytest.approx(sum(lines) / (2 * len(lines)), abs=1e-6)
    assert every["correct"]["low"] <= every["correct"]["mean"] <= every["correct"]["high"]
    assert [row["recipes"] for row in every["curve"]] == sorted((r["recipes"] for r in every["curve"]), reverse=True)
    assert [dish["dish_type"] for dish in value["left_out"]] == ["sausage"]


def test_what_robot_and_cook_accept_is_counted_of_all_recipes_asked(answer):
    value = printed(answer)
    every = value["dish_types"][-1]
    for verdict in ("robot", "cook", "accepted", "form"):
        assert every[verdict] == sum(recipe[verdict] for recipe in value["recipes"])
    for recipe in value["recipes"]:
        assert recipe["accepted"] == (recipe["robot"] and recipe["cook"])
        assert set(recipe["fatal"]) <= set(recipe["broken"]) <= set(every["rules"])
    for rule, count in every["rules"].items():
        assert count["fatal"] == sum(rule in recipe["fatal"] for recipe in value["recipes"])
        assert count["fatal"] + count["minor"] == sum(rule in recipe["broken"] for recipe in value["recipes"])
        assert count["kept"] == count["asked"] - count["fatal"] - count["minor"]


@pytest.mark.slow
def test_the_same_bytes_from_any_order_and_from_kept_plans(answer, salads, tmp_path):
    turned = tmp_path / "turned"
    turned.mkdir()
    for place, path in enumerate(sorted(salads.iterdir(), reverse=True)):
        shutil.copy(path, turned / f"{place}.json")
    plans = tmp_path / "plans.jsonl"
    assert evaluate(turned, "--json").stdout_bytes == answer.stdout_bytes
    assert evaluate(salads, "--json", "--output", plans).stdout_bytes == answer.stdout_bytes
    kept = plans.read_bytes()
    plans.write_bytes(kept[: len(kept) // 2])  # a run that was stopped
    assert evaluate(salads, "--json", "--output", plans).stdout_bytes == answer.stdout_bytes
    assert plans.read_bytes() == kept


def test_the_tables_say_what_json_says(salads, answer):
    shown = evaluate(salads)
    every = printed(answer)["dish_types"][-1]
    assert f"{100 * every['correct']['mean']:.1f} %" in shown.stdout
    accepted = shown.stdout.split("Accepted, of all recipes asked")[1].split("\n\n")[0].splitlines()
    assert f"{every['accepted']} ({100 * every['accepted'] / every['recipes']:.0f} %)" in accepted[-1]
    assert "Left out: fewer than 3 goals in the FOON\n  sausage" in shown.stdout


@pytest.mark.slow
def test_an_evaluation_compared_with_itself_changed_nothing(salads, answer, tmp_path):
    old = tmp_path / "old.json"
    old.write_bytes(answer.stdout_bytes)
    assert printed(evaluate(salads, "--json", "--compare", old))["comparison"]["verdict"] == "nothing changed"
    assert "nothing changed" in evaluate(salads, "--compare", old).stdout


@pytest.mark.slow
def test_people_who_score_like_the_rule_agree_fully(salads, answer, tmp_path):
    sheet = tmp_path / "sheet.csv"
    rule = {
        (recipe["id"], line["object"], line["state"]): line["score"]
        for recipe in printed(evaluate(salads, "--json", "--scores-to", sheet))["recipes"]
        for line in recipe["lines"]
    }
    with sheet.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        row["score"] = rule[row["recipe"], row["ingredient"], row["state"]]
    with sheet.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    found = printed(evaluate(salads, "--json", "--scores", sheet))["agreement"]
    assert (found["lines"], found["same"]) == (len(rows), 1)
    assert "kappa" in evaluate(salads, "--scores", sheet).stdout


@pytest.mark.slow
def test_a_recipe_without_a_tree_counts_as_nothing_and_is_named(tmp_path):
    recipe = json.loads(min(demo_recipes()).read_text(encoding="utf-8"))
    empty = {"id": "empty", "type": recipe["type"], "ingredients": []}
    (tmp_path / "empty.json").write_text(json.dumps(empty))
    found = printed(evaluate(tmp_path, "--json"))
    assert found["recipes"][0]["correct"] == 0
    assert not any(found["recipes"][0][verdict] for verdict in ("robot", "cook", "accepted", "form"))
    assert all(count["asked"] == 0 for count in found["dish_types"][-1]["rules"].values())
    assert found["dish_types"][-1]["without_tree"] == ["empty"]
    assert "Without a tree, counted as 0\n  empty" in evaluate(tmp_path).stdout


@pytest.mark.parametrize(
    ("arguments", "said"),
    [(["--dish", "nectar"], "“nectar” is no dish type"), (["--dish", "pork"], "no such recipe")],
)
def test_what_cannot_be_asked_is_told(salads, arguments, said):
    answer = evaluate(salads, *arguments)
    assert answer.exit_code == 2
    assert said in answer.stderr


def test_two_recipes_of_one_name_are_refused(salads, tmp_path):
    for name in "ab":
        shutil.copy(salads / "0.json", tmp_path / f"{name}.json")
    answer = evaluate(tmp_path)
    assert answer.exit_code == 1
    assert "two recipes are called “recipe 0”" in answer.stderr


@pytest.mark.slow
def test_the_papers_own_method_can_be_evaluated_beside_ours():
    recipe = next(path for path in demo_recipes() if path.stem == "tomato_salad")
    ours, theirs = (
        json.loads(
            CliRunner()
            .invoke(app, ["evaluate", "recipes", str(recipe), "--files", str(demo_folder()), "--json", *method])
            .stdout
        )["dish_types"][-1]
        for method in ([], ["--method", "paper"])
    )
    assert ours["accepted"] == 1
    assert theirs["accepted"] == 0
