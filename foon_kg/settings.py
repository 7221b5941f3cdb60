"""How a person wants recipes to be planned."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.kitchen import Kitchen
from foon_kg.similarity import Similarity, food_similarity


@dataclass(frozen=True)
class PlanSettings:
    """How to plan: what is at hand, how foods are compared, how long a search may take (seconds)."""

    kitchen: Kitchen = field(default_factory=Kitchen.default)
    similarity: Similarity = field(default_factory=food_similarity)
    time_limit: float | None = 20.0
