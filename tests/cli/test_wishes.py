"""``foon plan`` with a person's wishes: ``--substitute``, ``--avoid``, and ``--explain``."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.plans.result import PlanResult

SALAD = ["--dish", "salad", "chopped kohlrabi", "chopped tomato", "liquid olive oil", "granulated salt"]


def plan(*arguments):
    return CliRunner().invoke(app, ["plan", *arguments, "--files", str(demo_folder())])


def result_of(answer):
    assert answer.exit_code == 0, answer.stderr
    return PlanResult.from_json(json.loads(answer.stdout))


@pytest.mark.slow
def test_a_substitute_is_taken_and_its_low_confidence_is_told():
    result = result_of(plan(*SALAD, "--substitute", "kohlrabi = onions", "--json"))
    (chosen,) = [s for s in result.substitutions if s.kind == "object"]
    assert (chosen.required, chosen.equivalent) == ("kohlrabi", "onion")
    assert chosen.confidence < 0.5 < chosen.alternatives[0].confidence


def test_avoided_foods_are_left_out_one_by_one_and_said():
    answer = plan(*SALAD, "chopped walnut", "grated cheddar", "--avoid", "nuts", "--avoid", "dairy", "--json")
    assert answer.stderr.splitlines() == [
        "“walnut” is left out: walnut belongs to “nuts”",
        "“cheddar” is left out: cheddar belongs to “dairy product”",
    ]
    wanted = [ingredient.object for ingredient in result_of(answer).recipe.ingredients]
    assert wanted == ["kohlrabi", "tomato", "olive oil", "salt"]


@pytest.mark.slow
def test_explain_shows_the_plan_and_then_why_each_ingredient_is_made_so():
    answer = plan(*SALAD, "--explain", "--quiet")
    assert answer.exit_code == 0
    plain, _, why = answer.stdout.partition("\nWhy each ingredient is made so\n")
    assert plain == plan(*SALAD, "--quiet").stdout
    named = [line.strip() for line in why.splitlines() if line.startswith("  ") and not line.startswith("    ")]
    assert named == ["kohlrabi (chopped)", "tomato (chopped)", "olive oil (liquid)", "salt (granulated)"]
    assert "like carrot" in " ".join(why.split()) or "makes carrot" in " ".join(why.split())


@pytest.mark.slow
def test_a_plan_shows_the_title_that_was_asked_and_the_dish_of_foon_that_it_is_like(tmp_path):
    foods = [{"object": "kohlrabi", "state": "chopped"}, {"object": "tomato", "state": "chopped"}]
    path = tmp_path / "r.json"
    path.write_text(json.dumps({"type": "salad", "title": "Grandmother's bowl", "ingredients": foods}))
    result = result_of(plan(str(path), "--json"))
    assert result.recipe.title == "Grandmother's bowl"
    for options in ([], ["--explain"]):
        shown = plan(str(path), *options).stdout.splitlines()
        assert "dish  Grandmother's bowl (salad)" in shown
        assert any(line.startswith(f"makes {result.goal.label} (") for line in shown)
        assert any(line.startswith(f"like  {result.reference.goal.label} (video ") for line in shown)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--substitute", "kohlrabi"], "“kohlrabi” is no substitute"),
        (["--substitute", "=onion"], "“=onion” is no substitute"),
        (["--substitute", "kohlrabi=tomatto"], "this FOON does not know “tomatto”"),
        (["--substitute", "kohlrabi=onion", "--substitute", "kohlrabi=carrot"], "has two substitutes"),
        (["--explain", "--foon"], "--foon and --explain ask for two forms of one answer"),
        (["--jobs", "0"], "invalid value for '--jobs'"),
        (["--avoid", "vegetable", "--avoid", "oil", "--avoid", "salt"], "nothing is left of the recipe"),
    ],
)
def test_wishes_that_make_no_sense_are_wrong_usage(arguments, message):
    answer = plan(*SALAD, *arguments)
    assert (answer.exit_code, answer.stdout) == (2, "")
    assert message in answer.stderr


def test_two_forms_of_one_answer_are_refused_in_json_where_that_is_one_of_them():
    answer = plan(*SALAD, "--explain", "--json")
    said = "--json and --explain ask for two forms of one answer"
    assert (answer.exit_code, json.loads(answer.stdout)["error"]["message"]) == (2, said)
    assert said in answer.stderr


def test_an_unknown_substitute_is_answered_with_near_words():
    answer = plan(*SALAD, "--substitute", "kohlrabi=tomatto")
    assert "hint: Did you mean tomato" in answer.stderr


@pytest.mark.slow
def test_a_dish_or_a_video_is_followed_as_wished_and_one_that_nobody_made_is_refused():
    assert result_of(plan(*SALAD, "--json")).reference.goal.label != "winter salad"
    for wish in ("winter salad", "winter_salad"):
        result = result_of(plan(*SALAD, "--after", wish, "--json"))
        assert (result.reference.goal.label, result.reference.videos) == ("winter salad", ("winter_salad",))
    refused = plan(*SALAD, "--after", "moon salad")
    assert refused.exit_code == 3
    assert "called “moon salad”" in refused.stderr


def test_the_paper_follows_nothing_that_is_wished():
    refused = plan(*SALAD, "--after", "winter salad", "--method", "paper")
    assert refused.exit_code == 2
    assert "--after" in refused.stderr
