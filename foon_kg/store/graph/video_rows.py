"""A video as rows of the statements that write it, worked out from itself alone, whatever else the graph has."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from foon_kg.model import FunctionalUnit, ObjectNode, Subgraph, sightings_of
from foon_kg.model.json_text import compact_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.method_rows import SightingValue
from foon_kg.store.graph.movements import Movement, movements
from foon_kg.store.graph.values import properties_of
from foon_kg.store.snapshot import goals_of
from foon_kg.store.vocabulary import UnitWords, words_of

KeptSighting = tuple[str, int, str]
"""A sighting: its video, its position there, and its text as the graph keeps it."""

Side = list[tuple[str, int | None]]
"""The nodes of one side of a unit by their keys, each with how many sightings show it moving, ``None`` for none."""

_SIDES = ("inputs", "outputs")


@dataclass(frozen=True)
class VideoRows:
    """What statements take of one video: objects and units by their keys, each unit as often moving as it shows it.

    ``seen`` are its units, each with its sighting there, and ``words`` what each unit adds to the counts of words.
    """

    video: dict[str, Any]
    objects: Mapping[str, dict[str, Any]]
    units: Mapping[str, dict[str, Any]]
    sightings: dict[str, Any]
    goals: tuple[dict[str, str], ...]
    seen: tuple[tuple[str, KeptSighting], ...]
    words: Mapping[str, UnitWords]


def rows_of(subgraph: Subgraph, kitchen: Kitchen) -> VideoRows:
    """Return the rows of ``subgraph`` in this ``kitchen``."""
    units = {annotation.unit.key: annotation.unit for annotation in subgraph.annotations}
    nodes = {node for unit in units.values() for node in (*unit.input_nodes, *unit.output_nodes)}
    name = subgraph.name
    return VideoRows(
        video={"name": name, "content": subgraph.content_key, "sources": subgraph.sources},
        objects={node.key: _object_row(node, kitchen) for node in nodes},
        units=unit_rows(subgraph),
        sightings={
            "name": name,
            "sightings": [
                {"unit": one.unit.key, "properties": properties_of(one, position)}
                for position, one in enumerate(subgraph.annotations)
            ],
        },
        goals=_goal_rows(subgraph, kitchen),
        seen=_seen(subgraph),
        words={key: words_of(unit, kitchen.is_utensil) for key, unit in units.items()},
    )


def unit_rows(subgraph: Subgraph) -> dict[str, dict[str, Any]]:
    """Return the rows of the units of ``subgraph`` by their keys, each as often moving as it is seen so there."""
    moving = movements([subgraph])
    return {annotation.unit.key: _unit_row(annotation.unit, moving) for annotation in subgraph.annotations}


def _goal_rows(subgraph: Subgraph, kitchen: Kitchen) -> tuple[dict[str, str], ...]:
    goals = goals_of(subgraph, kitchen)
    return tuple({"key": node.key, "dish_type": dish_type, "video": subgraph.name} for node, dish_type in goals)


def _seen(subgraph: Subgraph) -> tuple[tuple[str, KeptSighting], ...]:
    return tuple(
        (unit.key, written_sighting((seen.video, seen.position, seen.source, seen.start, seen.end)))
        for unit, seen in sightings_of(subgraph)
    )


def written_sighting(value: SightingValue) -> KeptSighting:
    """Return a sighting with its text: the values of a ``Sighting`` as JSON."""
    return value[0], value[1], compact_json(value)


def objects_together(videos: Iterable[VideoRows]) -> dict[str, dict[str, Any]]:
    """Return the rows of all objects of ``videos``, sorted by their keys."""
    found: dict[str, dict[str, Any]] = {}
    for video in videos:
        found.update(video.objects)
    return dict(sorted(found.items()))


def units_together(videos: Iterable[Mapping[str, dict[str, Any]]]) -> dict[str, dict[str, Any]]:
    """Return the rows of all units of ``videos``, sorted by their keys: what several show is counted in all of them.

    Each video is given as :func:`unit_rows` returns its units.
    """
    found: dict[str, dict[str, Any]] = {}
    for units in videos:
        for key, row in units.items():
            there = found.get(key)
            found[key] = row if there is None else there | {side: _sum(there[side], row[side]) for side in _SIDES}
    return dict(sorted(found.items()))


def movement_rows(units: Iterable[Mapping[str, Any]], weight: int = 1) -> Iterator[dict[str, Any]]:
    """Yield what ``load_movements`` adds for the rows of ``units``, of those in which something moves.

    For sightings that go, ``weight`` is -1.
    """
    for row in units:
        sides = {side: [{"key": key, "count": weight * count} for key, count in row[side] if count] for side in _SIDES}
        if any(sides.values()):
            yield {"unit": row["key"], **sides}


def _object_row(node: ObjectNode, kitchen: Kitchen) -> dict[str, Any]:
    return {
        "key": node.key,
        "label": node.label,
        "states": node.states,
        "ingredients": node.ingredients,
        "relation": node.relation,
        "container": node.container,
        "start": kitchen.has(node) or None,  # the closure asks for nodes without the property
        "utensil": kitchen.is_utensil(node.label) or None,
    }


def _unit_row(unit: FunctionalUnit, moving: Mapping[Movement, int]) -> dict[str, Any]:
    return {
        "key": unit.key,
        "verb": unit.motion,
        "accepts_any": unit.accepts_any,
        "inputs": _side(unit.key, "inputs", unit.input_nodes, moving),
        "outputs": _side(unit.key, "outputs", unit.output_nodes, moving),
    }


def _side(unit: str, side: str, nodes: Iterable[ObjectNode], moving: Mapping[Movement, int]) -> Side:
    return [(node.key, moving.get((unit, side, node.key))) for node in nodes]


def _sum(one: Side, other: Side) -> Side:
    """Return the same nodes with what both count of each."""
    more = dict(other)
    return [(key, (count or 0) + (more[key] or 0) or None) for key, count in one]
