"""The first part of the objective, alone: the least gap penalty, and the steps that can keep it.

Only the nodes that cannot be made without a gap matter here; that is a small part of a core, on which LM-cut is nearly
always the exact answer.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

from foon_kg.search.core import Core, bits_of
from foon_kg.search.cuts import CutBound, Web, cut_bound, heights
from foon_kg.search.forward import chain, cheapest_first
from foon_kg.search.landmarks import landmarks_of
from foon_kg.search.partial import Choice, Partial


def within_least_penalty(core: Core) -> tuple[int, list[int]] | None:
    """Answer the least gap penalty of any tree and the steps that such trees may have; ``None`` without a tree."""
    units = range(len(core.gap_nodes), core.step_count)
    order, made = chain(core, units)
    if made[core.goal]:
        return 0, order
    everything, reached = chain(core, range(core.step_count))
    if not reached[core.goal]:
        return None
    penalty, cuts = _least(_needy(core, made), _weights(core))
    gaps = {step for step, node in enumerate(core.outputs[: len(core.gap_nodes)]) if made[node[0]]}
    steps = [step for step in everything if step not in gaps]  # what can be made is never a gap in a best tree
    whole = replace(cuts, heights=heights(Web.of(core, steps), cuts.left))
    return penalty, [step for step in steps if whole.least_with(core, step) <= penalty]


def _weights(core: Core) -> list[int]:
    return [*core.costs, *[0] * len(core.units)]


def _needy(core: Core, made: list[bool]) -> Core:
    """Answer ``core`` with nothing but what needs a gap: the nodes that can be made without one count as there."""

    def needy(sides: Iterable[tuple[int, ...]]) -> tuple[tuple[int, ...], ...]:
        return tuple(tuple(node for node in side if not made[node]) for side in sides)

    return replace(core, inputs=needy(core.inputs), outputs=needy(core.outputs))


def _least(core: Core, weights: list[int]) -> tuple[int, CutBound]:
    steps: Collection[int] = reachable(core, range(core.step_count))
    best = core.penalty_of(cheapest_first(core, steps))
    while True:
        cuts = _cuts(Web.of(core, steps), weights)
        kept = reachable(core, [step for step in steps if cuts.least_with(core, step) <= best])
        if cuts.bound == best:
            return best, cuts
        if len(kept) == len(steps):
            best = _proven(core, kept, weights, best, cuts)
            return best, _sharpened(core, kept, weights, best)
        steps = kept
        best = min(best, core.penalty_of(cheapest_first(core, steps)))


def _sharpened(core: Core, steps: Collection[int], weights: list[int], penalty: int) -> CutBound:
    """Answer cuts for trees of that ``penalty`` alone: without the gaps that cost more, whatever is chosen beside."""
    while True:
        web = Web.of(core, steps)
        cuts = _cuts(web, weights)
        gaps = [step for step in web.steps if weights[step]]
        dear = {gap for gap in gaps if weights[gap] + _cuts(web, _without(weights, gap)).bound > penalty}
        if cuts.bound == penalty or not dear:
            return cuts
        steps = reachable(core, [step for step in steps if step not in dear])


def _cuts(web: Web, weights: list[int]) -> CutBound:
    cuts = cut_bound(web, weights, [web.core.goal])
    if cuts is None:
        raise AssertionError("a tree of least penalty is never thrown out")
    return cuts


def _without(weights: list[int], step: int) -> list[int]:
    return [*weights[:step], 0, *weights[step + 1 :]]


def _proven(core: Core, steps: Collection[int], weights: list[int], best: int, cuts: CutBound) -> int:
    """Answer the least penalty, at most ``best``, by branch and bound with LM-cut at every tree."""
    order, _ = chain(core, steps)
    landmarks = landmarks_of(core, order)
    web = Web.of(core, order)
    choice = Choice(core, web.makers, landmarks.nodes_of_step)
    stack = [choice.start()]
    while stack and best > cuts.bound:
        partial = choice.forced(stack.pop())
        if partial is None or _outlook(web, weights, partial) >= best:
            continue
        if not partial.waiting:
            best = core.penalty_of(partial.chosen)
            continue
        options = {node: choice.options(partial, node) for node in partial.waiting}
        node = min(options, key=lambda waiting: (len(options[waiting]), waiting))
        options[node].sort(key=lambda step: (cuts.least_with(core, step), step), reverse=True)
        stack += [partial.take(core, node, step) for step in options[node]]
    return best


def _outlook(web: Web, weights: list[int], partial: Partial) -> float:
    left = list(weights)
    for step in bits_of(partial.chosen):
        left[step] = 0
    cuts = cut_bound(web, left, partial.waiting, list(bits_of(partial.decided)))
    return float("inf") if cuts is None else web.core.penalty_of(partial.chosen) + cuts.bound


def reachable(core: Core, steps: Iterable[int]) -> set[int]:
    """Answer the steps of ``steps`` that may take part in making the goal."""
    makers = Web.of(core, steps).makers
    waiting, nodes, found = [core.goal], {core.goal}, set[int]()
    for node in waiting:  # grows while it is read
        for step in makers[node]:
            if step not in found:
                found.add(step)
                fresh = [n for n in core.inputs[step] if n not in nodes]
                nodes.update(fresh)
                waiting.extend(fresh)
    return found
