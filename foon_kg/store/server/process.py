"""The server's process: finding it, starting it, waiting for its first answer, ending it."""

from __future__ import annotations

import socket
import subprocess
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

import psutil

from foon_kg.model.errors import ServerError
from foon_kg.store.disk import could_not_write, explain_os_error, no_room
from foon_kg.store.server.home import Home, Memory
from foon_kg.store.server.reach import HOST
from foon_kg.store.settings import ConnectionSettings

ANSWER_SECONDS = 180
STOP_SECONDS = 60
ASKING_SECONDS = 5
POLL_SECONDS = 0.05
_BETWEEN_LOOKS = 1.0
BOLT_ANSWER = 4  # bytes of the version chosen
BOLT_HELLO = bytes.fromhex("6060b017 00000405 00000000 00000000 00000000")
"""Bolt's magic number and the one version proposed; any server of Bolt answers with four bytes (Bolt handshake)."""


def find(home: Home, memory: Memory | None) -> psutil.Process | None:
    """Return the running server of a ``home``, if there is one, by the ``memory`` of its start.

    A process counts only if it was started with our argument file: a number that another process has got since does
    not. Where nothing is remembered all processes are looked at, so that a server is found even if its record is lost.
    """
    if memory is not None and memory.pid is None:
        return None
    try:
        candidates = psutil.process_iter() if memory is None else iter([psutil.Process(memory.pid)])
    except psutil.NoSuchProcess:
        return None
    return next((process for process in candidates if _is_ours(process, home)), None)


def _is_ours(process: psutil.Process, home: Home) -> bool:
    try:
        return f"@{home.arguments}" in process.cmdline() and process.status() != psutil.STATUS_ZOMBIE
    except (psutil.NoSuchProcess, psutil.AccessDenied):
        return False


def free_port() -> int:
    """Return a port of the loopback interface that nobody listens on."""
    with socket.socket() as probe:
        probe.bind((HOST, 0))
        port: int = probe.getsockname()[1]
        return port


def is_free(port: int) -> bool:
    """Say whether a server could listen on this port now."""
    with socket.socket() as probe:
        # As Neo4j does it: a connection that was closed a moment ago is no hindrance.
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((HOST, port))
        except OSError:
            return False
    return True


def spawn(command: Sequence[str], log: Path, folder: Path) -> subprocess.Popen[bytes]:
    """Start a process of ``command`` in ``folder`` that outlives this one, its output in ``log``."""
    with explain_os_error(f"cannot start {command[0]}"):
        if log.exists():
            log.replace(log.with_name(f"{log.name}.old"))
        with log.open("wb") as output:
            return subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                cwd=folder,
                start_new_session=True,  # Ctrl-C is for the command, not for the server behind it
            )


def speaks_bolt(port: int) -> bool:
    """Say whether a Bolt server answers on this port."""
    try:
        with socket.create_connection((HOST, port), timeout=5) as connection:
            connection.sendall(BOLT_HELLO)
            answer: bytes = connection.recv(4)
            return len(answer) == BOLT_ANSWER
    except OSError:
        return False


def wait_for_answer(process: psutil.Process, settings: ConnectionSettings, home: Home) -> None:
    """Wait until the database of ``settings`` answers a query; raises ServerError, which says why, when it cannot.

    ``process`` runs it, on ``home``.
    """
    import neo4j  # noqa: PLC0415 - slow to import: done while the server starts
    from neo4j.exceptions import AuthError, DriverError, Neo4jError  # noqa: PLC0415 - the same

    deadline = time.monotonic() + ANSWER_SECONDS
    port = int(settings.uri.rpartition(":")[2])
    while time.monotonic() < deadline and is_alive(process):
        if not speaks_bolt(port):
            time.sleep(POLL_SECONDS)
            continue
        try:
            auth = (settings.user, settings.password)
            with (
                neo4j.GraphDatabase.driver(settings.uri, auth=auth) as driver,
                driver.session(database=settings.database) as session,
            ):
                session.run("RETURN 1").consume()  # a managed transaction would wait seconds between its retries
        except AuthError as error:
            raise ServerError(
                f"the local Neo4j does not accept the password in {home.password_file}",
                hint="put the old password back, or remove the folder to begin with an empty graph",
                code="password",
            ) from error
        except (DriverError, Neo4jError):  # not ready yet: the database opens after the connector
            time.sleep(POLL_SECONDS)
        else:
            return
    raise failure(home, "did not answer in time" if is_alive(process) else "ended before it answered", port)


def is_alive(process: psutil.Process) -> bool:
    """Say whether the process still runs; a child that ended and was not waited for does not."""
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


_NO_ROOM = ("No space left on device", "Disk quota exceeded", "File too large")
_IN_USE = ("FileLockException", "store_lock")
_ERRORS = ("ERROR", "Caused by:", "Error:")


def failure(home: Home, what: str, port: int) -> ServerError:
    """Return the error for a start that failed (``what``) on ``home`` and ``port``, as its log explains it."""
    text = home.console_log.read_text(encoding="utf-8", errors="replace") if home.console_log.exists() else ""
    if _has_one(_NO_ROOM, text):
        return no_room(f"the local Neo4j {what}: it cannot write to {home.root}")
    if "Address already in use" in text:
        return port_taken(port)
    if _has_one(_IN_USE, text):
        return ServerError(
            f"the database in {home.root} is in use by another process",
            hint="end the Neo4j that runs on it, or let FOON_KG_HOME name another folder",
            code="in-use",
        )
    hint = f"the whole story is in {home.console_log}"
    return ServerError(f"the local Neo4j {what}: {_reason(text)}", hint=hint, code="start")


def _has_one(signs: Iterable[str], text: str) -> bool:
    return any(sign in text for sign in signs)


def _reason(text: str) -> str:
    """Return the last line of a log that speaks of an error, else its last line."""
    lines = text.strip().splitlines() or ["it printed nothing"]
    errors = [line.strip() for line in text.splitlines() if _has_one(_ERRORS, line)]
    return (errors or lines)[-1]


def port_taken(port: int) -> ServerError:
    """Return the error for a port that somebody else listens on."""
    return ServerError(
        f"port {port} is in use by another program",
        hint="name another one: foon server start --port NUMBER",
        code="port",
    )


def has_failed_to_write(settings: ConnectionSettings) -> bool:
    """Return whether the database of ``settings`` answers nothing any more since its disk was full."""
    import neo4j  # noqa: PLC0415 - slow to import
    from neo4j.exceptions import DriverError, Neo4jError  # noqa: PLC0415 - the same

    if not speaks_bolt(int(settings.uri.rpartition(":")[2])):
        return False
    auth = (settings.user, settings.password)
    try:
        with (
            neo4j.GraphDatabase.driver(
                settings.uri, auth=auth, connection_acquisition_timeout=ASKING_SECONDS
            ) as driver,
            driver.session(database=settings.database) as session,
        ):
            session.run("RETURN 1").consume()
    except Neo4jError as error:
        return could_not_write(error.code, error.message)
    except DriverError:
        return False
    return False


def wait_for_end(process: psutil.Process, seconds: float) -> None:
    """Wait until the process has ended; raises psutil.TimeoutExpired where it has not within ``seconds``.

    One that has ended and whose parent has not asked after it yet keeps its number for as long as that parent lives.
    """
    until = time.monotonic() + seconds
    while (left := until - time.monotonic()) > _BETWEEN_LOOKS:
        try:
            process.wait(_BETWEEN_LOOKS)
        except psutil.TimeoutExpired:
            if not has_ended(process):
                continue
        return
    process.wait(max(left, 0))


def has_ended(process: psutil.Process) -> bool:
    """Whether the process has ended, be it that its parent has not asked after it yet."""
    try:
        return process.status() == psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return True


def end_at_once(process: psutil.Process) -> None:
    """End the process without another word of it; Neo4j recovers from that at its next start."""
    try:
        process.kill()
        wait_for_end(process, STOP_SECONDS)
    except psutil.NoSuchProcess:
        return


def end(process: psutil.Process, seconds: float = STOP_SECONDS) -> None:
    """Ask the process to stop, and insist after so many ``seconds``; Neo4j recovers from that at its next start."""
    try:
        process.terminate()
        wait_for_end(process, seconds)
    except psutil.TimeoutExpired:
        process.kill()
        wait_for_end(process, STOP_SECONDS)
    except psutil.NoSuchProcess:
        return
