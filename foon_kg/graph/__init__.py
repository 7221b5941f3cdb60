"""The thin Neo4j layer: what the planner asks, what the loader writes, and nothing that decides anything."""

from foon_kg.graph.connection import Connection
from foon_kg.graph.loading import LoadReport, load, remove
from foon_kg.graph.reading import GraphView, Neo4jGraph

__all__ = ["Connection", "GraphView", "LoadReport", "Neo4jGraph", "load", "remove"]
