"""How to reach a Neo4j: its address and who asks, and what the environment says of both."""

from __future__ import annotations

import os
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
