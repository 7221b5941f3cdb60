"""What is installed is what the project says it needs: the lock, the packages, the command of the tests."""

from __future__ import annotations

import os
import re
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
EXTRAS = PROJECT["project"]["optional-dependencies"]
LOCKS = {"requirements.txt": ("server", "fast"), "requirements-dev.txt": ("dev",)}
"""Which extras each lock holds, beside what every installation needs."""

every_lock = pytest.mark.parametrize("name", LOCKS)


def pins(name):
    """Every pinned version by the name of its package: of some there are several, each for other systems."""
    text = (ROOT / name).read_text(encoding="utf-8")
    found = re.findall(r"^([\w.-]+)==([^\s;\\]+)", text, flags=re.MULTILINE)
    return {package.lower(): {version for other, version in found if other == package} for package, _ in found}


def asked_for(extras):
    """What the project asks for with ``extras``, its own extras among them taken apart."""
    for text in [*PROJECT["project"]["dependencies"], *(text for extra in extras for text in EXTRAS[extra])]:
        requirement = Requirement(text)
        if requirement.name == PROJECT["project"]["name"]:
            yield from asked_for(sorted(requirement.extras))
        else:
            yield requirement


@every_lock
def test_the_lock_satisfies_everything_that_the_project_asks_for(name):
    pinned = pins(name)
    unmet = [
        str(asked)
        for asked in asked_for(LOCKS[name])
        if not any(
            asked.specifier.contains(version, prereleases=True) for version in pinned.get(asked.name.lower(), ())
        )
    ]
    assert unmet == [], "run: make lock"


@every_lock
def test_every_pin_has_its_hashes_and_no_host_is_named(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    entries = re.findall(r"^[\w.-]+==[^\n]*(?:\\\n +--hash=sha256:[0-9a-f]{64} ?)+$", text, flags=re.MULTILINE)
    assert len(entries) == len(re.findall(r"^[\w.-]+==", text, flags=re.MULTILINE)) > 20
    assert "://" not in text


def test_the_tests_use_the_versions_that_the_demo_uses():
    demo, tests = pins("requirements.txt"), pins("requirements-dev.txt")
    assert {name: versions for name, versions in demo.items() if not versions <= tests.get(name, set())} == {}


def test_every_folder_with_code_is_a_package_of_the_distribution():
    folders = {path.parent.relative_to(ROOT) for path in (ROOT / "foon_kg").rglob("__init__.py")}
    packages = {".".join(folder.parts) for folder in folders} | {"foon_kg.cypher", "foon_kg.docs", "foon_kg.loaders"}
    assert set(PROJECT["tool"]["setuptools"]["packages"]) == packages


def test_continuous_integration_runs_the_command_that_readme_gives_for_the_tests():
    script = ROOT / ".ci" / "run"
    assert os.access(script, os.X_OK)
    assert script.read_text(encoding="utf-8").splitlines()[-1] == "exec make test"
    assert "make test" in (ROOT / "README.md").read_text(encoding="utf-8")


def test_every_place_that_contributing_names_is_there():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = re.findall(r"`((?:foon_kg|cypher|loaders|docs|tests)(?:/[\w./]+)?)`", text)
    assert len(named) > 30
    assert [place for place in named if not (ROOT / place).exists() and "NAME" not in place] == []
