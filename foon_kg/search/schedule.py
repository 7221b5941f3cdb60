"""The order of a tree's units: executable, and sensible to a cook."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from heapq import heappop, heappush

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.tree import used_up

Urgency = tuple[bool, int, int, int]
"""Whether a unit waits for another maker of what it takes; how many others still need what it uses up, of made things
and of others; its place by its key. The least is the most urgent."""


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
    order = (*_Queue.of(waiting, last, there).in_order(), last)
    if _each_leads_on(order):
        return order
    return (*_Queue.of(waiting, last, there).waiting_for_all_makers().in_order(), last)


@dataclass(eq=False)
class _Queue:
    """The units that wait, by number, in the order of their keys.

    ``takers`` and ``consumers`` are, for each node, the units that take it and those of them that use it up.
    ``awaited`` counts the inputs of a unit that are not there yet, ``makers`` the other units to come that make them
    too (none, unless whoever takes a node waits for all its makers), and ``needed`` how often others need what it uses
    up: made nodes, and nodes that were there. In the heap ``ready`` only the latest entry of a unit counts.
    """

    units: Sequence[KnownUnit]
    there: Collection[ObjectNode]
    takers: defaultdict[ObjectNode, list[int]]
    consumers: defaultdict[ObjectNode, list[int]]
    awaited: list[int]
    makers: list[int]
    needed: list[list[int]]
    ready: list[Urgency] = field(default_factory=list)

    @classmethod
    def of(cls, units: Sequence[KnownUnit], last: KnownUnit, there: Collection[ObjectNode]) -> _Queue:
        """Queue ``units``, sorted by their keys, before ``last``."""
        takers, consumers = defaultdict[ObjectNode, list[int]](list), defaultdict[ObjectNode, list[int]](list)
        for number, known in enumerate(units):
            for node in known.unit.input_nodes:
                takers[node].append(number)
            for node in used_up(known.unit):
                consumers[node].append(number)
        needed = [[0, 0] for _ in units]
        for node, numbers in consumers.items():
            others = len(takers[node]) - 1 + (node in last.unit.input_nodes)
            for number in numbers:
                needed[number][node in there] += others
        awaited = [sum(node not in there for node in known.unit.input_nodes) for known in units]
        return cls(units, there, takers, consumers, awaited, [0] * len(units), needed)

    def waiting_for_all_makers(self) -> _Queue:
        """Return this queue, to be asked before any unit is taken out, where no maker of a node is too late."""
        for maker, taker in self._from_maker_to_taker(range(len(self.units))):
            self.makers[taker] += maker != taker
        return self

    def in_order(self) -> list[KnownUnit]:
        """Take out all units, one after another."""
        order, done, have, fresh = list[KnownUnit](), [False] * len(self.units), set(self.there), set[int]()
        self._put(range(len(self.units)))
        while len(order) < len(self.units):
            chosen = self._next(done, fresh)
            done[chosen] = True
            order.append(self.units[chosen])
            changed = self._carry_out(chosen, have)
            fresh = {taker for _, taker in self._from_maker_to_taker([chosen]) if not done[taker]}
            self._put(number for number in changed if not done[number])
        return order

    def _carry_out(self, chosen: int, have: set[ObjectNode]) -> list[int]:
        """Count what ``chosen`` makes and needs no more; return for which units that changes anything."""
        unit, changed = self.units[chosen].unit, list[int]()
        for node in unit.input_nodes:
            for number in self.consumers[node]:
                self.needed[number][node in self.there] -= 1
                changed.append(number)
        for node in unit.output_nodes:
            for number in self.takers[node]:
                self.awaited[number] -= node not in have
                self.makers[number] -= self.makers[number] > 0 and number != chosen
                changed.append(number)
            have.add(node)
        return changed

    def _from_maker_to_taker(self, makers: Iterable[int]) -> Iterator[tuple[int, int]]:
        for maker in makers:
            for node in self.units[maker].unit.output_nodes:
                for taker in self.takers[node]:
                    yield maker, taker

    def _put(self, numbers: Iterable[int]) -> None:
        for number in numbers:
            if not self.awaited[number]:
                heappush(self.ready, self._urgency(number))

    def _urgency(self, number: int) -> Urgency:
        made, found = self.needed[number]
        return self.makers[number] > 0, made, found, number

    def _next(self, done: Sequence[bool], fresh: Iterable[int]) -> int:
        """Return the most urgent unit; of equally urgent ones the first that takes what the last one made."""
        while done[self.ready[0][-1]] or self.ready[0] != self._urgency(self.ready[0][-1]):
            heappop(self.ready)
        *urgency, first = self.ready[0]
        ready = (number for number in fresh if not self.awaited[number])
        return min((number for number in ready if [*self._urgency(number)[:-1]] == urgency), default=first)


def _each_leads_on(order: Sequence[KnownUnit]) -> bool:
    """Whether every unit but the last makes something that a later one takes."""
    taken = set(order[-1].unit.input_nodes)
    for known in reversed(order[:-1]):
        if taken.isdisjoint(known.unit.output_nodes):
            return False
        taken.update(known.unit.input_nodes)
    return True


def last_of(units: Sequence[KnownUnit], there: Collection[ObjectNode], goal: ObjectNode) -> KnownUnit | None:
    """Return the one of ``units`` that makes the ``goal`` and that no other needs; ``None`` where there is none.

    The others can all run without it from the nodes that are ``there``.
    """
    makers = (known for known in units if goal in known.unit.output_nodes)
    return next((m for m in makers if _can_all_run([known for known in units if known is not m], there)), None)


def _can_all_run(units: Sequence[KnownUnit], there: Collection[ObjectNode]) -> bool:
    takers: defaultdict[ObjectNode, list[int]] = defaultdict(list)
    awaited = [0] * len(units)
    for number, known in enumerate(units):
        for node in known.unit.input_nodes:
            if node not in there:
                takers[node].append(number)
                awaited[number] += 1
    running = [number for number, count in enumerate(awaited) if not count]
    for number in running:  # grows while it is read
        for node in units[number].unit.output_nodes:
            for taker in takers.pop(node, ()):
                awaited[taker] -= 1
                if not awaited[taker]:
                    running.append(taker)
    return len(running) == len(units)
