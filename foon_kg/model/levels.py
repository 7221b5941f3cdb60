"""The three levels at which a FOON can be read (Paulius et al., IROS 2016 and 2018).

At level 1 an object node is its label. At level 2 it has its states as well, and where it is: a FOON file writes
``in [bowl]`` as a state. At level 3 it also has its ingredients; this is the FOON as it was annotated. Units that are
the same at a level are one unit there, seen wherever one of them was seen.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from enum import IntEnum

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant


class Level(IntEnum):
    """How much of an object node counts."""

    OBJECTS = 1
    STATES = 2
    INGREDIENTS = 3


def node_at(node: ObjectNode, level: Level) -> ObjectNode:
    """Return what is left of ``node`` at ``level``.

    >>> bowl = ObjectNode("bowl", ("used",), ("egg", "milk"))
    >>> str(node_at(bowl, Level.OBJECTS)), str(node_at(bowl, Level.STATES))
    ('bowl', 'bowl (used)')
    """
    if level is Level.INGREDIENTS:
        return node
    return ObjectNode(node.label) if level is Level.OBJECTS else replace(node, ingredients=())


@dataclass(frozen=True)
class Leveller:
    """Nodes and units as they are at ``level``.

    Nodes that become equal become one object, whose hash is worked out once.
    """

    level: Level
    _nodes: dict[ObjectNode, ObjectNode] = field(default_factory=dict)
    _distinct: dict[ObjectNode, ObjectNode] = field(default_factory=dict)

    def node(self, node: ObjectNode) -> ObjectNode:
        """Return what is left of ``node``.

        >>> str(Leveller(Level.OBJECTS).node(ObjectNode("onion", ("chopped",))))
        'onion'
        """
        if node not in self._nodes:
            found = node_at(node, self.level)
            self._nodes[node] = self._distinct.setdefault(found, found)
        return self._nodes[node]

    def unit(self, unit: FunctionalUnit) -> FunctionalUnit:
        """Return what is left of ``unit``: the same motion; object nodes that have become one count once.

        >>> side = tuple(Participant(ObjectNode("onion", (state,))) for state in ("whole", "chopped"))
        >>> len(Leveller(Level.OBJECTS).unit(FunctionalUnit(side, "mix", ())).inputs)
        1
        """
        if self.level is Level.INGREDIENTS:
            return unit
        return replace(unit, inputs=self._side(unit.inputs), outputs=self._side(unit.outputs))

    def _side(self, side: tuple[Participant, ...]) -> tuple[Participant, ...]:
        """Return the inputs or outputs of a unit; one that was several moves, or completes a dish, as any of them."""
        found: dict[ObjectNode, Participant] = {}
        for participant in side:
            node = self.node(participant.node)
            before = found.get(node)
            moving = participant.moving or (before is not None and before.moving)
            dish_type = participant.dish_type or (before.dish_type if before else None)
            found[node] = Participant(node, moving, dish_type)
        return tuple(found.values())


def units_at(units: Iterable[KnownUnit], level: Level) -> tuple[KnownUnit, ...]:
    """Return the distinct units at ``level``, sorted by key, each as its first sighting has it.

    >>> beat = FunctionalUnit((Participant(ObjectNode("egg", ("cracked",))),), "beat", ())
    >>> same = FunctionalUnit((Participant(ObjectNode("egg", ("raw",))),), "beat", ())
    >>> len(units_at([KnownUnit(beat, ()), KnownUnit(same, ())], Level.OBJECTS))
    1
    """
    if level is Level.INGREDIENTS:
        return tuple(sorted(units, key=lambda known: known.unit.key))
    groups: defaultdict[str, list[KnownUnit]] = defaultdict(list)
    leveller = Leveller(level)
    for known in units:
        unit = leveller.unit(known.unit)
        groups[unit.key].append(KnownUnit(unit, known.seen_in))
    return tuple(_merged(groups[key]) for key in sorted(groups))


def _merged(same: list[KnownUnit]) -> KnownUnit:
    """Return units that are the same at a level as one: as first seen, with the sightings of all."""
    if len(same) == 1:
        return same[0]
    first = min(same, key=lambda known: known.seen_in[:1])
    return KnownUnit(first.unit, tuple(sorted(sighting for known in same for sighting in known.seen_in)))
