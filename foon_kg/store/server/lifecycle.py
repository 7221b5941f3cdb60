"""Start and stop of the local Neo4j, one server a home however many commands ask at once."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import psutil
from filelock import FileLock

from foon_kg.model.errors import ServerError
from foon_kg.store.server import process as processes
from foon_kg.store.server.disk import explain_os_error
from foon_kg.store.server.fetch import fetch
from foon_kg.store.server.home import Home, Memory, Say, cache_folder, home, silent
from foon_kg.store.server.jars import JarSet, pinned
from foon_kg.store.server.java import java
from foon_kg.store.server.launch import launched, settings_of
from foon_kg.store.server.settings import ConnectionSettings, connection_from_environment
from foon_kg.store.server.startup_cache import StartupCache, the_startup_cache


def connection_settings(say: Say = silent) -> ConnectionSettings:
    """Return how to reach the graph: the Neo4j that the environment names, else the local one, started if need be."""
    return connection_from_environment() or ensure_running(say)


def ensure_running(say: Say = silent) -> ConnectionSettings:
    """Return how to reach the local server; starts it if it is not up, with the idle time and port it had before."""
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
    server stops by itself (0: never). ``after_start`` is called once a server that this call started has answered.
    Raises ServerError: see its codes in ``fetch``, ``disk`` and ``process``.
    """
    place = home()
    with place.locked(say):
        known = place.recall()
        running = processes.find(place, known)
        if running:
            settings = _join(place, running, known, port, idle_minutes)
        else:
            memory = _remembered(place, known, port, idle_minutes, say)
            settings = _launch(place, memory, say, explicit_port=port is not None)
        with explain_os_error(f"cannot write {place.used}"):
            place.used.touch()
    if not running:
        (after_start or _warm)(settings)
    return settings


def stop(say: Say = silent) -> bool:
    """Stop the local server; answers whether there was one to stop."""
    place = home()
    if not place.root.exists():
        return False
    with place.locked(say):
        return stop_locked(place, say)


def stop_locked(place: Home, say: Say = silent) -> bool:
    """Stop the server of a home that the caller has locked."""
    known = place.recall()
    running = processes.find(place, known)
    if running:
        say(f"stopping the local Neo4j (process {running.pid})")
        if known and known.port and processes.has_failed_to_write(settings_of(place, known.port)):
            processes.end_at_once(
                running
            )  # in order it would write on behind what was torn off: nobody could read that
        else:
            processes.end(running)
    if known:
        place.remember(replace(known, pid=None))
    return running is not None


def _join(
    place: Home, running: psutil.Process, known: Memory | None, port: int | None, idle_minutes: float | None
) -> ConnectionSettings:
    """Use the server that runs, whoever started it; the idle time can be changed while it does."""
    known = known or _rebuilt(place, running)
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


def _rebuilt(place: Home, running: psutil.Process) -> Memory:
    """Remember again a server whose record was lost, from the process itself."""
    listening = [item.laddr.port for item in running.net_connections("tcp") if item.status == psutil.CONN_LISTEN]
    memory = Memory(running.pid, next(iter(listening), None), version=pinned().version)
    place.remember(memory)
    _watch(place, running.pid)
    return memory


def _remembered(place: Home, known: Memory | None, port: int | None, idle_minutes: float | None, say: Say) -> Memory:
    """Return the memory that a new start begins with: what was asked now, else what was before."""
    if known is None and place.memory_file.exists():
        say(f"{place.memory_file} is unreadable and is written anew; the server gets a new port")
    memory = known or Memory()
    if idle_minutes is not None:
        memory = replace(memory, idle_minutes=idle_minutes)
    return replace(memory, pid=None, port=port or memory.port)


def _launch(place: Home, memory: Memory, say: Say, *, explicit_port: bool) -> ConnectionSettings:
    """Fetch what is missing, start, remember; once more without the start-up cache if that start fails."""
    java()
    cache = the_startup_cache()
    jar_set, folder = cache.jar_set, cache.folder
    if missing := jar_set.missing(folder):
        size = sum(jar.size for jar in missing) / 1e6
        say(f"fetching Neo4j {jar_set.version} into {folder}: {len(missing)} files, {size:.0f} MB, only this once")
        with _fetching():
            fetch(jar_set, folder)
    port = _port(memory.port, say, explicit=explicit_port)
    memory = replace(memory, port=port, version=jar_set.version)
    say(f"starting Neo4j {jar_set.version}")
    try:
        return _launch_on(place, port, memory, cache)
    except ServerError as error:
        _blame_damaged_jars(jar_set, folder)
        if error.code != "start" or not cache.discard():
            raise
        say(f"{error.message}; starting again without the start-up cache")
        return _launch_on(place, port, memory, cache)


def _launch_on(place: Home, port: int, memory: Memory, cache: StartupCache) -> ConnectionSettings:
    with launched(place, port, cache.jar_set, cache.folder, cache.flags()) as (child, settings):
        place.remember(replace(memory, pid=child.pid))
        _watch(place, child.pid)
        processes.wait_for_answer(psutil.Process(child.pid), settings, place)
    return settings


@contextmanager
def _fetching() -> Iterator[None]:
    """Let one command fetch at a time, whatever its home: the jars are shared."""
    with explain_os_error(f"cannot use {cache_folder()}"):
        cache_folder().mkdir(parents=True, exist_ok=True)
        with FileLock(cache_folder() / "fetch.lock"):
            yield


def _port(port: int | None, say: Say, *, explicit: bool) -> int:
    """Return the port to use. One that was asked for now must be free; one that was only remembered may be changed."""
    if port is None:
        return processes.free_port()
    if processes.is_free(port):
        return port
    if explicit:
        raise processes.port_taken(port)
    other = processes.free_port()
    say(f"port {port} has been taken by another program: the local Neo4j moves to port {other}")
    return other


def _blame_damaged_jars(jar_set: JarSet, folder: Path) -> None:
    """After a failed start: take away what is not the pinned content, so that the next start fetches it again."""
    damaged = jar_set.damaged(folder)
    for jar in damaged:
        (folder / jar.name).unlink()
    if damaged:
        names = ", ".join(jar.name for jar in damaged)
        raise ServerError(
            f"the local Neo4j cannot start: damaged on disk in {folder}: {names}",
            hint="start it again: they were removed and are fetched anew",
            code="checksum",
        )


def _watch(place: Home, pid: int) -> None:
    """Leave a process behind that stops the server when nobody uses it."""
    command = [sys.executable, "-m", "foon_kg.store.server.idle", str(place.root), str(pid)]
    processes.spawn(command, place.console_log.with_name("idle.log"), cache_folder())


def _warm(settings: ConnectionSettings) -> None:
    """Let the graph layer compile its queries, so that the first plan doesn't wait for that."""
    from foon_kg.store.graph.warming import warm  # noqa: PLC0415 - needed only after a start

    warm(settings)
