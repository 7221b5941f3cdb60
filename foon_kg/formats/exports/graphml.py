"""GraphML, which Gephi, yEd, Cytoscape and networkx read: every field of every node, nothing left to a label."""

from __future__ import annotations

import json
from collections.abc import Mapping
from xml.etree import ElementTree as ET

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.formats.exports.graph import BipartiteGraph
from foon_kg.formats.exports.markup import xml_document, xml_text
from foon_kg.formats.exports.notation import node_text, unit_text
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.node_json import sighting_to_json

Value = str | bool | float | None

_NAMESPACE = "http://graphml.graphdrawing.org/xmlns"
_FIELDS = {
    "node": {
        "kind": "string", "text": "string", "label": "string", "states": "string", "ingredients": "string",
        "relation": "string", "container": "string", "thing": "int", "at_hand": "boolean", "goal": "boolean",
        "motion": "string", "accepts_any": "boolean", "success_rate": "double", "seen_in": "string",
    },
    "edge": {"moving": "boolean"},
}  # fmt: skip


def write_graphml(graph: BipartiteGraph) -> str:
    """Return ``graph`` as GraphML. Lists (states, ingredients, where a unit was seen) are written as JSON.

    Motion nodes have a success rate where the motion has a weight.

    Object nodes have the numbers of their things (``thing``) where the tree is a plan.

    Raises :class:`~foon_kg.model.errors.FormatError` for names with control characters, which no XML can hold.
    """
    root = ET.Element("graphml", {"xmlns": _NAMESPACE})
    for what, fields in _FIELDS.items():
        for name, kind in fields.items():
            ET.SubElement(root, "key", {"id": name, "for": what, "attr.name": name, "attr.type": kind})
    drawn = ET.SubElement(root, "graph", {"id": "foon", "edgedefault": "directed"})
    ET.SubElement(drawn, "desc").text = xml_text(graph.name)
    for name, node in graph.objects.items():
        _add(drawn, "node", {"id": name}, _object(name, node, graph))
    for name, known in graph.units.items():
        _add(drawn, "node", {"id": name}, _motion(known, graph.costs))
    for edge in graph.edges:
        _add(drawn, "edge", {"source": edge.start, "target": edge.end}, {"moving": edge.moving})
    return xml_document(root)


def _object(name: str, node: ObjectNode, graph: BipartiteGraph) -> dict[str, Value]:
    return {
        "kind": "food" if graph.kitchen.is_food(node) else "utensil",
        "text": node_text(node),
        "label": node.label,
        "states": _list(node.states),
        "ingredients": _list(node.ingredients),
        "relation": node.relation,
        "container": node.container,
        "thing": graph.things.get(name),
        "at_hand": node in graph.at_hand,
        "goal": node in graph.goals,
    }


def _motion(known: KnownUnit, costs: MotionCosts) -> dict[str, Value]:
    motion = known.unit.motion
    return {
        "kind": "motion",
        "text": unit_text(known.unit),
        "motion": motion,
        "accepts_any": known.unit.accepts_any,
        "success_rate": float(costs.success(motion)) if motion in costs.costs else None,
        "seen_in": _list([sighting_to_json(sighting) for sighting in known.seen_in]),
    }


def _add(parent: ET.Element, tag: str, attributes: dict[str, str], data: Mapping[str, Value]) -> None:
    element = ET.SubElement(parent, tag, attributes)
    for key, value in data.items():
        if value is not None:
            text = str(value).lower() if isinstance(value, bool) else str(value)
            ET.SubElement(element, "data", {"key": key}).text = xml_text(text)


def _list(values: object) -> str:
    return json.dumps(values, ensure_ascii=False)
