"""A process that has ended is not waited for, though its parent lives on and has not asked after it."""

from __future__ import annotations

import signal
import subprocess
import sys

import psutil
import pytest

from foon_kg.store.server.process import end, end_at_once, has_ended, wait_for_end

PARENT = """
import subprocess, sys
child = subprocess.Popen([sys.executable, "-c", "import sys; sys.stdin.read()"], stdin=subprocess.PIPE)
print(child.pid, flush=True)
sys.stdin.read()
"""


@pytest.fixture
def child():
    """A process of which another one, and not this, is the parent; that one never asks after it."""
    with subprocess.Popen([sys.executable, "-c", PARENT], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as parent:
        yield psutil.Process(int(parent.stdout.readline()))
        parent.stdin.close()


@pytest.mark.parametrize("ending", [end, end_at_once])
def test_who_ends_it_does_not_wait_for_its_parent(child, ending):
    ending(child)
    assert child.status() == psutil.STATUS_ZOMBIE
    assert has_ended(child)


def test_one_that_runs_has_not_ended(child):
    with pytest.raises(psutil.TimeoutExpired):
        wait_for_end(child, 0)
    assert not has_ended(child)
    child.kill()
    wait_for_end(child, 60)


STUBBORN = "import signal, sys; signal.signal(signal.SIGTERM, signal.SIG_IGN); print(flush=True); sys.stdin.read()"


def test_one_that_does_not_stop_is_killed_after_so_many_seconds():
    with psutil.Popen([sys.executable, "-c", STUBBORN], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        process.stdout.readline()
        end(process, 0)
        assert process.wait() == -signal.SIGKILL
