"""Whoever changes something is held to one gate: before a commit, here, and on a public forge."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
CHECK = MAKEFILE.split("\ncheck: ")[1].split("\n\n")[0].replace("$(BIN)", ".venv/bin")
"""What make check runs."""


def commands(path, key):
    return re.findall(rf"^\s*(?:- )?{key}: (.+)$", (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE)


def test_a_public_forge_runs_what_our_own_gate_runs():
    assert commands(".github/workflows/gate.yml", "run") == [".ci/run", "make docs"]
    gate = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    assert re.findall(r"^(?:exec )?(make \w+)$", gate, re.MULTILINE) == ["make check", "make test"]


@pytest.mark.parametrize("entry", commands(".pre-commit-config.yaml", "entry"))
def test_what_is_looked_at_before_a_commit_is_a_part_of_make_check(entry):
    assert entry in map(str.strip, CHECK.splitlines())
