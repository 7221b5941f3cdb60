"""Recipes of a collection as plain values: as its files have them, and as they were understood."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from foon_kg.model import content_key
from foon_kg.model.nodes import one_spelling

LONGEST_ID = 200
LONGEST_LINE = 1_000
"""So many characters an id or a line may have, more than anybody writes: Neo4j indexes no name of over 8,000 bytes."""


@dataclass(frozen=True)
class DishClass:
    """A dish class that a recipe's title names (one of ``DISH_TYPES``); at most one of a title is ``sure``."""

    name: str
    sure: bool


@dataclass(frozen=True)
class CollectedLine:
    """One ingredient as a collection has it.

    ``text`` is the line as written. ``detected`` is the food that the collection itself found in it, ``None`` where it
    found none or does not trust it. ``state``, ``quantity`` and ``unit`` are ``""`` where the collection says nothing.
    """

    text: str
    detected: str | None = None
    state: str = ""
    quantity: str = ""
    unit: str = ""

    @property
    def is_readable(self) -> bool:
        """Whether text and food are at most :data:`LONGEST_LINE` characters long.

        >>> CollectedLine("1 cup flour", "flour").is_readable, CollectedLine("a" * (LONGEST_LINE + 1)).is_readable
        (True, False)
        """
        return len(self.text) <= LONGEST_LINE and len(self.detected or "") <= LONGEST_LINE


@dataclass(frozen=True)
class CollectedRecipe:
    """One recipe as a collection has it; ``place`` says where it stands (file and number, from 1).

    ``instructions`` are its steps in words, for drafts: the graph does not keep them.
    """

    id: str
    title: str
    lines: tuple[CollectedLine, ...]
    place: str
    dish_type: str | None = None
    partition: str | None = None
    url: str | None = None
    instructions: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "id", one_spelling(self.id))

    @cached_property
    def content(self) -> str:
        """Return a hash of all that the graph keeps of it: where it is equal, loading it again would change nothing.

        >>> one, other = (CollectedRecipe("r1", title, (), "recipes.json:1") for title in ("Toast", "Fine toast"))
        >>> one.content == other.content
        False
        """
        lines = [(line.text, line.detected, line.state, line.quantity, line.unit) for line in self.lines]
        return content_key(self.id, self.title, lines, self.dish_type, self.partition, self.url)


@dataclass(frozen=True)
class CalledFor:
    """One ingredient of a recipe as understood; ``state`` is ``""`` where the line says nothing of it."""

    object: str
    state: str
    text: str
    quantity: str = ""
    unit: str = ""

    @property
    def amount(self) -> str:
        """How much it asks, as people write it: "1 1/2 cups".

        >>> CalledFor("flour", "", "3/2 cups flour", "3/2", "cups").amount
        '1 1/2 cups'
        """
        low, dash, high = self.quantity.partition("-")
        return " ".join(filter(None, (f"{_mixed(low)}{dash}{_mixed(high)}", self.unit)))


def _mixed(number: str) -> str:
    """Return a number with its whole part before the rest: "1 1/2" for "3/2"."""
    over, slash, under = number.partition("/")
    if not (slash and over.isdecimal() and under.isdecimal() and int(under)):
        return number
    whole, rest = divmod(int(over), int(under))
    return " ".join(filter(None, (str(whole or ""), f"{rest}/{under}" if rest else ""))) or "0"


@dataclass(frozen=True)
class UnderstoodRecipe:
    """A recipe ready for the graph. ``left_over`` are the lines in which no food was found."""

    recipe: CollectedRecipe
    dish_classes: tuple[DishClass, ...]
    ingredients: tuple[CalledFor, ...]
    left_over: tuple[str, ...] = ()
