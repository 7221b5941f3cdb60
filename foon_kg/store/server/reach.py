"""How the local server of a home is reached: its address, and the password that its folder keeps."""

from __future__ import annotations

from foon_kg.model.errors import ServerError
from foon_kg.store.server.home import Home
from foon_kg.store.settings import ConnectionSettings

HOST = "127.0.0.1"


def settings_of(place: Home, port: int) -> ConnectionSettings:
    """Return how to reach the server of the home ``place`` on this ``port``."""
    return ConnectionSettings(f"bolt://{HOST}:{port}", "neo4j", password_of(place), "neo4j")


def password_of(place: Home) -> str:
    """Return the password of the user ``neo4j`` in the home ``place``; raises ServerError where it cannot be read."""
    try:
        return place.password_file.read_text(encoding="utf-8").strip()
    except OSError as error:
        raise ServerError(
            f"the password of the local Neo4j cannot be read: {place.password_file}: {error.strerror}",
            hint=f"put the file back, or remove {place.root} to begin with an empty graph",
            code="password",
        ) from error
