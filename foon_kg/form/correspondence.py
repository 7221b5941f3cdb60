"""Which node of a tree's unit is which node of the FOON's unit, and which substitutions that takes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg import motions
from foon_kg.food.lists import word_list
from foon_kg.form.tree import Substituted, TreeUnit
from foon_kg.kitchen import Kitchen, singular
from foon_kg.model import FunctionalUnit, NodeSortKey, ObjectNode

EMPTY = "empty"
APPLIED = word_list("given by contents")
"""States that a food gives to what it is put on; they go with it."""

Pair = tuple[ObjectNode, ObjectNode]
"""A node of the tree, and the node of the FOON that it was."""


def undeclared(kind: str, label: str, required: str, equivalent: str) -> Substituted:
    """Answer the entry that is missing."""
    return Substituted(kind, label, required, equivalent, None, None)


@dataclass(frozen=True)
class Correspondence:
    """A unit of a tree beside a unit of the FOON. Paired are nodes that are the same thing; the rest came or went.

    Where any number may enter, a food that stands elsewhere than in FOON, or is in a state that no entry explains, is
    not paired: one food went and another came.
    """

    unit: TreeUnit
    source: FunctionalUnit
    declared: tuple[Substituted, ...]
    kitchen: Kitchen

    @cached_property
    def any_number(self) -> bool:
        """Whether FOON's unit lets any number of foods enter."""
        return motions.accepts_any(self.source.motion, star=self.source.accepts_any)

    @cached_property
    def inputs(self) -> tuple[Pair, ...]:
        """The inputs that are the same thing."""
        pairs = self._pairs(self.unit.input_nodes, self.source.input_nodes)
        return tuple(pair for pair in pairs if not (self.any_number and self._is_exchanged(pair)))

    @cached_property
    def outputs(self) -> tuple[Pair, ...]:
        """The outputs that are the same thing."""
        pairs = self._pairs(self.unit.output_nodes, self.source.output_nodes)
        added = {node.label for node in self.new_inputs}
        return tuple(pair for pair in pairs if not (pair[0].label in added and self._is_exchanged(pair)))

    def _is_exchanged(self, pair: Pair) -> bool:
        mine, theirs = pair
        if not self.is_food(mine) and not mine.ingredients:
            return False
        return not self.same_place(mine, theirs) or (self.is_food(mine) and bool(self.entries(pair)[1]))

    @cached_property
    def new_inputs(self) -> tuple[ObjectNode, ...]:
        """The inputs that FOON's unit does not have."""
        return _rest(self.unit.input_nodes, (mine for mine, _ in self.inputs))

    @cached_property
    def gone_inputs(self) -> tuple[ObjectNode, ...]:
        """The inputs of FOON's unit that the tree does not have."""
        return _rest(self.source.input_nodes, (theirs for _, theirs in self.inputs))

    @cached_property
    def new_outputs(self) -> tuple[ObjectNode, ...]:
        """The outputs that FOON's unit does not have."""
        return _rest(self.unit.output_nodes, (mine for mine, _ in self.outputs))

    @cached_property
    def gone_outputs(self) -> tuple[ObjectNode, ...]:
        """The outputs of FOON's unit that the tree does not have."""
        return _rest(self.source.output_nodes, (theirs for _, theirs in self.outputs))

    def _pairs(self, mine: Sequence[ObjectNode], theirs: Sequence[ObjectNode]) -> tuple[Pair, ...]:
        """Pair the nodes that are the same thing, the likest first."""
        alike = [(m, t) for m in mine for t in theirs if m.label in self.names_now(t.label)]
        pairs: list[Pair] = []
        for m, t in sorted(alike, key=self._distance):
            if all(m != other and t != another for other, another in pairs):
                pairs.append((m, t))
        return tuple(pairs)

    def _distance(self, pair: Pair) -> tuple[bool, int, bool, int, NodeSortKey, NodeSortKey]:
        """Answer how unlike two nodes are; their own order decides between equals, so that no other order does."""
        mine, theirs = pair
        return (
            not self.same_place(mine, theirs),
            len(set(mine.states) ^ set(theirs.states)),
            mine.label != theirs.label,
            len(set(mine.ingredients) ^ set(theirs.ingredients)),
            mine.sort_key,
            theirs.sort_key,
        )

    def names_now(self, name: str) -> set[str]:
        """Answer what a name of FOON may be called in the tree."""
        return {name, *(e.required for e in self.declared if e.kind == "object" and e.equivalent == name)}

    def same_place(self, mine: ObjectNode, theirs: ObjectNode) -> bool:
        """Say whether the places are the same; what only a food that is gone gave (coated with oil) may be missing."""
        cover = theirs.container
        if mine.container is None and cover and not self.kitchen.is_utensil(cover) and not self.is_brought(cover):
            return True
        if mine.relation != theirs.relation:
            return False
        if theirs.container is None:
            return mine.container is None
        return mine.container in self.names_now(theirs.container)

    def is_food(self, node: ObjectNode) -> bool:
        """Say whether a node is a food."""
        return self.kitchen.is_food(node)

    def motion_entries(self) -> tuple[set[Substituted], list[Substituted]]:
        """Answer the entries that the motion uses, and those it would need."""
        mine, theirs = self.unit.motion, self.source.motion
        if mine == theirs:
            return set(), []
        labels = {node.label for node in (*self.unit.input_nodes, *self.unit.output_nodes)}
        fitting = {
            e
            for e in self.declared
            if e.kind == "motion"
            and (e.required, e.equivalent) == (mine, theirs)
            and (not e.object or e.object in labels)
        }
        foods = sorted(label for label in labels if not self.kitchen.is_utensil(label))
        return fitting, [] if fitting else [undeclared("motion", foods[0] if foods else "", mine, theirs)]

    def entries(self, pair: Pair) -> tuple[set[Substituted], list[Substituted]]:
        """Answer the entries that a pair uses, and those it would need."""
        mine, theirs = pair
        used = set()
        if mine.label != theirs.label:
            used |= self._renaming(mine.label, theirs.label)
        for name in set(theirs.ingredients) - set(mine.ingredients):
            for now in (self.names_now(name) - {name}) & set(mine.ingredients):
                used |= self._renaming(now, name)
        extra, lost = self._state_changes(mine, theirs)
        fitting = [e for e in self._state_entries(mine.label) if e.required in mine.states]
        fitting = [e for e in fitting if (e.equivalent or "") in (theirs.states or ("",))]
        needed = [e for e in fitting if e.required in extra or e.equivalent in lost]
        unexplained = extra - {e.required for e in fitting} | lost - {e.equivalent for e in fitting}
        if not unexplained:
            return used | set(needed), []
        missing = undeclared("state", mine.label, ", ".join(sorted(extra)), ", ".join(sorted(lost)))
        return used | set(needed), [missing]

    def _renaming(self, now: str, before: str) -> set[Substituted]:
        return {e for e in self.declared if e.kind == "object" and (e.required, e.equivalent) == (now, before)}

    def _state_entries(self, label: str) -> list[Substituted]:
        return [e for e in self.declared if e.kind == "state" and e.object == label]

    def _state_changes(self, mine: ObjectNode, theirs: ObjectNode) -> tuple[set[str], set[str]]:
        """Answer the states that were added and lost; a vessel is empty when it holds nothing, and only then."""
        extra, lost = set(mine.states) - set(theirs.states), set(theirs.states) - set(mine.states)
        if any(not self.is_brought(name) for name in theirs.ingredients):
            lost -= APPLIED
        if not self.is_food(mine):
            if theirs.ingredients and not mine.ingredients:
                extra.discard(EMPTY)
            if mine.ingredients and not theirs.ingredients:
                lost.discard(EMPTY)
        return extra, lost

    @cached_property
    def brought(self) -> frozenset[str]:
        """The names, in the singular, of all foods that the inputs of the tree's unit are or hold."""
        return self.foods_of(self.unit.input_nodes)

    def is_brought(self, name: str) -> bool:
        """Say whether a food that FOON calls ``name`` is among what goes in."""
        return self.is_among(name, self.brought)

    def is_among(self, name: str, foods: frozenset[str]) -> bool:
        """Say whether what FOON calls ``name`` is, under the name it has now, one of ``foods``."""
        return any(singular(now) in foods for now in self.names_now(name))

    def foods_of(self, nodes: Iterable[ObjectNode]) -> frozenset[str]:
        """Answer the names, in the singular, of all foods that ``nodes`` are or hold."""
        named = [(node.label, *node.ingredients) if self.is_food(node) else node.ingredients for node in nodes]
        return frozenset(singular(name) for names in named for name in names)

    def guesses(self) -> tuple[Substituted, ...]:
        """Answer the renamings that would explain the foods left over: one of the tree in the place of one of FOON."""
        found: dict[str, Substituted] = {}
        for new, old in ((self.new_inputs, self.gone_inputs), (self.new_outputs, self.gone_outputs)):
            for mine in new:
                for theirs in old:
                    if self.is_food(mine) and self.is_food(theirs) and _place(mine) == _place(theirs):
                        found.setdefault(mine.label, undeclared("object", mine.label, mine.label, theirs.label))
        return tuple(found.values())


def _rest(nodes: Sequence[ObjectNode], without: Iterable[ObjectNode]) -> tuple[ObjectNode, ...]:
    taken = set(without)
    return tuple(node for node in nodes if node not in taken)


def _place(node: ObjectNode) -> tuple[str | None, str | None]:
    return (node.relation, node.container)
