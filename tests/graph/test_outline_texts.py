"""An outline of a frame is kept as one text, which gives back the same."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.integration.joining.outlines import Outline
from foon_kg.model.names import canonical
from foon_kg.store.graph.frame_rows import outline_of, outline_text

names = st.text(min_size=1).map(canonical)
some_names = st.frozensets(names.filter(bool), max_size=4)


@given(st.builds(Outline, names, names, names, some_names, some_names, st.tuples(names, names)))
def test_an_outline_is_the_same_after_its_text(outline):
    assert outline_of(outline_text(outline)) == outline


def test_another_text_is_no_outline():
    with pytest.raises(ValueError, match="unpack"):
        outline_of("salad")
