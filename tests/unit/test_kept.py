"""What is kept in the cache: whole, for just what was asked, and never at the cost of an error."""

import pytest

from foon_kg.model import kept


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path))
    return tmp_path


def test_what_is_kept_is_found_again():
    kept.keep("answers", "what", "this")
    assert kept.find("answers", "what") == "this"
    assert kept.find("answers", "what else") is None


@pytest.mark.parametrize(("asked", "body"), [("name \udcff", "this"), ("what", "name \udcff")])
def test_text_that_is_no_unicode_is_not_kept(asked, body):
    kept.keep("answers", asked, body)
    assert kept.find("answers", asked) is None


def test_the_key_of_code_changes_with_its_tables(tmp_path):
    table = tmp_path / "room" / "aliases.txt"
    table.parent.mkdir()
    table.write_text("scallion = green onion")
    before = kept.code_key([table.parent])
    table.write_text("scallion = spring onion")
    assert kept.code_key([table.parent]) != before
