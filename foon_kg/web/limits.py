"""How much one may ask: the size of a body, the time to send it, how often an address asks; as ASGI middleware."""

from __future__ import annotations

import asyncio
import math
import time
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass

from starlette.datastructures import Headers
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from foon_kg.model.errors import FoonError
from foon_kg.web.callers import Callers
from foon_kg.web.questions import Reply

_NO_JSON = FoonError(
    "the body is not said to be JSON", hint="Send Content-Type: application/json.", code="content-type"
)
_CROWD = FoonError("too much is asked at once", hint="Ask again in a second.", code="busy")
_SLOW = FoonError("the body did not come in time", hint="Send it faster.", code="slow")

TABLES = "/api/teach/"
"""Below this path a question has a whole table with it."""

MOST_CALLERS = 4096
"""Of so many callers it is remembered how often they asked."""


@dataclass(frozen=True)
class Limits:
    """What the service puts up with.

    ``body`` in bytes, ``table`` where a whole draft is sent (below ``TABLES``); ``seconds`` for a question, and for
    sending it; of one caller ``per_second`` requests, and ``burst`` at once; ``waiting`` plans that are under way or
    wait; ``requests`` under way at once; ``connections`` that are open, ``of_one`` caller; ``asking`` seconds from a
    connection's begin to its first whole request.
    """

    body: int = 64 * 1024
    table: int = 1024 * 1024
    seconds: float = 20.0
    per_second: float = 50.0
    burst: int = 100
    waiting: int = 16
    requests: int = 200
    connections: int = 400
    of_one: int = 100
    asking: float = 10.0


async def refuse(
    scope: Scope, send: Send, status: int, error: FoonError, headers: Mapping[str, str] | None = None
) -> None:
    """Answer the HTTP request of a ``scope`` with ``error``, as every error of this service looks.

    ``send`` takes the answer, with this ``status`` and more ``headers``.
    """
    body = Reply.of_error(error).body
    told = {"content-type": "application/json", "content-length": str(len(body)), **(headers or {})}
    raw = [(name.encode("latin-1"), value.encode("latin-1")) for name, value in told.items()]
    await send({"type": "http.response.start", "status": status, "headers": raw})
    await send({"type": "http.response.body", "body": b"" if scope["method"] == "HEAD" else body})


class CrowdLimit:
    """Refuses (503) what is asked while as many requests are under way as this puts up with."""

    def __init__(self, app: ASGIApp, limits: Limits) -> None:
        self.app = app
        self.limits = limits
        self._under_way = 0

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or refuse it."""
        if scope["type"] != "http":
            return await self.app(scope, receive, send)
        if self._under_way >= self.limits.requests:
            return await refuse(scope, send, 503, _CROWD, {"retry-after": "1"})
        self._under_way += 1
        try:
            return await self.app(scope, receive, send)
        finally:
            self._under_way -= 1


class RateLimit:
    """Refuses (429) a caller who asks too often: a bucket of ``burst`` tokens that fills at ``per_second``."""

    def __init__(self, app: ASGIApp, limits: Limits, callers: Callers) -> None:
        self.app = app
        self.limits = limits
        self.callers = callers
        self._left: OrderedDict[str, tuple[float, float]] = OrderedDict()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or refuse it."""
        if scope["type"] == "http":
            wait = self._wait(self.callers.of(scope))
            if wait > 0:
                seconds = str(math.ceil(wait))
                error = FoonError("this address asks too often", hint=f"Ask again in {seconds} s.", code="rate")
                return await refuse(scope, send, 429, error, {"retry-after": seconds})
        return await self.app(scope, receive, send)

    def _wait(self, caller: str) -> float:
        """Take one token of ``caller``; return how many seconds are missing to the next where there is none."""
        now = time.monotonic()
        left, then = self._left.pop(caller, (float(self.limits.burst), now))
        left = min(self.limits.burst, left + (now - then) * self.limits.per_second)
        self._left[caller] = (max(left - 1, 0) if left >= 1 else left, now)
        while len(self._left) > MOST_CALLERS:
            self._left.popitem(last=False)
        return 0.0 if left >= 1 else (1 - left) / self.limits.per_second


class BodyLimit:
    """Reads the body whole before anything else sees it; refuses one that is too large, too slow or no JSON."""

    def __init__(self, app: ASGIApp, limits: Limits) -> None:
        self.app = app
        self.limits = limits

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on with its body, or refuse it."""
        if scope["type"] != "http" or scope["method"] in {"GET", "HEAD"}:
            return await self.app(scope, receive, send)
        headers = Headers(scope=scope)
        media_type = headers.get("content-type", "").partition(";")[0].strip().lower()
        if scope["method"] == "POST" and media_type != "application/json":
            return await refuse(scope, send, 415, _NO_JSON)
        try:
            most = self.limits.table if scope["path"].startswith(TABLES) else self.limits.body
            body = await asyncio.wait_for(self._read(headers, receive, most), self.limits.seconds)
        except TimeoutError:
            return await refuse(scope, send, 408, _SLOW, {"connection": "close"})
        if body is None:
            large = FoonError(f"the body has more than {most} bytes", hint="Ask for less at once.", code="size")
            return await refuse(scope, send, 413, large, {"connection": "close"})
        return await self.app(scope, replaying(body, receive), send)

    async def _read(self, headers: Headers, receive: Receive, most: int) -> bytes | None:
        """Return the body; ``None`` where it has more than ``most`` bytes."""
        length = headers.get("content-length", "0")
        if not length.isdecimal() or int(length) > most:
            return None
        body = bytearray()
        while True:
            message = await receive()
            body += message.get("body", b"")
            if len(body) > most:
                return None
            if not message.get("more_body", False):
                return bytes(body)


def replaying(body: bytes, receive: Receive) -> Receive:
    """Return what gives the ``body`` that was read once more, then what ``receive`` gives."""
    told = False

    async def give() -> Message:
        nonlocal told
        if told:
            return await receive()
        told = True
        return {"type": "http.request", "body": body, "more_body": False}

    return give
