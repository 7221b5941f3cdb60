"""Start and stop of the local Neo4j, one server a home however many commands ask at once.

Most commands find that it runs: what only a start takes (:mod:`foon_kg.store.server.starting`) is imported for one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import psutil

from foon_kg.model.errors import ServerError
from foon_kg.store.disk import explain_os_error
from foon_kg.store.server import process as processes
from foon_kg.store.server.home import Home, Memory, Say, home, silent
from foon_kg.store.server.reach import settings_of
from foon_kg.store.settings import ConnectionSettings


def ensure_running(say: Say = silent) -> ConnectionSettings:
    """Return how to reach the local server; starts it if it is not up, with the idle time and port it had before.

    ``say`` hears what is done.
    """
    return start(say=say)


def start(
    *,
    port: int | None = None,
    idle_minutes: float | None = None,
    say: Say = silent,
    after_start: Callable[[ConnectionSettings], None] | None = None,
) -> ConnectionSettings:
    """Start the local server, or find that it runs, and return how to reach it.

    ``port`` is kept for later starts; without one a free port is chosen once. ``idle_minutes`` without use, and the
    server stops by itself (0: never). ``say`` hears what is done; ``after_start`` is called once a server that this
    call started has answered. Raises ServerError: see its codes in ``fetch``, ``disk`` and ``process``.
    """
    place = home()
    with place.locked(say):
        settings, ran = start_locked(place, say, port=port, idle_minutes=idle_minutes)
    if not ran:
        (after_start or _warm)(settings)
    return settings


def start_locked(
    place: Home, say: Say = silent, *, port: int | None = None, idle_minutes: float | None = None
) -> tuple[ConnectionSettings, bool]:
    """Start the server of the home ``place``, which the caller has locked.

    Return how to reach it, and if it ran already.

    ``say``, ``port``, ``idle_minutes`` and what is raised: see :func:`start`.
    """
    known = place.recall()
    running = processes.find(place, known)
    if running:
        settings = _join(place, running, known, port, idle_minutes)
    else:
        from foon_kg.store.server import starting  # noqa: PLC0415 - what most commands never need

        memory = starting.remembered(place, known, port, idle_minutes, say)
        settings = starting.launch(place, memory, say, explicit_port=port is not None)
    with explain_os_error(f"cannot write {place.used}"):
        place.used.touch()
    return settings, running is not None


def stop(say: Say = silent) -> bool:
    """Stop the local server, and ``say`` so; return whether there was one to stop."""
    place = home()
    if not place.root.exists():
        return False
    with place.locked(say):
        return stop_locked(place, say)


def stop_locked(place: Home, say: Say = silent) -> bool:
    """Stop the server of the home ``place``, which the caller has locked, and ``say`` so."""
    known = place.recall()
    running = processes.find(place, known)
    if running:
        say(f"stopping the local Neo4j (process {running.pid})")
        if known and known.port and processes.has_failed_to_write(settings_of(place, known.port)):
            # in order it would write on behind what was torn off: nobody could read that
            processes.end_at_once(running)
        else:
            processes.end(running)
    if known:
        place.remember(replace(known, pid=None))
    return running is not None


def _join(
    place: Home, running: psutil.Process, known: Memory | None, port: int | None, idle_minutes: float | None
) -> ConnectionSettings:
    """Use the server that runs, whoever started it; the idle time can be changed while it does."""
    if known is None:
        from foon_kg.store.server.starting import rebuilt  # noqa: PLC0415 - as above

        known = rebuilt(place, running)
    if idle_minutes is not None:
        place.remember(replace(known, idle_minutes=idle_minutes))
    if known.port is None or port not in (None, known.port):
        raise ServerError(
            f"the local Neo4j runs already, on port {known.port}",
            hint="foon server stop, then start it again",
            code="port",
        )
    settings = settings_of(place, known.port)
    if not processes.speaks_bolt(known.port):
        processes.wait_for_answer(running, settings, place)
    return settings


def _warm(settings: ConnectionSettings) -> None:
    """Let the graph layer compile its queries, so that the first plan doesn't wait for that."""
    from foon_kg.store.graph.warming import warm  # noqa: PLC0415 - needed only after a start

    warm(settings)
