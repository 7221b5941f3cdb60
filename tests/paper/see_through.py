"""A similarity of which a test says every figure, and small FOONs to plan from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from kitchen_stories import subgraph

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.confidences import Confidences, Neighbour, best
from foon_kg.store.snapshot import Snapshot


@dataclass(frozen=True)
class Told:
    """A similarity: 1 for the same name, what was told for two others, else 0.1."""

    pairs: dict[frozenset[str], float] = field(default_factory=dict)

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        rows = [[self._of(one, other) for other in known] for one in wanted]
        return np.array(rows, dtype=float).reshape(len(wanted), len(known))

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        return best(known, self.matrix([name], known)[0], limit)

    def why(self, name: str, known: str) -> tuple[str, ...]:
        return ()

    def _of(self, one: str, other: str) -> float:
        return 1.0 if one == other else self.pairs.get(frozenset({one, other}), 0.1)


def told(**pairs: float) -> Told:
    """Return the similarity with, for instance, ``leek_onion=0.95``."""
    return Told({frozenset(names.split("_")): value for names, value in pairs.items()})


def recipe(*foods: str, dish_type: str = "salad") -> Recipe:
    """Return a recipe for ``chopped onion``, ``whole tomato`` …: a state of one word, then the food."""
    wants = (food.partition(" ") for food in foods)
    return Recipe(dish_type, tuple(RequiredIngredient(food, state) for state, _, food in wants))


def foon(*dishes: tuple[str, ...], dish_type: str = "salad") -> Snapshot:
    """Return the FOON of some videos; the last unit of each makes a goal."""
    videos = [subgraph(f"video {number}", dish_type, *lines) for number, lines in enumerate(dishes)]
    return Snapshot.of(videos, Kitchen.default())
