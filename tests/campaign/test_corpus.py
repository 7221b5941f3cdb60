"""Files that a reader once stumbled over, and new ones made of them: each is read, or said to be wrong in words.

What the fuzzer finds it writes, as small as it gets, into ``corpus/READER/``; commit it with what mends it. As a test
some hundred new files are tried for each reader, always the same; ``make campaign`` tries 5,000 from another seed each
time (``FOON_KG_SEED`` names one).
"""

from __future__ import annotations

import hashlib
import os
import random
from functools import partial
from pathlib import Path

import pytest
from campaign.fuzzed_readers import READERS, fails
from campaign.mutations import mutated, smaller

pytestmark = pytest.mark.slow

CORPUS = Path(__file__).with_name("corpus")
WHOLE_CAMPAIGN = os.environ.get("FOON_KG_CAMPAIGN") == "yes"
SEED = int(os.environ.get("FOON_KG_SEED") or (random.randrange(2**32) if WHOLE_CAMPAIGN else 1))
SLOW = {"plan": 100}
"""Whole commands: so many times fewer of them."""

FOUND = sorted(path for path in CORPUS.rglob("*") if path.is_file())


def kept(name):
    return tuple(path.read_bytes() for path in FOUND if path.parent.name == name)


def test_every_find_is_of_a_reader():
    assert {path.parent.name for path in FOUND} <= set(READERS)


@pytest.mark.parametrize("path", FOUND, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_nobody_stumbles_again(path, tmp_path):
    reader = READERS[path.parent.name]
    file = tmp_path / f"file{reader.ending}"
    file.write_bytes(path.read_bytes())
    assert fails(reader, file) is None


@pytest.mark.parametrize("name", READERS)
def test_a_file_that_was_changed_is_read_or_refused(name, tmp_path):
    reader, chance = READERS[name], random.Random(SEED)
    file = tmp_path / f"file{reader.ending}"

    def stumbles(data):
        file.write_bytes(data)
        return fails(reader, file)

    def stumbles_so(kind, data):
        return type(stumbles(data)) is kind

    seeds = reader.begin_from() + kept(name)
    for seed in seeds:
        assert stumbles(seed) is None
    for number in range((5_000 if WHOLE_CAMPAIGN else 100) // SLOW.get(name, 1)):
        data = mutated(chance, seeds)
        if failed := stumbles(data):
            data = smaller(data, partial(stumbles_so, type(failed)))
            (CORPUS / name).mkdir(parents=True, exist_ok=True)
            find = CORPUS / name / hashlib.sha256(data).hexdigest()[:12]
            find.write_bytes(data)
            pytest.fail(f"seed {SEED}, number {number}: {failed!r}, now in {find}: {data[:300]!r}")
