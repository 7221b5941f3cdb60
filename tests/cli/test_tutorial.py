"""The tutorial, command by command, in the order in which a newcomer types them."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder

pytestmark = [pytest.mark.neo4j, pytest.mark.slow]

PAGE = (Path(__file__).parents[2] / "docs" / "tutorial.md").read_text(encoding="utf-8")
COMMANDS = [
    line for block in re.findall(r"```sh\n(.*?)```", PAGE, re.DOTALL) for line in block.splitlines()
    if line.startswith("foon ")
]  # fmt: skip
TABLE = re.search(r"```text\n(start.*?)```", PAGE, re.DOTALL)[1]

SHOWN = re.findall(r"```sh\n((?:[^`]|`(?!``))*)```\n\n```text\n(?!start)(.*?)```", PAGE, re.DOTALL)
"""Blocks of commands with what the page shows of what the last of each prints."""


def test_the_tutorial_shows_what_its_first_commands_print():
    assert len(SHOWN) >= 4


@pytest.fixture
def here(tmp_path, monkeypatch, empty_graph):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my_salad.csv").write_text(TABLE, encoding="utf-8")
    return tmp_path


def typed(line):
    """Run what a person types; what is behind ``>`` gets what is printed."""
    command, _, target = line.partition(" > ")
    answer = CliRunner().invoke(app, shlex.split(command)[1:])
    if target:
        Path(target.strip()).write_text(answer.stdout, encoding="utf-8")
    return answer


def test_every_command_of_the_tutorial_does_what_it_says(here):
    assert typed(f"foon load foon {demo_folder()}").exit_code == 0
    answers = {line: typed(line) for line in COMMANDS}
    assert len(answers) > 10
    refused = {line: answer.stderr for line, answer in answers.items() if answer.exit_code}
    assert list(refused) == ['foon plan --dish bread "chopped onion" "olive oil"']
    assert "this FOON has no bread" in next(iter(refused.values()))
    assert (
        "like  cucumber salad (video my_salad)"
        in answers['foon plan --dish salad "sliced cucumber" yogurt "chopped dill"'].stdout
    )
    for block, shown in SHOWN:
        last = answers[[line for line in block.splitlines() if line.startswith("foon ")][-1].partition(" #")[0].strip()]
        assert shown in last.stdout or shown in last.stderr
