"""A database that does not answer as it should is told about in one sentence, with what to do."""

from __future__ import annotations

import socket
import socketserver
import threading
from dataclasses import replace

import pytest

from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.graph.warming import warm
from foon_kg.store.settings import ConnectionSettings


@pytest.fixture
def nobody():
    """An address at which nobody listens."""
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        yield ConnectionSettings(f"bolt://127.0.0.1:{taken.getsockname()[1]}")


def test_a_database_that_is_down_is_said_to_be(nobody):
    with Neo4jGraph(nobody) as graph, pytest.raises(GraphError, match="no Neo4j answers at") as error, graph.reading():
        pass
    assert "NEO4J_URI" in error.value.hint


def test_a_read_is_not_tried_again_and_again_where_no_neo4j_is():
    callers = []

    class HangUp(socketserver.BaseRequestHandler):
        def handle(self):
            callers.append(self.client_address)

    with socketserver.TCPServer(("127.0.0.1", 0), HangUp) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        settings = ConnectionSettings(f"bolt://127.0.0.1:{server.server_address[1]}")
        with (
            Connection(settings) as connection,
            pytest.raises(GraphError, match="no Neo4j answers at"),
            connection.session() as session,
        ):
            session.execute_read(lambda work: work.run("RETURN 1").consume())
        server.shutdown()
    assert len(callers) == 1


@pytest.mark.parametrize("scheme", ["bolt", "neo4j"])
def test_who_takes_a_connection_and_says_nothing_is_no_neo4j(scheme, monkeypatch):
    monkeypatch.setattr("foon_kg.store.graph.connection._ANSWER_SECONDS", 0.2)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        settings = ConnectionSettings(f"{scheme}://127.0.0.1:{silent.getsockname()[1]}")
        with (
            Connection(settings) as connection,
            pytest.raises(GraphError, match="no Neo4j answers at") as error,
            connection.session() as session,
        ):
            session.run("RETURN 1").consume()
    assert error.value.code == "unreachable"


def test_an_address_that_is_none_is_said_to_be():
    settings = ConnectionSettings("http://localhost")
    with Neo4jGraph(settings) as graph, pytest.raises(GraphError, match="http://localhost") as error, graph.reading():
        pass
    assert "NEO4J_URI" in error.value.hint


@pytest.mark.neo4j
def test_a_wrong_password_is_said_to_be(neo4j_server):
    wrong = replace(neo4j_server, password="wrong-password")
    with Neo4jGraph(wrong) as graph, pytest.raises(GraphError, match="does not let") as error, graph.reading():
        pass
    assert "NEO4J_PASSWORD" in error.value.hint


@pytest.mark.neo4j
def test_an_unknown_database_is_said_to_be(neo4j_server):
    elsewhere = replace(neo4j_server, database="nowhere")
    with Connection(elsewhere) as connection, pytest.raises(GraphError, match="nowhere") as error:
        load(connection, [])
    assert "NEO4J_DATABASE" in error.value.hint


def test_warming_a_database_that_is_down_is_no_error(nobody):
    warm(nobody)
    with Neo4jGraph(nobody) as graph, pytest.raises(GraphError, match="no Neo4j answers at"), graph.reading():
        pass


@pytest.mark.neo4j
def test_warming_an_empty_database_writes_nothing_into_it(bare_graph):
    warm(bare_graph)
    for question in ("MATCH (n) RETURN count(n)", "SHOW CONSTRAINTS YIELD name RETURN count(name)"):
        with Connection(bare_graph) as connection, connection.session() as session:
            assert session.run(question).single().value() == 0
