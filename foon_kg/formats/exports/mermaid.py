"""Mermaid flowcharts, as Markdown pages show them."""

from __future__ import annotations

import json
from collections.abc import Iterator

from foon_kg.formats.exports.graph import BipartiteGraph

_CLASSES = (
    "  classDef food fill:#8bc99b,stroke:#2e7d46,color:#000",
    "  classDef utensil fill:#d5ecdb,stroke:#2e7d46,color:#000",
    "  classDef goal fill:#f2c14e,stroke:#7a5c00,color:#000",
    "  classDef motion fill:#e06666,stroke:#7a1f1f,color:#000",
)
_PLAIN = frozenset(" ,.()-_+*'/!")


def write_mermaid(graph: BipartiteGraph) -> str:
    """Return ``graph`` as a flowchart from the kitchen to the goal; thick arrows where something moves."""
    lines = ["---", f"title: {json.dumps(graph.name, ensure_ascii=False)}", "---", "flowchart TD", *_CLASSES]
    lines += _objects(graph)
    for name, known in graph.units.items():
        verb = known.unit.motion + ("*" if known.unit.accepts_any else "")
        lines.append(f"  {name}[{_quoted(verb)}]:::motion")
    lines += (f"  {edge.start} {'==>' if edge.moving else '-->'} {edge.end}" for edge in graph.edges)
    return "\n".join(lines) + "\n"


def _objects(graph: BipartiteGraph) -> Iterator[str]:
    for name, node in graph.objects.items():
        kind = "goal" if node in graph.goals else "food" if graph.kitchen.is_food(node) else "utensil"
        yield f"  {name}([{_quoted(graph.text_of(name))}]):::{kind}"


def _quoted(text: str) -> str:
    """Return ``text`` as a quoted label: what could mean anything to Mermaid, Markdown or HTML as its code point."""
    return '"' + "".join(c if c.isalnum() or c in _PLAIN else f"#{ord(c)};" for c in text) + '"'
