"""A real local Neo4j without Docker or a system Java, and how any Neo4j is reached.

``connection_settings`` is what a command asks: the Neo4j that the environment names, else the local one, started if it
is not up. Everything else here is that local server.
"""

from foon_kg.store.server.lifecycle import connection_settings, ensure_running, start, stop
from foon_kg.store.server.settings import ConnectionSettings, connection_from_environment
from foon_kg.store.server.state import Status, status

__all__ = [
    "ConnectionSettings",
    "Status",
    "connection_from_environment",
    "connection_settings",
    "ensure_running",
    "start",
    "status",
    "stop",
]
