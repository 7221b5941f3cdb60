"""The FOON as the judge looks things up in it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg import motions
from foon_kg.form.derivation import Derivation
from foon_kg.kitchen import Kitchen, singular
from foon_kg.levels import Level, node_at, units_at
from foon_kg.model import FunctionalUnit, Goal, KnownUnit, ObjectNode
from foon_kg.recent import Recent

MOST_DERIVATIONS = 16384
"""How many derivations of a unit are kept for the next tree."""


@dataclass(frozen=True)
class KnownFoon:
    """The units of a universal FOON and its goals.

    ``goals`` may be left out: the dish classes that the units themselves carry are used then.
    """

    units: tuple[KnownUnit, ...]
    goals: tuple[Goal, ...] = ()

    @classmethod
    def of(cls, units: Iterable[KnownUnit], goals: Iterable[Goal] = ()) -> KnownFoon:
        """Keep ``units`` sorted by key, so that no answer depends on their order."""
        return cls(tuple(sorted(units, key=lambda known: known.unit.key)), tuple(goals) or ())

    def at(self, level: Level) -> KnownFoon:
        """Answer this FOON as it is at ``level``."""
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
    def derivations(self) -> Recent[Hashable, Derivation]:
        """How units of the trees that were judged of late come from units of this FOON: many trees share them."""
        return Recent(MOST_DERIVATIONS)

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
    def by_motion(self) -> Mapping[str, tuple[FunctionalUnit, ...]]:
        """The units of each motion."""
        found: defaultdict[str, list[FunctionalUnit]] = defaultdict(list)
        for known in self.units:
            found[known.unit.motion].append(known.unit)
        return {motion: tuple(units) for motion, units in found.items()}

    @cached_property
    def _made(self) -> frozenset[ObjectNode]:
        return frozenset(
            node for known in self.units for node in known.unit.output_nodes if node not in known.unit.input_nodes
        )

    def makes(self, node: ObjectNode) -> bool:
        """Whether some unit outputs ``node`` without having taken it."""
        return node in self._made

    @cached_property
    def _processed_alone(self) -> frozenset[tuple[str, str]]:
        utensils = Kitchen.default()
        found = set()
        for known in self.units:
            foods = [node for node in known.unit.input_nodes if utensils.is_food(node)]
            if len({food.label for food in foods}) != 1:
                continue
            before = {state for food in foods for state in food.states}
            for node in known.unit.output_nodes:
                if node.label == foods[0].label:
                    found |= {(singular(node.label), state) for state in set(node.states) - before}
        return frozenset(found)

    def processes(self, label: str, state: str) -> bool:
        """Whether some unit brings the food ``label`` into ``state`` with no other food taking part."""
        return (singular(label), state) in self._processed_alone

    @cached_property
    def opened(self) -> frozenset[str]:
        """The labels of what some unit cracks, peels, opens or cuts, utensils (a can, a box) among them."""
        units = [known.unit for known in self.units if motions.opens(known.unit.motion)]
        return frozenset(node.label for unit in units for node in unit.input_nodes if node not in unit.output_nodes)

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
    def food_names(self) -> frozenset[str]:
        """The names, in the singular, of the foods that a kitchen may have; no mixtures and no end products."""
        kitchen = Kitchen.default()
        nodes = {node for known in self.units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
        bought = {
            singular(node.label)
            for node in nodes
            if kitchen.is_food(node) and node.states and not node.ingredients and not kitchen.processed_states(node)
        }
        return frozenset(bought) - {singular(x) for labels in self.end_products.values() for x in labels}

    def videos_of(self, goal: ObjectNode) -> tuple[str, ...]:
        """Answer the videos that end in ``goal``, sorted; where none is marked, those that make it."""
        if goal in self._videos_by_goal:
            return tuple(sorted(self._videos_by_goal[goal]))
        made = {s.video for known in self.units if goal in known.unit.output_nodes for s in known.seen_in}
        return tuple(sorted(made))

    @cached_property
    def _videos_by_goal(self) -> Mapping[ObjectNode, set[str]]:
        found: defaultdict[ObjectNode, set[str]] = defaultdict(set)
        for known in self.goals:
            if known.videos:
                found[known.node].update(known.videos)
        return dict(found)

    @cached_property
    def video_units(self) -> Mapping[str, frozenset[int]]:
        """The places of the units of each video."""
        found: defaultdict[str, set[int]] = defaultdict(set)
        for known in self.units:
            for sighting in known.seen_in:
                found[sighting.video].add(sighting.position)
        return {video: frozenset(places) for video, places in found.items()}
