"""The rows that questions about recipes answer."""

from __future__ import annotations

from foon_kg.store.graph.rows import Row


class RecipeContentRow(Row):
    """A recipe that the graph has, and the hash of its content."""

    id: str
    content: str


class RecipesTurnRow(Row):
    """How many recipes are counted; ``None`` where those that are there never were."""

    recipes: int | None


class RecipeHeldRow(Row):
    """What a recipe counts for: ``[dish type, sure]`` and ``[food, state]``."""

    classes: list[tuple[str, bool]]
    ingredients: list[tuple[str, str]]


class RecipeRow(Row):
    """A recipe; ``classes`` are ``[dish type, sure]``, ``ingredients`` are the values of a ``CalledFor``."""

    title: str
    classes: list[tuple[str, bool]]
    ingredients: list[tuple[str, str, str, str, str]]


class RecipePageRow(Row):
    """A recipe as in a ``RecipeRow``, with its id."""

    id: str
    title: str
    classes: list[tuple[str, bool]]
    ingredients: list[tuple[str, str, str, str, str]]


class RecipesUntilRow(Row):
    """How many recipes there are, and how many of them up to one."""

    recipes: int
    until: int


class RecipeIdRow(Row):
    """The id of one recipe."""

    id: str


class RecipeClassRow(Row):
    """The recipes that surely are a ``dish_type``; ``unseen`` of the ``ingredients`` they call for are in no unit."""

    dish_type: str
    recipes: int
    ingredients: int
    unseen: int


class WantedFoodRow(Row):
    """A food that no unit has, how many recipes call for it, and in which states most often."""

    food: str
    recipes: int
    states: list[str]


class RecipeCountRow(Row):
    """All recipes, those with a sure dish type, and the foods that they name."""

    recipes: int
    sure: int
    foods: int
    are_counted: bool
