"""Whether a unit of a tree comes from a unit of the FOON by nothing but what C8 allows, and by which substitutions.

Allowed are: labels, states and motions that ``substitutions`` names; foods taken out, with the vessels that served only
them; foods added where any number may enter; and what follows from these for the outputs, which hold what really
went in. Where any number may enter, a food that stands elsewhere than in FOON, or is in a state that no entry explains,
is one food taken out and another added.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.kitchen import Kitchen, singular
from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.validation.tree import Substituted, TreeUnit
from foon_kg.validation.words import takes_any

EMPTY = "empty"
APPLIED = frozenset({"buttered", "coated", "floured", "garnished", "greased", "oiled", "salted", "seasoned", "stuffed"})
"""States that a food gives to what it is put on; they go with it."""

Pair = tuple[ObjectNode, ObjectNode]


@dataclass(frozen=True)
class Fault:
    """Something that no rule of derivation explains."""

    reason: str
    node: ObjectNode | None = None


@dataclass(frozen=True)
class Derivation:
    """How a unit comes from ``source``: the entries it uses, those it would need, and what stays unexplained."""

    source: FunctionalUnit
    faults: tuple[Fault, ...]
    used: frozenset[Substituted]
    undeclared: tuple[Substituted, ...]

    @property
    def cost(self) -> tuple[int, int, int]:
        """The smaller, the better the source explains the unit."""
        return (len(self.faults), len(self.undeclared), len(self.used))


def derive(unit: TreeUnit, source: FunctionalUnit, declared: Sequence[Substituted], kitchen: Kitchen) -> Derivation:
    """Compare ``unit`` with ``source``.

    Where it fails, foods that stand in each other's place are taken as substitutions nobody declared, and the
    comparison is made once more with them: a missing entry is then told as such (C7), not as an invention (C8).
    """
    plain = _Comparison(unit, source, tuple(declared), kitchen).answer()
    if not plain.faults:
        return plain
    guesses = _Comparison(unit, source, tuple(declared), kitchen).guesses()
    if not guesses:
        return plain
    guessed = _Comparison(unit, source, (*declared, *guesses), kitchen).answer()
    missing = tuple(entry for entry in guesses if entry in guessed.used)
    better = replace(guessed, used=guessed.used - set(guesses), undeclared=(*guessed.undeclared, *missing))
    return plain if guessed.faults else better


def undeclared(kind: str, label: str, required: str, equivalent: str) -> Substituted:
    """Answer the entry that is missing."""
    return Substituted(kind, label, required, equivalent, None, None)


@dataclass(frozen=True)
class _Comparison:
    unit: TreeUnit
    source: FunctionalUnit
    declared: tuple[Substituted, ...]
    kitchen: Kitchen

    def answer(self) -> Derivation:
        explained = [self._entries(pair) for pair in (*self.inputs, *self.outputs)]
        used, missing = self._motion_entries()
        for found, lacking in explained:
            used |= found
            missing += lacking
        faults = (*self._input_faults(), *self._output_faults())
        return Derivation(self.source, tuple(faults), frozenset(used), tuple(dict.fromkeys(missing)))

    def guesses(self) -> tuple[Substituted, ...]:
        """Answer the renamings that would explain the foods left over: one of the tree in the place of one of FOON."""
        found: dict[str, Substituted] = {}
        for new, old in ((self.new_inputs, self.gone_inputs), (self.new_outputs, self.gone_outputs)):
            for mine in new:
                for theirs in old:
                    if self._is_food(mine) and self._is_food(theirs) and _place(mine) == _place(theirs):
                        found.setdefault(mine.label, undeclared("object", mine.label, mine.label, theirs.label))
        return tuple(found.values())

    # ---- who is who

    @cached_property
    def any_number(self) -> bool:
        return takes_any(self.source.motion, star=self.source.accepts_any) or takes_any(self.unit.motion)

    @cached_property
    def inputs(self) -> tuple[Pair, ...]:
        pairs = self._pairs(self.unit.input_nodes, self.source.input_nodes)
        return tuple(pair for pair in pairs if not (self.any_number and self._is_exchanged(pair)))

    @cached_property
    def outputs(self) -> tuple[Pair, ...]:
        pairs = self._pairs(self.unit.output_nodes, self.source.output_nodes)
        added = {node.label for node in self.new_inputs}
        return tuple(pair for pair in pairs if not (pair[0].label in added and self._is_exchanged(pair)))

    def _is_exchanged(self, pair: Pair) -> bool:
        mine, theirs = pair
        if not self._is_food(mine) and not mine.ingredients:
            return False
        return not self._same_place(mine, theirs) or (self._is_food(mine) and bool(self._entries(pair)[1]))

    @cached_property
    def new_inputs(self) -> tuple[ObjectNode, ...]:
        return _rest(self.unit.input_nodes, (mine for mine, _ in self.inputs))

    @cached_property
    def gone_inputs(self) -> tuple[ObjectNode, ...]:
        return _rest(self.source.input_nodes, (theirs for _, theirs in self.inputs))

    @cached_property
    def new_outputs(self) -> tuple[ObjectNode, ...]:
        return _rest(self.unit.output_nodes, (mine for mine, _ in self.outputs))

    @cached_property
    def gone_outputs(self) -> tuple[ObjectNode, ...]:
        return _rest(self.source.output_nodes, (theirs for _, theirs in self.outputs))

    def _pairs(self, mine: Sequence[ObjectNode], theirs: Sequence[ObjectNode]) -> tuple[Pair, ...]:
        """Pair the nodes that are the same thing, the likest first."""
        costs = sorted(
            (self._distance(m, t), i, j)
            for i, m in enumerate(mine)
            for j, t in enumerate(theirs)
            if m.label in self._names_now(t.label)
        )
        taken_mine: set[int] = set()
        taken_theirs: set[int] = set()
        pairs = []
        for _, i, j in costs:
            if i not in taken_mine and j not in taken_theirs:
                taken_mine.add(i)
                taken_theirs.add(j)
                pairs.append((mine[i], theirs[j]))
        return tuple(pairs)

    def _distance(self, mine: ObjectNode, theirs: ObjectNode) -> tuple[bool, int, bool, int]:
        foods = set(mine.ingredients) ^ set(theirs.ingredients)
        return (
            not self._same_place(mine, theirs),
            len(set(mine.states) ^ set(theirs.states)),
            mine.label != theirs.label,
            len(foods),
        )

    def _names_now(self, name: str) -> set[str]:
        """Answer what a name of FOON may be called in the tree."""
        return {name, *(e.required for e in self.declared if e.kind == "object" and e.equivalent == name)}

    def _same_place(self, mine: ObjectNode, theirs: ObjectNode) -> bool:
        """Say whether the places are the same; what only a food that is gone gave (coated with oil) may be missing."""
        cover = theirs.container
        if mine.container is None and cover and not self.kitchen.is_utensil(cover) and not self._is_brought(cover):
            return True
        if mine.relation != theirs.relation:
            return False
        if mine.container is None or theirs.container is None:
            return mine.container == theirs.container
        return mine.container in self._names_now(theirs.container)

    def _is_food(self, node: ObjectNode) -> bool:
        return self.kitchen.is_food(node)

    # ---- what is substituted

    def _motion_entries(self) -> tuple[set[Substituted], list[Substituted]]:
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

    def _entries(self, pair: Pair) -> tuple[set[Substituted], list[Substituted]]:
        """Answer the entries that a pair uses, and those it would need."""
        mine, theirs = pair
        used = set()
        if mine.label != theirs.label:
            used |= self._renaming(mine.label, theirs.label)
        for name in set(theirs.ingredients) - set(mine.ingredients):
            for now in (self._names_now(name) - {name}) & set(mine.ingredients):
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
        if any(not self._is_brought(name) for name in theirs.ingredients):
            lost -= APPLIED
        if not self._is_food(mine):
            if theirs.ingredients and not mine.ingredients:
                extra.discard(EMPTY)
            if mine.ingredients and not theirs.ingredients:
                lost.discard(EMPTY)
        return extra, lost

    # ---- what went in

    @cached_property
    def brought(self) -> frozenset[str]:
        """The names of all foods that the inputs of the tree's unit are or hold."""
        return _names(self.unit.input_nodes, self._is_food)

    def _is_brought(self, name: str) -> bool:
        return any(singular(now) in self.brought for now in self._names_now(name))

    def _input_faults(self) -> Iterable[Fault]:
        for mine, theirs in self.inputs:
            if not self._same_place(mine, theirs):
                yield Fault(f"FOON has it {_where(theirs)}, and nothing but what stands there may enter here", mine)
        for node in self.new_inputs:
            if not self._is_food(node) and not node.ingredients:
                yield Fault("FOON's unit does not use it, and only foods are added", node)
            elif not self.any_number:
                yield Fault(f"added to “{self.source.motion}”, where no more foods may enter", node)
        for node in self.gone_inputs:
            if not self._is_food(node) and not self._served_only_what_is_gone(node):
                yield Fault("FOON's unit needs it and it is left out, though it serves what is still there", node)
        if _names(self.source.input_nodes, self._is_food) and not self.brought:
            yield Fault("all foods were taken out, so the unit has nothing to do")

    def _served_only_what_is_gone(self, node: ObjectNode) -> bool:
        if any(food.container == node.label for food in self.gone_inputs):
            return True
        foods = self.kitchen.foods_in(node)
        return bool(foods) and not any(self._is_brought(name) for name in foods)

    def _output_faults(self) -> Iterable[Fault]:
        before = _names(self.source.input_nodes, self._is_food)
        for mine, theirs in self.outputs:
            if not self._same_place(mine, theirs) and mine not in self.unit.input_nodes:
                yield Fault(f"FOON's unit leaves it {_where(theirs)}", mine)
            yield from self._content_faults(mine, theirs, before)
        added = {node.label for node in self.new_inputs}
        for node in self.new_outputs:
            if node.label not in added and node not in self.unit.input_nodes:
                yield Fault("FOON's unit does not make it", node)
        for node in self.gone_outputs:
            if self._still_made(node):
                yield Fault("FOON's unit makes it of what is still there, and it is left out", node)

    def _content_faults(self, mine: ObjectNode, theirs: ObjectNode, before: frozenset[str]) -> Iterable[Fault]:
        made = {singular(node.label) for node in self.unit.output_nodes}
        known = {now for name in theirs.ingredients for now in self._names_now(name)}
        for name in mine.ingredients:
            if singular(name) in self.brought | made or self.kitchen.is_utensil(name):
                continue
            if name not in known:
                yield Fault(f"it holds {name}, which did not go in", mine)
            elif any(singular(old) in before for old in theirs.ingredients if name in self._names_now(old)):
                yield Fault(f"it still holds {name}, which was taken out of what goes in", mine)
        kept = {singular(name) for name in mine.ingredients} | {singular(mine.label)}
        for name in theirs.ingredients:
            lost = not any(singular(now) in kept for now in self._names_now(name))
            if lost and self._is_still_in(name):
                yield Fault(f"{name} goes in and is not in it, as it is in FOON", mine)

    def _is_still_in(self, name: str) -> bool:
        """Say whether an input that is or holds ``name`` in FOON is or holds it in the tree."""
        for mine, theirs in self.inputs:
            if singular(name) in _names((theirs,), self._is_food):
                there = _names((mine,), self._is_food)
                if any(singular(now) in there for now in self._names_now(name)):
                    return True
        return False

    def _still_made(self, node: ObjectNode) -> bool:
        """Say whether what an output of FOON's unit comes from is still among the inputs.

        A product that names no ingredients (water from the faucet, the yolk of an egg) may be taken out by itself.
        """
        kept = [mine for mine, _ in self.inputs]
        if not self._is_food(node):
            return any(node.label == theirs.label for _, theirs in self.inputs)
        names = _names(kept, self._is_food)
        own = [node.label] if any(node.label == other.label for other in self.source.input_nodes) else node.ingredients
        return any(singular(now) in names for name in own for now in self._names_now(name))


def _names(nodes: Iterable[ObjectNode], is_food: Callable[[ObjectNode], bool]) -> frozenset[str]:
    own = [node.label for node in nodes if is_food(node)]
    return frozenset(map(singular, own + [name for node in nodes for name in node.ingredients]))


def _rest(nodes: Sequence[ObjectNode], without: Iterable[ObjectNode]) -> tuple[ObjectNode, ...]:
    taken = set(without)
    return tuple(node for node in nodes if node not in taken)


def _place(node: ObjectNode) -> tuple[str | None, str | None]:
    return (node.relation, node.container)


def _where(node: ObjectNode) -> str:
    return f"{node.relation or 'at'} the {node.container}" if node.container else "in no place"
