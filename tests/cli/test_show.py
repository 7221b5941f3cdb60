"""``foon show``: what a plan is, in the terminal, as pictures, as a timetable and as a shopping list."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes


@pytest.fixture(scope="module")
def plans(tmp_path_factory):
    """Two plans of the demo, one a line, and a recipe that has no tree."""
    recipes = [str(p) for p in demo_recipes() if p.stem in {"courgette_salad", "tomato_salad"}]
    path = tmp_path_factory.mktemp("plans") / "plans.jsonl"
    answer = CliRunner().invoke(app, ["plan", *recipes, "--files", str(demo_folder()), "--json", "--quiet"])
    recipe = json.loads(answer.stdout.splitlines()[0])["recipe"]
    failure = {"recipe": recipe, "error": {"code": "no-way", "message": "no way to make it", "hint": "Ask less."}}
    path.write_text(answer.stdout + json.dumps(failure) + "\n", encoding="utf-8")
    return path


def show(*arguments, text=None):
    return CliRunner().invoke(app, ["show", *map(str, arguments)], input=text)


@pytest.mark.slow
def test_without_an_option_the_tree_is_printed(plans):
    answer = show(plans)
    assert answer.exit_code == 0, answer.stderr
    for title in ("dish", "Steps", "Kitchen", "Substitutions", "Progress of each ingredient"):
        assert f"\n{title}" in f"\n{answer.stdout}"
    assert "\x1b[" not in answer.stdout


def test_one_of_many_results_is_chosen_by_its_line_and_standard_input_is_read(plans):
    assert "Sliced tomato salad" in show("-", "--line", 2, text=plans.read_text(encoding="utf-8")).stdout
    answer = show(plans, "--line", 9)
    assert answer.exit_code == 2
    assert "has 3 results, and --line asks for 9" in answer.stderr


def test_a_recipe_without_a_tree_says_why_again(plans):
    answer = show(plans, "--line", 3)
    assert answer.exit_code == 3
    assert "no way to make it" in answer.stderr
    assert "Ask less." in answer.stderr


def test_foon_text_is_shown_as_well():
    answer = show(demo_folder() / "greek_salad.txt")
    assert answer.exit_code == 0, answer.stderr
    assert "greek_salad" in answer.stdout
    assert "Progress of each ingredient" in answer.stdout


def test_an_option_that_would_mean_nothing_is_refused(plans):
    alone = show(plans, "--hands", "2")
    assert (alone.exit_code, "--hands is for --schedule" in alone.stderr) == (2, True)
    text = show(demo_folder() / "greek_salad.txt", "--line", "2")
    assert (text.exit_code, "no file with many results" in text.stderr) == (2, True)


def test_what_is_no_tree_is_refused(tmp_path):
    path = tmp_path / "nothing.txt"
    path.write_text("# only a comment\n", encoding="utf-8")
    assert show(path).exit_code == 1
    assert show(tmp_path / "absent.json").exit_code == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "begins"),
    [
        (["--svg"], b"<svg "),
        (["--svg", "--unfold"], b"<svg "),
        (["--svg", "--progress"], b"<svg "),
        (["--png"], b"\x89PNG"),
        (["--html"], b"<!doctype html>"),
        (["--svg", "--difference", "--files", str(demo_folder())], b"<svg "),
        (["--svg", "--schedule", "--hands", "2", "--files", str(demo_folder())], b"<svg "),
    ],
    ids=lambda value: " ".join(value[:3]) if isinstance(value, list) else "",
)
def test_pictures_are_written_to_a_file_and_twice_the_same(plans, tmp_path, options, begins):
    pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
    files = [tmp_path / "one", tmp_path / "two"]
    for file in files:
        answer = show(plans, *options, "--quiet", "--output", file)
        assert answer.exit_code == 0, answer.stderr
    assert files[0].read_bytes().startswith(begins)
    assert files[0].read_bytes() == files[1].read_bytes()


def test_a_timetable_says_who_does_what_when_and_how_often_that_was_seen(plans):
    answer = show(plans, "--schedule", "--hands", "2", "--files", demo_folder(), "--quiet")
    assert answer.exit_code == 0, answer.stderr
    assert answer.stdout.splitlines()[1].split() == ["hands", "step", "seen"]  # no video of the demo times its steps
    assert "How long it takes is unknown" in answer.stdout
    assert {line.split()[0] for line in answer.stdout.splitlines()[2:] if line[:1].isdigit()} == {"1", "2"}


@pytest.mark.slow
def test_the_difference_to_the_reference_tree_is_told_step_by_step(plans):
    answer = show(plans, "--difference", "--files", demo_folder(), "--quiet")
    assert answer.exit_code == 0, answer.stderr
    reference = json.loads(plans.read_text(encoding="utf-8").splitlines()[0])["reference"]["units"]
    total = dict(part.split(" ", 1)[::-1] for part in answer.stdout.splitlines()[-1].rstrip(".").split(", "))
    assert sum(int(total[change]) for change in ("kept", "changed", "left out")) == reference


def test_foon_text_has_no_reference_to_differ_from():
    answer = show(demo_folder() / "greek_salad.txt", "--difference", "--files", demo_folder())
    assert answer.exit_code == 2
    assert "does not say what its reference was" in answer.stderr


def test_the_difference_needs_the_foon_of_the_plan(plans):
    answer = show(plans, "--difference", "--files", demo_folder() / "hot_cocoa.txt")
    assert answer.exit_code != 0
    assert "hint:" in answer.stderr


def test_a_shopping_list_has_foods_and_no_utensils(plans):
    lines = show(plans, "--shopping").stdout.splitlines()
    assert any("courgette" in line for line in lines)
    assert not any("knife" in line or "bowl" in line for line in lines)


@pytest.mark.parametrize("options", [["--svg", "--png"], ["--schedule", "--shopping"], ["--shopping", "--svg"]])
def test_two_things_at_once_are_refused(plans, options):
    answer = show(plans, *options)
    assert answer.exit_code == 2
    assert "hint:" in answer.stderr
