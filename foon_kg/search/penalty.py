"""The first part of the objective, alone: the least gap penalty, and the steps that can keep it.

Only the nodes that cannot be made without a gap matter here; that is a small part of a core, on which LM-cut is nearly
always the exact answer.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from foon_kg.search.core import Core, bits_of
from foon_kg.search.cuts import CutBound, Web, cut_bound, heights
from foon_kg.search.deadline import Deadline
from foon_kg.search.forward import chain, cheapest_first
from foon_kg.search.landmarks import landmarks_of
from foon_kg.search.partial import Choice, Partial


@dataclass(frozen=True)
class LeastPenalty:
    """The least gap ``penalty`` of any tree, and the ``steps`` that such trees may have.

    Where the time was too short it is the least found, and ``at_least`` is what is proven.
    """

    penalty: int
    at_least: int
    steps: list[int]


def within_least_penalty(core: Core, deadline: Deadline) -> LeastPenalty | None:
    """Find the least gap penalty of any tree that makes the goal; ``None`` where nothing makes it."""
    order, made = chain(core, range(len(core.gap_nodes), core.step_count))
    if made[core.goal]:
        return LeastPenalty(0, 0, order)
    part = needy(core, made)
    order, reached = chain(part)
    if not reached[part.goal]:
        return None
    penalty, part, cuts = _least(part.only(reachable(part, order)), deadline)
    at_least = penalty if not deadline.has_passed() else cuts.bound
    return LeastPenalty(penalty, at_least, _kept(core, made, part, cuts, penalty))


def _kept(core: Core, made: list[bool], part: Core, cuts: CutBound, penalty: int) -> list[int]:
    """Answer which steps of ``core`` may be in a tree of that penalty, by the cuts of a part of it."""
    paid = dict(zip(part.names, cuts.left, strict=True))
    left = [paid.get(name, weight) for name, weight in zip(core.names, _weights(core), strict=True)]
    for gap, (node,) in enumerate(core.outputs[: len(core.gap_nodes)]):
        if made[node]:
            left[gap] = penalty + 1  # what can be made is never a gap in a best tree
    whole = CutBound(cuts.bound, left, heights(Web.of(core), left))
    return [step for step in range(core.step_count) if whole.least_with(core, step) <= penalty]


def _weights(core: Core) -> list[int]:
    return [*core.costs, *[0] * len(core.units)]


def needy(core: Core, made: list[bool]) -> Core:
    """Answer what of ``core`` needs a gap: the nodes that can be made without one count as there."""
    outputs = tuple(tuple(node for node in side if not made[node]) for side in core.outputs)
    steps = [step for step, side in enumerate(outputs) if side]
    inputs: list[tuple[int, ...]] = [()] * core.step_count
    for step in steps:
        inputs[step] = tuple(node for node in core.inputs[step] if not made[node])
    part = replace(core, inputs=tuple(inputs), outputs=outputs)
    return part.only(reachable(part, steps))


def _least(core: Core, deadline: Deadline) -> tuple[int, Core, CutBound]:
    """Answer the least penalty, and cuts for what of ``core`` may be in a tree of that penalty."""
    best = core.penalty_of(cheapest_first(core))
    while True:
        cuts = _cuts(Web.of(core), _weights(core))
        kept = reachable(core, [step for step in range(core.step_count) if cuts.least_with(core, step) <= best])
        if cuts.bound == best:
            return best, core, cuts
        if len(kept) == core.step_count:
            best = _proven(core, best, cuts, deadline)
            return (best, core, cuts) if deadline.has_passed() else (best, *_sharpened(core, best))
        core = core.only(kept)
        best = min(best, core.penalty_of(cheapest_first(core)))


def _sharpened(core: Core, penalty: int) -> tuple[Core, CutBound]:
    """Answer cuts for trees of that ``penalty`` alone: without the gaps that cost more, whatever is chosen beside."""
    while True:
        web, weights = Web.of(core), _weights(core)
        cuts = _cuts(web, weights)
        spare = penalty - cuts.bound
        dear = {
            gap
            for gap, cost in enumerate(core.costs)
            if cost > spare and _costs_more(web, [*weights[:gap], 0, *weights[gap + 1 :]], penalty - cost)
        }
        if not spare or not dear:
            return core, cuts
        core = core.only(reachable(core, [step for step in range(core.step_count) if step not in dear]))


def _cuts(web: Web, weights: list[int]) -> CutBound:
    cuts = cut_bound(web, weights, [web.core.goal])
    if cuts is None:
        raise AssertionError("a tree of least penalty is never thrown out")
    return cuts


def _costs_more(web: Web, weights: list[int], limit: int) -> bool:
    return cut_bound(web, weights, [web.core.goal], limit=limit) is None


def _proven(core: Core, best: int, cuts: CutBound, deadline: Deadline) -> int:
    """Answer the least penalty, at most ``best``, by branch and bound with LM-cut at every tree.

    It is the least found where the deadline passes.
    """
    order, _ = chain(core)
    landmarks = landmarks_of(core, order)
    web, weights = Web.of(core), _weights(core)
    choice = Choice(core, web.makers, landmarks.nodes_of_step)
    stack = [choice.start()]
    while stack and best > cuts.bound and not deadline.has_passed():
        partial = choice.forced(stack.pop())
        if partial is None:
            continue
        if not partial.waiting:
            best = min(best, core.penalty_of(partial.chosen))
            continue
        if not _may_cost_less(web, weights, partial, best):
            continue
        options = {node: choice.options(partial, node) for node in partial.waiting}
        node = min(options, key=lambda waiting: (len(options[waiting]), waiting))
        options[node].sort(key=lambda step: (cuts.least_with(core, step), step), reverse=True)
        stack += [partial.take(core, node, step) for step in options[node]]
    return best


def _may_cost_less(web: Web, weights: list[int], partial: Partial, best: int) -> bool:
    left, spare = list(weights), best - 1 - web.core.penalty_of(partial.chosen)
    for step in bits_of(partial.chosen):
        left[step] = 0
    return cut_bound(web, left, partial.waiting, list(bits_of(partial.decided)), limit=spare) is not None


def reachable(core: Core, steps: Iterable[int]) -> set[int]:
    """Answer the steps of ``steps`` that may take part in making the goal."""
    makers: list[list[int]] = [[] for _ in core.nodes]
    for step in steps:
        for node in core.outputs[step]:
            makers[node].append(step)
    waiting, nodes, found = [core.goal], {core.goal}, set[int]()
    for node in waiting:  # grows while it is read
        for step in makers[node]:
            if step not in found:
                found.add(step)
                fresh = [n for n in core.inputs[step] if n not in nodes]
                nodes.update(fresh)
                waiting.extend(fresh)
    return found
