"""How processes begin: as copies of one that is ready, unless what is ready may be wrong for them."""

from __future__ import annotations

from functools import cache
from multiprocessing import get_all_start_methods

import pytest

from foon_kg.model import copies

pytestmark = pytest.mark.skipif("forkserver" not in get_all_start_methods(), reason="this system makes no copies")


@pytest.fixture(autouse=True)
def _no_process_yet(monkeypatch):
    monkeypatch.setattr(copies, "_first_own_tables", cache(copies._own_tables))


def test_a_process_begins_as_a_copy_of_one_that_is_ready():
    assert copies.copies("foon_kg.web.warm").get_start_method() == "forkserver"
    assert copies.copies("foon_kg.web.warm").get_start_method() == "forkserver"


def test_a_process_begins_by_itself_where_other_tables_were_named_since(monkeypatch):
    copies.copies("foon_kg.web.warm")
    monkeypatch.setenv("FOON_KG_FOODS", "foods of mine.toml")
    assert copies.copies("foon_kg.web.warm").get_start_method() == "spawn"
    monkeypatch.delenv("FOON_KG_FOODS")
    assert copies.copies("foon_kg.web.warm").get_start_method() == "forkserver"
