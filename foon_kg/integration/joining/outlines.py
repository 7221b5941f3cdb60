"""What of each frame tells whether it is worth a closer look, so that of many frames few have to be read whole."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from foon_kg.food import Tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.joining.layouts import Layout
from foon_kg.model.values import made_often

_DIGITS = 6
"""Scores that are equal to so many digits are ties, and go by their keys: sums of floats differ in the last ones."""

_SLACK = 1e-5
"""More than scores differ by that are equal once they are rounded: all of them are sorted, whatever is cut off."""

Mask = npt.NDArray[np.bool_]
Shares = npt.NDArray[np.float64]
Numbers = npt.NDArray[np.intp]


@made_often()
class Outline:
    """The foods and kinds of a frame's slots, and how its dish is heated last (``ends``, :func:`closing_heat`)."""

    key: str
    dish_type: str
    label: str
    foods: frozenset[str]
    kinds: frozenset[str]
    ends: tuple[str, str]

    @classmethod
    def of(cls, layout: Layout, known: Tables) -> Outline:
        """Return the outline of the frame that ``layout`` is of, read by the tables ``known``."""
        frame = layout.frame
        slots = list(frame.line.all_slots())
        return cls(
            frame.key,
            frame.dish_type,
            frame.goal.label,
            frozenset(slot.food for slot in slots),
            frozenset(slot.kind for slot in slots) - {"unknown"},
            closing_heat(layout, known),
        )


def closing_heat(layout: Layout, known: Tables) -> tuple[str, str]:
    """Return how the dish of ``layout`` is heated last: what is done, and on what (``("", "")`` for a cold one).

    ``known`` are the tables.
    """
    heats = [spot for spot in layout.spots if "heat" in spot.stage.does and not spot.side]
    if not heats:
        return ("", "")
    last = heats[-1]
    dry = "dry" in last.stage.does or last.stage.appliance in {"oven", "microwave"}
    row = known.utensil(last.stage.vessel)
    return ("bake", "") if dry else ("heat", row.group if row is not None else "")


@made_often()
class Sought:
    """A food that is sought in outlines: how much it counts, by which names it is known, and its kind."""

    weight: float
    names: Collection[str]
    kind: str


class Outlines:
    """Outlines with an index of what is in them: a question looks only at those that have something to do with it."""

    def __init__(self, outlines: Iterable[Outline]) -> None:
        self.all = tuple(outlines)
        self.dish_types = frozenset(outline.dish_type for outline in self.all)
        self._foods = _index((number, outline.foods) for number, outline in enumerate(self.all))
        self._kinds = _index((number, outline.kinds) for number, outline in enumerate(self.all))
        self._types = _index((number, [outline.dish_type]) for number, outline in enumerate(self.all))
        self._ends = _index((number, [outline.ends]) for number, outline in enumerate(self.all))
        self._words = _index((number, words(outline.label)) for number, outline in enumerate(self.all))
        self._heads = _index((number, words(outline.label)[-1:]) for number, outline in enumerate(self.all))

    def are_of(self, dish_type: str) -> bool:
        """Return whether some dish is of a type, or called so; of any type for ``""``."""
        called = any(word in self._words for word in words(dish_type))
        return bool(self.all) if not dish_type else dish_type in self.dish_types or called

    def taught(self, dish_type: str, known: Tables) -> list[tuple[str, frozenset[str]]]:
        """Return what the dishes of a type are called and made of, but those of a hot type that end as raw flour.

        ``known`` are the tables that say what is hot.
        """
        hot = any(dish.heated for dish in known.dishes_named(dish_type))
        flour = word_list("is raw flour") if hot else frozenset[str]()
        own = (one for one in self.all if one.dish_type == dish_type)
        return [(one.label, one.foods) for one in own if one.ends[0] or one.kinds.isdisjoint(flour)]

    def best(
        self,
        foods: Sequence[Sought],
        dish_type: str,
        score: Callable[[Shares, Mask, Mask, Mask], Shares],
        *,
        title: str = "",
        ends: Collection[tuple[str, str]] | None = None,
        allowed: Callable[[str], bool] | None = None,
        most: int,
    ) -> list[str]:
        """Return the keys of the ``most`` outlines of the greatest score, the best first, ties by key.

        ``score`` is given, for all outlines at once, which share of the weight of ``foods`` they have, which are of
        ``dish_type``, which have a word of it in their name, and of which the name ends in a word of ``title``. Of
        other dish types only those count that are heated last in one of the ways of ``ends``, or (``None``) as some
        dish of ``dish_type`` is, if there is any. ``allowed`` says which names may be taken at all.
        """
        own = self._mask(self._types, [dish_type])
        taken = np.ones(len(self.all), bool)
        if allowed is not None:
            taken = np.fromiter((allowed(outline.label) for outline in self.all), bool, len(self.all))
        if ends is None:
            ends = {self.all[number].ends for number in np.flatnonzero(own & taken)}
        if ends:
            taken &= own | self._mask(self._ends, ends)
        named, headed = self._mask(self._words, words(dish_type)), self._mask(self._heads, words(title))
        return self._first(score(self._shares(foods), own, named, headed), taken, most)

    def _shares(self, foods: Sequence[Sought]) -> Shares:
        """Return of each outline which share of the weight of ``foods`` it has, by their names or kinds."""
        there = np.zeros(len(self.all))
        for food in foods:
            found = [self._foods[name] for name in food.names if name in self._foods]
            there[self._mask(self._kinds, [food.kind], found)] += food.weight
        return there / (sum(food.weight for food in foods) or 1.0)

    def _first(self, scores: Shares, taken: Mask, most: int) -> list[str]:
        numbers = np.flatnonzero(taken)
        if len(numbers) > most:
            least = np.partition(scores[numbers], -most)[-most]
            numbers = numbers[scores[numbers] >= least - _SLACK]
        rows = sorted((-round(float(scores[number]), _DIGITS), self.all[number].key) for number in numbers)
        return [key for _, key in rows[:most]]

    def _mask(self, index: Mapping[object, Numbers], names: Iterable[object], more: Iterable[Numbers] = ()) -> Mask:
        mask = np.zeros(len(self.all), bool)
        for numbers in (*(index[name] for name in names if name in index), *more):
            mask[numbers] = True
        return mask


def _index(rows: Iterable[tuple[int, Iterable[object]]]) -> Mapping[object, Numbers]:
    found: defaultdict[object, list[int]] = defaultdict(list)
    for number, names in rows:
        for name in names:
            found[name].append(number)
    return {name: np.array(numbers, np.intp) for name, numbers in found.items()}
