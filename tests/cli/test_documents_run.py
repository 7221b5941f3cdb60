"""The commands of the documents are typed, page by page, in a folder that has what they speak of.

The tutorial has a test of its own, and so have the questions of explore.md.
"""

from __future__ import annotations

import json
import re
import shlex
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.store.settings import ConnectionSettings

pytestmark = [pytest.mark.neo4j, pytest.mark.slow]

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [
    ROOT / "README.md",
    *(DOCS / "how-to" / f"{name}.md" for name in ("plan", "look", "robot", "load", "neo4j", "evaluate")),
]

NOT_HERE = re.compile(r"foon (serve|mcp|server|demo|doctor)\b|--offline|load muhai|recipes\.csv|--vectors")
"""What stays, starts a server or replaces all that it holds, or asks for files and packages that are not here."""

NO_MORE_THAN = 15
"""So many commands of these pages are left out at most."""

EXIT_CODES = {
    "foon check plans.jsonl --kitchen kitchen.txt": 1,  # its omelette takes what is not in that kitchen
    "foon retrieve salad --level 3 --kitchen at_home.txt --json": 3,  # at home there is an onion and no salad
}
"""The commands that do not end with 0, as these files are."""

WRITES = r"(?: -o| --output| --report| --html| --scores-to| >) ([^-\s]\S*)"
"""What stands before the name of a file that a command writes."""

RECIPES = [
    {
        "id": "000018c8a5",
        "title": "Onion salad",
        "ingredients": [{"text": "1 chopped onion"}, {"text": "2 tablespoons olive oil"}, {"text": "1 diced tomato"}],
        "instructions": [{"text": "Toss the onion and the tomato with the olive oil."}],
        "url": "https://example.org/onion-salad",
        "partition": "train",
    }
]
"""A collection as Recipe1M+ has it."""


def commands(page: Path) -> list[str]:
    """Return the commands of ours that ``page`` has, in their order, without what a shell takes for a comment."""
    blocks = re.findall(r"```sh\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    lines = (line for block in blocks for line in block.replace("\\\n", " ").splitlines())
    return [re.sub(r"\s+# .*", "", line) for line in lines if line.startswith("foon ")]


def typed(line: str) -> Result:
    """Run what a person types; what is behind ``>`` gets what is printed."""
    command, _, target = line.partition(" > ")
    answer = CliRunner().invoke(app, shlex.split(command.replace(r"\$", "$"))[1:])
    if target:
        Path(target).write_text(answer.stdout, encoding="utf-8")
    return answer


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, emptied_server: ConnectionSettings):
    """A folder with each file that the pages name, and a graph that holds the demo and a recipe."""
    there = tmp_path_factory.mktemp("documents")
    shutil.copytree(demo_folder(), there / "subgraphs")
    shutil.copytree(demo_folder().parent, there / "foon_kg" / "foon" / "demo")
    (there / "recipes").mkdir()
    for recipe in (path for path in demo_recipes() if path.stem in {"leek_omelette", "tomato_salad"}):
        shutil.copy(recipe, there / "recipes")
    shutil.copy(there / "recipes" / "leek_omelette.json", there / "recipe.json")
    (there / "recipe1m").mkdir()
    (there / "recipe1m" / "layer1.json").write_text(json.dumps(RECIPES), encoding="utf-8")
    for name in ("kitchen.txt", "at_home.txt"):
        (there / name).write_text("onion\ntomato\negg\n", encoding="utf-8")
    table = re.findall(r"```text\n(start.*?)```", (DOCS / "tutorial.md").read_text(encoding="utf-8"), re.DOTALL)
    (there / "my_salad.csv").write_text(table[0], encoding="utf-8")
    (there / "motion_cost.json").write_text(json.dumps({"chop": 0.4, "pour": 0.1}), encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(there)
        for name in ("uri", "user", "password", "database"):
            patch.setenv(f"NEO4J_{name.upper()}", getattr(emptied_server, name))
        for line in ("foon load foon subgraphs/", "foon load recipes recipe1m/", "foon load weights motion_cost.json"):
            assert typed(line).exit_code == 0
        plan = json.loads(typed("foon plan recipe.json --json").stdout)
        (there / "now.json").write_text(json.dumps(plan["kitchen"]), encoding="utf-8")
        yield there


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_command_of_a_page_ends_as_it_should(page, folder, tmp_path, monkeypatch):
    monkeypatch.chdir(shutil.copytree(folder, tmp_path / "here"))
    lines = [line for line in commands(page) if not NOT_HERE.search(line)]
    assert len(lines) > 2
    answers = {line: typed(line) for line in lines}
    wrong = {
        line: (answer.exit_code, answer.stderr)
        for line, answer in answers.items()
        if answer.exit_code != EXIT_CODES.get(line, 0)
    }
    assert wrong == {}
    files = {
        line: re.findall(r"(?: -o| --output| --report| --html| --scores-to| >) ([^-\s]\S*)", line) for line in lines
    }
    assert [line for line, names in files.items() if not all(Path(name).exists() for name in names)] == []
    assert [line for line, answer in answers.items() if not files[line] and not answer.stdout.strip()] == []


def test_few_commands_are_left_out():
    lines = [line for page in PAGES for line in commands(page)]
    assert EXIT_CODES.keys() <= set(lines)
    assert sum(bool(NOT_HERE.search(line)) for line in lines) <= NO_MORE_THAN
