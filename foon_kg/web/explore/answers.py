"""The answer to a question in Cypher as a table, and as a picture of the nodes and edges that are in it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from neo4j.graph import Node, Path, Relationship

from foon_kg.web.explore.network import Edge, Network, Thing

if TYPE_CHECKING:
    from foon_kg.store.graph.free_cypher import Answer

MOST_DRAWN = 150
"""So many nodes of an answer are drawn."""

_LONGEST_NOTE = 200
_KINDS = {
    "Object": ("object", "key"), "Motion": ("step", "key"), "Video": ("video", "name"), "DishType": ("dish", "name"),
    "Verb": ("motion", "name"), "Ingredient": ("food", "name"), "Label": ("food", "name"),
    "Food": ("food", "name"), "Utensil": ("utensil", "name"),
}  # fmt: skip
"""Which nodes of the graph are which things of the explorer, and the property that names them."""

_EDGES = {
    "INPUT_OF": "takes", "OUTPUTS": "makes", "SEEN_IN": "seen in", "IS_A": "type", "MADE_OF": "contains",
    "CALLED": "called",
}  # fmt: skip


@dataclass(frozen=True)
class Drawn:
    """The nodes of an answer as things (at most ``MOST_DRAWN``), and the edges among them."""

    things: tuple[Thing, ...]
    edges: tuple[Edge, ...]


def drawn(answer: Answer, network: Network) -> Drawn:
    """Return what of an ``answer`` can be drawn in ``network``: its nodes, edges and paths, wherever they stand."""
    nodes: dict[str, Thing] = {}
    edges: dict[Edge, None] = {}
    for value in _graph_values(answer.rows):
        if isinstance(value, Node):
            if len(nodes) < MOST_DRAWN:
                nodes.setdefault(value.element_id, _thing(value, network))
        elif (edge := _joined(value, network)) is not None:
            edges[edge] = None
    things = {thing.id: thing for thing in nodes.values()}
    there = (edge for edge in edges if edge.source in things and edge.target in things)
    return Drawn(tuple(things.values()), tuple(there))


def _joined(edge: Relationship, network: Network) -> Edge | None:
    """Return what an edge joins, ``None`` where the question did not ask for its ends."""
    if edge.start_node is None or edge.end_node is None:
        return None
    kind = _EDGES.get(edge.type, edge.type.lower().replace("_", " "))
    return Edge(_thing(edge.start_node, network).id, _thing(edge.end_node, network).id, kind)


def _graph_values(value: object) -> Iterator[Node | Relationship]:
    """Return every node and edge in a value of the driver, however deep."""
    if isinstance(value, Node | Relationship):
        yield value
    elif isinstance(value, Path):
        yield from value.nodes
        yield from value.relationships
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from _graph_values(item)
    elif isinstance(value, list | tuple | set | frozenset):
        for item in value:
            yield from _graph_values(item)


def _thing(node: Node, network: Network) -> Thing:
    """Return the thing that a node is: one that the explorer knows, else one that it can only show.

    The ends of an edge come without their labels and properties where the question did not ask for them.
    """
    for label in sorted(node.labels):
        kind, key = _KINDS.get(label, ("", ""))
        name = str(node.get(key, ""))
        known = next((f"{k}:{name}" for k in (kind, "utensil") if kind and network.has(f"{k}:{name}")), None)
        if known is not None:
            return network.thing(known)
    return Thing(f"node:{node.element_id}", "other", _name(node), (), 0, _note(node))


def _name(node: Node) -> str:
    own = next((node[key] for key in ("name", "label", "title", "motion", "food", "id") if node.get(key)), "")
    return str(own or next(iter(sorted(node.labels)), "node"))


def _note(node: Node) -> str:
    labels = ", ".join(sorted(node.labels))
    told = "; ".join(f"{key} {value}" for key, value in sorted(node.items()) if not isinstance(value, list | bytes))
    note = f"{labels}: {told}" if told else labels
    return note if len(note) <= _LONGEST_NOTE else f"{note[:_LONGEST_NOTE]}…"
