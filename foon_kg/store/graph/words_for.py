"""What of a large FOON's words and goals matters to one recipe, found through Neo4j's indexes, without reading all.

What matters is what :meth:`KnowledgeView.words_for <foon_kg.model.knowledge.KnowledgeView.words_for>` promises. The
vector index answers the foods nearest to each wanted one, and the bound of :mod:`foon_kg.similarity.points` says what
none of the others can exceed (filter and refine; Faloutsos and others, 1994): where that is little enough, all that
matters is there. So it is exact, like :mod:`foon_kg.store.graph.equivalents`, and one round trip where the first
points settle every food.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from foon_kg.food import words
from foon_kg.model.knowledge import FAIR, UNLIKE, Gathering, MadeBy, SeenAs, Vocabulary
from foon_kg.model.names import canonical
from foon_kg.similarity import food_similarity
from foon_kg.similarity.points import question
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.equivalents import FIRST, MORE
from foon_kg.store.graph.rows import StateRow, WordsForRow

BEST = 4
"""Where a food has a fair equivalent, so many of its best are promised: the one chosen and three alternatives."""

MOST = FIRST * MORE
"""So many points a food are asked for at most; where they do not settle each food, who asks reads all words."""

Ask = Callable[[Mapping[str, Any]], list[WordsForRow]]


@dataclass(frozen=True)
class WordsFound:
    """The part of the vocabulary, and each pair of a wanted food and a name of at least ``UNLIKE`` confidence.

    Every other name is less sure. A pair is (place among the wanted foods, name, confidence).
    """

    vocabulary: Vocabulary
    pairs: tuple[tuple[int, str, float], ...]


def find_words(ask: Ask, foods: Sequence[str], called: Sequence[str]) -> WordsFound | None:
    """Return what matters to ``foods``, each of them once, and all that is known of the foods with names ``called``.

    ``ask`` takes the parameters of ``cypher/words_for.cypher``. ``None`` where only all words together tell it:

    - a food has no word in it by which others could be named after it;
    - the points are of other word lists than those of this program: ``ask`` returns no row;
    - more than ``MOST`` others are near a food;
    - all that have a point are there, and names without one, of which nothing is known, could still be among the best.

    >>> others_lists = []
    >>> find_words(lambda parameters: others_lists, ["onion"], ()) is None
    True
    >>> raw = ("raw", ["onion"], [1], [2])
    >>> row = WordsForRow([("onion", 1, 1.0)], ["onion"], True, [raw], ["raw"], [], [], ["soup"])
    >>> found = find_words(lambda parameters: [row], ["onion"], ())
    >>> found.vocabulary.labels, found.pairs
    (['onion'], ((0, 'onion', 1.0),))
    """
    if not all(map(words, foods)):
        return None
    asked = [{"name": food, "point": question(food).point, "words": words(food)} for food in foods]
    names = sorted(set(map(canonical, (*foods, *called))))
    count = FIRST
    while count <= MOST:
        rows = ask({"words": word_lists_key(), "names": names, "asked": asked, "count": count})
        if not rows:
            return None
        found = _RowRead(rows[0], foods)
        unsettled = [food for food in foods if not found.settles(food, count)]
        if not unsettled:
            return WordsFound(found.vocabulary(), tuple(found.pairs()))
        if any(found.has_all_points(food, count) for food in unsettled):
            return None  # more points would bring nothing: names without one decide, and only all words have these
        count *= MORE
    return None


def seen_as(rows: Iterable[StateRow]) -> Iterator[SeenAs]:
    """Yield what is known of each food in each state; a row has one state, with its foods and their counts by place.

    Raises ValueError where the lists of a row are not equally long.

    >>> list(seen_as([("chopped", ["leek", "onion"], [1, 3], [2, 4])]))[1]
    SeenAs(label='onion', state='chopped', made=3, used=4)
    """
    columns = (zip(labels, [state] * len(labels), made, used, strict=True) for state, labels, made, used in rows)
    return map(SeenAs._make, chain.from_iterable(columns))


class _RowRead:
    """The row that the database answered, and how sure each name in it is for each food."""

    def __init__(self, row: WordsForRow, foods: Sequence[str]) -> None:
        self.row = row
        self.names = sorted(row.names)
        confidences: list[list[float]] = food_similarity().matrix(foods, self.names).tolist()
        self.confidences = dict(zip(foods, confidences, strict=True))
        self.known = {label for _, labels, _, _ in row.foods for label in labels}
        self.nearest = {name: (size, furthest) for name, size, furthest in row.nearest}

    def has_all_points(self, food: str, count: int) -> bool:
        """Return whether the index has answered every point that it has for ``food``, asked for ``count``."""
        return self.nearest.get(food, (0, 0.0))[0] < count

    def settles(self, food: str, count: int) -> bool:
        """Return whether nothing that was not answered matters to ``food``."""
        has_all = self.has_all_points(food, count)
        if has_all and self.row.all_placed:
            return True
        furthest = 0.0 if has_all else self.nearest[food][1]  # a name without a point is at right angles to all foods
        surest_of_others = question(food).most(furthest)
        if surest_of_others >= UNLIKE:
            return False
        best = self._best(food)
        has_fair = bool(best) and best[0] >= FAIR
        return not has_fair or (len(best) >= BEST and best[BEST - 1] > surest_of_others)

    def _best(self, food: str) -> list[float]:
        """Return how sure each known food, itself apart, is for ``food``, the surest first."""
        sure = zip(self.names, self.confidences[food], strict=True)
        return sorted((confidence for name, confidence in sure if name in self.known and name != food), reverse=True)

    def vocabulary(self) -> Vocabulary:
        """Return what was answered, sorted, with the states of all foods."""
        motions = (MadeBy(*motion) for motion in sorted(self.row.motions))
        return Vocabulary(
            tuple(sorted(seen_as(self.row.foods))),
            tuple(motions),
            tuple(sorted(self.row.dish_types)),
            tuple(sorted(self.row.states)),
            tuple(Gathering(*verb) for verb in sorted(self.row.verbs)),
        )

    def pairs(self) -> Iterator[tuple[int, str, float]]:
        """Yield (place of the food, name, confidence) for each name that is like the food: ``UNLIKE`` or surer."""
        for number, row in enumerate(self.confidences.values()):
            for name, confidence in zip(self.names, row, strict=True):
                if confidence >= UNLIKE:
                    yield number, name, confidence
