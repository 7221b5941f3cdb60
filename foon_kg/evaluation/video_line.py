"""A left-out video's figures as one line of a file with which a run that was stopped goes on; no figure is rounded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict

from foon_kg.evaluation.tree_overlap import MEASURES, Overlap
from foon_kg.evaluation.video_figures import VideoFigures
from foon_kg.model import Recipe
from foon_kg.model.errors import UsageError
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.node_json import recipe_to_json


def to_line(figures: VideoFigures, foon: str) -> JsonObject:
    """Return the line of the ``figures`` of a video; ``foon`` names the FOON from which it was left out."""
    return {
        "recipe": recipe_to_json(figures.recipe),
        "foon": foon,
        "methods": {method: asdict(found) for method, found in figures.overlaps.items()},
        "failed": figures.failed,
    }


def from_line(line: JsonObject, where: str, recipe: Recipe, methods: Sequence[str], foon: str) -> VideoFigures:
    """Read back what :func:`to_line` wrote of ``recipe``.

    Raises UsageError where the line was written of another FOON or of other ``methods``, and ReadError where it is
    something else.
    """
    fields = Fields(line, where)
    found, failed = fields.nested("methods"), fields.nested("failed")
    if fields.text("foon") != foon or found.names != tuple(sorted(methods)):
        raise UsageError(
            f"{where}: this line was written of another FOON or for other methods",
            hint="Name another file, or take this one away to begin anew.",
        )
    overlaps = {method: _overlap(found.nested(method)) for method in methods}
    return VideoFigures(recipe, overlaps, {method: failed.text(method) for method in methods if method in failed})


def _overlap(fields: Fields) -> Overlap:
    units, with_states, triples, graph = map(fields.number, MEASURES)
    return Overlap(units, with_states, triples, graph, proven=fields.truth("proven"))
