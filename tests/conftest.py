"""What several test folders need: above all a real Neo4j.

Which Neo4j: the one that ``NEO4J_URI`` names (it must be empty, or ``FOON_KG_TEST_ERASE=yes`` be set, because the tests
erase it); else a container where a Docker engine answers; else foon-kg's own local server on a home of its own. A run
without any fails, it never skips. One server serves all workers of pytest-xdist, and ends with the run.

Neo4j Community has one database, so tests marked ``neo4j`` must not run beside each other: they all go to one worker
(``--dist=loadgroup`` in pyproject.toml, the group is given here). Whoever wants an empty graph asks ``empty_graph``;
without constraints and indexes it is a ``bare_graph``, at ten times the CPU: Neo4j forgets whatever it has compiled
when an index comes or goes. In ``make campaign``, whose tests mostly wait, each worker has a local server of its own
instead.
"""

from __future__ import annotations

import gc
import json
import os
import shutil
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Set
from dataclasses import asdict
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

import hypothesis
import neo4j
import pytest
from chromium import chromium
from examples import examples
from filelock import FileLock

from foon_kg.cypher import schema_parts
from foon_kg.model.errors import FoonError
from foon_kg.store.graph import Connection, Neo4jGraph
from foon_kg.store.server import ConnectionSettings, connection_from_environment

if TYPE_CHECKING:
    import docker
    from selenium.webdriver.chrome.webdriver import WebDriver

IMAGE = "neo4j:2026.09.0-community"
SESSION_FOLDER = "FOON_KG_TEST_SESSION"
CAMPAIGN = os.environ.get("FOON_KG_CAMPAIGN") == "yes"
OWN_SERVERS = CAMPAIGN and connection_from_environment() is None
"""Whether each worker has a local server: nothing is shared then, and the tests of the database need no group."""

QUICKLY_COMPILED = "-XX:TieredStopAtLevel=1"
"""A server of tests lives for minutes: what Java spends to compile well, two fifths of its CPU, it never gets back."""

EXAMPLES = 40
"""On so many a property is tried that says no other number."""

PLANNED_ONCE = "dbms.cypher.min_replan_interval", "1h"
"""A graph that comes and goes would have Neo4j plan each query anew every ten seconds, a third of its CPU; it still
does so when an index comes or goes."""

MANY_FILES = 4
"""For each worker: of fewer files each test is sent by itself, and nobody waits for the longest file."""

LONGEST_ID = 100
"""Characters of a parameter that a test is called by: one of four million was sent to each worker and back again."""

OURS = schema_parts()
"""The constraints and indexes of foon-kg by their names."""

# a test never depends on how quick the machine is; what else Hypothesis has chosen for this place (CI) stays
hypothesis.settings.register_profile("untimed", examples(EXAMPLES, base=hypothesis.settings()))
hypothesis.settings.load_profile("untimed")


def pytest_configure(config: pytest.Config) -> None:
    """Make the folder in which the workers of this run agree on one server, or each keeps its own."""
    if not hasattr(config, "workerinput") or OWN_SERVERS:
        os.environ[SESSION_FOLDER] = tempfile.mkdtemp(prefix="foon-kg-test-")
        os.environ.setdefault("JAVA_TOOL_OPTIONS", QUICKLY_COMPILED)


def pytest_unconfigure(config: pytest.Config) -> None:
    """End the server of this run, or of this worker, if it is ours."""
    if (hasattr(config, "workerinput") and not OWN_SERVERS) or SESSION_FOLDER not in os.environ:
        return
    folder = Path(os.environ.pop(SESSION_FOLDER))
    if (folder / "container").exists():
        _docker().containers.get((folder / "container").read_text()).remove(force=True, v=True)
    if (folder / "home").exists():
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("FOON_KG_HOME", str(folder / "home"))
            from foon_kg.store.server import stop

            stop()
    shutil.rmtree(folder)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """Look for no garbage while tests are collected: they stay, and to look at them took a quarter of the time.

    After that it is looked for again, but seldom, and not among the ten thousand tests that stay to the end.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(100_000, 50, 100)
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave to ``make campaign`` what is marked so; send all tests of the database to one worker; a browser is slow."""
    if not CAMPAIGN:
        left_out = [item for item in items if item.get_closest_marker("campaign")]
        items[:] = [item for item in items if not item.get_closest_marker("campaign")]
        config.hook.pytest_deselected(items=left_out)
    for item in items:
        if item.get_closest_marker("neo4j") and not OWN_SERVERS:
            item.add_marker(pytest.mark.xdist_group("neo4j"))
        if "browser" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.slow)
    slow = Counter(item.path for item in items if item.get_closest_marker("slow"))
    # the longest first, so that no worker waits for another in the end: what is in a group, then files of slow tests
    items.sort(key=lambda item: (0, 0) if item.get_closest_marker("xdist_group") else (1, -slow[item.path]))


def pytest_make_parametrize_id(val: object) -> str | None:
    """Return what a long text is called among the parameters of a test; whatever else is called as usual."""
    if isinstance(val, str | bytes) and len(val) > LONGEST_ID:
        return f"{val[:LONGEST_ID]!a} and {len(val) - LONGEST_ID} more"
    return None


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """Return how many workers ``-n auto`` has: one for each core, and one more where slow tests are among them.

    These wait as long as they work, for a browser, a server that starts, or Neo4j: a third of the cores' time was idle.
    """
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return cores + ("not slow" not in config.option.markexpr)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> object | None:
    """Send what is in no group to the workers file by file: what a module makes for its tests is made once."""
    if config.getvalue("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadGroupScheduling

    class ByGroupOrFile(LoadGroupScheduling):
        @cached_property
        def _has_many_files(self) -> bool:
            return len({nodeid.partition("::")[0] for nodeid in self.collection}) > MANY_FILES * len(self.nodes)

        def _split_scope(self, nodeid: str) -> str:
            scope = super()._split_scope(nodeid)
            return nodeid.partition("::")[0] if scope == nodeid and self._has_many_files else scope

    return ByGroupOrFile(config, log)


def pytest_collection_finish(session: pytest.Session) -> None:
    """Refuse to run where pytest-xdist does not keep that group together: the tests would erase each other's graph."""
    if getattr(session.config.option, "loadgroup", False) and not OWN_SERVERS:
        apart = [item.nodeid for item in session.items if item.get_closest_marker("neo4j") and "@" not in item.nodeid]
        if apart:
            pytest.exit(f"pytest-xdist does not group {apart[0]}: this pytest is too new for it", returncode=3)


@pytest.fixture(scope="session")
def neo4j_server() -> ConnectionSettings:
    """A real Neo4j for the whole run: ``uri``, ``user``, ``password``, ``database``."""
    folder = Path(os.environ[SESSION_FOLDER])
    record = folder / "neo4j.json"
    with FileLock(folder / "neo4j.lock"):
        if not record.exists():
            settings = _named() or _container(folder) or _own_server(folder)
            record.write_text(json.dumps(asdict(settings)))
    return ConnectionSettings(**json.loads(record.read_text()))


@pytest.fixture(scope="module")
def emptied_server(neo4j_server: ConnectionSettings) -> ConnectionSettings:
    """The server with no node in its database when the module begins, and foon-kg's constraints and indexes alone."""
    with _alone():
        erase(neo4j_server, keeping=OURS)
    return neo4j_server


@pytest.fixture(scope="module")
def bare_server(neo4j_server: ConnectionSettings) -> ConnectionSettings:
    """The server, bare when the module begins: how Neo4j plans a query depends on what is left in the database."""
    with _alone():
        erase(neo4j_server)
    return neo4j_server


@pytest.fixture
def bare_graph(neo4j_server: ConnectionSettings) -> Iterator[ConnectionSettings]:
    """The server with nothing in its database, neither constraint nor index, for this test alone."""
    with _alone():
        erase(neo4j_server)
        yield neo4j_server


@pytest.fixture
def empty_graph(neo4j_server: ConnectionSettings) -> Iterator[ConnectionSettings]:
    """The server with no node in its database, and foon-kg's constraints and indexes alone, for this test alone."""
    with _alone():
        erase(neo4j_server, keeping=OURS)
        yield neo4j_server


@pytest.fixture
def connection(empty_graph: ConnectionSettings) -> Iterator[Connection]:
    """An open connection to the empty graph, to load and to ask."""
    with Connection(empty_graph) as connection:
        yield connection


@pytest.fixture
def graph(empty_graph: ConnectionSettings) -> Iterator[Neo4jGraph]:
    """The empty graph as the planner opens it."""
    with Neo4jGraph(empty_graph) as graph:
        yield graph


def _alone() -> FileLock:
    """Return what keeps the tests of other workers from the graph."""
    return FileLock(Path(os.environ[SESSION_FOLDER]) / "graph.lock")


MOST_ROUNDS = 100
BECAME_A_CONSTRAINT = "Neo.DatabaseError.Schema.IndexDropFailed"
CONSTRAINTS = "SHOW CONSTRAINTS YIELD name"
INDEXES = "SHOW INDEXES YIELD name, type, owningConstraint WHERE type <> 'LOOKUP' AND owningConstraint IS NULL"


def erase(settings: ConnectionSettings, keeping: Mapping[str, str] = MappingProxyType({})) -> None:
    """Delete every node, relationship, constraint and index of the database.

    ``keeping`` are constraints and indexes by name, with the statement that makes each: they are there afterwards.
    """
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:

        def run(query: str) -> list[neo4j.Record]:
            return driver.execute_query(neo4j.Query(query), database_=settings.database).records

        kept = _drop_schema(run, keeping.keys())
        run("MATCH (n) DETACH DELETE n")
        if missing := keeping.keys() - kept:
            for name in sorted(missing):
                run(keeping[name])
            run("CALL db.awaitIndexes()")


def _drop_schema(run: Callable[[str], list[neo4j.Record]], keeping: Set[str]) -> Set[str]:
    """Drop every constraint and index but those to keep; return which of them are there."""
    # a program that was killed may still have a statement running: what it makes is dropped in the next round
    for _ in range(MOST_ROUNDS):
        constraints, indexes = ({row["name"] for row in run(query)} for query in (CONSTRAINTS, INDEXES))
        if constraints | indexes <= keeping:
            break
        for name in constraints - keeping:
            run(f"DROP CONSTRAINT `{name}` IF EXISTS")
        for name in indexes - keeping:
            try:
                run(f"DROP INDEX `{name}` IF EXISTS")
            except neo4j.exceptions.DatabaseError as error:
                if error.code != BECAME_A_CONSTRAINT:
                    raise
    return constraints | indexes


def _named() -> ConnectionSettings | None:
    settings = connection_from_environment()
    if settings is None:
        return None
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        try:
            count = driver.execute_query("MATCH (n) RETURN count(n) AS n", database_=settings.database).records[0]["n"]
        except (neo4j.exceptions.DriverError, neo4j.exceptions.Neo4jError) as error:
            pytest.fail(f"NEO4J_URI is {settings.uri}, and that Neo4j cannot be used: {error}", pytrace=False)
    if count and os.environ.get("FOON_KG_TEST_ERASE") != "yes":
        pytest.fail(
            f"the tests erase the database, and {settings.uri} holds {count} nodes: empty it, unset NEO4J_URI, "
            "or set FOON_KG_TEST_ERASE=yes",
            pytrace=False,
        )
    return settings


def _docker() -> docker.DockerClient:
    """Return the client of the Docker engine that the environment names."""
    import docker

    return docker.from_env()


def _container(folder: Path) -> ConnectionSettings | None:
    """Start a container where a Docker engine answers; None where none does."""
    from docker.errors import DockerException
    from testcontainers.community.neo4j import Neo4jContainer

    try:
        _docker().ping()
    except DockerException:
        return None
    os.environ["TESTCONTAINERS_RYUK_DISABLED"] = "true"  # the container outlives the worker that starts it
    container = Neo4jContainer(IMAGE, password="tests-only")
    name, value = PLANNED_ONCE
    container.with_env("NEO4J_" + name.replace("_", "__").replace(".", "_"), value)
    container.start()
    (folder / "container").write_text(container.get_wrapped_container().id)
    return ConnectionSettings(container.get_connection_url(), "neo4j", "tests-only", "neo4j")


def _own_server(folder: Path) -> ConnectionSettings:
    from foon_kg.store.server import configuration, start

    usual = configuration.neo4j_conf
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FOON_KG_HOME", str(folder / "home"))
        patch.setattr(configuration, "neo4j_conf", lambda port: usual(port) + "=".join(PLANNED_ONCE) + "\n")
        try:
            return start(idle_minutes=60, after_start=lambda _settings: None)
        except FoonError as error:
            pytest.fail(f"no Neo4j for the tests: {error.message} ({error.hint})", pytrace=False)


@pytest.fixture(scope="session")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[WebDriver]:
    """A real Chromium, for the tests of pages."""
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        yield driver
