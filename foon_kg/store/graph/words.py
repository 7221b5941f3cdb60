"""What of a large FOON's words and goals matters to one recipe, found through Neo4j's indexes, without reading all.

The vector index answers the foods nearest to each wanted one, and the bound of :mod:`foon_kg.similarity.points` says
what none of the others can exceed: where that is little enough, all that matters is there. So it is exact, like
:mod:`foon_kg.store.graph.equivalents`; of the public FOON, and among thirty thousand names, 64 points settle every
food.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from foon_kg.food import words
from foon_kg.model.knowledge import FAIR, UNLIKE, Gathering, MadeBy, SeenAs, Vocabulary
from foon_kg.model.names import canonical
from foon_kg.similarity import Confidences, food_similarity
from foon_kg.similarity.points import question
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.equivalents import FIRST, MORE
from foon_kg.store.graph.rows import StateRow, WordsForRow

BEST = 4
"""Where a food has a fair equivalent, so many of its best are wanted: the one chosen and three alternatives."""

MOST = FIRST * MORE
"""So many points a food are asked for at most; a food that they do not settle is compared with all words in memory."""

Ask = Callable[[Mapping[str, Any]], list[WordsForRow]]


@dataclass(frozen=True)
class WordsFound:
    """The part of the vocabulary, and each pair of a wanted food and a name of at least ``UNLIKE`` confidence.

    Every other name is less sure. A pair has the number of the food among those asked for.
    """

    vocabulary: Vocabulary
    pairs: tuple[tuple[int, str, float], ...]


def find_words(ask: Ask, foods: Sequence[str], called: Sequence[str]) -> WordsFound | None:
    """Return what matters to ``foods``, and besides the foods called like ``called``.

    ``ask`` takes the parameters of ``cypher/words_for.cypher``. ``None`` where that cannot be told without reading all
    words: the points are of other word lists, a food has no word in it, too many others are near it, or so few that
    foods of which nothing is known, and which have no point, may be among the best.
    """
    if not all(map(words, foods)):
        return None
    asked = [{"name": food, "point": question(food).point, "words": words(food)} for food in foods]
    names = sorted(set(map(canonical, (*foods, *called))))
    count = FIRST
    while count <= MOST:
        rows = ask({"words": word_lists_key(), "called": names, "asked": asked, "count": count})
        if not rows:
            return None
        found = _Found(rows[0], foods)
        unsettled = [food for food in foods if not found.settles(food, count)]
        if not unsettled:
            return WordsFound(found.vocabulary(), tuple(found.pairs()))
        if any(found.is_all(food, count) for food in unsettled):
            return None
        count *= MORE
    return None


def seen_as(rows: Iterable[StateRow]) -> Iterator[SeenAs]:
    """Return the rows of the vocabulary that travelled by state."""
    columns = (zip(labels, [state] * len(labels), made, used, strict=True) for state, labels, made, used in rows)
    return map(SeenAs._make, chain.from_iterable(columns))


class _Found:
    """One answer of the database, and how sure each name in it is for each food."""

    def __init__(self, row: WordsForRow, foods: Sequence[str]) -> None:
        self.row, self.foods = row, foods
        self.names = sorted(row.names)
        self.confidences: Confidences = food_similarity().matrix(foods, self.names)
        self.known = {label for _, labels, _, _ in row.foods for label in labels}
        self.nearest = {name: (size, furthest) for name, size, furthest in row.nearest}

    def is_all(self, food: str, count: int) -> bool:
        """Say whether the index has no more; what is left has no point."""
        return self.nearest.get(food, (0, 0.0))[0] < count

    def settles(self, food: str, count: int) -> bool:
        """Say whether nothing that was not answered matters to ``food``."""
        is_all = self.is_all(food, count)
        if is_all and self.row.all_placed:
            return True
        bound = question(food).most(0.0 if is_all else self.nearest[food][1])
        best = self._best(food)
        fair = bool(best) and best[0] >= FAIR
        return bound < UNLIKE and (not fair or (len(best) >= BEST and best[BEST - 1] > bound))

    def _best(self, food: str) -> list[float]:
        """Return how sure each known name is for ``food``, the surest first."""
        sure = zip(self.names, self.confidences[self.foods.index(food)].tolist(), strict=True)
        return sorted((confidence for name, confidence in sure if name in self.known and name != food), reverse=True)

    def vocabulary(self) -> Vocabulary:
        motions = (MadeBy(*motion) for motion in sorted(self.row.motions))
        return Vocabulary(
            tuple(sorted(seen_as(self.row.foods))),
            tuple(motions),
            tuple(sorted(self.row.dish_types)),
            tuple(sorted(self.row.states)),
            tuple(Gathering(*verb) for verb in sorted(self.row.verbs)),
        )

    def pairs(self) -> Iterator[tuple[int, str, float]]:
        for number, row in enumerate(self.confidences.tolist()):
            for name, confidence in zip(self.names, row, strict=True):
                if confidence >= UNLIKE:
                    yield number, name, confidence
