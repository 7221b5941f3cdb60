"""How a person wants recipes to be planned."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import chain
from typing import Literal

from foon_kg.food import tables
from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.model.nodes import one_spelling
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import Similarity

Method = Literal["frames", "paper"]
"""How trees are made: as foon-kg makes them, or by the paper's four algorithms to the letter, for comparison."""


_BETWEEN = re.compile(r"\s*[,;]\s*|\s+(?:and|or|&)\s+", re.IGNORECASE)


def _each(text: str) -> list[str]:
    """Return the names that ``text`` has: two of "nuts, dairy", one of "half and half"."""
    parts = [part for part in _BETWEEN.split(text) if part.strip()]
    return parts if len(parts) > 1 and not tables().foods.is_listed(text) else [text]


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

    What is avoided may be told in one text ("nuts, dairy and eggs"). Raises
    :class:`~foon_kg.model.errors.UsageError` for a name of it that has no letter, and for a text in place of a list.

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
        given: object = self.avoided
        if isinstance(given, str):  # its letters would be taken for names
            raise UsageError(f"what is avoided is a list, and no “{given}”", hint="A list of names, even of one.")
        object.__setattr__(self, "after", one_spelling(self.after))
        named = tuple(chain.from_iterable(map(_each, self.avoided)))
        object.__setattr__(self, "avoided", named)
        odd = next((name for name in named if not any(letter.isalpha() for letter in canonical(name))), None)
        if odd is not None:
            hint = "Name a food, or a kind of food, in letters."
            raise UsageError(f"“{odd}” is no food that can be avoided", hint=hint)
