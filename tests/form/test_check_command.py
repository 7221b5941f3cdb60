"""``foon check``: what it prints and how it exits, for plan results and for FOON text."""

from __future__ import annotations

import json

import pytest
from form.garden import GARDEN, SUBGRAPHS, garden, garnished, salad
from kitchen_stories import subgraph
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.loaders import write_text


@pytest.fixture
def foon(tmp_path):
    folder = tmp_path / "foon"
    folder.mkdir()
    for one in SUBGRAPHS:
        (folder / f"{one.name}.txt").write_text(write_text(one), encoding="utf-8")
    return folder


@pytest.fixture
def check(foon, tmp_path):
    def run(text, *options, name="tree.json", stdin=None):
        (tmp_path / name).write_text(text, encoding="utf-8")
        source = "-" if stdin is not None else str(tmp_path / name)
        return CliRunner().invoke(app, ["check", source, "--files", str(foon), *options], input=stdin)

    return run


def unsound():
    tree = salad()
    tree["kitchen"] = [node for node in tree["kitchen"] if node["label"] != "knife"]
    return tree


def test_a_sound_tree(check):
    result = check(json.dumps(salad()))
    assert (result.exit_code, result.stdout) == (0, "r1: sound\n")


def test_an_unsound_tree_says_rule_unit_node_and_reason(check):
    result = check(json.dumps(unsound()))
    assert result.exit_code == 1
    assert result.stdout.splitlines() == [
        "r1: not sound (C1)",
        "  C1 unit 1 knife: it is neither in the kitchen nor an output of an earlier unit",
    ]


def test_sense_is_asked_on_request_only(check):
    tree = salad()
    tree["substitutions"][0]["confidence"] = 0.3
    assert check(json.dumps(tree)).exit_code == 0
    result = check(json.dumps(tree), "--sense")
    assert result.exit_code == 1
    assert result.stdout.startswith("r1: sound, not clean (S5)\n")
    assert check(json.dumps(salad()), "--sense").stdout == "r1: clean\n"


def test_json_lines_in_and_out(check):
    lines = "\n".join(json.dumps(tree | {"recipe": tree["recipe"] | {"id": str(number)}})
                      for number, tree in enumerate([salad(), unsound(), garnished()]))  # fmt: skip
    result = check(lines, "--json", "--sense")
    reports = [json.loads(line) for line in result.stdout.splitlines()]
    assert [(r["name"], r["sound"], r["clean"]) for r in reports] == [
        ("0", True, True),
        ("1", False, False),
        ("2", True, True),
    ]
    (finding,) = reports[1]["findings"]
    assert (finding["rule"], finding["unit"], finding["node"]["label"]) == ("C1", 1, "knife")
    assert result.exit_code == 1


def test_json_spread_over_lines(check):
    assert check(json.dumps(salad(), indent=2)).exit_code == 0


def test_standard_input(check):
    assert check("", stdin=json.dumps(salad())).stdout == "r1: sound\n"


def test_different_answers_to_one_recipe(check):
    other = salad()
    other["substitutions"][0]["confidence"] = 0.9
    result = check("\n".join(map(json.dumps, [salad(), salad(), other])))
    assert result.exit_code == 1
    assert [line for line in result.stdout.splitlines() if "C9" in line and "unit" not in line] == [
        "r1: not sound (C9)",
        "  C9: answer 1 differs from the first in substitutions[0].confidence",
    ]


def test_a_failure_is_told_as_such(check):
    failure = {
        "recipe": salad()["recipe"],
        "error": {"code": "no-goal", "message": "this FOON has no salad", "hint": ""},
    }
    result = check(json.dumps(failure))
    assert result.exit_code == 1
    assert "there is no tree: this FOON has no salad" in result.stdout


def test_foon_text_and_what_was_not_asked(check):
    result = check(write_text(subgraph("mine", "salad", *GARDEN)), name="mine.txt")
    assert result.exit_code == 0
    assert result.stdout.splitlines() == [
        "mine: sound",
        "  C4 not asked: no recipe is known",
        "  C5 not asked: no recipe is known",
    ]


def test_foon_text_with_its_recipe(check, tmp_path):
    asked = garden()["recipe"] | {"type": "salad"}
    asked["ingredients"] = asked["ingredients"][:2]
    (tmp_path / "recipe.json").write_text(json.dumps(asked), encoding="utf-8")
    text = write_text(subgraph("mine", "salad", *GARDEN))
    result = check(text, "--recipe", str(tmp_path / "recipe.json"), name="mine.txt")
    assert result.exit_code == 1
    assert "salt comes from the kitchen and nobody asked for it" in result.stdout


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('{"recipe": 1}', "tree.json:1"),
        ('{"recipe": {}', "tree.json:1"),
        ("{}\n\n{,}", "tree.json"),
        ("", "no task tree"),
    ],
)
def test_what_is_no_tree_is_an_error_with_its_place(check, text, said):
    result = check(text)
    assert result.exit_code == 1
    assert said in result.stderr


def test_a_file_that_is_not_there(check):
    result = CliRunner().invoke(app, ["check", "nowhere.json", "--files", "nowhere"])
    assert result.exit_code == 2
