"""Food words as vectors: a GloVe of 35 numbers a word stem, learnt from recipes (``data/food-vectors.npz``)."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files

import numpy as np
import numpy.typing as npt
from Stemmer import Stemmer

Vectors = npt.NDArray[np.float64]

_WORD = re.compile(r"[a-z]+")
_STEMMER = Stemmer("english")


def stem(word: str) -> str:
    """Answer the English Snowball stem, under which the vectors are kept."""
    return str(_STEMMER.stemWord(word))


@dataclass(frozen=True, eq=False)
class FoodVectors:
    """A vector for each known stem."""

    vectors: Vectors
    places: dict[str, int]

    def embed(self, names: Sequence[str]) -> Vectors:
        """Answer one row of length 1 for each name: the mean of its words. Zeros where no word is known."""
        return np.array([self._embed(name) for name in names]).reshape(len(names), self.vectors.shape[1])

    def _embed(self, name: str) -> Vectors:
        places = [self.places[s] for s in map(stem, _WORD.findall(name)) if s in self.places]
        total: Vectors = self.vectors[places].sum(axis=0)
        return total / (math.sqrt(float(total @ total)) or 1.0)


@lru_cache(maxsize=1)
def food_vectors() -> FoodVectors:
    """Answer the vectors that ship with foon-kg, read once."""
    path = files("foon_kg.data").joinpath("food-vectors.npz")
    with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
        stems = archive["stems"].tobytes().decode().split("\n")
        return FoodVectors(archive["vectors"].astype(np.float64), {s: place for place, s in enumerate(stems)})
