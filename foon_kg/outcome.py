"""From an executed tree to the answer: units with their origin, the kitchen, what was substituted and assumed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from foon_kg.integration import FinalTree
from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode, Recipe
from foon_kg.progress import progress_lines
from foon_kg.result import Alternative, Assumption, Origin, PlannedUnit, PlanResult, ReferenceSummary, Substitution
from foon_kg.script import Casting, Recast, Step
from foon_kg.substitution import FAIR, Equivalents

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
    units = tuple(_planned(step, casting, keys) for step, casting in tree.steps)
    leaves = tuple(_leaves(units))
    return PlanResult(
        recipe=recipe,
        reference=summary,
        goal=tree.goal,
        units=units,
        kitchen=leaves,
        substitutions=tuple(_substitutions(tree, equivalents)),
        assumptions=tuple(_assumptions(leaves, units, kitchen)),
    )


def with_progress(result: PlanResult, kitchen: Kitchen) -> PlanResult:
    """Answer ``result`` with the progress line of every required food."""
    units = [unit.as_unit() for unit in result.units]
    lines = progress_lines(units, result.goal, result.recipe.ingredients, kitchen)
    return replace(result, progress_lines=lines)


def _planned(step: Step, casting: Casting, reference: set[str]) -> PlannedUnit:
    unit = step.known.unit
    return PlannedUnit(
        step.input_nodes,
        step.motion,
        step.output_nodes,
        _origin(step, casting, in_reference=unit.key in reference),
        step.known.seen_in,
        unit.accepts_any,
        step.moving,
    )


def _origin(step: Step, casting: Casting, *, in_reference: bool) -> Origin:
    if any(True for _ in _renamings(step, casting)):
        return "substituted"
    return "reference" if in_reference else "foon"


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


def _substitutions(tree: FinalTree, equivalents: Equivalents) -> Iterator[Substitution]:
    seen = dict.fromkeys(renaming for step, casting in tree.steps for renaming in _renamings(step, casting))
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
            made = next(s for _, c in tree.steps for s in _states_made_by(c, food, known, required))
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
    return round(dict(options).get(name, FAIR), 4)


def _others(options: Sequence[tuple[str, float]], chosen: str) -> tuple[Alternative, ...]:
    return tuple(Alternative(name, round(sure, 4)) for name, sure in options if name != chosen)[:MOST_ALTERNATIVES]


def _assumptions(leaves: Sequence[ObjectNode], units: Sequence[PlannedUnit], kitchen: Kitchen) -> Iterator[Assumption]:
    for node in leaves:
        taker = next(unit for unit in units if node in unit.input_nodes)
        fault = kitchen.leaf_fault(node, [other for other in taker.input_nodes if other != node])
        if fault is not None:
            yield Assumption(node, f"nothing in this FOON makes it, or a fair equivalent, from what was asked: {fault}")
