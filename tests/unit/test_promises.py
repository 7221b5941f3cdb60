"""What SECURITY.md promises is shown by tests that are there."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PROMISED = (ROOT / "SECURITY.md").read_text(encoding="utf-8").partition("## What is promised")[2].partition("\n## ")[0]
ROWS = [
    tuple(cell.strip() for cell in line.strip("|").split("|"))
    for line in PROMISED.splitlines()
    if line.startswith("| ") and "shown by" not in line
]
NAMED = re.compile(r"`(tests/[^`]+)`")


def named_in(place):
    """Return the names of the tests in a file, or in the files of a folder."""
    path = ROOT / place
    files = sorted(path.rglob("test_*.py")) if path.is_dir() else [path]
    trees = [ast.walk(ast.parse(file.read_text(encoding="utf-8"))) for file in files]
    functions = (node for tree in trees for node in tree if isinstance(node, ast.FunctionDef))
    return {node.name for node in functions if node.name.startswith("test_")}


def test_there_are_promises():
    assert len(ROWS) >= 15
    assert all(len(row) == 2 for row in ROWS)


@pytest.mark.parametrize(("promise", "shown"), ROWS, ids=[row[0][:60] for row in ROWS])
def test_a_promise_names_tests_that_are_there(promise, shown):
    named = NAMED.findall(shown)
    assert named, f"nothing shows: {promise}"
    for one in named:
        place, _, test = one.partition("::")
        assert (ROOT / place).exists(), f"{place} is not there"
        there = named_in(place)
        assert there
        assert not test or test in there, f"{one} is not there"
