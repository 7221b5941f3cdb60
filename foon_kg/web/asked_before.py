"""What was asked before in the same words is answered before anybody reads them; as ASGI middleware."""

from __future__ import annotations

from starlette.datastructures import Headers
from starlette.types import ASGIApp, Receive, Scope, Send

from foon_kg.web.limits import replaying
from foon_kg.web.questions import Reply
from foon_kg.web.service import Edition, FoonService

PATHS = frozenset({"/api/examples", "/api/plan", "/api/suggest"})

EDITION, NEWER = "foon-edition", "foon-newer"
"""The headers that name the edition of the FOON that answered, and a newer one that is being read."""

KEPT_BY_ASKERS = "private, no-cache"
"""Who asks may keep an answer, and has to ask whether it still is the answer."""

OK, NOT_MODIFIED = 200, 304


class AskedBefore:
    """Answers from what ``service`` keeps. It stands behind all that may refuse a request, and after the body is read.

    The words of a question are its method, path, query and body, byte for byte; ``scope["words"]`` has them where they
    are new.
    """

    def __init__(self, app: ASGIApp, service: FoonService) -> None:
        self.app = app
        self.service = service

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send the answer that is kept, or pass the request on."""
        if scope["type"] != "http" or scope["path"] not in PATHS:
            return await self.app(scope, receive, send)
        body = b"" if scope["method"] in {"GET", "HEAD"} else (await receive()).get("body", b"")
        words = b"\0".join((scope["method"].encode(), scope["path"].encode(), scope["query_string"], body))
        there = self.service.kept_answer(words)
        if there is None:
            return await self.app({**scope, "words": words}, replaying(body, receive), send)
        edition, reply = there
        status, headers, content = http_response(reply, edition, scope)
        headers |= {"content-length": str(len(content))} if status != NOT_MODIFIED else {}
        raw = [(name.encode(), value.encode()) for name, value in headers.items()]
        await send({"type": "http.response.start", "status": status, "headers": raw})
        return await send({"type": "http.response.body", "body": content})


def edition_headers(edition: Edition) -> dict[str, str]:
    """Return the headers that say which edition of the FOON answered, and which newer one is being read."""
    return {EDITION: edition.name} | ({NEWER: edition.newer} if edition.newer else {})


def http_response(reply: Reply, edition: Edition, scope: Scope) -> tuple[int, dict[str, str], bytes]:
    """Return status, headers and body of a ``reply``: nothing but its mark for one who asks with GET and has it.

    ``edition`` of the FOON is in the mark; ``scope`` is that of the request.
    """
    headers = {"content-type": "application/json", **edition_headers(edition)}
    if scope["method"] != "GET" or reply.status != OK:
        return reply.status, headers, reply.body
    marked = {"etag": reply.mark, "cache-control": KEPT_BY_ASKERS, **edition_headers(edition)}
    known = Headers(scope=scope).get("if-none-match", "")
    if reply.mark in {mark.strip().removeprefix("W/") for mark in known.split(",")}:
        return NOT_MODIFIED, marked, b""
    return reply.status, headers | marked, reply.body
