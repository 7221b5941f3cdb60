"""What speaks for and against one food standing for another: one number of each kind for each pair of names."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from foon_kg.food import tables
from foon_kg.similarity.forms import plain
from foon_kg.similarity.groups import FoodGroups
from foon_kg.similarity.sparse import Flags, SparseRows, Table
from foon_kg.similarity.taxonomy import MOST_NAMES, FoodTaxonomy
from foon_kg.similarity.vectors import FoodVectors

KINDS = (
    "vectors",  # cosine of the names' food vectors
    "head vectors",  # the same of their last words
    "kind",  # what WordNet says both are
    "kind unknown",  # WordNet does not know one of them
    "group",  # both are listed in one group of cooks' uses
    "guessed group",  # one of them had to be placed in a group
    "shelf",  # their groups stand on one shelf
    "same head word",  # rice vinegar, vinegar
    "more specific",  # the known one is a sort of the wanted: oil, olive oil
    "more general",  # the wanted one is a sort of the known: brown sugar, sugar
    "shared word",  # another word than the last is in both: almond, almond butter
    "prepared dish",  # the known one is a dish or a mixture, the wanted one is not
    "no food",  # the wanted one is in no table of foods
    "unknown word",  # the wanted one has another word that nobody ever read of food: floober sauce
)
"""The kinds of evidence, in the order in which :meth:`Evidence.between` has them."""

_KIND_SHARE = 0.5
"""Half of how near a name is to a listed food is what WordNet says of both, where it knows both."""

_ALONE = 0.8
"""So much the cosine of their vectors counts where WordNet does not know one of them."""


@dataclass(frozen=True, eq=False)
class Names:
    """All that is known of some canonical names, one row each, ready to be compared with other names."""

    vectors: Table
    heads: Table
    kinds: SparseRows
    groups: Table
    shelves: Table
    listed: Flags
    dish: Table
    strange: Flags
    obscure: Flags
    words: tuple[frozenset[str], ...]
    last_words: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Evidence:
    """Brings the vectors, the kinds, the groups and the words of names together."""

    food_vectors: FoodVectors
    taxonomy: FoodTaxonomy
    food_groups: FoodGroups

    def about(self, names: Sequence[str]) -> Names:
        """Return all that is known of canonical ``names``, read without words for pieces."""
        names = [plain(name, self.food_groups.places) for name in names]
        memberships = self.food_groups.rows(names, self._near_listed)
        kinds = self.taxonomy.rows(names)
        groups = memberships * self._stands_for_others
        last_words = tuple(name.rpartition(" ")[2] for name in names)
        return Names(
            vectors=self.food_vectors.embed(names),
            heads=self._heads(last_words),
            kinds=kinds,
            groups=groups,
            shelves=self.food_groups.shelves(groups),
            listed=np.array([name in self.food_groups.places for name in names], dtype=bool),
            dish=np.minimum(memberships @ self._is_dish, 1.0),
            strange=~kinds.filled & np.array([self._is_strange(name) for name in names], dtype=bool),
            obscure=np.array(list(map(self._obscure, names)), dtype=bool),
            words=tuple(frozenset(name.split()) for name in names),
            last_words=last_words,
        )

    def between(self, wanted: Names, known: Names) -> Table:
        """Return an array (kind of evidence, wanted, known): 0 says nothing, 1 is the most there can be."""
        kind_unknown = ~np.outer(wanted.kinds.filled, known.kinds.filled)
        agreement = np.minimum(wanted.groups @ known.groups.T, 1.0)
        both_listed = np.outer(wanted.listed, known.listed)
        return np.array(
            [
                wanted.vectors @ known.vectors.T,
                wanted.heads @ known.heads.T,
                known.kinds.product(wanted.kinds.dense()),
                kind_unknown,
                agreement * both_listed,
                agreement * ~both_listed,
                np.minimum(wanted.shelves @ known.shelves.T, 1.0),
                *_by_words(wanted, known),
                np.outer(1 - wanted.dish, known.dish),
                np.outer(wanted.strange, np.ones(len(known.words))),
                np.outer(wanted.obscure & ~wanted.strange, np.ones(len(known.words))),
            ],
            dtype=np.float64,
        )

    @cached_property
    def _is_dish(self) -> Table:
        return self.food_groups.on_shelves("dish", "apart")

    @cached_property
    def _stands_for_others(self) -> Table:
        return 1 - self.food_groups.on_shelves("apart")

    @cached_property
    def _obscure(self) -> Callable[[str], bool]:
        """:meth:`_is_obscure`, kept: plans ask again and again of the same names."""
        return lru_cache(maxsize=MOST_NAMES)(self._is_obscure)

    def _is_strange(self, name: str) -> bool:
        """Return whether no table lists a name or any ending of it as a food."""
        return not self.food_groups.has_ending(name) and tables().foods.find(name)[0] == "unknown"

    def _is_obscure(self, name: str) -> bool:
        """Return whether a word of a name of several is in no recipe behind the vectors, nor in any table."""
        words = name.split()
        return len(words) > 1 and any(
            word.isalpha() and not self.food_vectors.knows(word) and word not in self._listed_words for word in words
        )

    @cached_property
    def _listed_words(self) -> frozenset[str]:
        names = (*tables().foods.kind_of, *self.food_groups.foods, *self.taxonomy.meanings)
        return frozenset(word for name in names for word in name.split())

    def _heads(self, last_words: Sequence[str]) -> Table:
        """Return the vectors of ``last_words``; many names share them."""
        distinct = {word: place for place, word in enumerate(dict.fromkeys(last_words))}
        heads: Table = self.food_vectors.embed(list(distinct))[[distinct[word] for word in last_words]]
        return heads

    def _near_listed(self, names: Sequence[str]) -> Table:
        """Return how near ``names`` are to every listed food: half by vectors, half by kind where it is known."""
        vectors, kinds = self._listed
        rows, own = self.taxonomy.rows(names), self.food_vectors.embed(names)
        near = np.zeros((len(names), len(vectors)))
        told = rows.filled | own.any(axis=1)  # of the others nothing is known: they are near to nothing
        cosines = own[told] @ vectors.T
        by_kind = rows.columns(rows.used)[told] @ kinds.columns(rows.used).T  # a name is of ten kinds out of thousands
        both = np.outer(rows.filled[told], kinds.filled)
        near[told] = np.where(both, (1 - _KIND_SHARE) * cosines + _KIND_SHARE * by_kind, _ALONE * cosines)
        return near

    @cached_property
    def _listed(self) -> tuple[Table, SparseRows]:
        return self.food_vectors.embed(self.food_groups.foods), self.taxonomy.rows(self.food_groups.foods)


def _by_words(wanted: Names, known: Names) -> Table:
    """Return the four kinds of evidence that compare the names word by word."""
    places = {word: place for place, word in enumerate(sorted(frozenset().union(*wanted.words)))}
    shared = _word_rows(wanted, places) @ _word_rows(known, places).T
    size, known_size = _sizes(wanted)[:, None], _sizes(known)[None, :]
    same_head = np.array(wanted.last_words)[:, None] == np.array(known.last_words)[None, :]
    more_specific = same_head & (shared == size) & (size < known_size)
    more_general = same_head & (shared == known_size) & (known_size < size)
    return np.array([same_head, more_specific, more_general, (shared > 0) & ~same_head], dtype=np.float64)


def _word_rows(names: Names, places: dict[str, int]) -> Table:
    rows = [{places[word]: 1.0 for word in words if word in places} for words in names.words]
    return SparseRows.of(rows, len(places)).dense()


def _sizes(names: Names) -> Table:
    return np.array([len(words) for words in names.words], dtype=np.float64)
