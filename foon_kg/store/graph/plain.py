"""Values as the driver answers them, in the types of JSON."""

from __future__ import annotations

from typing import Any

from neo4j.graph import Node, Path, Relationship


def as_plain(value: Any) -> object:  # noqa: ANN401 - whatever a driver can answer
    """Return a value of the driver as JSON knows it: nodes, edges and paths as objects, times and places as text."""
    if isinstance(value, Node):
        return {"labels": sorted(value.labels), "properties": as_plain(dict(value))}
    if isinstance(value, Relationship):
        return {"type": value.type, "properties": as_plain(dict(value))}
    if isinstance(value, Path):
        return {"nodes": list(map(as_plain, value.nodes)), "relationships": list(map(as_plain, value.relationships))}
    if isinstance(value, dict):
        return {str(key): as_plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple | set | frozenset):
        return list(map(as_plain, value))
    return value if isinstance(value, str | int | float | bool | None) else str(value)
