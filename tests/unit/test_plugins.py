"""Plug-ins of a package that pip installed: a loader, an export, a similarity; what is wrong with broken ones."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.loaders import read_paths
from foon_kg.model import plugins
from foon_kg.model.errors import UsageError

PROJECT = """
[build-system]
requires = ["setuptools"]
build-backend = "setuptools.build_meta"

[project]
name = "foon-shouting"
version = "1.0"

[tool.setuptools]
py-modules = ["foon_shouting"]

[project.entry-points."foon_kg.loaders"]
shout = "foon_shouting:read"
broken = "foon_shouting:fails"
wrong = "foon_shouting:length"

[project.entry-points."foon_kg.exports"]
haiku = "foon_shouting:haiku"
absent = "foon_not_there:write"

[project.entry-points."foon_kg.similarity"]
letters = "foon_shouting:letters"
short = "foon_shouting:length"
ragged = "foon_shouting:ragged"
endless = "foon_shouting:endless"
"""
MODULE = """
from foon_kg.loaders import read_text


def read(text, name, path):
    return read_text(text.partition("HEAR\\n")[2], name, path)


def haiku(tree):
    return f"{tree.title}:\\n{len(tree.units)} steps\\n"


def letters(names):
    return [[name.count(letter) for letter in "abcdefghijklmnopqrstuvwxyz"] for name in names]


def length(*arguments):
    return [1.0]


def ragged(names):
    return [[1.0] * place for place, _ in enumerate(names)]


def endless(names):
    return [[float("inf")] for _ in names]


def fails(*arguments):
    raise RuntimeError("no idea")
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder into which pip installed the package."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("target")
    (source / "pyproject.toml").write_text(PROJECT, encoding="utf-8")
    (source / "foon_shouting.py").write_text(MODULE, encoding="utf-8")
    options = ["--no-index", "--no-deps", "--no-build-isolation", "--quiet", "--target", str(target)]
    subprocess.run([sys.executable, "-m", "pip", "install", *options, str(source)], check=True, capture_output=True)
    return target


@pytest.fixture
def installed(folder, monkeypatch):
    monkeypatch.syspath_prepend(str(folder))
    yield
    sys.modules.pop("foon_shouting", None)


def foon(*words):
    return CliRunner().invoke(app, [str(word) for word in words])


def loud(tmp_path, ending="shout"):
    text = (demo_folder() / "greek_salad.txt").read_text(encoding="utf-8")
    path = tmp_path / f"greek_salad.{ending}"
    path.write_text(f"HEAR\n{text}", encoding="utf-8")
    return path


pytestmark = pytest.mark.slow


@pytest.mark.usefixtures("installed")
def test_a_loader_reads_files_of_its_ending_named_or_in_a_folder(tmp_path):
    path = loud(tmp_path)
    [plain] = read_paths([demo_folder() / "greek_salad.txt"])
    [named] = read_paths([path])
    [found] = read_paths([tmp_path])
    assert named.subgraph == found.subgraph == plain.subgraph
    answer = foon("stats", "--files", tmp_path, "--json")
    assert json.loads(answer.stdout)["videos"] == 1


def test_without_its_package_such_a_file_is_none(tmp_path):
    answer = foon("load", "foon", loud(tmp_path), "--dry-run")
    assert answer.exit_code == 1
    assert "neither *.txt nor *.json" in answer.stderr


@pytest.mark.usefixtures("installed")
@pytest.mark.parametrize(("ending", "why"), [("broken", "no idea"), ("wrong", "gave list")])
def test_a_loader_that_fails_is_named(tmp_path, ending, why):
    answer = foon("load", "foon", loud(tmp_path, ending), "--dry-run")
    assert answer.exit_code == 2
    assert why in answer.stderr
    assert "Traceback" not in answer.output


@pytest.mark.usefixtures("installed")
def test_an_export_is_a_format_like_any_other(tmp_path):
    recipe = next(path for path in demo_recipes() if path.stem == "tomato_salad")
    plan = tmp_path / "plan.json"
    plan.write_text(foon("plan", recipe, "--files", demo_folder(), "--json", "--quiet").stdout, encoding="utf-8")
    steps = len(json.loads(plan.read_text(encoding="utf-8"))["units"])
    assert foon("export", plan, "--format", "haiku").stdout.endswith(f":\n{steps} steps\n")
    assert foon("export", plan, "-o", tmp_path / "plan.haiku").exit_code == 0
    assert (tmp_path / "plan.haiku").read_text(encoding="utf-8").endswith(f"{steps} steps\n")
    unknown = foon("export", plan, "--format", "sonnet")
    assert "haiku" in unknown.stderr
    absent = foon("export", plan, "--format", "absent")
    assert (absent.exit_code, "foon-shouting" in absent.stderr) == (2, True)
    whole = foon("export", "--files", demo_folder(), "--format", "haiku")
    assert "cannot be written as haiku" in whole.stderr


@pytest.mark.usefixtures("installed")
def test_a_similarity_is_asked_by_its_name():
    answer = foon("similar", "noino", "--files", demo_folder(), "--vectors", "letters", "--json", "--limit", 1)
    assert json.loads(answer.stdout)["nearest"] == [{"name": "onion", "confidence": 1.0}]
    short = foon("similar", "caper", "--files", demo_folder(), "--vectors", "short")
    assert "gave vectors of the shape (1,)" in short.stderr


@pytest.mark.usefixtures("installed")
@pytest.mark.parametrize(("name", "why"), [("ragged", "no table of numbers"), ("endless", "infinite numbers")])
def test_a_similarity_that_gives_no_numbers_is_named(name, why):
    answer = foon("similar", "caper", "--files", demo_folder(), "--vectors", name)
    assert answer.exit_code == 2
    assert f"the plug-in “{name}” gave" in answer.stderr
    assert why in answer.stderr


@pytest.mark.usefixtures("installed")
def test_two_packages_with_one_name_are_told_apart(tmp_path, monkeypatch):
    other = tmp_path / "other-1.0.dist-info"
    other.mkdir()
    (other / "METADATA").write_text("Metadata-Version: 2.1\nName: other\nVersion: 1.0\n", encoding="utf-8")
    (other / "entry_points.txt").write_text("[foon_kg.exports]\nhaiku = json:dumps\n", encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    with pytest.raises(UsageError, match="foon-shouting and other both bring “haiku”"):
        plugins.plugin(plugins.EXPORTS, "haiku")
