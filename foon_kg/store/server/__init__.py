"""A real local Neo4j without Docker or a system Java, and how any Neo4j is reached.

``connection_settings`` is what a command asks: the Neo4j that the environment names, else the local one, started if it
is not up. Everything else here is that local server; a name is imported when somebody first asks for it.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from foon_kg.store.server.lifecycle import ensure_running, start, stop
    from foon_kg.store.server.settings import ConnectionSettings, connection_from_environment, connection_settings
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

_HOMES = {
    "ConnectionSettings": "settings",
    "Status": "state",
    "connection_from_environment": "settings",
    "connection_settings": "settings",
    "ensure_running": "lifecycle",
    "start": "lifecycle",
    "status": "state",
    "stop": "lifecycle",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
