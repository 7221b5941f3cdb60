"""The first part of the objective, alone: the least gap penalty, and the steps that can keep it.

Units cost nothing here: the question is for the cheapest set of gaps with which the goal can be made. It is the
cheapest one that hits every *landmark*, a set of gaps without which the goal cannot be made; the few landmarks that
decide are found one after another, wherever the cheapest set that hits those known so far does not make the goal
(Haslum, Slaney, Thiébaux: Minimal landmarks for optimal delete-free planning, ICAPS 2012).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from foon_kg.search.core import Core, bits_of
from foon_kg.search.deadline import Deadline
from foon_kg.search.forward import chain, cheapest_first
from foon_kg.search.hitting_set import HittingSets


@dataclass(frozen=True)
class LeastPenalty:
    """The least gap ``penalty`` of any tree, and the ``steps`` that such trees may have.

    Where the time was too short it is the least found, and ``at_least`` is what is proven.
    """

    penalty: int
    at_least: int
    steps: list[int]


def within_least_penalty(core: Core, deadline: Deadline) -> LeastPenalty | None:
    """Return the least gap penalty of any tree that makes the goal of ``core``, and the steps of such trees.

    ``None`` where nothing makes it. By minimal landmarks and hitting sets (Haslum, Slaney and Thiébaux, ICAPS 2012);
    after the ``deadline`` the least penalty found stands for the proven one.
    """
    units = range(len(core.gap_nodes), core.step_count)
    order, made = chain(core, units)
    if made[core.goal]:
        return LeastPenalty(0, 0, order)
    part = needy(core, made)
    order, reached = chain(part)
    if not reached[part.goal]:
        return None
    part = part.only(reachable(part, order))
    least = _least(part, deadline)
    names = {part.names[gap] for gap in bits_of(least.possible)}
    gaps = [gap for gap in range(len(core.gap_nodes)) if core.names[gap] in names]
    order, _ = chain(core, [*gaps, *units])
    return LeastPenalty(part.penalty_of(least.cheapest), least.at_least, order)


def needy(core: Core, made: list[bool]) -> Core:
    """Return what of ``core`` needs a gap: the nodes that can be made without one count as there."""
    outputs = tuple(tuple(node for node in side if not made[node]) for side in core.outputs)
    steps = [step for step, side in enumerate(outputs) if side]
    inputs: list[tuple[int, ...]] = [()] * core.step_count
    for step in steps:
        inputs[step] = tuple(node for node in core.inputs[step] if not made[node])
    part = replace(core, inputs=tuple(inputs), outputs=outputs)
    return part.only(reachable(part, steps))


@dataclass(frozen=True)
class _Gaps:
    """The gaps of ``cheapest`` make the goal; ``possible`` are those that may be among the gaps of a tree as cheap."""

    cheapest: int
    possible: int
    at_least: int


def _least(core: Core, deadline: Deadline) -> _Gaps:
    """Return a cheapest set of gaps that makes the goal, or the cheapest one found before the deadline."""
    reach, costs = _Reach.of(core), core.costs
    best = reach.without_idle(cheapest_first(core) & ((1 << len(costs)) - 1))
    hitting_sets = HittingSets(costs, deadline)
    landmarks, hitting, at_least = list[int](), 0, 0
    while core.penalty_of(best) > at_least and not deadline.has_passed():
        while landmark := reach.landmark(hitting):
            landmarks.append(landmark)
            hitting |= 1 << min(bits_of(landmark), key=lambda gap: (costs[gap], gap))
        best = min(best, reach.without_idle(hitting), key=lambda gaps: (core.penalty_of(gaps), gaps))
        found = hitting_sets.cheapest(landmarks, core.penalty_of(best) - 1)
        if deadline.has_passed():
            break
        at_least = core.penalty_of(best if found is None else found)
        hitting = found or 0
    if core.penalty_of(best) > at_least:
        return _Gaps(best, best, at_least)
    return _Gaps(best, hitting_sets.members_of_cheapest(landmarks), at_least)


@dataclass(frozen=True, eq=False)
class _Reach:
    """What can be made with a set of gaps.

    ``users`` are the steps that take each node, ``arity`` how many inputs each step has, and ``cheap_first`` the gaps
    with their nodes.
    """

    core: Core
    users: list[list[int]]
    arity: list[int]
    cheap_first: list[tuple[int, int]]

    @classmethod
    def of(cls, core: Core) -> _Reach:
        users: list[list[int]] = [[] for _ in core.nodes]
        for step, nodes in enumerate(core.inputs):
            for node in nodes:
                users[node].append(step)
        arity = [len(nodes) for nodes in core.inputs]
        gaps = sorted(range(len(core.costs)), key=lambda gap: (core.costs[gap], gap))
        return cls(core, users, arity, [(gap, core.outputs[gap][0]) for gap in gaps])

    def landmark(self, gaps: int) -> int:
        """Return gaps outside ``gaps`` one of which is needed to make the goal, none too many; 0 where it is made.

        All others are taken, the cheap ones first, as long as they do not make the goal.
        """
        made = _Made(self, gaps)
        if made.goal:
            return 0
        landmark = 0
        for gap, node in self.cheap_first:
            if not made.has[node] and not made.take(node):
                landmark |= 1 << gap
        return landmark

    def without_idle(self, gaps: int) -> int:
        """Return ``gaps`` without those that are not needed to make the goal, the dearest first."""
        for gap in sorted(bits_of(gaps), key=lambda gap: (-self.core.costs[gap], gap)):
            if _Made(self, gaps & ~(1 << gap)).goal:
                gaps &= ~(1 << gap)
        return gaps


class _Made:
    """The nodes that some gaps make, and how many inputs each step lacks."""

    def __init__(self, reach: _Reach, gaps: int) -> None:
        self.reach = reach
        self.missing = reach.arity.copy()
        self.has = [False] * len(reach.core.nodes)
        self._spread([reach.core.outputs[gap][0] for gap in bits_of(gaps)])

    @property
    def goal(self) -> bool:
        """Whether the goal is made."""
        return self.has[self.reach.core.goal]

    def take(self, node: int) -> bool:
        """Take ``node`` as well, unless that makes the goal: False then."""
        fresh = self._spread([node])
        if not self.goal:
            return True
        for undone in fresh:
            self.has[undone] = False
            for step in self.reach.users[undone]:
                self.missing[step] += 1
        return False

    def _spread(self, nodes: Iterable[int]) -> list[int]:
        """Make ``nodes`` and all that can then be made; return what is new."""
        outputs, users, has, missing = self.reach.core.outputs, self.reach.users, self.has, self.missing
        fresh = [node for node in nodes if not has[node]]
        for node in fresh:
            has[node] = True
        for node in fresh:  # grows while it is read
            for step in users[node]:
                missing[step] -= 1
                if not missing[step]:
                    for other in outputs[step]:
                        if not has[other]:
                            has[other] = True
                            fresh.append(other)
        return fresh


def reachable(core: Core, steps: Iterable[int]) -> set[int]:
    """Return those of ``steps`` (numbers in ``core``) that may take part in making its goal."""
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
