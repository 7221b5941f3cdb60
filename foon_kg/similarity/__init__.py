"""How likely a cook is to accept one food for another, and Algorithm 2 over whole ingredient lists.

``food_similarity()`` is the default; ``spacy_similarity(name)`` and ``cosine_similarity()`` are the paper's way. A name
is imported when somebody first asks for it: the measures need numpy.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from foon_kg.model.knowledge import Neighbour
    from foon_kg.similarity.confidences import Confidences, Similarity
    from foon_kg.similarity.food import food_similarity
    from foon_kg.similarity.lists import count_similar, matching
    from foon_kg.similarity.raw import cosine_similarity, plugged_similarity, spacy_similarity

__all__ = [
    "Confidences",
    "Neighbour",
    "Similarity",
    "cosine_similarity",
    "count_similar",
    "food_similarity",
    "matching",
    "plugged_similarity",
    "spacy_similarity",
]

_HOMES = {
    "Confidences": "foon_kg.similarity.confidences",
    "Neighbour": "foon_kg.model.knowledge",
    "Similarity": "foon_kg.similarity.confidences",
    "cosine_similarity": "foon_kg.similarity.raw",
    "count_similar": "foon_kg.similarity.lists",
    "food_similarity": "foon_kg.similarity.food",
    "matching": "foon_kg.similarity.lists",
    "plugged_similarity": "foon_kg.similarity.raw",
    "spacy_similarity": "foon_kg.similarity.raw",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
