"""How well the foods of one FOON stand for those of the recipes that are planned from it."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from foon_kg.errors import UsageError
from foon_kg.knowledge import Vocabulary
from foon_kg.names import canonical
from foon_kg.recent import Recent
from foon_kg.similarity import Similarity
from foon_kg.substitution import FAIR

LEAST_KEPT = 256
MOST_KEPT = 4_000_000
"""Of so many foods at least it is kept how like they are to all known ones; of more up to so many confidences in all:
8,000 foods where 500 are known."""

_BESIDE_A_CHOICE = 1e-3
"""How much of its lead over ``FAIR`` an equivalent keeps where a person chose another one."""


@dataclass(frozen=True)
class Substitute:
    """A person's choice: ``food``, wherever a recipe asks for it, is handled like the known food ``like``."""

    food: str
    like: str


class Likeness:
    """How likely a cook is to accept one food for another, worked out in one product a food and kept for a while.

    Raises :class:`~foon_kg.errors.UsageError` for a substitute that the FOON does not know, or two for one food.
    """

    def __init__(self, similarity: Similarity, vocabulary: Vocabulary, substitutes: Sequence[Substitute] = ()) -> None:
        self.similarity = similarity
        self.labels = vocabulary.labels
        self.rows: Recent[str, dict[str, float]] = Recent(max(LEAST_KEPT, MOST_KEPT // max(len(self.labels), 1)))
        self.chosen: dict[str, str] = {}
        for substitute in substitutes:
            self._choose(substitute)

    def __call__(self, required: str, known: str) -> float:
        """Answer :meth:`own`, but 1 for a substitute that a person chose; others are then barely fair at best."""
        sure = self.own(required, known)
        if not self.chosen:
            return sure
        like = self.chosen.get(canonical(required))
        if like is None:
            return sure
        if canonical(known) == like:
            return 1.0
        return min(sure, FAIR + (sure - FAIR) * _BESIDE_A_CHOICE)

    def own(self, required: str, known: str) -> float:
        """Answer how likely a cook is to accept ``known`` for ``required`` (0..1), whatever was chosen."""
        row = self.rows.find(required)
        if row is None:
            self.learn([required])
            row = self.rows[required]
        sure = row.get(known)
        if sure is None:
            sure = row[known] = float(self.similarity.matrix([required], [known])[0, 0])
        return sure

    def learn(self, foods: Iterable[str], known: Collection[str] = ()) -> None:
        """Work out at once what every food of the FOON is worth in the place of each of ``foods``.

        ``known`` are further names: of a large FOON the vocabulary may be only a part.
        """
        rows = {food: self.rows.get(food) for food in foods}
        self._work_out({food: {food: 1.0} for food, row in rows.items() if row is None}, self.labels)
        rows = {food: self.rows.get(food) for food in rows}
        names = [name for name in known if any(row is not None and name not in row for row in rows.values())]
        if names:
            self._work_out({food: row for food, row in rows.items() if row is not None}, names)

    def _work_out(self, rows: Mapping[str, dict[str, float]], names: Sequence[str]) -> None:
        if not rows:
            return
        foods = [*rows]
        for food, values in zip(foods, self.similarity.matrix(foods, names).tolist(), strict=True):
            self.rows[food] = {**dict(zip(names, values, strict=True)), **rows[food]}

    def _choose(self, substitute: Substitute) -> None:
        food, like = canonical(substitute.food), canonical(substitute.like)
        if self.chosen.setdefault(food, like) != like:
            raise UsageError(f"“{substitute.food}” has two substitutes", hint="Choose one of them.")
        if like not in map(canonical, self.labels):
            near = difflib.get_close_matches(substitute.like, self.labels, n=3)
            near = near or [found.name for found in self.similarity.nearest(substitute.like, self.labels, limit=3)]
            hint = f"Did you mean {' or '.join(near)}?" if near else "It knows no food at all."
            raise UsageError(f"this FOON does not know “{substitute.like}”", hint=hint, code="unknown-substitute")
