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
    """Yield the units of a ``row``, in no order, each written as its first sighting has it, as the snapshot does.

    Neo4j answers with what is committed at each moment: of what somebody removed while it answered come a unit without
    its properties, edges without theirs, or numbers of nodes that are not told. Such a unit, or sighting, is left out.
    """
    writing = _Writing([node for node in row.nodes if node[0] is not None])
    for unit in row.units:
        sightings = sorted((seen for seen in unit[-1] if None not in _sides_of(seen)), key=itemgetter(0, 1))
        if unit[0] is not None and sightings and writing.is_whole(unit, sightings[0]):
            yield writing.unit(unit, sightings)


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

    def is_whole(self, value: KnownUnitValue, first: Sequence[Any]) -> bool:
        """Whether the nodes of a unit are all there that its ``first`` sighting counts."""
        inputs, outputs, sides = value[3], value[4], _sides_of(first)
        counted = len(set(sides[0])) == len(inputs) and len(set(sides[3])) == len(outputs)
        return counted and self.place.keys() >= {*inputs, *outputs}

    def unit(self, value: KnownUnitValue, sightings: Sequence[Sequence[Any]]) -> KnownUnit:
        """Return a unit with its ``sightings``, the first of which it is written as."""
        key, verb, accepts_any, inputs, outputs, _ = value
        ranks_in, moving_in, dish_in, ranks_out, moving_out, dish_out = _sides_of(sightings[0])
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


def _sides_of(sighting: Sequence[Any]) -> Sequence[Any]:
    """Return the ranks, the moving ones and the dish types of the inputs, then those of the outputs."""
    return sighting[_SIGHTING_FIELDS:]


def _sighting(values: Sequence[Any]) -> Sighting:
    video, position, source, start, end, measures = values[:_SIGHTING_FIELDS]
    return Sighting(video, position, source, start, end, measures_of(*measures))


def _node(row: KeyedNode) -> ObjectNode:
    node = node_of(row[2:])
    vars(node)["key"] = row[1]
    return node
