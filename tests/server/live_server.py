"""Starting, finding and killing real local servers in tests."""

from __future__ import annotations

import sys

import psutil

from foon_kg.store.server import ConnectionSettings, start
from foon_kg.store.server.home import Home

START = [sys.executable, "-c", "from foon_kg.store.server import start; print(start().uri)"]
"""A command that starts the server and prints where it answers."""


def up(**options) -> ConnectionSettings:
    """Start the server without the graph layer's warming, which is not what these tests are about."""
    return start(after_start=lambda _settings: None, **options)


def servers_of(place: Home) -> list[psutil.Process]:
    """Return every process that runs Neo4j on this home."""
    argument = f"@{place.arguments}"
    return [process for process in psutil.process_iter(["cmdline"]) if argument in (process.info["cmdline"] or ())]


def kill(pid: int) -> None:
    """End a process at once, as a crash or ``kill -9`` does."""
    process = psutil.Process(pid)
    process.kill()
    process.wait()
