"""From an executed tree to the answer: units with their origin, the kitchen, what was substituted and assumed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Self

from foon_kg.integration.reenacting import FinalTree
from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode, Recipe
from foon_kg.progress import progress_lines
from foon_kg.result import Alternative, Assumption, Origin, PlannedUnit, PlanResult, ReferenceSummary, Substitution
from foon_kg.script import EMPTY, GIVEN, Casting, Recast, Step, spot_of
from foon_kg.substitution import FAIR, SAME_CLASS, Equivalents

MOST_ALTERNATIVES = 3


def plan_result(
    recipe: Recipe,
    tree: FinalTree,
    script: Sequence[KnownUnit],
    summary: ReferenceSummary,
    *,
    equivalents: Equivalents,
    kitchen: Kitchen,
) -> PlanResult:
    """Answer the plan result for ``tree``, which was made from the reference tree ``script``."""
    keys = {known.unit.key for known in script}
    changes = [_Change.of(step, casting) for step, casting in tree.steps]
    substitutions = (*_substitutions(changes, equivalents), *_utensils_otherwise(changes, equivalents, kitchen))
    units = tuple(_planned(change, keys, substitutions) for change in changes)
    leaves = tuple(_leaves(units))
    return PlanResult(
        recipe=recipe,
        reference=summary,
        goal=tree.goal,
        units=units,
        kitchen=leaves,
        substitutions=substitutions,
        assumptions=tuple(_assumptions(leaves, units, kitchen)),
    )


def with_progress(result: PlanResult, kitchen: Kitchen) -> PlanResult:
    """Answer ``result`` with the progress line of every required food."""
    units = [unit.as_unit() for unit in result.units]
    lines = progress_lines(units, result.goal, result.recipe.ingredients, kitchen)
    return replace(result, progress_lines=lines)


@dataclass(frozen=True)
class _Change:
    """A step with how it differs from its unit in FOON: see :func:`_renamings` and :func:`_same_things`."""

    step: Step
    casting: Casting
    renamings: tuple[tuple[str, str, str, str], ...]
    same_things: tuple[tuple[ObjectNode, ObjectNode], ...]

    @classmethod
    def of(cls, step: Step, casting: Casting) -> Self:
        return cls(step, casting, tuple(_renamings(step, casting)), tuple(_same_things(step)))


def _planned(change: _Change, reference: set[str], substitutions: Sequence[Substitution]) -> PlannedUnit:
    step = change.step
    unit = step.known.unit
    return PlannedUnit(
        step.input_nodes,
        step.motion,
        step.output_nodes,
        _origin(change, substitutions, in_reference=unit.key in reference),
        step.known.seen_in,
        unit.accepts_any,
        step.moving,
    )


def _origin(change: _Change, substitutions: Sequence[Substitution], *, in_reference: bool) -> Origin:
    if change.renamings or _shows_any(change, substitutions):
        return "substituted"
    return "reference" if in_reference else "foon"


def _shows_any(change: _Change, substitutions: Sequence[Substitution]) -> bool:
    """Say whether a substitution is to be seen in a step, be it that the food itself joined before as another's."""
    return any(_shows(now, before, other) for now, before in change.same_things for other in substitutions)


def _shows(now: ObjectNode, before: ObjectNode, other: Substitution) -> bool:
    if other.kind == "object":
        gone = set(before.ingredients) - set(now.ingredients)
        return other.equivalent in gone and other.required in now.ingredients
    if other.kind == "state" and other.object == now.label:
        extra, lost = _other_states(now, before)
        return other.required in extra or other.equivalent in lost
    return False


def _same_things(step: Step) -> Iterator[tuple[ObjectNode, ObjectNode]]:
    """Answer the nodes of a step that differ from FOON's, each with the likest one of its label and place there."""
    unit = step.known.unit
    for nodes, known in ((step.input_nodes, unit.input_nodes), (step.output_nodes, unit.output_nodes)):
        free = [node for node in known if node not in nodes]
        for now in nodes:
            alike = [node for node in free if node.label == now.label and spot_of(node) == spot_of(now)]
            if now not in known and alike:
                yield now, min(alike, key=lambda node: (len(set(node.states) ^ set(now.states)), node.sort_key))


def _other_states(now: ObjectNode, before: ObjectNode) -> tuple[set[str], set[str]]:
    """Answer the states that a node has beyond FOON's, and FOON's that it has not; not what follows from its foods."""
    extra, lost = set(now.states) - set(before.states), set(before.states) - set(now.states)
    if before.ingredients and not now.ingredients:
        extra.discard(EMPTY)
    if now.ingredients and not before.ingredients:
        lost.discard(EMPTY)
    if not set(before.ingredients) <= set(now.ingredients):
        lost -= GIVEN
    return extra, lost


def _utensils_otherwise(
    changes: Iterable[_Change], equivalents: Equivalents, kitchen: Kitchen
) -> Iterator[Substitution]:
    """Answer the utensils that are in another state than in FOON, for what brought them there was left out.

    A board that nobody floured is an empty one; a pan into which no oil was poured is still the heated one.
    """
    found: dict[tuple[str, str, str], None] = {}  # a set that keeps its order
    for change in changes:
        for now, before in change.same_things:
            extra, lost = _other_states(now, before)
            if kitchen.is_utensil(now.label) and extra and len(lost) <= 1:
                gone = lost or set(before.states) - set(now.states)
                found |= {(now.label, state, min(gone, default="")): None for state in sorted(extra)}
    for label, required, known in found:
        sure = equivalents.state_similarity(required, known) if known else SAME_CLASS
        yield Substitution("state", label, required, known, round(sure, 4), ())


def _leaves(units: Iterable[PlannedUnit]) -> Iterator[ObjectNode]:
    """Answer, once each, the inputs that no earlier unit outputs."""
    there: set[ObjectNode] = set()
    for unit in units:
        for node in unit.input_nodes:
            if node not in there:
                there.add(node)
                yield node
        there.update(unit.output_nodes)


def _renamings(step: Step, casting: Casting) -> Iterator[tuple[str, str, str, str]]:
    """Answer (kind, object, required, equivalent) for everything that is substituted in this step."""
    unit = step.known.unit
    shown = {node.label for node in (*step.input_nodes, *step.output_nodes)}
    named = {name for node in (*step.input_nodes, *step.output_nodes) for name in node.ingredients}
    nodes = (*unit.input_nodes, *unit.output_nodes)
    for label in sorted({n.label for n in nodes} | {name for n in nodes for name in n.ingredients}):
        recast = casting.foods.get(label)
        if recast is None or recast.label not in shown | named:
            continue
        if recast.label != label:
            yield "object", recast.label, recast.label, label
        yield from _state_renamings(step, label, recast)
    if step.motion != unit.motion:
        recast = next(r for r in casting.foods.values() if r is not None and r.motions.get(unit.motion) == step.motion)
        yield "motion", recast.label, step.motion, unit.motion


def _state_renamings(step: Step, label: str, recast: Recast) -> Iterator[tuple[str, str, str, str]]:
    now = {node for node in (*step.input_nodes, *step.output_nodes) if node.label == recast.label}
    for node in (*step.known.unit.input_nodes, *step.known.unit.output_nodes):
        if node.label != label or not any(set(recast.states_of(node)) <= set(n.states) for n in now):
            continue
        for known, required in sorted(recast.states.items()):
            if known in node.states or (not known and not node.states):
                yield "state", recast.label, required, known


def _substitutions(changes: Sequence[_Change], equivalents: Equivalents) -> Iterator[Substitution]:
    seen = dict.fromkeys(renaming for change in changes for renaming in change.renamings)
    for kind, food, required, known in seen:
        if kind == "object":
            options = equivalents.labels_like(food)
            yield Substitution("object", food, required, known, _confidence(options, known), _others(options, known))
        elif kind == "state":
            label = next((k for d, o, _, k in seen if d == "object" and o == food), food)
            options = equivalents.states_like(food, required, label)
            sure = equivalents.state_confidence(food, required, known)
            yield Substitution("state", food, required, known, round(sure, 4), _others(options, known))
        else:
            made = next(s for c in changes for s in _states_made_by(c.casting, food, known, required))
            options = equivalents.motions_like(made)
            yield Substitution(
                "motion", food, required, known, _confidence(options, required), _others(options, required)
            )


def _states_made_by(casting: Casting, food: str, known: str, required: str) -> Iterator[str]:
    """Answer the states for whose sake the motion ``required`` stands for ``known``."""
    for recast in casting.foods.values():
        if recast is not None and recast.label == food and recast.motions.get(known) == required:
            yield from recast.states.values()


def _confidence(options: Sequence[tuple[str, float]], name: str) -> float:
    return round(next((sure for other, sure in options if other == name), FAIR), 4)


def _others(options: Sequence[tuple[str, float]], chosen: str) -> tuple[Alternative, ...]:
    others = ((name, sure) for name, sure in options if name != chosen)
    return tuple(Alternative(name, round(sure, 4)) for name, sure in islice(others, MOST_ALTERNATIVES))


def _assumptions(leaves: Sequence[ObjectNode], units: Sequence[PlannedUnit], kitchen: Kitchen) -> Iterator[Assumption]:
    for node in leaves:
        taker = next(unit for unit in units if node in unit.input_nodes)
        fault = kitchen.leaf_fault(node, [other for other in taker.input_nodes if other != node])
        if fault is not None:
            yield Assumption(node, f"nothing in this FOON makes it, or a fair equivalent, from what was asked: {fault}")
