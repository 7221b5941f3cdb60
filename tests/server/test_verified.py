"""A file is compared with its hash when it changed, however well it was disguised, and else not read."""

from __future__ import annotations

import hashlib
import os

import pytest

from foon_kg.store.server import verified
from foon_kg.store.server.verified import RECORD, other_than

RIGHT = b"what was pinned"
HASHES = {name: hashlib.sha256(RIGHT).hexdigest() for name in ("a.jar", "b.jar", "c.jar")}


@pytest.fixture
def folder(tmp_path):
    for name in ("a.jar", "b.jar"):
        (tmp_path / name).write_bytes(RIGHT)
    return tmp_path


def test_what_is_right_and_what_is_not_there_is_not_told(folder):
    assert other_than(folder, HASHES) == ()


def test_what_was_compared_is_not_read_again(folder, monkeypatch):
    other_than(folder, HASHES)
    monkeypatch.setattr(verified, "sha256_of", lambda file: pytest.fail(f"{file} was read"))
    assert other_than(folder, HASHES) == ()


def test_a_change_that_keeps_size_and_time_is_told(folder):
    other_than(folder, HASHES)
    times = (folder / "b.jar").stat()
    (folder / "b.jar").write_bytes(RIGHT[::-1])
    os.utime(folder / "b.jar", ns=(times.st_atime_ns, times.st_mtime_ns))
    assert other_than(folder, HASHES) == ("b.jar",)
    assert other_than(folder, HASHES) == ("b.jar",)
    (folder / "b.jar").write_bytes(RIGHT)
    assert other_than(folder, HASHES) == ()


def test_what_was_compared_with_another_hash_is_read_again(folder):
    other_than(folder, HASHES)
    assert other_than(folder, {"a.jar": "0" * 64}) == ("a.jar",)


@pytest.mark.parametrize("record", ["", "[]", "{", '{"a.jar": 1}', '{"a.jar": []}'])
def test_a_record_that_is_none_counts_as_none(folder, record):
    (folder / RECORD).write_text(record)
    (folder / "a.jar").write_bytes(b"another")
    assert other_than(folder, HASHES) == ("a.jar",)
