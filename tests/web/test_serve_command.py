"""``foon serve`` as a process of its own: it says where it is, answers, and ends with all its processes."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import subprocess
import sys

import httpx
import psutil
import pytest
from web.serving import SALAD

from foon_kg.foon.demo import demo_folder

PROGRAM = "import sys; from foon_kg.cli import main; sys.exit(main())"
FORKS = "forkserver" in multiprocessing.get_all_start_methods()


BREAKS = """
import pathlib, sys
from foon_kg.foon import demo

def broken():
    pathlib.Path(__file__).with_name("it broke").touch()
    raise RuntimeError("nothing to warm up with")

if any("forkserver" in word for word in sys.orig_argv):
    demo.demo_folder = broken
"""


@contextlib.contextmanager
def served(**environment):
    """A process that serves the demo with two that plan, and its address; whatever becomes of it, it is ended."""
    arguments = ["serve", "--files", str(demo_folder()), "--port", "0", "--jobs", "2"]
    serving = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, *arguments], stderr=subprocess.PIPE, text=True, env=os.environ | environment
    )
    try:
        yield serving, serving.stderr.readline().strip()
    finally:
        serving.kill()
        serving.wait(60)
        serving.stderr.close()


def planned(address):
    """Return the status of a plan."""
    return httpx.post(f"{address}api/plan", json=SALAD, timeout=120).status_code


@pytest.mark.slow
def test_its_processes_end_when_it_is_killed():
    with served() as (serving, address):
        assert planned(address) == 200
        processes = psutil.Process(serving.pid).children(recursive=True)
        assert any("forkserver" in " ".join(one.cmdline()) for one in processes) == FORKS
        serving.kill()
        gone, alive = psutil.wait_procs(processes, timeout=60)
        assert gone
        assert not alive


@pytest.mark.slow
@pytest.mark.skipif(not FORKS, reason="no process is warmed up here")
def test_a_warm_up_that_breaks_leaves_it_planning(tmp_path):
    (tmp_path / "sitecustomize.py").write_text(BREAKS, encoding="utf-8")
    with served(PYTHONPATH=str(tmp_path)) as (_, address):
        assert planned(address) == 200
    assert (tmp_path / "it broke").exists()


@pytest.mark.slow
def test_it_says_where_it_is_answers_and_ends_with_all_its_processes(tmp_path):
    token_file = tmp_path / "token"
    arguments = ["serve", "--files", str(demo_folder()), "--port", "0", "--jobs", "1", "--token-file", str(token_file)]
    serving = subprocess.Popen([sys.executable, "-c", PROGRAM, *arguments], stderr=subprocess.PIPE, text=True)
    try:
        address, _, token = serving.stderr.readline().strip().partition("#token=")
        assert token == token_file.read_text().strip()
        assert httpx.get(f"{address}api/summary", timeout=60).status_code == 401
        headers = {"authorization": f"Bearer {token}"}
        told = httpx.post(f"{address}api/plan", json=SALAD, headers=headers, timeout=120).json()
        assert told["recipe"]["dish_type"] == "salad"
        processes = psutil.Process(serving.pid).children(recursive=True)
        assert processes
        serving.send_signal(signal.SIGINT)
        serving.wait(60)
        gone, alive = psutil.wait_procs(processes, timeout=60)
        assert gone
        assert not alive
    finally:
        serving.kill()
        serving.stderr.close()


@pytest.mark.slow
@pytest.mark.parametrize("words", [["serve", "--port", "0", "--jobs", "1"], ["mcp"]])
def test_what_runs_for_long_collects_what_requests_leave_behind(words):
    """A command that ends does not: an hour of ``foon serve`` grew by 6 MB a minute so."""
    # who runs the tests in the background has them ignore an interrupt, and so would the command until it serves
    hears = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    program = (
        f"{hears}; import atexit, gc; atexit.register(lambda: print('looks after', gc.get_threshold()[0])); {PROGRAM}"
    )
    arguments = [sys.executable, "-c", program, *words, "--files", str(demo_folder())]
    pipe = subprocess.PIPE
    running = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe, text=True)
    try:
        if words[0] == "serve":
            assert "http" in running.stderr.readline()
            running.send_signal(signal.SIGINT)
        told, _ = running.communicate(timeout=120)
    finally:
        running.kill()
    assert int(told.rpartition("looks after")[2]) <= 10_000


@pytest.mark.slow
def test_a_port_that_is_taken_is_said_in_one_line(tmp_path):
    import socket

    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        arguments = ["serve", "--files", str(demo_folder()), "--port", port]
        answer = subprocess.run(
            [sys.executable, "-c", PROGRAM, *arguments], capture_output=True, text=True, check=False
        )
    assert answer.returncode == 2
    assert f"127.0.0.1:{port} cannot be served" in answer.stderr
    assert "Traceback" not in answer.stderr
