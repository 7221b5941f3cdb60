"""What can go wrong with a real local server: a clear message, nothing left behind, and the next start works."""

from __future__ import annotations

import json
import os
import resource
import shutil
import signal
import socket
import subprocess
import sys

import psutil
import pytest
from server.live_server import START, servers_of, up
from server.test_fetch import repository  # noqa: F401 - a Maven repository of its own

from foon_kg.model.errors import ServerError
from foon_kg.store.server import status, stop
from foon_kg.store.server.fetch import fetch
from foon_kg.store.server.jars import pinned, sha256_of
from foon_kg.store.server.startup_cache import the_startup_cache

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("local-server")]


@pytest.fixture
def private_cache(tmp_path, monkeypatch):
    """A cache of one test alone, with every jar in it; answers the folder of the jars."""
    jars = the_startup_cache().folder
    fetch(pinned(), jars)
    private = tmp_path / "cache"
    shutil.copytree(jars, private / jars.name, copy_function=shutil.copy)
    monkeypatch.setenv("FOON_KG_CACHE", str(private))
    return private / jars.name


@pytest.mark.campaign
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


HEEDING = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
"""What lets a command be interrupted though the tests run in the background, where a shell has it ignore Ctrl-C."""


def test_after_a_start_that_is_interrupted_and_one_whose_port_is_taken_the_next_one_works(place):
    stop()
    *python, code = START
    command = subprocess.Popen([*python, HEEDING + code], stderr=subprocess.DEVNULL)
    while command.poll() is None and not servers_of(place):
        os.sched_yield()
    command.send_signal(signal.SIGINT)
    assert command.wait() != 0
    assert servers_of(place) == []
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


@pytest.mark.campaign
def test_a_port_that_it_had_before_and_another_program_has_now_is_left_to_that(place, ask):
    before = up()
    stop()
    lines = []
    with socket.create_server(("127.0.0.1", int(before.uri.rpartition(":")[2]))):
        after = up(say=lines.append)
        assert after.uri != before.uri
        assert ask(after, "RETURN 1") == 1
    assert any("taken by another program" in line and after.uri.rpartition(":")[2] in line for line in lines)


@pytest.mark.campaign
def test_a_start_without_room_says_so_and_the_next_one_works(place):
    up()
    stop()

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

    code = (
        "import sys\nfrom foon_kg.model.errors import ServerError\nfrom foon_kg.store.server import start\n"
        "try:\n    start()\nexcept ServerError as error:\n    sys.exit(f'{error.code}: {error.message}')\n"
    )
    done = subprocess.run(
        [sys.executable, "-B", "-c", code], preexec_fn=small_files, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert done.stderr.startswith("no-space: "), done.stderr
    assert servers_of(place) == []
    up()


@pytest.mark.campaign
def test_a_start_that_is_killed_leaves_a_server_that_the_next_one_takes_over(place, ask):
    stop()
    command = subprocess.Popen(START)
    while command.poll() is None and not (status().running and place.arguments.exists()):
        os.sched_yield()
    command.kill()
    command.wait()
    assert ask(up(), "RETURN 1") == 1
    assert len(servers_of(place)) == 1


@pytest.mark.campaign
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


@pytest.mark.campaign
@pytest.mark.parametrize("told", ["", "0" * 64])
def test_a_startup_cache_that_was_changed_is_taken_away_and_the_server_starts(place, private_cache, told):
    stop()
    the_startup_cache().file.write_bytes(b"no cache at all" * 1000)
    the_startup_cache().digest.write_text(told)
    said = []
    up(say=said.append)
    assert any("start-up cache is not as it was made" in line for line in said)
    assert servers_of(place) != []
    stop()


@pytest.mark.campaign
def test_a_startup_cache_that_java_cannot_use_does_not_stop_the_start(place, private_cache):
    stop()
    cache = the_startup_cache()
    cache.file.write_bytes(b"no cache at all" * 1000)
    cache.digest.write_text(sha256_of(cache.file))
    assert cache.is_as_made()
    up()
    assert servers_of(place) != []
    stop()


@pytest.mark.campaign
def test_a_jar_that_was_changed_is_fetched_again_before_anything_of_it_runs(place, private_cache, repository):  # noqa: F811 - the fixture
    stop()
    (kernel,) = [jar for jar in pinned().jars if jar.coordinates.startswith("org.neo4j:neo4j-kernel:")]
    changed = private_cache / kernel.name
    repository.contents[f"/{kernel.path}"] = changed.read_bytes()
    times = changed.stat()
    changed.write_bytes(b"\0" * kernel.size)
    os.utime(changed, ns=(times.st_atime_ns, times.st_mtime_ns))
    said = []
    up(say=said.append)
    assert any(f"{kernel.name} is not what was pinned" in line for line in said)
    assert sha256_of(changed) == kernel.sha256
    assert [path for path, _ in repository.requests] == [f"/{kernel.path}"]
    stop()


@pytest.mark.campaign
def test_a_server_whose_folder_was_removed_ends(tmp_path, monkeypatch):
    monkeypatch.setenv("FOON_KG_HOME", str(tmp_path / "home"))
    up(idle_minutes=0.1)
    server = psutil.Process(status().pid)
    shutil.rmtree(tmp_path / "home", ignore_errors=True)
    server.wait(120)
    assert not server.is_running()
