"""Where a disk is full a command says so in one line and fails, and what was in its files before is there still."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.loaders import read_paths, write_json

pytestmark = pytest.mark.slow

# without -B they would keep compiled code, too, which without room is torn, and every later test would read it
PROGRAM = [sys.executable, "-B", "-c", "import sys; from foon_kg.cli import main; sys.exit(main())"]
FILES = ["--files", str(demo_folder())]
RECIPES = [str(path) for path in demo_recipes()[:3]]
ROOM = 512
"""Bytes that a file may have here: fewer than any of these commands writes."""

TO_STDOUT = {
    "stats": ["stats", *FILES],
    "plan": ["plan", RECIPES[0], *FILES],
    "plan as JSON": ["plan", RECIPES[0], "--json", *FILES],
    "plan as FOON text": ["plan", RECIPES[0], "--foon", *FILES],
    "export": ["export", "--format", "dot", *FILES],
    "show": ["show", "--units", "PLAN"],
    "a picture": ["show", "--svg", "PLAN"],
    "check": ["check", "PLAN", *FILES],
    "similar": ["similar", "caper", *FILES],
    "help": ["--help"],
    "version": ["--version"],
}
TO_FILES = {
    "an export": ["export", "--format", "dot", *FILES, "--output", "OUT"],
    "an export of a tree": ["export", "TREE", "--format", "json", "--output", "OUT"],
    "a page": ["show", "PLAN", "--html", "--output", "OUT"],
    "an evaluation": ["evaluate", "recipes", *RECIPES, "--jobs", "1", *FILES, "--html", "OUT"],
    "a report of loading": ["load", "videos", "TABLE", "--dry-run", "--report", "OUT"],
}

IN_A_TEST = {"plan", "plan as JSON", "help", "an export", "a page", "an evaluation"}
"""One of each way to write; each command is a process of its own, and ``make campaign`` asks all of them."""


def some(commands):
    return [
        pytest.param(words, id=name, marks=[] if name in IN_A_TEST else pytest.mark.campaign)
        for name, words in commands.items()
    ]


@pytest.fixture
def tree(tmp_path):
    path = tmp_path / "tree.json"
    (one, *_) = [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None]
    path.write_text(write_json(one), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    path = tmp_path_factory.mktemp("plan") / "plan.json"
    path.write_text(CliRunner().invoke(app, ["plan", RECIPES[0], "--json", *FILES]).stdout, encoding="utf-8")
    return path


@pytest.fixture
def table(tmp_path):
    """A table of a video with many words that nobody knows: its report is long."""
    path = tmp_path / "video.csv"
    rows = [f"{n},{n + 1},glorp{n},snark{n},snark{n} (glorped)," for n in range(20)]
    path.write_text("\n".join(["start,end,motion,inputs,outputs,dish", *rows]), encoding="utf-8")
    return path


def small_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (ROOM, ROOM))


def ended(words, **options):
    """Return what a command told where it ends."""
    done = subprocess.run(
        [*PROGRAM, *words], stderr=subprocess.PIPE, text=True, check=False, **{"stdout": subprocess.DEVNULL, **options}
    )
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr
    return done


def filled(words, **places):
    return [str(places.get(word, word)) for word in words]


@pytest.mark.parametrize("words", [*some(TO_STDOUT), pytest.param(None, id="unbuffered")])
def test_a_full_standard_output_is_said_in_one_line(words, tree, plan):
    unbuffered = {} if words else {"PYTHONUNBUFFERED": "1"}
    words = words or TO_STDOUT["stats"]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"} | unbuffered
    with Path("/dev/full").open("w") as full:
        done = ended(filled(words, TREE=tree, PLAN=plan), stdout=full, env=environment)
    assert done.returncode == 1
    said = [line for line in done.stderr.splitlines() if line.startswith("error:")]
    assert said == ["error: standard output: no space is left there"]
    assert "hint:" in done.stderr


@pytest.mark.parametrize("words", some(TO_FILES))
def test_a_file_without_room_is_named_and_is_as_it_was(words, tree, plan, table, tmp_path):
    folder = tmp_path / "out"
    folder.mkdir()
    out = folder / "out.dot"
    out.write_text("what was there")
    done = ended(filled(words, TREE=tree, PLAN=plan, TABLE=table, OUT=out), preexec_fn=small_files)
    assert done.returncode == 1, done.stderr
    assert f"error: {out}: no space is left there" in done.stderr.splitlines()
    assert [path.name for path in folder.iterdir()] == [out.name]
    assert out.read_text() == "what was there"


def test_many_recipes_go_on_where_the_room_ended(tmp_path):
    whole, torn = tmp_path / "whole.jsonl", tmp_path / "torn.jsonl"
    assert CliRunner().invoke(app, ["plan", *RECIPES, *FILES, "--output", str(whole)]).exit_code == 0
    lines = whole.read_bytes().splitlines(keepends=True)
    room = len(lines[0]) + len(lines[1]) // 2

    def some_room():
        resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

    done = ended(["plan", *RECIPES, *FILES, "--output", str(torn)], preexec_fn=some_room)
    assert done.returncode == 1
    assert f"error: {torn}: no space is left there" in done.stderr.splitlines()
    assert torn.read_bytes().startswith(lines[0])
    assert ended(["plan", *RECIPES, *FILES, "--output", str(torn)]).returncode == 0
    assert torn.read_bytes() == whole.read_bytes()


def test_a_folder_of_drafts_without_room_is_said(tmp_path):
    told = tmp_path / "soup.txt"
    told.write_text("Chop the onion. Fry the onion in the pan. Add water and boil. " * 10)
    words = ["draft", "text", str(told), *FILES, "--output", str(tmp_path / "drafts")]
    done = ended(words, preexec_fn=small_files)
    assert done.returncode == 1, done.stderr
    assert f"error: {tmp_path / 'drafts' / 'soup.csv'}: no space is left there" in done.stderr.splitlines()


def test_answers_are_written_to_files_only(tmp_path):
    pipe = tmp_path / "pipe.jsonl"
    os.mkfifo(pipe)
    for special in (pipe, "/dev/full", tmp_path):
        answer = CliRunner().invoke(app, ["plan", RECIPES[0], *FILES, "--output", str(special)])
        assert answer.exit_code == 2
        assert str(special) in answer.output


def test_what_is_written_keeps_its_place_and_its_mode(tree, tmp_path):
    """A link stays a link, and who might read the file before may read it now."""
    out, link = tmp_path / "out.json", tmp_path / "link.json"
    out.write_text("before")
    out.chmod(0o640)
    link.symlink_to(out)
    assert CliRunner().invoke(app, ["export", str(tree), "--output", str(link)]).exit_code == 0
    assert link.is_symlink()
    assert out.stat().st_mode & 0o777 == 0o640
    assert json.loads(out.read_text())
