"""What a graph's operators and frames were learnt by is a hash of all code that learning them runs."""

from __future__ import annotations

from pathlib import Path

import grimp

import foon_kg
from foon_kg.store.graph.learnt_by import LEARNT_BY

NOT_LEARNING = {"model", "plans", "similarity", "store", "cypher"}
"""Rooms that learning reads with, and which change nothing of what is learnt: values, vectors, rows of the graph."""


def test_whatever_learning_methods_runs_is_in_the_hash_of_what_they_were_learnt_by() -> None:
    graph = grimp.build_graph("foon_kg")
    package = Path(foon_kg.__file__).parent
    hashed = [package / name for name in LEARNT_BY]
    missed = set()
    for module in {"foon_kg.integration.methods", *graph.find_upstream_modules("foon_kg.integration.methods")}:
        path = package.joinpath(*module.split(".")[1:])
        file = path.with_suffix(".py") if path.with_suffix(".py").is_file() else path / "__init__.py"
        if file.name == "__init__.py" and len(file.read_text(encoding="utf-8").splitlines()) == 1:
            continue
        if module.split(".")[1:2] and module.split(".")[1] in NOT_LEARNING:
            continue
        if not any(file == one or one in file.parents for one in hashed):
            missed.add(module)
    assert not missed
