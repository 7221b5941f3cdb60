"""Who is let in, and what every answer says to a browser."""

from __future__ import annotations

import os

import pytest
from fastapi.testclient import TestClient
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner
from web.serving import SALAD, app

from foon_kg.cli import app as commands
from foon_kg.model.errors import UsageError
from foon_kg.web.security import KnownHosts, is_loopback, own_names, public_name, token_from

TOKEN = "a-token-of-enough-letters"


@pytest.fixture(scope="module")
def client():
    with TestClient(app(), base_url="http://localhost") as made:
        yield made


@pytest.fixture(scope="module")
def guarded():
    with TestClient(app(token=TOKEN), base_url="http://localhost") as made:
        yield made


@pytest.mark.parametrize("path", ["/", "/main.js", "/api/summary", "/api/nothing", "/nothing", "/picture.css"])
def test_every_answer_has_a_strict_policy(client, path):
    headers = client.get(path).headers
    policy = dict(part.strip().split(" ", 1) for part in headers["content-security-policy"].split(";"))
    assert policy["default-src"] == "'none'"
    assert policy["frame-ancestors"] == "'none'"
    assert {source for value in policy.values() for source in value.split()} == {"'none'", "'self'"}
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    assert "access-control-allow-origin" not in headers
    assert "server" not in headers


@pytest.mark.parametrize(
    "host", ["evil.example", "localhost.evil.example", "evil.example:80", "", "[evil]", "127.0.0.1.nip.io"]
)
def test_another_name_than_the_machines_is_refused(client, host):
    answer = client.get("/api/summary", headers={"host": host})
    assert answer.status_code == 421
    assert answer.json()["error"]["code"] == "host"
    assert "content-security-policy" in answer.headers


@pytest.mark.parametrize("host", ["localhost", "LOCALHOST:8000", "127.0.0.1:8000", "[::1]:8000", "192.168.1.7"])
def test_the_machines_own_names_and_addresses_are_fine(client, host):
    assert client.get("/api/summary", headers={"host": host}).status_code == 200


@given(st.text(alphabet="abcdefghijklmnopqrstuvwxyz-.", min_size=1).filter(lambda name: name != "localhost"))
def test_no_other_name_is_ever_known(name):
    assert not KnownHosts(None, own_names("127.0.0.1")).knows(name)


@pytest.fixture(scope="module")
def behind_a_proxy():
    with TestClient(app(token=TOKEN, public=["kitchen.example"]), base_url="http://kitchen.example") as made:
        made.headers["authorization"] = f"Bearer {TOKEN}"
        yield made


def test_behind_a_proxy_it_answers_under_the_name_that_it_was_given(behind_a_proxy):
    for host in ("kitchen.example", "KITCHEN.example:443", "localhost"):
        assert behind_a_proxy.get("/api/summary", headers={"host": host}).status_code == 200
    for host in ("evil.example", "kitchen.example.evil", "evil.kitchen.example", "xkitchen.example"):
        assert behind_a_proxy.get("/api/summary", headers={"host": host}).status_code == 421


@pytest.mark.parametrize(
    ("origin", "status"),
    [
        ("https://kitchen.example", 200),
        ("https://kitchen.example:8443", 200),
        ("https://evil.example", 403),
        ("https://kitchen.example.evil", 403),
        ("ftp://kitchen.example", 403),
        ("null", 403),
    ],
)
def test_behind_a_proxy_its_own_page_may_ask_whether_or_not_the_proxy_keeps_the_name(behind_a_proxy, origin, status):
    for host in ("kitchen.example", "127.0.0.1:8000"):
        assert behind_a_proxy.get("/api/summary", headers={"host": host, "origin": origin}).status_code == status


@pytest.mark.parametrize("name", ["*", "", "https://kitchen.example", "a b", "kitchen.example:80", "127.0.0.1", "-a.b"])
def test_only_a_whole_name_can_be_given(name):
    with pytest.raises(UsageError, match="no host name"):
        public_name(name)


def test_under_a_public_name_it_asks_for_a_token():
    answer = CliRunner().invoke(commands, ["serve", "--name", "kitchen.example"])
    assert answer.exit_code == 2
    assert "anybody could reach kitchen.example" in " ".join(answer.stderr.split())


@pytest.mark.parametrize("origin", ["https://evil.example", "null", "http://localhost:1", "file://"])
def test_a_page_of_another_site_may_not_ask(client, origin):
    answer = client.post("/api/plan", json=SALAD, headers={"origin": origin})
    assert answer.status_code == 403
    assert client.options("/api/plan", headers={"origin": origin}).status_code == 403


def test_the_page_itself_may_ask(client):
    assert client.get("/api/summary", headers={"origin": "http://localhost"}).status_code == 200


@pytest.mark.parametrize(
    "given_token", [None, "", "Bearer", f"Bearer {TOKEN}x", f"Bearer {TOKEN[:-1]}", f"Basic {TOKEN}", TOKEN]
)
@pytest.mark.parametrize("path", ["/api/summary", "/api/openapi.json", "/api/nothing", "/api"])
def test_without_the_token_nothing_of_the_api_is_told(guarded, path, given_token):
    answer = guarded.get(path, headers={} if given_token is None else {"authorization": given_token})
    assert answer.status_code == 401
    assert answer.headers["www-authenticate"] == "Bearer"
    assert answer.json()["error"]["code"] == "token"


def test_with_the_token_it_answers_and_the_empty_page_needs_none(guarded):
    assert guarded.get("/api/summary", headers={"authorization": f"Bearer {TOKEN}"}).status_code == 200
    for path in ("/", "/main.js", "/api.js", "/picture.css"):
        assert guarded.get(path).status_code == 200


def test_a_token_is_made_for_its_owner_alone_and_stays(tmp_path):
    path = tmp_path / "token"
    token = token_from(path)
    assert len(token) >= 32
    assert path.stat().st_mode & 0o777 == 0o600
    assert token_from(path) == token
    assert token_from(tmp_path / "other") != token


@pytest.mark.skipif(os.name != "posix", reason="modes of files are POSIX")
def test_a_token_that_others_can_read_is_refused(tmp_path):
    path = tmp_path / "token"
    token_from(path)
    path.chmod(0o640)
    with pytest.raises(UsageError, match="others can read"):
        token_from(path)


@pytest.mark.parametrize("text", ["", "short", "two words that are long enough"])
def test_a_file_that_holds_no_token_is_refused(tmp_path, text):
    path = tmp_path / "token"
    path.touch(0o600)
    path.write_text(text)
    with pytest.raises(UsageError, match="not one word"):
        token_from(path)


def test_without_a_token_it_binds_to_loopback_only():
    assert [is_loopback(host) for host in ("127.0.0.1", "::1", "localhost", "127.8.8.8")] == [True] * 4
    assert [is_loopback(host) for host in ("0.0.0.0", "::", "192.168.0.1", "example.org", "")] == [False] * 5
    answer = CliRunner().invoke(commands, ["serve", "--host", "0.0.0.0"])
    assert answer.exit_code == 2
    assert "--token-file" in answer.stderr
