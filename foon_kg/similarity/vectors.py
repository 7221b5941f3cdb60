"""Food words as vectors: a GloVe of 35 numbers a word stem, learnt from recipes (``food-vectors.npz``)."""

from __future__ import annotations

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
    """Return the English Snowball stem of a ``word``, under which the vectors are kept."""
    return str(_STEMMER.stemWord(word))


@dataclass(frozen=True, eq=False)
class FoodVectors:
    """A vector for each known stem."""

    vectors: Vectors
    places: dict[str, int]

    def embed(self, names: Sequence[str]) -> Vectors:
        """Return one row of length 1 for each name: the mean of its words. Zeros where no word is known."""
        places = [self._places(name) for name in names]
        counts = np.array(list(map(len, places)), dtype=np.int64)
        totals = np.zeros((len(names), self.vectors.shape[1]))
        if counts.any():
            starts = (np.cumsum(counts) - counts)[counts > 0]
            totals[counts > 0] = np.add.reduceat(self.vectors[[p for each in places for p in each]], starts, axis=0)
        return of_length_one(totals)

    def knows(self, word: str) -> bool:
        """Return whether there is a vector for a word of small letters."""
        return stem(word) in self.places

    def _places(self, name: str) -> list[int]:
        return [self.places[s] for s in map(stem, _WORD.findall(name)) if s in self.places]


def of_length_one(rows: Vectors) -> Vectors:
    """Return ``rows``, each as long as 1; one of zeros stays so."""
    lengths = np.sqrt((rows * rows).sum(axis=1, keepdims=True))
    unit: Vectors = rows / np.where(lengths == 0, 1.0, lengths)
    return unit


@lru_cache(maxsize=1)
def food_vectors() -> FoodVectors:
    """Return the vectors that ship with foon-kg, read once."""
    path = files("foon_kg.similarity").joinpath("food-vectors.npz")
    with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
        stems = archive["stems"].tobytes().decode().split("\n")
        return FoodVectors(archive["vectors"].astype(np.float64), {s: place for place, s in enumerate(stems)})
