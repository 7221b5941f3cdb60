"""The sense measures that follow a food through the tree: S1 to S4 and S7.

A food *joins others* where an output of a unit that takes it holds, beside it, another food that is not free. A unit
that takes several foods and keeps them apart (two foods on one board) joins nothing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from foon_kg import motions
from foon_kg.form.case import Case, Joining
from foon_kg.form.report import Finding
from foon_kg.form.tree import TreeUnit
from foon_kg.kitchen import singular, words
from foon_kg.model import ObjectNode


def fresh(case: Case) -> Iterator[Finding]:
    """S1: no unit takes a food, or a vessel with food, that an earlier unit moved or changed.

    Storage and the foods of the kitchen are not asked: a second helping of salt is S4's matter. What a unit puts back,
    or makes again, is fresh again. Annotators often leave out of the outputs what only stood by (the board under the
    knife); :func:`_stays` says what that is.
    """
    gone: dict[ObjectNode, int] = {}
    leaves = set(case.tree.leaves)
    for place, unit in enumerate(case.tree.units):
        for node in unit.input_nodes:
            if node in gone:
                yield Finding("S1", f"unit {gone[node]} moved or changed it before", place, node)
        for node in unit.used_up:
            if _holds_food(case, node) and not _inexhaustible(case, node, leaves) and not _stays(case, unit, node):
                gone.setdefault(node, place)
        for node in unit.output_nodes:
            gone.pop(node, None)


def _holds_food(case: Case, node: ObjectNode) -> bool:
    return case.kitchen.is_food(node) or bool(case.kitchen.foods_in(node))


def _inexhaustible(case: Case, node: ObjectNode, leaves: set[ObjectNode]) -> bool:
    return node in leaves and (case.kitchen.is_food(node) or case.kitchen.is_storage(node.label))


def _stays(case: Case, unit: TreeUnit, node: ObjectNode) -> bool:
    """Say whether an input that is not among the outputs is there all the same, and as it was.

    No output may be the same thing in another form. A vessel stays where an output still lies in it, be it under a
    shorter name (annotators write *in pan* of what lies in the cooking pan); a food stays where its vessel still holds
    it and the unit neither mixes nor heats.
    """
    if any(other.label == node.label for other in unit.output_nodes):
        return False
    if not case.kitchen.is_food(node):
        names = {node.label, words(node.label)[-1]}
        return any(other.container in names for other in unit.output_nodes)
    holds = any(other.label == node.container and node.label in other.ingredients for other in unit.output_nodes)
    return holds and not _works(unit)


def _works(unit: TreeUnit) -> bool:
    """Whether a unit mixes or heats: what joins after the last such unit joins too late (S2)."""
    return motions.mixes(unit.motion) or motions.heats(unit.motion)


def in_time(case: Case) -> Iterator[Finding]:
    """S2: a food joins others no later than the last unit that mixes or heats, unless FOON's unit takes it there.

    Free foods count neither as what joins nor as what is joined.
    """
    units = case.tree.units
    working = [place for place, unit in enumerate(units) if _works(unit) and case.names_of(unit.input_nodes)]
    if not working:
        return
    equivalents = {
        singular(e.required): e.equivalent or "" for e in case.tree.substitutions or () if e.kind == "object"
    }
    for joining in case.joinings:
        if joining.place <= working[-1]:
            continue
        known = case.derivations[joining.place]
        taken = case.names_of(known.source.input_nodes) if known else frozenset()
        if taken.isdisjoint({joining.food, singular(equivalents.get(joining.food, joining.food))}):
            yield Finding("S2", f"{joining.food} joins others after the last mixing or heating", joining.place)


def opened(case: Case) -> Iterator[Finding]:
    """S3: a food asked whole is cracked, peeled, opened or cut before it joins others, where FOON has a unit for it."""
    asked = {singular(w.object) for w in case.required if _is_whole(w.state)}
    if not asked or case.foon is None:
        return
    known = {singular(label) for label in case.foon.opened if not case.kitchen.is_utensil(label)}
    for joining in case.joinings:
        if joining.food in asked & known and not _opened_before(case, joining):
            yield Finding(
                "S3", f"{joining.food} joins others as a whole, and FOON has a unit that opens it", joining.place
            )


def _is_whole(state: str) -> bool:
    return "whole" in words(state)


def _opened_before(case: Case, joining: Joining) -> bool:
    for unit in case.tree.units[: joining.place + 1]:
        if motions.opens(unit.motion) and any(singular(node.label) == joining.food for node in unit.used_up):
            return True
    return False


def thrifty(case: Case) -> Iterator[Finding]:
    """S4: a required food is taken from the kitchen, vessels apart, no more often than it was asked.

    A unit takes a leaf when it uses it up; what it puts back as it was stays in the kitchen.
    """
    asked = Counter(singular(wanted.object) for wanted in case.required)
    takes: Counter[str] = Counter()
    leaves = set(case.tree.leaves).intersection(case.tree.kitchen or case.tree.leaves)
    for place, unit in enumerate(case.tree.units):
        for node in unit.used_up:
            name = singular(node.label)
            if node in leaves and case.kitchen.is_food(node) and name in asked:
                takes[name] += 1
                if takes[name] > asked[name]:
                    yield Finding("S4", f"taken {takes[name]} times, asked {asked[name]} times", place, node)


@dataclass(frozen=True)
class _States:
    """The states in which each food is seen where it joins others."""

    case: Case

    @cached_property
    def at_joining(self) -> dict[str, set[str]]:
        seen: dict[str, set[str]] = {}
        for joining in self.case.joinings:
            unit = self.case.tree.units[joining.place]
            there = (*joining.nodes, *(n for n in unit.output_nodes if singular(n.label) == joining.food))
            if there:
                seen.setdefault(joining.food, set()).update(state for node in there for state in node.states)
        return seen


def state_kept(case: Case) -> Iterator[Finding]:
    """S7: a food still has each processed state that was asked where it joins the others (before or in that unit)."""
    seen = _States(case).at_joining
    for wanted in sorted(set(case.required)):
        food = singular(wanted.object)
        if not wanted.state or case.kitchen.is_start_state(wanted.object, wanted.state) or food not in seen:
            continue
        if wanted.state not in seen[food]:
            yield Finding("S7", f"{wanted.object} was asked {wanted.state} and is not so where it joins the others")
