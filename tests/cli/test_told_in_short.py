"""What is odd about files is told in one line where it is much; few broken units in many stop no load."""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app

UNIT = "O1\tonion\t0\nS1\twhole\nM1\tchop\t0:01\t0:02\nO1\tonion\t0\nS2\t{state}\n//\n"
BROKEN = "O1\tonion\t0\nS1\twhole\nO1\tonion\t0\nS2\tchopped\n//\n"


@pytest.fixture(autouse=True)
def alone(tmp_path, monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "bolt://127.0.0.1:1")
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "cache"))


def loaded(folder, units, broken, *words):
    folder.mkdir(exist_ok=True)
    states = ("chopped", "sliced", "diced", "minced", "grated", "peeled", "mashed")
    text = "//\n" + "".join(UNIT.format(state=states[place % 7]) for place in range(units)) + BROKEN * broken
    (folder / "video.txt").write_text(text, encoding="utf-8")
    return CliRunner().invoke(app, ["load", "foon", str(folder), "--dry-run", *map(str, words)])


@pytest.mark.parametrize(
    ("units", "broken", "words", "refused"),
    [
        (98, 1, (), True),
        (99, 1, (), False),
        (198, 2, (), False),
        (198, 3, (), True),
        (99, 1, ("--bad-tolerance", 0), True),
        (9, 1, ("--bad-tolerance", 1), False),
    ],
)
def test_one_broken_unit_in_a_hundred_stops_no_load(tmp_path, units, broken, words, refused):
    answer = loaded(tmp_path / "foon", units, broken, *words)
    assert (answer.exit_code == 1) == refused, answer.stderr
    assert ("nothing was loaded" in answer.stderr) == refused


def test_much_that_is_odd_is_one_line(tmp_path):
    answer = loaded(tmp_path / "foon", 2000, 12)
    assert answer.exit_code == 0
    assert answer.stderr == "12 units skipped: --report FILE lists them\n"
    report = tmp_path / "report.jsonl"
    answer = loaded(tmp_path / "foon", 2000, 12, "--report", report)
    assert answer.stderr == f"12 units skipped: see {report}\n"
    assert len(report.read_text(encoding="utf-8").splitlines()) == 12


def test_of_what_has_to_be_mended_the_first_is_named(tmp_path):
    lines = loaded(tmp_path / "foon", 3, 12).stderr.splitlines()
    assert sum("unit rejected" in line for line in lines) == 10
    assert lines[10] == "12 units skipped: --report FILE lists them"
    assert "12 units are unusable" in lines[11]


def test_little_is_told_one_by_one(tmp_path):
    answer = loaded(tmp_path / "foon", 300, 2)
    assert answer.exit_code == 0
    assert [line.split(":")[0] for line in answer.stderr.splitlines()] == [str(tmp_path / "foon" / "video.txt")] * 2
