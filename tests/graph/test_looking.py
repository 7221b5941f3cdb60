"""What is more than a look at the graph is refused by its words, wherever it stands in a question."""

from __future__ import annotations

import tracemalloc

import neo4j
import pytest
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.cypher import explore_queries
from foon_kg.model.errors import GraphError, WriteRefused
from foon_kg.store.graph import Connection
from foon_kg.store.graph.free_cypher import LARGEST_ANSWER, MOST_ON_THE_WIRE, ask_freely
from foon_kg.store.graph.looking import only_looking
from foon_kg.store.graph.question_words import DEEPEST, MOST_CHARACTERS, MOST_WORDS, read

INSIDE = {
    "a file": "LOAD CSV FROM 'file:///etc/passwd' AS l RETURN l",
    "an address": "LOAD CSV WITH HEADERS FROM 'http://127.0.0.1:9/x.csv' AS l RETURN l",
    "settings": "CALL dbms.listConfig() YIELD name RETURN name",
    "statistics": "CALL db.stats.clear('QUERIES') YIELD section RETURN section",
    "connections": "CALL dbms.listConnections() YIELD connectionId RETURN connectionId",
}
PLACES = {
    "list": "RETURN [COLLECT { @ }] AS x",
    "list comprehension": "RETURN [i IN [1] | COLLECT { @ }] AS x",
    "its condition": "RETURN [i IN [1] WHERE size(COLLECT { @ }) > 0] AS x",
    "case": "RETURN CASE WHEN true THEN COLLECT { @ } ELSE [] END AS x",
    "reduce": "RETURN reduce(n = 0, i IN [1] | n + size(COLLECT { @ })) AS x",
    "any": "RETURN any(i IN [1] WHERE size(COLLECT { @ }) > 0) AS x",
    "map": "RETURN {a: COLLECT { @ }} AS x",
    "index": "RETURN COLLECT { @ }[0] AS x",
    "argument": "RETURN coalesce(size(COLLECT { @ }), 1) AS x",
    "where": "MATCH (n:Video) WHERE size(COLLECT { @ }) > 0 RETURN n",
    "with": "WITH COLLECT { @ } AS x RETURN x",
    "unwind": "UNWIND COLLECT { @ } AS x RETURN x",
    "order": "MATCH (n:Video) RETURN n ORDER BY size(COLLECT { @ })",
    "projection": "MATCH (n:Video) RETURN n {.name, x: COLLECT { @ }} AS x",
    "pattern comprehension": "MATCH (n:Video) RETURN [(n)--(m) | COLLECT { @ }] AS x",
    "count": "RETURN COUNT { @ } AS x",
    "exists": "RETURN EXISTS { @ } AS x",
    "a subquery": "CALL () { @ } RETURN 1 AS x",
    "a subquery of a subquery": "RETURN COLLECT { WITH COLLECT { @ } AS y RETURN y } AS x",
    "itself": "@",
}
ATTEMPTS = [
    version + place.replace("@", clause)
    for place in PLACES.values() for clause in INSIDE.values() for version in ("CYPHER 5 ", "CYPHER 25 ", "")
]  # fmt: skip
DISGUISES = (
    "load/* */csv FROM 'x' AS l RETURN l",
    "LOAD // csv\ncsv FROM 'x' AS l RETURN l",
    "LOAD\u200bCSV FROM 'x' AS l RETURN l",
    "\u017fhow u\u017fer\u017f",
    "RETURN '\\u0027 + LOAD CSV'",
    "\\u004cOAD CSV FROM 'x' AS l RETURN l",
    "RETURN [1][0..apoc.cypher.runFirstColumnSingle('x')]",
    "RETURN {a: apoc.load.json('x')}",
    "RETURN `apoc`.`load` . json('x')",
    "RETURN `apoc.load.json`('x')",
    "RETURN genai.vector.encode('x', 'OpenAI', {token: 'x'})",
    "CALL /* db.labels */ dbms . listConfig()",
    "CALL `dbms`.`listConfig`()",
    "USE system RETURN 1",
    "USE `system` RETURN 1",
    "RETURN [x IN [1] | `apoc.load.json`('x')]",
    "USE (system) RETURN 1",
    "SHOW GRAPH TYPE",
    "CALL () { SHOW `settings` } RETURN 1",
    "RETURN 'a",
    "RETURN `a",
    "RETURN 1 /* a",
)
LOOKS = (
    "RETURN date.truncate('day', date()) AS d, duration.between(date(), date()) AS e",
    "MATCH p = (a)-[:X*1..3]->(b) RETURN p, [1, 2][0..1]",
    "RETURN n.load, n.csv, {call: 1, show: 2, use: 3}.call AS use",
    "MATCH (n:Call|Load) RETURN n",
    "RETURN vector.similarity.cosine([1.0], [2.5e-3]) AS v",
    "MATCH (`a b`:`X y` {`c d`: 1}) RETURN `a b`.`z`",
    "MATCH (n) WHERE n.name =~ '.*\\\\d' RETURN n // LOAD CSV",
    "RETURN 1.5 + .5 AS x, -1 AS y, a{.x, .*} AS z, 'LOAD CSV' AS text",
    "CALL (x) { RETURN 1 AS y } RETURN y, COUNT { MATCH (n) } AS c",
)


def refusal(attempt):
    """Return with which hint a question is refused; None where it is let through."""
    try:
        only_looking(attempt)
    except WriteRefused as refused:
        return refused.hint
    return None


def test_an_attempt_is_refused_before_any_server_sees_it():
    assert [attempt for attempt in ATTEMPTS if not refusal(attempt)] == []


@pytest.mark.parametrize("attempt", DISGUISES)
def test_an_attempt_in_disguise_is_refused(attempt):
    assert refusal(attempt)


@pytest.mark.neo4j
@pytest.mark.parametrize("version", ["CYPHER 5 ", "CYPHER 25 "])
def test_the_attempts_are_cypher_that_a_server_would_take(neo4j_server, version):
    """Else nothing would be shown by their being refused: with these hands they reach a plan that may run."""
    login = (neo4j_server.user, neo4j_server.password)
    with neo4j.GraphDatabase.driver(neo4j_server.uri, auth=login, warn_notification_severity="OFF") as driver:
        for place in PLACES.values():
            text = place.replace("@", INSIDE["an address"])
            driver.execute_query(f"EXPLAIN {version}{text}")


@pytest.mark.parametrize("question", [*LOOKS, *(query.text for query in explore_queries())])
def test_a_look_is_let_through(question):
    assert [piece for piece in only_looking(question) if piece.kind != "space"] == list(read(question))


@pytest.mark.parametrize(
    "question",
    [
        "RETURN '" + "x" * MOST_CHARACTERS + "'",
        "RETURN 1" + " + 1" * MOST_WORDS,
        "RETURN " + "[" * (DEEPEST + 1) + "]" * (DEEPEST + 1),
        "RETURN size([x IN range(1, 2000000000) | x * 1.5])",
    ],
)
def test_what_a_server_could_be_at_for_hours_is_not_asked(question):
    with pytest.raises(GraphError) as refused:
        only_looking(question)
    assert refused.value.code == "too-much"
    assert refused.value.hint


@given(
    st.lists(
        st.sampled_from(["a", "LOAD", "CSV", "`b`", "'c'", '"d"', " ", "\n", "// e\n", "/* f */", ".", "(", "1.5"])
    )
)
def test_nothing_of_a_text_is_lost_but_spaces_and_comments(parts):
    text = " ".join(parts)
    told = [token.text for token in read(text)]
    assert "".join(told) == "".join(one for one in parts if one.strip() and not one.startswith(("//", "/*")))


@pytest.mark.neo4j
def test_an_answer_that_is_too_large_is_given_up_and_the_server_goes_on(neo4j_server):
    with Connection(neo4j_server) as connection:
        with pytest.raises(GraphError, match="larger than") as large:
            ask_freely(connection, "UNWIND range(1, 400) AS i RETURN [x IN range(1, 20000) | x] AS xs")
        assert large.value.code == "too-much"
        assert ask_freely(connection, "RETURN 1 AS one").rows == ((1,),)


@pytest.mark.neo4j
@pytest.mark.slow
def test_of_a_row_that_is_too_large_no_more_is_read_than_is_bounded(neo4j_server, caplog):
    """The driver makes a text of a row when all of it has come: 84 MB and their text once more were taken before."""
    with Connection(neo4j_server) as connection:
        tracemalloc.start()
        try:
            with pytest.raises(GraphError, match="larger than") as large:
                ask_freely(connection, "RETURN reduce(s = 'abcdefghij', i IN range(1, 23) | s + s) AS n")
            peak = tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()
        assert large.value.code == "too-much"
        assert peak < MOST_ON_THE_WIRE + LARGEST_ANSWER
        assert ask_freely(connection, "RETURN 1 AS one").rows == ((1,),)
    assert not caplog.records


@pytest.mark.neo4j
def test_a_connection_has_the_whole_bound_for_each_question(neo4j_server):
    question = "UNWIND range(1, 10) AS n RETURN reduce(s = 'abcdefghij', i IN range(1, 17) | s + s) AS s"
    with Connection(neo4j_server) as connection:
        for _ in range(2 + 2 * MOST_ON_THE_WIRE // LARGEST_ANSWER):
            assert len(ask_freely(connection, question).rows) == 10


@pytest.mark.neo4j
def test_who_wants_few_of_many_large_rows_gets_them(neo4j_server):
    question = "UNWIND range(1, 900) AS n RETURN reduce(s = 'abcdefghij', i IN range(1, 14) | s + s) AS s"
    with Connection(neo4j_server) as connection:
        answer = ask_freely(connection, question, limit=5)
    assert (len(answer.rows), answer.cut) == (5, True)


@pytest.mark.neo4j
def test_who_waits_is_answered_in_time_though_the_server_does_not_heed(neo4j_server):
    """To look through a list that has itself in it over and over is one step, which no server interrupts."""
    long = "RETURN 0 IN reduce(s = [1], i IN range(1, 26) | s + s) AS long"  # seconds: longer ones cost the server
    with Connection(neo4j_server) as connection, pytest.raises(GraphError) as late:
        ask_freely(connection, long, timeout=0.2)
    assert late.value.code == "timeout"
    with Connection(neo4j_server) as connection:
        assert ask_freely(connection, "RETURN 1 AS one").rows == ((1,),)
