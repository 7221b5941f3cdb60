"""No text of a FOON becomes a formula of a spreadsheet, and none is lost on the way back."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model.cells import as_cell, from_cell

texts = st.text(st.sampled_from("=+-@\t\r'a1. "), max_size=6) | st.text(max_size=6)


@given(texts)
def test_no_cell_is_a_formula_and_what_was_written_is_read(text):
    cell = as_cell(text)
    assert cell[:1] not in set("=@\t\r")
    assert cell[:1] not in set("+-") or float(cell) is not None
    assert cell == text or from_cell(cell) == text
