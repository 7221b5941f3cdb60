"""What a person types may change the graph where that was asked for: whole and counted, in time, or not at all."""

from __future__ import annotations

import logging
import re
from concurrent.futures import ThreadPoolExecutor

import neo4j
import pytest

from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection, free_cypher
from foon_kg.store.graph.free_cypher import ask_freely

pytestmark = pytest.mark.neo4j


def test_with_write_the_graph_changes_and_the_changes_are_counted(empty_graph):
    with Connection(empty_graph) as connection:
        made = ask_freely(connection, "CREATE (n:Note {text: 'x'}) RETURN n.text AS text", write=True)
        assert made.rows == (("x",),)
        assert made.changes == {"labels_added": 1, "nodes_created": 1, "properties_set": 1}
        assert ask_freely(connection, "MATCH (n:Note) RETURN count(n) AS n").rows == ((1,),)


def test_what_a_profiled_write_changed_is_counted(empty_graph):
    with Connection(empty_graph) as connection:
        told = ask_freely(connection, "PROFILE CREATE (n:Note {text: 'x'})", write=True)
        assert told.columns[-1] == "db_hits"
        assert told.changes == {"labels_added": 1, "nodes_created": 1, "properties_set": 1}


def test_the_size_of_a_path_counts(empty_graph, monkeypatch):
    monkeypatch.setattr(free_cypher, "LARGEST_ANSWER", 1_000)
    with Connection(empty_graph) as connection:
        made = "CREATE (:Note {text: $text})-[:NEXT {text: $text}]->(:Note {text: $text})"
        ask_freely(connection, made, {"text": "a" * 300}, write=True)
        path = "MATCH p = (:Note)-[:NEXT]->(:Note) RETURN "
        assert len(ask_freely(connection, path + "p").rows) == 1
        with pytest.raises(GraphError, match="larger than"):
            ask_freely(connection, path + "p, p AS again")


def test_of_a_change_whose_answer_is_too_large_nothing_stays(empty_graph, monkeypatch):
    monkeypatch.setattr(free_cypher, "LARGEST_ANSWER", 1_000)
    with Connection(empty_graph) as connection:
        with pytest.raises(GraphError, match="larger than") as large:
            ask_freely(connection, "CREATE (:Note) RETURN range(1, 1000) AS n", write=True)
        assert "stays" not in large.value.hint
        assert ask_freely(connection, "MATCH (n:Note) RETURN count(n)").rows == ((0,),)


def test_of_a_change_in_transactions_of_its_own_it_is_said_that_some_stays(empty_graph, monkeypatch):
    monkeypatch.setattr(free_cypher, "LARGEST_ANSWER", 1_000)
    text = "UNWIND range(1, 3) AS i CALL (i) { CREATE (:Note) } IN TRANSACTIONS OF 1 ROWS RETURN range(1, 1000) AS n"
    with Connection(empty_graph) as connection:
        with pytest.raises(GraphError, match="larger than") as large:
            ask_freely(connection, text, write=True)
        assert "its earlier transactions changed stays" in large.value.hint
        assert ask_freely(connection, "MATCH (n:Note) RETURN count(n) > 0").rows == ((True,),)


def test_two_changes_that_wait_for_each_other_are_made_one_after_the_other(empty_graph, caplog):
    """Neo4j ends one of them, of which nothing stays: it is the one that holds fewer locks."""
    settings = empty_graph
    typed = "MATCH (b:Note {k: 0}) SET b.by = 'typed' WITH b MATCH (a:Note {k: 1}) SET a.by = 'typed'"
    with (
        Connection(settings) as connection,
        neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver,
        ThreadPoolExecutor(1) as another,
        driver.session() as session,
    ):
        driver.execute_query("UNWIND range(0, 200) AS k CREATE (:Note {k: k})")
        caplog.set_level(logging.DEBUG, "neo4j.io")
        with session.begin_transaction() as held:
            held.run("MATCH (n:Note) WHERE n.k > 0 SET n.by = 'held'").consume()
            waiting = another.submit(ask_freely, connection, typed, write=True, timeout=300)
            blocked = "SHOW TRANSACTIONS YIELD status WHERE status STARTS WITH 'Blocked' RETURN status"
            while not driver.execute_query(blocked).records and not waiting.done():
                pass
            held.run("MATCH (n:Note {k: 0}) SET n.by = 'held'").consume()
            held.commit()
        assert waiting.result().changes == {"properties_set": 2}
        first, *_, last = limits_told(caplog)
        assert first > last
        by = driver.execute_query("MATCH (n:Note) RETURN n.by AS by, count(n) AS n").records
        assert {row["by"]: row["n"] for row in by} == {"typed": 2, "held": 199}


@pytest.mark.parametrize(
    ("text", "write", "times"),
    [
        ("MATCH (n:Objct) RETURN [x IN [1] | n.labl]", False, 4),  # its plan, two lists of names, itself
        ("MATCH (n:Objct) SET n.x = [x IN [1] | x]", True, 3),  # two plans, itself
    ],
)
def test_all_that_a_server_is_asked_has_one_deadline(empty_graph, caplog, text, write, times):
    with Connection(empty_graph) as connection, caplog.at_level(logging.DEBUG, "neo4j.io"):
        ask_freely(connection, text, write=write, timeout=20)
    left = limits_told(caplog)
    assert len(left) == times
    assert left == sorted(left, reverse=True)
    assert 20_000 >= left[0] > left[-1]


def limits_told(caplog):
    """Return the milliseconds that the server was given for each question."""
    return [int(found) for found in re.findall(r"'tx_timeout': (\d+)", caplog.text)]
