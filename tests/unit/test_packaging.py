"""What is installed is what the project says it needs: the lock, the packages, the command of the tests."""

from __future__ import annotations

import os
import re
import tomllib
from pathlib import Path

from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
LOCK = (ROOT / "requirements.txt").read_text(encoding="utf-8")
PINNED = {name.lower(): version for name, version in re.findall(r"^([\w.-]+)==([^\s;\\]+)", LOCK, flags=re.MULTILINE)}


def test_the_lock_satisfies_everything_that_the_project_asks_for():
    extras = PROJECT["project"]["optional-dependencies"]
    asked = map(Requirement, [*PROJECT["project"]["dependencies"], *extras["server"], *extras["dev"]])
    unmet = [str(r) for r in asked if not r.specifier.contains(PINNED.get(r.name.lower(), "0"), prereleases=True)]
    assert unmet == [], "run: make lock"


def test_every_pin_has_its_hashes_and_no_host_is_named():
    entries = re.findall(r"^[\w.-]+==[^\n]*(?:\\\n +--hash=sha256:[0-9a-f]{64} ?)+$", LOCK, flags=re.MULTILINE)
    assert len(entries) == len(re.findall(r"^[\w.-]+==", LOCK, flags=re.MULTILINE)) > 20
    assert "://" not in LOCK


def test_every_folder_with_code_is_a_package_of_the_distribution():
    folders = {path.parent.relative_to(ROOT) for path in (ROOT / "foon_kg").rglob("__init__.py")}
    packages = {".".join(folder.parts) for folder in folders} | {"foon_kg.cypher", "foon_kg.loaders"}
    assert set(PROJECT["tool"]["setuptools"]["packages"]) == packages


def test_continuous_integration_runs_the_command_that_readme_gives_for_the_tests():
    script = ROOT / ".ci" / "run"
    assert os.access(script, os.X_OK)
    assert script.read_text(encoding="utf-8").splitlines()[-1] == "exec make test"
    assert "make test" in (ROOT / "README.md").read_text(encoding="utf-8")
