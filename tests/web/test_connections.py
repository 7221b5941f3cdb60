"""Who opens connections and asks nothing keeps nobody out: neither by their number nor by how slowly they ask."""

from __future__ import annotations

import contextlib
import select
import socket
import subprocess
import sys
from dataclasses import replace
from urllib.parse import urlsplit

import httpx
import pytest
from web.serving import PLENTY, app, served

from foon_kg.foon.demo import demo_folder
from foon_kg.web.callers import Callers, proxy_network

PROGRAM = "import sys; from foon_kg.cli import main; sys.exit(main())"
HALF = b"GET /api/summary HTTP/1.1\r\nHost: localhost\r\nX-Half: "
WHOLE = b"GET /api/summary HTTP/1.1\r\nHost: localhost\r\n\r\n"
NEVER = 100_000.0


@contextlib.contextmanager
def half_sent(address, count, hosts=("127.0.0.1",), words=HALF):
    """Hold so many connections on which a request has begun, from each of ``hosts`` by turns."""
    there = urlsplit(address)
    with contextlib.ExitStack() as stack:
        held = []
        for number in range(count):
            source = (hosts[number % len(hosts)], 0)
            one = stack.enter_context(socket.create_connection((there.hostname, there.port), 60, source))
            one.sendall(words)
            held.append(one)
        yield held


def is_closed(connection):
    """Wait for what the server says; whether it said nothing and closed."""
    try:
        return connection.recv(1) == b""
    except ConnectionResetError:
        return True


def limits(**changed):
    return replace(PLENTY, **changed)


@pytest.mark.slow
def test_hundreds_of_half_sent_requests_keep_nobody_out_of_the_command(tmp_path):
    arguments = ["serve", "--files", str(demo_folder()), "--port", "0", "--jobs", "1"]
    serving = subprocess.Popen([sys.executable, "-c", PROGRAM, *arguments], stderr=subprocess.PIPE, text=True)
    try:
        address = serving.stderr.readline().strip()
        with half_sent(address, 430):
            assert httpx.get(f"{address}api/summary", timeout=60).status_code == 200
    finally:
        serving.kill()
        serving.wait()
        serving.stderr.close()


@pytest.mark.parametrize("hosts", [["127.0.0.1"], [f"127.0.0.{n}" for n in range(2, 9)]], ids=["one", "seven"])
@pytest.mark.parametrize("words", [b"", HALF], ids=["nothing", "half"])
def test_room_is_made_where_somebody_asks(hosts, words):
    """However long it may take to ask: who waited longest without asking goes."""
    few = limits(asking=NEVER, connections=100, of_one=30)
    with served(app(limits=few)) as address, half_sent(address, 200, hosts, words) as held:
        assert httpx.get(f"{address}/api/summary", timeout=60).status_code == 200
        assert is_closed(held[0])
        held[-1].sendall(WHOLE if not words else b"x\r\n\r\n")
        assert held[-1].recv(12) == b"HTTP/1.1 200"  # who came last is still there


def test_an_address_has_no_more_connections_than_that_but_a_proxy_has():
    few = limits(asking=NEVER, connections=100, of_one=3)
    with served(app(limits=few)) as address, half_sent(address, 4) as held:
        assert is_closed(held[0])
    proxies = Callers((proxy_network("127.0.0.1"),))
    with served(app(limits=few), proxies) as address, half_sent(address, 20) as held:
        for one in held:
            one.sendall(b"x\r\n\r\n")
        assert {one.recv(12) for one in held} == {b"HTTP/1.1 200"}


@pytest.mark.parametrize("first", [b"", WHOLE], ids=["the first request", "the next one"])
def test_a_request_that_does_not_come_to_its_end_is_closed(first):
    with served(app(limits=limits(asking=1.0))) as address, half_sent(address, 1, words=first) as (slow,):
        if first:
            while not (told := slow.recv(65536)).endswith(b"}"):
                assert told
        slow.sendall(HALF)
        assert is_closed(slow)


def test_one_letter_after_another_wins_no_time():
    with served(app(limits=limits(asking=1.0))) as address, half_sent(address, 1) as (slow,):
        while not select.select([slow], [], [], 0.02)[0]:
            slow.sendall(b"x")
        assert is_closed(slow)


def test_who_has_asked_is_waited_for():
    """A request that is under way is no connection that waits, however many come meanwhile."""
    body = b'{"dish_type": "salad", "ingredients": ["chopped onion"]}'
    head = "POST /api/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
    few = limits(asking=NEVER, connections=20, of_one=5)
    with served(app(limits=few)) as address, half_sent(address, 1, words=b"") as (early,):
        early.sendall(f"{head}Content-Length: {len(body)}\r\n\r\n".encode())
        httpx.get(f"{address}/api/summary", timeout=60)  # by now the head has been read
        with half_sent(address, 15):
            httpx.get(f"{address}/api/summary", timeout=60)
            early.sendall(body)
            assert early.recv(12) == b"HTTP/1.1 200"
