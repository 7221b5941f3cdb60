"""Fetching the jars: in parallel, resumable, verified, never half a file under its final name."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from foon_kg.model.errors import ServerError
from foon_kg.store.disk import explain_os_error
from foon_kg.store.server.extra import missing_extra
from foon_kg.store.server.jars import CHUNK, Jar, JarSet, sha256_of

if TYPE_CHECKING:
    import requests

THREADS = 8
TRIES = 4
PAUSE_SECONDS = 0.3  # before the second try; longer before each further one
TIMEOUT = (10, 30)  # seconds to connect, seconds between two pieces
HTTP_NOT_FOUND = 404
HTTP_PARTIAL = 206

Advance = Callable[[int], None]
"""Told how many bytes more are there; negative when a file has to be begun again."""


def repositories() -> tuple[str, ...]:
    """Return the addresses of the Maven repositories to ask, in order.

    ``FOON_KG_MAVEN`` names one and only one; otherwise they are those of jgo: its own default, and what the person's
    jgo configuration names. Raises ServerError where jgo, of the extra ``server``, is not installed.
    """
    if chosen := os.environ.get("FOON_KG_MAVEN"):
        return (chosen.rstrip("/"),)
    try:
        from jgo.config import GlobalSettings  # noqa: PLC0415 - part of the optional extra
        from jgo.constants import MAVEN_CENTRAL_URL  # noqa: PLC0415 - the same
    except ModuleNotFoundError as error:
        raise missing_extra("jgo") from error
    known = {"central": MAVEN_CENTRAL_URL} | GlobalSettings.load().repositories
    return tuple(address.rstrip("/") for address in known.values())


def fetch(jar_set: JarSet, folder: Path) -> None:
    """Bring every missing jar of the set into ``folder``; what is there already, whole or in part, is used.

    Raises ServerError when a file cannot be had, its content is not the pinned one, or there is no room for it.
    Whatever was complete by then stays, so that the next call goes on from there.
    """
    if find_spec("requests") is None:
        raise missing_extra("requests")
    sources = repositories()
    with explain_os_error(f"cannot keep the jars of Neo4j in {folder}"):
        folder.mkdir(parents=True, exist_ok=True)
        jars = jar_set.missing(folder)
        with _progress(f"Neo4j {jar_set.version}", sum(jar.size for jar in jars)) as advance:
            _fetch_all(jars, folder, sources, advance)


def _fetch_all(jars: Sequence[Jar], folder: Path, sources: Sequence[str], advance: Advance) -> None:
    largest_first = sorted(jars, key=lambda jar: (-jar.size, jar.coordinates))
    with ThreadPoolExecutor(THREADS, thread_name_prefix="fetch") as pool:
        waiting = [pool.submit(fetch_one, jar, folder, sources, advance) for jar in largest_first]
        try:
            for done in as_completed(waiting):
                done.result()
        except BaseException:  # Ctrl-C too: else the pool would fetch all other jars before it ends
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def fetch_one(jar: Jar, folder: Path, sources: Sequence[str], advance: Advance = lambda _: None) -> None:
    """Bring one ``jar`` into ``folder`` from the first of ``sources`` that has it.

    Its ``.part`` file is continued and verified, and then gets its name in one step. ``advance`` hears how many bytes
    came. Raises ServerError where it cannot be had, or what comes is not the pinned jar.
    """
    part = folder / f"{jar.name}.part"
    advance(part.stat().st_size if part.exists() else 0)
    for attempt in range(1, TRIES + 1):
        try:
            _download(jar, part, sources, advance)
        except _InterruptedError as error:
            if attempt == TRIES:
                raise _unavailable(jar, str(error)) from error
            time.sleep(PAUSE_SECONDS * attempt)
            continue
        if sha256_of(part) == jar.sha256:
            part.replace(folder / jar.name)
            return
        advance(-part.stat().st_size)
        part.unlink()
    raise ServerError(
        f"{jar.path}: what was fetched is not the pinned file (SHA-256 {jar.sha256} was expected)",
        hint=f"{' and '.join(sources)} serve something else: check the proxy or mirror, or set FOON_KG_MAVEN",
        code="checksum",
    )


class _InterruptedError(Exception):
    """The connection ended before the file did; trying again may help."""


def _download(jar: Jar, part: Path, sources: Sequence[str], advance: Advance) -> None:
    """Append to ``part`` what is missing of the jar."""
    import requests  # noqa: PLC0415 - slow to import, and only a first start needs it
    import urllib3  # noqa: PLC0415 - the same

    for source in sources:
        have = part.stat().st_size if part.exists() else 0
        if have >= jar.size:
            return
        try:
            headers = {"Accept-Encoding": "identity"} | ({"Range": f"bytes={have}-"} if have else {})
            with requests.get(f"{source}/{jar.path}", headers=headers, stream=True, timeout=TIMEOUT) as answer:
                if answer.status_code == HTTP_NOT_FOUND:
                    continue
                _write(answer, part, have, advance)
        except (requests.RequestException, urllib3.exceptions.HTTPError) as error:
            raise _InterruptedError(str(error)) from error
        if part.stat().st_size < jar.size:
            raise _InterruptedError(f"only {part.stat().st_size} of {jar.size} bytes came")
        return
    raise _unavailable(jar, "none of the repositories has it")


def _write(answer: requests.Response, part: Path, have: int, advance: Advance) -> None:
    """Write the body behind what is there, or from the start when the server did not understand the range."""
    answer.raise_for_status()
    continues = answer.status_code == HTTP_PARTIAL
    if have and not continues:
        advance(-have)
    with part.open("ab" if continues else "wb") as stream:
        while piece := answer.raw.read1(CHUNK):  # what has come is written, even if the rest never does
            stream.write(piece)
            advance(len(piece))


def _unavailable(jar: Jar, why: str) -> ServerError:
    return ServerError(
        f"{jar.path} cannot be fetched: {why}",
        hint="check the network and start again: what has come so far is kept. A mirror can be named by FOON_KG_MAVEN",
        code="fetch",
    )


@contextmanager
def _progress(title: str, total: int) -> Iterator[Advance]:
    """Show a bar on standard error while fetching, if that is a terminal."""
    from rich.console import Console  # noqa: PLC0415 - only a first start shows a bar
    from rich.progress import BarColumn, DownloadColumn, Progress, TextColumn, TransferSpeedColumn  # noqa: PLC0415

    columns = (TextColumn("{task.description}"), BarColumn(), DownloadColumn(), TransferSpeedColumn())
    with Progress(*columns, console=Console(file=sys.stderr), disable=not sys.stderr.isatty()) as bar:
        task = bar.add_task(f"fetching {title}", total=total)
        yield lambda amount: bar.advance(task, amount)
