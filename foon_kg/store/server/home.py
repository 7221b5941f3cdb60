"""Where the local server keeps its things, and what it remembers between commands."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import asdict, dataclass
from pathlib import Path

from filelock import FileLock, Timeout

from foon_kg.model.errors import ServerError
from foon_kg.model.kept import write_private
from foon_kg.store.disk import explain_os_error

DEFAULT_IDLE_MINUTES = 30
LOCK_SECONDS = 900  # a first start on a slow line, which others wait for


Say = Callable[[str], None]
"""Told, in one line of words, what takes time."""


def waiting(say: Say, what: str) -> AbstractContextManager[object]:
    """Say what is waited for; return what shows it for as long as it lasts, where ``say`` can."""
    shown = getattr(say, "waiting", None)
    if shown is not None:
        begun: AbstractContextManager[object] = shown(what)
        return begun
    say(what)
    return nullcontext()


def silent(_message: str) -> None:
    """Say nothing."""


@dataclass(frozen=True, slots=True)
class Memory:
    """What is remembered of the last start: process (None once stopped), port, idle time (0: never stops by itself)."""

    pid: int | None = None
    port: int | None = None
    idle_minutes: float = DEFAULT_IDLE_MINUTES
    version: str = ""


@dataclass(frozen=True, slots=True)
class Home:
    """The folder of one local server; ``FOON_KG_HOME`` names it, else it is in the user's data folder."""

    root: Path

    @property
    def configuration(self) -> Path:
        """The folder of neo4j.conf, written anew at each start."""
        return self.root / "conf"

    @property
    def data(self) -> Path:
        """The folder of all that Neo4j keeps."""
        return self.root / "data"

    @property
    def data_before(self) -> Path:
        """What the data were, while others are put in their place (:mod:`foon_kg.store.server.exchange`)."""
        return self.root / "data-before"

    @property
    def databases(self) -> Path:
        """The folder that exists once Neo4j has been started on this home."""
        return self.data / "databases"

    @property
    def password_file(self) -> Path:
        """The random password of the user ``neo4j``, readable by its owner only."""
        return self.root / "password"

    @property
    def console_log(self) -> Path:
        """What the server prints; that of the run before is beside it as ``.old``."""
        return self.root / "logs" / "console.log"

    @property
    def arguments(self) -> Path:
        """The file that names the server's Java arguments; its path on a command line identifies our process."""
        return self.root / "run" / "neo4j.args"

    @property
    def used(self) -> Path:
        """Touched by every command that asks for the server."""
        return self.root / "run" / "used"

    @property
    def watch_lock(self) -> Path:
        """Held by the one process that watches the server."""
        return self.root / "run" / "watch.lock"

    @property
    def started_again(self) -> Path:
        """The line that says when and why the server was last ended and started by itself."""
        return self.root / "run" / "started-again.txt"

    @property
    def memory_file(self) -> Path:
        """The JSON of ``Memory``."""
        return self.root / "run" / "server.json"

    def create(self) -> None:
        """Make the folders, closed to everybody else."""
        with explain_os_error(f"cannot use {self.root} for the data of the local Neo4j"):
            self.root.mkdir(mode=0o700, parents=True, exist_ok=True)
            self.root.chmod(0o700)
            for folder in (self.configuration, self.console_log.parent, self.arguments.parent):
                folder.mkdir(exist_ok=True)

    @contextmanager
    def locked(self, say: Say = silent) -> Iterator[None]:
        """Hold the home against every other foon command that would start or stop the server.

        ``say`` hears that another one is waited for.
        """
        self.create()
        lock = FileLock(self.root / "run" / "lock")
        try:
            lock.acquire(timeout=1)
        except Timeout:
            say("waiting for another foon command that starts or stops the local Neo4j")
            self._acquire_at_last(lock)
        try:
            yield
        finally:
            lock.release()

    def _acquire_at_last(self, lock: FileLock) -> None:
        try:
            lock.acquire(timeout=LOCK_SECONDS)
        except Timeout as error:
            raise ServerError(
                f"another foon command has been starting or stopping the server in {self.root} for {LOCK_SECONDS} s",
                hint="wait for it or end it, then try again",
                code="locked",
            ) from error

    def recall(self) -> Memory | None:
        """Return what is remembered: nothing (None) where the file is missing or is not one that foon-kg wrote."""
        with explain_os_error(f"cannot read {self.memory_file}"):
            try:
                return Memory(**json.loads(self.memory_file.read_text(encoding="utf-8")))
            except (FileNotFoundError, ValueError, TypeError):
                return None

    def remember(self, memory: Memory) -> None:
        """Write down the ``memory``: what the next command has to know."""
        with explain_os_error(f"cannot write {self.memory_file}"):
            write_private(self.memory_file, json.dumps(asdict(memory)) + "\n")


def home() -> Home:
    """Return the home that the environment names."""
    chosen = os.environ.get("FOON_KG_HOME")
    if chosen:
        return Home(Path(chosen).expanduser().resolve())
    import platformdirs  # noqa: PLC0415 - only where nobody named a home

    return Home((platformdirs.user_data_path("foon-kg", appauthor=False) / "neo4j").expanduser().resolve())
