"""The order of a tree's steps: everything is made before it is taken, and taken before it is moved away."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Sequence

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.script import Casting, Step

Played = tuple[Step, Casting]
"""A step and the casting that it is played with."""


def once(steps: Sequence[Played]) -> Iterator[Played]:
    """Leave out steps that were done before: the same inputs, motion and outputs."""
    seen = set()
    for step, casting in steps:
        same = (frozenset(step.input_nodes), step.motion, frozenset(step.output_nodes))
        if same not in seen:
            seen.add(same)
            yield step, casting


def fresh_order(steps: Sequence[Played]) -> tuple[Played, ...]:
    """Answer ``steps``, executable in their order, with those that move or change a node after all that only use it.

    The order is otherwise kept. Where two steps each move what the other uses, the earlier one stays earlier (sense,
    S1: nothing is taken that an earlier step took away).
    """
    before = _hard(steps)
    wishes = _soft(steps, before)
    waiting = {place: before[place] | wishes[place] for place in range(len(steps))}
    done: set[int] = set()
    order: list[int] = []
    while len(order) < len(steps):
        ready = [place for place in waiting if place not in done and waiting[place] <= done]
        if not ready:  # wishes that contradict each other: the first step that can be done gives up its own
            ready = [place for place in waiting if place not in done and before[place] <= done]
        place = min(ready)
        done.add(place)
        order.append(place)
    return tuple(steps[place] for place in order)


def _hard(steps: Sequence[Played]) -> list[set[int]]:
    """For every step the earlier ones that make what it takes (the last maker before it), or make a node anew."""
    maker: dict[ObjectNode, int] = {}
    users: dict[ObjectNode, set[int]] = {}
    before: list[set[int]] = []
    for place, (step, _) in enumerate(steps):
        needed = {maker[node] for node in step.input_nodes if node in maker}
        for node in step.output_nodes:
            if node not in step.input_nodes and node in maker:
                needed |= users.get(node, set()) | {maker[node]}  # the node as it was is taken before it is made anew
        before.append(needed - {place})
        for node in step.input_nodes:
            users.setdefault(node, set()).add(place)
        for node in step.output_nodes:
            if node not in step.input_nodes:
                users[node] = set()
            maker[node] = place
    return before


def _soft(steps: Sequence[Played], before: Sequence[set[int]]) -> list[set[int]]:
    """For every step that moves or changes a node, the others that take the same node."""
    users: dict[ObjectNode, set[int]] = {}
    for place, (step, _) in enumerate(steps):
        for node in step.input_nodes:
            users.setdefault(node, set()).add(place)
    wishes: list[set[int]] = []
    for place, (step, _) in enumerate(steps):
        left = {node.label for node in step.output_nodes}
        moved = [n for n in step.input_nodes if n.label in left and n not in step.output_nodes and not _empty(n)]
        others = {other for node in moved for other in users[node]} - {place}
        wishes.append({other for other in others if place not in before[other]})
    return wishes


def _empty(node: ObjectNode) -> bool:
    return "empty" in node.states  # an empty vessel is there again as often as it is needed


def as_recorded(units: Sequence[KnownUnit], videos: Collection[str]) -> tuple[KnownUnit, ...]:
    """Answer ``units``, executable in their order, as far as may be in the order of the goal's ``videos``.

    A unit from elsewhere goes just before the first that takes what it makes. What uses a node up waits for the others
    that take it, as :func:`foon_kg.search.schedule` has it; the last unit, which makes the goal, stays last.
    """
    if not units:
        return ()
    made = {node for known in units for node in known.unit.output_nodes}
    have = {node for known in units for node in known.unit.input_nodes if _taken_before_made(node, units, made)}
    places = _recorded_places(units, videos)
    needed = Counter(node for known in units for node in known.unit.input_nodes)
    waiting, done = list(units[:-1]), list[KnownUnit]()

    def urgency(known: KnownUnit) -> tuple[int, float, int, str]:
        used_up = set(known.unit.input_nodes) - set(known.unit.output_nodes)
        others = sum(needed[node] - 1 for node in used_up if node in made)
        return (others, *places[known.unit.key], known.unit.key)

    while waiting:
        ready = [known for known in waiting if have.issuperset(known.unit.input_nodes)]
        chosen = min(ready, key=urgency)
        waiting.remove(chosen)
        done.append(chosen)
        have.update(chosen.unit.output_nodes)
        needed.subtract(chosen.unit.input_nodes)
    return (*done, units[-1])


def _taken_before_made(node: ObjectNode, units: Sequence[KnownUnit], made: set[ObjectNode]) -> bool:
    """Say whether a node is a leaf: some unit takes it before any unit of ``units`` makes it."""
    if node not in made:
        return True
    first = next(known for known in units if node in known.unit.input_nodes or node in known.unit.output_nodes)
    return node in first.unit.input_nodes


def _recorded_places(units: Sequence[KnownUnit], videos: Collection[str]) -> dict[str, tuple[float, int]]:
    """Answer for each unit (by key) its place in the videos, or that of its first taker, and how far before it."""
    takers: dict[ObjectNode, list[str]] = {}
    for known in units:
        for node in known.unit.input_nodes:
            takers.setdefault(node, []).append(known.unit.key)
    places: dict[str, tuple[float, int]] = {}
    for known in reversed(units):
        seen = [sighting.position for sighting in known.seen_in if sighting.video in videos]
        later = (places[key] for node in known.unit.output_nodes for key in takers.get(node, ()) if key in places)
        nearest = min(((place, distance - 1) for place, distance in later), default=(float(len(units)), 0))
        places[known.unit.key] = (float(min(seen)), 0) if seen else nearest
    return places
