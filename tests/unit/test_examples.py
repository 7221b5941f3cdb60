"""Every example in a docstring runs, and prints what stands below it; those of the front door are in test_foon."""

from __future__ import annotations

import doctest
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
AT_THE_DOOR = (
    "foon_kg.foon", "foon_kg.foon.answering", "foon_kg.foon.changing", "foon_kg.foon.collected",
    "foon_kg.foon.drafting", "foon_kg.foon.evaluating", "foon_kg.foon.exploring", "foon_kg.foon.opened",
    "foon_kg.foon.plan",
)  # fmt: skip


def modules_with_examples():
    for folder, package in ((ROOT / "foon_kg", "foon_kg"), (ROOT / "loaders", "foon_kg.loaders")):
        for file in sorted(folder.rglob("*.py")):
            if ">>> " in file.read_text(encoding="utf-8"):
                parts = file.relative_to(folder).with_suffix("").parts
                yield ".".join((package, *(part for part in parts if part != "__init__")))


@pytest.mark.parametrize("name", sorted(set(modules_with_examples()) - set(AT_THE_DOOR)))
def test_the_examples_of_a_module_are_true(name):
    done = doctest.testmod(import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert done.attempted > 0
    assert done.failed == 0
