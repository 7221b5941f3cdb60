"""Counts of recipes, kept by the transactions that store them: a million recipes are counted without being read.

``Foon.recipes`` and ``sure_recipes``, ``DishType.recipes`` (sure ones), ``Ingredient.recipes``, and how many lines call
for a food: ``(:Ingredient)-[:USED_IN {count}]->(:DishType)`` in recipes of a sure dish type, ``(:Ingredient)-[:ASKED_AS
{count}]->(:State)`` in a state. What is unseen is asked when it is told: a FOON that is loaded later changes no count.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

import neo4j

from foon_kg.model.errors import GraphError, SchemaError
from foon_kg.store.graph import statements as cypher
from foon_kg.store.graph.recipe_rows import RecipeCountRow
from foon_kg.store.graph.statements import Ask, ask

Key = TypeVar("Key", str, tuple[str, str])

RECIPES_COUNTED_AT_ONCE = 1_000


@dataclass
class RecipeCounts:
    """What recipes add to the counts."""

    recipes: int = 0
    sure: int = 0
    dish_types: Counter[str] = field(default_factory=Counter)
    foods: Counter[str] = field(default_factory=Counter)
    uses: Counter[tuple[str, str]] = field(default_factory=Counter)
    """By food and dish type."""
    states: Counter[tuple[str, str]] = field(default_factory=Counter)
    """By food and state."""

    def count(self, classes: Iterable[tuple[str, bool]], called: Sequence[tuple[str, str]], *, weight: int = 1) -> None:
        """Count a recipe with the ``classes`` that it may be, the sure ones marked, and foods as ``called`` in states.

        A ``weight`` of -1 takes it away.
        """
        sure = {dish_type for dish_type, is_sure in classes if is_sure}
        self.recipes += weight
        self.sure += weight if sure else 0
        for dish_type in sure:
            self.dish_types[dish_type] += weight
        for food in {food for food, _ in called}:
            self.foods[food] += weight
        for food, state in called:
            if state:
                self.states[food, state] += weight
            for dish_type in sure:
                self.uses[food, dish_type] += weight

    def write(self, ask: Ask) -> None:
        """Add all to the counts of the graph with ``ask``; it must have the foods and dish types."""
        ask(
            cypher.ADD_RECIPE_COUNTS,
            recipes=self.recipes,
            sure=self.sure,
            dish_types=[{"dish_type": name, "count": count} for name, count in _changed(self.dish_types)],
            foods=[{"food": name, "count": count} for name, count in _changed(self.foods)],
            uses=[{"food": food, "dish_type": name, "count": count} for (food, name), count in _changed(self.uses)],
            states=[{"food": food, "state": name, "count": count} for (food, name), count in _changed(self.states)],
        )


def take_turn(ask: Ask) -> None:
    """Wait, with ``ask``, until no other program writes; count recipes first that an earlier foon-kg stored.

    Raises GraphError where the database was emptied meanwhile.
    """
    row = next(iter(ask(cypher.RECIPES_TURN)), None)
    if row is None:
        raise GraphError("the database was emptied meanwhile", hint="Load again: that makes all that is needed anew.")
    if row.recipes is not None:
        return
    counts, last = RecipeCounts(), ""
    while page := ask(cypher.RECIPE_PAGE, after=last, dish_type="", most=RECIPES_COUNTED_AT_ONCE):
        for recipe in page:
            counts.count(recipe.classes, [(food, state) for food, state, *_ in recipe.ingredients])
        last = page[-1].id
    counts.write(ask)


def counted(transaction: neo4j.ManagedTransaction) -> RecipeCountRow:
    """Return how many recipes there are in ``transaction``. Raises SchemaError where they were never counted."""
    (row,) = ask(transaction, cypher.COUNT_RECIPES)
    if not row.are_counted:
        raise SchemaError(
            "the recipes of the graph were stored by an earlier foon-kg, which kept no counts of them",
            hint="Load any recipes, even some that are there already: foon load recipes PATH counts them all.",
        )
    return row


def _changed(counts: Counter[Key]) -> list[tuple[Key, int]]:
    return [(key, counts[key]) for key in sorted(counts) if counts[key]]
