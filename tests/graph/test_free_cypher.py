"""What a person types only looks at the graph, unless writing was asked for."""

from __future__ import annotations

import neo4j
import pytest
from kitchen_stories import SALAD, subgraph

from foon_kg.model.errors import GraphError, WriteRefused
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely

pytestmark = pytest.mark.neo4j

DATA = (
    "CREATE (n:Video {name: 'x'})",
    "MERGE (v:Video {name: 'x'})",
    "MATCH (n) DETACH DELETE n",
    "MATCH (o:Object) SET o.label = 'x'",
    "MATCH (o:Object) SET o:Motion",
    "MATCH (o:Object) SET o += {label: 'x'}",
    "MATCH (o:Object) REMOVE o.start",
    "MATCH ()-[r:SEEN_IN]->() DELETE r",
    "MATCH (o:Object), (m:Motion) CREATE (o)-[:INPUT_OF]->(m)",
    "UNWIND range(1, 3) AS i CREATE (:Video {name: i})",
    "FOREACH (i IN range(1, 3) | CREATE (:Video {name: i}))",
    "CALL () { CREATE (n:Video {name: 'x'}) RETURN n } RETURN n",
    "MATCH (o:Object) WITH o LIMIT 1 SET o.label = 'x' RETURN o",
    "RETURN 1 AS one UNION CREATE (n:Video {name: 'x'}) RETURN 1 AS one",
    "MATCH (n) RETURN n; MATCH (n) DETACH DELETE n",
    "CALL db.createLabel('x')",
    "CALL db.createProperty('x')",
    "CALL db.createRelationshipType('X')",
)
DISGUISED = (
    "CYPHER 5 CREATE (n:Video {name: 'x'})",
    "CYPHER 25 CREATE (n:Video {name: 'x'})",
    "CYPHER 25 RETURN 1 AS one NEXT CREATE (n:Video {name: 'x'})",
    "CYPHER runtime=slotted CREATE (n:Video {name: 'x'})",
    "PROFILE CREATE (n:Video {name: 'x'})",
    "EXPLAIN CREATE (n:Video {name: 'x'})",
    "CYPHER 25 PROFILE CREATE (n:Video {name: 'x'})",
    "cReAtE (n:Video {name: 'x'})",
    "\\u0043REATE (n:Video {name: 'x'})",
    "/* MATCH (n) RETURN n */ CREATE (n:Video {name: 'x'})",
    "// MATCH (n) RETURN n\nCREATE (n:Video {name: 'x'})",
    "MATCH (n) // RETURN n\nDETACH DELETE n",
    "\u00a0\u2003CREATE\u2003(n:Video {name: 'x'})",
    "\ufeffCREATE (n:Video {name: 'x'})",
    "\n\n\t  CREATE (n:Video {name: 'x'})  ;",
    "USE neo4j CREATE (n:Video {name: 'x'})",
    "// EXPLAIN",
    "*/ CREATE (n:Video {name: 'x'})",
)
SCHEMA = (
    "CREATE INDEX x FOR (o:Object) ON (o.verb)",
    "DROP INDEX object_label",
    "DROP CONSTRAINT object_key",
    "CREATE CONSTRAINT x FOR (o:Object) REQUIRE o.verb IS UNIQUE",
    "CREATE FULLTEXT INDEX x FOR (o:Object) ON EACH [o.verb]",
    "CREATE LOOKUP INDEX x FOR (n) ON EACH labels(n)",
)
SERVER = (
    "CREATE USER mallory SET PASSWORD 'very-secret'",
    "DROP USER neo4j",
    "ALTER USER neo4j SET PASSWORD 'very-secret'",
    "ALTER CURRENT USER SET PASSWORD FROM 'a' TO 'very-secret'",
    "RENAME USER neo4j TO mallory",
    "CREATE DATABASE other",
    "DROP DATABASE neo4j",
    "STOP DATABASE neo4j",
    "GRANT ROLE admin TO neo4j",
    "TERMINATE TRANSACTIONS 'neo4j-transaction-1'",
    "SHOW TRANSACTIONS",
    "SHOW USERS",
    "SHOW CURRENT USER",
    "SHOW DATABASES",
    "SHOW SETTINGS",
    "SHOW PROCEDURES",
    "SHOW FUNCTIONS",
    "SHOW INDEXES",
    "SHOW CONSTRAINTS YIELD name RETURN name",
    "CYPHER 25 SHOW TRANSACTIONS",
    "CALL tx.setMetaData({name: 'x'})",
    "CALL db.clearQueryCaches()",
    "CALL `db`.`clearQueryCaches`()",
    "CALL db.prepareForReplanning()",
    "CALL db.resampleIndex('object_label')",
    "CALL db.stats.clear('QUERIES')",
    "CALL db.stats.collect('QUERIES')",
    "CALL dbms.killConnection('bolt-1')",
    "CALL dbms.listConnections()",
    "CALL dbms.listConfig()",
    "CALL dbms.setConfigValue('db.logs.query.enabled', 'off')",
)
OUTSIDE = (
    "LOAD CSV FROM 'file:///etc/passwd' AS line RETURN line",
    "LOAD CSV FROM 'http://127.0.0.1:9/x.csv' AS line RETURN line",
    "LOAD CSV WITH HEADERS FROM 'https://127.0.0.1:9/x.csv' AS line RETURN line",
    "LOAD CSV FROM 'ftp://127.0.0.1:9/x.csv' AS line RETURN line",
    "MATCH (o:Object) CALL (o) { LOAD CSV FROM 'file:///etc/passwd' AS line RETURN line } RETURN line",
    "CYPHER 25 RETURN COLLECT { LOAD CSV FROM 'file:///etc/passwd' AS line RETURN line } AS lines",
    "LOAD CSV FROM $where AS line CREATE (:Video {name: line[0]})",
)
IN_TRANSACTIONS = (
    "UNWIND range(1, 3) AS i CALL (i) { CREATE (:Video {name: i}) } IN TRANSACTIONS",
    "MATCH (n) CALL (n) { DETACH DELETE n } IN TRANSACTIONS OF 1 ROWS",
    "MATCH (n) CALL (n) { DETACH DELETE n } IN 2 CONCURRENT TRANSACTIONS OF 1 ROWS ON ERROR CONTINUE",
    "MATCH (v:Video) CALL (v) { RETURN v.name AS name } IN TRANSACTIONS RETURN name",
)
ATTEMPTS = (*DATA, *DISGUISED, *SCHEMA, *SERVER, *OUTSIDE, *IN_TRANSACTIONS)

LOOKS = (
    "MATCH (o:Object) RETURN o.label AS label ORDER BY label LIMIT 1",
    "CYPHER 5 MATCH (o:Object) RETURN count(*) AS n",
    "CYPHER 25 MATCH (o:Object) RETURN count(*) AS n",
    "// the words CREATE and DELETE in a comment\nMATCH (o:Object) RETURN count(*) AS n",
    "RETURN 'CREATE (n)' AS text",
    "CALL db.labels() YIELD label RETURN label ORDER BY label",
    "CALL db.labels",
    "CALL db.index.fulltext.queryNodes('object_words', 'onion') YIELD node RETURN node.label AS label",
    "CALL db.schema.visualization()",
    "EXPLAIN MATCH (n) RETURN n",
)


@pytest.fixture(scope="module")
def everything(neo4j_server):
    """A graph with one video, a connection to it, and a look at everything that must not change."""
    login = (neo4j_server.user, neo4j_server.password)
    with (
        Connection(neo4j_server) as connection,
        neo4j.GraphDatabase.driver(neo4j_server.uri, auth=login, warn_notification_severity="OFF") as driver,
    ):
        load(connection, [subgraph("salad", "salad", *SALAD)])

        def look():
            def rows(text):
                found = driver.execute_query(text, database_=neo4j_server.database).records
                return sorted(repr(record.values()) for record in found)

            return (
                rows("MATCH (n) RETURN labels(n), properties(n)"),
                rows("MATCH (a)-[r]->(b) RETURN elementId(a), type(r), properties(r), elementId(b)"),
                rows("SHOW INDEXES YIELD name, type, labelsOrTypes, properties"),
                rows("SHOW CONSTRAINTS YIELD name, type"),
                rows("SHOW USERS YIELD user"),
                rows("SHOW DATABASES YIELD name, currentStatus"),
                rows("CALL db.labels()"),
                rows("CALL db.propertyKeys()"),
                rows("CALL db.relationshipTypes()"),
            )

        yield connection, look


def test_there_are_more_than_sixty_different_attempts():
    assert len(set(ATTEMPTS)) == len(ATTEMPTS) > 60


@pytest.mark.parametrize("attempt", ATTEMPTS)
def test_an_attempt_to_do_more_than_look_is_refused_and_nothing_has_changed(everything, attempt):
    connection, look = everything
    before = look()
    with pytest.raises(GraphError) as refused:
        ask_freely(connection, attempt, {"where": "file:///etc/passwd"})
    assert refused.value.hint
    assert look() == before


@pytest.mark.parametrize("attempt", [*DATA[:14], *SCHEMA, *OUTSIDE[:5], *IN_TRANSACTIONS])
def test_a_plain_attempt_is_told_that_it_was_refused_and_how_to_write(everything, attempt):
    with pytest.raises(WriteRefused) as refused:
        ask_freely(everything[0], attempt)
    assert "--write" in refused.value.hint


@pytest.mark.parametrize("question", LOOKS)
def test_a_look_is_answered(everything, question):
    assert ask_freely(everything[0], question).changes == {}


def test_parameters_are_values(everything):
    answer = ask_freely(everything[0], "RETURN $x AS x, $y.z AS y", {"x": "'}) DETACH DELETE n", "y": {"z": [1, 2]}})
    assert (answer.columns, answer.rows) == (("x", "y"), (("'}) DETACH DELETE n", [1, 2]),))


def test_more_rows_than_the_limit_are_cut_and_said_to_be(everything):
    answer = ask_freely(everything[0], "UNWIND range(1, 100000) AS i RETURN i", limit=3)
    assert (answer.rows, answer.cut) == (((1,), (2,), (3,)), True)
    assert not ask_freely(everything[0], "UNWIND range(1, 3) AS i RETURN i", limit=3).cut


def test_a_question_that_takes_too_long_is_given_up(everything):
    endless = "UNWIND range(1, 100000) AS a UNWIND range(1, 100000) AS b WITH a, b WHERE a + b < 0 RETURN count(*) AS n"
    with pytest.raises(GraphError, match=r"no answer within 0\.5 seconds") as late:
        ask_freely(everything[0], endless, timeout=0.5)
    assert "--timeout" in late.value.hint


def test_what_is_no_cypher_is_told_as_the_database_tells_it(everything):
    with pytest.raises(GraphError, match="Invalid input"):
        ask_freely(everything[0], "MAKE ME A SANDWICH")


def test_with_write_the_graph_changes_and_the_changes_are_counted(empty_graph):
    with Connection(empty_graph) as connection:
        made = ask_freely(connection, "CREATE (n:Note {text: 'x'}) RETURN n.text AS text", write=True)
        assert made.rows == (("x",),)
        assert made.changes == {"labels_added": 1, "nodes_created": 1, "properties_set": 1}
        assert ask_freely(connection, "MATCH (n:Note) RETURN count(n) AS n").rows == ((1,),)
