"""The collection of recipes that a FOON in a Neo4j has beside its videos.

The examples are of a Neo4j that holds the demo's FOON and its recipes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from foon_kg.foon.opened import Opened, silent
from foon_kg.model.nodes import one_spelling

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.language.collection import CollectionReader
    from foon_kg.model.collected import CollectedRecipe, UnderstoodRecipe
    from foon_kg.store.graph.recipe_rows import RecipeClassRow, RecipeCountRow, WantedFoodRow
    from foon_kg.store.graph.recipes import RecipesStored, StoredRecipe, Understand
    from foon_kg.store.offline.staged import Staged


class Recipes:
    """The recipes in the Neo4j of a FOON (``foon.recipes``); of one in files all of this raises ``UsageError``."""

    def __init__(self, foon: Opened) -> None:
        self._foon = foon

    def get(self, recipe_id: str) -> StoredRecipe:
        """Return a recipe that was loaded, by its ``recipe_id``. Raises ``UsageError`` where there is none of this id.

        >>> foon.recipes.get("limeade").title
        'Limeade'
        """
        from foon_kg.store.graph.recipes import stored_recipe

        return stored_recipe(self._foon.connection_for("for recipes"), one_spelling(recipe_id))

    def all(self, dish_type: str = "", *, after: str = "") -> Iterator[StoredRecipe]:
        """Yield the recipes whose id is greater than ``after``, by id: those that surely are a ``dish_type``.

        ``""`` stands for all types. They are read page by page: there may be a million.

        >>> [one.id for one in foon.recipes.all("salad", after="courgette_salad")]
        ['kohlrabi_salad', 'tomato_salad']
        """
        from foon_kg.store.graph.recipes import recipes_after

        return recipes_after(self._foon.connection_for("for recipes"), after, dish_type)

    def until(self, last: str, dish_type: str = "") -> tuple[int, int]:
        """Return how many recipes are of a ``dish_type`` (``""``: any), and how many have an id up to ``last``.

        >>> foon.recipes.until("kohlrabi_salad", "salad")
        (3, 2)
        """
        from foon_kg.store.graph.recipes import recipes_until

        return recipes_until(self._foon.connection_for("for recipes"), last, dish_type)

    def ids(self, dish_type: str, partition: str = "") -> list[str]:
        """Return the ids of the recipes that surely are a ``dish_type``, sorted.

        ``partition`` is the part of their collection they are of: ``train``, ``val``, ``test``, or ``""`` for any.

        >>> foon.recipes.ids("salad")
        ['courgette_salad', 'kohlrabi_salad', 'tomato_salad']
        """
        from foon_kg.store.graph.recipes import recipe_ids

        return recipe_ids(self._foon.connection_for("for recipes"), dish_type, partition)

    def counts(self) -> tuple[RecipeCountRow, Sequence[RecipeClassRow]]:
        """Return how many recipes and foods of theirs there are, and for each dish type what its recipes call for.

        >>> foon.recipes.counts()[0].recipes
        8
        """
        from foon_kg.store.graph.recipes import class_counts, recipe_count

        connection = self._foon.connection_for("for recipes")
        return recipe_count(connection), class_counts(connection)

    def wanted_foods(self, most: int = 20) -> Sequence[WantedFoodRow]:
        """Return the at most ``most`` foods that no unit has and most recipes call for: what to annotate next.

        >>> foon.recipes.wanted_foods(1)[0].food
        'kohlrabi'
        """
        from foon_kg.store.graph.recipes import wanted_foods

        return wanted_foods(self._foon.connection_for("for recipes"), most)

    def store(
        self,
        recipes: Iterable[CollectedRecipe],
        *,
        full: bool = False,
        stored: Callable[[RecipesStored], None] = silent,
        understood: Callable[[UnderstoodRecipe], None] = silent,
        left_over: Callable[[UnderstoodRecipe], None] = silent,
    ) -> RecipesStored:
        """Bring recipes of a collection into the graph, and return how many were new, replaced and unchanged.

        Their lines are read for the foods of this FOON, with ``full`` all by the parser of ingredient lines, else only
        where the collection names no food. ``stored`` is told of each transaction when it is safe, ``understood`` each
        recipe that was read, ``left_over`` those with lines in which no food was found.

        >>> from foon_kg.foon.demo import demo_recipes
        >>> from foon_kg.loaders.recipe_collections import RecipeCollections
        >>> with RecipeCollections(demo_recipes(), print) as recipes:
        ...     foon.recipes.store(recipes).unchanged
        8
        """
        from foon_kg.language.collection import CollectionReader, labels_of
        from foon_kg.language.recipe_lines import LineReader
        from foon_kg.planning.batch import cores
        from foon_kg.store.graph.recipes import load_recipes, prepare_for_recipes

        connection = self._foon.connection_for("for recipes")
        with LineReader(cores()) as lines:
            prepare_for_recipes(connection)
            with self._foon.reading() as view:
                reader = CollectionReader(labels_of(view.vocabulary()), lines, full)
            return load_recipes(
                connection,
                recipes,
                _reporting(reader, understood),
                stored=stored,
                left_over=left_over,
                version=reader.version,
            )

    @staticmethod
    def stage(
        staged: Staged,
        recipes: Iterable[CollectedRecipe],
        *,
        stored: Callable[[RecipesStored], None] = silent,
        understood: Callable[[UnderstoodRecipe], None] = silent,
        left_over: Callable[[UnderstoodRecipe], None] = silent,
    ) -> RecipesStored:
        """Bring recipes to what is ``staged`` for an offline import, which calls this ``beside`` its videos.

        ``stored``, ``understood`` and ``left_over`` are told what :meth:`store` tells them.
        """
        from foon_kg.language.collection import CollectionReader, labels_by_name
        from foon_kg.language.recipe_lines import LineReader
        from foon_kg.planning.batch import cores
        from foon_kg.store.offline.staging import stage_recipes

        with LineReader(cores()) as lines:
            reader = CollectionReader(labels_by_name(staged.seen_foods()), lines)
            understand = _reporting(reader, understood)
            return stage_recipes(
                staged, recipes, understand, version=reader.version, stored=stored, left_over=left_over
            )


def _reporting(reader: CollectionReader, understood: Callable[[UnderstoodRecipe], None]) -> Understand:
    """Return what understands recipes as ``reader`` does, and hands each of them to ``understood``."""

    def understand(asked: Sequence[CollectedRecipe]) -> Sequence[UnderstoodRecipe]:
        found = reader.understand(asked)
        for recipe in found:
            understood(recipe)
        return found

    return understand
