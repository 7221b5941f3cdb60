"""What a terminal shows of a run that takes a while, and the line that closes it."""

from __future__ import annotations

import os
import re
import sys
from contextlib import contextmanager

import pytest
from terminals import on_a_terminal

from foon_kg.cli import runs
from foon_kg.cli.console import sayer
from foon_kg.foon.demo import demo_folder
from foon_kg.store.server.home import waiting

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="a terminal is made with pty, which Windows has not")


@pytest.fixture
def terminal(monkeypatch):
    """Return a context in which stderr is a terminal, and a list that has at its end what was seen there."""
    seen: list[str] = []

    @contextmanager
    def opened():
        above, below = os.openpty()
        monkeypatch.setenv("TERM", "xterm")
        with os.fdopen(below, "w") as stream, os.fdopen(above, "rb", buffering=0) as written:
            monkeypatch.setattr(sys, "stderr", stream)
            yield seen
            stream.write("<end>")
            stream.flush()
            text = b""
            while b"<end>" not in text:
                text += written.read(65536)
        seen.append(text.decode())

    return opened


@pytest.mark.parametrize(("after", "shown"), [(0.0, True), (3600.0, False)])
def test_a_bar_with_its_name_is_shown_of_what_takes_long(terminal, monkeypatch, after, shown):
    with terminal() as seen, runs.counting("Planning recipes", 3, after=after) as advance:
        for _ in "abc":
            advance(1)
    assert ("Planning recipes" in seen[0]) == shown
    assert ("3/3" in seen[0]) == shown
    assert bool(re.search(r"Planning recipes: 3 of 3 in [0-9.]+ s", seen[0])) == shown


def test_a_second_is_what_takes_long():
    assert runs.SHOWN_AFTER == 1.0


def test_what_was_stopped_says_how_far_it_came(terminal):
    def stopped():
        with runs.counting("Loading", 9, 2, after=0) as advance:
            advance(1)
            raise KeyboardInterrupt

    with terminal() as seen, pytest.raises(KeyboardInterrupt):
        stopped()
    assert re.search(r"Loading: 3 of 9 in [0-9.]+ s", seen[0])


@pytest.mark.parametrize("items", ["", "a", "abc"])
def test_what_is_waited_for_comes_as_it_is(terminal, items):
    with terminal() as seen:
        assert list(runs.waited(iter(items), "Planning")) == list(items)
        assert list(runs.progress_bar(iter(items), "Planning", len(items))) == list(items)
    assert "Planning" not in seen[0]


def test_the_server_is_waited_for_in_seconds_on_a_terminal(terminal):
    with terminal() as seen, waiting(sayer(quiet=False), "starting Neo4j 1.2"):
        pass
    assert re.search(r"starting Neo4j 1\.2 .*0:00:0\d", seen[0])
    assert re.search(r"starting Neo4j 1\.2 in [0-9.]+ s", seen[0])


def test_who_wants_no_word_gets_none(terminal):
    with terminal() as seen, waiting(sayer(quiet=True), "starting"), runs.counting("x", 1, quiet=True, after=0):
        pass
    assert seen == ["<end>"]


def test_elsewhere_it_is_one_line(capsys):
    with waiting(sayer(quiet=False), "starting Neo4j 1.2"), runs.counting("Loading", 3, after=0) as advance:
        advance(3)
    assert capsys.readouterr().err == "starting Neo4j 1.2\n"


def test_who_only_takes_lines_is_told_once():
    lines: list[str] = []
    with waiting(lines.append, "starting"):
        assert lines == ["starting"]
    assert lines == ["starting"]


def test_nothing_moves_where_a_terminal_gets_an_answer_at_once():
    code, seen = on_a_terminal(["similar", "caper", "--files", str(demo_folder())])
    assert code == 0
    assert "in 0" not in seen
    assert "Reading" not in seen
