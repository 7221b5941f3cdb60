"""A script as it is read in one kitchen: what every recipe asks of it that is brought into it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from foon_kg.footage import same_things
from foon_kg.kitchen import Kitchen
from foon_kg.lines import FoodLine, food_lines, held_names
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.recent import Recent
from foon_kg.script import Repertoire, Script
from foon_kg.slots import Slots

MOST_READINGS = 2048
"""How many scripts are kept read in one kitchen."""

MOST_FOODS = 64
"""Of how many foods it is kept, for each script, how like they are to those that join in it."""


@dataclass(frozen=True, eq=False)
class Reading:
    """One script: its ``units`` in their order, each question answered once."""

    units: Sequence[KnownUnit]
    kitchen: Kitchen
    repertoire: Repertoire
    likeness: Recent[str, Mapping[int, float]] = field(default_factory=lambda: Recent(MOST_FOODS), repr=False)
    """How much those who join at each open place are like a food, of so many foods; whoever asks works it out."""

    @cached_property
    def _same(self) -> Mapping[ObjectNode, ObjectNode]:
        return same_things(self.units, self.kitchen)

    @cached_property
    def lines(self) -> Mapping[str, FoodLine]:
        """The lines of the foods that the script takes from the kitchen."""
        return food_lines(self.units, self.kitchen, self._same)

    @cached_property
    def names(self) -> frozenset[str]:
        """The foods that are there from the start, by themselves or in vessels, and cost something to have."""
        names = {*self.lines, *held_names(self.units, self.kitchen, self._same)}
        return frozenset(name for name in names if not self.kitchen.is_free(name))

    @cached_property
    def slots(self) -> Slots:
        """Where foods may join the script."""
        return Slots.of(self.units, self.lines, self.kitchen)

    @cached_property
    def play(self) -> Script:
        """The script, ready to be executed."""
        return Script.of(self.units, self.repertoire, self._same)


@dataclass(frozen=True, eq=False)
class Readings:
    """The scripts that were read in one kitchen so far."""

    kitchen: Kitchen
    _known: Recent[tuple[str, ...], Reading] = field(default_factory=lambda: Recent(MOST_READINGS), repr=False)

    @cached_property
    def _repertoire(self) -> Repertoire:
        return Repertoire(self.kitchen)

    def of(self, units: Sequence[KnownUnit]) -> Reading:
        """Answer the reading of ``units``, known or new."""
        key = tuple(known.unit.key for known in units)
        if key not in self._known:
            self._known[key] = Reading(units, self.kitchen, self._repertoire)
        return self._known[key]
