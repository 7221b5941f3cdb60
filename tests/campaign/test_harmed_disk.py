"""Every write, fsync and rename of a command fails once, by its number, or is where the process is killed.

Then each of its files is as it was or as it was to be, nothing lies about beside them after a failure, and who asks
again gets all. As a test some operations of an export and of compressed plans are harmed; ``make campaign`` harms every
operation of every command.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from campaign.harmed_disk import KILLED, Harm
from campaign.writing_process import on_a_harmed_disk
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes

pytestmark = pytest.mark.slow

WHOLE_CAMPAIGN = os.environ.get("FOON_KG_CAMPAIGN") == "yes"
IN_A_TEST = 4
PROGRAM = Path(__file__).with_name("writing_process.py")
FILES = ["--files", str(demo_folder())]
RECIPES = [str(path) for path in demo_recipes()[:3]]
OLD = "what was in the file before\n"
COMMANDS = {
    "an export": (["export", "--format", "dot", *FILES, "-o", "@/out"], "out"),
    "a picture": (["show", "@/plan.json", "--svg", "-o", "@/out"], "out"),
    "a page": (["show", "@/plan.json", "--html", "-o", "@/out"], "out"),
    "a report": (["load", "videos", "@/video.csv", "--dry-run", "--report", "@/out"], "out"),
    "scores": (["evaluate", "recipes", *RECIPES, "--jobs", "1", *FILES, "--html", "@/out"], "out"),
}
"""Commands that write a file in one piece, and which; ``@`` is the folder that is harmed."""

TESTED = {"an export", "jsonl.gz", Harm.ENDS}
"""What is harmed as a test."""


def some(cases):
    return [case if case in TESTED else pytest.param(case, marks=pytest.mark.campaign) for case in cases]


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    path = tmp_path_factory.mktemp("plan") / "plan.json"
    path.write_text(CliRunner().invoke(app, ["plan", RECIPES[0], "--json", *FILES]).stdout, encoding="utf-8")
    return path


@pytest.fixture
def folder(tmp_path, plan):
    folder = tmp_path / "harmed"
    folder.mkdir()
    shutil.copy(plan, folder)
    rows = [f"{n},{n + 1},glorp{n},snark{n},snark{n} (glorped)," for n in range(20)]
    (folder / "video.csv").write_text("\n".join(["start,end,motion,inputs,outputs,dish", *rows]), encoding="utf-8")
    return folder


@pytest.fixture
def begin(folder, tmp_path):
    """Run a command in a process of its own with one operation harmed; return what it told, nothing if killed."""

    def command(words, number=0, harm=Harm.FAILS, cache=tmp_path / "cache"):
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([*sys.path, str(PROGRAM.parents[1])]),
                       "FOON_KG_CACHE": str(cache)}  # fmt: skip
        given = [word.replace("@", str(folder)) for word in words]
        done = subprocess.run([sys.executable, str(PROGRAM), str(folder), str(number), harm, *given],
                              env=environment, capture_output=True, text=True, check=False)  # fmt: skip
        if harm is Harm.ENDS and number:
            assert done.returncode == KILLED, done.stderr
            return None
        assert done.returncode == 0, done.stderr
        told = json.loads(done.stdout)
        assert not told["failed"], told
        return told

    return command


@pytest.fixture
def run(begin, folder):
    """Run a command with one operation harmed: here unless it is killed, as a process takes fifty times as long."""

    def command(words, number=0, harm=Harm.FAILS):
        if harm is Harm.ENDS and number:
            return begin(words, number, harm)
        told = on_a_harmed_disk(str(folder), str(number), harm, *(word.replace("@", str(folder)) for word in words))
        assert not told["failed"], told
        return told

    return command


def numbers(total):
    if WHOLE_CAMPAIGN or total <= IN_A_TEST:
        return range(1, total + 1)
    return sorted({1, total, *range(1, total, max(1, total // (IN_A_TEST - 2)))})


@pytest.mark.parametrize("harm", Harm)
@pytest.mark.parametrize("what", some(COMMANDS))
def test_a_file_is_as_it_was_or_as_it_was_to_be(folder, run, what, harm):
    words, name = COMMANDS[what]
    file = folder / name
    file.write_text(OLD)
    beside = {path.name for path in folder.iterdir()}
    whole = run(words)
    assert whole["code"] == 0, whole["output"]
    new = file.read_bytes()
    assert {"write", "fsync"} <= set(whole["done"])
    for number in numbers(len(whole["done"])):
        file.write_text(OLD)
        told = run(words, number, harm)
        place = f"{whole['done'][number - 1]}, number {number}"
        assert file.read_bytes() in (OLD.encode(), new), place
        if told:
            assert told["code"] != 0, place
            assert str(file) in told["output"], place
            assert file.read_bytes() == OLD.encode(), place
            assert {path.name for path in folder.iterdir()} == beside, place
        assert run(words)["code"] == 0
        assert file.read_bytes() == new, place
        for left in {path.name for path in folder.iterdir()} - beside:
            assert told is None, left  # who is killed takes nothing away
            (folder / left).unlink()


@pytest.mark.parametrize("harm", Harm)
@pytest.mark.parametrize("ending", some(["jsonl", "jsonl.gz", "jsonl.zst"]))
def test_plans_go_on_where_writing_failed(folder, run, ending, harm):
    words = ["plan", *RECIPES, *FILES, "--jobs", "1", "-o", f"@/plans.{ending}"]
    file = folder / f"plans.{ending}"
    whole = run(words)
    assert whole["code"] == 0, whole["output"]
    new = file.read_bytes()
    for number in numbers(len(whole["done"])):
        file.unlink()
        told = run(words, number, harm)
        assert told is None or told["code"] != 0
        assert new.startswith(file.read_bytes()), "what is there is the beginning"
        assert run(words)["code"] == 0
        assert file.read_bytes() == new


@pytest.mark.parametrize("harm", some(Harm))
def test_what_is_kept_to_be_quicker_changes_no_answer(folder, begin, harm):
    words = ["plan", RECIPES[0], *FILES, "--json"]
    whole = begin(words, cache=folder)
    assert whole["done"]
    for number in numbers(len(whole["done"])):
        for path in sorted(folder.rglob("*"), reverse=True):
            path.rmdir() if path.is_dir() else path.unlink()
        told = begin(words, number, harm, cache=folder)
        assert told is None or told["output"] == whole["output"]
        assert begin(words, cache=folder)["output"] == whole["output"]
