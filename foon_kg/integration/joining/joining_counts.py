"""How often foods of each kind join at each type of stage, counted over all frames, by dish type.

The type of a stage (:class:`~foon_kg.integration.joining.spots.StageType`) is what those of different dishes share.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable

from foon_kg.food import Tables, tables
from foon_kg.integration.joining.spots import Spot, StageType, spots_of
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Frame

_FACTORS = 3
"""How many things make a type of stage (:class:`~foon_kg.integration.joining.spots.StageType`).

They are counted apart, as if they did not depend on each other: of all three at once a hundred videos show too few."""

_LEAST = 0.02
"""How likely it is at least that a food joins at such a stage: that no video shows it is no proof."""

_PRIOR = 3.0
"""How many sightings of such a food are half trusted; the other half is what broader foods do."""

_USUAL_TOGETHER = 2
"""Two kinds that meet so often are usual together, however often they meet besides."""


def _no_counts() -> tuple[Counter[object], ...]:
    return tuple(Counter() for _ in range(_FACTORS))


class JoiningCounts:
    """How often foods join at each type of stage and beside which others, counted over frames.

    ``counts`` has by kind (or ``trait:``, ``""`` for any food) and dish type (``""`` for any) a counter for each factor
    of a stage type; ``beside`` by kind which kinds join at the same stage; ``cooked`` by which motions such foods are
    cooked by themselves before. Answers are kept: a recipe asks the same of each place of sixteen frames.
    """

    def __init__(self, frames: Iterable[Frame], known: Tables | None = None) -> None:
        self.known = known or tables()
        self.counts: defaultdict[tuple[str, str], tuple[Counter[object], ...]] = defaultdict(_no_counts)
        self.beside: defaultdict[str, Counter[str]] = defaultdict(Counter)
        self.cooked: defaultdict[str, Counter[str]] = defaultdict(Counter)
        self._kept: dict[tuple[str, frozenset[str], StageType, str], float] = {}
        self._factors: dict[tuple[str, frozenset[str], int, object, str], float] = {}
        self._totals: dict[tuple[str, str, int], int] = {}
        self._together: dict[tuple[str, tuple[str, ...]], float] = {}
        for frame in frames:
            for spot in spots_of(frame.line):
                self._count(frame, spot)

    def _count(self, frame: Frame, spot: Spot) -> None:
        slots = list(spot.stage.slots)
        for slot in slots:
            for name in self.names(slot.kind):
                for dish in (frame.dish_type, ""):
                    for counter, value in zip(self.counts[name, dish], spot.stage_type, strict=True):
                        counter[value] += 1
                for motion in slot.cooked[:1]:
                    self.cooked[name][motion] += 1
            for other in slots:
                if other is not slot:
                    self.beside[slot.kind][other.kind] += 1

    def names(self, kind: str) -> tuple[str, ...]:
        """Return what a kind is counted under: itself, its traits, and any food."""
        row = self.known.foods.kinds.get(kind)
        return (kind, *sorted(f"trait:{trait}" for trait in (row.traits if row else ())), "")

    def likely(self, want: Want, stage_type: StageType, dish_type: str) -> float:
        """Return how likely (0 to 1) a food of the kind of ``want`` joins at such a stage, most of all in this type.

        The type is ``dish_type``, that of the recipe.
        """
        key = (want.facts.kind, want.facts.traits, stage_type, dish_type)
        found = self._kept.get(key)
        if found is None:
            found = 1.0
            for factor in range(_FACTORS):
                own = (want.facts.kind, want.facts.traits, factor, stage_type[factor], dish_type)
                if own not in self._factors:
                    self._factors[own] = self._factor(want, factor, stage_type[factor], dish_type)
                found *= self._factors[own]
            found = self._kept[key] = found ** (1 / _FACTORS)
        return found

    def _factor(self, want: Want, factor: int, value: object, dish_type: str) -> float:
        """Return how likely such a food joins where one ``factor`` of the stage type has a ``value``.

        The share is told by any food first, then by foods with its traits, then by its kind; of each in all dishes and
        then in those of the type. Each corrects what was told before as far as there is enough of it to be trusted.
        """
        share = _LEAST
        traits = sorted(f"trait:{trait}" for trait in want.facts.traits)
        for names in (("",), traits, (want.facts.kind,)):
            for dish in ("", dish_type):
                total = times = 0
                for name in names:
                    counts = self.counts.get((name, dish))
                    if counts is not None:
                        total += self._total(name, dish, factor)
                        times += counts[factor][value]
                trust = total / (total + _PRIOR)
                share = trust * (times / total if total else 0.0) + (1 - trust) * share
        return max(share, _LEAST)

    def _total(self, name: str, dish: str, factor: int) -> int:
        found = self._totals.get((name, dish, factor))
        if found is None:
            found = self._totals[name, dish, factor] = self.counts[name, dish][factor].total()
        return found

    def never(self, want: Want, work: str) -> bool:
        """Return whether no food of the kind of ``want`` was ever seen where such ``work`` is done."""
        counts = self.counts.get((want.facts.kind, ""))
        return counts is None or not counts[0][work]

    def company(self, kind: str, kinds: tuple[str, ...]) -> float:
        """Return how usual (0 to 1) it is that such a food joins together with foods of ``kinds``."""
        found = self._together.get((kind, kinds))
        if found is None:
            mine = self.beside.get(kind)
            found = (
                sum(min(1.0, mine[other] / _USUAL_TOGETHER) for other in kinds) / len(kinds) if mine and kinds else 0.0
            )
            self._together[kind, kinds] = found
        return found
