"""C7 honest, C8 grounded (docs/contract.md): the FOON attests every step, and every difference is told."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import IntEnum
from typing import get_args

from foon_kg.food import singular
from foon_kg.model import FunctionalUnit
from foon_kg.model.claims import Substitution, SubstitutionKind
from foon_kg.model.tree import Step
from foon_kg.validation.case import Case
from foon_kg.validation.report import Finding
from foon_kg.world.reading import NodeReading

KINDS: tuple[str, ...] = get_args(SubstitutionKind)


class Grounding(IntEnum):
    """How near the evidence of a unit is: the same food, a declared equivalent, its kind, the motion alone.

    Of a unit without food the appliance counts: the same one, one that works like it (its kind), the motion alone.
    """

    FOOD = 0
    LIKE = 1
    KIND = 2
    MOTION = 3

    @property
    def word(self) -> str:
        """The word of a plan result."""
        return self.name.lower()


def honest(case: Case) -> Iterator[Finding]:
    """Yield the findings of C7 in ``case``: each substitution is whole and used; evidence of another food is told."""
    entries = case.tree.substitutions or ()
    named = {singular(name) for node in case.tree.nodes for name in (node.label, *node.ingredients)}
    for place, entry in enumerate(entries):
        for reason in _incomplete(entry):
            yield Finding("C7", f"substitution {place}, {_in_words(entry)}: {reason}")
        if entry in entries[:place]:
            yield Finding("C7", f"substitution {place}, {_in_words(entry)}, is there twice")
        elif not _is_used(case, entry, named):
            yield Finding("C7", f"substitution {place}, {_in_words(entry)}: no unit uses it")
    if case.foon is not None:
        yield from _undeclared_evidence(case)


def _undeclared_evidence(case: Case) -> Iterator[Finding]:
    """Yield the units whose evidence is no food like theirs and that do not say by what they are grounded."""
    for place, unit in enumerate(case.tree.units):
        if unit.seen_in and _nearest(case, unit) > Grounding.LIKE and unit.grounding is None:
            facts = _facts(case, unit)
            if facts.inputs or not facts.appliances:
                foods = ", ".join(sorted(facts.inputs)) or "nothing"
                why = f"no substitution says what {foods} is handled like"
            else:
                why = f"no unit that it names has {' or '.join(sorted(facts.appliances))}, and no grounding says so"
            yield Finding("C7", why, place)


def _incomplete(entry: Substitution) -> Iterator[str]:
    """Yield what an entry does not say, or says wrongly."""
    if entry.kind not in KINDS:
        yield f"its kind is “{entry.kind}”, not {', '.join(KINDS)}"
    if not entry.required:
        yield "it does not say what is required"
    if "equivalent" in entry.missing or (not entry.equivalent and entry.kind != "state"):
        yield "it names no equivalent"
    if entry.equivalent == entry.required:
        yield "the equivalent is what was required"
    if "confidence" in entry.missing or not 0 <= entry.confidence <= 1:
        yield "it has no confidence between 0 and 1"
    if not entry.object:
        yield "it does not name its object"
    yield from _incomplete_alternatives(entry)


def _incomplete_alternatives(entry: Substitution) -> Iterator[str]:
    if "alternatives" in entry.missing:
        yield "it has no list of alternatives"
    elif any(not other.name or other.missing for other in entry.alternatives):
        yield "an alternative has no name or no confidence"


def _is_used(case: Case, entry: Substitution, named: set[str]) -> bool:
    if entry.kind == "motion":
        return any(unit.motion == entry.required for unit in case.tree.units)
    about = entry.required if entry.kind in {"object", "tool", "vessel"} else entry.object
    return singular(about) in named or singular(entry.object) in named


def grounded(case: Case) -> Iterator[Finding]:
    """Yield the findings of C8 in ``case``: what a unit names of the FOON is like it, or it says that it is not.

    Such a unit has its motion, its main food or one of its kind, and its tool.
    """
    for place, unit in enumerate(case.tree.units):
        if unit.seen_in is None or case.tree.level is not None:
            yield from _explained(case, place, unit)
            continue
        if not unit.seen_in:
            yield Finding("C8", "it names no unit of the FOON", place)
        for sighting in unit.seen_in:
            source = case.foon.by_sighting.get((sighting.video, sighting.position)) if case.foon else None
            if source is None:
                yield Finding("C8", f"the FOON has no unit {sighting.position} in “{sighting.video}”", place)
            else:
                yield from _differs(case, place, unit, source)
        yield from _claims(case, place, unit)


def _explained(case: Case, place: int, unit: Step) -> Iterator[Finding]:
    """Ask of a unit that names no source whether the FOON has it, or at least its motion with one of its things."""
    if case.foon is None or unit.nodes_key in case.foon.by_key:
        return
    if case.tree.level is not None:
        yield Finding("C8", "the FOON has no such unit", place)
        return
    labels = {singular(node.label) for node in unit.output_nodes}
    if labels.isdisjoint(case.foon.labels_of_motion.get(unit.motion, ())):
        yield Finding("C8", "the FOON has no unit with this motion and any of these outputs", place)


def _differs(case: Case, place: int, unit: Step, source: FunctionalUnit) -> Iterator[Finding]:
    """Yield in what a unit differs from the one of the FOON that it names, where the tree does not say so."""
    mine, theirs = _facts(case, unit), _facts(case, source)
    if unit.motion != source.motion and not _declared(case, "motion", unit.motion, source.motion):
        yield Finding("C8", f"the unit it names does “{source.motion}”", place)
    alone = nearness(case, unit, source) is Grounding.MOTION and mine.inputs
    if alone and unit.grounding != Grounding.MOTION.word:
        foods = ", ".join(sorted(theirs.inputs)) or "no food"
        yield Finding("C8", f"the unit it names works on {foods}, of another kind", place)
    for tool in _undeclared_tools(case, mine.tools, theirs.tools):
        yield Finding("C8", f"the unit it names uses no {tool}", place)


def _undeclared_tools(case: Case, mine: frozenset[str], theirs: frozenset[str]) -> list[str]:
    """Return the tools of a unit that its source has not, nor any for which the tree says it stands; sorted.

    A source without tools is no evidence: many videos do not tell with what something is done.
    """
    if not theirs:
        return []
    others = sorted(mine - theirs)
    return [tool for tool in others if not any(_declared(case, "tool", tool, other) for other in theirs)]


def _claims(case: Case, place: int, unit: Step) -> Iterator[Finding]:
    if unit.grounding is None or case.foon is None or not unit.seen_in:
        return
    words = [level.word for level in Grounding]
    if unit.grounding not in words:
        yield Finding("C8", f"its grounding is “{unit.grounding}”, not {', '.join(words)}", place)
    elif words.index(unit.grounding) < _nearest(case, unit) and _is_about_something(_facts(case, unit)):
        yield Finding("C8", f"it claims “{unit.grounding}”, and its evidence is {_nearest(case, unit).word}", place)


def _is_about_something(facts: _Facts) -> bool:
    """Return whether the evidence of a unit with these ``facts`` is asked of what goes in, or of its appliance."""
    return bool(facts.inputs) or not facts.foods


def _nearest(case: Case, unit: Step) -> Grounding:
    sources = [case.foon.by_sighting.get((s.video, s.position)) for s in unit.seen_in or ()] if case.foon else []
    return min((nearness(case, unit, source) for source in sources if source), default=Grounding.FOOD)


def nearness(case: Case, unit: Step, source: FunctionalUnit) -> Grounding:
    """Return how near ``source``, a unit of the FOON, is as evidence for ``unit``, one of the tree of ``case``."""
    mine, theirs = _facts(case, unit).foods, _facts(case, source).foods
    if not mine:
        return _nearness_of_appliances(case, _facts(case, unit).appliances, _facts(case, source).appliances)
    if mine & theirs:
        return Grounding.FOOD
    if any(_declared(case, "object", food, other) for food in mine for other in theirs):
        return Grounding.LIKE
    kinds = {case.tables.foods.find(food)[0] for food in mine} & {case.tables.foods.find(food)[0] for food in theirs}
    return Grounding.KIND if kinds - {"unknown"} else Grounding.MOTION


def _nearness_of_appliances(case: Case, mine: frozenset[str], theirs: frozenset[str]) -> Grounding:
    """Return how near ``theirs`` are as evidence for what is done with ``mine`` and without food."""
    if not mine or mine & theirs:
        return Grounding.FOOD
    own, others = ([case.tables.utensils[name] for name in sorted(names)] for names in (mine, theirs))
    alike = any(one.works_like(other) for one in own for other in others)
    return Grounding.KIND if alike else Grounding.MOTION


def _declared(case: Case, kind: str, mine: str, theirs: str) -> bool:
    return any(
        entry.kind == kind
        and singular(entry.required) == singular(mine)
        and singular(entry.equivalent) == singular(theirs)
        for entry in case.tree.substitutions or ()
    )


@dataclass(frozen=True)
class _Facts:
    """The foods of a unit, those that go in, the tools that go in, and its appliances; names in the singular."""

    foods: frozenset[str]
    inputs: frozenset[str]
    tools: frozenset[str]
    appliances: frozenset[str]


def _facts(case: Case, unit: Step | FunctionalUnit) -> _Facts:
    """Return what a unit works on and with. Those of the FOON's units are kept, for every tree asks for them."""
    kept = case.foon.facts if case.foon is not None and isinstance(unit, FunctionalUnit) else case.facts
    key = (case.reader.foods, id(unit))  # what is food in one recipe (a wrap) is a utensil in another
    found = kept.get(key)
    if not isinstance(found, _Facts):
        found = kept[key] = _read_facts(case, unit)
    return found


def _read_facts(case: Case, unit: Step | FunctionalUnit) -> _Facts:
    inputs, outputs = ([case.reader.read(node) for node in side] for side in (unit.input_nodes, unit.output_nodes))
    foods_in, foods_out = _foods(inputs), _foods(outputs)
    tools = frozenset(said.label for said in inputs if said.utensil is not None and said.utensil.role == "tool")
    appliances = frozenset(said.label for said in (*inputs, *outputs) if said.is_appliance)
    return _Facts(foods_in | foods_out, foods_in, tools, appliances)


def _foods(saids: Iterable[NodeReading]) -> frozenset[str]:
    """Return the foods that nodes are or hold, of what the nodes say (``saids``)."""
    return frozenset().union(*(said.names | {said.label} if said.is_food else said.names for said in saids))


def _in_words(entry: Substitution) -> str:
    """Return what an entry says, for a message."""
    about = f"{entry.object}: " if entry.kind != "object" and entry.object else ""
    return f"{about}{entry.required or 'nothing'} for {entry.equivalent or 'nothing'} ({entry.kind or 'no kind'})"
