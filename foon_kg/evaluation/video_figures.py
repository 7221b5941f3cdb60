"""What leave-one-out found: by video, by dish type, and all in all."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.evaluation.methods import OURS
from foon_kg.evaluation.resampling import Interval, bootstrap_mean, paired_difference
from foon_kg.evaluation.sampling import LeftOut
from foon_kg.evaluation.tree_overlap import MEASURES, Overlap
from foon_kg.evaluation.verdicts import ALL
from foon_kg.model import Recipe
from foon_kg.model.json_fields import JsonObject


@dataclass(frozen=True)
class VideoFigures:
    """One video: what each method's tree has in common with the true subgraph; ``failed`` says who found no tree."""

    recipe: Recipe
    overlaps: dict[str, Overlap]
    failed: dict[str, str] = field(default_factory=dict)

    def to_json(self) -> JsonObject:
        """Return the video's entry; its own figures are those of foon-kg."""
        return {
            "id": self.recipe.id,
            "dish_type": self.recipe.dish_type,
            "asked": [{"object": want.object, "state": want.state} for want in self.recipe.ingredients],
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
        """Return the mean of a ``measure`` (0 to 1) of a ``method`` over the videos, with its interval."""
        return bootstrap_mean(self._values(method, measure), self.seed)

    def ahead(self, other: str, measure: str) -> Interval:
        """Return by how much foon-kg is ahead of the ``other`` method in a ``measure``, the videos drawn in pairs."""
        return paired_difference(self._values(OURS, measure), self._values(other, measure), self.seed)

    def failed(self, method: str) -> int:
        """Return for how many videos a method found no tree."""
        return sum(method in video.failed for video in self.videos)

    @property
    def unproven(self) -> int:
        """How many edit distances were given up before they were proven."""
        return sum(not found.proven for video in self.videos for found in video.overlaps.values())

    def to_json(self) -> JsonObject:
        """Return the entry under ``dish_types``."""
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

    @property
    def dishes(self) -> tuple[VideosTogether, ...]:
        """The figures of each dish type, by name."""
        names = sorted({video.recipe.dish_type for video in self.videos})
        return tuple(self._together(name) for name in names)

    @property
    def all(self) -> VideosTogether:
        """The figures of all videos."""
        return VideosTogether(ALL, self.videos, self.methods, self.seed)

    def to_json(self) -> JsonObject:
        """Return the evaluation as ``--json`` prints it and ``--compare`` reads it."""
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
        videos = tuple(video for video in self.videos if video.recipe.dish_type == name)
        return VideosTogether(name, videos, self.methods, self.seed)
