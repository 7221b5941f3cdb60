"""A tree that is being chosen: some nodes have their producer, others wait for one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from foon_kg.model.values import made_often
from foon_kg.search.core import Core


@made_often(eq=False)
class Partial:
    """``chosen`` steps, ``decided`` nodes, and the nodes ``waiting``, each with the decided nodes that depend on it.

    Sets of steps and of nodes are whole numbers, as in :class:`~foon_kg.search.core.Core`: bit 3 stands for number 3.
    As a node's producer must not depend on the node itself, the nodes above a waiting one are all that has to be known
    to keep a tree well-founded.
    """

    chosen: int
    decided: int
    waiting: dict[int, int]

    def take(self, core: Core, node: int, step: int) -> Partial:
        """Return this tree with ``step`` as the producer of the waiting ``node``, both by their numbers in ``core``."""
        waiting = dict(self.waiting)
        above = waiting.pop(node) | 1 << node
        decided = self.decided | 1 << node
        for needed in core.inputs[step]:
            if needed in waiting:
                waiting[needed] |= above
            elif decided >> needed & 1:
                # its producer is chosen already: what is above this node is now above all that waits below that one
                for other, others in waiting.items():
                    if others >> needed & 1:
                        waiting[other] = others | above
            else:
                waiting[needed] = above
        return Partial(self.chosen | 1 << step, decided, waiting)


@dataclass(frozen=True, eq=False)
class Choice:
    """Which steps may be chosen for each node. ``needed_by`` holds the nodes that each step cannot do without."""

    core: Core
    makers: Sequence[Sequence[int]]
    needed_by: Sequence[int]

    def start(self) -> Partial:
        """Return the tree in which nothing is chosen and the goal waits."""
        return Partial(0, 0, {self.core.goal: 0})

    def options(self, partial: Partial, node: int) -> list[int]:
        """Return the steps that may be chosen for a ``node`` that waits in ``partial``, all by their numbers.

        They are those that need nothing which depends on the node, or a tree would go in circles.
        """
        blocked = partial.waiting[node] | 1 << node
        return [step for step in self.makers[node] if not self.needed_by[step] & blocked]

    def forced(self, partial: Partial) -> Partial | None:
        """Return ``partial`` grown for as long as a waiting node has one option only; ``None`` where one has none."""
        while partial.waiting:
            node, options = self._tightest(partial)
            if not options:
                return None
            if len(options) > 1:
                break
            partial = partial.take(self.core, node, options[0])
        return partial

    def _tightest(self, partial: Partial) -> tuple[int, list[int]]:
        """Return the waiting node with the fewest options, and these: so a tree that cannot be is given up soonest."""
        tightest, fewest = -1, list[int]()
        for node in partial.waiting:
            options = self.options(partial, node)
            if tightest < 0 or len(options) < len(fewest):
                tightest, fewest = node, options
                if len(options) <= 1:  # nothing is tighter: take it at once, or give up
                    break
        return tightest, fewest
