"""Units as the graph answers them, also while somebody removes them."""

from __future__ import annotations

from foon_kg.store.graph.known_units import known_units
from foon_kg.store.graph.rows import KnownUnitsRow


def test_a_unit_that_goes_while_the_graph_answers_is_left_out():
    gone = (None, None, None, [], [], [])
    assert list(known_units(KnownUnitsRow([(None, None, None, None)], [gone], []))) == []
