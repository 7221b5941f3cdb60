"""Why nothing makes a goal: which nodes nobody has and nothing makes, the nearest to the goal first."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.model import ObjectNode
from foon_kg.plans.shortage import MOST_NAMED, named, remedies
from foon_kg.search.core import Core, core_behind
from foon_kg.search.forward import chain
from foon_kg.search.problem import NoWayError, SearchProblem


def no_way(problem: SearchProblem, targets: Sequence[ObjectNode]) -> NoWayError:
    """Return the error that says why nothing makes any of the ``targets`` (at least one) of ``problem``."""
    return no_way_without(
        targets, tuple(dict.fromkeys(n for target in targets for n in missing_behind(problem, target)))
    )


def no_way_without(targets: Sequence[ObjectNode], missing: tuple[ObjectNode, ...]) -> NoWayError:
    """Return the error that says that nothing makes any of the ``targets`` for want of what is ``missing``."""
    goal = " or ".join(map(str, targets[:MOST_NAMED]))
    return NoWayError(
        f"nothing makes {goal}: missing {named(missing)}",
        missing=missing,
        hint=f"{remedies(missing)}. What is there after all is named with --kitchen FILE.",
    )


def missing_behind(problem: SearchProblem, target: ObjectNode) -> tuple[ObjectNode, ...]:
    """Return the nodes of ``problem`` that stop ``target``, nearest first: what nothing makes, else circles."""
    number = problem.index.number_of.get(target)
    if number is None:
        return (target,)
    core = core_behind(problem, number)
    _, made = chain(core, range(core.step_count))
    makers = _makers(core)
    stopped = [node for node in _nearest_first(core.goal, makers, core.inputs) if not made[node]]
    nobody = [node for node in stopped if not makers[node]]
    return tuple(problem.index.nodes[core.nodes[node]] for node in nobody or stopped)


def _makers(core: Core) -> list[list[int]]:
    """Return for each node of a core the steps that make it."""
    makers: list[list[int]] = [[] for _ in core.nodes]
    for step, nodes in enumerate(core.outputs):
        for node in nodes:
            makers[node].append(step)
    return makers


def _nearest_first(goal: int, makers: list[list[int]], inputs: Sequence[tuple[int, ...]]) -> list[int]:
    found, seen, ring = list[int](), {goal}, [goal]
    while ring:
        found += ring
        ring = sorted({n for node in ring for step in makers[node] for n in inputs[step]} - seen)
        seen.update(ring)
    return found
