"""How likely a cook is to accept one food for another, and Algorithm 2 over whole ingredient lists.

``food_similarity()`` is the default; ``spacy_similarity(name)`` and ``cosine_similarity()`` are the paper's way.
"""

from foon_kg.model.knowledge import Neighbour
from foon_kg.similarity.answers import Confidences, Similarity
from foon_kg.similarity.food import food_similarity
from foon_kg.similarity.lists import count_similar, matching
from foon_kg.similarity.raw import cosine_similarity, spacy_similarity

__all__ = [
    "Confidences",
    "Neighbour",
    "Similarity",
    "cosine_similarity",
    "count_similar",
    "food_similarity",
    "matching",
    "spacy_similarity",
]
