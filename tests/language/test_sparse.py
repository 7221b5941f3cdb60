"""Sparse rows answer what the whole matrix answers."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.similarity.sparse import SparseRows

WIDTH = 7
ROWS = st.lists(st.dictionaries(st.integers(0, WIDTH - 1), st.floats(-2, 2)), max_size=6)


def whole(rows):
    table = np.zeros((len(rows), WIDTH))
    for number, row in enumerate(rows):
        for place, value in row.items():
            table[number, place] = value
    return table


@given(ROWS, ROWS)
def test_products_with_sparse_rows_are_those_with_the_whole_matrix(rows, others):
    sparse = SparseRows.of(rows, WIDTH)
    np.testing.assert_allclose(sparse.product(whole(others)), whole(others) @ whole(rows).T, atol=1e-12)
    np.testing.assert_array_equal(sparse.dense(), whole(rows))
    assert sparse.filled.tolist() == [bool(row) for row in rows]


@given(ROWS, st.integers(1, WIDTH))
def test_folded_rows_add_up_what_shares_a_column(rows, width):
    folded = np.zeros((len(rows), width))
    for place in range(WIDTH):
        folded[:, place % width] += whole(rows)[:, place]
    np.testing.assert_allclose(SparseRows.of(rows, WIDTH).folded(width), folded, atol=1e-12)
