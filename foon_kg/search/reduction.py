"""Throw out what cannot be part of the best tree, before anything is tried."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from foon_kg.search.core import Core
from foon_kg.search.forward import chain, cheapest_first
from foon_kg.search.landmarks import Landmarks, landmarks_of


@dataclass(frozen=True, eq=False)
class Reduced:
    """What is left of a core: ``makers`` of each node, the ``landmarks``, and a first tree to be bettered.

    ``behind`` holds, for each node, all steps that may take part in making it.
    """

    core: Core
    makers: list[tuple[int, ...]]
    landmarks: Landmarks
    behind: list[int]
    first_tree: int


def reduced(core: Core) -> Reduced | None:
    """Reduce ``core`` until nothing more can be thrown out; ``None`` when nothing makes its goal."""
    steps: Collection[int] = range(core.step_count)
    best: tuple[tuple[int, int, int, int], int] | None = None
    while True:
        tree = cheapest_first(core, steps)
        if tree is None:
            return None
        found = (value_of(core, tree), tree)
        best = found if best is None else min(best, found)
        order, _ = chain(core, steps)
        landmarks = landmarks_of(core, order)
        makers = _makers(core, order, landmarks, best[0][0])
        kept = _reachable(core, makers)
        if len(kept) == len(steps):
            return Reduced(core, makers, landmarks, _behind(core, makers), best[1])
        steps = kept


def value_of(core: Core, steps: int) -> tuple[int, int, int, int]:
    """Answer the place in the order of trees: penalty, overlap, units, least keys. The lesser is the better."""
    return (core.penalty_of(steps), -core.foods_of(steps).bit_count(), core.units_in(steps), -steps)


def _makers(core: Core, order: list[int], landmarks: Landmarks, penalty: int) -> list[tuple[int, ...]]:
    """Answer the steps that may be chosen for each node: within the penalty, and possible without the node itself."""
    needed = landmarks.steps_of_node[core.goal]
    makers: list[list[int]] = [[] for _ in core.nodes]
    for step in order:
        if core.penalty_of(needed | landmarks.steps_of_step[step]) <= penalty:
            for node in core.outputs[step]:
                if not landmarks.nodes_of_step[step] >> node & 1:
                    makers[node].append(step)
    return [tuple(sorted(steps)) for steps in makers]


def _reachable(core: Core, makers: list[tuple[int, ...]]) -> set[int]:
    waiting, nodes, steps = [core.goal], {core.goal}, set[int]()
    for node in waiting:  # grows while it is read
        for step in makers[node]:
            if step not in steps:
                steps.add(step)
                fresh = [n for n in core.inputs[step] if n not in nodes]
                nodes.update(fresh)
                waiting.extend(fresh)
    return steps


def _behind(core: Core, makers: list[tuple[int, ...]]) -> list[int]:
    behind = [0] * len(core.nodes)
    changed = True
    while changed:
        changed = False
        for node, steps in enumerate(makers):
            mask = 0
            for step in steps:
                mask |= 1 << step
                for needed in core.inputs[step]:
                    mask |= behind[needed]
            if mask != behind[node]:
                behind[node], changed = mask, True
    return behind
