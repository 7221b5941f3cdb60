"""The thin Neo4j layer: what the planner asks, what the loader writes, and nothing that decides anything."""

from foon_kg.graph.connection import Connection
from foon_kg.graph.loading import LoadReport, load, remove
from foon_kg.graph.reading import GraphView, Neo4jGraph
from foon_kg.graph.weights import WeightsReport, load_weights

__all__ = ["Connection", "GraphView", "LoadReport", "Neo4jGraph", "WeightsReport", "load", "load_weights", "remove"]
