"""Which foods and kinds the operators for a question are asked by: what is done to them, or to what is like them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from foon_kg.food import tables
from foon_kg.integration.teaching.operators import LIKE_AT_ALL
from foon_kg.similarity.points import Question, question
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.equivalents import FIRST, MORE
from foon_kg.store.graph.lifting import KIND
from foon_kg.store.graph.method_rows import MatterValue, MethodsAskedRow, NearValue

_SLACK = 1e-4
"""Points are stored as single floats."""

_HALVINGS = 30

MOST = FIRST * MORE
"""So many points are asked for at most."""

Ask = Callable[[Mapping[str, Any]], list[MethodsAskedRow]]


@dataclass
class KnownMatters:
    """What one edition answered: of each food the foods like it at all, and of each matter what is done to it."""

    near: dict[str, tuple[str, ...]] = field(default_factory=dict)
    rows: dict[str, MatterValue] = field(default_factory=dict)
    kinds: set[str] = field(default_factory=set)

    def for_foods(self, foods: Collection[str], ask: Ask) -> list[MatterValue] | None:
        """Return the rows of all that matters to ``foods``, which it may ``ask``.

        ``None`` if points cannot tell that.
        """
        kinds = {f"{KIND}{tables().foods.find(food)[0]}" for food in foods}
        waiting = {food: question(food) for food in sorted(foods) if food not in self.near}
        count = FIRST
        while waiting or kinds - self.kinds:
            if count > MOST or not self._look(waiting, kinds, count, ask):
                return None
            count *= MORE
        return [self.rows[name] for name in self._matters(foods, kinds) if name in self.rows]

    def _look(self, waiting: dict[str, Question], kinds: set[str], count: int, ask: Ask) -> bool:
        """Keep what ``count`` points a food tell of foods that are ``waiting`` and of kinds; whether they can tell."""
        asked = [_asked(food, about) for food, about in waiting.items()]
        if any(row["least"] <= 0 for row in asked):
            return False
        missing, known = sorted(kinds - self.kinds), sorted(self.rows)
        rows = ask({"words": word_lists_key(), "asked": asked, "kinds": missing, "known": known, "count": count})
        if not rows:
            return False
        self.rows.update((row[0], row) for row in rows[0].matters)
        self.kinds |= kinds
        self._settle(rows[0].near, waiting, count)
        return True

    def _settle(self, near: Iterable[NearValue], waiting: dict[str, Question], count: int) -> None:
        """Keep the foods near to those that are ``waiting``, unless of ``count`` points more may be as near."""
        for food, size, furthest, names in near:
            if size < count or (furthest or 0.0) < _least(waiting[food]):
                self.near[food] = tuple(dict.fromkeys(names))
                del waiting[food]

    def _matters(self, foods: Iterable[str], kinds: Iterable[str]) -> list[str]:
        return sorted({*kinds, *(name for food in foods for name in self.near[food])})


def _asked(food: str, about: Question) -> dict[str, Any]:
    return {"name": food, "canonical": about.canonical_name, "point": about.point, "least": _least(about)}


def _least(about: Question) -> float:
    """Return a cosine: no food whose point is at less is like the one that is asked ``about`` at all."""
    low, high = -1.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        if about.most(middle) >= LIKE_AT_ALL:
            high = middle
        else:
            low = middle
    return low - _SLACK
