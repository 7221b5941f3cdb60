"""The report of ``foon evaluate leave-one-out`` as one HTML file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from foon_kg.evaluation.comparison import Comparison
from foon_kg.evaluation.curves import THRESHOLDS, recipes_over
from foon_kg.evaluation.methods import BASELINES, OURS
from foon_kg.evaluation.resampling import Interval
from foon_kg.evaluation.tree_overlap import MEASURES
from foon_kg.evaluation.video_figures import LeaveOneOut, VideoFigures, VideosTogether
from foon_kg.formats.pictures.charts import curve_chart, interval_chart
from foon_kg.formats.pictures.report import (
    WORST,
    charts,
    comparison_section,
    left_out_section,
    page,
    paragraph,
    section,
    table,
    tree_picture,
    unfolded,
    without_tree_section,
    words,
)
from foon_kg.formats.views.evaluation import interval_words, per_cent
from foon_kg.formats.views.leave_one_out import TITLES
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.model import Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult


def leave_one_out_report(
    evaluation: LeaveOneOut,
    comparison: Comparison | None,
    subgraphs: Sequence[Subgraph],
    kitchen: Kitchen,
    planned: Callable[[VideoFigures], PlanResult],
) -> str:
    """Return the text of an HTML file: tables, charts, and the worst videos with both their trees.

    It tells an ``evaluation`` of ``subgraphs`` in a ``kitchen``, and its ``comparison`` with an earlier one.
    ``planned`` makes the tree of a video once more, from the others: the figures do not hold them.
    """
    every = evaluation.all
    parts = [
        paragraph(
            f"{len(every.videos)} videos, each taken out of the FOON and asked for: its dish type, and the foods that "
            "a cook would buy for it, in the states in which they first join others. Every figure is between 0 "
            "(nothing in common with what the person did) and 100 % (the same); without a tree it is 0. FOON "
            f"{evaluation.foon[:12]}, seed {evaluation.seed}."
        ),
        *([comparison_section(comparison)] if comparison else []),
        *(_measure(every, measure) for measure in MEASURES),
        _curves(every),
        _by_dish(evaluation),
        section(
            "worst", "The worst videos, with their trees", *_trees(worst(every.videos), subgraphs, kitchen, planned)
        ),
        _without_tree(every),
        left_out_section(evaluation.left_out),
    ]
    if every.unproven:
        parts.append(
            paragraph(f"The search for {every.unproven} edit distances was given up: they are at least so close.")
        )
    if evaluation.no_question:
        parts.append(paragraph(f"No dish of any foods is marked in {', '.join(evaluation.no_question)}."))
    return page("How good the task trees are: left-out videos", parts)


def worst(videos: Sequence[VideoFigures]) -> tuple[VideoFigures, ...]:
    """Return the videos with a tree that have least in common with it: units, then graph, then by name."""

    def rank(video: VideoFigures) -> tuple[object, ...]:
        ours = video.overlaps[OURS]
        return round(ours.units, 9), round(ours.graph, 9), video.recipe.id

    return tuple(sorted((video for video in videos if OURS not in video.failed), key=rank)[:WORST])


def _measure(every: VideosTogether, measure: str) -> str:
    means = {method: every.mean(method, measure) for method in every.methods}
    rows = [
        (
            words(method),
            f"<b>{per_cent(mean.mean)}</b>" if method == OURS else per_cent(mean.mean),
            interval_words(mean),
            "" if method == OURS else _lead(every.ahead(method, measure)),
            str(every.failed(method)),
        )
        for method, mean in means.items()
    ]
    chart = interval_chart(list(means.items()), TITLES[measure])
    told = f"{TITLES[measure]}: mean and 95 % interval by method."
    head = ("", "mean", "95 % interval", f"{OURS} is ahead by", "no tree")
    return section(measure.replace("_", "-"), TITLES[measure], charts((chart, told)), table(head, rows))


def _lead(lead: Interval) -> str:
    told = f"{100 * lead.mean:+.1f} [{100 * lead.low:+.1f}, {100 * lead.high:+.1f}]"
    return f'<span class="{"kept" if lead.low > 0 else "broken"}">{told}</span>' if lead.apart_from_zero else told


def _curves(every: VideosTogether) -> str:
    curves = {
        method: dict(
            zip(THRESHOLDS, recipes_over([video.overlaps[method].units for video in every.videos]), strict=True)
        )
        for method in (OURS, *BASELINES)
    }
    chart = curve_chart(curves, "Videos with at least so many units in common", "units in common, at least", "videos")
    told = "Share of the videos by how many units they have at least in common with the tree."
    return section("curve", "Videos with at least so much in common", charts((chart, told)))


def _by_dish(evaluation: LeaveOneOut) -> str:
    rows = [
        (
            words(dish.name),
            str(len(dish.videos)),
            *(per_cent(dish.mean(method, MEASURES[0]).mean) for method in evaluation.methods),
        )
        for dish in (*evaluation.dishes, evaluation.all)
    ]
    return section("dishes", "Units in common by dish type", table(("", "videos", *evaluation.methods), rows))


def _trees(
    videos: Sequence[VideoFigures],
    subgraphs: Sequence[Subgraph],
    kitchen: Kitchen,
    planned: Callable[[VideoFigures], PlanResult],
) -> Iterator[str]:
    named = {subgraph.name: subgraph for subgraph in subgraphs}
    for place, video in enumerate(videos):
        subgraph = named[video.recipe.id or ""]
        truth = ShownTree.of_subgraph(subgraph)
        ours = ShownTree.of_result(planned(video))
        foods = kitchen.with_foods(want.object for want in video.recipe.ingredients)
        found = video.overlaps[OURS]
        figures = f"{per_cent(found.units)} of the units, {per_cent(found.graph)} of the graph in common"
        asked = ", ".join(f"{want.state} {want.object}".strip() for want in video.recipe.ingredients)
        yield unfolded(
            f'<b>{words(subgraph.name)}</b> <span class="aside">{words(video.recipe.dish_type)}: {figures}</span>',
            paragraph(f"Asked: {asked}."),
            f"<h3>What foon-kg made: {len(ours.units)} units</h3>",
            tree_picture(ours, foods, f"worst-{place}-made"),
            f"<h3>What the person did: {len(truth.units)} units</h3>",
            tree_picture(truth, foods, f"worst-{place}-true"),
        )


def _without_tree(every: VideosTogether) -> str:
    failed = [video for video in every.videos if OURS in video.failed]
    return without_tree_section("video", [(v.recipe.id or "", v.recipe.dish_type, v.failed[OURS]) for v in failed])
