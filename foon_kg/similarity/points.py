"""Foods as points of a vector index, so that a database finds the known foods that may stand for a wanted one.

An index knows one measure, the cosine of two points; the confidence weighs many kinds of evidence, and not all of
them are products of what is known of either food. So the points hold what bounds it: the product of a question and the
point of a known food is never less than the log odds that the food stands for the wanted one. Whoever takes the foods
of the greatest product, works out their confidences and finds the last one wanted above :meth:`Question.most` of the
last food taken, has the same answer as by comparing all foods (filter and refine; Faloutsos and others, 1994).

A point depends on the name and the word lists alone, the weights are in the question: they can be fitted anew without
writing the points anew. Points have length 1, so that the cosine ranks as the product does. The thousands of kinds and
the groups share a few places each; as nothing in them is negative, sharing a place only makes the bound wider.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from foon_kg.model.names import canonical
from foon_kg.similarity.confidences import DECIMALS
from foon_kg.similarity.evidence import Names
from foon_kg.similarity.food import FoodSimilarity, confidence_of, food_similarity
from foon_kg.similarity.sparse import Table

VECTOR, KIND, GROUP, SHELF = 35, 64, 64, 24
"""How many places of a point are for the food vector, WordNet's kinds, the groups of uses, and their shelves."""

POINT_LENGTH = VECTOR + KIND + GROUP + SHELF + 3
"""The last three: is it a dish, does WordNet know it, and what makes every point equally long."""

LONGEST = 4.0
"""No food's evidence is longer; what is not used up goes into the last place."""

NOWHERE = [*[0.0] * (POINT_LENGTH - 1), 1.0]
"""The point of a name of which nothing is known. It is in no index: where many points are equal, a search among
neighbours loses its way. Its product with any question is 0."""

_SLACK = 1e-3  # log odds; databases reckon with 32 bits
_ROUNDED = 10.0**-DECIMALS


@dataclass(frozen=True, eq=False)
class Question:
    """A wanted food as an index is asked for it: the direction in which the points lie that may stand for it."""

    canonical_name: str
    point: tuple[float, ...]
    length: float
    constant: float

    def most(self, cosine: float) -> float:
        """Return a confidence that no food at ``cosine`` or farther exceeds, one of an equal name apart.

        That goes for names of which nothing is known, too.
        """
        cosine = max(cosine, 0.0)
        odds = np.array([cosine * self.length + self.constant + _SLACK])
        return float(confidence_of(odds)[0]) + _ROUNDED


def indexed_points(names: Sequence[str]) -> list[list[float] | None]:
    """Return the point that an index has for each name; ``None`` for ``NOWHERE``."""
    return [None if point == NOWHERE else point for point in points(names)]


def points(names: Sequence[str]) -> list[list[float]]:
    """Return the point of each name, equal ones for equal names; ``POINT_LENGTH`` numbers, as far from 0 as 1."""
    about = food_similarity().evidence.about([canonical(name) for name in names])
    rows = np.c_[_shared(about), about.dish, about.kinds.filled]
    rest = np.sqrt(LONGEST**2 - (rows * rows).sum(axis=1))
    numbers: list[list[float]] = np.round(np.c_[rows, rest] / LONGEST, DECIMALS).tolist()
    return numbers


def question(name: str) -> Question:
    """Return how an index of :func:`points` is asked for ``name``."""
    return _question(canonical(name), food_similarity())


@lru_cache(maxsize=1_024)
def _question(name: str, similarity: FoodSimilarity) -> Question:
    weights = similarity.weights
    about = similarity.evidence.about([name])
    known_kind = float(about.kinds.filled[0])
    group = max(weights["group"], weights["guessed group"], 0.0)
    steps = (weights["vectors"], max(weights["kind"], 0.0), group, max(weights["shelf"], 0.0))
    weighed = np.repeat(steps, (VECTOR, KIND, GROUP, SHELF)) * _shared(about)[0]
    by_flags = weights["prepared dish"] * (1 - float(about.dish[0])), -weights["kind unknown"] * known_kind
    point = np.array([*weighed, *by_flags, 0.0]) * LONGEST
    length = float(np.linalg.norm(point)) or 1.0
    constant = similarity.bias + weights["kind unknown"] + weights["no food"] * float(about.strange[0])
    constant += weights["unknown word"] * float(about.obscure[0] and not about.strange[0])
    constant += _by_names(weights)
    return Question(name, tuple((point / length).tolist()), length, constant)


def _by_names(weights: dict[str, float]) -> float:
    """Return the most that the last words and the words in common can add."""
    same_head = weights["same head word"] + max(weights["more specific"], weights["more general"], 0.0)
    return abs(weights["head vectors"]) + max(same_head, weights["shared word"], 0.0)


def _shared(about: Names) -> Table:
    """Return one row for each name: vector, kinds, groups and shelves, in few places."""
    parts = (about.kinds.folded(KIND), _folded(about.groups, GROUP), _folded(about.shelves, SHELF))
    return np.concatenate((about.vectors, *parts), axis=1)


def _folded(rows: Table, places: int) -> Table:
    folded = np.zeros((len(rows), places))
    for start in range(0, rows.shape[1], places):
        part = rows[:, start : start + places]
        folded[:, : part.shape[1]] += part
    return folded
