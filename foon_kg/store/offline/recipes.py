"""The part of what is staged for an import that recipes are written to."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from foon_kg.store.graph.recipe_rows import RecipeHeldRow, RecipesTurnRow
from foon_kg.store.offline.database import Database, Rows, cell


class StagedRecipes(Database):
    """What :func:`~foon_kg.store.graph.recipes.write_recipes` asks, done on tables.

    ``recipes`` are how many there are and how many have a sure dish type; ``None`` where none were staged.
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.recipes: tuple[int, int] | None = None

    def recipes_turn(self) -> list[RecipesTurnRow]:
        """Return how many recipes are counted."""
        return [RecipesTurnRow(self.recipes[0] if self.recipes else 0)]

    def recipes_held(self, ids: Sequence[str]) -> list[RecipeHeldRow]:
        """Return nothing.

        Raises ValueError where some of ``ids`` are staged already: a collection has each recipe once.
        """
        if twice := self.ids("Recipe", ids):
            raise ValueError(f"staged already: {', '.join(sorted(twice))}")
        return []

    def load_recipe_words(self, ingredients: Rows, dish_types: Sequence[str]) -> None:
        """Make the ingredients and dish types that recipes name and that are not there yet."""
        foods = ((row["name"], row["canonical"]) for row in ingredients)
        self.database.executemany("INSERT OR IGNORE INTO Ingredient (name, canonical) VALUES (?, ?)", foods)
        self.merged("DishType", dish_types)

    def load_recipes(self, recipes: Rows) -> None:
        """Make recipes with the foods that they call for and their dish types."""
        foods = self.ids("Ingredient", {called["name"] for row in recipes for called in row["ingredients"]})
        dishes = self.ids("DishType", {one["name"] for row in recipes for one in row["classes"]})
        for row in recipes:
            number = self.one("Recipe", {"id": row["id"], **row["properties"]})
            classes = ((number, dishes[one["name"]], cell(one["sure"])) for one in row["classes"])
            self.insert("Recipe_KIND_OF_DishType", classes)
            called = ((number, foods[one["name"]], *one["properties"].values()) for one in row["ingredients"])
            self.insert("Recipe_CALLS_FOR_Ingredient", called)

    def add_recipe_counts(self, *, recipes: int, sure: int, dish_types: Rows, foods: Rows, uses: Rows,
                          states: Rows) -> None:  # fmt: skip
        """Add to the counts of ``recipes``, of which ``sure`` many have a sure dish type.

        ``dish_types``, ``foods``, ``uses`` (of a food in a dish type) and ``states`` are rows with a count each.
        """
        counted = self.recipes or (0, 0)
        self.recipes = (counted[0] + recipes, counted[1] + sure)
        for table, key, rows in (("DishType", "dish_type", dish_types), ("Ingredient", "food", foods)):
            self.database.executemany(
                f"UPDATE {table} SET recipes = coalesce(recipes, 0) + ? WHERE name = ?",
                [(row["count"], row[key]) for row in rows],
            )
        self.count("Ingredient_USED_IN_DishType", uses, "food", "dish_type")
        self.count("Ingredient_ASKED_AS_State", states, "food", "state")
