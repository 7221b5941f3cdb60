"""The graph that ``foon load foon`` writes, as tables: a row a node for each label, a row an edge for each type.

Its record (``Foon``) is not among them: a graph is one that foon-kg can read only when all the rest is in place.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from foon_kg.food import singular
from foon_kg.model import ObjectNode, Subgraph
from foon_kg.model.names import canonical
from foon_kg.similarity.points import indexed_points
from foon_kg.store.graph.movements import following, movements
from foon_kg.store.graph.values import properties_of
from foon_kg.store.offline.tables import EDGES, named
from foon_kg.store.snapshot import Snapshot, goals_of
from foon_kg.store.vocabulary import WordCounts

Cell = str | bool | float | Sequence[object] | None
Row = tuple[Cell, ...]

SIGHTING = tuple(map(named, next(edges.columns for edges in EDGES if edges.type == "SEEN_IN")))
"""The properties of ``SEEN_IN``, in the order of their cells."""


def node_tables(foon: Snapshot) -> dict[str, list[Row]]:
    """Return, for each label, the properties of its nodes in ``foon``, one row a node."""
    counts = _counts(foon)
    objects = _objects(foon)
    return {
        "Video": [(video.name, video.content_key, video.sources) for video in foon.subgraphs],
        "Label": _names(node.label for node in objects),
        "Object": [(*_fields(node), *_flags(node, foon)) for node in objects],
        "Motion": [(known.unit.key, known.unit.motion, known.unit.accepts_any) for known in foon.units],
        "DishType": _names(goal.dish_type for goal in foon.goals()),
        "Ingredient": _ingredients(foon, counts),
        "State": _names({row.state for row in counts.seen_as()} | {row.state for row in counts.made_by()}),
        "Verb": [(row.motion, row.units, row.several) for row in counts.gatherings()],
    }


def _ingredients(foon: Snapshot, counts: WordCounts) -> list[Row]:
    """Return the foods that are seen, and those that goals are made of, with their points."""
    made_of = {name for goal in foon.goals() for name in goal.ingredients}
    foods = sorted({row.label for row in counts.seen_as()} | made_of)
    points = zip(foods, indexed_points(foods), strict=True)
    return [(food, canonical(food), singular(food), point) for food, point in points]


def edge_tables(foon: Snapshot) -> dict[str, list[Row]]:
    """Return, for each type, the edges of ``foon`` as (name of the start, name of the end, properties…).

    A node is named by its key or its name, whichever it has.
    """
    counts = _counts(foon)
    return {
        "CALLED": [(node.key, node.label) for node in _objects(foon)],
        **_participations(foon),
        "NEXT": [(one, other, video.name, place) for video in foon.subgraphs for one, other, place in following(video)],
        "SEEN_IN": [row for video in foon.subgraphs for row in _sightings(video)],
        **_dishes(foon),
        "SEEN_AS": [(row.label, row.state, row.made, row.used) for row in counts.seen_as()],
        "MADE_BY": [(row.state, row.motion, row.count) for row in counts.made_by()],
    }


def _dishes(foon: Snapshot) -> dict[str, list[Row]]:
    """Return of which dish type each goal is, by which video, and of which foods it is made."""
    goals = [(node, dish, video.name) for video in foon.subgraphs for node, dish in goals_of(video, foon.kitchen)]
    made_of = sorted({(node.key, food) for node, _, _ in goals for food in node.ingredients})
    return {"IS_A": [(node.key, dish, video) for node, dish, video in goals], "MADE_OF": list(made_of)}


def _participations(foon: Snapshot) -> dict[str, list[Row]]:
    """Return which objects each unit takes and makes, with how many sightings show the object moving."""
    moving = movements(foon.subgraphs)
    taken: list[Row] = []
    made: list[Row] = []
    for unit in (known.unit for known in foon.units):
        taken += [(node.key, unit.key, moving.get((unit.key, "inputs", node.key))) for node in unit.input_nodes]
        made += [(unit.key, node.key, moving.get((unit.key, "outputs", node.key))) for node in unit.output_nodes]
    return {"INPUT_OF": taken, "OUTPUTS": made}


def _counts(foon: Snapshot) -> WordCounts:
    counts = WordCounts(foon.kitchen.is_utensil)
    counts.count(known.unit for known in foon.units)
    return counts


def _objects(foon: Snapshot) -> list[ObjectNode]:
    nodes = {node for known in foon.units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    return sorted(nodes, key=lambda node: node.key)


def _fields(node: ObjectNode) -> Row:
    return (node.key, node.label, node.states, node.ingredients, node.relation, node.container)


def _flags(node: ObjectNode, foon: Snapshot) -> Row:
    return (foon.kitchen.has(node) or None, foon.kitchen.is_utensil(node.label) or None)


def _sightings(video: Subgraph) -> Iterable[Row]:
    for position, annotation in enumerate(video.annotations):
        properties = properties_of(annotation, position)
        yield (annotation.unit.key, video.name, *(properties[name] for name in SIGHTING))


def _names(names: Iterable[str]) -> list[Row]:
    return [(name,) for name in sorted(set(names))]
