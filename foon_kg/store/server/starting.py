"""A start of the local Neo4j on a locked home: what it was before, fetched, launched, watched and warmed."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import psutil
from filelock import FileLock

from foon_kg.model.errors import ServerError
from foon_kg.model.kept import cache_folder
from foon_kg.store.disk import explain_os_error
from foon_kg.store.server import process as processes
from foon_kg.store.server.exchange import restore
from foon_kg.store.server.fetch import fetch
from foon_kg.store.server.home import Home, Memory, Say, waiting
from foon_kg.store.server.jars import JarSet, pinned
from foon_kg.store.server.java import java
from foon_kg.store.server.launch import launched
from foon_kg.store.server.startup_cache import StartupCache, the_startup_cache
from foon_kg.store.server.verified import other_than
from foon_kg.store.settings import ConnectionSettings


def remembered(place: Home, known: Memory | None, port: int | None, idle_minutes: float | None, say: Say) -> Memory:
    """Return the memory that a new start on ``place`` begins with: what was asked now, else what was ``known`` before.

    What is asked are ``port`` and ``idle_minutes``, ``None`` for as before; ``say`` hears of a record that cannot be
    read.
    """
    if known is None and place.memory_file.exists():
        say(f"{place.memory_file} is unreadable and is written anew; the server gets a new port")
    memory = known or Memory()
    if idle_minutes is not None:
        memory = replace(memory, idle_minutes=idle_minutes)
    return replace(memory, pid=None, port=port or memory.port)


def launch(place: Home, memory: Memory, say: Say, *, explicit_port: bool) -> ConnectionSettings:
    """Fetch what is missing and start the server of ``place``, by its ``memory``; then remember it.

    It starts once more without the start-up cache if that start fails. ``say`` hears what is done; an ``explicit_port``
    is not changed where it is taken.
    """
    restore(place)
    cache = fetched(say)
    jar_set, folder = cache.jar_set, cache.folder
    port = _port(memory.port, say, explicit=explicit_port)
    memory = replace(memory, port=port, version=jar_set.version)
    try:
        with waiting(say, f"starting Neo4j {jar_set.version}"):
            return _launch_on(place, port, memory, cache)
    except ServerError as error:
        _blame_damaged_jars(jar_set, folder)
        if error.code != "start" or not cache.discard():
            raise
        say(f"{error.message}; starting again without the start-up cache")
        return _launch_on(place, port, memory, cache)


def fetched(say: Say) -> StartupCache:
    """Return the start-up cache with the jars that it is of, once all that is missing of these has been fetched.

    ``say`` hears what is fetched.
    """
    java()
    cache = the_startup_cache()
    _fetch_what_is_not_there(cache.jar_set, cache.folder, say)
    if not cache.is_as_made():
        say("the start-up cache is not as it was made: it is taken away, and made anew in a quiet moment")
        cache.discard()
    return cache


def _fetch_what_is_not_there(jar_set: JarSet, folder: Path, say: Say) -> None:
    """Fetch the files that are not there, and those that somebody has changed since they were compared."""
    for name in other_than(folder, jar_set.hashes()):
        say(f"{folder / name} is not what was pinned: it is taken away and fetched again")
        with explain_os_error(f"cannot take away {folder / name}"):
            (folder / name).unlink(missing_ok=True)
    if missing := jar_set.missing(folder):
        size = sum(jar.size for jar in missing) / 1e6
        say(f"fetching Neo4j {jar_set.version} into {folder}: {len(missing)} files, {size:.0f} MB, only this once")
        with _fetching():
            fetch(jar_set, folder)


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


def rebuilt(place: Home, running: psutil.Process) -> Memory:
    """Return the memory of the home ``place`` whose record was lost, from the ``running`` process.

    It is written again.
    """
    listening = [item.laddr.port for item in running.net_connections("tcp") if item.status == psutil.CONN_LISTEN]
    memory = Memory(running.pid, next(iter(listening), None), version=pinned().version)
    place.remember(memory)
    _watch(place, running.pid)
    return memory


def _watch(place: Home, pid: int) -> None:
    """Leave a process behind that stops the server when nobody uses it."""
    command = [sys.executable, "-m", "foon_kg.store.server.idle", str(place.root), str(pid)]
    processes.spawn(command, place.console_log.with_name("idle.log"), cache_folder())
