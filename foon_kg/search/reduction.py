"""Throw out what cannot be part of the best tree, before anything is tried."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.search.core import Core, bits_of
from foon_kg.search.cuts import Web, cut_bound
from foon_kg.search.forward import chain
from foon_kg.search.landmarks import Landmarks, landmarks_of
from foon_kg.search.partial import Choice
from foon_kg.search.penalty import reachable

Value = tuple[int, int, int, int]
"""(penalty, minus overlap, units, minus the set of steps): the whole order between trees, the lesser the better."""


@dataclass(frozen=True, eq=False)
class Reduced:
    """What is left of a core: for each node its possible makers, and what every way of making it needs.

    ``behind`` holds, for each node, all steps that may take part in making it, ``around`` all nodes of these steps and
    ``foods`` the wanted foods that occur in them. ``penalty`` is the least there is.
    """

    core: Core
    penalty: int
    web: Web
    choice: Choice
    landmarks: Landmarks
    behind: list[int]
    around: list[int]
    foods: list[int]

    @classmethod
    def of(cls, core: Core, penalty: int, steps: Collection[int]) -> Reduced:
        """Return what may be in a tree of ``core`` that has only ``steps`` and that ``penalty``, numbered anew."""
        while True:
            core = core.only(reachable(core, steps))
            order, _ = chain(core)
            landmarks = landmarks_of(core, order)
            choice = Choice(core, _makers(core, order, landmarks, penalty), landmarks.nodes_of_step)
            steps = _chosen_from(choice)
            if len(steps) == core.step_count:
                return cls(core, penalty, Web.of(core), choice, landmarks, *_behind(choice))

    def wanting(self, foods: tuple[int, ...]) -> Reduced:
        """Return the same with these wanted ``foods`` of the steps, one bit a food.

        Which trees there are does not turn on them.
        """
        core = replace(self.core, foods=foods)
        found = {mask: core.foods_of(mask) for mask in set(self.behind)}
        return replace(self, core=core, foods=[found[mask] for mask in self.behind])

    def without_longer_than(self, units: int) -> Reduced:
        """Reduce further to what may be in a tree of at most so many units; ValueError where none is so short."""
        needed = self.landmarks.steps_of_node[self.core.goal]
        spare = units - self.core.units_in(needed)
        cuts = cut_bound(self.web, self.unit_weights(needed), [self.core.goal], limit=spare)
        if cuts is None:
            raise ValueError(f"no tree has at most {units} units")
        kept = [step for step in range(self.core.step_count) if cuts.least_with(self.core, step) <= spare]
        if len(kept) == self.core.step_count:
            return self
        return Reduced.of(self.core, self.penalty, kept).without_longer_than(units)

    @property
    def gaps_are_settled(self) -> bool:
        """Whether the gaps that every tree needs make up the whole penalty."""
        return self.core.penalty_of(self.landmarks.steps_of_node[self.core.goal]) == self.penalty

    def gap_weights(self, paid: int) -> list[int]:
        """Return the weight of each step: of a gap its cost, of units and of the steps in ``paid`` (bits) nothing."""
        weights = [*self.core.costs, *[0] * len(self.core.units)]
        for step in bits_of(paid & ((1 << len(self.core.costs)) - 1)):
            weights[step] = 0
        return weights

    def unit_weights(self, paid: int) -> list[int]:
        """Return the weight of each step where units count one, and gaps and the steps in ``paid`` (bits) nothing."""
        weights = [0] * len(self.core.gap_nodes) + [1] * len(self.core.units)
        for step in bits_of(paid):
            weights[step] = 0
        return weights


def value_of(core: Core, steps: int) -> Value:
    """Return the place of the tree ``steps`` (bits) of ``core`` in the order of trees, the lesser the better.

    It is (gap penalty, minus the overlap, units, minus the set): the objective of algorithm 3, then the least keys.
    """
    return (core.penalty_of(steps), -core.foods_of(steps).bit_count(), core.units_in(steps), -steps)


def _makers(core: Core, order: list[int], landmarks: Landmarks, penalty: int) -> list[list[int]]:
    """Return the steps that may be chosen for each node: within the penalty, and possible without the node itself."""
    needed = landmarks.steps_of_node[core.goal]
    makers: list[list[int]] = [[] for _ in core.nodes]
    for step in sorted(order):
        if core.penalty_of(needed | landmarks.steps_of_step[step]) <= penalty:
            for node in core.outputs[step]:
                if not landmarks.nodes_of_step[step] >> node & 1:
                    makers[node].append(step)
    return makers


def _chosen_from(choice: Choice) -> set[int]:
    waiting, nodes, steps = [choice.core.goal], {choice.core.goal}, set[int]()
    for node in waiting:  # grows while it is read
        steps.update(choice.makers[node])
        for step in choice.makers[node]:
            fresh = [n for n in choice.core.inputs[step] if n not in nodes]
            nodes.update(fresh)
            waiting.extend(fresh)
    return steps


def _behind(choice: Choice) -> tuple[list[int], list[int], list[int]]:
    """Return, for each node, the steps that may take part in making it, their nodes and their foods."""
    core = choice.core
    behind = _steps_behind(choice)
    masks = [_mask((*core.inputs[step], *core.outputs[step])) for step in range(core.step_count)]
    distinct = {mask: _nodes_of(masks, mask) for mask in set(behind)}
    foods = {mask: core.foods_of(mask) for mask in distinct}
    return behind, [distinct[mask] for mask in behind], [foods[mask] for mask in behind]


def _steps_behind(choice: Choice) -> list[int]:
    """Return, for each node, the steps that may take part in making it, one bit a step."""
    inputs = choice.core.inputs
    behind = [_mask(makers) for makers in choice.makers]
    needs = [{node for step in makers for node in inputs[step]} for makers in choice.makers]
    changed = True
    while changed:
        changed = False
        for node, needed in enumerate(needs):
            mask = behind[node]
            for one in needed:
                mask |= behind[one]
            if mask != behind[node]:
                behind[node], changed = mask, True
    return behind


def _nodes_of(masks: Sequence[int], steps: int) -> int:
    """Return the nodes of a set of ``steps``, of which ``masks`` has those of each: all one bit a node or step."""
    nodes = 0
    for step in bits_of(steps):
        nodes |= masks[step]
    return nodes


def _mask(numbers: Iterable[int]) -> int:
    mask = 0
    for number in numbers:
        mask |= 1 << number
    return mask
