"""What every derivation needs: the landmarks of each node and step.

A landmark of a node is a node or a step that occurs in every well-founded derivation of it: the greatest solution of
``of(node) = {node} + what all its producers share`` and ``of(step) = {step} + everything that any input needs``
(Keyder, Richter, Helmert: Sound and complete landmarks for and/or graphs, ECAI 2010). They are lower bounds, and they
tell which producer of a node cannot be made without that node.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from foon_kg.search.core import Core


@dataclass(frozen=True, eq=False)
class Landmarks:
    """For each node and each step, the set of the steps and the set of the nodes that it cannot do without."""

    steps_of_node: list[int]
    nodes_of_node: list[int]
    steps_of_step: list[int]
    nodes_of_step: list[int]


def landmarks_of(core: Core, order: Sequence[int]) -> Landmarks:
    """Return the landmarks of ``core`` among the steps of ``order`` (numbers), in which they can be executed.

    The greatest fixed point of Keyder, Richter and Helmert (ECAI 2010), see above.
    """
    width = len(core.nodes)
    of_node, of_step = _fixed_point(core, order)
    low = (1 << width) - 1
    return Landmarks(
        steps_of_node=[mask >> width for mask in of_node],
        nodes_of_node=[mask & low for mask in of_node],
        steps_of_step=[mask >> width for mask in of_step],
        nodes_of_step=[mask & low for mask in of_step],
    )


def _fixed_point(core: Core, order: Sequence[int]) -> tuple[list[int], list[int]]:
    """Return the landmarks of the nodes and of the steps as masks: nodes in the low bits, steps above them."""
    width = len(core.nodes)
    of_node, of_step = [0] * width, [0] * core.step_count
    changed = True
    while changed:
        changed = False
        for step in order:
            needs = 1 << (width + step)
            for node in core.inputs[step]:
                needs |= of_node[node]
            if needs == of_step[step]:
                continue
            of_step[step], changed = needs, True
            for node in core.outputs[step]:
                before = of_node[node]
                of_node[node] = 1 << node | (before & needs if before else needs)
    return of_node, of_step
