"""What a search leaves out because it knows no moving away: units that make anew what an earlier unit changed.

For a search (algorithm 3) a node that was made once is there for good: a griddle that was closed may be turned off as
the open griddle that it was before. A cook opens it first, and so does FOON.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from foon_kg.kitchen import Kitchen
from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode


def restored(
    script: Sequence[KnownUnit], makers: Callable[[ObjectNode], Iterable[KnownUnit]], kitchen: Kitchen
) -> tuple[KnownUnit, ...]:
    """Answer ``script`` with units of FOON put in before each unit that would take a node as it was before (sense, S1).

    ``makers`` answers the units that output a node, in an order of their own (C9). Put in is the first that needs
    nothing but what stands there fresh, and changes nothing that a later unit takes; where there is none, the script
    stays as it is.
    """
    done: list[KnownUnit] = []
    fresh: set[ObjectNode] = set()
    stale: set[ObjectNode] = set()
    for place, known in enumerate(script):
        for node in known.unit.input_nodes:
            if node in stale:
                later = {other for after in script[place:] for other in after.unit.input_nodes}
                maker = next((m for m in makers(node) if m not in script and _fits(m.unit, fresh, later)), None)
                if maker is not None:
                    done.append(maker)
                    _happened(maker.unit, fresh, stale, kitchen)
        done.append(known)
        _happened(known.unit, fresh, stale, kitchen)
    return tuple(done)


def _fits(unit: FunctionalUnit, fresh: set[ObjectNode], later: set[ObjectNode]) -> bool:
    changed = set(unit.input_nodes) - set(unit.output_nodes)
    return fresh.issuperset(unit.input_nodes) and changed.isdisjoint(later)


def _happened(unit: FunctionalUnit, fresh: set[ObjectNode], stale: set[ObjectNode], kitchen: Kitchen) -> None:
    """Keep in mind what stands there now, and which foods and filled vessels are another node now.

    An empty utensil that the outputs do not name stood by and is still there.
    """
    left = {node.label for node in unit.output_nodes}
    for node in unit.input_nodes:
        holds_food = kitchen.is_food(node) or bool(kitchen.foods_in(node))
        if node not in unit.output_nodes and node.label in left:
            fresh.discard(node)
            if holds_food:
                stale.add(node)
        elif not holds_food:
            fresh.add(node)
    fresh.update(unit.output_nodes)
    stale.difference_update(unit.output_nodes)
