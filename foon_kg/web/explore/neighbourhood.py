"""What stands around a thing: some edges far, never more than a bound, what matters most first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, zip_longest
from typing import TypeVar

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.web.explore.network import NO_FILTERS, Edge, Filters, Network, Thing, ThingKind, grouped

T = TypeVar("T")

_NEAR = 0.6
"""So much of the room is for what is next to the thing itself, where more than that is asked for."""


@dataclass(frozen=True)
class Neighbourhood:
    """A thing (the first of ``things``) and what is around it, nearest first.

    ``edges`` are all among them and what was shown before. ``more`` says of each how many neighbours are not shown.
    """

    things: tuple[Thing, ...]
    edges: tuple[Edge, ...]
    more: dict[str, int]


class Neighbours:
    """Who stands next to whom in a network."""

    def __init__(self, network: Network) -> None:
        self.network = network
        self._next_to: dict[ThingKind, Callable[[Thing, Filters], Iterable[str]]] = {
            "food": self._of_name,
            "utensil": self._of_name,
            "object": self._of_object,
            "step": self._of_step,
            "motion": self._of_motion,
            "video": self._of_video,
            "dish": self._of_dish,
        }

    def around(
        self, name: str, filters: Filters = NO_FILTERS, *, depth: int = 1, most: int = 30, shown: Collection[str] = ()
    ) -> Neighbourhood:
        """Return the thing with the id ``name`` and at most ``most`` new ones, at most ``depth`` edges away.

        Only steps that pass ``filters`` count. ``shown`` are the ids of what is in the picture already: it does not use
        up the bound. What this FOON does not have of it is passed over. Raises UnknownError where it does not have
        ``name``.
        """
        centre = self.network.thing(name)
        there = {id_: self.network.thing(id_) for id_ in shown if self.network.has(id_)} | {name: centre}
        found, level = {name: centre}, [centre]
        for left in range(depth, 0, -1):
            room = most if left == 1 else round(most * _NEAR)
            level = self._beyond(level, filters, found, there, room)
            most -= sum(thing.id not in there for thing in level)
            found |= {thing.id: thing for thing in level}
            there |= {thing.id: thing for thing in level}
        return Neighbourhood(tuple(found.values()), self.edges(there), self._more(there, filters))

    def _beyond(
        self,
        level: Sequence[Thing],
        filters: Filters,
        found: Collection[str],
        there: Collection[str],
        room: int,
    ) -> list[Thing]:
        """Return what is next to those of a ``level`` and not yet ``found``; of what is not ``there`` so many at most.

        What joins most of them comes first, then the first of each, the second of each, and so on.
        """
        beside = list(_in_turns([self.next_to(thing, filters) for thing in level]))
        if len(found) > 1:  # what is far away is of the same videos and types, which say nothing there
            beside = [thing for thing in beside if thing.kind not in {"video", "dish"}]
        joined = Counter(thing.id for thing in beside)
        distinct = {thing.id: thing for thing in beside if thing.id not in found}
        return _with_room(sorted(distinct.values(), key=lambda thing: -joined[thing.id]), there, room)

    def next_to(self, thing: Thing, filters: Filters = NO_FILTERS) -> list[Thing]:
        """Return the neighbours of one thing that ``filters`` let through, what matters most first."""
        return [self.network.thing(name) for name in dict.fromkeys(self._next_to[thing.kind](thing, filters))]

    def edges(self, ids: Collection[str]) -> tuple[Edge, ...]:
        """Return every edge between two of the things with these ids, sorted."""
        found = chain.from_iterable(self._edges_at(self.network.thing(name)) for name in ids)
        return tuple(sorted({edge for edge in found if edge.source in ids and edge.target in ids}))

    def _more(self, there: Collection[str], filters: Filters) -> dict[str, int]:
        things = (self.network.thing(name) for name in sorted(there))
        return {thing.id: sum(one.id not in there for one in self.next_to(thing, filters)) for thing in things}

    def _of_name(self, thing: Thing, filters: Filters) -> Iterator[str]:
        name = thing.id.partition(":")[2]
        yield from self._objects(self.network.called.get(name, ()), filters)
        yield from self._objects(self.network.goals_with.get(name, ()), filters)

    def _of_object(self, thing: Thing, filters: Filters) -> Iterator[str]:
        network, node = self.network, self.network.object_of(thing)
        sides = [self._steps(side.get(node, ()), filters) for side in (network.makers, network.takers)]
        yield from _in_turns(sides)
        for goal in network.goals.get(node, ()):
            if not filters.dish_types or goal.dish_type in filters.dish_types:
                yield f"dish:{goal.dish_type}"
                yield from self._videos(goal.videos, filters)

    def _of_step(self, thing: Thing, filters: Filters) -> Iterator[str]:
        unit = self.network.step_of(thing).unit
        nodes = [self.network.thing(f"object:{node.key}") for node in (*unit.output_nodes, *unit.input_nodes)]
        told = nodes if filters.utensils else [one for one in nodes if not one.empty]
        yield from (one.id for one in told or nodes)  # of a stove that is turned on there is nothing else to tell
        yield from self._videos((seen.video for seen in self.network.step_of(thing).seen_in), filters)

    def _of_motion(self, thing: Thing, filters: Filters) -> list[str]:
        return self._steps(self.network.done_by(thing), filters)

    def _of_video(self, thing: Thing, filters: Filters) -> Iterator[str]:
        yield from self._objects(self.network.goals_in.get(thing.name, ()), filters)
        steps = self.network.in_video.get(thing.name, ())
        yield from (f"step:{known.unit.key}" for known in steps if self.network.passes(known, filters))

    def _of_dish(self, thing: Thing, filters: Filters) -> list[str]:
        return self._objects(self.network.goals_of_type[thing.name], filters)

    def _objects(self, nodes: Iterable[ObjectNode], filters: Filters) -> list[str]:
        network = self.network
        passing = (node for node in nodes if any(network.passes(known, filters) for known in self._steps_of(node)))
        things = {node: network.thing(f"object:{node.key}") for node in passing}
        return [things[node].id for node in sorted(things, key=lambda node: (-things[node].steps, node.sort_key))]

    def _steps_of(self, node: ObjectNode) -> Iterator[KnownUnit]:
        return chain(self.network.makers.get(node, ()), self.network.takers.get(node, ()))

    def _steps(self, steps: Iterable[KnownUnit], filters: Filters) -> list[str]:
        """Return the ids of steps: the most seen of each motion, the second of each, and so on."""
        passing = [known for known in steps if self.network.passes(known, filters)]
        passing.sort(key=lambda known: (-len(known.seen_in), known.unit.motion, known.seen_in, known.unit.key))
        motions = grouped((known.unit.motion, f"step:{known.unit.key}") for known in passing)
        return list(_in_turns(list(motions.values())))

    def _videos(self, names: Iterable[str], filters: Filters) -> Iterator[str]:
        for name in names:
            types = self.network.dish_types.get(name, ())
            if filters.dish_types and filters.dish_types.isdisjoint(types):
                continue
            if not filters.videos or name in filters.videos:
                yield f"video:{name}"

    def _edges_at(self, thing: Thing) -> Iterator[Edge]:
        if thing.kind == "step":
            known = self.network.step_of(thing)
            yield from (Edge(f"object:{node.key}", thing.id, "takes") for node in known.unit.input_nodes)
            yield from (Edge(thing.id, f"object:{node.key}", "makes") for node in known.unit.output_nodes)
            yield from (Edge(thing.id, f"video:{seen.video}", "seen in") for seen in known.seen_in)
            yield Edge(thing.id, f"motion:{known.unit.motion}", "motion")
        elif thing.kind == "object":
            yield from self._edges_of_object(thing)

    def _edges_of_object(self, thing: Thing) -> Iterator[Edge]:
        node = self.network.object_of(thing)
        yield Edge(thing.id, f"{'utensil' if thing.vessel else 'food'}:{node.label}", "called")
        for goal in self.network.goals.get(node, ()):
            yield Edge(thing.id, f"dish:{goal.dish_type}", "type")
            yield from (Edge(thing.id, f"food:{food}", "contains") for food in goal.ingredients)
            yield from (Edge(f"video:{video}", thing.id, "shows") for video in goal.videos)


def _with_room(things: Sequence[Thing], there: Collection[str], room: int) -> list[Thing]:
    """Return ``things`` without those that are not ``there`` yet and for which there is no ``room``."""
    new = [thing.id for thing in things if thing.id not in there]
    dropped = set(new[max(room, 0) :])
    return [thing for thing in things if thing.id not in dropped]


def _in_turns(rows: Sequence[Sequence[T]]) -> Iterator[T]:
    """Return the first of each row, the second of each, and so on."""
    nothing = object()
    for column in zip_longest(*rows, fillvalue=nothing):
        yield from (item for item in column if item is not nothing)  # type: ignore[misc] # what is left are Ts
