"""Questions in Cypher from the page: only where they are allowed, only what looks, as a table and as a picture."""

from __future__ import annotations

import threading

import pytest
from fastapi.testclient import TestClient
from typer.testing import CliRunner
from web.serving import NAMES, PLENTY, app, served

from foon_kg import Foon
from foon_kg.cli import app as command_line
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.cypher import explore_queries
from foon_kg.foon.demo import demo_folder
from foon_kg.model.errors import GraphError, WriteRefused
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.web.api import web_app
from foon_kg.web.explore.cypher import CypherDesk
from foon_kg.web.foon import LiveFoon
from foon_kg.web.questions import BusyError
from foon_kg.web.service import FoonService

CONTROL, ENTER = "\ue009", "\ue007"
CHOPPED = "MATCH (o:Object {label: $food})-[edge:INPUT_OF]->(m:Motion {verb: 'chop'}) RETURN o, edge, m"


@pytest.fixture(scope="module")
def neo4j(emptied_server):
    with Connection(emptied_server) as connection:
        load(connection, demo_subgraphs())
    return emptied_server


def asking(settings):
    """The application with a desk for Cypher, of a FOON in Neo4j."""
    service = FoonService(LiveFoon(lambda: Foon(server=settings)))
    return web_app(service, names=NAMES, limits=PLENTY, cypher=CypherDesk(lambda: Foon(server=settings)))


@pytest.fixture(scope="module")
def client(neo4j):
    with TestClient(asking(neo4j), base_url="http://localhost") as made:
        yield made


def ask(client, text, status=200, **more):
    answer = client.post("/api/explore/cypher", json={"text": text, **more})
    assert answer.status_code == status, answer.text
    return answer.json()


def test_without_leave_of_the_operator_nothing_is_asked():
    with TestClient(app(), base_url="http://localhost") as closed:
        assert not closed.get("/api/explore/questions").json()["allowed"]
        error = ask(closed, "RETURN 1", 404)["error"]
    assert error["code"] == "no-cypher"
    assert "foon serve --cypher" in error["hint"]


def test_files_cannot_be_served_with_it():
    answer = CliRunner().invoke(command_line, ["serve", "--cypher", "--files", str(demo_folder())])
    assert answer.exit_code == 2
    assert "Leave out --cypher" in answer.stderr


@pytest.mark.neo4j
def test_an_answer_is_a_table_and_its_nodes_are_things_of_the_explorer(client):
    told = ask(client, CHOPPED, parameters={"food": "onion"})
    assert told["columns"] == ["o", "edge", "m"]
    assert told["rows"]
    assert all(row[0]["properties"]["label"] == "onion" for row in told["rows"])
    assert {(thing["kind"], thing["name"]) for thing in told["things"]} == {("object", "onion"), ("step", "chop")}
    taken = {(edge["source"], edge["target"]) for edge in told["edges"] if edge["kind"] == "takes"}
    assert len(taken) == len(told["rows"])
    around = client.post("/api/explore/around", json={"id": told["things"][0]["id"]})
    assert around.json()["things"][0] == told["things"][0]


@pytest.mark.neo4j
def test_paths_and_lists_are_drawn_and_what_the_explorer_does_not_know_is_shown(client):
    path = ask(client, "MATCH way = (:Object)-[:INPUT_OF]->(:Motion)-[:OUTPUTS]->(:Object) RETURN [way] LIMIT 1")
    assert {edge["kind"] for edge in path["edges"]} == {"takes", "makes"}
    alone = ask(client, "MATCH ()-[edge:INPUT_OF]->() RETURN edge LIMIT 3")
    assert (len(alone["rows"]), alone["things"], alone["edges"]) == (3, [], [])
    other = ask(client, "MATCH (o:Operator {motion: 'chop'}) RETURN o LIMIT 1")["things"][0]
    assert (other["kind"], other["name"]) == ("other", "chop")
    assert other["note"].startswith("Operator: ")


@pytest.mark.neo4j
def test_no_more_rows_are_answered_than_asked(client):
    told = ask(client, "UNWIND range(1, 50) AS n RETURN n", limit=7)
    assert told["rows"] == [[n] for n in range(1, 8)]
    assert told["cut"]


@pytest.mark.neo4j
@pytest.mark.parametrize(
    ("text", "status", "code"),
    [
        ("MATCH (n) DETACH DELETE n", 403, "read-only"),
        ("LOAD CSV FROM 'http://127.0.0.1/' AS row RETURN row", 403, "read-only"),
        ("CALL dbms.listConfig()", 403, "read-only"),
        ("RETRUN 1", 422, "cypher"),
        ("MATCH (n) RETURN $unknown", 422, "cypher"),
        ("RETURN " + "(" * 70 + "1" + ")" * 70, 422, "too-much"),
    ],
)
def test_what_does_more_than_look_and_what_is_no_cypher_is_refused(client, text, status, code):
    error = ask(client, text, status)["error"]
    assert error["code"] == code
    assert "--" not in error["hint"]  # there is no command line here


@pytest.mark.neo4j
def test_a_question_that_takes_too_long_is_given_up(neo4j):
    desk = CypherDesk(lambda: Foon(server=neo4j), seconds=0.5)
    service = FoonService(LiveFoon(lambda: Foon(server=neo4j)))
    with TestClient(web_app(service, names=NAMES, limits=PLENTY, cypher=desk), base_url="http://localhost") as client:
        long = "UNWIND range(1, 1000000) AS a UNWIND range(1, 1000000) AS b RETURN count(a + b)"
        assert ask(client, long, 504)["error"]["code"] == "timeout"


def test_two_ask_at_once_and_a_third_is_told_to_wait():
    begun, end = threading.Barrier(3, timeout=30), threading.Event()

    def opened():
        begun.wait()
        end.wait(30)
        raise GraphError("nobody answers", code="unreachable")

    desk = CypherDesk(opened)

    def first():
        with pytest.raises(GraphError, match="nobody answers"):
            desk.ask("RETURN 1", {}, 1)

    threads = [threading.Thread(target=first) for _ in range(2)]
    for thread in threads:
        thread.start()
    begun.wait()
    with pytest.raises(BusyError):
        desk.ask("RETURN 1", {}, 1)
    end.set()
    for thread in threads:
        thread.join()


@pytest.mark.neo4j
def test_the_gate_is_that_of_the_command(neo4j, client):
    text = "CALL { MATCH (n) SET n.x = 1 } RETURN 1"
    with Connection(neo4j) as connection, pytest.raises(WriteRefused) as refused:
        ask_freely(connection, text)
    assert ask(client, text, 403)["error"]["message"] == refused.value.message


@pytest.mark.neo4j
def test_every_question_that_comes_along_can_be_asked_as_it_is_told(client):
    told = client.get("/api/explore/questions").json()
    assert told["allowed"]
    assert [one["name"] for one in told["questions"]] == [query.name for query in explore_queries()]
    read = {"STRING": str, "INTEGER": int, "LIST<STRING>": lambda text: [word.strip() for word in text.split(",")]}
    for one, query in zip(told["questions"], explore_queries(), strict=True):
        assert not one["text"].startswith("//")
        parameters = {name: read[kind](one["examples"][name]) for name, kind in one["parameters"].items()}
        assert ask(client, one["text"], parameters=parameters)["columns"] == list(query.columns)


@pytest.mark.neo4j
def test_the_box_on_the_page_asks_and_draws(browser, neo4j):
    from chromium import as_usual
    from selenium.webdriver.support.ui import Select, WebDriverWait

    def until(script):
        return WebDriverWait(browser, 60, poll_frequency=0.05).until(lambda it: it.execute_script(f"return {script}"))

    as_usual(browser)
    with served(asking(neo4j)) as address:
        browser.get("about:blank")
        browser.get_log("browser")
        browser.get(f"{address}/explore")
        until("!document.querySelector('#cypher').hidden")
        browser.find_element("css selector", "#cypher > summary").send_keys(ENTER)
        Select(browser.find_element("id", "question")).select_by_value("states_of_food")
        assert browser.find_element("id", "parameter-food").get_attribute("value") == "onion"
        browser.find_element("id", "statement").send_keys(CONTROL + ENTER)
        until("!!document.querySelector('#answer table')")
        heads = [cell.text for cell in browser.find_elements("css selector", "#answer th")]
        assert heads == ["state", "made", "used"]
        assert not browser.find_element("id", "draw").is_displayed()
        Select(browser.find_element("id", "question")).select_by_value("")
        box = browser.find_element("id", "statement")
        box.clear()
        box.send_keys(CHOPPED.replace("$food", "'onion'"), CONTROL + ENTER)
        until("!document.querySelector('#draw').hidden")
        browser.find_element("id", "draw").send_keys(ENTER)
        until("picture._cyreg.cy.nodes().every(node => ['onion', 'chop'].includes(node.data('thing').name))")
        box.clear()
        box.send_keys("MATCH (n) DELETE n", CONTROL + ENTER)
        until("!!document.querySelector('#answer [role=alert]')")
        assert "only looks" in browser.find_element("id", "answer").text
        assert [it["message"] for it in browser.get_log("browser") if "403" not in it["message"]] == []
        browser.get("about:blank")


@pytest.mark.neo4j
def test_without_leave_the_page_has_no_box(browser):
    with served(app()) as address:
        browser.get(f"{address}/explore")
        from selenium.webdriver.support.ui import WebDriverWait

        WebDriverWait(browser, 60).until(lambda it: it.execute_script("return !!about.firstChild"))
        assert not browser.find_element("id", "cypher").is_displayed()
        browser.get("about:blank")
