"""A file of weights is read whole, or refused with what is wrong in it."""

from __future__ import annotations

import json

import pytest

from foon_kg.loaders import read_weights
from foon_kg.model.errors import ReadError


def weights(folder, text):
    path = folder / "weights.json"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_weights(path)


def test_weights_are_read_as_they_are_written(tmp_path):
    costs = weights(tmp_path, '\ufeff{"chop": 0.9, "pick  and place": 0, "pour": 1}')
    assert costs.costs == {"chop": 0.9, "pick and place": 0.0, "pour": 1.0}
    assert [str(costs.success(motion)) for motion in ("chop", "pour", "fly")] == ["1/10", "0", "1/2"]
    assert costs.unknown(["pour", "fly", "fly"]) == ("fly",)


@pytest.mark.parametrize(
    "value", ["-0.1", "1.01", "1e999", "-1e999", "NaN", "Infinity", "true", "null", '"0.5"', "[0.5]", "{}", "9" * 400]
)
def test_what_is_no_number_from_0_to_1_is_refused_by_name(tmp_path, value):
    with pytest.raises(ReadError, match=r"weights\.json: the weight of “chop” is") as caught:
        weights(tmp_path, f'{{"pour": 0.5, "chop": {value}}}')
    assert len(caught.value.message) < 300
    assert caught.value.hint


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"chop": 0.5,\n "pour" 1}', r"weights\.json:2: "),
        ("", r"weights\.json:1: "),
        ('{"chop": ' + "9" * 5000 + "}", r"weights\.json: no such JSON is read"),
        ("[" * 100_000, r"weights\.json: no such JSON is read"),
        ("[]", "there are no weights in it"),
        ("{}", "there are no weights in it"),
        ("0.5", "there are no weights in it"),
        ('{"chop": 0.5, "chop": 0.5}', "“chop” is there twice"),
        ('{"chop": 0.5, " chop ": 0.6}', "“chop” is there twice"),
        ('{" ": 0.5}', "a motion has no name"),
        (b'{"chop\xff": 0.5}', "cannot be read"),
    ],
)
def test_what_is_no_table_of_weights_is_refused_with_its_place(tmp_path, text, message):
    with pytest.raises(ReadError, match=message):
        weights(tmp_path, text)


def test_a_file_that_is_not_there_is_said_to_be(tmp_path):
    for path in (tmp_path, tmp_path / "lost.json"):
        with pytest.raises(ReadError, match="cannot be read"):
            read_weights(path)


@pytest.mark.slow
def test_a_huge_table_is_read(tmp_path):
    table = {f"motion {number}": number / 100_000 for number in range(100_000)}
    assert weights(tmp_path, json.dumps(table)).costs == table
