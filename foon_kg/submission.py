"""A plan as it is laid before the judge: with the judge's own words, and without a detour through JSON.

Only what a plan result says in JSON is handed over. So the judge sees what it would read in ``foon plan --json``, and
``tests/planner/test_submission.py`` holds both ways to the same.
"""

from __future__ import annotations

from foon_kg.form.tree import Assumed, Substituted, TaskTree, TreeUnit
from foon_kg.result import PlannedUnit, PlanResult, Substitution


def submitted(result: PlanResult) -> TaskTree:
    """Answer what :meth:`TaskTree.from_json` reads in the JSON of ``result``."""
    recipe = result.recipe
    return TaskTree(
        recipe.id or recipe.title or "plan",
        tuple(map(_unit, result.units)),
        result.goal,
        recipe,
        result.kitchen,
        tuple(map(_substituted, result.substitutions)),
        tuple(Assumed(entry.node, entry.why) for entry in result.assumptions),
        result.reference.goal,
    )


def _unit(unit: PlannedUnit) -> TreeUnit:
    inputs, outputs = tuple(dict.fromkeys(unit.input_nodes)), tuple(dict.fromkeys(unit.output_nodes))
    return TreeUnit(inputs, unit.motion_node, outputs, unit.origin, unit.seen_in)


def _substituted(entry: Substitution) -> Substituted:
    alternatives = tuple((other.name, other.confidence) for other in entry.alternatives)
    return Substituted(entry.kind, entry.object, entry.required, entry.equivalent, entry.confidence, alternatives)
