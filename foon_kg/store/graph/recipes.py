"""Collections of recipes in the graph: loaded in batches, counted, sampled, and read one by one.

``(:Recipe {id, title, content, source, partition, url, left_over})-[:CALLS_FOR {position, state, text, quantity,
unit}]->(:Ingredient)``, and ``(:Recipe)-[:KIND_OF {sure}]->(:DishType)``. The way from a dish type to its recipes has a
type of its own beside the ``IS_A`` of goal nodes, so that a plan's goals are found without passing a million recipes.
What is counted of them is kept (``recipe_counts``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import islice

import neo4j

from foon_kg.food.words import without_part
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.model.collected import CalledFor, CollectedRecipe, DishClass, UnderstoodRecipe
from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import statements as cypher
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.recipe_counts import RecipeCounts, counted, take_turn
from foon_kg.store.graph.recipe_rows import RecipeClassRow, RecipeCountRow, RecipePageRow, RecipeRow, WantedFoodRow
from foon_kg.store.graph.schema import prepare_for_writing
from foon_kg.store.graph.statements import Ask, ask

RECIPES_PER_TRANSACTION = 1_000

_SPACED = {0x1F: " "}
"""An import joins lists by this character, which Python takes for white space like others."""

Understand = Callable[[Sequence[CollectedRecipe]], Sequence[UnderstoodRecipe]]


@dataclass(frozen=True)
class RecipesStored:
    """How many recipes were new, how many had another content, how many were there already as they are."""

    inserted: int = 0
    replaced: int = 0
    unchanged: int = 0
    foods: int = 0
    left_over: int = 0

    def __add__(self, other: RecipesStored) -> RecipesStored:
        """Return both as one."""
        return RecipesStored(
            self.inserted + other.inserted,
            self.replaced + other.replaced,
            self.unchanged + other.unchanged,
            self.foods + other.foods,
            self.left_over + other.left_over,
        )

    def __len__(self) -> int:
        """Return how many recipes it is about."""
        return self.inserted + self.replaced + self.unchanged


@dataclass(frozen=True)
class StoredRecipe:
    """A recipe as the graph has it."""

    id: str
    title: str
    dish_classes: tuple[DishClass, ...]
    ingredients: tuple[CalledFor, ...]

    def asked(self, dish_type: str = "") -> Recipe:
        """Return what is to be planned: as the given dish type, else as its sure one, else as any.

        For what of the dish a food is, its line says ("for the glaze").
        """
        return Recipe(
            dish_type or next((dish.name for dish in self.dish_classes if dish.sure), ""),
            tuple(
                RequiredIngredient(called.object, called.state, called.amount, without_part(called.text)[1])
                for called in self.ingredients
            ),
            self.id,
            self.title or None,
        )


def prepare_for_recipes(connection: Connection, kitchen: Kitchen | None = None) -> None:
    """Apply what the graph of ``connection`` lacks of the schema and of counts.

    ``kitchen`` is the usual one for ``None``.

    Raises SchemaError for a graph that a newer foon-kg wrote.
    """
    with connection.session(writing=True) as session:
        prepare_for_writing(session, kitchen or Kitchen.default())
        session.execute_write(_take_turn)


def _take_turn(transaction: neo4j.ManagedTransaction) -> None:
    take_turn(partial(ask, transaction))


def load_recipes(
    connection: Connection,
    recipes: Iterable[CollectedRecipe],
    understand: Understand,
    *,
    stored: Callable[[RecipesStored], None] = lambda _: None,
    left_over: Callable[[UnderstoodRecipe], None] = lambda _: None,
    version: str = "",
    recipes_per_transaction: int = RECIPES_PER_TRANSACTION,
) -> RecipesStored:
    """Bring the graph of ``connection`` to have ``recipes``.

    Those that it has with the same content are not read again.

    Each transaction has so many whole recipes (``recipes_per_transaction``), and ``stored`` is told once it is safe:
    after a kill, the next load goes on behind it. While one batch is written, the next is understood, by
    ``understand``. ``version`` names the way of understanding: with another one everything counts as changed.
    ``left_over`` is told each recipe with lines in which no food was found. Needs :func:`prepare_for_recipes`. Raises
    GraphError when the database fails.
    """
    total, writing = RecipesStored(), None
    with ThreadPoolExecutor(max_workers=1) as writer:
        for batch in batches(recipes, recipes_per_transaction):
            there = _contents(connection, batch)
            changed = [recipe for recipe in batch if there.get(recipe.id) != _content(recipe, version)]
            understood = understand(changed)
            total += _finished(writing, stored)
            for recipe in understood:
                if recipe.left_over:
                    left_over(recipe)
            known = sum(recipe.id in there for recipe in changed)
            report = RecipesStored(
                len(changed) - known,
                known,
                len(batch) - len(changed),
                sum(len(recipe.ingredients) for recipe in understood),
                sum(len(recipe.left_over) for recipe in understood),
            )
            writing = writer.submit(_write, connection, understood, version, report)
        return total + _finished(writing, stored)


def class_counts(connection: Connection) -> list[RecipeClassRow]:
    """Return for each dish type on ``connection`` how many recipes it surely has, and what they call for.

    Of that it is told how much no unit has.
    """
    with connection.session() as session:
        session.execute_read(counted)
        return session.execute_read(ask, cypher.RECIPE_CLASSES)


def recipe_count(connection: Connection) -> RecipeCountRow:
    """Return how many recipes ``connection`` has, with a sure dish type and in all, and how many foods they name."""
    with connection.session() as session:
        return session.execute_read(counted)


def wanted_foods(connection: Connection, most: int) -> list[WantedFoodRow]:
    """Return the ``most`` foods on ``connection`` that no unit has and most recipes call for, with commonest states."""
    with connection.session() as session:
        session.execute_read(counted)
        return session.execute_read(ask, cypher.WANTED_FOODS, most=most)


def recipe_ids(connection: Connection, dish_type: str, partition: str = "") -> list[str]:
    """Return the ids of the recipes on ``connection`` that surely are a ``dish_type``, of a ``partition``, sorted.

    The partition (``train``, ``val``, ``test``) is any for ``""``.
    """
    with connection.session() as session:
        rows = session.execute_read(ask, cypher.RECIPE_IDS, dish_type=dish_type, partition=partition)
    return [row.id for row in rows]


def stored_recipe(connection: Connection, recipe_id: str) -> StoredRecipe:
    """Return the recipe with ``recipe_id`` on ``connection``. Raises UsageError where the graph does not have it."""
    with connection.session() as session:
        rows = session.execute_read(ask, cypher.RECIPE, id=recipe_id)
    if not rows:
        hint = "foon recipes --sample 5 shows some; foon load recipes PATH loads more."
        raise UsageError(f"the graph has no recipe “{recipe_id}”", hint=hint)
    return _stored(recipe_id, rows[0])


def recipes_after(connection: Connection, last: str = "", dish_type: str = "") -> Iterator[StoredRecipe]:
    """Yield the recipes on ``connection`` behind the id ``last``, by their ids: those that surely are a ``dish_type``.

    They are of all dish types for ``""``, and are read as they are asked for, some at a time.
    """
    rows: list[RecipePageRow] = []
    while True:
        after = rows[-1].id if rows else last
        with connection.session() as session:
            rows = session.execute_read(
                ask, cypher.RECIPE_PAGE, after=after, dish_type=dish_type, most=RECIPES_PER_TRANSACTION
            )
        if not rows:
            return
        yield from (_stored(row.id, row) for row in rows)


def recipes_until(connection: Connection, last: str, dish_type: str = "") -> tuple[int, int]:
    """Return how many recipes of ``dish_type`` are on ``connection``, and how many have an id up to ``last``."""
    with connection.session() as session:
        (row,) = session.execute_read(ask, cypher.RECIPES_UNTIL, last=last, dish_type=dish_type)
    return row.recipes, row.until


def _stored(recipe_id: str, row: RecipeRow | RecipePageRow) -> StoredRecipe:
    classes = tuple(DishClass(name, sure=sure) for name, sure in sorted(row.classes, key=lambda c: (not c[1], c[0])))
    return StoredRecipe(recipe_id, row.title, classes, tuple(CalledFor(*called) for called in row.ingredients))


def batches(recipes: Iterable[CollectedRecipe], size: int = RECIPES_PER_TRANSACTION) -> Iterator[list[CollectedRecipe]]:
    """Yield ``recipes`` in groups of ``size``, in their order."""
    waiting = iter(recipes)
    while batch := list(islice(waiting, size)):
        yield batch


def _contents(connection: Connection, batch: Sequence[CollectedRecipe]) -> dict[str, str]:
    with connection.session() as session:
        rows = session.execute_read(ask, cypher.RECIPE_CONTENTS, ids=[recipe.id for recipe in batch])
    return {row.id: row.content for row in rows}


def _content(recipe: CollectedRecipe, version: str) -> str:
    return f"{version}:{recipe.content}"


def _finished(writing: Future[RecipesStored] | None, stored: Callable[[RecipesStored], None]) -> RecipesStored:
    if writing is None:
        return RecipesStored()
    report = writing.result()
    stored(report)
    return report


def _write(
    connection: Connection, recipes: Sequence[UnderstoodRecipe], version: str, report: RecipesStored
) -> RecipesStored:
    if recipes:
        with connection.session(writing=True) as session:
            session.execute_write(_write_batch, recipes, version)
    return report


def _write_batch(transaction: neo4j.ManagedTransaction, recipes: Sequence[UnderstoodRecipe], version: str) -> None:
    write_recipes(partial(ask, transaction), recipes, version)


def write_recipes(ask: Ask, recipes: Sequence[UnderstoodRecipe], version: str) -> None:
    """Write ``recipes`` with their counts: in one transaction, or into what is staged for an import, as ``ask`` does.

    ``version`` names the way in which they were understood.
    """
    take_turn(ask)
    counts = RecipeCounts()
    for held in ask(cypher.RECIPES_HELD, ids=[one.recipe.id for one in recipes]):
        counts.count(held.classes, held.ingredients, weight=-1)
    for one in recipes:
        classes_of_it = [(dish.name, dish.sure) for dish in one.dish_classes]
        counts.count(classes_of_it, [(called.object, called.state) for called in one.ingredients])
    _write_words(ask, recipes)
    rows = sorted((_row(recipe, version) for recipe in recipes), key=lambda row: str(row["id"]))
    ask(cypher.LOAD_RECIPES, recipes=rows)
    counts.write(ask)


def _write_words(ask: Ask, recipes: Sequence[UnderstoodRecipe]) -> None:
    """Write the foods and dish classes of ``recipes`` that are not there yet."""
    foods = sorted({called.object for recipe in recipes for called in recipe.ingredients})
    classes = sorted({dish.name for recipe in recipes for dish in recipe.dish_classes})
    words = [{"name": food, "canonical": canonical(food)} for food in foods]
    ask(cypher.LOAD_RECIPE_WORDS, ingredients=words, dish_types=classes)


def _row(understood: UnderstoodRecipe, version: str) -> dict[str, object]:
    recipe = understood.recipe
    return {
        "id": recipe.id,
        "properties": {
            "title": recipe.title,
            "content": _content(recipe, version),
            "source": recipe.place,
            "partition": recipe.partition,
            "url": recipe.url,
            "left_over": [text.translate(_SPACED) for text in understood.left_over] or None,
        },
        "classes": [{"name": dish.name, "sure": dish.sure} for dish in understood.dish_classes],
        "ingredients": [
            {"name": called.object, "properties": _called(called, position)}
            for position, called in enumerate(understood.ingredients)
        ],
    }


def _called(called: CalledFor, position: int) -> dict[str, object]:
    return {
        "position": position,
        "state": called.state,
        "text": called.text,
        "quantity": called.quantity,
        "unit": called.unit,
    }
