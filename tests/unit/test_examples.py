"""Every example in a docstring runs, and prints what stands below it; those of the front door are in test_foon."""

from __future__ import annotations

import doctest
import inspect
from functools import cached_property
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
    for folder, package in (
        (ROOT / "foon_kg", "foon_kg"),
        (ROOT / "loaders", "foon_kg.loaders"),
        (ROOT / "cypher", "foon_kg.cypher"),
    ):
        for file in sorted(folder.rglob("*.py")):
            if ">>> " in file.read_text(encoding="utf-8"):
                parts = file.relative_to(folder).with_suffix("").parts
                yield ".".join((package, *(part for part in parts if part != "__init__")))


def examples_in(module):
    """Yield the examples of a module, those of cached properties too, which doctest passes over."""
    finder = doctest.DocTestFinder()
    yield from finder.find(module)
    for name, owner in inspect.getmembers(module, inspect.isclass):
        kept = [one for one in vars(owner).values() if isinstance(one, cached_property)]
        for one in kept if owner.__module__ == module.__name__ else ():
            yield from finder.find(one.func, f"{name}.{one.attrname}", globs=vars(module).copy())


@pytest.mark.parametrize("name", sorted(set(modules_with_examples()) - set(AT_THE_DOOR)))
def test_the_examples_of_a_module_are_true(name):
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    for one in examples_in(import_module(name)):
        runner.run(one)
    assert runner.tries > 0
    assert runner.failures == 0


def test_the_example_of_a_cached_property_is_run():
    node = import_module("foon_kg.model.nodes")
    assert any(one.name == "ObjectNode.key" and one.examples for one in examples_in(node))
