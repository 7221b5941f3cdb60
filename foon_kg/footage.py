"""A goal's own video as a script: for goals whose reference tree has a hole that no kitchen fills.

Annotators call one thing by two names: a brownie is put on the board with all that is in it, and cut as a brownie
without. For a search these are two nodes, and the way ends there (algorithm 3, an exact match); the video goes on.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence

from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.script import EMPTY, spot_of

ALIKE = 0.5
"""Two names of one thing have at least this share of their ingredients in common."""


def footage(
    goal: ObjectNode,
    videos: Sequence[str],
    makers: Callable[[ObjectNode], Iterable[KnownUnit]],
    at_hand: Callable[[ObjectNode], bool],
) -> tuple[KnownUnit, ...]:
    """Answer the units of the first of ``videos`` up to its ``goal``, in their order, as far as they lie behind it.

    ``makers`` answers the units that output a node; what is ``at_hand`` is not made. Where no unit of the video makes
    the goal, nothing is answered.
    """
    behind = _behind(goal, makers, at_hand)
    places = {s.position: known for known in behind for s in known.seen_in if s.video == min(videos, default="")}
    last = max((place for place, known in places.items() if goal in known.unit.output_nodes), default=-1)
    return tuple(dict.fromkeys(places[place] for place in sorted(places) if place <= last))


def _behind(
    goal: ObjectNode, makers: Callable[[ObjectNode], Iterable[KnownUnit]], at_hand: Callable[[ObjectNode], bool]
) -> Collection[KnownUnit]:
    waiting, seen = [goal], {goal}
    found: dict[KnownUnit, None] = {}  # a set that keeps its order
    for node in waiting:  # grows while it is read
        for known in makers(node):
            found[known] = None
            fresh = [other for other in known.unit.input_nodes if other not in seen and not at_hand(other)]
            seen.update(fresh)
            waiting.extend(fresh)
    return found


def same_things(units: Sequence[KnownUnit], kitchen: Kitchen) -> dict[ObjectNode, ObjectNode]:
    """Answer, for inputs that no earlier unit outputs and no kitchen has, the output that is the same by another name.

    That is one with the same label, states and place, and most of the ingredients; of several the likest, then the
    last.
    """
    made: dict[ObjectNode, int] = {}
    found: dict[ObjectNode, ObjectNode] = {}
    for place, known in enumerate(units):
        for node in known.unit.input_nodes:
            if node not in made and node not in found and not kitchen.may_be_leaf(node, known.unit.input_nodes):
                alike = [other for other in made if _alike(node, other) >= ALIKE]
                if alike:
                    found[node] = max(alike, key=lambda other: (_alike(node, other), made[other], other.sort_key))
        made.update(dict.fromkeys(known.unit.output_nodes, place))
    return found


def _alike(node: ObjectNode, other: ObjectNode) -> float:
    """Say how likely two nodes are one thing (0 to 1), by what they hold; one that says nothing may be any other."""
    if node.label != other.label or spot_of(node) != spot_of(other):
        return 0.0
    if set(node.states) - {EMPTY} != set(other.states) - {EMPTY} or not other.ingredients:
        return 0.0
    both = set(node.ingredients) | set(other.ingredients)
    return len(set(node.ingredients) & set(other.ingredients)) / len(both) if node.ingredients else ALIKE
