"""How a person wants recipes to be planned."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from foon_kg.kitchen import Kitchen
from foon_kg.similarity import Similarity, food_similarity
from foon_kg.states import state_similarity


@dataclass(frozen=True)
class Substitute:
    """A person's choice: ``food``, wherever a recipe asks for it, is handled like the known food ``like``."""

    food: str
    like: str


@dataclass(frozen=True)
class Rules:
    """Which rules of choice are at work; each is switched off only to measure what it is worth (``foon evaluate``).

    ``motions``: the motion that makes the wanted state takes the place of the equivalent's. ``joining``: a food joins
    where one like it does; without it, at the last unit that takes any number of foods. ``ties``: goals that are nearly
    alike are told apart by their trees; without it, the first is taken. ``carriers``: each food that joins does so by a
    step of its own, as FOON brings such a food into such a vessel.
    """

    motions: bool = True
    joining: bool = True
    ties: bool = True
    carriers: bool = True


@dataclass(frozen=True)
class PlanSettings:
    """How to plan: what is at hand, how foods and how states are compared, how long a search may take (seconds).

    A person's own wishes come before what the similarity says: ``substitutes`` are tried first however unlike they
    are, and no tree has a food of ``avoided`` (names of foods or of kinds of food).
    """

    kitchen: Kitchen = field(default_factory=Kitchen.default)
    similarity: Similarity = field(default_factory=food_similarity)
    time_limit: float | None = 20.0
    substitutes: tuple[Substitute, ...] = ()
    avoided: tuple[str, ...] = ()
    state_similarity: Callable[[str, str], float] = state_similarity
    rules: Rules = field(default_factory=Rules)
