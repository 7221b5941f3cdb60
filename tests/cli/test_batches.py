"""Many recipes: the same lines on one core and on several, in their order, and a run that was stopped goes on."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
from concurrent.futures.process import BrokenProcessPool

import psutil
import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.model.errors import FoonError
from foon_kg.planning.batch import Cook
from foon_kg.planning.processes import _with_reason

pytestmark = pytest.mark.slow

FOON = [sys.executable, "-c", "from foon_kg.cli import main; main()"]
FILES = ["--files", str(demo_folder())]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Recipes of the demo, one without a tree, one that cannot be read, and some that name no state."""
    folder = tmp_path_factory.mktemp("recipes")
    cold = (path for path in demo_recipes() if not path.stem.endswith(("omelette", "soup")))
    recipes = [json.loads(path.read_text(encoding="utf-8")) for path in cold]
    for number in range(14):
        recipe = {**recipes[number % len(recipes)], "id": f"recipe {number}"}
        recipe["ingredients"] = [*recipe["ingredients"], {"object": "salt", "state": ""}]
        (folder / f"{number:02}.json").write_text(json.dumps(recipe), encoding="utf-8")
    (folder / "04.json").write_text("{", encoding="utf-8")
    no_goal = {"id": "crème pie", "type": "pie", "ingredients": [{"object": "apple", "state": "chopped"}]}
    (folder / "07.json").write_text(json.dumps(no_goal), encoding="utf-8")
    return folder


def plan(*arguments):
    return CliRunner().invoke(app, ["plan", *map(str, arguments), *FILES])


@pytest.fixture(scope="module")
def lines(folder):
    """What a run on one core prints."""
    return plan(folder, "--json", "--jobs", 1)


@pytest.mark.parametrize("jobs", [3])
def test_the_lines_do_not_depend_on_how_many_processes_planned_them(folder, lines, jobs):
    answer = plan(folder, "--json", "--jobs", jobs)
    assert answer.stdout_bytes == lines.stdout_bytes
    assert answer.stderr == lines.stderr
    assert answer.exit_code == lines.exit_code == 3


def test_the_lines_are_in_the_order_of_the_recipes_and_failures_are_lines_too(lines):
    values = [json.loads(line) for line in lines.stdout.splitlines()]
    ids = [value["recipe"]["id"] for value in values]
    assert ids == [{4: "04", 7: "crème pie"}.get(number, f"recipe {number}") for number in range(14)]
    assert [number for number, value in enumerate(values) if "error" in value] == [4, 7]


def test_a_file_has_the_lines_that_would_be_printed(folder, lines, tmp_path):
    output = tmp_path / "plans.jsonl"
    answer = plan(folder, "--output", output)
    assert (answer.stdout, answer.exit_code) == ("", 3)
    assert output.read_bytes() == lines.stdout_bytes


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGINT])
def test_a_run_ended_in_the_middle_leaves_no_process_and_goes_on_to_the_same_file(folder, lines, tmp_path, end):
    output = tmp_path / "plans.jsonl"
    command = [*FOON, "plan", str(folder), "--output", str(output), "--jobs", "2", *FILES]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        notes = (line for line in process.stderr if "names no state" in line)
        for _ in range(4):
            next(notes)  # said just before a line is written
        workers = psutil.Process(process.pid).children(recursive=True)
        process.send_signal(end)
        process.stderr.read()
    _, alive = psutil.wait_procs(workers, timeout=60)
    assert alive == []
    written = output.read_bytes()
    assert written.count(b"\n") >= 3
    assert lines.stdout_bytes.startswith(written)
    assert plan(folder, "--output", output).exit_code == 3
    assert output.read_bytes() == lines.stdout_bytes


@pytest.mark.parametrize("tail", [1, 2, 400])
def test_an_incomplete_last_line_is_cut_and_done_again(folder, lines, tmp_path, tail):
    output = tmp_path / "plans.jsonl"
    output.write_bytes(lines.stdout_bytes[:-tail])
    answer = plan(folder, "--output", output)
    assert f"{output} has 13 of 14 answers already" in answer.stderr
    assert output.read_bytes() == lines.stdout_bytes
    assert answer.exit_code == 3


def test_a_finished_file_stays_as_it_is_and_keeps_its_exit_code(folder, lines, tmp_path):
    output = tmp_path / "plans.jsonl"
    output.write_bytes(lines.stdout_bytes)
    answer = plan(folder, "--output", output)
    assert (answer.exit_code, answer.stdout) == (3, "")
    assert answer.stderr == f"{output} has 14 of 14 answers already\n"
    assert output.read_bytes() == lines.stdout_bytes


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"notes to keep\n", ":1: this line is no JSON"),
        (b"[1]\n", ":1: this line is no answer to a recipe"),
        (b'{"recipe": {"id": "another"}}\nhal', ":1: this line answers another question"),
        (b'{"recipe": {"id": "a"}, "error": {"code": "usage"}}\n', ":1: this line answers another question"),
        (b'{"recipe": null, "error": {"code": "usage"}}\n', ":1: this line is no answer to a recipe"),
        (b'{"recipe": {"id": "a"}, "units": null}\n', ":1: this line is no answer to a recipe"),
        (b'{"recipe": {"id": "a"}, "units": [{}]}\n', ":1: this line is no answer to a recipe"),
    ],
)
def test_a_file_of_something_else_is_refused_and_left_alone(folder, tmp_path, content, message):
    output = tmp_path / "plans.jsonl"
    output.write_bytes(content)
    answer = plan(folder, "--output", output)
    assert answer.exit_code == 2
    assert f"{output}{message}" in answer.stderr
    assert output.read_bytes() == content


def test_a_file_that_other_recipes_were_planned_into_is_refused(folder, lines, tmp_path):
    output = tmp_path / "plans.jsonl"
    output.write_bytes(lines.stdout_bytes)
    answer = plan(folder, "--avoid", "salt", "--output", output)
    assert answer.exit_code == 2
    assert f"{output}:1: this line answers another question" in answer.stderr
    assert output.read_bytes() == lines.stdout_bytes


@pytest.mark.parametrize("options", [["--foon"], ["--explain"]])
def test_a_file_is_for_json_alone(folder, tmp_path, options):
    answer = plan(folder / "00.json", "--output", tmp_path / "plans.jsonl", *options)
    assert answer.exit_code == 2
    assert "two forms of one answer" in answer.stderr
    assert not (tmp_path / "plans.jsonl").exists()


def test_a_folder_is_no_output_file(folder, tmp_path):
    answer = plan(folder / "00.json", "--output", tmp_path)
    assert answer.exit_code == 2
    assert str(tmp_path) in answer.stderr


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_substitute_that_the_foon_does_not_know_ends_a_batch_whatever_its_processes(folder, jobs):
    answer = plan(folder, "--json", "--substitute", "salt=unicorn", "--jobs", jobs)
    assert answer.exit_code == 2
    assert "this FOON does not know “unicorn”" in answer.stderr
    assert json.loads(answer.stdout)["error"]["code"] == "unknown-substitute"


def test_a_process_that_is_ended_from_outside_is_told_with_what_to_do():
    def broken():
        yield "an answer"
        raise BrokenProcessPool

    found = _with_reason(broken())
    assert next(found) == "an answer"
    with pytest.raises(FoonError, match="ended from outside") as told:
        next(found)
    assert "--jobs 1" in told.value.hint


@pytest.mark.skipif(sys.platform == "win32", reason="a terminal is made with pty, which Windows has not")
def test_progress_is_shown_on_a_terminal_alone(folder, tmp_path):
    terminal, end = os.openpty()
    at_once = "from foon_kg.cli import main, runs; runs.SHOWN_AFTER = 0.0; main()"  # however fast the machine is
    output = ["--output", str(tmp_path / "plans.jsonl")]
    command = [sys.executable, "-c", at_once, "plan", str(folder), *output, "--jobs", "1", *FILES]
    with subprocess.Popen(command, stderr=end, env={**os.environ, "TERM": "xterm"}) as process:
        os.close(end)
        shown = bytearray()
        while part := _read(terminal):
            shown += part
    os.close(terminal)
    assert process.returncode == 3
    assert b"14 of 14" in shown


def test_no_progress_goes_into_a_pipe(lines):
    assert "/14" not in lines.stderr


def _read(terminal):
    try:
        return os.read(terminal, 65536)
    except OSError:  # Linux says so when nobody has the other end any more
        return b""


def test_a_file_that_was_planned_of_another_foon_is_refused_by_name(folder, lines, tmp_path):
    output, videos = tmp_path / "plans.jsonl", tmp_path / "videos"
    output.write_bytes(lines.stdout_bytes)
    shutil.copytree(demo_folder(), videos)
    last = [line for line in map(json.loads, lines.stdout.splitlines()) if "units" in line][-1]
    for name in last["reference"]["videos"]:
        (videos / f"{name}.txt").unlink()
    answer = CliRunner().invoke(app, list(map(str, ["plan", folder, "--output", output, "--files", videos])))
    assert answer.exit_code == 2
    told = f"has another tree of {last['recipe']['id']} than this FOON, kitchen and wishes give"
    assert told in " ".join(answer.stderr.split())
    assert "hint: Name another file, or take this one away to begin anew." in answer.stderr
    assert output.read_bytes() == lines.stdout_bytes


@pytest.mark.parametrize("ending", ["", ".gz"])
def test_of_recipes_that_were_mended_only_these_are_planned(folder, tmp_path, ending, monkeypatch):
    mended, output = tmp_path / "recipes", tmp_path / f"plans.jsonl{ending}"
    shutil.copytree(folder, mended)
    (mended / "00.json").rename(mended / "99.json")  # what is mended stands first, too
    (mended / "04.json").rename(mended / "00.json")
    assert plan(mended, "--output", output).exit_code == 3
    (mended / "00.json").write_text(json.dumps({"type": "salad", "ingredients": ["chopped onion", "olive oil"]}))
    planned = []
    monkeypatch.setattr(Cook, "answer", _noting(planned, Cook.answer))
    answer = plan(mended, "--output", output, "--jobs", 1)
    assert "1 recipes could not be read before, and are planned now" in " ".join(answer.stderr.split())
    assert sorted(path.stem for path in planned) == ["00", "99"]  # and one once more, to see whether it is this FOON's
    fresh = tmp_path / f"fresh.jsonl{ending}"
    plan(mended, "--output", fresh, "--jobs", 1)
    assert output.read_bytes() == fresh.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["recipes", output.name, fresh.name])


def _noting(planned, answer):
    def noted(cook, question, **options):
        planned.append(question.path)
        return answer(cook, question, **options)

    return noted
