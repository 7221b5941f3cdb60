"""What one functional unit teaches about words, and the tables that many units add up to.

The tables of :class:`~foon_kg.model.knowledge.Vocabulary` are sums over units, so that the graph can keep them right by
adding what a new unit teaches and taking away what a forgotten one taught.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Set
from dataclasses import dataclass, field
from typing import NamedTuple

from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.model.knowledge import Gathering, MadeBy, SeenAs

NO_STATE = ""
"""Stands for the state of a node that has none, so that its food stays known."""

FoodState = tuple[str, str]


def food_states(nodes: Iterable[ObjectNode], is_utensil: Callable[[str], bool]) -> set[FoodState]:
    """Return every (label, state) of the foods among ``nodes``; a node without states counts as ``NO_STATE``.

    ``is_utensil`` tells by a label what is no food.
    """
    foods = (node for node in nodes if not is_utensil(node.label))
    return {(node.label, state) for node in foods for state in (node.states or (NO_STATE,))}


def states_made(unit: FunctionalUnit, is_utensil: Callable[[str], bool]) -> frozenset[str]:
    """Return the states that ``unit`` gives to a food: in an output of the food, in none of its inputs.

    ``is_utensil`` tells by a label what is no food.
    """
    return _given(food_states(unit.output_nodes, is_utensil), food_states(unit.input_nodes, is_utensil))


class UnitWords(NamedTuple):
    """What one unit adds to the counts: foods in states that it makes and uses, and the states that it gives a food.

    ``several`` says whether it takes more than one food, be they in a vessel.
    """

    motion: str
    made: frozenset[FoodState]
    used: frozenset[FoodState]
    states: frozenset[str]
    several: bool


def words_of(unit: FunctionalUnit, is_utensil: Callable[[str], bool]) -> UnitWords:
    """Return what ``unit`` teaches about words; ``is_utensil`` tells by a label what is no food."""
    made, used = food_states(unit.output_nodes, is_utensil), food_states(unit.input_nodes, is_utensil)
    names = {name for node in unit.input_nodes for name in (node.label, *node.ingredients) if not is_utensil(name)}
    return UnitWords(unit.motion, frozenset(made), frozenset(used), _given(made, used), len(names) > 1)


def _given(made: Set[FoodState], used: Set[FoodState]) -> frozenset[str]:
    """Return the states of foods that are ``made`` and were not there in what is ``used``."""
    return frozenset(state for _, state in made - used if state != NO_STATE)


@dataclass
class WordCounts:
    """The counts of the vocabulary, growing or shrinking by one distinct unit at a time."""

    is_utensil: Callable[[str], bool]
    made: Counter[FoodState] = field(default_factory=Counter)
    used: Counter[FoodState] = field(default_factory=Counter)
    motions: Counter[tuple[str, str]] = field(default_factory=Counter)
    units: Counter[str] = field(default_factory=Counter)
    several: Counter[str] = field(default_factory=Counter)

    def count(self, units: Iterable[FunctionalUnit], weight: int = 1) -> None:
        """Add what each of ``units`` teaches ``weight`` times; -1 takes it away."""
        self.add((words_of(unit, self.is_utensil) for unit in units), weight)

    def add(self, units: Iterable[UnitWords], weight: int = 1) -> None:
        """Add what ``units`` teach, each ``weight`` times."""
        for unit in units:
            for pair in unit.made:
                self.made[pair] += weight
            for pair in unit.used:
                self.used[pair] += weight
            for state in unit.states:
                self.motions[state, unit.motion] += weight
            self.units[unit.motion] += weight
            self.several[unit.motion] += weight * unit.several

    def seen_as(self) -> Iterator[SeenAs]:
        """Yield the rows about foods that differ from nothing, sorted."""
        for pair in sorted(self.made.keys() | self.used.keys()):
            if self.made[pair] or self.used[pair]:
                yield SeenAs(*pair, made=self.made[pair], used=self.used[pair])

    def made_by(self) -> Iterator[MadeBy]:
        """Yield the rows about motions that differ from nothing, sorted."""
        for state, motion in sorted(self.motions):
            if self.motions[state, motion]:
                yield MadeBy(state, motion, self.motions[state, motion])

    def gatherings(self) -> Iterator[Gathering]:
        """Yield the rows about motions and how many foods they take that differ from nothing, sorted."""
        for motion in sorted(self.units):
            if self.units[motion] or self.several[motion]:
                yield Gathering(motion, self.units[motion], self.several[motion])
