"""What a rule has before it when it judges a tree."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from operator import attrgetter

from foon_kg.form.derivation import Derivation, derive, may_explain
from foon_kg.form.foon import KnownFoon
from foon_kg.form.tree import TaskTree, TreeUnit
from foon_kg.kitchen import Kitchen, singular
from foon_kg.model import FunctionalUnit, ObjectNode, Recipe, RequiredIngredient


@dataclass(frozen=True)
class Joining:
    """Where one food comes together with others: the place of the unit, and the nodes of the food there."""

    food: str
    place: int
    nodes: tuple[ObjectNode, ...]


@dataclass(frozen=True)
class Case:
    """A tree with the FOON it should come from (``None`` where there is none at hand) and the kitchen."""

    tree: TaskTree
    foon: KnownFoon | None
    kitchen: Kitchen

    @property
    def recipe(self) -> Recipe | None:
        """The recipe asked, where it is known."""
        return self.tree.recipe

    @property
    def required(self) -> tuple[RequiredIngredient, ...]:
        """What the recipe asks for; nothing where there is none."""
        return self.recipe.ingredients if self.recipe else ()

    @cached_property
    def required_names(self) -> frozenset[str]:
        """The required foods, in the singular."""
        return frozenset(singular(wanted.object) for wanted in self.required)

    @cached_property
    def goal(self) -> ObjectNode | None:
        """The goal that the tree names; for unmarked FOON text the richest food that its last unit outputs."""
        if self.tree.goal is not None or not self.tree.units:
            return self.tree.goal
        foods = [node for node in self.tree.units[-1].output_nodes if self.kitchen.is_food(node)]
        return max(foods, key=lambda node: (len(node.ingredients), node.sort_key), default=None)

    @cached_property
    def intermediates(self) -> frozenset[str]:
        """The foods, in the singular, that some unit makes of other foods."""
        made: set[str] = set()
        for unit in self.tree.units:
            foods = {singular(node.label) for node in unit.new_outputs if self.kitchen.is_food(node)}
            made |= foods - self.names_of(unit.input_nodes)
        return frozenset(made)

    @cached_property
    def derivations(self) -> tuple[Derivation | None, ...]:
        """How each unit comes from the FOON, by the best of the units it names; ``None`` where none is known."""
        rank = attrgetter("cost", "source.key")
        return tuple(min(found, key=rank, default=None) for found in self.comparisons)

    @cached_property
    def comparisons(self) -> tuple[tuple[Derivation, ...], ...]:
        """Each unit derived from each of its sources."""
        return tuple(tuple(self._derived(unit, source) for source in self.sources(unit)) for unit in self.tree.units)

    def _derived(self, unit: TreeUnit, source: FunctionalUnit) -> Derivation:
        """Derive a unit as it was derived in an earlier tree, where all is the same that may come up in it."""
        known = self.foon.derivations if self.foon is not None else {}
        declared = tuple(entry for entry in self.tree.substitutions or () if may_explain(entry, unit, source))
        key = (unit.input_nodes, unit.motion, unit.output_nodes, source.key, declared, self.kitchen)
        if key not in known:
            known[key] = derive(unit, source, declared, self.kitchen)
        return known[key]

    def sources(self, unit: TreeUnit) -> tuple[FunctionalUnit, ...]:
        """Answer the units of the FOON that ``unit`` names; for a tree that cannot name any, those of its motion."""
        if self.foon is None:
            return ()
        if unit.seen_in is None and unit.identity in self.foon.by_key:
            return (self.foon.by_key[unit.identity],)
        if unit.seen_in is None:
            return tuple(s for s in self.foon.by_motion.get(unit.motion, ()) if _overlaps(unit, s))
        places = ((sighting.video, sighting.position) for sighting in unit.seen_in)
        named = (self.foon.by_sighting.get(place) for place in places)
        return tuple({source.key: source for source in named if source is not None}.values())

    def is_required_or_free(self, name: str) -> bool:
        """Whether a food may come from the kitchen."""
        return singular(name) in self.required_names or self.kitchen.is_free(name)

    def names_of(self, nodes: Iterable[ObjectNode]) -> frozenset[str]:
        """Answer the foods that ``nodes`` are or hold, in the singular."""
        return frozenset().union(*map(self.names_in, nodes))

    def names_in(self, node: ObjectNode) -> frozenset[str]:
        """Answer the foods that ``node`` is or holds, in the singular."""
        if node not in self._names:
            names = self.kitchen.foods_in(node)
            self._names[node] = frozenset(map(singular, (node.label, *names) if self.kitchen.is_food(node) else names))
        return self._names[node]

    @cached_property
    def _names(self) -> dict[ObjectNode, frozenset[str]]:
        return {}  # asked of every node again and again

    @cached_property
    def joinings(self) -> tuple[Joining, ...]:
        """Where each required food joins others, as often as it comes to them anew; free foods never do.

        It comes alone, or in a vessel with nothing else that counts, and is with others in what the unit newly makes.
        """
        found = []
        asked = self._counting(self.required_names)
        for place, unit in enumerate(self.tree.units):
            coming = [self._counting(self.names_in(node)) for node in unit.input_nodes]
            made = [self._counting(self.names_in(node)) for node in unit.new_outputs]
            alone = frozenset().union(*(names for names in coming if len(names) == 1))
            for food in sorted(asked & alone):
                if any(food in names and len(names) > 1 for names in made):
                    nodes = tuple(node for node in unit.input_nodes if singular(node.label) == food)
                    found.append(Joining(food, place, nodes))
        return tuple(found)

    def _counting(self, names: frozenset[str]) -> frozenset[str]:
        return frozenset(name for name in names if not self.kitchen.is_free(name))


def _overlaps(unit: TreeUnit, source: FunctionalUnit) -> bool:
    return not {node.label for node in unit.output_nodes}.isdisjoint(node.label for node in source.output_nodes)
