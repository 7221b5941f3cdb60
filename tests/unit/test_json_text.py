"""Whatever JSON cannot be read is one kind of error, with its place."""

from __future__ import annotations

import json

import pytest

from foon_kg.model.json_text import json_value, json_value_at


@pytest.mark.parametrize("text", ["[" * 100_000, "9" * 5000, "[1,", "", '{"a": ' * 50_000])
def test_what_cannot_be_read_is_one_kind_of_error(text):
    with pytest.raises(json.JSONDecodeError):
        json_value(text)
    with pytest.raises(json.JSONDecodeError) as error:
        json_value_at(f"[] {text}", 3)
    assert error.value.pos >= 3


def test_a_value_is_read_where_it_begins():
    assert json_value(' {"a": [1.5, null]} ') == {"a": [1.5, None]}
    assert json_value_at("[] 12 x", 3) == (12, 5)
