"""``foon draft review`` at a real terminal (a pty): few questions, one key each, quit and resume."""

from __future__ import annotations

import os
import pty
import re
import select
import signal
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.language.reviewing import Review
from foon_kg.loaders.text_reader import read_text

pytestmark = pytest.mark.slow

DRAFT = """start,end,motion,inputs,outputs,dish,confidence,doubt,said,source
0:01,0:04,peel,onion on cutting board; knife,onion (peeled) on cutting board,,0.90,,“peel the onion”,kitchen.mp4
0:05,0:31,chop,onion (peeled) on cutting board; knife,onion (chopped) on cutting board,,0.03,no unit chops onions,“chop it”,kitchen.mp4
0:40,0:44,pick-and-place,onion (chopped) on cutting board; xyzzy (empty),onion (chopped) in xyzzy; xyzzy {onion},,0.80,,“into the xyzzy”,kitchen.mp4
0:45,,,,,,0.00,“wow” is no motion of the FOON: left out,“wow”,kitchen.mp4
"""  # noqa: E501
GIVES_UP = 120.0
"""Seconds after which a test that waits for words has failed."""
ASKS_AGAIN = 2.0
"""Seconds after which a person presses a key once more."""
CSI = re.compile(r"\x1b\[[0-9;?]*[a-zA-Z]")


class Terminal:
    """A program at a terminal of 100 columns, driven as a person would."""

    def __init__(self, *words, cwd):
        self.seen = ""
        self.process, self.screen = pty.fork()
        if self.process == 0:  # the program itself
            os.chdir(cwd)
            signal.signal(signal.SIGINT, signal.SIG_DFL)  # what runs in the background may have been told to ignore it
            os.environ |= {"COLUMNS": "100", "LINES": "40", "TERM": "xterm", "PYTHONSAFEPATH": "1"}
            code = "from foon_kg.cli import main; main()"
            os.execv(sys.executable, [sys.executable, "-c", code, *map(str, words)])

    def until(self, words, again=""):
        """Read until ``words`` are on the screen, and return all that came since the last time.

        ``again`` is pressed anew where nothing comes of it, as a person does.
        """
        while words not in self.plain:
            if again and not self._readable(ASKS_AGAIN):
                self.press(again)
            data = self._read()
            assert data, f"it ended without “{words}”: {self.plain}"
            self.seen += data.decode()
        shown, self.seen = self.plain, ""
        return shown

    def _read(self):
        assert self._readable(GIVES_UP), f"it waits, and shows: {self.plain}"
        try:
            return os.read(self.screen, 65_536)
        except OSError:  # it has ended
            return b""

    def _readable(self, seconds):
        return bool(select.select([self.screen], [], [], seconds)[0])

    @property
    def plain(self):
        return CSI.sub("", self.seen).replace("\r", "")

    def press(self, keys):
        os.write(self.screen, keys.encode())

    def ends(self):
        """Read to the end; return what was shown and the exit code."""
        while data := self._read():
            self.seen += data.decode()
        _, status = os.waitpid(self.process, 0)
        self.process = 0
        return self.plain, os.waitstatus_to_exitcode(status)

    def close(self):
        if self.process:
            os.kill(self.process, signal.SIGKILL)
            os.waitpid(self.process, 0)
        os.close(self.screen)


@pytest.fixture
def draft(tmp_path):
    (tmp_path / "kitchen.csv").write_text(DRAFT)
    return tmp_path / "kitchen.csv"


@pytest.fixture
def sit(draft):
    opened = []

    def begin(*more):
        opened.append(Terminal("draft", "review", draft.name, *more, cwd=draft.parent))
        return opened[-1]

    yield begin
    for terminal in opened:
        terminal.close()


ASKS = "q quit"


def units(path: Path):
    result = read_text(path.read_text(), path.stem)
    assert not result.notices
    return [one.unit for one in result.subgraph.annotations]


def test_only_what_matters_is_asked_and_one_key_accepts_it(sit, draft):
    terminal = sit()
    first = terminal.until(ASKS)
    assert "1 of 3" in first
    assert "“chop it”" in first
    assert "0:05 to 0:31" in first
    assert "Chop the onion on the cutting board with the knife." in first
    assert "doubt: no unit chops onions" in first
    terminal.press("\r")
    second = terminal.until(ASKS)
    assert "1 of 2" in second
    assert "“into the xyzzy”" in second
    assert "“xyzzy” is not in the table of utensils" in second
    terminal.press("a")
    third = terminal.until(ASKS)
    assert "no unit" in third
    assert "“wow”" in third
    terminal.press("\r")
    told, code = terminal.ends()
    assert code == 0
    assert "all is decided. kitchen.txt: 3 units" in told
    assert [unit.motion for unit in units(draft.with_suffix(".txt"))] == ["peel", "chop", "pick-and-place"]
    checked = CliRunner().invoke(app, ["load", "foon", str(draft.with_suffix(".txt")), "--dry-run"])
    assert checked.exit_code == 0, checked.output
    assert "1 subgraphs, 3 units, 0 rejected units" in checked.output


def test_who_quits_goes_on_where_they_were(sit, draft):
    terminal = sit()
    terminal.until(ASKS)
    terminal.press("\r")
    terminal.until(ASKS)
    terminal.press("q")
    told, code = terminal.ends()
    assert code == 0
    assert "2 of its rows are to be decided" in told
    assert not draft.with_suffix(".txt").exists()
    again = sit()
    assert "“into the xyzzy”" in again.until(ASKS)
    again.press("d")
    again.until(ASKS)
    again.press("\x03")
    assert again.ends()[1] == 0
    assert [row["said"] for row in Review.of(draft.read_text(), "kitchen").rows] == [
        "“peel the onion”",
        "“chop it”",
        "“wow”",
    ]


def test_a_row_is_edited_in_place_and_what_is_no_unit_is_asked_again(sit, draft):
    terminal = sit("--output", "mine.txt")
    terminal.until(ASKS)
    terminal.press("e")
    terminal.until("motion: chop")
    terminal.press("\x15dice\r")  # Ctrl-U empties the line
    terminal.until("inputs: onion (peeled) on cutting board; knife")
    terminal.press("\x15((\r")
    terminal.until("outputs: onion (chopped) on cutting board")
    terminal.press("\r")
    terminal.until("dish: ")
    terminal.press("\r")
    assert "Ctrl-C leaves it as it was" in terminal.until("motion: dice")
    terminal.press("\r")
    terminal.until("inputs: ((")
    terminal.press("\x15onion (peeled) on cutting board; cleaver\r")
    terminal.until("outputs: onion (chopped) on cutting board")
    terminal.press("\r")
    terminal.until("dish: ")
    terminal.press("\r")
    terminal.until(ASKS)
    terminal.press("\r")
    terminal.until(ASKS)
    terminal.press("\r")
    assert "mine.txt" in terminal.ends()[0]
    diced = units(draft.with_name("mine.txt"))[1]
    assert diced.motion == "dice"
    assert [node.label for node in diced.input_nodes] == ["onion", "cleaver"]


def test_what_was_decided_can_be_undone_and_put_off(sit, draft):
    before = Review.of(DRAFT, "kitchen").text()
    terminal = sit()
    terminal.until(ASKS)
    terminal.press("d")
    terminal.until(ASKS)
    assert draft.read_text() != before
    terminal.press("u")
    assert "“chop it”" in terminal.until(ASKS)
    assert draft.read_text() == before
    terminal.press("s")
    assert "2 of 3" in terminal.until(ASKS)
    terminal.press("b")
    assert "1 of 3" in terminal.until(ASKS)
    terminal.press("s")
    terminal.until(ASKS)
    terminal.press("s")
    terminal.until(ASKS)
    terminal.press("s")
    assert "3 of its rows are to be decided" in terminal.ends()[0]


def test_arrows_are_no_answer_and_keys_pressed_early_are_none_lost(sit, draft):
    terminal = sit()
    terminal.press("\x1b[A")  # an arrow ends in A
    terminal.until(ASKS)
    terminal.press("\x1b[A")
    terminal.press("sq")
    assert "3 of its rows are to be decided" in terminal.ends()[0]
    assert draft.read_text() == DRAFT


def test_an_edit_is_left_with_ctrl_c(sit, draft):
    terminal = sit()
    terminal.until(ASKS)
    terminal.press("e")
    terminal.until("motion: chop")
    terminal.press("\x03")  # Python's readline loses one that comes between showing the line and waiting for keys
    assert "as it was" in terminal.until(ASKS, again="\x03")
    assert draft.read_text() == DRAFT
    terminal.press("q")
    assert terminal.ends()[1] == 0
