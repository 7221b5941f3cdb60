"""Rows of answers: values by name, as many as there are columns."""

from __future__ import annotations

import pickle
from copy import copy

import pytest

from foon_kg.store.graph.rows import SchemaState, SizeRow, UnitsCountRow


def test_a_row_has_its_values_by_name_and_equals_one_of_the_same():
    row = SizeRow(3, 2, 1, dish_types=["soup"])
    assert (row.units, row.videos, row.foods, row.dish_types) == (3, 2, 1, ["soup"])
    assert row == SizeRow(3, 2, 1, ["soup"])
    assert row != SizeRow(3, 2, 1, [])
    assert UnitsCountRow(3) != SchemaState(3, "")
    assert repr(UnitsCountRow(3)) == "UnitsCountRow(units=3)"


def test_what_has_a_default_may_be_missing():
    assert SchemaState(1, "here").edition is None
    assert SchemaState(1, "here", edition="one").edition == "one"


@pytest.mark.parametrize("values", [(), (1,), (1, 2, 3, [], 5)])
def test_too_few_and_too_many_values_are_refused(values):
    with pytest.raises(TypeError, match="units, videos, foods, dish_types"):
        SizeRow(*values)


def test_values_of_other_names_are_refused_also_where_a_default_leaves_room_for_them():
    with pytest.raises(TypeError, match="has the columns units"):
        UnitsCountRow(units=1, foo=2)
    with pytest.raises(TypeError, match="has the columns version, kitchen"):
        SchemaState(1, "here", foo=2)
    with pytest.raises(TypeError, match="has the columns units"):
        UnitsCountRow(1, units=1)


def test_a_row_stays_as_it_is():
    row = UnitsCountRow(1)
    with pytest.raises(AttributeError, match="units cannot be set"):
        row.units = 5
    with pytest.raises(AttributeError, match="units cannot be deleted"):
        del row.units
    assert row == UnitsCountRow(1)


def test_a_row_travels_to_another_process():
    row = SizeRow(3, 2, 1, ["soup"])
    assert pickle.loads(pickle.dumps(row)) == copy(row) == row
