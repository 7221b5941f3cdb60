"""The FOON as the judge looks things up in it: where units were seen, and which dishes end how."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.food import Tables, singular, tables
from foon_kg.model import FunctionalUnit, Goal, KnownUnit
from foon_kg.model.levels import Level, node_at, units_at


@dataclass(frozen=True)
class KnownFoon:
    """The units of a universal FOON and its goals.

    ``goals`` may be left out: the dish classes that the units themselves carry are used then.
    """

    units: tuple[KnownUnit, ...]
    goals: tuple[Goal, ...] = ()

    @classmethod
    def of(cls, units: Iterable[KnownUnit], goals: Iterable[Goal] = ()) -> KnownFoon:
        """Return a FOON of ``units`` and ``goals``. The units are sorted by key: no finding depends on their order."""
        return cls(tuple(sorted(units, key=lambda known: known.unit.key)), tuple(goals) or ())

    def at(self, level: Level) -> KnownFoon:
        """Return this FOON as it is at ``level``."""
        if level is Level.INGREDIENTS:
            return self
        if level not in self._lower:
            goals = (replace(goal, node=node_at(goal.node, level)) for goal in self.goals)
            self._lower[level] = KnownFoon.of(units_at(self.units, level), goals)
        return self._lower[level]

    @cached_property
    def _lower(self) -> dict[Level, KnownFoon]:
        return {}  # many trees of one level are judged one after another

    @cached_property
    def facts(self) -> dict[tuple[frozenset[str], int], object]:
        """What a rule worked out of each unit, by the names that are foods here, and by the identity of the unit.

        Every tree that is judged asks for them. An identity is not used again, for the units stay as long as this.
        """
        return {}

    @cached_property
    def by_sighting(self) -> Mapping[tuple[str, int], FunctionalUnit]:
        """The unit at each (video, place)."""
        return {(s.video, s.position): known.unit for known in self.units for s in known.seen_in}

    @cached_property
    def by_key(self) -> Mapping[tuple[object, ...], FunctionalUnit]:
        """The unit with each set of inputs, motion and set of outputs."""
        return {
            (frozenset(u.input_nodes), u.motion, frozenset(u.output_nodes)): u for u in (k.unit for k in self.units)
        }

    @cached_property
    def labels_of_motion(self) -> Mapping[str, frozenset[str]]:
        """The labels, in the singular, that the units of each motion take or make."""
        found: defaultdict[str, set[str]] = defaultdict(set)
        for known in self.units:
            found[known.unit.motion] |= {singular(n.label) for n in (*known.unit.input_nodes, *known.unit.output_nodes)}
        return {motion: frozenset(labels) for motion, labels in found.items()}

    @cached_property
    def end_products(self) -> Mapping[str, frozenset[str]]:
        """The labels of the end products of each dish type."""
        found: defaultdict[str, set[str]] = defaultdict(set)
        for goal in self.goals:
            found[goal.dish_type].add(goal.node.label)
        if not self.goals:
            for known in self.units:
                for participant in known.unit.outputs:
                    if participant.dish_type:
                        found[participant.dish_type].add(participant.node.label)
        return {dish_type: frozenset(labels) for dish_type, labels in found.items()}

    @cached_property
    def operators(self) -> frozenset[tuple[str, str]]:
        """The states that some unit gives to a kind of food, and to each food: (kind or name, state)."""
        known = tables()
        return frozenset(pair for unit in self.units for pair in _given(unit.unit, known))


def _given(unit: FunctionalUnit, known: Tables) -> set[tuple[str, str]]:
    before: defaultdict[str, set[str]] = defaultdict(set)
    for node in unit.input_nodes:
        before[singular(node.label)].update(node.states)
    found = set()
    for node in unit.output_nodes:
        label = singular(node.label)
        if label in before and known.utensil(label) is None:
            for state in set(node.states) - before[label]:
                found |= {(label, state), (known.foods.food(label).kind, state)}
    return found
