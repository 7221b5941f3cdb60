"""Leave one out, the paper's future work: every video taken out of the FOON, asked for, and compared with the answer.

Three baselines answer the same questions in the same run: the nearest recipe unchanged, the planner where nothing
stands for anything else, and the paper's own method. One that finds no tree has nothing in common with the truth.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from foon_kg.evaluation.left_out_video import LeftOutVideo
from foon_kg.evaluation.methods import METHODS
from foon_kg.evaluation.tree_overlap import NOTHING, Overlap, overlap
from foon_kg.evaluation.video_figures import VideoFigures
from foon_kg.model import Recipe, Subgraph
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.planning.recipes import IngredientWords, with_states
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.store.snapshot import Snapshot


def asking_without(
    subgraphs: Sequence[Subgraph], kitchen: Kitchen, methods: Sequence[str]
) -> Callable[[LeftOutVideo], VideoFigures]:
    """Return what asks ``methods`` for a video in a ``kitchen``, each of a FOON of all ``subgraphs`` but that one."""
    return partial(_asked_without, Snapshot.of(subgraphs, kitchen), methods)


def planned_without(subgraphs: Sequence[Subgraph], kitchen: Kitchen, video: VideoFigures) -> PlanResult:
    """Return the tree that foon-kg makes for a ``video`` of the others among ``subgraphs``, in this ``kitchen``.

    Raises NoTreeError where there is none.
    """
    rest, recipe = _left(Snapshot.of(subgraphs, kitchen), video.recipe)
    return Planner(rest, PlanSettings()).plan(recipe)


def _left(whole: Snapshot, recipe: Recipe) -> tuple[Snapshot, Recipe]:
    """Return the FOON without the video of the recipe, and the question in the words of that."""
    rest = whole.without(recipe.id or "")
    return rest, with_states(recipe, IngredientWords(rest.vocabulary(), rest.kitchen)).recipe


def _asked_without(whole: Snapshot, methods: Sequence[str], video: LeftOutVideo) -> VideoFigures:
    rest, recipe = _left(whole, video.recipe)
    overlaps, failed = dict[str, Overlap](), dict[str, str]()
    for method in methods:
        try:
            overlaps[method] = overlap(METHODS[method](rest, recipe), video.units, rest.kitchen)
        except NoTreeError as error:
            overlaps[method], failed[method] = NOTHING, error.message
    return VideoFigures(video.recipe, overlaps, failed)
