"""``foon plan``: the task tree of a recipe, or of many."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, print_view, sayer, show_error
from foon_kg.errors import FoonError, NoTreeError, ReadError, UsageError
from foon_kg.model import DISH_TYPES, Recipe

if TYPE_CHECKING:
    from foon_kg.knowledge import KnowledgeView
    from foon_kg.recipes import IngredientWords, ReadRecipe
    from foon_kg.result import PlanFailure, PlanResult

EXAMPLES = examples(
    'foon plan --dish salad "chopped onion" "whole prune" "olive oil"',
    "foon plan recipe.json --json",
    "foon plan recipes/ --files subgraphs/ --json > plans.jsonl",
)


def _dish_types(incomplete: str) -> list[str]:
    return [dish_type for dish_type in DISH_TYPES if dish_type.startswith(incomplete)]


def plan(
    wanted: Annotated[
        list[str],
        typer.Argument(
            metavar="INGREDIENT|RECIPE...",
            help="With --dish ingredients, state first (“chopped onion”); otherwise recipe files (JSON) or folders.",
        ),
    ],
    *,
    dish: Annotated[
        str | None,
        typer.Option("--dish", metavar="TYPE", help="The dish type: salad, soup, …", autocompletion=_dish_types),
    ] = None,
    as_json: Json = False,
    foon: Annotated[bool, typer.Option("--foon", help="Print the tree as FOON text.")] = False,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Plan the task tree that makes a dish from these ingredients.

    The answer is the steps in order, what has to be in the kitchen, what FOON has not seen so and which equivalent
    stands for it, and the progress of each ingredient.

    A recipe file is {"id", "title", "type", "ingredients": [{"object", "state"}]}. With --json every recipe is one
    line, in order; one that has no tree is a line with an "error". With several recipes the exit code is the highest.
    """
    from foon_kg.cli.knowledge import open_knowledge
    from foon_kg.kitchen import Kitchen
    from foon_kg.recipes import IngredientWords

    if as_json and foon:
        raise UsageError("--json and --foon ask for two forms of one answer", hint="Choose one of them.")
    questions = [_question_in_words(dish, wanted)] if dish is not None else _questions_in_files(wanted, one_only=foon)
    say = sayer(quiet=quiet)
    with open_knowledge(files, say) as view:
        words = IngredientWords(view.vocabulary(), Kitchen.default())
        codes = [_show(answer, as_json, foon) for answer in _answers(questions, view, words, say)]
    if any(codes):
        raise typer.Exit(max(codes))


@dataclass(frozen=True)
class _Question:
    """A recipe still to be read; ``stand_in`` is what is known of one that turns out to be unreadable."""

    stand_in: Recipe
    read: Callable[[IngredientWords], ReadRecipe]


@dataclass(frozen=True)
class _NoAnswer:
    """Why a recipe has no tree; in a batch it takes the place of one."""

    failure: PlanFailure
    error: FoonError


def _question_in_words(dish_type: str, texts: Sequence[str]) -> _Question:
    from foon_kg.recipes import recipe_of

    return _Question(Recipe(dish_type, ()), lambda words: recipe_of(dish_type, texts, words))


def _questions_in_files(names: Sequence[str], *, one_only: bool) -> list[_Question]:
    from foon_kg.recipes import read_recipe, recipe_files

    paths = list(recipe_files(Path(name) for name in names))
    if one_only and len(paths) > 1:
        raise UsageError(f"--foon prints one tree, and these are {len(paths)} recipes", hint="Ask for them one by one.")
    return [_Question(Recipe("", (), id=path.stem), partial(read_recipe, path)) for path in paths]


def _answers(
    questions: Sequence[_Question], view: KnowledgeView, words: IngredientWords, say: Say
) -> Iterator[PlanResult | _NoAnswer]:
    from foon_kg.planner import Planner, PlanSettings
    from foon_kg.result import PlanFailure
    from foon_kg.snapshot import Snapshot

    whole = view.units if isinstance(view, Snapshot) and len(questions) > 1 else None
    planner = Planner(view, PlanSettings(), whole)
    for question in questions:
        recipe = question.stand_in
        try:
            read = question.read(words)
            recipe = read.recipe
            for note in read.notes:
                say(note)
            yield planner.plan(recipe)
        except (NoTreeError, ReadError, UsageError) as error:  # any other ends the batch: it is not about this recipe
            yield _NoAnswer(PlanFailure.of(recipe, error), error)


def _show(answer: PlanResult | _NoAnswer, as_json: bool, foon: bool) -> int:
    """Print one answer; return the exit code that it stands for."""
    if isinstance(answer, _NoAnswer):
        if as_json:
            print_json(answer.failure.to_json())
        show_error(answer.error, about=answer.failure.recipe.id)
        return answer.error.exit_code
    if as_json:
        print_json(answer.to_json())
    elif foon:
        from foon_kg.loaders import write_text

        typer.echo(write_text(answer.to_subgraph()), nl=False)
    else:
        from foon_kg.views.tree import plan_view

        print_view(plan_view(answer))
    return 0
