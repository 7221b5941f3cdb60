"""From the compact rows in which units travel to the units of the model, each value made once."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from operator import itemgetter
from typing import Any

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant, Sighting
from foon_kg.store.graph.rows import KeyedNode, KnownUnitsRow, KnownUnitValue
from foon_kg.store.graph.values import measures_of, node_of, order

_SIGHTING_FIELDS = len(dataclasses.fields(Sighting))


def known_units(row: KnownUnitsRow) -> Iterator[KnownUnit]:
    """Return the units of a ``row``, in no order, each written as its first sighting has it, as the snapshot does.

    A unit that somebody removed while the database answered comes without anything, and is left out; so is a sighting
    whose edge went meanwhile and left no properties.
    """
    for unit in row.units:
        if unit[-1]:
            unit[-1][:] = [sighting for sighting in unit[-1] if sighting[_SIGHTING_FIELDS] is not None]
    there = (unit for unit in row.units if unit[0] is not None and unit[-1])
    return map(_Writing([node for node in row.nodes if node[0] is not None]).unit, there)


class _Writing:
    """The nodes of one answer in their order, and the participants made of them so far.

    The ranks on a ``SEEN_IN`` edge count among the nodes of one side in the order of :func:`order`: whoever sorts all
    nodes in it once has sorted those of every side.
    """

    def __init__(self, rows: Sequence[KeyedNode]) -> None:
        ordered = sorted(rows, key=lambda row: order(row[2:]))
        self.place = {row[0]: place for place, row in enumerate(ordered)}
        self.nodes = tuple(map(_node, ordered))
        self.participants: dict[tuple[int, bool, str], Participant] = {}

    def unit(self, value: KnownUnitValue) -> KnownUnit:
        key, verb, accepts_any, inputs, outputs, sightings = value
        sightings.sort(key=itemgetter(0, 1))
        ranks_in, moving_in, dish_in, ranks_out, moving_out, dish_out = sightings[0][_SIGHTING_FIELDS:]
        unit = FunctionalUnit(
            self._side(inputs, ranks_in, moving_in, dish_in),
            verb,
            self._side(outputs, ranks_out, moving_out, dish_out),
            accepts_any,
        )
        vars(unit)["key"] = key  # what the graph keeps it under: hashing it again takes longer than all the rest
        return KnownUnit(unit, tuple(map(_sighting, sightings)))

    def _side(
        self, numbers: Sequence[int], ranks: Sequence[int], moving: Sequence[bool], dishes: Sequence[str]
    ) -> tuple[Participant, ...]:
        places = sorted(map(self.place.__getitem__, numbers))
        columns = zip(ranks, moving, dishes, strict=True)
        return tuple(self._participant(places[rank], moves, dish) for rank, moves, dish in columns)

    def _participant(self, place: int, moves: bool, dish: str) -> Participant:  # noqa: FBT001 - the columns of one table
        found = self.participants.get((place, moves, dish))
        if found is None:
            found = self.participants[place, moves, dish] = Participant(self.nodes[place], moves, dish or None)
        return found


def _sighting(values: Sequence[Any]) -> Sighting:
    video, position, source, start, end, measures = values[:_SIGHTING_FIELDS]
    return Sighting(video, position, source, start, end, measures_of(*measures))


def _node(row: KeyedNode) -> ObjectNode:
    node = node_of(row[2:])
    vars(node)["key"] = row[1]
    return node
