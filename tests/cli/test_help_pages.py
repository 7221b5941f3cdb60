"""Help on a terminal is drawn in groups with colour; anywhere else it is plain, in the same groups."""

from __future__ import annotations

import re

import pytest
from terminals import on_a_terminal
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.commands import HOMES

COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def panels() -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for name, home in HOMES.items():
        found.setdefault(home.panel, []).append(name)
    return found


def test_plain_help_lists_the_commands_of_each_group_below_its_name():
    told = CliRunner().invoke(app, ["--help"]).stdout
    groups = dict(re.findall(r"^(.+):\n((?:  .+\n)+)", told, re.MULTILINE))
    for panel, names in panels().items():
        assert re.findall(r"^  (\S+)", groups[panel], re.MULTILINE) == names
    assert "\x1b" not in told


def test_a_terminal_has_the_same_groups_in_colour():
    code, seen = on_a_terminal(["--help"])
    assert code == 0
    assert COLOUR.search(seen)
    drawn = COLOUR.sub("", seen)
    for panel, names in panels().items():
        below = re.search(rf"╭─ {panel} ─+╮\n(.+?)╰", drawn, re.DOTALL)
        assert below, panel
        assert re.findall(r"^│ (\S+)", below[1], re.MULTILINE) == names


@pytest.mark.slow
def test_without_colours_where_they_are_not_wanted():
    assert "\x1b[3" not in on_a_terminal(["--help"], environment={"NO_COLOR": "1"})[1]


@pytest.mark.slow
@pytest.mark.parametrize("words", [["plan"], ["load", "foon"], ["check"], ["cypher"]], ids=" ".join)
def test_the_help_of_a_command_says_the_same_on_a_terminal(words):
    plain = CliRunner().invoke(app, [*words, "--help"]).stdout
    code, seen = on_a_terminal([*words, "--help"])
    drawn = re.sub(r"[│╭╮╰╯─]", " ", COLOUR.sub("", seen))
    examples = [line.strip() for line in plain.splitlines() if line.strip().startswith("foon ")]
    assert code == 0
    assert all(" ".join(example.split()) in " ".join(drawn.split()) for example in examples)
    sentences = " ".join(plain.split("Options:")[0].split("Arguments:")[0].split("\n\n", 1)[1].split())
    assert sentences in " ".join(drawn.split())
