"""Choose the planner's rules by leave-one-out on one half of the videos, and report what they do to the other half.

    python benchmarks/evaluation_rules.py ../shared/data/foon-111/TXT [NAME...]

Every rule is tried with other values; NAMEs try only these. The halves are drawn within each dish type, so that both
have of all. A value is better where the first half says so; the second half, which chose nothing, says whether that is
true.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from foon_kg import carriers, goals, integration, question, substitution
from foon_kg.batch import cores
from foon_kg.cli.knowledge import whole_foon
from foon_kg.evaluation.leave_one_out import asking_without
from foon_kg.evaluation.left_out_video import LeftOutVideo, left_out_video
from foon_kg.evaluation.methods import OURS
from foon_kg.evaluation.resampling import Interval, bootstrap_mean, paired_difference
from foon_kg.evaluation.sampling import drawn, known_enough
from foon_kg.evaluation.video_figures import VideoFigures
from foon_kg.kitchen import Kitchen
from foon_kg.model import Subgraph
from foon_kg.processes import spread

SEED = 0
AS_IT_IS = "as it is"


def as_it_is() -> None:
    """Change nothing."""


def ties(near: float, first: int) -> None:
    """Tell more or fewer goals apart by their trees."""
    goals.NEAR, question.FIRST_GOALS = near, first


def same_class(least: float) -> None:
    """Let more or fewer states stand for one another."""
    substitution.SAME_CLASS = least


def fair(least: float) -> None:
    """Let fewer foods stand for one another."""
    substitution.FAIR = question.FAIR = integration.FAIR = carriers.FAIR = least


def goals_by_score() -> None:
    """Rank goals by likeness alone, truly named or not."""

    def order(ranked: goals.RankedGoal) -> tuple[object, ...]:
        goal = ranked.goal
        return -round(ranked.score, 2), len(ranked.misnamed), len(goal.ingredients), goal.node.sort_key, goal.dish_type

    goals._order = order  # noqa: SLF001 - the rule that is tried


RULES: Mapping[str, Callable[[], None]] = {
    AS_IT_IS: as_it_is,
    "ties 0.15, 3 goals": partial(ties, 0.15, 3),
    "ties 0.5, 5 goals": partial(ties, 0.5, 5),
    "states from 0.4": partial(same_class, 0.4),
    "states from 0.65": partial(same_class, 0.65),
    "foods from 0.6": partial(fair, 0.6),
    "foods from 0.7": partial(fair, 0.7),
    "goals by score alone": goals_by_score,
}


def asking(rule: str, subgraphs: Sequence[Subgraph], kitchen: Kitchen) -> Callable[[LeftOutVideo], VideoFigures]:
    RULES[rule]()
    return asking_without(subgraphs, kitchen, (OURS,))


def units(
    rule: str, videos: Sequence[LeftOutVideo], subgraphs: Sequence[Subgraph], kitchen: Kitchen
) -> dict[str, float]:
    """Answer by video the units in common, planned with ``rule`` in processes of their own."""
    with spread(partial(asking, rule, subgraphs, kitchen), videos, max(2, cores())) as found:
        return {figures.recipe.id: figures.overlaps[OURS].units for figures in found}


def halves(videos: Sequence[LeftOutVideo]) -> tuple[list[str], list[str]]:
    first = []
    for dish in sorted({video.recipe.dish_type for video in videos}):
        names = [video.name for video in videos if video.recipe.dish_type == dish]
        first += drawn(names, (len(names) + 1) // 2, SEED, dish)
    return first, [video.name for video in videos if video.name not in set(first)]


def shown(interval: Interval) -> str:
    return f"{100 * interval.mean:5.1f} [{100 * interval.low:5.1f},{100 * interval.high:5.1f}]"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("rules", nargs="*", choices=[[], *RULES], metavar="NAME")
    asked_for = parser.parse_args()
    foon = whole_foon([asked_for.folder], lambda *_: None)
    enough = known_enough(foon.goals())
    asked = [left_out_video(subgraph, foon.kitchen) for subgraph in foon.subgraphs]
    videos = [video for video in asked if video is not None and video.recipe.dish_type in enough]
    chosen, held_out = halves(videos)
    usual = units(AS_IT_IS, videos, foon.subgraphs, foon.kitchen)
    head = (f"first half ({len(chosen)})", "than now", f"other half ({len(held_out)})", "than now")
    print(" " * 24 + "".join(f"{name:>22}" for name in head))
    for rule in asked_for.rules or RULES:
        found = usual if rule == AS_IT_IS else units(rule, videos, foon.subgraphs, foon.kitchen)
        row = []
        for half in (chosen, held_out):
            row.append(shown(bootstrap_mean([found[name] for name in half], SEED)))
            row.append(shown(paired_difference([found[n] for n in half], [usual[n] for n in half], SEED)))
        print(f"{rule:24}" + "".join(f"{cell:>22}" for cell in row), flush=True)


if __name__ == "__main__":
    main()
