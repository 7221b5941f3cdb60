"""How well the foods of one FOON stand for those of the recipes that are planned from it."""

from __future__ import annotations

from foon_kg.knowledge import Vocabulary
from foon_kg.similarity import Similarity


class Likeness:
    """How likely a cook is to accept one food for another, worked out in one product a food and kept."""

    def __init__(self, similarity: Similarity, vocabulary: Vocabulary) -> None:
        self.similarity = similarity
        self.labels = sorted({row.label for row in vocabulary.foods})
        self.rows: dict[str, dict[str, float]] = {}

    def __call__(self, required: str, known: str) -> float:
        """Answer how likely a cook is to accept ``known`` for ``required`` (0..1)."""
        if required == known:
            return 1.0
        if required not in self.rows:
            values = self.similarity.matrix([required], self.labels)[0].tolist()
            self.rows[required] = dict(zip(self.labels, values, strict=True))
        row = self.rows[required]
        if known not in row:
            row[known] = float(self.similarity.matrix([required], [known])[0, 0])
        return row[known]
