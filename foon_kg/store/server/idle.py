"""Stops the local server when nobody has used it for a while: ``python -m foon_kg.store.server.idle HOME PID``.

Bolt connections are numbered by the server, one after another. The watcher looks in now and then with a connection of
its own: if others are open, or the numbers have moved on by more than its own visit, somebody has used the server
since, with foon or with any driver. A driver that stays open counts as use. Beside that, the watcher makes the start-up
cache, in the first quiet moment.
"""

from __future__ import annotations

import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import psutil
from filelock import FileLock

from foon_kg.store.server import process as processes
from foon_kg.store.server.home import Home, Memory
from foon_kg.store.server.lifecycle import stop_locked
from foon_kg.store.server.reach import settings_of
from foon_kg.store.server.startup_cache import the_startup_cache
from foon_kg.store.settings import ConnectionSettings

LOOK_SECONDS = 60.0
NICE = 19
VISIT = "foon-kg-idle-watch"


@dataclass(frozen=True, slots=True)
class Visit:
    """What one look showed: the number of the newest Bolt connection (our own), and how many others are open."""

    newest: int
    others: int

    def saw_use(self, before: Visit) -> bool:
        """Say whether anybody else was there since the look before."""
        return self.others > 0 or self.newest > before.newest + 1


def visit(settings: ConnectionSettings) -> Visit | None:
    """Look at the connections of a running server; None when it does not answer, busy or about to end."""
    import neo4j  # noqa: PLC0415 - slow to import
    from neo4j.exceptions import DriverError, Neo4jError  # noqa: PLC0415 - the same

    auth = (settings.user, settings.password)
    query = "CALL dbms.listConnections() YIELD connectionId, userAgent RETURN connectionId, userAgent"
    try:
        with (
            neo4j.GraphDatabase.driver(settings.uri, auth=auth, user_agent=VISIT) as driver,
            driver.session(database=settings.database) as session,
        ):
            rows = list(session.run(query))
    except (DriverError, Neo4jError):
        return None
    others = [row for row in rows if row["userAgent"] != VISIT]
    return Visit(max(int(row["connectionId"].rpartition("-")[2]) for row in rows), len(others))


def watch(place: Home, server: psutil.Process, settings: ConnectionSettings) -> None:
    """Follow one server until it ends; end it when it has been idle for as long as its home remembers."""
    before, used, quiet = None, time.monotonic(), False
    while known := _memory_of(place, server):
        limit = known.idle_minutes * 60
        if _ended_within(server, min(LOOK_SECONDS, limit / 4) if limit else LOOK_SECONDS):
            break
        now = visit(settings)
        if now is None or before is None or now.saw_use(before):
            used = time.monotonic()
        elif not quiet:
            quiet = True
            the_startup_cache().make()
        before = now or before
        if limit and time.monotonic() - used >= limit and _stop_unless_wanted(place, server, seconds=limit):
            break
    if not place.arguments.exists():  # somebody has removed the folder under the server: no command would find it
        processes.end(server)
    if not quiet:
        the_startup_cache().make()


def _memory_of(place: Home, server: psutil.Process) -> Memory | None:
    """Return what the home remembers of this very server; None once it is another's, or the home is gone."""
    known = place.recall()
    return known if known and known.pid == server.pid else None


def _ended_within(server: psutil.Process, seconds: float) -> bool:
    try:
        server.wait(seconds)
    except psutil.TimeoutExpired:
        return False
    return True


def _stop_unless_wanted(place: Home, server: psutil.Process, *, seconds: float) -> bool:
    """Stop the server, except if a command has asked for it just now and is about to connect."""
    with place.locked():
        asked = place.used.stat().st_mtime if place.used.exists() else 0.0
        return time.time() - asked >= seconds and _memory_of(place, server) is not None and stop_locked(place)


def main(root: str, pid: str) -> None:
    """Watch the server that the arguments name; after another watcher of this home, if there is one."""
    os.nice(NICE)
    place = Home(Path(root))
    with FileLock(place.watch_lock):
        known = place.recall()
        server = processes.find(place, known)
        if known and known.port and server and server.pid == int(pid):
            watch(place, server, settings_of(place, known.port))


if __name__ == "__main__":
    main(*sys.argv[1:])
