"""A real local Neo4j without Docker or a system Java, and how any Neo4j is reached.

``connection_settings`` is what a command asks: the Neo4j that the environment names, else the local one, started if it
is not up. Everything else here is that local server; a name is imported when somebody first asks for it.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING

from foon_kg.store.settings import ConnectionSettings, connection_from_environment

if TYPE_CHECKING:
    from foon_kg.store.server.lifecycle import ensure_running, start, stop
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
    "Status": "foon_kg.store.server.state",
    "ensure_running": "foon_kg.store.server.lifecycle",
    "start": "foon_kg.store.server.lifecycle",
    "status": "foon_kg.store.server.state",
    "stop": "foon_kg.store.server.lifecycle",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def connection_settings(say: Callable[[str], None] = lambda _message: None) -> ConnectionSettings:
    """Return how to reach the graph: the Neo4j that the environment names, else the local one, started if need be.

    ``say`` hears what is done for that.
    """
    named = connection_from_environment()
    if named is not None:
        return named
    from foon_kg.store.server.lifecycle import ensure_running  # noqa: PLC0415 - for the local one only

    return ensure_running(say)
