"""How a person wants recipes to be planned."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import Similarity, food_similarity


@dataclass(frozen=True)
class Substitute:
    """A person's choice: ``food``, wherever a recipe asks for it, is handled like the known food ``like``."""

    food: str
    like: str


@dataclass(frozen=True)
class PlanSettings:
    """How to plan: what is at hand, how foods are compared, how long a search for a reference tree may take (seconds).

    A person's own wishes come before what the similarity says: ``substitutes`` are tried first however unlike they
    are, and no tree has a food of ``avoided`` (names of foods or of kinds of food).
    """

    kitchen: Kitchen = field(default_factory=Kitchen.default)
    similarity: Similarity = field(default_factory=food_similarity)
    time_limit: float | None = 20.0
    substitutes: tuple[Substitute, ...] = ()
    avoided: tuple[str, ...] = ()
