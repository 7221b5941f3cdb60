from itertools import permutations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from foon_kg.similarity import count_similar, matching
from foon_kg.similarity.lists import heaviest_matching


class Fixed:
    """A similarity with given confidences, whatever the names."""

    def __init__(self, confidences):
        self.confidences = np.array(confidences, dtype=float)

    def matrix(self, wanted, known):
        return self.confidences[: len(wanted), : len(known)]


weights = st.tuples(st.integers(1, 5), st.integers(1, 5)).flatmap(
    lambda size: arrays(np.float64, size, elements=st.sampled_from([0.0, 0.1, 0.25, 0.5, 0.9, 0.95, 1.0]))
)


def best_by_trying_all(matrix):
    if matrix.shape[0] > matrix.shape[1]:
        matrix = matrix.T
    rows, columns = matrix.shape
    return max(
        sum(matrix[row, column] for row, column in enumerate(order)) for order in permutations(range(columns), rows)
    )


def test_algorithm_2_counts_every_pair_above_the_threshold():
    similarity = Fixed([[0.95, 0.91, 0.2], [0.95, 0.90, 1.0]])
    assert count_similar(["a", "b"], ["x", "y", "z"], similarity) == 4
    assert count_similar(["a", "b"], ["x", "y", "z"], similarity, threshold=0.94) == 3
    assert count_similar([], ["x"], Fixed(np.zeros((0, 1)))) == 0


def test_a_matching_counts_each_food_once():
    similarity = Fixed([[0.95, 0.91], [0.95, 0.2]])
    score, pairs = matching(["a", "b"], ["x", "y"], similarity)
    assert [(pair.required, pair.known) for pair in pairs] == [("a", "y"), ("b", "x")]
    assert score == pytest.approx(1.86)


def test_without_a_similarity_the_default_one_answers():
    assert count_similar(["prawn", "egg"], ["shrimp", "eggs"]) == 2
    score, pairs = matching(["prawn", "egg"], ["eggs", "shrimp"])
    assert score == 2
    assert [pair.known for pair in pairs] == ["shrimp", "eggs"]


@given(weights)
def test_the_matching_is_the_heaviest_there_is(matrix):
    pairs = heaviest_matching(matrix)
    assert sum(matrix[row, column] for row, column in pairs) == pytest.approx(best_by_trying_all(matrix))


@given(weights)
def test_no_row_and_no_column_is_matched_twice(matrix):
    pairs = heaviest_matching(matrix)
    assert len(pairs) == min(matrix.shape)
    assert len({row for row, _ in pairs}) == len({column for _, column in pairs}) == len(pairs)
    assert pairs == sorted(pairs)


@given(weights)
def test_each_food_once_never_counts_more_than_algorithm_2_does(matrix):
    required, known = (["a", "b", "c", "d", "e"][:size] for size in matrix.shape)
    pairs = matching(required, known, Fixed(matrix))[1]
    strong = [pair for pair in pairs if pair.confidence > 0.9]
    assert len(strong) <= count_similar(required, known, Fixed(matrix))


def test_empty_lists_match_nothing():
    assert matching([], ["egg"]) == (0, ())
    assert matching(["egg"], []) == (0, ())
