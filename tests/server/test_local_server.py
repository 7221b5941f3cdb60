"""The local server for real: each test brings the home into the state that it is about."""

from __future__ import annotations

import json
import os
import resource
import shutil
import signal
import socket
import stat
import subprocess
import sys
import threading
import time

import psutil
import pytest

from foon_kg.errors import ServerError
from foon_kg.server import connection_settings, ensure_running, start, status, stop
from foon_kg.server.process import is_free

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("local-server")]

START = "from foon_kg.server import start; print(start().uri)"


def no_warming(_settings):
    """Take the place of the graph layer's warming, which is not what these tests are about."""


def up(**options):
    return start(after_start=no_warming, **options)


def say_to(lines):
    return {"say": lines.append}


def servers_of(place):
    """Every process that runs Neo4j on this home."""
    argument = f"@{place.arguments}"
    return [process for process in psutil.process_iter(["cmdline"]) if argument in (process.info["cmdline"] or ())]


def kill(pid):
    process = psutil.Process(pid)
    process.kill()
    process.wait()


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


def test_two_commands_that_start_it_at_once_end_with_one_server(place):
    stop()
    commands = [subprocess.Popen([sys.executable, "-c", START], stdout=subprocess.PIPE, text=True) for _ in range(3)]
    answers = {command.communicate()[0] for command in commands}
    assert [command.returncode for command in commands] == [0, 0, 0]
    assert answers == {f"{status().uri}\n"}
    assert len(servers_of(place)) == 1


def test_it_can_be_stopped_and_keeps_its_data_and_its_port(place, ask):
    settings = up()
    ask(settings, "MERGE (n:Kept {key: 1}) RETURN n.key")
    assert stop() is True
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


def test_a_process_id_that_another_process_has_got_is_not_taken_for_the_server(place):
    up()
    stop()
    with subprocess.Popen(["sleep", "1000"]) as other:
        record = json.loads(place.memory_file.read_text())
        place.memory_file.write_text(json.dumps(record | {"pid": other.pid}))
        assert status().running is False
        assert stop() is False
        up()
        assert status().pid != other.pid
        assert other.poll() is None
        other.kill()


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


def test_a_port_that_is_taken_is_said_and_the_next_start_works(place):
    stop()
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(ServerError, match=f"port {port} is in use") as caught:
            up(port=port)
        assert "--port" in caught.value.hint
        assert servers_of(place) == []
    assert up(port=port).uri.endswith(f":{port}")
    with pytest.raises(ServerError, match=f"runs already, on port {port}"):
        up(port=port + 1)
    assert servers_of(place) != []


def test_a_port_that_it_had_before_and_another_program_has_now_is_left_to_that(place, ask):
    before = up()
    stop()
    lines = []
    with socket.create_server(("127.0.0.1", int(before.uri.rpartition(":")[2]))):
        after = up(**say_to(lines))
        assert after.uri != before.uri
        assert ask(after, "RETURN 1") == 1
    assert any("taken by another program" in line and after.uri.rpartition(":")[2] in line for line in lines)


def test_a_start_without_room_says_so_and_the_next_one_works(place):
    up()
    stop()

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

    code = (
        "import sys\nfrom foon_kg.errors import ServerError\nfrom foon_kg.server import start\n"
        "try:\n    start()\nexcept ServerError as error:\n    sys.exit(f'{error.code}: {error.message}')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], preexec_fn=small_files, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert done.stderr.startswith("no-space: "), done.stderr
    assert servers_of(place) == []
    up()


def test_a_start_that_is_interrupted_leaves_no_server_behind(place):
    stop()
    command = subprocess.Popen([sys.executable, "-c", START], stderr=subprocess.DEVNULL)
    while command.poll() is None and not servers_of(place):
        os.sched_yield()
    command.send_signal(signal.SIGINT)
    assert command.wait() != 0
    assert servers_of(place) == []
    up()


def test_a_start_that_is_killed_leaves_a_server_that_the_next_one_takes_over(place, ask):
    stop()
    command = subprocess.Popen([sys.executable, "-c", START])
    while command.poll() is None and not (status().running and place.arguments.exists()):
        os.sched_yield()
    command.kill()
    command.wait()
    assert ask(up(), "RETURN 1") == 1
    assert len(servers_of(place)) == 1


def test_a_lost_password_is_said_with_its_path(place):
    up()
    stop()
    password = place.password_file.read_text()
    place.password_file.unlink()
    with pytest.raises(ServerError, match=str(place.password_file)) as caught:
        up()
    assert caught.value.code == "password"
    assert servers_of(place) == []
    place.password_file.write_text("another password")
    with pytest.raises(ServerError, match="does not accept the password") as caught:
        up()
    assert caught.value.code == "password"
    assert servers_of(place) == []
    place.password_file.write_text(password)
    up()


def test_a_broken_startup_cache_does_not_stop_the_start(place, tmp_path, monkeypatch):
    from foon_kg.server.home import cache_folder
    from foon_kg.server.startup_cache import the_startup_cache

    stop()
    private = tmp_path / "cache"
    private.mkdir()
    jars = next(cache_folder().glob("neo4j-*"))
    monkeypatch.setenv("FOON_KG_CACHE", str(private))
    shutil.copytree(jars, private / jars.name, copy_function=os.link)
    the_startup_cache().file.write_bytes(b"no cache at all" * 1000)
    up()
    assert servers_of(place) != []
    stop()


def test_a_damaged_jar_is_named_and_removed_so_that_it_is_fetched_again(place, tmp_path, monkeypatch):
    from foon_kg.server.home import cache_folder
    from foon_kg.server.jars import pinned

    stop()
    private = tmp_path / "cache"
    private.mkdir()
    jars = next(cache_folder().glob("neo4j-*"))
    monkeypatch.setenv("FOON_KG_CACHE", str(private))
    shutil.copytree(jars, private / jars.name, copy_function=os.link)
    (kernel,) = [jar for jar in pinned().jars if jar.coordinates.startswith("org.neo4j:neo4j-kernel:")]
    broken = private / jars.name / kernel.name
    broken.unlink()
    broken.write_bytes(b"\0" * kernel.size)
    with pytest.raises(ServerError, match=f"damaged on disk.*{kernel.name}") as caught:
        up()
    assert "start it again" in caught.value.hint
    assert pinned().missing(private / jars.name) == (kernel,)
    assert servers_of(place) == []


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


def test_a_server_whose_folder_was_removed_ends(tmp_path, monkeypatch):
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "home"))
    up(idle_minutes=0.1)
    server = psutil.Process(status().pid)
    shutil.rmtree(tmp_path / "home", ignore_errors=True)
    server.wait(120)


def test_who_waits_for_another_command_is_told(place):
    lines = []
    first = threading.Thread(target=up)
    with place.locked():
        first.start()
        second = threading.Thread(target=up, kwargs=say_to(lines))
        second.start()
        while not lines:
            os.sched_yield()
    first.join()
    second.join()
    assert "waiting for another foon command" in lines[0]
    assert len(servers_of(place)) == 1
