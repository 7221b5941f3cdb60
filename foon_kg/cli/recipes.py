"""``foon recipes``: what the collections in the graph hold, and what they ask for that no video shows."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Json, Quiet, examples, print_json, sayer
from foon_kg.cli.dish_types import check_dish_types
from foon_kg.cli.streams import data

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.model.collected import CalledFor
    from foon_kg.store.graph.recipe_rows import RecipeClassRow, RecipeCountRow, WantedFoodRow
    from foon_kg.store.graph.recipes import StoredRecipe

EXAMPLES = examples(
    "foon recipes",
    "foon recipes --unseen 20",
    "foon recipes --sample 5 --dish salad --seed 7",
    "foon recipes --id 000018c8a5",
)


def recipes(
    *,
    sample: Annotated[int, typer.Option(min=0, metavar="N", help="Show N recipes drawn at random.")] = 0,
    dish: Annotated[str | None, typer.Option(metavar="TYPE", help="Draw them from this dish type.")] = None,
    partition: Annotated[
        str, typer.Option(metavar="PART", help="Draw them from this part of it: train, val or test.")
    ] = "",
    seed: Annotated[int, typer.Option(metavar="S", help="The same seed draws the same recipes.")] = 0,
    unseen: Annotated[
        int, typer.Option(min=0, metavar="N", help="Show the N foods that most recipes want and no video shows.")
    ] = 0,
    recipe_id: Annotated[str | None, typer.Option("--id", metavar="ID", help="Show this recipe.")] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Count, draw and show the recipes that were loaded.

    Without an option: how many recipes a dish type has, how many ingredients they call for, and how many of these are
    unseen. With --unseen N: what to annotate next. An ingredient is unseen where no unit of the FOON has that food.
    Only the sure dish type of a recipe counts.
    """
    from foon_kg.foon import Foon
    from foon_kg.model.errors import UsageError

    if [bool(sample), bool(unseen), recipe_id is not None].count(True) > 1:
        raise UsageError("--sample, --unseen and --id exclude each other", hint="Ask for one of them.")
    if (dish is not None or partition) and not sample:
        raise UsageError("--dish and --partition say from what to draw", hint="Add --sample N.")
    with Foon.connect(say=sayer(quiet=quiet)) as foon:
        if sample:
            ids = _drawn(foon, dish, partition, sample, seed)
            _show_recipes(list(map(foon.recipes.get, ids)), as_json=as_json)
        elif recipe_id is not None:
            _show_recipes([foon.recipes.get(recipe_id)], as_json=as_json)
        elif unseen:
            _show_wanted(foon.recipes.wanted_foods(unseen), as_json=as_json)
        else:
            _show_counts(*foon.recipes.counts(), as_json=as_json)


def _drawn(foon: Foon, dish: str | None, partition: str, count: int, seed: int) -> list[str]:
    from foon_kg.model import DISH_TYPES
    from foon_kg.model.errors import UsageError

    check_dish_types([dish] if dish is not None else [])
    ids = sorted({one for name in ([dish] if dish else DISH_TYPES) for one in foon.recipes.ids(name, partition)})
    if not ids:
        part = f" in the part “{partition}”" if partition else ""
        hint = "foon recipes counts what there is; foon load recipes PATH loads more."
        raise UsageError(f"the graph has no recipe of {dish or 'any dish type'}{part}", hint=hint)
    return sorted(random.Random(seed).sample(ids, min(count, len(ids))))  # noqa: S311 - a draw, no secret


def _show_recipes(shown: list[StoredRecipe], *, as_json: bool) -> None:
    if as_json:
        return print_json([_recipe_json(recipe) for recipe in shown])
    for recipe in shown:
        kinds = ", ".join(f"{dish.name}{'' if dish.sure else '?'}" for dish in recipe.dish_classes) or "no dish type"
        data().print(f"{recipe.title or '(no title)'}  [{recipe.id}]  {kinds}", style="bold", markup=False)
        for called in recipe.ingredients:
            data().print(f"  {_called_for(called)}", markup=False, highlight=False)
    return None


def _called_for(called: CalledFor) -> str:
    what = f"{called.object}, {called.state}" if called.state else called.object
    return f"{what}  ({called.amount})" if called.amount else what


def _recipe_json(recipe: StoredRecipe) -> dict[str, object]:
    return {
        "id": recipe.id,
        "title": recipe.title,
        "dish_types": [{"name": dish.name, "sure": dish.sure} for dish in recipe.dish_classes],
        "ingredients": [
            {"object": c.object, "state": c.state, "text": c.text, "quantity": c.quantity, "unit": c.unit}
            for c in recipe.ingredients
        ],
    }


def _show_wanted(rows: Sequence[WantedFoodRow], *, as_json: bool) -> None:
    if as_json:
        return print_json([{"food": row.food, "recipes": row.recipes, "states": row.states} for row in rows])
    return _print_table(
        "Wanted by recipes, shown in no video",
        ("food", "recipes", "most often"),
        [(row.food, f"{row.recipes:,}", ", ".join(row.states)) for row in rows],
    )


def _show_counts(count: RecipeCountRow, rows: Sequence[RecipeClassRow], *, as_json: bool) -> None:
    if as_json:
        classes = [
            {"dish_type": r.dish_type, "recipes": r.recipes, "ingredients": r.ingredients, "unseen": r.unseen}
            for r in rows
        ]
        return print_json({"recipes": count.recipes, "sure": count.sure, "foods": count.foods, "dish_types": classes})
    title = f"{count.recipes:,} recipes, {count.sure:,} of them with a sure dish type; they name {count.foods:,} foods"
    return _print_table(
        title,
        ("dish type", "recipes", "ingredients a recipe", "unseen a recipe", "share"),
        [
            (
                r.dish_type,
                f"{r.recipes:,}",
                f"{r.ingredients / r.recipes:.1f}",
                f"{r.unseen / r.recipes:.1f}",
                f"{r.unseen / r.ingredients:.0%}" if r.ingredients else "",
            )
            for r in rows
        ],
    )


def _print_table(title: str, columns: tuple[str, ...], rows: list[tuple[str, ...]]) -> None:
    from rich.table import Table

    if not rows:
        typer.echo(f"{title}: none")
        return
    data().print(title, style="italic", markup=False, soft_wrap=True)
    table = Table(box=None)
    for place, column in enumerate(columns):
        table.add_column(column, justify="right" if 0 < place < len(columns) - ("most often" in columns) else "left")
    for row in rows:
        table.add_row(*row)
    data().print(table)
