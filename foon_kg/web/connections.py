"""Who is connected: so many at once, so many of one caller, and whoever does not ask in time makes room for others."""

from __future__ import annotations

import asyncio
import itertools
from functools import partial
from typing import Any

import h11
import uvicorn
from fastapi import FastAPI
from uvicorn.protocols.http.h11_impl import H11Protocol
from uvicorn.server import ServerState

from foon_kg.model.errors import FoonError
from foon_kg.web.callers import Callers
from foon_kg.web.limits import Limits
from foon_kg.web.questions import Reply
from foon_kg.web.security import HEADERS

_KEPT_OPEN = 5
"""Seconds for which a connection on which nothing more is asked is kept."""

_TO_END = 5
"""Seconds that answers under way may take where the service ends."""


_TURNS = itertools.count(1)


class PatientProtocol(H11Protocol):
    """HTTP of uvicorn, which itself waits for a request without end.

    A request has to be there within ``limits.asking`` seconds. Where one more connection is too many, of all or of one
    caller, the one goes that has waited longest for its caller to ask; one that has asked is never closed for it.
    """

    def __init__(
        self, limits: Limits, callers: Callers, *, config: uvicorn.Config, server_state: ServerState,
        app_state: dict[str, Any], _loop: asyncio.AbstractEventLoop | None = None,
    ) -> None:  # fmt: skip
        super().__init__(config, server_state, app_state, _loop)
        self._limits = limits
        self._callers = callers
        self.caller: str | None = None
        self.since = 0
        self._too_late: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Take the connection of a ``transport``, and make room for it."""
        super().connection_made(transport)
        self.caller = self._callers.at_the_end_of(self.client)
        others = [one for one in self.connections if isinstance(one, PatientProtocol) and one is not self]
        same = [one for one in others if self.caller is not None and one.caller == self.caller]
        if len(same) >= self._limits.of_one:
            if not _close_oldest(same):
                transport.abort()
        elif len(others) >= self._limits.connections - 1:
            _close_oldest(others)
        self._wait_for_request()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the connection, whatever ``exc`` ended it."""
        self._stop_waiting()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Read the ``data`` that came; a request that is whole ends the wait for it."""
        if len(self.connections) >= self._limits.connections:  # those that are being closed take nobody's room
            closing = sum(one.transport.is_closing() for one in self.connections)
            self.limit_concurrency = self._limits.connections + closing
        super().data_received(data)
        if not self.waits():
            self._stop_waiting()

    def send_400_response(self, msg: str) -> None:
        """Refuse what is no request of HTTP with ``msg``, as every error of this service looks."""
        reply = Reply.of_error(FoonError(msg.rstrip(".").lower(), hint="Send HTTP/1.1.", code="request"))
        headers = {**HEADERS, "content-type": "application/json", "connection": "close"}
        raw = [(name.encode(), value.encode()) for name, value in headers.items()]
        for event in (h11.Response(status_code=400, headers=raw), h11.Data(data=reply.body), h11.EndOfMessage()):
            self.transport.write(self.conn.send(event) or b"")
        self.transport.close()

    def on_response_complete(self) -> None:
        """Wait for the next request."""
        super().on_response_complete()
        if self.waits():
            self._wait_for_request()

    def waits(self) -> bool:
        """Whether the next request is not there yet."""
        return self.cycle is None or self.cycle.response_complete

    def _wait_for_request(self) -> None:
        self._stop_waiting()
        self.since = next(_TURNS)  # no time: many connections come within one turn of the loop
        self._too_late = self.loop.call_later(self._limits.asking, self.transport.abort)

    def _stop_waiting(self) -> None:
        if self._too_late is not None:
            self._too_late.cancel()
            self._too_late = None


def _close_oldest(connections: list[PatientProtocol]) -> bool:
    """Close the connection that has waited longest for a request; whether one of them waits."""
    waiting = [one for one in connections if one.waits() and not one.transport.is_closing()]
    if not waiting:
        return False
    min(waiting, key=lambda one: one.since).transport.abort()
    return True


def server_of(app: FastAPI, limits: Limits, callers: Callers) -> uvicorn.Server:
    """Return the server that brings ``app`` behind sockets, within ``limits``; ``callers`` knows who asks."""
    config = uvicorn.Config(
        app,
        http=partial(PatientProtocol, limits, callers),  # type: ignore[arg-type] # called like a class
        log_level="warning",
        server_header=False,
        proxy_headers=False,
        ws="none",
        limit_concurrency=limits.connections,
        timeout_keep_alive=_KEPT_OPEN,
        timeout_graceful_shutdown=_TO_END,
    )
    return uvicorn.Server(config)
