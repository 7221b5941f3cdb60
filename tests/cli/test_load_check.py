"""``foon load videos --check``: what an annotator forgot, by line."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app

HEAD = "start,end,motion,inputs,outputs,dish\n"
LIT = """
0:01,0:02,turn on,stove (off); ,stove (on),
0:02,0:04,pick-and-place,cooking pot (empty); stove (on),cooking pot (empty) on stove; stove (on) under cooking pot,
""".lstrip()
SOUP = """
0:05,0:06,pour,cooking pot (empty) on stove; leek (whole),cooking pot {leek} on stove; leek (whole) in cooking pot,
0:07,0:30,boil,cooking pot {leek} on stove; leek (whole) in cooking pot; stove (on) under cooking pot,"""
SOUP += "cooking pot {leek} on stove; leek (boiled) in cooking pot,soup\n"
UNLIT = SOUP.replace("; stove (on) under cooking pot", "")


@pytest.fixture
def asked(tmp_path):
    """Return what the command says of a table on stderr, and its report."""

    def ask(rows):
        table, report = tmp_path / "leek.csv", tmp_path / "report.jsonl"
        table.write_text(HEAD + rows, encoding="utf-8")
        words = ["load", "videos", str(table), "--check", "--dry-run", "--report", str(report), "--json"]
        answer = CliRunner().invoke(app, words)
        assert answer.exit_code == 0, answer.stderr
        lines = report.read_text(encoding="utf-8").splitlines()
        return answer.stderr, [json.loads(line) for line in lines]

    return ask


def unlit(report):
    return [(one["line"], one["kind"]) for one in report if "while the stove is off" in one["message"]]


def test_nobody_lit_the_stove_and_the_line_of_the_table_is_told(asked):
    told, report = asked(UNLIT.lstrip())
    assert unlit(report) == [(3, "not-played")]
    assert "leek.csv:3: step 2, boil" in told
    assert "a robot cannot carry it out" in told


def test_what_is_annotated_whole_is_not_blamed_for_its_stove(asked):
    _, report = asked(LIT + SOUP.lstrip())
    assert unlit(report) == []
