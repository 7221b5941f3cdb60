"""The rows that questions about recipes answer."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class RecipeContentRow:
    """A recipe that the graph has, and the hash of its content."""

    id: str
    content: str


@dataclass(frozen=True)
class RecipesTurnRow:
    """How many recipes are counted; ``None`` where those that are there never were."""

    recipes: int | None


@dataclass(frozen=True)
class RecipeHeldRow:
    """What a recipe counts for: ``[dish type, sure]`` and ``[food, state]``."""

    classes: list[tuple[str, bool]]
    ingredients: list[tuple[str, str]]


@dataclass(frozen=True)
class RecipeRow:
    """A recipe; ``classes`` are ``[dish type, sure]``, ``ingredients`` are the values of a ``CalledFor``."""

    title: str
    classes: list[tuple[str, bool]]
    ingredients: list[tuple[str, str, str, str, str]]


@dataclass(frozen=True)
class RecipePageRow:
    """A recipe as in a ``RecipeRow``, with its id."""

    id: str
    title: str
    classes: list[tuple[str, bool]]
    ingredients: list[tuple[str, str, str, str, str]]


@dataclass(frozen=True)
class RecipesUntilRow:
    """How many recipes there are, and how many of them up to one."""

    recipes: int
    until: int


@dataclass(frozen=True)
class RecipeIdRow:
    """The id of one recipe."""

    id: str


@dataclass(frozen=True)
class RecipeClassRow:
    """The recipes that surely are a ``dish_type``; ``unseen`` of the ``ingredients`` they call for are in no unit."""

    dish_type: str
    recipes: int
    ingredients: int
    unseen: int


@dataclass(frozen=True)
class WantedFoodRow:
    """A food that no unit has, how many recipes call for it, and in which states most often."""

    food: str
    recipes: int
    states: list[str]


@dataclass(frozen=True)
class RecipeCountRow:
    """All recipes, those with a sure dish type, and the foods that they name."""

    recipes: int
    sure: int
    foods: int
    are_counted: bool
