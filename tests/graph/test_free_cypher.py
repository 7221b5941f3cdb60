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
    "PROFILE EXPLAIN CREATE (n:Video {name: 'x'})",
    "PROFILE PROFILE CREATE (n:Video {name: 'x'})",
    "PROFILE CALL () { CREATE (n:Video {name: 'x'}) } RETURN 1 AS one",
    "CYPHER 25 SHOW INDEXES YIELD name CREATE (n:Video {name: name})",
    "SHOW INDEXES YIELD name CREATE (n:Video {name: name}) RETURN n",
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
    "SHOW ALL SETTINGS",
    "SHOW ALL PRIVILEGES",
    "SHOW INDEXES YIELD name SHOW SETTINGS YIELD value RETURN name, value",
    "SHOW CONSTRAINTS YIELD name TERMINATE TRANSACTIONS 'x' YIELD message RETURN message",
    "SHOW TEXT DATABASES",
    "EXPLAIN SHOW USERS",
    "PROFILE SHOW TRANSACTIONS",
    "RETURN 1 AS name UNION SHOW INDEXES YIELD name RETURN name",
    "CALL () { SHOW INDEXES YIELD name RETURN name } RETURN name",
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
    "SHOW INDEXES",
    "SHOW INDEX WHERE name = 'object_label'",
    "SHOW VECTOR INDEXES YIELD name RETURN name",
    "CYPHER 25 SHOW CONSTRAINTS YIELD name RETURN name",
    "EXPLAIN SHOW ALL CONSTRAINTS",
    "show node key constraints",
    "PROFILE MATCH (o:Object) RETURN count(*) AS n",
    "CYPHER 5 PROFILE MATCH (o:Object) RETURN count(*) AS n",
    "CYPHER runtime=slotted profile MATCH (o:Object) RETURN count(*) AS n",
)


@pytest.fixture(scope="module")
def everything(emptied_server):
    """A graph with one video, a connection to it, and a look at everything that must not change."""
    login = (emptied_server.user, emptied_server.password)
    with (
        Connection(emptied_server) as connection,
        neo4j.GraphDatabase.driver(emptied_server.uri, auth=login, warn_notification_severity="OFF") as driver,
    ):
        load(connection, [subgraph("salad", "salad", *SALAD)])

        def look():
            def rows(text):
                found = driver.execute_query(text, database_=emptied_server.database).records
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


def test_the_plan_of_a_question_is_an_answer_row_by_row(everything):
    text = "MATCH (o:Object {label: 'onion'}) RETURN o.states AS states"
    planned = ask_freely(everything[0], f"EXPLAIN {text}")
    assert planned.columns == ("operator", "details", "estimated_rows")
    assert planned.rows[0][0] == "ProduceResults"
    assert planned.rows[1][0].startswith("  ")
    profiled = ask_freely(everything[0], f"PROFILE {text}")
    assert profiled.columns[-2:] == ("rows", "db_hits")
    found = len(ask_freely(everything[0], text).rows)
    assert profiled.rows[0][3] == found > 0
    assert sum(row[4] for row in profiled.rows) > 0


def test_to_explain_what_would_write_writes_nothing(everything):
    connection, look = everything
    before = look()
    planned = ask_freely(connection, "EXPLAIN MATCH (n) DETACH DELETE n", write=True)
    assert "operator" in planned.columns
    assert look() == before


@pytest.mark.parametrize(
    ("text", "where", "mark"),
    [
        ("MATCH (o:Object) RETRN o", "(line 1, column 18)", "RETRN o"),
        ("  MATCH (o:Object)\n  RETURN x", "(line 2, column 10)", "x"),
        ("EXPLAIN MATCH (o:Object) RETURN x", "(line 1, column 33)", "x"),
        ("CYPHER 25\nPROFILE\nMATCH (o:Object) // all\nRETURN o.label,\n foo(o)", "(line 5, column 2)", "foo(o)"),
        ("/* what */ MATCH (o:Object RETURN o", "(line 1, column 28)", "RETURN o"),
    ],
)
@pytest.mark.parametrize("write", [False, True])
def test_an_error_stands_where_the_person_typed_it(everything, text, where, mark, write):
    with pytest.raises(GraphError) as told:
        ask_freely(everything[0], text, write=write)
    first, shown, pointer = told.value.message.split("\n")
    assert first.endswith(where)
    assert shown[pointer.index("^") :].startswith(mark)


def test_an_error_says_what_may_have_been_meant(everything):
    with pytest.raises(GraphError) as told:
        ask_freely(everything[0], "MATCH (o:Object) RETRN o")
    assert told.value.hint == "Did you mean RETURN?"
    with pytest.raises(GraphError) as told:
        ask_freely(everything[0], "MATCH (o:Object {label: $x, key: $y}) RETURN o")
    assert "-P x=VALUE -P y=VALUE" in told.value.hint


def test_names_that_nothing_in_the_graph_has_are_told(everything):
    answer = ask_freely(everything[0], "MATCH (n:Objct)-[:INPUTOF]->()\nRETURN n.labl, n.labl AS again")
    assert answer.rows == ()
    assert answer.warnings == (
        "no node has the label “Objct” (line 1, column 10): did you mean “Object”?",
        "no relationship has the type “INPUTOF” (line 1, column 19): did you mean “INPUT_OF”?",
        "nothing has the property “labl” (line 2, column 10): did you mean “label”?",
    )
    assert ask_freely(everything[0], "MATCH (n:Object) RETURN n.label AS label").warnings == ()


def test_nothing_is_logged_beside_the_answer(everything, caplog):
    ask_freely(everything[0], "MATCH (n:Objct) RETURN n")
    assert caplog.records == []


@pytest.mark.parametrize("write", [False, True])
@pytest.mark.parametrize("column", ["'ab' =~ '.*a.*b'", "[x IN [1, 2] | x ]", "[x IN ['ab'] | x =~ '.*a.*b']"])
def test_a_column_is_called_as_it_was_typed(everything, column, write):
    assert ask_freely(everything[0], f"RETURN {column}, 1 AS one", write=write).columns == (column, "one")


@pytest.mark.parametrize("write", [False, True])
@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("MATCH (n)\nWHERE n.name =~ '.*a.*b' RETURN\n nobody", "(line 3, column 2)"),
        ("MATCH (n) RETURN [x IN [1] | x], nobody", "(line 1, column 34)"),
        ("MATCH (n) WHERE n.name =~ '.*a.*b' RETRN n", "(line 1, column 36)"),
    ],
)
def test_an_error_stands_where_it_was_typed_though_other_words_are_asked(everything, text, where, write):
    with pytest.raises(GraphError) as told:
        ask_freely(everything[0], text, write=write)
    assert told.value.code == "cypher"
    first, shown, _ = told.value.message.split("\n")
    assert first.endswith(where)
    assert shown.strip() in text


def test_once_the_time_is_over_nothing_more_is_asked(everything):
    connection, look = everything
    before = look()
    with pytest.raises(GraphError) as late:
        ask_freely(connection, "CREATE (n:Note)", write=True, timeout=0)
    assert late.value.code == "timeout"
    assert look() == before
