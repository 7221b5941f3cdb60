"""What is no file, has nothing in it or too much: every command that is given one says so, names it, and ends."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from campaign.reading_commands import AT_A_TERMINAL, GOOD, READS, RECIPE, WRITES
from typer.main import get_command
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder

pytestmark = pytest.mark.slow

GIVEN = READS | WRITES
ENDINGS = sorted({word.removeprefix("@") for words in GIVEN.values() for word in words if word.startswith("@")})
PROGRAM = Path(__file__).with_name("reading_commands.py")
HUGE = 300_000_000_000
A_HANG = 400
"""Seconds: all commands together take some twenty."""


def pipe(path):
    os.mkfifo(path)


def bound_socket(path):
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(str(path))


def huge(path):
    path.touch()
    os.truncate(path, HUGE)


KINDS = {
    "a pipe": pipe,
    "a socket": bound_socket,
    "a device without end": lambda path: path.symlink_to("/dev/zero"),
    "a link to itself": lambda path: path.symlink_to(path),
    "a link to nothing": lambda path: path.symlink_to(path.with_name("nothing")),
    "more than anybody has": huge,
    "no text": lambda path: path.write_bytes(bytes(range(256)) * 40),
    "a folder": lambda path: path.mkdir(),
    "an empty file": lambda path: path.touch(),
}
MAY_BE_RIGHT = {"a folder", "an empty file"}
"""Nothing is in them: some commands take that for an answer."""

IN_A_TEST = "a pipe"
"""On which commands hung; the others are left to make campaign."""

TAKES_NOTHING = {"a pipe", "a socket", "a link to itself"}
"""To these nothing can be written, while nobody listens."""

BEGUN_ANEW = {"a link to nothing", "an empty file"}
"""Files of answers that are as good as none: -o writes them."""


@pytest.fixture
def good(tmp_path):
    """Files beside the special one with which nothing is wrong."""
    folder = tmp_path / "good"
    folder.mkdir()
    plan = CliRunner().invoke(app, ["plan", RECIPE, "--json", "--files", str(demo_folder())])
    (folder / GOOD["PLAN"]).write_text(plan.stdout, encoding="utf-8")
    (folder / GOOD["TEXT"]).write_text("Chop the onion.\nFry it.\n", encoding="utf-8")
    head = "start,end,motion,inputs,outputs,dish,confidence,doubt,said,source"
    (folder / GOOD["DRAFT"]).write_text(
        f"{head}\n0,1,chop,onion (whole);knife,onion (chopped),,0.5,,,\n", encoding="utf-8"
    )
    recipe = {"id": "r1", "title": "Soup", "ingredients": ["onion"], "instructions": ["Chop the onion."]}
    (folder / GOOD["COLLECTION"]).write_text(json.dumps([recipe]), encoding="utf-8")
    table = "start,end,motion,inputs,outputs,dish\n0,1,chop,onion (whole);knife,onion (chopped),salad\n"
    (folder / GOOD["TABLE"]).write_text(table, encoding="utf-8")
    (folder / GOOD["NETWORK"]).write_text(";; onion\n", encoding="utf-8")
    (folder / GOOD["NARRATED"]).write_text(
        "narration_id,participant_id,video_id,narration_timestamp,start_timestamp,stop_timestamp,start_frame,stop_frame,"
        "narration,verb,verb_class,noun,noun_class,all_nouns,all_noun_classes\n"
        "P01_01_0,P01,P01_01,00:00:01.0,00:00:00.1,00:00:03.3,8,202,chop onion,chop,7,onion,16,['onion'],[16]\n"
    )  # fmt: skip
    return tmp_path


@pytest.mark.parametrize(
    "kind", [kind if kind == IN_A_TEST else pytest.param(kind, marks=pytest.mark.campaign) for kind in KINDS]
)
def test_every_command_ends_and_names_the_file(good, kind):
    for ending in ENDINGS:
        KINDS[kind](good / f"special{ending}")
    environment = {**os.environ, "NEO4J_URI": "bolt://127.0.0.1:1", "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(
        [sys.executable, str(PROGRAM), str(good)],
        capture_output=True, text=True, check=False, timeout=A_HANG, env=environment, stdin=subprocess.DEVNULL,
    )  # fmt: skip
    told = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(told) == len(GIVEN), done.stderr[-3000:]
    wrong = [one for one in told if one["failed"] != "None" or not (written if one["writes"] else read)(kind, one)]
    assert not wrong, json.dumps(wrong, indent=1)


def read(kind, one):
    """Say whether a command that reads a special file ended as it should."""
    if one["code"] == 0:
        return kind in MAY_BE_RIGHT or (kind in BEGUN_ANEW and one["what"][1] == "-o")
    return one["path"] in one["output"]


def written(kind, one):
    """Say whether a command that writes to a special file ended as it should."""
    return kind not in TAKES_NOTHING if one["code"] == 0 else one["path"] in one["output"]


def test_a_pipe_that_somebody_reads_is_written_to(good):
    pipe(good / "pipe")
    with subprocess.Popen(["cat", str(good / "pipe")], stdout=subprocess.PIPE, text=True) as reader:
        while True:  # until it has opened the pipe, nobody reads it
            words = ["show", str(good / "good" / GOOD["PLAN"]), "--format", "json", "-o", str(good / "pipe")]
            if CliRunner().invoke(app, words).exit_code == 0:
                break
        assert json.load(reader.stdout)


def commands(command, name=()):
    inner = getattr(command, "commands", {})
    if not inner:
        yield " ".join(name), command.params
    for word, one in inner.items():
        yield from commands(one, (*name, word))


def test_every_option_that_names_a_file_is_in_the_matrix():
    there = {
        (name, one.opts[-1])
        for name, params in commands(get_command(app))
        for one in params
        if "Path" in str(one.type_descriptor)
    }
    assert there == {(name, option) for name, option in GIVEN if ": " not in option} | AT_A_TERMINAL
