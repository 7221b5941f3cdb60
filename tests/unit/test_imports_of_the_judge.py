"""The judge, its world and its food knowledge know the model and nothing of planning: no module is forgotten."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "foon_kg"
MAY_IMPORT = {
    "food": {"foon_kg.food", "foon_kg.model"},
    "world": {"foon_kg.food", "foon_kg.model", "foon_kg.world"},
    "validation": {"foon_kg.food", "foon_kg.model", "foon_kg.validation", "foon_kg.world"},
}


def imported(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)


@pytest.mark.parametrize("room", MAY_IMPORT)
def test_a_room_imports_only_what_lies_below_it(room):
    allowed = MAY_IMPORT[room]
    for path in sorted((PACKAGE / room).rglob("*.py")):
        own = {name for name in imported(path) if name.startswith("foon_kg")}
        beyond = {name for name in own if not any(name == one or name.startswith(f"{one}.") for one in allowed)}
        assert not beyond, f"{path.name} imports {sorted(beyond)}"


@pytest.mark.parametrize("room", MAY_IMPORT)
def test_no_import_hides_behind_type_checking(room):
    for path in sorted((PACKAGE / room).rglob("*.py")):
        assert "TYPE_CHECKING" not in path.read_text(encoding="utf-8"), path.name
