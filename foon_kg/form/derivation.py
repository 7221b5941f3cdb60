"""Whether a unit of a tree comes from a unit of the FOON by nothing but what C8 allows, and by which substitutions.

Allowed are: labels, states and motions that ``substitutions`` names; foods taken out, with the vessels that served only
them; foods added where any number may enter; and what follows from these for the outputs, which hold what really
went in. Where any number may enter, a food that stands elsewhere than in FOON, or is in a state that no entry explains,
is one food taken out and another added.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from foon_kg.form.correspondence import Correspondence, Pair
from foon_kg.form.tree import Substituted, TreeUnit
from foon_kg.kitchen import Kitchen, singular
from foon_kg.model import FunctionalUnit, ObjectNode


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
    if _is_the_same(unit, source):
        return Derivation(source, (), frozenset(), ())
    plain = Correspondence(unit, source, tuple(declared), kitchen)
    found = _derivation(plain)
    guesses = plain.guesses() if found.faults else ()
    if not guesses:
        return found
    guessed = _derivation(replace(plain, declared=(*declared, *guesses)))
    if guessed.faults:
        return found
    missing = tuple(entry for entry in guesses if entry in guessed.used)
    return replace(guessed, used=guessed.used - set(guesses), undeclared=(*guessed.undeclared, *missing))


def may_explain(entry: Substituted, unit: TreeUnit, source: FunctionalUnit) -> bool:
    """Say whether ``entry`` is about anything in the two units: no other entry has a part in :func:`derive`."""
    if entry.kind == "object":
        named = (*source.input_nodes, *source.output_nodes)
        return any(entry.equivalent in (node.label, node.container, *node.ingredients) for node in named)
    if entry.kind == "state":
        return any(entry.object == node.label for node in (*unit.input_nodes, *unit.output_nodes))
    return entry.kind == "motion" and unit.motion != source.motion


def _is_the_same(unit: TreeUnit, source: FunctionalUnit) -> bool:
    """Say whether nothing was changed, so that nothing is to be explained."""
    return (
        unit.motion == source.motion
        and set(unit.input_nodes) == set(source.input_nodes)
        and set(unit.output_nodes) == set(source.output_nodes)
    )


def _derivation(pairs: Correspondence) -> Derivation:
    explained = [pairs.entries(pair) for pair in (*pairs.inputs, *pairs.outputs)]
    used, missing = pairs.motion_entries()
    for found, lacking in explained:
        used |= found
        missing += lacking
    faults = (*_input_faults(pairs), *_output_faults(pairs))
    return Derivation(pairs.source, faults, frozenset(used), tuple(dict.fromkeys(missing)))


def _input_faults(pairs: Correspondence) -> Iterator[Fault]:
    for mine, theirs in pairs.inputs:
        if not pairs.same_place(mine, theirs):
            yield Fault(f"FOON has it {_where(theirs)}, and nothing but what stands there may enter here", mine)
    for node in pairs.new_inputs:
        if not pairs.is_food(node) and not node.ingredients:
            yield Fault("FOON's unit does not use it, and only foods are added", node)
        elif not pairs.any_number:
            yield Fault(f"added to “{pairs.source.motion}”, where no more foods may enter", node)
    for node in pairs.gone_inputs:
        if not pairs.is_food(node) and not _served_only_what_is_gone(node, pairs):
            yield Fault("FOON's unit needs it and it is left out, though it serves what is still there", node)
    if pairs.foods_of(pairs.source.input_nodes) and not pairs.brought:
        yield Fault("all foods were taken out, so the unit has nothing to do")


def _served_only_what_is_gone(node: ObjectNode, pairs: Correspondence) -> bool:
    if any(food.container == node.label for food in pairs.gone_inputs):
        return True
    foods = pairs.kitchen.foods_in(node)
    return bool(foods) and not any(pairs.is_brought(name) for name in foods)


def _output_faults(pairs: Correspondence) -> Iterator[Fault]:
    for pair in pairs.outputs:
        mine, theirs = pair
        if not pairs.same_place(mine, theirs) and mine not in pairs.unit.input_nodes:
            yield Fault(f"FOON's unit leaves it {_where(theirs)}", mine)
        yield from _too_much(pair, pairs)
        yield from _too_little(pair, pairs)
    added = {node.label for node in pairs.new_inputs}
    for node in pairs.new_outputs:
        if node.label not in added and node not in pairs.unit.input_nodes:
            yield Fault("FOON's unit does not make it", node)
    for node in pairs.gone_outputs:
        if _could_be_made(node, pairs):
            yield Fault("FOON's unit makes it of what is still there, and it is left out", node)


def _too_much(pair: Pair, pairs: Correspondence) -> Iterator[Fault]:
    """Tell the ingredients that did not go in, unless FOON itself names them out of nowhere."""
    mine, theirs = pair
    there = pairs.brought | {singular(node.label) for node in pairs.unit.output_nodes}
    before = pairs.foods_of(pairs.source.input_nodes)
    for name in pairs.kitchen.foods_in(mine):
        if singular(name) in there:
            continue
        known_as = [old for old in theirs.ingredients if name in pairs.names_now(old)]
        if not known_as:
            yield Fault(f"it holds {name}, which did not go in", mine)
        elif any(singular(old) in before for old in known_as):
            yield Fault(f"it still holds {name}, which was taken out of what goes in", mine)


def _too_little(pair: Pair, pairs: Correspondence) -> Iterator[Fault]:
    """Tell the ingredients that go in as they do in FOON and are not in the output as they are in FOON."""
    mine, theirs = pair
    kept = frozenset(map(singular, (mine.label, *mine.ingredients)))
    for name in theirs.ingredients:
        if not pairs.is_among(name, kept) and _goes_in_as_in_foon(name, pairs):
            yield Fault(f"{name} goes in and is not in it, as it is in FOON", mine)


def _goes_in_as_in_foon(name: str, pairs: Correspondence) -> bool:
    for mine, theirs in pairs.inputs:
        if singular(name) in pairs.foods_of((theirs,)) and pairs.is_among(name, pairs.foods_of((mine,))):
            return True
    return False


def _could_be_made(node: ObjectNode, pairs: Correspondence) -> bool:
    """Say whether what an output of FOON's unit comes from is still among the inputs.

    A product that names no ingredients (water from the faucet, the yolk of an egg) may be taken out by itself.
    """
    if not pairs.is_food(node):
        return any(node.label == theirs.label for _, theirs in pairs.inputs)
    kept = pairs.foods_of(mine for mine, _ in pairs.inputs)
    is_input = any(node.label == other.label for other in pairs.source.input_nodes)
    return any(pairs.is_among(name, kept) for name in ([node.label] if is_input else node.ingredients))


def _where(node: ObjectNode) -> str:
    return f"{node.relation or 'at'} the {node.container}" if node.container else "in no place"
