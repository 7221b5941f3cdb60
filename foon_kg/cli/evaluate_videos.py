"""``foon evaluate leave-one-out``: every video taken out of the FOON, and asked for."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, examples, print_json, print_view, progress_bar, sayer
from foon_kg.cli.evaluate_recipes import Compare, Jobs, Seed, compared, foon_key
from foon_kg.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.evaluation.left_out_video import LeftOutVideo
    from foon_kg.evaluation.video_figures import LeaveOneOut, VideoFigures
    from foon_kg.snapshot import Snapshot

EXAMPLES = examples(
    "foon evaluate leave-one-out --files subgraphs/",
    "foon evaluate leave-one-out --sample 5 --seed 1 --json > old.json",
    "foon evaluate leave-one-out --sample 5 --seed 1 --compare old.json",
    "foon evaluate leave-one-out --dish salad --parts",
)


def leave_one_out(  # noqa: PLR0917 - each parameter is an option of its own
    dish: Annotated[list[str] | None, typer.Option("--dish", metavar="TYPE", help="Only this dish type.")] = None,
    sample: Annotated[
        int | None, typer.Option("--sample", metavar="N", min=1, help="Draw N videos of each dish type.")
    ] = None,
    seed: Seed = 0,
    parts: Annotated[bool, typer.Option("--parts", help="Also switch off parts of the planner, one by one.")] = False,
    compare: Compare = None,
    jobs: Jobs = None,
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

    Baselines in the same run: the reference tree of the nearest recipe (Algorithm 1) unchanged, and a search for which
    only the same food and state stand for a food and a state. With --parts also the planner without its similarity of
    foods, and without its classes of states.

    Means have 95 % bootstrap intervals; the lead over each baseline is drawn in pairs. Dish types with fewer than
    three goals in the FOON are left out and named. The same FOON and seed give the same answer to the byte.
    """
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.evaluation.comparison import read_evaluation
    from foon_kg.views.evaluation import comparison_view
    from foon_kg.views.leave_one_out import leave_one_out_view

    before = None if compare is None else read_evaluation(compare, "leave-one-out")
    snapshot = whole_foon(files, sayer(quiet=quiet))
    evaluation = _evaluated(snapshot, dish or [], sample, seed, parts=parts, jobs=jobs, quiet=quiet)
    value = evaluation.to_json()
    comparison = None if before is None else compared(before, value, str(compare), seed)
    if as_json:
        print_json(value if comparison is None else {**value, "comparison": comparison.to_json()})
        return
    print_view(leave_one_out_view(evaluation))
    if comparison is not None:
        print_view(comparison_view(comparison))


def _evaluated(
    snapshot: Snapshot,
    dishes: Sequence[str],
    sample: int | None,
    seed: int,
    *,
    parts: bool,
    jobs: int | None,
    quiet: bool,
) -> LeaveOneOut:
    from foon_kg.evaluation.left_out_video import left_out_video
    from foon_kg.evaluation.methods import methods
    from foon_kg.evaluation.sampling import known_enough, left_out, sampled
    from foon_kg.evaluation.video_figures import LeaveOneOut

    found = [(subgraph.name, left_out_video(subgraph, snapshot.kitchen)) for subgraph in snapshot.subgraphs]
    videos = [video for _, video in found if video is not None and (not dishes or video.recipe.dish_type in dishes)]
    goals = snapshot.goals()
    enough, out = known_enough(goals), left_out((video.recipe.dish_type for video in videos), goals)
    drawn = [video.recipe for video in videos if video.recipe.dish_type in enough]
    drawn = drawn if sample is None else sampled(drawn, sample, seed)
    names = {recipe.id for recipe in drawn}
    asked = [video for video in videos if video.name in names]
    if not asked:
        raise UsageError(
            "there is no video to leave out", hint="It needs a dish type with three goals in the FOON: see foon stats."
        )
    compared_methods = methods(parts=parts)
    with _answering(asked, snapshot, compared_methods, jobs) as answers:
        figures = tuple(answers if quiet else progress_bar(answers, len(asked), 0))
    nothing = tuple(name for name, video in found if video is None)
    return LeaveOneOut(foon_key(snapshot), seed, figures, compared_methods, out, nothing)


def _answering(
    asked: Sequence[LeftOutVideo], snapshot: Snapshot, methods: Sequence[str], jobs: int | None
) -> AbstractContextManager[Iterable[VideoFigures]]:
    from functools import partial

    from foon_kg.batch import MANY, cores
    from foon_kg.evaluation.leave_one_out import asking_without
    from foon_kg.processes import spread

    processes = cores() if jobs is None else jobs
    make = partial(asking_without, snapshot.subgraphs, snapshot.kitchen, methods)
    if processes > 1 and len(asked) >= MANY:
        return spread(make, asked, processes)
    return nullcontext(map(make(), asked))
