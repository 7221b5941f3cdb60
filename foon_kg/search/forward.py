"""Forward chaining from the kitchen: what can be made, in which order, and at what cost at most.

Well-founded derivations in a directed hypergraph: Knuth, A generalization of Dijkstra's algorithm, 1977. Here the
cost of a derivation is the *union* of its steps, as a sum would count shared parts twice; the tree found is valid, not
always best.
"""

from __future__ import annotations

from collections.abc import Collection
from heapq import heappop, heappush

from foon_kg.search.core import Core


def chain(core: Core, steps: Collection[int] | None = None) -> tuple[list[int], list[bool]]:
    """Return which steps of ``core`` can be executed, in an order in which they can, and which nodes that makes.

    Of ``steps`` (by number), of all where none are given. Forward chaining: a step runs once all of its inputs are
    made.
    """
    steps = range(core.step_count) if steps is None else steps
    users, missing = _users(core, steps)
    order = [step for step in sorted(steps) if not missing[step]]
    made = [False] * len(core.nodes)
    for step in order:  # grows while it is read
        for node in core.outputs[step]:
            if not made[node]:
                made[node] = True
                for user in users[node]:
                    missing[user] -= 1
                    if not missing[user]:
                        order.append(user)
    return order, made


def cheapest_first(core: Core) -> int:
    """Return the steps of a tree of ``core`` that makes its goal, cheap derivations first: a set of bits.

    Knuth's generalization of Dijkstra's algorithm (1977), with the union of steps as the cost. Raises ValueError when
    nothing makes the goal; :func:`chain` tells.
    """
    users, missing = _users(core, range(core.step_count))
    waiting: list[tuple[int, int, int, int]] = []
    for step in missing:
        if not missing[step]:
            _queue(waiting, core, step, 1 << step)
    derivation: dict[int, int] = {}
    while waiting:
        _, _, negated, step = heappop(waiting)
        for node in core.outputs[step]:
            if node in derivation:
                continue
            derivation[node] = -negated
            if node == core.goal:
                return -negated
            for user in users[node]:
                missing[user] -= 1
                if not missing[user]:
                    _queue(waiting, core, user, _union(core, user, derivation))
    raise ValueError("nothing makes the goal")


def _queue(waiting: list[tuple[int, int, int, int]], core: Core, step: int, steps: int) -> None:
    heappush(waiting, (core.penalty_of(steps), core.units_in(steps), -steps, step))


def _union(core: Core, step: int, derivation: dict[int, int]) -> int:
    steps = 1 << step
    for node in core.inputs[step]:
        steps |= derivation[node]
    return steps


def _users(core: Core, steps: Collection[int]) -> tuple[list[list[int]], dict[int, int]]:
    users: list[list[int]] = [[] for _ in core.nodes]
    missing = {}
    for step in steps:
        missing[step] = len(core.inputs[step])
        for node in core.inputs[step]:
            users[node].append(step)
    return users, missing
