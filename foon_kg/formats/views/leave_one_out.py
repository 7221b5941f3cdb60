"""What leave-one-out found, as tables of a terminal."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from foon_kg.evaluation.methods import OURS
from foon_kg.evaluation.resampling import Interval
from foon_kg.evaluation.tree_overlap import MEASURES
from foon_kg.evaluation.video_figures import LeaveOneOut, VideosTogether
from foon_kg.formats.views.evaluation import columns, interval_words, left_out_view, per_cent
from foon_kg.formats.views.words import section

TITLES = {
    "units": "Units in common: motion and main object",
    "units_with_states": "Units in common, with states",
    "triples": "Triples in common: food, state and motion",
    "graph": "Edit distance of the graphs of units, as a likeness",
}


def leave_one_out_view(evaluation: LeaveOneOut) -> RenderableType:
    """Return what an ``evaluation`` says: each measure by method, how far foon-kg is ahead, units by dish type."""
    every = evaluation.all
    parts: list[RenderableType] = [Text(f"{len(every.videos)} videos, each taken out of the FOON and asked for")]
    parts += [section(title, _measure(every, measure)) for measure, title in TITLES.items()]
    parts.append(section("Units in common by dish type", _by_dish(evaluation)))
    if every.unproven:
        parts.append(Text(f"The search for {every.unproven} edit distances was given up: these are at least so close"))
    if evaluation.no_question:
        parts.append(section("No dish of any foods is marked in", Text(", ".join(evaluation.no_question))))
    return Group(*parts, *left_out_view(evaluation.left_out))


def _measure(videos: VideosTogether, measure: str) -> Table:
    table = columns("", "mean", "95 % interval", "foon-kg is ahead by", "no tree")
    for method in videos.methods:
        mean = videos.mean(method, measure)
        lead = "" if method == OURS else _lead(videos.ahead(method, measure))
        table.add_row(method, per_cent(mean.mean), interval_words(mean), lead, str(videos.failed(method)))
    return table


def _by_dish(evaluation: LeaveOneOut) -> Table:
    table = columns("", "videos", *evaluation.methods)
    for dish in (*evaluation.dishes, evaluation.all):
        means = (per_cent(dish.mean(method, MEASURES[0]).mean) for method in evaluation.methods)
        table.add_row(dish.name, str(len(dish.videos)), *means)
    return table


def _lead(lead: Interval) -> str:
    return f"{100 * lead.mean:+.1f} [{100 * lead.low:+.1f}, {100 * lead.high:+.1f}]"
