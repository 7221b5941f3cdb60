"""The demo's FOON as a service: in this process, or behind a socket for a browser."""

from __future__ import annotations

import contextlib
import socket
import threading

import httpx
from pictures.demo_plans import demo_foon

from foon_kg.web.api import web_app
from foon_kg.web.callers import Callers
from foon_kg.web.connections import server_of
from foon_kg.web.foon import FixedFoon
from foon_kg.web.limits import Limits
from foon_kg.web.service import FoonService

PLENTY = Limits(seconds=300.0, per_second=10_000, burst=10_000)
NAMES = frozenset({"localhost", "127.0.0.1"})
SALAD = {"dish_type": "salad", "ingredients": ["sliced kohlrabi", "chopped onion", "olive oil"]}


def app(*, foon=None, token=None, limits=PLENTY, most=16, processes=0, public=(), callers=None, patience=60):
    service = FoonService(foon or FixedFoon(demo_foon()), processes=processes, most=most, patience=patience, pause=0)
    return web_app(service, names=NAMES, public=public, token=token, limits=limits, callers=callers)


@contextlib.contextmanager
def served(application, callers=None):
    """The address of ``application`` behind a real socket."""
    listener = socket.create_server(("127.0.0.1", 0))
    server = server_of(application, application.state.limits, callers or Callers())
    thread = threading.Thread(target=server.run, args=([listener],), daemon=True)
    thread.start()
    address = f"http://127.0.0.1:{listener.getsockname()[1]}"
    try:
        httpx.get(f"{address}/api/summary", timeout=120)  # the socket listens already: it waits for the first answer
        yield address
    finally:
        server.should_exit = True
        thread.join(10)


def error_of(answer):
    """Return the error that an answer tells, in the form of all of them."""
    told = answer.json()["error"]
    assert set(told) >= {"code", "message", "hint"}
    return told
