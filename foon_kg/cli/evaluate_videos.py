"""``foon evaluate leave-one-out``: every video taken out of the FOON, and asked for."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli import evaluate_options as options
from foon_kg.cli.console import Dask, Files, Json, Quiet, examples, json_line, print_json, print_view, sayer
from foon_kg.cli.dish_types import check_dish_types
from foon_kg.cli.runs import progress_bar

if TYPE_CHECKING:
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.evaluation.comparison import Comparison
    from foon_kg.evaluation.left_out_video import LeftOutVideo
    from foon_kg.evaluation.video_figures import LeaveOneOut, VideoFigures
    from foon_kg.foon import Foon

EXAMPLES = examples(
    "foon evaluate leave-one-out --files subgraphs/",
    "foon evaluate leave-one-out --sample 5 --seed 1 --json > old.json",
    "foon evaluate leave-one-out --sample 5 --seed 1 --compare old.json",
    "foon evaluate leave-one-out --dish salad --html report.html",
    "foon evaluate leave-one-out --output videos.jsonl",
    "foon evaluate leave-one-out --dask tcp://127.0.0.1:8786",
)


def leave_one_out(  # noqa: PLR0917 - each parameter is an option of its own
    dish: options.Dish = None,
    sample: Annotated[
        int | None, typer.Option("--sample", metavar="N", min=1, help="Draw N videos of each dish type.")
    ] = None,
    seed: options.Seed = 0,
    output: options.Output = None,
    html: options.Html = None,
    compare: options.Compare = None,
    jobs: options.Jobs = None,
    dask: Dask = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Leave out each video, ask for it, and compare.

    The question is the video's dish type and the foods of its goal, in the states in which they first join others; a
    mixture that the video makes is asked as what it is made of.
    Compared are, each as intersection over union: units (the motion with its main object; the same with its states),
    and triples of food, state and motion; and as graphs of units, by their edit distance (0 nothing in common, 1 the
    same). A method without a tree has 0.

    Baselines in the same run: the reference tree of the nearest recipe unchanged, the planner where no other food
    stands for a food, and the paper's own four algorithms. A tree of foon-kg also says what annotators leave out (the
    stove that is turned on and off), so that even the right tree has not all in common with the truth.

    Means have 95 % bootstrap intervals; the lead over each baseline is drawn in pairs. Dish types with fewer than
    three goals in the FOON are left out and named. The same FOON and seed give the same answer to the byte, wherever
    they were planned and however often a run with --output was stopped.
    """
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.foon import Evaluation, Foon

    check_dish_types(dish or [])
    options.check_places(html=html)
    say = sayer(quiet=quiet)
    before = None if compare is None else Evaluation.earlier(compare, "leave-one-out")
    foon = Foon(whole_foon(files, say))
    compared = partial(_figures, foon, options.Run(output, jobs, dask, say, quiet))
    evaluation = foon.evaluation.leave_one_out(dish or (), sample=sample, seed=seed, compared=compared)
    value = evaluation.to_json()
    comparison = None if before is None else before.compared_with(value, seed)
    if html is not None:
        _write_report(html, evaluation, comparison, foon)
    if as_json:
        print_json(value if comparison is None else {**value, "comparison": comparison.to_json()})
    else:
        _show(evaluation, comparison)


def _show(evaluation: LeaveOneOut, comparison: Comparison | None) -> None:
    from foon_kg.formats.views.evaluation import comparison_view
    from foon_kg.formats.views.leave_one_out import leave_one_out_view

    print_view(leave_one_out_view(evaluation))
    if comparison is not None:
        print_view(comparison_view(comparison))


def _figures(foon: Foon, run: options.Run, asked: Sequence[LeftOutVideo], methods: Sequence[str]) -> list[VideoFigures]:
    """Return the figures of all videos; those that the file of answers has already are not asked for again."""
    from foon_kg.evaluation.video_line import from_line, to_line

    key = foon.content_key()
    done = _answered_before(asked, run)
    found = [
        from_line(line, f"{run.output}:{number}", video.recipe, methods, key)
        for number, (line, video) in enumerate(zip(done.lines if done else (), asked, strict=False), 1)
    ]
    keep = nullcontext(None) if done is None else done.going_on()
    with (
        foon.evaluation.leaving_out(asked[len(found) :], methods, jobs=run.jobs, dask=run.dask) as answers,
        keep as add,
    ):
        for figures in progress_bar(answers, "Leaving out videos", len(asked), len(found), quiet=run.quiet):
            found.append(figures)
            if add is not None:
                add(json_line(to_line(figures, key)))
    return found


def _answered_before(asked: Sequence[LeftOutVideo], run: options.Run) -> AnswerFile | None:
    from foon_kg.cli.answer_file import AnswerFile
    from foon_kg.model.node_json import recipe_to_json

    if run.output is None:
        return None
    done = AnswerFile.read(run.output)
    done.check([recipe_to_json(video.recipe) for video in asked])
    if done.lines:
        run.say(f"{run.output} has {len(done.lines)} of {len(asked)} answers already")
    return done


def _write_report(path: Path, evaluation: LeaveOneOut, comparison: Comparison | None, foon: Foon) -> None:
    from foon_kg.formats.pictures.leave_one_out_report import leave_one_out_report

    whole = foon.snapshot()
    planned = foon.evaluation.plan_of_left_out
    report = leave_one_out_report(evaluation, comparison, whole.subgraphs, whole.kitchen, planned)
    options.write_text(path, report, "--html")
