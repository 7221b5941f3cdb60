"""Java's ahead-of-time cache: classes already loaded and linked, so that the server starts in half the time.

Java 25 makes it in two steps (JEP 483, JEP 514): a run that records, and a run that builds the file. Recording takes a
whole start and stop, so it is done on a throw-away home, in the background, by the process that watches the server.
"""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

import psutil
from filelock import FileLock, Timeout

from foon_kg.model.errors import FoonError, ServerError
from foon_kg.model.kept import cache_folder, write_private
from foon_kg.store.server import process as processes
from foon_kg.store.server.home import Home
from foon_kg.store.server.jars import JarSet, pinned, sha256_of
from foon_kg.store.server.java import FLAGS, java, java_version, write_arguments
from foon_kg.store.server.launch import launched
from foon_kg.store.server.verified import other_than
from foon_kg.store.settings import ConnectionSettings

UNUSED_SECONDS = 60 * 86_400
RECORDING_SECONDS = 600
"""So long Java may take to stop where it records: it writes down what it has seen then, and nobody waits for it."""

DIGEST = ".sha256"
TRAINING_PREFIX = "training-"
TRAINING = (
    "CREATE CONSTRAINT IF NOT EXISTS FOR (n:Training) REQUIRE n.key IS UNIQUE",
    "UNWIND range(1, 200) AS i MERGE (n:Training {key: i}) SET n.even = i % 2 = 0",
    "MATCH (a:Training), (b:Training) WHERE a.key + 1 = b.key MERGE (a)-[:NEXT]->(b)",
    "MATCH (a:Training {key: 1})-[:NEXT*1..9]->(b) WITH DISTINCT b ORDER BY b.key RETURN collect(b.key) AS keys",
    "MATCH (n:Training) WHERE n.even DETACH DELETE n",
)
"""What the recorded run is asked, beside what foon-kg itself does: a schema, writes, a path, an aggregation."""


@dataclass(frozen=True, slots=True)
class StartupCache:
    """The cache for one set of jars (in ``folder``), one Java and one set of flags; any other has another file."""

    jar_set: JarSet
    folder: Path

    @property
    def file(self) -> Path:
        """The cache itself, about 150 MB."""
        flags = hashlib.sha256(" ".join([*FLAGS, str(java()), str(self.folder)]).encode()).hexdigest()[:8]
        return cache_folder() / f"startup-{self.jar_set.fingerprint}-{java_version()}-{flags}.aot"

    @property
    def why_not(self) -> Path:
        """The file that says why the cache could not be made the last time."""
        return self.file.with_suffix(".failed")

    @property
    def lock(self) -> Path:
        """The lock of whoever makes a cache."""
        return cache_folder() / "startup.lock"

    @property
    def digest(self) -> Path:
        """The file that says what the SHA-256 of the cache was when it was made; its time is that of the last use."""
        return self.file.with_suffix(DIGEST)

    def flags(self) -> list[str]:
        """Return the Java flags that use the cache, none while there is no cache."""
        if not self.file.exists():
            return []
        self.digest.touch()  # a cache in use is not swept away
        return [f"-XX:AOTCache={self.file}"]

    def is_as_made(self) -> bool:
        """Say whether the cache, if there is one, has the content that it was made with."""
        if not self.file.exists():
            return True
        made = self.digest.read_text(encoding="utf-8") if self.digest.exists() else ""
        return not other_than(cache_folder(), {self.file.name: made})

    def discard(self) -> bool:
        """Remove the cache; return whether there was one."""
        there = self.file.exists()
        self.file.unlink(missing_ok=True)
        self.digest.unlink(missing_ok=True)
        return there

    def state(self) -> str:
        """Return ``ready``, ``not made yet``, or why it could not be made."""
        if self.file.exists():
            return "ready"
        return self.why_not.read_text(encoding="utf-8").strip() if self.why_not.exists() else "not made yet"

    def make(self) -> None:
        """Make the cache unless it is there or is being made; takes half a minute of one core.

        Without it the server works all the same, so that a failure is no error: ``state`` tells it.
        """
        if self.file.exists():
            return
        try:
            with FileLock(self.lock, timeout=0):
                self._make()
                self.why_not.unlink(missing_ok=True)
        except Timeout:
            return
        except (FoonError, OSError) as error:
            self.why_not.write_text(f"could not be made: {error}\n", encoding="utf-8")

    def _make(self) -> None:
        recording = self.file.with_suffix(".recording")
        draft = self.file.with_suffix(".new")
        try:
            _sweep()
            self._record(recording)
            self._build(recording, draft)
            write_private(self.digest, sha256_of(draft))
            draft.replace(self.file)
        finally:
            recording.unlink(missing_ok=True)
            draft.unlink(missing_ok=True)

    def _record(self, recording: Path) -> None:
        flags = ["-XX:AOTMode=record", f"-XX:AOTConfiguration={recording}"]
        with tempfile.TemporaryDirectory(dir=cache_folder(), prefix=TRAINING_PREFIX) as folder:
            place = Home(Path(folder))
            place.create()
            with launched(place, processes.free_port(), self.jar_set, self.folder, flags) as (child, settings):
                processes.wait_for_answer(psutil.Process(child.pid), settings, place)
                _train(settings)
                processes.end(psutil.Process(child.pid), RECORDING_SECONDS)
                child.wait()
        if not recording.exists():
            raise ServerError("Java recorded nothing")

    def _build(self, recording: Path, draft: Path) -> None:
        flags = ["-XX:AOTMode=create", f"-XX:AOTConfiguration={recording}", f"-XX:AOTCache={draft}"]
        arguments = self.file.with_suffix(".args")
        try:
            command = write_arguments(arguments, self.jar_set.class_path(self.folder), flags, ())
            done = subprocess.run(command, cwd=cache_folder(), capture_output=True, text=True, check=False)
        finally:
            arguments.unlink(missing_ok=True)
        if done.returncode or not draft.exists():
            raise ServerError(
                f"Java built nothing (exit code {done.returncode}): {(done.stderr or done.stdout)[-500:]}"
            )


def the_startup_cache() -> StartupCache:
    """Return the cache for the jars that this version of foon-kg runs, where they are kept."""
    jar_set = pinned()
    return StartupCache(jar_set, cache_folder() / f"neo4j-{jar_set.version}")


def _sweep() -> None:
    """Remove caches that nobody uses any more, and what a training that was killed has left behind."""
    for digest in cache_folder().glob(f"startup-*{DIGEST}"):
        if digest.stat().st_mtime < time.time() - UNUSED_SECONDS:
            digest.with_suffix(".aot").unlink(missing_ok=True)
            digest.unlink()
    for folder in cache_folder().glob(f"{TRAINING_PREFIX}*"):
        if left := processes.find(Home(folder), None):
            processes.end(left)
        shutil.rmtree(folder)


def _train(settings: ConnectionSettings) -> None:
    """Use the server as foon-kg does, so that the recording has seen the classes which that needs.

    A FOON is loaded, that of the demo: a first load would wait for those that plan and run its statements.
    """
    import neo4j  # noqa: PLC0415 - slow to import, and needed only here

    from foon_kg.loaders import read_paths  # noqa: PLC0415 - the same
    from foon_kg.store.graph.connection import Connection  # noqa: PLC0415 - the same
    from foon_kg.store.graph.loading import load  # noqa: PLC0415 - the same
    from foon_kg.store.graph.warming import warm  # noqa: PLC0415 - the same

    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        for query in TRAINING:
            driver.execute_query(neo4j.Query(query))
    demo = Path(str(resources.files("foon_kg").joinpath("foon", "demo", "subgraphs")))
    with Connection(settings) as connection:
        load(connection, [result.subgraph for result in read_paths([demo]) if result.subgraph is not None])
    warm(settings)
