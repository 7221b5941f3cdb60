import os
import resource
import signal
import subprocess
import sys
import textwrap
import threading

import pytest
from server.maven_repository import MavenRepository, serve

from foon_kg.model.errors import ServerError
from foon_kg.store.server.fetch import TRIES, fetch, repositories
from foon_kg.store.server.jars import JarSet


@pytest.fixture
def repository(monkeypatch):
    made = MavenRepository()
    server = serve(made)
    monkeypatch.setenv("FOON_KG_MAVEN", made.address)
    yield made
    if made.stall:
        made.stall.set()
    server.shutdown()
    server.server_close()


def contents(folder):
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def expected(repository, jars):
    return {jar.name: repository.contents[f"/{jar.path}"] for jar in jars}


@pytest.mark.slow
def test_every_jar_arrives_whole_and_nothing_else_stays(repository, tmp_path, capfd):
    jar_set = repository.jar_set(20)
    fetch(jar_set, tmp_path / "jars")
    assert contents(tmp_path / "jars") == expected(repository, jar_set.jars)
    assert jar_set.missing(tmp_path / "jars") == ()
    assert capfd.readouterr() == ("", "")  # a bar is for terminals


def test_what_is_there_is_not_asked_for_again(repository, tmp_path):
    jar_set = repository.jar_set(6)
    fetch(JarSet("1.0", jar_set.jars[:4]), tmp_path)
    repository.requests.clear()
    fetch(jar_set, tmp_path)
    assert sorted(path for path, _ in repository.requests) == [f"/{jar.path}" for jar in jar_set.jars[4:]]
    repository.requests.clear()
    fetch(jar_set, tmp_path)
    assert repository.requests == []


def test_a_file_that_was_broken_off_is_continued_where_it_ended(repository, tmp_path):
    jar_set = repository.jar_set(1)
    (jar,) = jar_set.jars
    (tmp_path / f"{jar.name}.part").write_bytes(repository.contents[f"/{jar.path}"][:1234])
    fetch(jar_set, tmp_path)
    assert repository.first_bytes_asked(jar) == [1234]
    assert contents(tmp_path) == expected(repository, jar_set.jars)


def test_a_connection_that_ends_early_is_taken_up_again(repository, tmp_path):
    jar_set = repository.jar_set(3)
    jar = jar_set.jars[1]
    repository.cut[f"/{jar.path}"] = 700
    fetch(jar_set, tmp_path)
    assert repository.first_bytes_asked(jar) == [0, 700]
    assert contents(tmp_path) == expected(repository, jar_set.jars)


def test_a_repository_without_ranges_is_read_from_the_start(repository, tmp_path):
    jar_set = repository.jar_set(1)
    (jar,) = jar_set.jars
    repository.understands_ranges = False
    (tmp_path / f"{jar.name}.part").write_bytes(b"x" * 99)
    fetch(jar_set, tmp_path)
    assert contents(tmp_path) == expected(repository, jar_set.jars)


@pytest.mark.slow
@pytest.mark.parametrize("left", [b"", b"wrong from the start", b"z" * 5_000, b"z" * 9_000])
def test_a_wrong_remainder_of_an_earlier_fetch_does_no_harm(repository, tmp_path, left):
    jar_set = repository.jar_set(1)
    (tmp_path / f"{jar_set.jars[0].name}.part").write_bytes(left)
    fetch(jar_set, tmp_path)
    assert contents(tmp_path) == expected(repository, jar_set.jars)


def test_other_content_is_refused_and_never_gets_the_name(repository, tmp_path):
    jar_set = repository.jar_set(3)
    jar = jar_set.jars[1]
    right = repository.contents[f"/{jar.path}"]
    repository.contents[f"/{jar.path}"] = right[:-1] + b"!"
    with pytest.raises(ServerError, match=r"part1-1\.0\.jar.*not the pinned file") as caught:
        fetch(jar_set, tmp_path)
    assert caught.value.code == "checksum"
    assert "FOON_KG_MAVEN" in caught.value.hint
    assert jar in jar_set.missing(tmp_path)
    repository.contents[f"/{jar.path}"] = right
    fetch(jar_set, tmp_path)
    assert contents(tmp_path) == expected(repository, jar_set.jars)


def test_a_jar_that_no_repository_has_is_named(repository, tmp_path):
    jar_set = repository.jar_set(2)
    del repository.contents[f"/{jar_set.jars[0].path}"]
    with pytest.raises(ServerError, match=r"org/example/part0/1\.0/part0-1\.0\.jar cannot be fetched") as caught:
        fetch(jar_set, tmp_path)
    assert "kept" in caught.value.hint


@pytest.mark.slow
def test_no_network_is_said_and_what_came_is_kept(repository, tmp_path, monkeypatch):
    jar_set = repository.jar_set(2)
    fetch(JarSet("1.0", jar_set.jars[:1]), tmp_path)
    monkeypatch.setenv("FOON_KG_MAVEN", "http://127.0.0.1:9")
    with pytest.raises(ServerError, match="cannot be fetched") as caught:
        fetch(jar_set, tmp_path)
    assert caught.value.code == "fetch"
    assert jar_set.missing(tmp_path) == jar_set.jars[1:]
    assert TRIES > 1


FETCH = textwrap.dedent("""
    import json, sys
    from pathlib import Path
    from foon_kg.model.errors import ServerError
    from foon_kg.store.server.fetch import fetch
    from foon_kg.store.server.jars import from_json
    try:
        fetch(from_json(json.loads(sys.argv[1])), Path(sys.argv[2]))
    except ServerError as error:
        sys.exit(f"{error.code}: {error.message}")
""")


def fetch_command(jar_set, folder):
    rows = ", ".join(
        f'{{"coordinates": "{jar.coordinates}", "size": {jar.size}, "sha256": "{jar.sha256}"}}' for jar in jar_set.jars
    )
    return [sys.executable, "-B", "-c", FETCH, f'{{"version": "1.0", "jars": [{rows}]}}', str(folder)]


def test_a_fetch_that_is_killed_goes_on_where_it_was(repository, tmp_path):
    jar_set = repository.jar_set(1, size=400_000)
    (jar,) = jar_set.jars
    part = tmp_path / f"{jar.name}.part"
    repository.stall = threading.Event()
    child = subprocess.Popen(fetch_command(jar_set, tmp_path))
    while child.poll() is None and not repository.requests:
        os.sched_yield()
    child.send_signal(signal.SIGKILL)
    child.wait()
    repository.stall.set()
    repository.stall = None
    assert not (tmp_path / jar.name).exists()
    came = part.stat().st_size if part.exists() else 0
    fetch(jar_set, tmp_path)
    assert repository.first_bytes_asked(jar)[-1] == came
    assert contents(tmp_path) == expected(repository, jar_set.jars)


@pytest.mark.slow
def test_a_full_disk_is_said_and_the_next_fetch_works(repository, tmp_path):
    jar_set = repository.jar_set(2, size=300_000)
    limit = 100_000

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    command = fetch_command(jar_set, tmp_path)
    done = subprocess.run(command, preexec_fn=small_files, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.startswith("no-space: ")
    assert str(tmp_path) in done.stderr
    fetch(jar_set, tmp_path)
    assert contents(tmp_path) == expected(repository, jar_set.jars)


def test_a_folder_that_cannot_be_made_is_an_error_with_its_path(repository, tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(ServerError, match="file/jars") as caught:
        fetch(repository.jar_set(1), tmp_path / "file" / "jars")
    assert "FOON_KG_CACHE" in caught.value.hint


def test_the_named_repository_is_the_only_one_asked(monkeypatch):
    monkeypatch.setenv("FOON_KG_MAVEN", "http://127.0.0.1:9/mirror/")
    assert repositories() == ("http://127.0.0.1:9/mirror",)


def test_a_repository_of_the_persons_own_jgo_configuration_is_asked_too(monkeypatch, tmp_path):
    monkeypatch.delenv("FOON_KG_MAVEN", raising=False)
    configuration = tmp_path / "jgo.conf"
    configuration.write_text("[repositories]\nours = http://127.0.0.1:9/ours\n")
    monkeypatch.setenv("JGO_CONFIG_FILE", str(configuration))
    assert repositories()[1:] == ("http://127.0.0.1:9/ours",)
    assert repositories()[0].startswith("https://")
