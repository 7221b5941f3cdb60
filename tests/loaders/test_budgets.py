"""How much memory a file takes that is read: so many bytes for each of its own, whatever is in it.

Times are in ``benchmarks/file_budgets.py``, which makes the files and reads each in a process of its own.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

PROGRAM = Path(__file__).parents[2] / "benchmarks" / "file_budgets.py"
SIZE = 1_000_000
FOR_EACH_BYTE, BESIDE = 64, 8_000_000
STREAMED = 8_000_000
"""Recipes are read one by one: a collection may be as large as it likes."""

FORMS = ("text", "json", "video table", "muhai", "narrations", "recipes in lines", "recipes in a list",
         "recipes in a table", "kitchen", "kitchen as JSON", "weights")  # fmt: skip


IN_A_TEST = {"text", "json", "recipes in lines"}
"""Each file is read by a process of its own; ``make campaign`` reads the others."""


@pytest.mark.parametrize("shape", ["many", "one"])
@pytest.mark.parametrize(
    "form", [form if form in IN_A_TEST else pytest.param(form, marks=pytest.mark.campaign) for form in FORMS]
)
def test_memory_is_bounded_by_the_size_of_the_file(form, shape):
    words = [sys.executable, str(PROGRAM), "--form", form, "--shape", shape, "--bytes", str(SIZE)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
    told = json.loads(done.stdout)
    assert told["bytes"] > SIZE // 2
    assert told["grew"] <= FOR_EACH_BYTE * told["bytes"] + BESIDE
    if shape == "many" and form in {"recipes in lines", "recipes in a list"}:
        assert told["grew"] <= STREAMED
