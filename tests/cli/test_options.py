"""One set of names: the same option is called the same, and takes the same, in every command."""

from __future__ import annotations

import inspect
import json
from functools import cache

import pytest
import typer
from typer.testing import CliRunner

from foon_kg import Foon
from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.store.graph import free_cypher

SHORT = {"--limit": "-n", "--format": "-f", "--output": "-o", "--quiet": "-q", "--jobs": "-j", "--param": "-P"}
SPEAKS_JSON = ("mcp",)
"""Its standard output is a protocol that is JSON already."""


def commands(group, words=()):
    for name, command in sorted(group.commands.items()):
        if hasattr(command, "commands"):
            yield from commands(command, (*words, name))
        else:
            yield (*words, name), command


@cache
def options():
    """Return the options of every command, by the words that call it."""
    return {
        words: [param for param in command.params if param.param_type_name == "option"]
        for words, command in commands(typer.main.get_command(app))
    }


def test_every_command_answers_in_json():
    without = [words for words, told in options().items() if not any("--json" in option.opts for option in told)]
    assert without == [SPEAKS_JSON]


def test_an_option_has_the_same_short_name_everywhere():
    for words, told in options().items():
        found = {name: option.opts for option in told for name in option.opts if name.startswith("--")}
        for name, short in SHORT.items():
            assert name not in found or short in found[name], (words, name)
        taken = {short: name for name, opts in found.items() for short in opts if not short.startswith("--")}
        assert taken.items() <= {short: name for name, short in SHORT.items()}.items(), words


def test_how_many_is_asked_with_one_word():
    named = [(words, name) for words, told in options().items() for option in told for name in option.opts]
    assert [one for one in named if one[1] in {"--most", "--max", "--count", "--top"}] == []


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    recipe = next(path for path in demo_recipes() if path.stem == "tomato_salad")
    path = tmp_path_factory.mktemp("plan") / "plan.json"
    answer = CliRunner().invoke(app, ["plan", str(recipe), "--files", str(demo_folder()), "--json", "--quiet"])
    path.write_text(answer.stdout, encoding="utf-8")
    return path


def shown(*arguments):
    return CliRunner().invoke(app, ["show", *map(str, arguments)])


def test_a_tree_is_shown_as_its_sentences_in_json(plan):
    told = json.loads(shown(plan, "--json").stdout)
    assert told["title"] == "Sliced tomato salad with feta"
    assert all(step[0].isupper() and step.endswith(".") for step in told["steps"])
    assert len(told["steps"]) == len(json.loads(plan.read_text(encoding="utf-8"))["units"])


@pytest.mark.parametrize(
    ("matter", "field"), [("--units", "units"), ("--progress", "progress_lines"), ("--shopping", "shopping")]
)
def test_each_matter_has_its_json(plan, matter, field):
    assert json.loads(shown(plan, matter, "--format", "json").stdout)[field]


@pytest.mark.parametrize(("matter", "field"), [("--schedule", "length"), ("--difference", "steps")])
def test_what_asks_a_foon_has_json_too(plan, matter, field):
    assert json.loads(shown(plan, matter, "--json", "--files", demo_folder()).stdout)[field]


def test_the_ending_of_the_output_says_the_form(plan, tmp_path):
    pytest.importorskip("fast_sugiyama")
    assert shown(plan, "-o", tmp_path / "tree.svg").exit_code == 0
    assert (tmp_path / "tree.svg").read_text(encoding="utf-8").startswith("<svg")
    assert shown(plan, "-o", tmp_path / "tree.json").exit_code == 0
    assert json.loads((tmp_path / "tree.json").read_text(encoding="utf-8"))["steps"]


@pytest.mark.parametrize(
    "words", [["--json", "--svg"], ["--format", "png", "--html"], ["-o", "tree.doc"]], ids=" ".join
)
def test_two_forms_or_none_are_refused(plan, words):
    answer = shown(plan, *words)
    assert answer.exit_code == 2
    assert answer.stderr.startswith("error:")


def test_an_export_is_asked_in_json_with_the_same_word(plan):
    call = ["export", str(plan)]
    as_json, by_format = (CliRunner().invoke(app, [*call, *more]).stdout for more in (["--json"], ["--format", "json"]))
    assert json.loads(as_json) == json.loads(by_format)
    assert CliRunner().invoke(app, [*call, "--json", "--format", "dot"]).exit_code == 2


def test_a_question_in_cypher_has_the_same_limits_at_every_door():
    command = dict(commands(typer.main.get_command(app)))[("cypher",)]
    told = {option.name: option.default for option in command.params if option.name in ("limit", "timeout")}
    assert told == {"limit": free_cypher.ROW_LIMIT, "timeout": free_cypher.TIME_LIMIT}
    for asks in (Foon.cypher, free_cypher.ask_freely):
        parameters = inspect.signature(asks).parameters
        assert {name: parameters[name].default for name in told} == told
