"""The order of a tree's units: executable, and sensible to a cook."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Sequence

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode


def schedule(units: Iterable[KnownUnit], there: Collection[ObjectNode], goal: ObjectNode) -> tuple[KnownUnit, ...]:
    """Order ``units`` so that every input of one is in ``there`` or an output of an earlier one, the goal's maker last.

    Among the units that can run, one that uses a node up (takes it and does not put it out again as it was) waits for
    the others that need it; nodes made in the tree count before those that were there. Then the one goes first that
    goes on from the unit before it, and at last the one with the least key: the order depends on the units alone.

    A node that two units of the tree make is as a rule there with the first; where that leaves the second without any
    use, whoever takes the node waits for both.

    Raises ValueError when no order exists.
    """
    waiting = sorted(units, key=lambda known: known.unit.key)
    if not waiting:
        return ()
    last = last_of(waiting, there, goal)
    if last is None:
        raise ValueError(f"no order of {len(waiting)} units ends with one that makes {goal}")
    waiting.remove(last)
    order = (*_ordered(waiting, last, there, _ready), last)
    return order if _each_leads_on(order) else (*_ordered(waiting, last, there, _ready_for_all), last)


Ready = Callable[[Sequence[KnownUnit], set[ObjectNode]], list[KnownUnit]]


def _ordered(
    units: Sequence[KnownUnit], last: KnownUnit, there: Collection[ObjectNode], ready: Ready
) -> list[KnownUnit]:
    needed = Counter(node for known in (*units, last) for node in known.unit.input_nodes)
    waiting, have, done, fresh = list(units), set(there), list[KnownUnit](), set[ObjectNode]()

    def urgency(known: KnownUnit) -> tuple[int, int, bool, str]:
        others = {node: needed[node] - 1 for node in used_up(known.unit)}
        made = sum(count for node, count in others.items() if node not in there)
        return (made, sum(others.values()) - made, fresh.isdisjoint(known.unit.input_nodes), known.unit.key)

    while waiting:
        chosen = min(ready(waiting, have), key=urgency)
        waiting.remove(chosen)
        done.append(chosen)
        fresh = set(chosen.unit.output_nodes)
        have.update(fresh)
        needed.subtract(chosen.unit.input_nodes)
    return done


def _each_leads_on(order: Sequence[KnownUnit]) -> bool:
    """Whether every unit but the last makes something that a later one takes."""
    taken = set(order[-1].unit.input_nodes)
    for known in reversed(order[:-1]):
        if taken.isdisjoint(known.unit.output_nodes):
            return False
        taken.update(known.unit.input_nodes)
    return True


def used_up(unit: FunctionalUnit) -> list[ObjectNode]:
    """Answer the nodes that ``unit`` takes and does not leave as they were: moved, changed, or gone into another."""
    left = set(unit.output_nodes)
    return [node for node in unit.input_nodes if node not in left]


def _ready(waiting: Iterable[KnownUnit], have: set[ObjectNode]) -> list[KnownUnit]:
    return [known for known in waiting if have.issuperset(known.unit.input_nodes)]


def _ready_for_all(waiting: Sequence[KnownUnit], have: set[ObjectNode]) -> list[KnownUnit]:
    """Answer the units that can run and that wait for no other maker of what they take; where all wait, any of them."""
    ready = _ready(waiting, have)
    to_come = [(known, node) for known in waiting for node in known.unit.output_nodes]
    patient = [k for k in ready if not any(k is not other and node in k.unit.input_nodes for other, node in to_come)]
    return patient or ready


def last_of(units: Sequence[KnownUnit], there: Collection[ObjectNode], goal: ObjectNode) -> KnownUnit | None:
    """Answer the unit that makes the goal and that no other needs, or ``None``: the others can all run without it."""
    makers = (known for known in units if goal in known.unit.output_nodes)
    return next((m for m in makers if _can_all_run([known for known in units if known is not m], there)), None)


def _can_all_run(units: Sequence[KnownUnit], there: Collection[ObjectNode]) -> bool:
    have, waiting = set(there), list(units)
    while waiting:
        ready = _ready(waiting, have)
        if not ready:
            return False
        have.update(node for known in ready for node in known.unit.output_nodes)
        waiting = [known for known in waiting if known not in ready]
    return True
