"""One table of exit codes: what it says is what the commands do."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.model import errors

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
TABLE = {int(code): (means, set(re.findall("`([^`]+)`", codes))) for code, means, codes in re.findall(
    r"^\| (\d) \| (.+?) \| (.*?) ?\|$", PAGE, re.MULTILINE
)}  # fmt: skip
DEMO = str(demo_folder())


def every(kind):
    return [kind, *(below for one in kind.__subclasses__() for below in every(one))]


def test_the_table_has_every_exit_code_there_is():
    kinds = [kind for kind in every(errors.FoonError) if kind.__module__.startswith("foon_kg.")]
    assert set(TABLE) == {0} | {kind.exit_code for kind in kinds}


@pytest.mark.parametrize("kind", [k for k in every(errors.FoonError) if k.__module__ == errors.__name__])
def test_each_error_stands_where_it_ends_the_program(kind):
    assert kind.code in TABLE[kind.exit_code][1]
    assert all(kind.code not in codes for code, (_, codes) in TABLE.items() if code != kind.exit_code)


@pytest.mark.parametrize(
    ("code", "words"),
    [
        (0, ["similar", "caper", "--files", DEMO]),
        (1, ["check", "nowhere.json", "--files", DEMO, "--json"]),
        (2, ["plan", "xyzzy", "--dish", "salad", "--files", DEMO, "--json"]),
        (2, ["plan", "--files", DEMO, "--json"]),
        (2, ["plan", "onion", "--nothing-so", "--json"]),
        (2, ["plan", "onion", "--limit", "many", "--json"]),
        (2, ["--json", "plan", "onion"]),
        (2, ["no-command", "--json"]),
        (2, ["show", "--json"]),
        (3, ["plan", "flour", "--dish", "bread", "--files", DEMO, "--json"]),
    ],
    ids=lambda value: " ".join(value[:2]) if isinstance(value, list) else str(value),
)
def test_commands_end_with_what_the_table_says(code, words):
    answer = CliRunner().invoke(app, words)
    assert answer.exit_code == code, answer.stderr
    if code:
        assert json.loads(answer.stdout.splitlines()[-1])["error"]["code"]


def test_a_command_line_that_cannot_be_read_says_where_help_is_in_two_lines():
    answer = CliRunner().invoke(app, ["plan", "onion", "--dsh", "salad"])
    error, hint = answer.stderr.splitlines()
    assert re.fullmatch(r"error: no such option: --dsh \(Possible options: .*--dish.*\)", error)
    assert hint == "hint: foon plan --help says what there is."
    assert answer.stdout == ""


WAITING = """
import os, signal, sys

class WaitsForWhoStopsIt:
    def find_spec(self, name, *_):
        if name == os.environ["WAITS_AT"]:
            print("imports", name, file=sys.stderr, flush=True)
            os.read(int(os.environ["HELD_BY"]), 1)

signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may ignore it
sys.meta_path.insert(0, WaitsForWhoStopsIt())
"""
"""Python runs this before all else, as ``sitecustomize``: an import waits until somebody writes, and nobody does."""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signal")
@pytest.mark.parametrize(
    "module", ["foon_kg.cli", "typer", "foon_kg.cli.similar", "foon_kg.foon", "foon_kg.planning.batch"]
)
def test_who_stops_a_command_while_it_imports_gets_130_and_no_traceback(module, tmp_path):
    (tmp_path / "sitecustomize.py").write_text(WAITING, encoding="utf-8")
    read, write = os.pipe()
    there = os.environ | {"PYTHONPATH": str(tmp_path), "WAITS_AT": module, "HELD_BY": str(read)}
    words = ["plan", "--dish", "salad", "onion"] if "planning" in module else ["similar", "caper"]
    call = [sys.executable, "-m", "foon_kg", *words, "--files", DEMO]
    with subprocess.Popen(call, env=there, pass_fds=[read], stderr=subprocess.PIPE, text=True) as running:
        said = [running.stderr.readline()]
        running.send_signal(signal.SIGINT)
        said += running.stderr.readlines()
    os.close(read)
    os.close(write)
    assert f"imports {module}\n" in said
    assert running.returncode == 128 + signal.SIGINT, said
    assert "Traceback" not in "".join(said)


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signal")
def test_who_stops_a_command_gets_130():
    code = "import os, signal; signal.signal(signal.SIGINT, signal.default_int_handler); "  # a shell may ignore it
    code += "from foon_kg.__main__ import main; import foon_kg.cli.similar as s; "
    code += "s._print_neighbours = lambda *_: os.kill(os.getpid(), signal.SIGINT); main()"
    call = [sys.executable, "-c", code, "similar", "caper", "--files", DEMO]
    ended = subprocess.run(call, capture_output=True, text=True, check=False)
    assert ended.returncode == 128 + signal.SIGINT
    assert "Traceback" not in ended.stderr
    assert "130" in PAGE


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signal")
def test_who_stops_a_command_that_has_ended_sees_no_traceback():
    code = "import atexit, os, signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
    code += "atexit.register(lambda: os.kill(os.getpid(), signal.SIGINT)); "
    code += "from foon_kg.__main__ import main; main()"
    ended = subprocess.run([sys.executable, "-c", code, "--version"], capture_output=True, text=True, check=False)
    assert ended.returncode == -signal.SIGINT  # which shells tell as 130
    assert (ended.stdout.startswith("foon-kg"), ended.stderr) == (True, "")


def test_a_misspelled_food_is_told_with_what_may_be_meant_and_a_known_one_is_not():
    answer = CliRunner().invoke(app, ["similar", "oinon", "caper", "--files", DEMO])
    assert answer.exit_code == 0
    assert answer.stderr.count("no food is called") == 1
    assert "warning: no food is called “oinon”: did you mean “onion”?" in answer.stderr


def test_a_file_that_is_not_there_is_told_without_the_system_s_number():
    answer = CliRunner().invoke(app, ["show", "nowhere.json"])
    assert answer.stderr.splitlines()[0] == "error: nowhere.json: cannot be read: No such file or directory"
