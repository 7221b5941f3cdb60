"""What docs/performance.md tells of modules is what ``make check`` holds the commands to."""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
ROW = re.compile(r"\| `foon ([^`]+)` \| (\d+) \| (\d+) \|")


def limits(monkeypatch):
    spec = importlib.util.spec_from_file_location("imports_of_commands", ROOT / "benchmarks" / "imports.py")
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, spec.name, module)  # its data classes look for it there
    spec.loader.exec_module(module)
    return {command.name: (command.own, command.others) for command in module.COMMANDS}


def test_the_counts_of_modules_in_the_documents_are_those_that_are_held(monkeypatch):
    """A twentieth may lie between them, so that not each new module changes a document."""
    start = (ROOT / "docs" / "performance.md").read_text(encoding="utf-8").partition("\n## Start\n")[2]
    told = {name: (int(own), int(others)) for name, own, others in ROW.findall(start)}
    held = limits(monkeypatch)
    assert told.keys() == held.keys()
    own = {name: (told[name][0], most) for name, (most, _) in held.items()}
    assert {name: pair for name, pair in own.items() if abs(pair[0] - pair[1]) > max(2, pair[1] // 20)} == {}
    assert {name: told[name][1] for name, (_, most) in held.items() if told[name][1] > most} == {}
