"""What ``foon server status`` answers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from foon_kg.store.server import process as processes
from foon_kg.store.server.home import Memory, home
from foon_kg.store.server.jars import pinned
from foon_kg.store.server.reach import HOST
from foon_kg.store.server.startup_cache import the_startup_cache


@dataclass(frozen=True, slots=True)
class Status:
    """The local server as it is now; ``memory`` in bytes, None for what only a running server has."""

    running: bool
    uri: str | None
    user: str
    pid: int | None
    version: str
    memory: int | None
    idle_minutes: float
    data: str
    password_file: str
    log_file: str
    startup_cache: str
    started_again: str | None
    """When and why it was ended and started by itself, the last time that was so."""


def status() -> Status:
    """Look at the local server without starting or changing anything."""
    place = home()
    known = place.recall()
    running = processes.find(place, known)
    memory = known or Memory()
    return Status(
        user="neo4j",
        running=running is not None,
        uri=f"bolt://{HOST}:{memory.port}" if running and memory.port else None,
        pid=running.pid if running else None,
        version=memory.version if running and memory.version else pinned().version,
        memory=running.memory_info().rss if running else None,
        idle_minutes=memory.idle_minutes,
        data=str(place.data),
        password_file=str(place.password_file),
        log_file=str(place.console_log),
        startup_cache=the_startup_cache().state(),
        started_again=_line(place.started_again),
    )


def _line(file: Path) -> str | None:
    try:
        return file.read_text(encoding="utf-8").strip()
    except OSError:
        return None
