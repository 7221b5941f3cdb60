"""A question whose time is over is over on the server too; what makes it so changes no answer."""

from __future__ import annotations

import time
from itertools import product

import neo4j
import psutil
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import SALAD, subgraph

from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.interruptible import interruptible
from foon_kg.store.graph.looking import only_looking
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
}  # fmt: skip
WRITTEN = {
    "a list": "CREATE (:Note {n: size([x IN range(1, 1000000) | size([y IN range(1, 1000000) | y])])}) RETURN 1 AS n",
    "a list in a subquery": "UNWIND range(1, $many) AS i CALL (i) { MATCH (v:Video) SET v.l = "
    "size([x IN range(1, 1000000) | [x]]) } RETURN 1 AS n",
    "a change": "MATCH (v:Video) SET v.n = reduce(n = 0, x IN range(1, 20 * 1000000) | n + x) RETURN 1 AS n",
}  # fmt: skip

BEARABLE = "'.*b.*'"
"""A pattern that takes no time, however long a text may be."""


def net(nodes):
    """Return a pattern in which all nodes are joined with each other."""
    return "MATCH " + ", ".join(f"(a{n})--(a{m})" for n in range(nodes) for m in range(n)) + " RETURN 1 AS n"


TOO_MUCH = {
    "a plan of 300 nodes": "MATCH " + "--".join(f"(a{n})" for n in range(300)) + " RETURN 1 AS n",
    "a plan of a net": net(14),
    "a plan of a smaller net": net(8),
    "a plan of a net in clauses": net(14).replace(", (", " OPTIONAL MATCH ("),
    "a plan of a net in a subquery": f"RETURN COUNT {{ {net(14)} }} AS n",
    "a plan of a net of arrows": net(14).replace("--", "-[:IN|OUT*1..3 {x: 1}]->"),
    "a plan of a net of steps that repeat": net(14).replace("--", "((x)--(y)){1,3}"),
    "a plan of a ring": "MATCH " + "--".join(f"(a{n})" for n in range(100)) + "--(a0) RETURN 1 AS n",
    "a condition of 600 parts": "MATCH (a) WHERE " + " XOR ".join(f"a.x{n}" for n in range(600)) + " RETURN 1 AS n",
    "a list nested 3,000 deep": "RETURN " + "[" * 3000 + "1" + "]" * 3000,
    "20,000 terms": "RETURN 1" + " + 1" * 10_000,
    "subqueries within each other": "RETURN " + "COUNT { MATCH (q) WHERE " * 24 + "true" + " } > 1" * 24,
    "cases within each other": "RETURN " + "CASE WHEN true THEN " * 400 + "1" + " END" * 400,
    "not not not": "RETURN " + "NOT " * 3000 + "true",
    "900 questions in one": " UNION ".join(["RETURN 1 AS x"] * 900),
    "a pattern that tries again": "RETURN $text =~ '(a|aa)*b'",
    "a pattern joined otherwise": "RETURN $text =~ '(a|aa)' || '*b'",
    "a pattern of many parts": "RETURN $text =~ '.*.*.*.*' + '.*b'",
    "a pattern given as one": "RETURN $text =~ $pattern",
    "a pattern that nobody knows": "MATCH (n) RETURN n.name =~ n.pattern",
    "one in brackets": "RETURN $text =~ ('.*' + $text)",
    "one with a hidden sign": "RETURN $text =~ '\\\\c\\\\*'",
    "one that hides what it repeats": "RETURN $text =~ '(?x)((.*a) *a) *b'",
    "one that hides it by two flags": "RETURN $text =~ '(?Ux)((.*a) *a) *b'",
    "one that hides it within": "RETURN $text =~ 'a(?i-sx:((.*a)#\n*a) *b)'",
    "a pattern that may lack eleven parts": "RETURN $text =~ '" + "a?" * 11 + "'",
    "a pattern of many alternatives": "RETURN $text =~ '" + "(a|a)" * 40 + "b'",
    "alternatives within alternatives": "RETURN $text =~ '" + "(b|(?:a|a)" * 40 + ")" * 40 + "'",
    "alternatives beside what could hide their groups": "RETURN $text =~ '" + "(a[]b)]|a)" * 40 + "b'",
    "alternatives beside a set in a set": "RETURN $text =~ '" + "(a[a[b])]|a)" * 40 + "b'",
}
MOST_SECONDS = 60
"""In which a server that others keep busy, too, ends what it was told to end."""

LISTS = ("[]", "[1, 2, 3]", "range(1, size('abc'))", "[null, 2]", "[[1], [2, 3]][1]", "[x IN [3, 4] | x]", "labels(v)")
CONDITIONS = (
    "x = 2",
    "x IS NULL OR x > 1",
    "NOT x = 2",
    "true",
    "v:Video",
    "toString(x) =~ '.*[23].*'",
    "v.name =~ '.*a?.*' AND ('v' + v.name) =~ '.*a?l.*'",
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
    assert nothing_runs(settings)
    assert listening(settings) == before


@pytest.mark.neo4j
@pytest.mark.parametrize("what", WRITTEN)
def test_after_the_deadline_nothing_of_what_was_to_be_written_runs_or_is_there(served, what):
    settings, connection = served
    before = listening(settings)
    with pytest.raises(GraphError) as late:
        ask_freely(connection, WRITTEN[what], {"many": 2 * 10**7}, write=True, timeout=0.5)
    assert late.value.code == "timeout"
    assert nothing_runs(settings)
    assert told(connection, "MATCH (n) WHERE n:Note OR n.n > 0 RETURN n") == []
    assert listening(settings) == before


@pytest.mark.neo4j
def test_what_may_be_written_is_written_as_it_was_typed(served):
    connection = served[1]
    made = ask_freely(connection, "CREATE (n:Note {l: [x IN [1, 2] | x + 1]}) RETURN [y IN n.l | y]", write=True)
    assert (made.columns, made.rows) == (("[y IN n.l | y]",), (([2, 3],),))
    # a subquery may not stand in MERGE, which then is asked as it was typed
    for question in ("MERGE (n:Note {l: [x IN [4] | x]})", "UNWIND [5, 6] AS i CREATE (n:Note {l: [x IN [i] | x]})"):
        ask_freely(connection, question, write=True)
    assert told(connection, "MATCH (n:Note) RETURN n.l ORDER BY n.l") == [[[2, 3]], [[4]], [[5]], [[6]]]
    with pytest.raises(GraphError, match="nobody") as wrong:
        ask_freely(connection, "RETURN [x IN [1] | nobody]", write=True)
    assert "CASE" not in wrong.value.message
    ask_freely(connection, "MATCH (n:Note) DELETE n", write=True)


def nothing_runs(settings):
    """Return whether a server lets go of a question that was to end; one that it does not let go of takes it hours."""
    asked = "SHOW TRANSACTIONS YIELD currentQuery WHERE currentQuery CONTAINS ' AS n' RETURN collect(currentQuery)"
    until = time.monotonic() + MOST_SECONDS
    with neo4j.GraphDatabase.driver(settings.uri, auth=(settings.user, settings.password)) as driver:
        while time.monotonic() < until:
            running = driver.execute_query(asked).records[0][0]
            if all("SHOW TRANSACTIONS" in one for one in running):
                return True
    return False


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
@pytest.mark.parametrize("what", TOO_MUCH)
def test_nor_is_it_where_writing_was_allowed(served, what):
    with pytest.raises(GraphError) as refused:
        ask_freely(served[1], TOO_MUCH[what], {"text": "a" * 6000, "pattern": "(.*a)*b"}, write=True)
    assert refused.value.code == "too-much"


@pytest.mark.parametrize(
    "question",
    [
        net(7),
        "MATCH " + ", ".join(f"(a)--(b{n})" for n in range(40)) + " RETURN 1 AS n",
        " UNION ".join(["MATCH (a)--(b)--(a) RETURN 1 AS n"] * 20),
        "RETURN " + " + ".join(f"((a.x) - (b.y) + size(c{n}) - (a.z))" for n in range(30)),
    ],
)
def test_a_pattern_that_people_ask_for_is_asked(question):
    assert only_looking(question)


@pytest.mark.neo4j
@pytest.mark.parametrize(
    ("pattern", "most"),
    [
        (BEARABLE, 10_000),
        ("'.*a' + '.*a.*b'", 464),
        ("'a?.*a.*a.*b'", 368),
        ("'(a|b)(a|a).*.*'+ 'b'", 5_000),
        ("'" + "a?" * 10 + ".*b'", 97_656),
    ],
)
def test_a_text_is_no_longer_than_its_pattern_bears(served, pattern, most):
    """Three times “as many as there are”, and a text of 100,000 characters: no server lets go of that for days.

    Where writing was allowed the same is refused; the longest that is matched there is so once, as it takes seconds.
    """
    question = (
        f"WITH {{a: $text}} AS m RETURN substring(m.a, 0) =~ {pattern} AS n, [x IN [$text] WHERE x =~ {pattern} | 1]"
    )
    for write in (False, True) if pattern == BEARABLE else (False,):
        assert ask_freely(served[1], question, {"text": "a" * most}, write=write).rows == ((False, []),)
    for length, write in product((most + 1, 100_000), (False, True)):
        with pytest.raises(GraphError, match=f"than its pattern bears: {most:,} characters") as refused:
            ask_freely(served[1], question, {"text": "a" * length}, write=write)
        assert refused.value.code == "too-much"


@pytest.mark.parametrize(
    ("pattern", "why"),
    [
        ("'(a|aa)*b'", "repeats a group"),
        ("'(?x)(a|aa) *b'", "flag x"),
        ("'.*.*.*.*b'", "has 4 of *, + and {…}, and 3 are the most"),
        ("'" + "a?" * 11 + "'", "more than 1,024 ways by its | and ?"),
        ("'" + "a?" * 20_000 + "'", "more than 1,024 ways by its | and ?"),
        ("'" + "(a|b|c)" * 8 + "'", "more than 1,024 ways by its | and ?"),
        ("'a.*' = true", "joined by +: ="),
        ("n.pattern", "neither a string nor a parameter"),
    ],
)
def test_it_is_told_why_a_pattern_is_refused(pattern, why):
    with pytest.raises(GraphError) as refused:
        only_looking(f"MATCH (n) RETURN n.name =~ {pattern}")
    assert why in refused.value.message


@pytest.mark.parametrize(
    "pattern",
    [
        "(?i).*(" + "|".join(f"name{n}" for n in range(2_000)) + ").*(raw|chopped)",  # a list may be long
        "(a|b)(?:c|d)(?=e|f)[^()|]{2,3}[(\\)|]",
        "[()][a[b]]",  # without alternatives nothing can hide there
        "a?" * 10,
    ],
)
def test_alternatives_that_people_ask_for_are_asked(pattern):
    assert only_looking("RETURN $text =~ $pattern", {"pattern": pattern})


@pytest.mark.parametrize("text", ["'a' + n.name", "n.name || 'a'", "CASE WHEN true THEN $text END", "-n.name"])
def test_a_text_of_which_nobody_knows_where_it_begins_is_put_into_brackets(text):
    with pytest.raises(GraphError) as refused:
        interruptible(read_pieces(f"MATCH (n) RETURN {text} =~ '.*a.*b'"))
    assert (refused.value.code, "brackets" in refused.value.hint) == ("too-much", True)
    assert interruptible(read_pieces(f"MATCH (n) RETURN ({text}) =~ '.*a.*b'"))


@pytest.mark.neo4j
@pytest.mark.parametrize(
    "pattern", ["'(?i).*salad.*'", "'(?i).*' + $food + '.*'", "$food", "'[a-z]+ (whole|diced)?'", "'\\\\d+'"]
)
def test_a_plain_pattern_is_asked(served, pattern):
    question = f"MATCH (v:Video) WHERE v.name =~ {pattern} AND true RETURN v.name"
    with served[1].session() as session:
        rows = session.run(question, food="leek").values()
    assert [list(row) for row in ask_freely(served[1], question, {"food": "leek"}).rows] == rows


@pytest.mark.neo4j
@examples(50)
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
