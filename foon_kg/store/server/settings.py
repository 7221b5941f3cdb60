"""How to reach a Neo4j: the one that the environment names, else the local one."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class ConnectionSettings:
    """Everything that a driver needs: address, user, password and the name of the database."""

    uri: str
    user: str = "neo4j"
    password: str = field(default="", repr=False)
    database: str = "neo4j"


def connection_from_environment() -> ConnectionSettings | None:
    """Return what ``NEO4J_URI``, ``_USER``, ``_PASSWORD`` and ``_DATABASE`` say, or None when no NEO4J_URI is set."""
    uri = os.environ.get("NEO4J_URI")
    if not uri:
        return None
    return ConnectionSettings(
        uri,
        os.environ.get("NEO4J_USER", "neo4j"),
        os.environ.get("NEO4J_PASSWORD", ""),
        os.environ.get("NEO4J_DATABASE") or "neo4j",
    )


def connection_settings(say: Callable[[str], None] = lambda _message: None) -> ConnectionSettings:
    """Return how to reach the graph: the Neo4j that the environment names, else the local one, started if need be."""
    named = connection_from_environment()
    if named is not None:
        return named
    from foon_kg.store.server.lifecycle import ensure_running  # noqa: PLC0415 - for the local one only

    return ensure_running(say)
