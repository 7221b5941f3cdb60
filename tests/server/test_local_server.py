"""The local server for real: each test brings the home into the state that it is about."""

from __future__ import annotations

import json
import os
import socket
import stat
import subprocess
import threading
import time

import psutil
import pytest
from server.live_server import START, kill, servers_of, up
from typer.testing import CliRunner

from foon_kg.cli.server import app
from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.server import connection_settings, ensure_running, status, stop
from foon_kg.store.server.process import is_free

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("local-server")]


def test_start_tells_where_it_answers_and_never_the_password(place):
    started = CliRunner().invoke(app, ["start", "--json", "--idle", "5"])
    told = json.loads(started.stdout)
    assert (told["running"], told["idle_minutes"], told["user"]) == (True, 5, "neo4j")
    assert "starting Neo4j" in started.stderr
    shown = CliRunner().invoke(app, ["start", "--quiet"])
    assert told["uri"] in shown.stdout
    assert "5 minutes" in shown.stdout
    assert shown.stderr == ""
    assert place.password_file.read_text() not in started.output + shown.output


def test_it_answers_on_loopback_only_with_a_password_only_its_owner_can_read(place, ask):
    settings = up()
    assert ask(settings, "CALL dbms.components() YIELD versions RETURN versions[0]") == status().version
    process = psutil.Process(status().pid)
    listening = {c.laddr for c in process.net_connections("tcp") if c.status == psutil.CONN_LISTEN}
    assert [address.ip for address in listening] in (["127.0.0.1"], ["::ffff:127.0.0.1"])
    assert stat.S_IMODE(place.root.stat().st_mode) == 0o700
    assert stat.S_IMODE(place.password_file.stat().st_mode) == 0o600
    assert stat.S_IMODE(place.arguments.stat().st_mode) == 0o600
    assert settings.password == place.password_file.read_text()
    assert settings.password not in repr(settings)
    assert settings.password not in " ".join(process.cmdline())


@pytest.mark.parametrize(
    "query", ["LOAD CSV FROM 'file:///etc/passwd' AS l RETURN l", "LOAD CSV FROM $there AS l RETURN l"]
)
def test_no_query_reaches_outside_the_graph(place, ask, query):
    import neo4j

    settings = up()
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(0)
        with pytest.raises(neo4j.exceptions.ClientError):
            ask(settings, query, there=f"http://127.0.0.1:{listener.getsockname()[1]}/secrets.csv")
        with pytest.raises(BlockingIOError):
            listener.accept()


def test_a_second_start_finds_the_first(place):
    settings = up()
    pid = status().pid
    assert ensure_running() == connection_settings() == up() == settings
    assert status().pid == pid


@pytest.mark.campaign
def test_two_commands_that_start_it_at_once_end_with_one_server(place):
    stop()
    commands = [subprocess.Popen(START, stdout=subprocess.PIPE, text=True) for _ in range(3)]
    answers = {command.communicate()[0] for command in commands}
    assert [command.returncode for command in commands] == [0, 0, 0]
    assert answers == {f"{status().uri}\n"}
    assert len(servers_of(place)) == 1


def test_it_can_be_stopped_and_keeps_its_data_and_its_port(place, ask):
    settings = up()
    ask(settings, "MERGE (n:Kept {key: 1}) RETURN n.key")
    assert json.loads(CliRunner().invoke(app, ["stop", "--json"]).stdout) == {"stopped": True}
    assert servers_of(place) == []
    assert status().running is False
    assert stop() is False
    assert up() == settings
    assert ask(settings, "MATCH (n:Kept) RETURN count(n)") == 1


def test_a_killed_server_is_started_again_with_everything_that_was_committed(place, ask):
    settings = up()
    ask(settings, "MERGE (n:Killed {key: 1}) RETURN n.key")
    kill(status().pid)
    assert status().running is False
    assert up() == settings
    assert ask(settings, "MATCH (n:Killed) RETURN count(n)") == 1


@pytest.mark.parametrize("content", [None, "", "{", '{"strange": 1}', "[]", '{"pid": 1'])
def test_a_running_server_is_found_although_its_record_is_lost(place, content):
    settings = up()
    pid = status().pid
    if content is None:
        place.memory_file.unlink()
    else:
        place.memory_file.write_text(content)
    assert up() == settings
    assert status().pid == pid


@pytest.mark.campaign
def test_an_unused_server_stops_by_itself_and_a_used_one_does_not(place, ask):
    stop()
    settings = up(idle_minutes=0.1)
    server = psutil.Process(status().pid)
    until = time.monotonic() + 15
    while time.monotonic() < until:  # longer than the idle time, and in use all the while
        assert ask(settings, "RETURN 1") == 1
    assert server.is_running()
    server.wait(120)
    assert status().running is False
    up(idle_minutes=30)
    assert status().idle_minutes == 30


@pytest.mark.campaign
def test_a_server_that_does_not_let_go_of_a_question_is_started_again_and_says_why(place, ask):
    """To look through a list that has itself in it over and over is one step, which no Neo4j interrupts."""
    stop()
    settings = up(idle_minutes=0.2)
    ask(settings, "CREATE (n:Note {text: 'still there'}) RETURN n.text")
    server = psutil.Process(status().pid)
    assert status().started_again is None
    with Connection(settings) as connection:
        ask_freely(connection, "RETURN 1 AS one")
        with pytest.raises(GraphError) as late:
            ask_freely(connection, "RETURN 0 IN reduce(s = [1], i IN range(1, 60) | s + s) AS endless", timeout=5)
    assert "started again" in late.value.hint
    server.wait(300)
    assert up(idle_minutes=30) == settings  # waits for whoever starts it
    assert status().pid != server.pid
    assert "AS endless" in status().started_again
    assert ask(settings, "MATCH (n:Note) RETURN n.text") == "still there"
    running = ask(settings, "SHOW TRANSACTIONS YIELD currentQuery WHERE currentQuery CONTAINS 'AS endless' "
                            "AND NOT currentQuery CONTAINS 'SHOW' RETURN count(*)")  # fmt: skip
    assert running == 0


def test_status_tells_where_everything_is(place):
    up()
    running = status()
    assert running.running
    assert running.uri == ensure_running().uri
    assert 100_000_000 < running.memory < 3_000_000_000
    assert running.data == str(place.root / "data")
    assert running.password_file == str(place.password_file)
    assert place.console_log.exists()
    stop()
    stopped = status()
    assert (stopped.running, stopped.uri, stopped.pid, stopped.memory) == (False, None, None, None)
    assert is_free(int(running.uri.rpartition(":")[2]))


@pytest.mark.campaign
def test_who_waits_for_another_command_is_told(place):
    lines = []
    first = threading.Thread(target=up)
    with place.locked():
        first.start()
        second = threading.Thread(target=up, kwargs={"say": lines.append})
        second.start()
        while not lines:
            os.sched_yield()
    first.join()
    second.join()
    assert "waiting for another foon command" in lines[0]
    assert len(servers_of(place)) == 1
