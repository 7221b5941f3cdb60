"""A question whose time is over is over on the server too; what makes it so changes no answer."""

from __future__ import annotations

import neo4j
import psutil
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kitchen_stories import SALAD, subgraph

from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.interruptible import interruptible
from foon_kg.store.graph.question_words import read_pieces

ENDLESS = {
    "reduce over a range that is reckoned": "RETURN reduce(n = 0, x IN range(1, 20 * 1000000) | n + x) AS n",
    "reduce over 10^11": "RETURN reduce(n = 0, x IN range(1, 1000000) | n + size([y IN range(1, 100000) | y])) AS n",
    "all": "RETURN all(x IN range(1, 1000000) WHERE all(y IN range(1, 1000000) WHERE x + y > 0)) AS n",
    "none": "RETURN none(x IN range(1, 1000000) WHERE single(y IN range(1, 1000000) WHERE x + y = 0)) AS n",
    "conditions": "RETURN size([x IN range(1, 1000000) WHERE any(y IN range(1, 1000000) WHERE x = -y)]) AS n",
    "a list of lists": "RETURN size([x IN range(1, 1000000) | size([y IN range(1, 1000000) | x + y])]) AS n",
    "texts": "RETURN reduce(s = reduce(t = 'ab', i IN range(1, 20) | t + t), i IN range(1, 1000000) | reverse(s)) AS n",
    "a number in a range": "RETURN 0.5 IN range(1, $many) AS n",
    "rows": "UNWIND range(1, $many) AS x UNWIND range(1, $many) AS y RETURN count(*) AS n",
    "a subquery": "RETURN COUNT { UNWIND range(1, $many) AS x UNWIND range(1, $many) AS y RETURN x } AS n",
    "a plan of 300 nodes": "MATCH " + "--".join(f"(a{n})" for n in range(300)) + " RETURN 1 AS n",
}  # fmt: skip
TOO_MUCH = {
    "a condition of 600 parts": "MATCH (a) WHERE " + " XOR ".join(f"a.x{n}" for n in range(600)) + " RETURN 1 AS n",
    "a list nested 3,000 deep": "RETURN " + "[" * 3000 + "1" + "]" * 3000,
    "20,000 terms": "RETURN 1" + " + 1" * 20_000,
    "subqueries within each other": "RETURN " + "COUNT { MATCH (q) WHERE " * 24 + "true" + " } > 1" * 24,
    "cases within each other": "RETURN " + "CASE WHEN true THEN " * 400 + "1" + " END" * 400,
    "not not not": "RETURN " + "NOT " * 3000 + "true",
    "900 questions in one": " UNION ".join(["RETURN 1 AS x"] * 900),
    "a pattern that tries again": "RETURN $text =~ '(a|aa)*b'",
    "a pattern of many parts": "RETURN $text =~ '.*.*.*.*' + '.*b'",
    "a pattern given as one": "RETURN $text =~ $pattern",
    "a pattern that nobody knows": "MATCH (n) RETURN n.name =~ n.pattern",
    "one in brackets": "RETURN $text =~ ('.*' + $text)",
    "one with a hidden sign": "RETURN $text =~ '\\\\c\\\\*'",
}
LISTS = ("[]", "[1, 2, 3]", "range(1, size('abc'))", "[null, 2]", "[[1], [2, 3]][1]", "[x IN [3, 4] | x]", "labels(v)")
CONDITIONS = (
    "x = 2",
    "x IS NULL OR x > 1",
    "NOT x = 2",
    "true",
    "v:Video",
    "(v)-->()",
    "((v)-->())",
    "x = 1 AND v:Video|Object",
)
DONE = ("x", "[x, x]", "'a' || toString(x)", "{a: x}", "v.name", "size([y IN [1, 2] WHERE y = x | y])")
FORMS = (
    "[x IN {list} WHERE {condition} | {done}]",
    "[x IN {list} | {done}]",
    "[x IN {list} WHERE {condition}]",
    "any(x IN {list} WHERE {condition})",
    "none( x IN {list}\n WHERE {condition} )",
    "reduce(s = 0, x IN {list} | s + coalesce(toIntegerOrNull(toString(x)), 0))",
    "reduce(s=[], x IN {list}|s + [{done}])",
    "[1, 2 IN {list}, {list}[0]]",
    "3 IN {list}",
    "[x IN [[1], [2]] | x[0]] + {list}",
)


@pytest.fixture(scope="module")
def served(emptied_server):
    with Connection(emptied_server) as connection:
        load(connection, [subgraph("salad", "salad", *SALAD)])
        yield emptied_server, connection


@pytest.mark.neo4j
@pytest.mark.parametrize("what", ENDLESS)
def test_after_the_deadline_nothing_of_it_runs_and_the_same_server_answers(served, what):
    settings, connection = served
    before = listening(settings)
    with pytest.raises(GraphError) as late:
        ask_freely(connection, ENDLESS[what], {"many": 2 * 10**7}, timeout=0.5)
    assert late.value.code == "timeout"
    assert "does not let go" not in late.value.hint
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        running = driver.execute_query("SHOW TRANSACTIONS YIELD currentQuery WHERE currentQuery CONTAINS ' AS n'")
    assert [row["currentQuery"] for row in running.records if "YIELD" not in row["currentQuery"]] == []
    assert listening(settings) == before


def listening(settings):
    """Return who answers at the port of the server: nobody where it is no process of this machine and user."""
    port = int(settings.uri.rpartition(":")[2])
    return {one.pid for one in psutil.net_connections("tcp") if one.status == "LISTEN" and one.laddr.port == port}


@pytest.mark.neo4j
@pytest.mark.parametrize("what", TOO_MUCH)
def test_what_no_server_would_end_is_not_asked(served, what):
    with pytest.raises(GraphError) as refused:
        ask_freely(served[1], TOO_MUCH[what], {"text": "a" * 6000, "pattern": "(.*a)*b"})
    assert refused.value.code == "too-much"
    assert refused.value.hint


@pytest.mark.neo4j
@pytest.mark.parametrize(
    "pattern", ["'(?i).*salad.*'", "'(?i).*' + $food + '.*'", "$food", "'[a-z]+ (whole|diced)?'", "'\\\\d+'"]
)
def test_a_plain_pattern_is_asked(served, pattern):
    ask_freely(served[1], f"MATCH (v:Video) WHERE v.name =~ {pattern} AND true RETURN v.name", {"food": "leek"})


@pytest.mark.neo4j
@settings(max_examples=100)
@given(
    st.builds(str.format, st.sampled_from(FORMS), list=st.sampled_from(LISTS), condition=st.sampled_from(CONDITIONS),
              done=st.sampled_from(DONE)),
    st.sampled_from(("CYPHER 5", "CYPHER 25")),
)  # fmt: skip
def test_every_list_expression_means_what_it_meant(served, expression, version):
    question = f"{version} MATCH (v:Video) RETURN {expression}, 1 AS one ORDER BY v.name"
    assert told(served[1], interruptible(read_pieces(question))) == told(served[1], question)


def told(connection, question):
    """Return the answer, or that it is no Cypher: some pairs are none, with and without."""
    try:
        with connection.session() as session:
            return session.run(question).values()
    except GraphError:
        return "refused"


@pytest.mark.neo4j
def test_a_column_without_a_name_is_called_as_it_was_written(served):
    assert ask_freely(served[1], "RETURN [x IN [1, 2] | x ]").columns == ("[x IN [1, 2] | x ]",)


def test_a_label_that_could_be_a_turn_is_asked_for_in_brackets():
    with pytest.raises(GraphError, match="bare") as refused:
        interruptible(read_pieces("RETURN [x IN CASE WHEN n:A|B THEN xs END | x]"))
    assert "brackets" in refused.value.hint
