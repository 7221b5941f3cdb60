"""Which steps of a task tree have to wait for which: the partial order behind the order of execution.

A step waits for an earlier one as an instruction of a program waits for another: it takes what that one makes, it
makes or uses up what that one takes, or both make the same thing. A plan says of every node which thing it is; of other
trees a thing is what its node says. And nothing is heated before what is prepared cold is ready. Everything else may be
done side by side.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field

from foon_kg.food import motions, tables
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Step

_Thing = ObjectNode | int
"""What tells a thing from others: its number, or in a tree without numbers its node."""


def earlier_steps(units: Sequence[Step]) -> tuple[frozenset[int], ...]:
    """Return for every unit (in the order of execution) the places of the units that have to be done before it.

    What lies in the kitchen may be taken by several steps: there is more than one onion. What a unit made is used up
    by a unit that takes it and does not put it out again; whoever else takes it does so in the order of execution.
    """
    things = _Things()
    prepared: set[int] = set()
    before: list[frozenset[int]] = []
    for place, unit in enumerate(units):
        waits = things.through(place, unit)
        if unit.phase == "prepare":
            prepared.add(place)
        elif unit.phase == "heat":
            waits |= prepared
        before.append(frozenset(waits - {place}))
    return tuple(waits | _ready_for(place, units, before) for place, waits in enumerate(before))


@dataclass
class _Things:
    """What the steps so far made, by the last one that did so, and which of them took it since."""

    made_by: dict[_Thing, int] = field(default_factory=dict)
    taken_by: defaultdict[_Thing, list[int]] = field(default_factory=lambda: defaultdict(list))

    def through(self, place: int, unit: Step) -> set[int]:
        """Return the steps for whose things the one at ``place`` waits, and let these be as ``unit`` leaves them."""
        taken = {one.identity for one in unit.inputs}
        made = {one.identity for one in set(unit.outputs) - set(unit.inputs)}  # what stays as it is was only held
        put_out = {one.identity for one in unit.outputs}
        used_up = {thing for thing in taken if thing in self.made_by and thing not in put_out}
        waits = {self.made_by[thing] for thing in taken | made if thing in self.made_by}
        waits.update(*(self.taken_by[thing] for thing in made | used_up))  # who takes it before has to be through
        self._leave(place, taken, made, used_up)
        return waits

    def _leave(self, place: int, taken: set[_Thing], made: set[_Thing], used_up: set[_Thing]) -> None:
        """Keep what the step at ``place`` has ``taken`` and ``made``, and what of the former it has ``used_up``."""
        for thing in taken:
            self.taken_by[thing].append(place)
        for thing in made:
            self.made_by[thing], self.taken_by[thing] = place, []
        for thing in used_up:
            self.made_by[thing] = place  # the next to take it comes after this one


def _ready_for(place: int, units: Sequence[Step], before: Sequence[frozenset[int]]) -> frozenset[int]:
    """Return what has to be done before the appliance that a unit turns on is used, as far as the tree has it earlier.

    An oven is hot before anything is put into it; what only moves (a mixer) would run for nothing meanwhile.
    """
    if not motions.switches_on(units[place].motion):
        return frozenset()
    running = {one.identity for one in units[place].outputs if _only_moves(one.node.label)}
    later = range(place + 1, len(units))
    user = next((i for i in later if not running.isdisjoint(one.identity for one in units[i].inputs)), None)
    return frozenset() if user is None else frozenset(earlier for earlier in before[user] if earlier < place)


def _only_moves(label: str) -> bool:
    row = tables().utensil(label)
    return row is not None and row.role == "appliance" and row.source == "power"
