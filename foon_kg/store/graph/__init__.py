"""The thin Neo4j layer: what the planner asks, what the loader writes, and nothing that decides anything.

A name is imported when somebody first asks for it: a question in Cypher needs a connection, and nothing of what a load
needs.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.graph.loading import LoadReport, load, remove
    from foon_kg.store.graph.neo4j_graph import Neo4jGraph
    from foon_kg.store.graph.reading import GraphView
    from foon_kg.store.graph.weights import WeightsReport, load_weights

__all__ = ["Connection", "GraphView", "LoadReport", "Neo4jGraph", "WeightsReport", "load", "load_weights", "remove"]

_HOMES = {
    "Connection": "connection",
    "GraphView": "reading",
    "LoadReport": "loading",
    "Neo4jGraph": "neo4j_graph",
    "WeightsReport": "weights",
    "load": "loading",
    "load_weights": "weights",
    "remove": "loading",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
