"""Questions that mean harm, on a Neo4j that nobody hardened: nothing outside the graph is touched, and it stays up."""

from __future__ import annotations

import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import neo4j
import psutil
import pytest
from server.live_server import up

from foon_kg.model.errors import GraphError
from foon_kg.model.kept import write_private
from foon_kg.store.doctor import Level, examine
from foon_kg.store.graph import Connection
from foon_kg.store.graph.free_cypher import ask_freely

pytestmark = pytest.mark.slow

VERSIONS = ("CYPHER 5 ", "CYPHER 25 ")
SECRET = "what nobody should read"
CLAUSES = {
    "an address": "LOAD CSV FROM '{address}' AS l RETURN l",
    "an address by its headers": "LOAD CSV WITH HEADERS FROM '{address}' AS l RETURN l",
    "a file": "LOAD CSV FROM '{file}' AS l RETURN l",
    "settings": "CALL dbms.listConfig() YIELD value RETURN value",
    "settings shown": "SHOW SETTINGS YIELD value RETURN value",
    "statistics": "CALL db.stats.clear('QUERIES') YIELD section RETURN section",
    "planning": "CALL db.prepareForReplanning() RETURN 1 AS l",
}
PLACES = (
    "@",
    "RETURN COLLECT {{ @ }} AS x",
    "RETURN [i IN [1] | COLLECT {{ @ }}] AS x",
    "RETURN [i IN [1] WHERE size(COLLECT {{ @ }}) > 0] AS x",
    "RETURN CASE WHEN true THEN COLLECT {{ @ }} END AS x",
    "RETURN CASE WHEN size(COLLECT {{ @ }}) > 0 THEN 1 END AS x",
    "RETURN reduce(n = 0, i IN [1] | n + size(COLLECT {{ @ }})) AS x",
    "RETURN all(i IN [1] WHERE size(COLLECT {{ @ }}) > 0) AS x",
    "RETURN none(i IN [1] WHERE size(COLLECT {{ @ }}) > 0) AS x",
    "RETURN {{a: [COLLECT {{ @ }}][0]}}.a AS x",
    "RETURN COUNT {{ @ }} AS x",
    "RETURN EXISTS {{ @ }} AS x",
    "RETURN coalesce(null, COLLECT {{ @ }}) AS x",
    "UNWIND COLLECT {{ @ }} AS x RETURN x",
    "WITH 1 AS i ORDER BY size(COLLECT {{ @ }}) RETURN i",
    "WITH 1 AS i WHERE COUNT {{ @ }} > 0 RETURN i",
    "RETURN 1 AS i LIMIT COUNT {{ @ }}",
    "CALL () {{ @ }} RETURN 1 AS x",
    "RETURN COLLECT {{ RETURN COLLECT {{ @ }} AS y }} AS x",
)
WORDS = "LOAD CSV FROM '{address}' AS l RETURN l"
ODD = "\x00\x0b\x1c\x1f\x85\xa0\xad\u1680\u180e\u2000\u200b\u2028\u2029\u3000\ufeff\u017f'\"`\\/*\n\r$u"
DISGUISES = (
    "LOAD^CSV FROM '{address}' AS l RETURN l",
    "// ^" + WORDS,
    "/* *^/ " + WORDS + " /* */ RETURN 1",
    "WITH '^' AS x " + WORDS + " //'",
    "WITH '\\^' AS x//' AS x\n" + WORDS + "//'",
    'WITH "\\^" AS x//" AS x\n' + WORDS + '//"',
    "WITH 1 AS `^` " + WORDS + " //`",
    "WITH 1 AS `\\^` " + WORDS + " //`",
    "WITH 1 AS a WITH a LIMIT 1^" + WORDS,
)
HUNGRY = (
    "RETURN size([x IN range(1, $many) | x * 1.5]) AS n",
    "RETURN size(reduce(s = 'ab', i IN range(1, 40) | s + s)) AS n",
    "RETURN size(replace(reduce(s = 'a', i IN range(1, 26) | s + s), 'a', $long)) AS n",
    "UNWIND range(1, $many) AS x WITH collect(x) AS l RETURN size(l) AS n",
)


@pytest.fixture(scope="module")
def bare(place):
    """A Neo4j with the settings that it comes with, but that it does not wait for idle threads when it stops."""

    def plain(home, port):
        lines = {
            "server.bolt.listen_address": f"127.0.0.1:{port}",
            "server.http.enabled": "false",
            "internal.server.bolt.thread_pool_shutdown_wait_time": "200ms",
        }
        write_private(home.configuration / "neo4j.conf", "".join(f"{name}={value}\n" for name, value in lines.items()))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("foon_kg.store.server.launch.write_configuration", plain)
        yield up()


@pytest.fixture(scope="module")
def tripwire():
    """An HTTP server; returns its address and the paths that were asked of it."""
    asked = []

    class Wire(BaseHTTPRequestHandler):
        def do_GET(self):
            asked.append(self.path)
            self.send_response(200)
            self.end_headers()
            self.wfile.write(f"{SECRET}\n".encode())

        def log_message(self, *_):
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Wire) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/secret.csv", asked
        server.shutdown()


def test_what_nobody_hardened_is_told_with_what_to_set(bare, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(bare, name))
    told = {one.what.partition(" ")[0]: one for one in examine() if one.subject == "settings"}
    assert set(told) == {"dbms.security.allow_csv_import_from_file_urls", "db.transaction.timeout"}
    for name, one in told.items():
        assert one.level is Level.NOTE
        assert f"Set {name} in neo4j.conf" in one.remedy


@pytest.fixture(scope="module")
def driver(bare):
    """The driver itself, without any gate."""
    with neo4j.GraphDatabase.driver(
        bare.uri, auth=(bare.user, bare.password), warn_notification_severity="OFF"
    ) as driver:
        yield driver


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """The address of a file that the server could read."""
    path = tmp_path_factory.mktemp("private") / "secret.csv"
    path.write_text(f"{SECRET}\n")
    return path.as_uri()


def test_without_the_gate_the_tripwires_are_touched(driver, tripwire, file):
    address, asked = tripwire
    for clause in ("an address", "a file"):
        text = PLACES[2].replace("@", CLAUSES[clause]).format(address=address, file=file)
        assert SECRET in repr(driver.execute_query(text).records)
    assert asked.pop() == "/secret.csv"


def test_no_clause_in_any_place_reaches_outside_the_graph(bare, tripwire, file):
    address, asked = tripwire
    attempts = {
        version + place.replace("@", clause).format(address=address, file=file)
        for version in VERSIONS for place in PLACES for clause in CLAUSES.values()
    }  # fmt: skip
    with Connection(bare) as connection:
        for attempt in sorted(attempts):
            with pytest.raises(GraphError):
                ask_freely(connection, attempt)
    assert asked == []


def test_no_disguise_of_its_words_reaches_outside_the_graph(bare, tripwire):
    """What passes the gate is asked, and the server reads it as the gate did."""
    address, asked = tripwire
    reached = set()
    with Connection(bare) as connection:
        for disguise in DISGUISES:
            for odd in ODD:
                attempt = disguise.format(address=address).replace("^", odd)
                try:
                    answer = ask_freely(connection, attempt)
                except GraphError:
                    continue
                assert SECRET not in repr(answer)
                reached.add(disguise)
    assert asked == []
    assert reached


@pytest.mark.parametrize("question", HUNGRY)
def test_after_a_question_that_needs_more_memory_than_there_is_the_same_server_answers(bare, place, driver, question):
    process = psutil.Process(place.recall().pid)
    with driver.session() as session, pytest.raises(neo4j.exceptions.TransientError, match=r"(?i)memory"):
        session.run(question, {"many": 2_000_000_000, "long": "a" * 100}).consume()
    assert process.is_running()
    with driver.session() as session:
        assert session.run("RETURN 1 AS one").single(strict=True)["one"] == 1
        session.run("MERGE (n:Note {text: 'still writing'})").consume()


def test_who_asked_for_too_much_is_told_so(bare):
    with Connection(bare) as connection, pytest.raises(GraphError, match="more memory than") as told:
        ask_freely(connection, HUNGRY[1])
    assert told.value.code == "memory"
