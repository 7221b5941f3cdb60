"""Leave one out, the paper's future work: every video taken out of the FOON, asked for, and compared with the answer.

Two baselines answer the same questions in the same run: the nearest recipe unchanged, and a search for which nothing
stands for anything else. A method that finds no tree has nothing in common with the truth.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial

from foon_kg.errors import NoTreeError
from foon_kg.evaluation.left_out_video import LeftOutVideo
from foon_kg.evaluation.methods import METHODS, OURS
from foon_kg.evaluation.resampling import Interval, bootstrap_mean, paired_difference
from foon_kg.evaluation.sampling import LeftOut
from foon_kg.evaluation.tree_overlap import MEASURES, NOTHING, Overlap, overlap
from foon_kg.json_fields import JsonObject
from foon_kg.kitchen import Kitchen
from foon_kg.model import Subgraph
from foon_kg.recipes import IngredientWords, with_states
from foon_kg.snapshot import Snapshot

ALL = "all"
"""The name under which all videos are taken together."""


@dataclass(frozen=True)
class VideoFigures:
    """One video: what each method's tree has in common with the true subgraph; ``failed`` says who found no tree."""

    video: LeftOutVideo
    overlaps: dict[str, Overlap]
    failed: dict[str, str] = field(default_factory=dict)

    def to_json(self) -> JsonObject:
        """Answer the video's entry; its own figures are those of foon-kg."""
        return {
            "id": self.video.name,
            "dish_type": self.video.recipe.dish_type,
            "asked": [{"object": want.object, "state": want.state} for want in self.video.recipe.ingredients],
            **self.overlaps[OURS].to_json(),
            "methods": {method: found.to_json() for method, found in self.overlaps.items()},
            "failed": self.failed,
        }


@dataclass(frozen=True)
class VideosTogether:
    """Some videos taken together, as a rule those of one dish type."""

    name: str
    videos: tuple[VideoFigures, ...]
    methods: tuple[str, ...]
    seed: int

    def mean(self, method: str, measure: str) -> Interval:
        """Answer the mean of a measure over the videos, with its interval."""
        return bootstrap_mean(self._values(method, measure), self.seed)

    def ahead(self, other: str, measure: str) -> Interval:
        """Answer by how much foon-kg is ahead of another method, the videos drawn in pairs."""
        return paired_difference(self._values(OURS, measure), self._values(other, measure), self.seed)

    def failed(self, method: str) -> int:
        """Answer for how many videos a method found no tree."""
        return sum(method in video.failed for video in self.videos)

    def to_json(self) -> JsonObject:
        """Answer the entry under ``dish_types``."""
        others = [method for method in self.methods if method != OURS]
        return {
            "dish_type": self.name,
            "videos": len(self.videos),
            "methods": {
                method: {
                    **{measure: self.mean(method, measure).to_json() for measure in MEASURES},
                    "without_tree": self.failed(method),
                }
                for method in self.methods
            },
            "ahead_of": {
                other: {measure: self.ahead(other, measure).to_json() for measure in MEASURES} for other in others
            },
        }

    def _values(self, method: str, measure: str) -> list[float]:
        return [getattr(video.overlaps[method], measure) for video in self.videos]


@dataclass(frozen=True)
class LeaveOneOut:
    """The answer of ``foon evaluate leave-one-out``; ``no_question`` are videos that mark no dish of any foods."""

    foon: str
    seed: int
    videos: tuple[VideoFigures, ...]
    methods: tuple[str, ...]
    left_out: tuple[LeftOut, ...] = ()
    no_question: tuple[str, ...] = ()

    @cached_property
    def dishes(self) -> tuple[VideosTogether, ...]:
        """The figures of each dish type, by name."""
        names = sorted({video.video.recipe.dish_type for video in self.videos})
        return tuple(self._together(name) for name in names)

    @cached_property
    def all(self) -> VideosTogether:
        """The figures of all videos."""
        return VideosTogether(ALL, self.videos, self.methods, self.seed)

    def to_json(self) -> JsonObject:
        """Answer the evaluation as ``--json`` prints it and ``--compare`` reads it."""
        return {
            "evaluation": "leave-one-out",
            "foon": self.foon,
            "seed": self.seed,
            "dish_types": [dish.to_json() for dish in (*self.dishes, self.all)],
            "left_out": [dish.to_json() for dish in self.left_out],
            "no_question": list(self.no_question),
            "videos": [video.to_json() for video in self.videos],
        }

    def _together(self, name: str) -> VideosTogether:
        videos = tuple(video for video in self.videos if video.video.recipe.dish_type == name)
        return VideosTogether(name, videos, self.methods, self.seed)


def asking_without(
    subgraphs: Sequence[Subgraph], kitchen: Kitchen, methods: Sequence[str]
) -> Callable[[LeftOutVideo], VideoFigures]:
    """Answer what asks ``methods`` for a video, each of a FOON of all ``subgraphs`` but that one."""
    return partial(_asked_without, subgraphs, kitchen, methods)


def _asked_without(
    subgraphs: Sequence[Subgraph], kitchen: Kitchen, methods: Sequence[str], video: LeftOutVideo
) -> VideoFigures:
    rest = Snapshot.of((other for other in subgraphs if other.name != video.name), kitchen)
    recipe = with_states(video.recipe, IngredientWords(rest.vocabulary(), rest.kitchen)).recipe
    overlaps, failed = dict[str, Overlap](), dict[str, str]()
    for method in methods:
        try:
            overlaps[method] = overlap(METHODS[method](rest, recipe), video.units, rest.kitchen)
        except NoTreeError as error:
            overlaps[method], failed[method] = NOTHING, error.message
    return VideoFigures(video, overlaps, failed)
