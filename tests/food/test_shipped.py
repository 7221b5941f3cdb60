"""A table is parsed once: what is kept of it is the table, and nothing else ever is."""

from __future__ import annotations

import tomllib
from importlib.resources import files

import pytest

from foon_kg.food import shipped
from foon_kg.food.shipped import shipped as document

NAMES = (
    "cold",
    "components",
    "dishes",
    "drinks",
    "eggs",
    "foods",
    "grains",
    "handheld",
    "kinds",
    "listed",
    "lists",
    "methods",
    "morsels",
    "motions",
    "pies",
    "sauces",
    "savoury",
    "states",
    "techniques",
    "utensils",
    "vegetables",
    "ways",
)


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "tables"


@pytest.mark.parametrize("name", NAMES)
def test_what_is_kept_of_a_table_is_the_table(folder, monkeypatch, name):
    table = tomllib.loads(files("foon_kg.food").joinpath(f"{name}.toml").read_text(encoding="utf-8"))
    assert document(name) == table
    monkeypatch.setattr(shipped, "_parsed", lambda _: pytest.fail("parsed again"))
    kept = document(name)
    assert kept == table
    assert list(kept) == list(table)


def test_a_table_that_was_changed_is_parsed_anew(folder):
    document("lists")
    (file,) = folder.iterdir()
    file.write_text(file.read_text(encoding="utf-8").replace("water", "sand"), encoding="utf-8")
    assert document("lists")["free foods"] == ["water"]


def test_where_nothing_can_be_written_a_table_is_read_all_the_same(folder):
    folder.parent.write_text("a file, and no folder")
    assert document("lists") == document("lists")
