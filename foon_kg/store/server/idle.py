"""Stops the local server when nobody has used it for a while: ``python -m foon_kg.store.server.idle HOME PID``.

Bolt connections are numbered by the server, one after another. The watcher looks in now and then with a connection of
its own: if others are open, or the numbers have moved on by more than its own visit, somebody has used the server
since, with foon or with any driver. A driver that stays open counts as use. Beside that, the watcher makes the start-up
cache, in the first quiet moment.

It also ends a server that does not let go of a question: one that was told to end and still runs at the next look would
keep a processor for ever, for there are expressions that no Neo4j interrupts. That waits until nobody else is at work,
and the server is started again at once.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import psutil
from filelock import FileLock

from foon_kg.model.kept import write_private
from foon_kg.store.server import process as processes
from foon_kg.store.server.home import Home, Memory
from foon_kg.store.server.lifecycle import stop_locked
from foon_kg.store.server.reach import settings_of
from foon_kg.store.server.startup_cache import the_startup_cache
from foon_kg.store.settings import ConnectionSettings

LOOK_SECONDS = 60.0
NICE = 19
VISIT = "foon-kg-idle-watch"
CONNECTIONS = "CALL dbms.listConnections() YIELD connectionId, userAgent RETURN connectionId, userAgent"
TRANSACTIONS = "SHOW TRANSACTIONS YIELD transactionId, connectionId, status, currentQuery"
MOST_TOLD = 200
"""Characters of a question that are told."""


@dataclass(frozen=True, slots=True)
class Visit:
    """What one look showed: the ``newest`` Bolt connection's number (our own), and how many ``others`` are open."""

    newest: int
    others: int
    stuck: Mapping[str, str] = field(default_factory=dict)
    """Of each transaction that was told to end and has not ended, what it asks."""

    busy: bool = False
    """Whether other transactions run."""

    def saw_use(self, before: Visit) -> bool:
        """Say whether anybody else was there since the look before."""
        return self.others > 0 or self.newest > before.newest + 1

    def still_stuck(self, before: Visit) -> str | None:
        """Return a question that was to end before the look before and has not, where nobody else is at work."""
        both = sorted(self.stuck.keys() & before.stuck.keys())
        return self.stuck[both[0]] if both and not self.busy else None


def visit(settings: ConnectionSettings) -> Visit | None:
    """Return the connections of the running server of these ``settings``; None if it does not answer, or is to end."""
    import neo4j  # noqa: PLC0415 - slow to import
    from neo4j.exceptions import DriverError, Neo4jError  # noqa: PLC0415 - the same

    auth = (settings.user, settings.password)
    try:
        with (
            neo4j.GraphDatabase.driver(settings.uri, auth=auth, user_agent=VISIT) as driver,
            driver.session(database=settings.database) as session,
        ):
            rows = list(session.run(CONNECTIONS))
            ours = {row["connectionId"] for row in rows if row["userAgent"] == VISIT}
            running = [row for row in session.run(TRANSACTIONS) if row["connectionId"] not in ours]
    except (DriverError, Neo4jError):
        return None
    stuck = {row["transactionId"]: row["currentQuery"] for row in running if row["status"].startswith("Terminated")}
    newest = max(int(row["connectionId"].rpartition("-")[2]) for row in rows)
    return Visit(newest, len(rows) - len(ours), stuck, busy=len(running) > len(stuck))


def watch(place: Home, server: psutil.Process, settings: ConnectionSettings) -> None:
    """Follow the ``server`` of the home ``place`` until it ends; end it when it has been idle as long as remembered.

    ``settings`` say how to reach it.
    """
    before, used, quiet = None, time.monotonic(), False
    while known := _memory_of(place, server):
        limit = known.idle_minutes * 60
        if _ended_within(server, _seconds_to_look(limit)):
            break
        now = visit(settings)
        if _saw_use(before, now):
            used = time.monotonic()
        elif not quiet:
            quiet = True
            the_startup_cache().make()
        if _is_stuck_and_begins_again(place, server, before, now) or _stopped_as_idle(place, server, used, limit):
            break
        before = now or before
    if not place.arguments.exists():  # somebody has removed the folder under the server: no command would find it
        processes.end(server)
    if not quiet:
        the_startup_cache().make()


def _seconds_to_look(limit: float) -> float:
    """Return after how many seconds to look again: so often that the ``limit`` (in seconds; 0 for ever) is kept."""
    return min(LOOK_SECONDS, limit / 4) if limit else LOOK_SECONDS


def _saw_use(before: Visit | None, now: Visit | None) -> bool:
    """Whether somebody used the server between two visits; it counts as used where one of them was not answered."""
    return now is None or before is None or now.saw_use(before)


def _is_stuck_and_begins_again(place: Home, server: psutil.Process, before: Visit | None, now: Visit | None) -> bool:
    """Start a server again that could not end a question between two visits; whether that was done."""
    asked = now.still_stuck(before) if now and before else None
    return _start_again(place, server, asked) if asked else False


def _stopped_as_idle(place: Home, server: psutil.Process, used: float, limit: float) -> bool:
    """Stop a server that was last ``used`` so many seconds (``limit``; 0 for ever) ago; whether that was done."""
    return bool(limit) and time.monotonic() - used >= limit and _stop_unless_wanted(place, server, seconds=limit)


def _memory_of(place: Home, server: psutil.Process) -> Memory | None:
    """Return what the home remembers of this very server; None once it is another's, or the home is gone."""
    known = place.recall()
    return known if known and known.pid == server.pid else None


def _ended_within(server: psutil.Process, seconds: float) -> bool:
    try:
        processes.wait_for_end(server, seconds)
    except psutil.TimeoutExpired:
        return False
    return True


def _stop_unless_wanted(place: Home, server: psutil.Process, *, seconds: float) -> bool:
    """Stop the server, except if a command has asked for it just now and is about to connect."""
    with place.locked():
        asked = place.used.stat().st_mtime if place.used.exists() else 0.0
        return time.time() - asked >= seconds and _memory_of(place, server) is not None and stop_locked(place)


def _start_again(place: Home, server: psutil.Process, asked: str) -> bool:
    """End a server that does not let go of what it was ``asked``, and start it again where it was."""
    from foon_kg.store.server.starting import launch  # noqa: PLC0415 - seldom needed

    with place.locked():
        known = _memory_of(place, server)
        if known is None:
            return False
        told = f"{asked[:MOST_TOLD]}{'…' if len(asked) > MOST_TOLD else ''}"
        when = time.strftime("%Y-%m-%d %H:%M:%S")
        write_private(place.started_again, f"{when}: it did not let go of a question: {' '.join(told.split())}\n")
        stop_locked(place)
        launch(place, replace(known, pid=None), print, explicit_port=False)
    return True


def main(root: str, pid: str) -> None:
    """Watch the server ``pid`` of the home at ``root``; after another watcher of this home, if there is one."""
    os.nice(NICE)
    place = Home(Path(root))
    with FileLock(place.watch_lock):
        known = place.recall()
        server = processes.find(place, known)
        if known and known.port and server and server.pid == int(pid):
            watch(place, server, settings_of(place, known.port))


if __name__ == "__main__":
    main(*sys.argv[1:])
