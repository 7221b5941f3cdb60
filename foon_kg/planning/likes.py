"""How well the foods of a FOON stand for those of one recipe: the similarity, and what a person chose."""

from __future__ import annotations

import difflib
from array import array
from collections.abc import Iterable, Mapping, Sequence, Set

import numpy as np

from foon_kg.food import singular
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.operators import LIKE_AT_ALL
from foon_kg.model.errors import UsageError
from foon_kg.model.knowledge import FAIR
from foon_kg.model.names import canonical
from foon_kg.model.recent import Recent
from foon_kg.planning.settings import Substitute
from foon_kg.similarity import Similarity
from foon_kg.similarity.food import FoodSimilarity

MOST_LIKES = 6
"""How many foods are asked for evidence in the place of one that has none."""

MOST_KEPT = 8192
"""For how many foods rows of confidences are kept."""

_READ = 0.97
"""How sure it is that a word of a recipe means the food as which the table of foods reads it."""


class FoodLikes:
    """Which known foods can stand for a food. Rows of confidences are kept for many recipes."""

    def __init__(self, similarity: Similarity, foods: Iterable[str], substitutes: Sequence[Substitute] = ()) -> None:
        self.similarity = similarity
        self.foods = tuple(sorted(foods))
        self.place: Mapping[str, int] = {food: place for place, food in enumerate(self.foods)}
        self._rows: Recent[str, array[float]] = Recent(MOST_KEPT)
        self._slots: Recent[str, array[float]] = Recent(MOST_KEPT)
        self._likes: Recent[str, tuple[tuple[str, float], ...]] = Recent(MOST_KEPT)
        self.chosen: dict[str, str] = {}
        for substitute in substitutes:
            self._choose(substitute)

    def knows(self, food: str) -> bool:
        """Whether a food is one of those that can stand for others."""
        return food in self.place

    def learn(self, foods: Iterable[str]) -> None:
        """Work out at once how well every known food stands for each of ``foods``."""
        fresh = [food for food in dict.fromkeys(foods) if food not in self._rows]
        if fresh:
            for food, row in zip(fresh, self.similarity.matrix(fresh, self.foods), strict=True):
                self._rows[food] = array("d", row)

    def row(self, food: str) -> array[float]:
        """Return how sure a cook is (0 to 1) to accept each known food for another one, by their :attr:`place`."""
        row = self._rows.find(food)
        if row is None:
            self.learn([food])
            row = self._rows[food]
        return row

    def slots(self, food: str) -> array[float]:
        """Return the same for what the food does in the slot of a dish, by their :attr:`place`.

        As a protein shrimp comes in the place of chicken, and broth in that of water as a liquid.
        """
        row = self._slots.find(food)
        if row is None:
            row = self._slots[food] = self.in_slots([food], self.foods)[food]
        return row

    def in_slots(self, wanted: Sequence[str], foods: Sequence[str]) -> Mapping[str, array[float]]:
        """Return for each of ``wanted`` how sure a cook is (0 to 1) to accept each of ``foods`` in its slot of a dish.

        ``foods`` need not be known.
        """
        if not isinstance(self.similarity, FoodSimilarity):
            return {food: array("d", [0.0] * len(foods)) for food in wanted}
        rows = self.similarity.in_slots(wanted, foods)
        return {food: array("d", row) for food, row in zip(wanted, rows, strict=True)}

    def likes(self, food: str) -> tuple[tuple[str, float], ...]:
        """Return the known foods that can fairly stand for a food, best first; what a person chose before all."""
        found = self._likes.find(food)
        if found is None:
            row = self.row(food)
            fair = [(name, sure) for name, sure in zip(self.foods, row, strict=True) if sure >= FAIR and name != food]
            found = tuple(sorted(fair, key=lambda pair: (-pair[1], pair[0]))[:MOST_LIKES])
            like = self.chosen.get(canonical(food))
            if like is not None:
                found = ((like, row[self.place[like]]), *(pair for pair in found if pair[0] != like))
            self._likes[food] = found
        return found

    def others(self, food: str) -> list[tuple[str, float]]:
        """Return the known foods that are like a food at all, be they not fairly so, the likest first."""
        row = self.row(food)
        like = np.flatnonzero(np.frombuffer(row) >= LIKE_AT_ALL)  # of hundreds of foods few are
        found = [(self.foods[place], row[place]) for place in like if self.foods[place] != food]
        return sorted(found, key=lambda pair: (-pair[1], pair[0]))

    def of_recipe(self, wants: Sequence[Want]) -> RecipeLikes:
        """Return the likes for one recipe of ``wants``, in which a word with two meanings means what it does there."""
        return RecipeLikes(self, wants)

    def _choose(self, substitute: Substitute) -> None:
        food, like = canonical(substitute.food), singular(substitute.like)
        if self.chosen.setdefault(food, like) != like:
            raise UsageError(f"“{substitute.food}” has two substitutes", hint="Choose one of them.")
        known = next((name for name in self.foods if canonical(name) == canonical(like)), None)
        if known is None:
            near = difflib.get_close_matches(substitute.like, self.foods, n=3)
            near = near or [found.name for found in self.similarity.nearest(substitute.like, self.foods, limit=3)]
            hint = f"Did you mean {' or '.join(near)}?" if near else "It knows no food at all."
            raise UsageError(f"this FOON does not know “{substitute.like}”", hint=hint, code="unknown-substitute")
        self.chosen[food] = known


_InSlots = tuple["array[float] | None", "array[float]"]
"""How well all known foods stand for one anywhere (``None`` where more than that is told), and in its slot."""


class RecipeLikes:
    """The likes for the foods of one recipe. ``instead`` are those for which a person chose another one."""

    def __init__(self, likes: FoodLikes, wants: Sequence[Want]) -> None:
        self._likes = likes
        self._read: dict[str, tuple[str, ...]] = {}
        for want in wants:
            name, meant = singular(want.label), want.facts.taken_for
            if meant and meant != name and likes.knows(meant):
                self._read[name] = tuple(dict.fromkeys((*self._read.get(name, ()), meant)))
        likes.learn(singular(want.label) for want in wants)
        self._rows: dict[str, array[float]] = {}
        self._slots: dict[str, _InSlots] = {}
        self._met: dict[str, int] = {}
        self._met_in_slots: Mapping[str, array[float]] = {}
        names = [singular(want.label) for want in wants]
        self._wanted = tuple(dict.fromkeys(names))
        self.instead = frozenset(name for name in names if canonical(name) in likes.chosen)

    def __call__(self, food: str) -> Sequence[tuple[str, float]]:
        """Return the known foods that can stand for a food, best first, each with its confidence."""
        name = singular(food)
        found = self._likes.likes(name)
        read = self._read.get(name)
        if not read or canonical(food) in self._likes.chosen:
            return found
        return (*((meant, _READ) for meant in read), *(pair for pair in found if pair[0] not in read))

    def others(self, food: str, chosen: str) -> list[tuple[str, float]]:
        """Return the known foods, the likest first, that a person may choose for a food instead of the chosen one."""
        fair = dict(self(food))
        found = [*fair.items(), *(pair for pair in self._likes.others(singular(food)) if pair[0] not in fair)]
        return [pair for pair in found if pair[0] != chosen]

    def meet(self, foods: Set[str]) -> None:
        """Work out what :meth:`in_slot` returns of ``foods`` that dishes have and that are unlike all of the recipe's.

        Of a part of a FOON they are not among the known ones.
        """
        strange = sorted(food for food in foods if food not in self._likes.place)
        if strange:
            self._met = {food: place for place, food in enumerate(strange)}
            self._met_in_slots = self._likes.in_slots(self._wanted, strange)

    def in_slot(self, food: str, known: str) -> float:
        """Return how sure a cook is (0 to 1) to accept a known food for another one: in its slot, or anywhere."""
        place, name = self._likes.place.get(known), singular(food)
        if place is None:
            met = self._met.get(known)
            slot = 0.0 if met is None or name not in self._met_in_slots else self._met_in_slots[name][met]
            return max(self.alike(food, known), slot)
        sure = self._slots.get(name)
        if sure is None:
            row = None if name in self._read or self._likes.chosen else self._likes.row(name)
            sure = self._slots[name] = row, self._likes.slots(name)
        row, slots = sure
        return max(self.alike(food, known) if row is None else row[place], slots[place])

    def stands_for(self, food: str, other: str) -> float:
        """Return how sure a cook is (0 to 1) to accept a food that need not be known for another one."""
        return float(self._likes.similarity.matrix([singular(food)], [singular(other)])[0, 0])

    def is_fair(self, food: str, known: str) -> bool:
        """Return whether a known food is the asked one, or stands fairly for it."""
        return singular(known) == singular(food) or self.alike(food, singular(known)) >= FAIR

    def alike(self, food: str, known: str) -> float:
        """Return how sure a cook is (0 to 1) to accept a known food for another one."""
        name = singular(food)
        if self._read and known in self._read.get(name, ()):
            return _READ
        if self._likes.chosen and self._likes.chosen.get(canonical(food)) == known:
            return 1.0
        place = self._likes.place.get(known)
        if place is None:
            return 0.0
        row = self._rows.get(name)
        if row is None:
            row = self._rows[name] = self._likes.row(name)
        return row[place]
