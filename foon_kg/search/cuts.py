"""A lower bound on the sum of weights of any tree: LM-cut.

Every tree has a step of every *cut* between the start and the goal. Cuts are taken one after another, each pays its
cheapest step, and its steps get that much cheaper; what was paid is a lower bound (Helmert, Domshlak: Landmarks,
critical paths and abstractions, ICAPS 2009). What is left of the weights tells which steps no good tree can have.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush

from foon_kg.model.values import made_often
from foon_kg.search.core import Core

_FREE = -1  # the supporter of a step that needs nothing
_NEVER = -2  # and of one that cannot be executed


@dataclass(frozen=True, eq=False)
class Web:
    """A core with, for each node, the steps that take and that make it; ``arity`` counts the inputs of each step.

    The last of ``users``, which -1 finds, are the steps that need nothing.
    """

    core: Core
    users: list[list[int]]
    makers: list[list[int]]
    arity: list[int]

    @classmethod
    def of(cls, core: Core) -> Web:
        """Return the web of ``core``."""
        users: list[list[int]] = [[] for _ in core.nodes]
        makers: list[list[int]] = [[] for _ in core.nodes]
        for step, nodes in enumerate(core.inputs):
            for node in nodes:
                users[node].append(step)
        for step, nodes in enumerate(core.outputs):
            for node in nodes:
                makers[node].append(step)
        arity = [len(nodes) for nodes in core.inputs]
        users.append([step for step, count in enumerate(arity) if not count])
        return cls(core, users, makers, arity)


@made_often(eq=False)
class Heights:
    """How much a node costs at least, infinite where nothing makes it; and the dearest input of each step."""

    of_node: list[float]
    supporter: list[int]


@made_often(eq=False)
class CutBound:
    """``bound``: what any tree weighs at least. ``left``: the weights after that. ``heights``: by these weights."""

    bound: int
    left: list[int]
    heights: Heights

    def least_with(self, core: Core, step: int) -> float:
        """Return what any tree of ``core`` that has ``step`` weighs at least, infinite where there is none."""
        dearest: float = 0  # an integer as long as it is finite: sums of efforts need every digit
        of_node = self.heights.of_node
        for node in core.inputs[step]:
            height = of_node[node]
            dearest = max(dearest, height)
        return dearest if dearest == math.inf else self.bound + self.left[step] + dearest


def heights(web: Web, weights: Sequence[int], there: Collection[int] = ()) -> Heights:
    """Return the heights of all nodes of ``web``: the dearest input of a step counts, and the cheapest maker of a node.

    ``weights`` are those of the steps by number; the nodes ``there`` are free. This is h^max (Bonet and Geffner:
    Planning as heuristic search, 2001), by Dijkstra's algorithm.
    """
    of_node = _at_once(web, weights, there)
    supporter = [_NEVER] * len(web.arity)
    for step in web.users[_FREE]:
        supporter[step] = _FREE
    waiting = [(height, node) for node, height in enumerate(of_node) if height != math.inf]
    heapify(waiting)
    found = Heights(of_node, supporter)
    _climb(web, weights, found, waiting)
    return found


def _climb(web: Web, weights: Sequence[int], found: Heights, waiting: list[tuple[float, int]]) -> None:
    """Raise ``found`` from the heights in the heap ``waiting``, which need no other node, to those of all nodes."""
    # searches spend most of their time here: no calls, and locals for all that is read
    outputs, users, of_node, supporter = web.core.outputs, web.users, found.of_node, found.supporter
    missing = web.arity.copy()
    while waiting:
        height, lowest = heappop(waiting)
        if height > of_node[lowest]:
            continue
        level = [lowest]
        for node in level:  # grows while it is read: most steps cost nothing and stay on the level
            for step in users[node]:
                missing[step] -= 1
                if missing[step]:
                    continue
                supporter[step], cost = node, height + weights[step]
                for made in outputs[step]:
                    if cost < of_node[made]:
                        of_node[made] = cost
                        if cost > height:
                            heappush(waiting, (cost, made))
                        else:
                            level.append(made)


def _at_once(web: Web, weights: Sequence[int], there: Collection[int]) -> list[float]:
    """Return how much a node costs at least by a single step that needs nothing."""
    of_node: list[float] = [math.inf] * len(web.core.nodes)
    for node in there:
        of_node[node] = 0
    for step in web.users[_FREE]:
        for node in web.core.outputs[step]:
            of_node[node] = min(of_node[node], weights[step])
    return of_node


def lower(web: Web, weights: Sequence[int], found: Heights, cheaper: Sequence[int]) -> None:
    """Bring the heights ``found`` up to date where the steps ``cheaper`` have lesser ``weights`` than before.

    Only what falls is looked at in ``web``: few heights do.
    """
    inputs, outputs, users = web.core.inputs, web.core.outputs, web.users
    of_node, supporter = found.of_node, found.supporter
    waiting: list[tuple[float, int]] = []

    def make(step: int, dearest: float) -> None:
        cost = dearest + weights[step]
        for made in outputs[step]:
            if cost < of_node[made]:
                of_node[made] = cost
                heappush(waiting, (cost, made))

    for step in cheaper:
        make(step, of_node[supporter[step]] if supporter[step] >= 0 else 0)
    while waiting:
        height, node = heappop(waiting)
        if height > of_node[node]:
            continue
        for step in users[node]:
            if supporter[step] == node:
                dearest = max(inputs[step], key=of_node.__getitem__)
                supporter[step] = dearest
                make(step, of_node[dearest])


def cut_bound(
    web: Web,
    weights: Sequence[int],
    goals: Collection[int],
    there: Collection[int] = (),
    *,
    limit: float = math.inf,
) -> CutBound | None:
    """Return what making all of ``goals`` weighs at least where the nodes ``there`` are free, and what that leaves.

    The LM-cut heuristic (Helmert and Domshlak, ICAPS 2009): each cut of ``web`` pays the least of its ``weights``.
    ``None`` when nothing makes them, or when the bound is more than ``limit``. That is often plain before all cuts are
    taken: a cut lowers the height of the dearest goal by no more than its price, so that the bound comes to at least
    what was paid and the height that is left.
    """
    left, paid = list(weights), 0
    found = heights(web, left, there)
    of_node = found.of_node
    while True:
        dearest = max(goals, key=of_node.__getitem__)
        height = of_node[dearest]
        if height == math.inf or paid + height > limit:
            return None
        if height <= 0:
            return CutBound(paid, left, found)
        cut = _cut(web, left, found, dearest, there)
        price = min([left[step] for step in cut])
        paid += price
        for step in cut:
            left[step] -= price
        lower(web, left, found, cut)


def _cut(web: Web, left: Sequence[int], found: Heights, goal: int, there: Collection[int]) -> list[int]:
    """Return the steps that lead from what the start reaches into what reaches the goal for nothing."""
    zone = _zone(web, left, found, goal)
    cut, reached, outputs = list[int](), set(there), web.core.outputs
    waiting = [_FREE, *there]
    for node in waiting:  # grows while it is read
        for step in web.users[node]:
            if found.supporter[step] != node:
                continue
            leads_in = False
            for made in outputs[step]:
                if made in zone:
                    leads_in = True
                elif made not in reached:
                    reached.add(made)
                    waiting.append(made)
            if leads_in:
                cut.append(step)
    return cut


def _zone(web: Web, left: Sequence[int], found: Heights, goal: int) -> set[int]:
    """Return the nodes from which steps that cost nothing any more lead to ``goal``."""
    zone, waiting = {goal}, [goal]
    for node in waiting:  # grows while it is read
        for step in web.makers[node]:
            supporter = found.supporter[step]
            if supporter >= 0 and not left[step] and supporter not in zone:
                zone.add(supporter)
                waiting.append(supporter)
    return zone
