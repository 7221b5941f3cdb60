"""DOT, the language of Graphviz: object nodes green, motion nodes red, as in the figures of the papers."""

from __future__ import annotations

import re
from collections.abc import Iterator

from foon_kg.formats.exports.graph import BipartiteGraph
from foon_kg.formats.video_address import is_web_address
from foon_kg.model import KnownUnit, ObjectNode

_HEAD = (
    "  rankdir=BT;",
    '  node [fontname="Helvetica", style=filled];',
    '  edge [color="#555555"];',
)
_ENTITY = re.compile(r"&(?=#?\w+;)")
_FOOD, _UTENSIL, _GOAL, _MOTION = "#8bc99b", "#d5ecdb", "#f2c14e", "#e06666"


def write_dot(graph: BipartiteGraph) -> str:
    """Return ``graph`` as DOT: from the kitchen below to the goal above; thick lines where something moves."""
    lines = [f"digraph {_quoted(graph.name)} {{", *_HEAD]
    lines += (f"  {name} [{_object(name, node, graph)}];" for name, node in graph.objects.items())
    lines += (f"  {name} [{_motion(known)}];" for name, known in graph.units.items())
    lines += (f"  {edge.start} -> {edge.end}{' [penwidth=2]' if edge.moving else ''};" for edge in graph.edges)
    return "\n".join((*lines, "}")) + "\n"


def _object(name: str, node: ObjectNode, graph: BipartiteGraph) -> str:
    colour = _GOAL if node in graph.goals else _FOOD if graph.kitchen.is_food(node) else _UTENSIL
    attributes = [f"label={_quoted(graph.text_of(name))}", "shape=ellipse", f'fillcolor="{colour}"']
    if node in graph.at_hand:
        attributes.append("peripheries=2")
    return ", ".join(attributes)


def _motion(known: KnownUnit) -> str:
    return ", ".join(_motion_attributes(known))


def _motion_attributes(known: KnownUnit) -> Iterator[str]:
    yield f"label={_quoted(known.unit.motion + ('*' if known.unit.accepts_any else ''))}"
    yield "shape=box"
    yield f'fillcolor="{_MOTION}"'
    source = known.seen_in[0].source if known.seen_in else None
    if source and is_web_address(source):
        yield f"URL={_quoted(source)}"


def _quoted(text: str) -> str:
    r"""Return ``text`` as a quoted string.

    A label shows a backslash only where there are two (``\N`` is an escape), and ``&lt;`` as a sign that it names.
    """
    printable = _ENTITY.sub("&amp;", "".join(c if c.isprintable() else " " for c in text))
    return '"' + printable.replace("\\", "\\\\").replace('"', '\\"') + '"'
