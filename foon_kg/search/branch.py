"""Branch and bound over "which producer for the next needed node", with proof."""

from __future__ import annotations

import time
from dataclasses import dataclass, field

from foon_kg.search.core import bits_of
from foon_kg.search.problem import Bound, weakest
from foon_kg.search.reduction import Reduced, value_of

Value = tuple[int, int, int, int]
State = tuple[int, int, dict[int, int]]
"""(steps chosen, nodes decided, open nodes each with the set of decided nodes that depend on it)."""

_CLOCK_EVERY = 64


@dataclass(eq=False)
class Search:
    """The state of one search: the best tree so far, and what is still to be tried."""

    reduced: Reduced
    deadline: float | None
    best: int = 0
    value: Value = (0, 0, 0, 0)
    tried: int = 0
    seen: dict[object, Value] = field(default_factory=dict)
    untried: list[State] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.best = self.reduced.first_tree
        self.value = value_of(self.reduced.core, self.best)

    def run(self) -> bool:
        """Search on until the best is proven (True) or the deadline has passed (False)."""
        core = self.reduced.core
        stack: list[State] = [(0, 0, {core.goal: 0})]
        while stack:
            self.tried += 1
            if self.deadline is not None and self.tried % _CLOCK_EVERY == 0 and time.monotonic() > self.deadline:
                self.untried = stack
                return False
            stack.extend(self._expand(stack.pop()))
        return True

    def bound(self) -> Bound:
        """Answer what no tree can be better than: the best found, or anything still to be tried."""
        core, bounds = self.reduced.core, [Bound(self.value[0], -self.value[1], self.value[2])]
        for chosen, _, waiting in self.untried:
            needed, behind = self._outlook(chosen, waiting)
            overlap = core.foods_of(needed | behind).bit_count()
            bounds.append(Bound(core.penalty_of(needed), overlap, core.units_in(needed)))
        return weakest(bounds)

    def _expand(self, state: State) -> list[State]:
        chosen, decided, waiting = state
        core = self.reduced.core
        waiting = dict(waiting)
        while waiting:
            node, options = self._most_forced(waiting)
            if len(options) != 1:
                break
            chosen, decided = self._take(chosen, decided, waiting, node, options[0])
        if not waiting:
            value = value_of(core, chosen)
            if value < self.value:
                self.best, self.value = chosen, value
            return []
        if not options:
            return []
        needed, behind = self._outlook(chosen, waiting)
        if self._hopeless(needed, behind) or self._seen_better(chosen, decided, waiting, behind):
            return []
        children = []
        options.sort(key=lambda step: self._promise(step, needed), reverse=True)
        for step in options:
            child = dict(waiting)
            children.append((*self._take(chosen, decided, child, node, step), child))
        return children

    def _outlook(self, chosen: int, waiting: dict[int, int]) -> tuple[int, int]:
        """Answer the steps that every tree from here has, and all that any may have beside those chosen."""
        needed, behind = chosen, 0
        for node in waiting:
            needed |= self.reduced.landmarks.steps_of_node[node]
            behind |= self.reduced.behind[node]
        return needed, behind

    def _promise(self, step: int, needed: int) -> tuple[int, int, int, int]:
        core = self.reduced.core
        extra = self.reduced.landmarks.steps_of_step[step] & ~needed
        gain = core.foods_of(extra | needed).bit_count()
        return core.penalty_of(extra), -gain, core.units_in(extra), -step

    def _most_forced(self, waiting: dict[int, int]) -> tuple[int, list[int]]:
        best_node, best_options = -1, list[int]()
        for node, above in waiting.items():
            blocked = above | 1 << node
            nodes_of = self.reduced.landmarks.nodes_of_step
            options = [step for step in self.reduced.makers[node] if not nodes_of[step] & blocked]
            if best_node < 0 or len(options) < len(best_options):
                best_node, best_options = node, options
                if len(options) <= 1:
                    break
        return best_node, best_options

    def _take(self, chosen: int, decided: int, waiting: dict[int, int], node: int, step: int) -> tuple[int, int]:
        above = waiting.pop(node) | 1 << node
        decided |= 1 << node
        for needed in self.reduced.core.inputs[step]:
            if needed in waiting:
                waiting[needed] |= above
            elif decided >> needed & 1:
                for other, others in waiting.items():
                    if others >> needed & 1:
                        waiting[other] = others | above
            else:
                waiting[needed] = above
        return chosen | 1 << step, decided

    def _hopeless(self, needed: int, behind: int) -> bool:
        core = self.reduced.core
        penalty, overlap, units, steps = self.value
        least = core.penalty_of(needed)
        if least != penalty:
            return least > penalty
        most = -core.foods_of(needed | behind).bit_count()
        if most != overlap:
            return most > overlap
        fewest = core.units_in(needed)
        if fewest != units:
            return fewest > units
        return -needed >= steps

    def _seen_better(self, chosen: int, decided: int, waiting: dict[int, int], behind: int) -> bool:
        core = self.reduced.core
        relevant = 0
        for step in bits_of(behind):
            for node in core.inputs[step]:
                relevant |= 1 << node
            for node in core.outputs[step]:
                relevant |= 1 << node
        foods = core.foods_of(chosen)
        key = (
            frozenset((node, above & relevant) for node, above in waiting.items()),
            decided & relevant,
            chosen & behind,
            foods,
        )
        value = (core.penalty_of(chosen), 0, core.units_in(chosen), -chosen)
        before = self.seen.get(key)
        if before is not None and before <= value:
            return True
        self.seen[key] = value
        return False
