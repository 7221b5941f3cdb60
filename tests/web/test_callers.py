"""Callers are told apart by what cannot be made up: their address, or what a trusted proxy says of it."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient
from hypothesis import example, given
from hypothesis import strategies as st
from typer.testing import CliRunner
from web.serving import app

from foon_kg.cli import app as commands
from foon_kg.model.errors import UsageError
from foon_kg.web.callers import Callers, proxy_network
from foon_kg.web.limits import Limits

PROXIES = Callers((proxy_network("127.0.0.1"), proxy_network("10.1.0.0/16"), proxy_network("fd00::/8")))
SCARCE = Limits(per_second=0.001, burst=2)


def asking(peer, *told):
    headers = [(b"x-forwarded-for", line.encode("latin-1")) for line in told]
    return {"type": "http", "client": (peer, 4321), "headers": headers}


@pytest.mark.parametrize(
    ("peer", "told", "caller"),
    [
        ("127.0.0.1", [], "127.0.0.1"),
        ("127.0.0.1", ["203.0.113.9"], "203.0.113.9"),
        ("127.0.0.1", ["198.51.100.1, 203.0.113.9"], "203.0.113.9"),  # who asks wrote the first part
        ("127.0.0.1", ["203.0.113.9, 10.1.2.3"], "203.0.113.9"),  # through two proxies
        ("127.0.0.1", ["198.51.100.1", "203.0.113.9"], "203.0.113.9"),  # two lines are one list
        ("127.0.0.1", ["10.1.2.3"], "10.1.2.3"),
        ("127.0.0.1", ["203.0.113.9:50123"], "203.0.113.9"),
        ("127.0.0.1", ["[2001:db8:1:2:3:4:5:6]:443"], "2001:db8:1:2::/64"),
        ("127.0.0.1", ["unknown"], "127.0.0.1"),
        ("127.0.0.1", ["203.0.113.9, nonsense, 10.1.2.3"], "10.1.2.3"),
        ("127.0.0.1", ["203.0.113.9,"], "127.0.0.1"),
        ("::ffff:127.0.0.1", ["203.0.113.9"], "203.0.113.9"),
        ("fd00::7", ["2001:db8::1%eth0"], "2001:db8::/64"),
        ("203.0.113.9", ["198.51.100.1"], "203.0.113.9"),  # no proxy: what it says of itself is nothing
        ("2001:db8::1", ["198.51.100.1"], "2001:db8::/64"),
        ("testclient", ["198.51.100.1"], ""),
    ],
)
def test_the_caller_is_the_last_that_no_proxy_is(peer, told, caller):
    assert PROXIES.of(asking(peer, *told)) == caller
    alone = Callers().of(asking(peer, *told))
    assert alone == Callers().of(asking(peer))  # as a rule nobody is believed


def test_nobody_asks_where_there_is_no_socket():
    assert Callers().of({"type": "http", "client": None, "headers": []}) == ""


@given(st.text(st.characters(max_codepoint=255, exclude_characters="\r\n")))
@example("203.0.113.9, ")
@example("127.0.0.1, 10.1.9.9, ")
def test_nothing_that_a_caller_writes_makes_it_another(written):
    assert PROXIES.of(asking("127.0.0.1", f"{written}, 198.51.100.7")) == "198.51.100.7"
    assert PROXIES.of(asking("127.0.0.1", written, "198.51.100.7")) == "198.51.100.7"
    assert Callers().of(asking("198.51.100.7", written)) == "198.51.100.7"


@pytest.mark.parametrize("text", ["", "localhost", "10.0.0.0/99", "0.0.0.0/0", "::/0", "example.org"])
def test_what_is_no_proxy_is_refused(text):
    with pytest.raises(UsageError):
        proxy_network(text)


def statuses(application, peer, *callers):
    with TestClient(application, base_url="http://localhost", client=(peer, 1234)) as client:
        headers = [{"x-forwarded-for": caller} for caller in callers]
        return [client.get("/api/summary", headers=told).status_code for told in headers]


def test_callers_behind_a_proxy_have_a_rate_each():
    many = ["203.0.113.1", "203.0.113.2", "203.0.113.1", "203.0.113.1", "203.0.113.2", "203.0.113.2"]
    assert statuses(app(limits=SCARCE, callers=PROXIES), "127.0.0.1", *many) == [200, 200, 200, 429, 200, 429]
    assert statuses(app(limits=SCARCE), "127.0.0.1", *many) == [200, 200, 429, 429, 429, 429]
    assert statuses(app(limits=SCARCE, callers=PROXIES), "203.0.113.9", *many) == [200, 200, 429, 429, 429, 429]


def test_the_command_refuses_to_believe_everybody(tmp_path):
    answer = CliRunner().invoke(commands, ["serve", "--proxy", "0.0.0.0/0", "--token-file", str(tmp_path / "token")])
    assert answer.exit_code == 2
    assert "0.0.0.0/0 is every address there is" in str(answer.exception) + answer.output
