"""How a person wants recipes to be planned."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import Similarity

Method = Literal["frames", "paper"]
"""How trees are made: as foon-kg makes them, or by the paper's four algorithms to the letter, for comparison."""


@dataclass(frozen=True)
class Substitute:
    """A person's choice: ``food``, wherever a recipe asks for it, is handled like the known food ``like``.

    >>> PlanSettings(substitutes=(Substitute("leek", "onion"),)).substitutes[0].like
    'onion'
    """

    food: str
    like: str


@dataclass(frozen=True)
class PlanSettings:
    """How to plan: what is at hand, how foods are compared, how long a search for a reference tree may take (seconds).

    Without a ``similarity`` it is :func:`~foon_kg.similarity.food_similarity`, which every process makes for itself. A
    person's own wishes come before what it says: ``substitutes`` are tried first however unlike they are, and no tree
    has a food of ``avoided`` (names of foods or of kinds of food). ``after`` names the recorded dish, or the video, to
    make it after. ``explain`` asks for the reasons with every tree. ``with_drafts`` plans with drafts of recipes, too,
    where the FOON has some; whoever opens it minds that. The paper's ``method`` knows nothing of all this.

    Raises :class:`~foon_kg.model.errors.UsageError` for something avoided that has no letter: no food is called so.

    >>> PlanSettings(avoided=("2%",))
    Traceback (most recent call last):
    foon_kg.model.errors.UsageError: “2%” is no food that can be avoided
    """

    kitchen: Kitchen = field(default_factory=Kitchen.default)
    similarity: Similarity | None = None
    time_limit: float | None = 20.0
    substitutes: tuple[Substitute, ...] = ()
    avoided: tuple[str, ...] = ()
    after: str = ""
    explain: bool = False
    method: Method = "frames"
    with_drafts: bool = False

    def __post_init__(self) -> None:
        odd = next((name for name in self.avoided if not any(letter.isalpha() for letter in canonical(name))), None)
        if odd is not None:
            hint = "Name a food, or a kind of food, in letters."
            raise UsageError(f"“{odd}” is no food that can be avoided", hint=hint)
