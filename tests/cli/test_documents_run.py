"""The commands of the documents, ``--help`` too, are typed, page by page, in a folder that has what they speak of.

The tutorial has a test of its own, and so have the questions of explore.md.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from cli.documented import DOCS, FIRST, commands, fill, typed

from foon_kg.store.settings import ConnectionSettings

pytestmark = [pytest.mark.neo4j, pytest.mark.slow]

HELP = DOCS / "reference" / "commands.md"
"""The examples of ``--help``, as they are in the commands themselves (see docs/generate.py)."""

PAGES = [
    DOCS.parent / "README.md",
    HELP,
    *(DOCS / "how-to" / f"{name}.md" for name in ("plan", "look", "robot", "load", "neo4j", "draft", "evaluate")),
]

NOT_HERE = re.compile(r"foon (serve|mcp|server|demo|doctor)\b|--offline|--dask|--vectors")
"""What stays, starts a server or replaces all that it holds, or asks for a cluster and packages that are not here."""

NO_MORE_THAN = 45
"""So many commands of these pages are left out at most: 21 of them are of servers, 10 of agents and the demo."""

EXIT_CODES = {
    "foon plan --recipes all --output plans.jsonl.zst": 3,  # nobody in this FOON makes cookies
    "foon check tree.txt --recipe recipe.json --json": 1,  # units alone do not tell what a leek is taken for
    "foon check plans.jsonl --kitchen kitchen.txt": 1,  # its omelette takes what is not in that kitchen
    "foon retrieve salad --level 3 --kitchen at_home.txt --json": 3,  # at home there is an onion and no salad
    "foon retrieve salad --kitchen at_home.txt --files subgraphs/ --foon": 3,
    "foon evaluate recipes recipes/ --output scored.jsonl --scores sheet.csv": 1,  # nobody has filled the sheet
    "foon draft accept drafts/P01_11.csv": 2,  # the page shows two ways, and the first has loaded this video
}
"""The commands that do not end with 0, as these files are."""

VIDEOS = (
    *("bean_salad", "garden_salad", "greek_salad", "winter_salad", "tomato_soup"),
    *("cheese_omelette", "garden_omelette", "plain_omelette", "spanish_omelette", "banana_smoothie", "lemonade"),
)
"""Two types of dishes with enough videos to leave one out, and what the pages ask for: all cost four times as much."""

WRITES = r"(?: -o| --output| --report| --html| --scores-to| >) ([^-\s]\S*)"
"""What stands before the name of a file that a command writes."""


@pytest.fixture(scope="module", autouse=True)
def one_core():
    """How many processes there are changes no answer, as others test; here each would take a second to start."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("foon_kg.planning.batch.cores", lambda: 1)
        yield


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, emptied_server: ConnectionSettings):
    """A folder with each file that the pages name, and a graph that holds some of the demo and two recipes."""
    there = tmp_path_factory.mktemp("documents")
    fill(there)
    for path in (there / "subgraphs").iterdir():
        if path.stem not in VIDEOS:
            path.unlink()
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(there)
        for name in ("uri", "user", "password", "database"):
            patch.setenv(f"NEO4J_{name.upper()}", getattr(emptied_server, name))
        for line in FIRST:
            answer = typed(line)
            assert answer.exit_code == 0, (line, answer.stderr)
        plan = json.loads(Path("plan.json").read_text(encoding="utf-8"))
        Path("now.json").write_text(json.dumps(plan["kitchen"]), encoding="utf-8")
        yield there


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_command_of_a_page_ends_as_it_should(page, folder, tmp_path, monkeypatch):
    monkeypatch.chdir(shutil.copytree(folder, tmp_path / "here"))
    elsewhere = {line for other in PAGES if page == HELP != other for line in commands(other)}
    lines = [line for line in commands(page) if not NOT_HERE.search(line) and line not in elsewhere]
    assert len(lines) > 2
    answers = {line: typed(line) for line in lines}
    wrong = [
        f"{line}: exit code {answer.exit_code}, {answer.stderr}"
        for line, answer in answers.items()
        if answer.exit_code != EXIT_CODES.get(line, 0)
    ]
    assert not wrong, "\n".join(wrong)
    files = {line: re.findall(WRITES, line) for line in lines}
    assert [line for line, names in files.items() if not all(Path(name).exists() for name in names)] == []
    done = [line for line, answer in answers.items() if answer.exit_code == 0]
    assert [line for line in done if not files[line] and not answers[line].stdout.strip()] == []


def test_few_commands_are_left_out():
    lines = [line for page in PAGES for line in commands(page)]
    assert EXIT_CODES.keys() <= set(lines)
    assert sum(bool(NOT_HERE.search(line)) for line in lines) <= NO_MORE_THAN
