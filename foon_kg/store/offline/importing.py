"""A FOON brought into the local Neo4j by ``neo4j-admin database import``, in place of all that the server holds.

The import is made in a home of its own inside the server's home, with its indexes and all that a load would write,
while the server goes on with what it has. Only when that is done is the one folder of data put in the place of the
other (:mod:`foon_kg.store.server.exchange`). A program that is killed leaves the old graph as it was, or the new one,
and a folder that the next import sweeps away.
"""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import psutil
from filelock import FileLock, Timeout

from foon_kg.cypher import named_query
from foon_kg.model import Subgraph
from foon_kg.model.errors import ServerError, UsageError
from foon_kg.model.kept import write_private
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.disk import explain_os_error
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.schema import prepare_for_writing
from foon_kg.store.graph.statements import COMPLETE_LISTS, HOLDS_SOMETHING, RECOUNT_WORDS, ask
from foon_kg.store.offline.csv_files import write_csv_files
from foon_kg.store.offline.staged import Staged
from foon_kg.store.offline.staging import Stager
from foon_kg.store.server import process as processes
from foon_kg.store.server.configuration import new_password, write_configuration
from foon_kg.store.server.exchange import exchange, restore
from foon_kg.store.server.home import Home, Say, home, silent, waiting
from foon_kg.store.server.java import run_admin
from foon_kg.store.server.launch import launched, set_password
from foon_kg.store.server.lifecycle import ensure_running, start_locked, stop_locked
from foon_kg.store.server.reach import password_of
from foon_kg.store.server.starting import fetched
from foon_kg.store.server.startup_cache import StartupCache
from foon_kg.store.settings import ConnectionSettings, connection_from_environment

MAX_OFF_HEAP = "1g"
"""Bounds the memory of the import beside Java's heap; without it the import takes nine tenths of what is free."""

_JAVA = {
    "HEAP_SIZE": "1g",
    "JDK_JAVA_OPTIONS": "--add-opens=java.base/java.nio=ALL-UNNAMED --enable-native-access=ALL-UNNAMED",
}
"""How the import calls Java, as Neo4j's own launcher does."""


@dataclass
class ImportReport:
    """How many videos were imported, and the seconds that each part of it took."""

    videos: int = 0
    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def timed(self, part: str) -> Iterator[None]:
        """Write down how long (s) the block takes, which does a ``part`` of the work."""
        started = time.monotonic()
        yield
        self.seconds[part] = round(time.monotonic() - started, 1)


def load_offline(
    subgraphs: Iterable[Subgraph],
    *,
    replace: bool = False,
    say: Say = silent,
    told: Callable[[int], None] = lambda _count: None,
    beside: Callable[[Staged], None] | None = None,
) -> ImportReport:
    """Make ``subgraphs`` the FOON of the local server, which is then up; only a part of them is in memory at a time.

    ``say`` hears what is done in words, ``told`` how many videos were read. ``beside`` stages what comes with them once
    all are staged (:func:`~foon_kg.store.offline.staging.stage_recipes`). Raises UsageError where ``NEO4J_URI`` names
    another Neo4j, and where the server holds anything, unless that shall be replaced (``replace``).
    """
    _refuse_another_server()
    place, kitchen, report = home(), Kitchen.default(), ImportReport()
    place.create()
    with _alone(place) as folder:
        if not replace:
            _refuse_what_is_not_empty(place, say)
        with Staged(folder / "staged.sqlite", kitchen) as staged:
            stager = Stager(staged, kitchen, told)
            with report.timed("reading"):
                stager.stage(subgraphs)
            if beside is not None:
                with report.timed("recipes"):
                    beside(staged)
            with report.timed("files"):
                staged.finish()
                arguments = write_csv_files(staged, folder, kitchen)
            report.videos = stager.videos
        _import(place, folder, arguments, report, say, replace=replace)
    return report


def _import(
    place: Home, folder: Path, arguments: Sequence[str], report: ImportReport, say: Say, *, replace: bool
) -> None:
    """Import the files that ``arguments`` name in ``folder``, and put the result in the place of the server's data."""
    cache, made = fetched(say), Home(folder / "home")
    made.create()
    _share_password(place, made)
    class_path = cache.jar_set.class_path(cache.folder)
    with waiting(say, "importing"), report.timed("import"):
        write_configuration(made, processes.free_port())
        set_password(made, class_path)
        words = ("database", "import", "full", "neo4j", f"--max-off-heap-memory={MAX_OFF_HEAP}", *arguments)
        run_admin(made.arguments.with_name("admin.args"), class_path, made.root, words, _JAVA)
    with waiting(say, "making indexes"), report.timed("indexes"), _started(made, cache) as settings:
        _complete(settings)
    with place.locked(say):
        if not replace:
            _refuse_what_was_stored_meanwhile(place, say)
        stop_locked(place, say)
        exchange(place, made)
    ensure_running(say)


def _complete(settings: ConnectionSettings) -> None:
    """Make of what was imported a FOON that this program reads and writes: its lists, constraints and indexes."""
    with Connection(settings) as connection, connection.session(writing=True) as session:
        session.run(named_query(COMPLETE_LISTS.name).text).consume()
        session.execute_write(ask, RECOUNT_WORDS)
        prepare_for_writing(session, Kitchen.default())


@contextmanager
def _started(made: Home, cache: StartupCache) -> Iterator[ConnectionSettings]:
    """Run a server on the home that was imported into, for as long as the block lasts."""
    with launched(made, processes.free_port(), cache.jar_set, cache.folder, cache.flags()) as (child, settings):
        process = psutil.Process(child.pid)
        processes.wait_for_answer(process, settings, made)
        yield settings
        processes.end(process)
        child.wait()


def _share_password(place: Home, made: Home) -> None:
    """Let ``made`` have the password of the server: so its data are all that takes the place of another."""
    with place.locked(), explain_os_error(f"cannot write {made.password_file}"):
        if not (place.password_file.exists() or place.databases.exists()):
            write_private(place.password_file, new_password())
        write_private(made.password_file, password_of(place))


@contextmanager
def _alone(place: Home) -> Iterator[Path]:
    """Yield the folder of the import, empty; one import is made at a time, and nothing is left of it."""
    lock = FileLock(place.root / "run" / "import.lock")
    try:
        lock.acquire(timeout=0)
    except Timeout as error:
        raise ServerError(
            f"another foon command imports into {place.root}", hint="wait for it or end it", code="locked"
        ) from error
    folder = place.root / "import"
    try:
        _sweep(folder)
        with place.locked():
            restore(place)
        with explain_os_error(f"cannot write to {folder}"):
            folder.mkdir()
        yield folder
    finally:
        _sweep(folder)
        lock.release()


def _sweep(folder: Path) -> None:
    """Take away what an import has left behind that was killed: files, and what still imports or serves them."""
    if folder.exists():
        while left := list(_at_work_in(folder)):  # one that ends may have started another
            for process in left:
                processes.end_at_once(process)
    shutil.rmtree(folder, ignore_errors=True)


def _at_work_in(folder: Path) -> Iterator[psutil.Process]:
    """Yield every Java that was started on something in ``folder``."""
    for process in psutil.process_iter(["cmdline", "status"]):
        command = process.info["cmdline"] or [""]
        ended = process.info["status"] == psutil.STATUS_ZOMBIE
        if not ended and Path(command[0]).stem == "java" and any(f"{folder}{os.sep}" in word for word in command):
            yield process


def _refuse_another_server() -> None:
    named = connection_from_environment()
    if named is not None:
        raise UsageError(
            f"NEO4J_URI names {named.uri}: only the local server's data can be imported offline",
            hint="Unset it, load without --offline, or import by hand: foon export --format csv --output import/",
        )


def _refuse_what_is_not_empty(place: Home, say: Say) -> None:
    if not place.databases.exists():
        return
    if _holds_something(ensure_running(say)):
        raise UsageError(
            "the local Neo4j holds a graph, and an import takes the place of all of it, recipes and drafts too",
            hint="Add --replace where that is meant; without --offline, videos are added to what is there.",
        )


def _refuse_what_was_stored_meanwhile(place: Home, say: Say) -> None:
    """Look once more, on the home that is locked: an import takes minutes, in which others load, and a server idles."""
    if place.databases.exists() and _holds_something(start_locked(place, say)[0]):
        raise UsageError(
            "while the import was made another program stored a graph in the local Neo4j; it is left as it is",
            hint="Import again with --replace where that is meant; without --offline, videos are added to it.",
        )


def _holds_something(settings: ConnectionSettings) -> bool:
    with Connection(settings) as connection, connection.session() as session:
        (row,) = session.execute_read(ask, HOLDS_SOMETHING)
    return row.something
