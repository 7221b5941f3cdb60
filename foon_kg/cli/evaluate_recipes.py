"""``foon evaluate recipes``: the paper's experiment with an executable rule."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli import evaluate_options as options
from foon_kg.cli.console import Dask, Files, Json, Quiet, Say, examples, print_json, print_view, sayer
from foon_kg.cli.dish_types import check_dish_types
from foon_kg.model import DISH_TYPES, Recipe
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.evaluation.comparison import Earlier
    from foon_kg.evaluation.figures import RecipeEvaluation
    from foon_kg.evaluation.sheet import FilledSheet
    from foon_kg.foon import Foon
    from foon_kg.model.json_fields import JsonObject
    from foon_kg.plans.result import PlanFailure, PlanResult

EXAMPLES = examples(
    "foon evaluate recipes recipes/ --files subgraphs/",
    "foon evaluate recipes recipes/ --sample 20 --seed 1 --json > old.json",
    "foon evaluate recipes recipes/ --sample 20 --seed 1 --compare old.json",
    "foon evaluate recipes --dish salad --sample 20 --seed 1",
    "foon evaluate recipes recipes/ --output scored.jsonl --scores-to sheet.csv",
    "foon evaluate recipes recipes/ --output scored.jsonl --scores sheet.csv",
    "foon evaluate recipes recipes/ --html report.html",
    "foon evaluate recipes recipes/ --method paper --json > paper.json",
)


def recipes(  # noqa: PLR0917 - each parameter is an option of its own
    paths: Annotated[
        list[Path] | None,
        typer.Argument(metavar="FILE|DIR...", help="Recipes (JSON); else those that foon load recipes brought in."),
    ] = None,
    dish: options.Dish = None,
    sample: Annotated[
        int | None, typer.Option("--sample", metavar="N", min=1, help="Draw N recipes of each dish type.")
    ] = None,
    seed: options.Seed = 0,
    output: options.Output = None,
    scores_to: Annotated[
        Path | None, typer.Option("--scores-to", metavar="FILE.csv", help="Write a sheet on which people can score.")
    ] = None,
    scores: Annotated[
        Path | None, typer.Option("--scores", metavar="FILE.csv", help="Read their scores, and compare the rule's.")
    ] = None,
    method: options.Method = "frames",
    html: options.Html = None,
    compare: options.Compare = None,
    jobs: options.Jobs = None,
    dask: Dask = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Plan recipes, and score each required ingredient 0, 1 or 2.

    The rule: 2 when its progress line starts in the kitchen, reaches the asked state by motions that make that state
    in the FOON, and ends in the dish (a state in which the food is sold needs no motion); 1 when it ends in the dish
    but its preparation is missing or not supported; 0 otherwise. It ends in the dish where the goal names it. A recipe
    without a tree has 0 for each ingredient, and is named.

    Told by dish type: the share correct (the sum of scores by twice the lines; the interval is a bootstrap over
    recipes), the share of recipes that are at least so correct, the confidences of substitutions, how many trees the
    judge of foon check accepts (robot, cook, both; of all recipes asked), and how many break each of its rules. Dish
    types with fewer than three goals in the FOON are left out and named.

    With --compare, recipes of both evaluations are compared in pairs: a difference is more than chance where the 95 %
    interval of its mean does not hold 0. --scores answers Cohen's kappa, linearly weighted. The same FOON, recipes and
    seed give the same answer to the byte.
    """
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.foon import Evaluation, Foon

    say = sayer(quiet=quiet)
    check_dish_types(dish or ())
    options.check_places(scores_to=scores_to, html=html)
    before = None if compare is None else Evaluation.earlier(compare, "recipes")
    sheet = None if scores is None else Evaluation.filled_sheet(scores)
    foon = Foon(whole_foon(files, say))
    planned = partial(_outcomes, foon, options.Run(output, jobs, dask, say, quiet, method))
    asked = _asked(paths or (), dish or (), sample, seed=seed, foon=foon, say=say)
    found = _Found(foon.evaluation.recipes(asked, seed=seed, planned=planned), sheet, before)
    if scores_to is not None:
        options.write_text(scores_to, Evaluation.sheet(found.evaluation), "--scores-to")
    if html is not None:
        options.write_text(html, found.report(), "--html")
    print_json(found.to_json()) if as_json else found.show()


def _asked(
    paths: Sequence[Path], dishes: Sequence[str], sample: int | None, *, seed: int, foon: Foon, say: Say
) -> list[Recipe]:
    """Return the recipes to be planned: those of ``paths``, else those that the graph holds."""
    from foon_kg.foon import Foon

    if paths:
        found = foon.evaluation.recipes_of(*paths, dish_types=dishes, sample=sample, seed=seed, noted=say)
    else:
        with Foon.connect(say=say) as collection:
            found = foon.evaluation.loaded_recipes(collection.recipes, dishes or DISH_TYPES, sample=sample, seed=seed)
    if not found:
        raise UsageError("there is no such recipe", hint="Name other files or dish types; foon recipes counts them.")
    return found


def _outcomes(foon: Foon, run: options.Run, asked: Sequence[Recipe]) -> list[PlanResult | PlanFailure]:
    """Plan ``asked`` on several cores or machines; what the file of answers has already is not planned again."""
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.cli.answering import Writing, answer_all
    from foon_kg.foon import Answer, PlanSettings, Question
    from foon_kg.plans.result import PlanFailure, PlanResult

    found: list[PlanResult | PlanFailure] = []

    def collect(answer: Answer) -> None:
        found.append(answer.outcome)

    questions = [Question(given=recipe) for recipe in asked]
    writing = Writing(collect, run.output, run.say, run.quiet, collected=True)
    answer_all(questions, foon, PlanSettings(method=run.method), run.jobs, writing, dask=run.dask)
    if run.output is None:
        return found
    return [
        PlanFailure.from_json(value, f"{run.output}:{line}")
        if "error" in value
        else PlanResult.from_json(value, f"{run.output}:{line}")
        for line, value in enumerate(AnswerFile.read(run.output).lines, 1)
    ]


class _Found:
    """What an evaluation found, with what it was compared with: the scores on a sheet, and an evaluation of before."""

    def __init__(self, evaluation: RecipeEvaluation, sheet: FilledSheet | None, before: Earlier | None) -> None:
        self.evaluation = evaluation
        self._left_open = 0 if sheet is None else sheet.left_open
        self._agreement = None if sheet is None else sheet.agreement_with(evaluation.recipes)
        self._comparison = None if before is None else before.compared_with(evaluation.to_json(), evaluation.seed)

    def to_json(self) -> JsonObject:
        """Return all of it as JSON."""
        value = self.evaluation.to_json()
        if self._agreement is not None:
            value["agreement"] = self._agreement.to_json()
        if self._comparison is not None:
            value["comparison"] = self._comparison.to_json()
        return value

    def show(self) -> None:
        """Print all of it for reading."""
        from foon_kg.formats.views.evaluation import agreement_view, comparison_view, recipe_evaluation_view

        print_view(recipe_evaluation_view(self.evaluation))
        if self._agreement is not None:
            print_view(agreement_view(self._agreement, self._left_open))
        if self._comparison is not None:
            print_view(comparison_view(self._comparison))

    def report(self) -> str:
        """Return all of it as a page."""
        from foon_kg.formats.pictures.recipes_report import recipes_report

        return recipes_report(self.evaluation, self._agreement, self._comparison)
