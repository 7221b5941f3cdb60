"""Who may ask, and what a browser may do with the answers: hosts, origins, the token, headers; as ASGI middleware."""

from __future__ import annotations

import ipaddress
import os
import re
import secrets
import socket
import stat
from collections.abc import Collection
from pathlib import Path

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from foon_kg.model.errors import FoonError, UsageError
from foon_kg.model.regular_files import open_regular
from foon_kg.web.limits import refuse

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), geolocation=(), microphone=()",
    "cache-control": "no-store",
}

_OTHER_NAME = FoonError(
    "this service has another name",
    hint="Use the address that foon serve printed; behind a proxy, start it with --name NAME.",
    code="host",
)
_OTHER_SITE = FoonError(
    "another site's page may not ask here", hint="Open the service's own page, or ask from a program.", code="origin"
)
_NO_TOKEN = FoonError(
    "the token is missing or wrong",
    hint="Send Authorization: Bearer TOKEN, with what is in the token file.",
    code="token",
)
_SHORTEST = 16
"""Letters: a token of fewer could be guessed, at 50 requests a second."""
_NAME = re.compile(r"(?=.{1,253}$)[a-z0-9]([a-z0-9-]{0,61}[a-z0-9])?(\.[a-z0-9]([a-z0-9-]{0,61}[a-z0-9])?)*")


class SecurityHeaders:
    """Sends :data:`HEADERS` with every answer."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on."""

        async def sent(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
            await send(message)

        await self.app(scope, receive, sent)


class KnownHosts:
    """Refuses requests under another name than the machine's (DNS rebinding), and those that other sites' pages send.

    Addresses are always fine: to rebind one needs a name. A page may ask under the name and port that it came from, and
    from the ``public`` names under any port: a proxy has another than this service.
    """

    def __init__(self, app: ASGIApp, names: Collection[str], public: Collection[str] = ()) -> None:
        self.app = app
        self.public = frozenset(name.lower() for name in public)
        self.names = frozenset(name.lower() for name in names) | self.public

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or refuse it."""
        if scope["type"] == "http":
            headers = Headers(scope=scope)
            host = headers.get("host", "")
            if not self.knows(host):
                return await refuse(scope, send, 421, _OTHER_NAME)
            origin = headers.get("origin")
            if origin is not None and not self._is_own(origin, host):
                return await refuse(scope, send, 403, _OTHER_SITE)
        return await self.app(scope, receive, send)

    def knows(self, host: str) -> bool:
        """Whether the service answers under ``host`` (with or without its port)."""
        name = _name_of(host)
        return name in self.names or _is_address(name)

    def _is_own(self, origin: str, host: str) -> bool:
        scheme, _, asker = origin.partition("://")
        return scheme in {"http", "https"} and (asker.lower() == host.lower() or _name_of(asker) in self.public)


GUARDED, OPEN = ("/api/", "/metrics/"), "/api/docs/"
"""What asks for the token, and what of it does not."""


class TokenRequired:
    """Refuses (401) what asks below ``/api``, or for what was counted, without the token.

    The pages themselves hold nothing and may be seen, the one that describes the API too.
    """

    def __init__(self, app: ASGIApp, token: str) -> None:
        self.app = app
        self.expected = f"Bearer {token}".encode()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or refuse it."""
        path = f"{scope['path']}/" if scope["type"] == "http" else ""
        if path.startswith(GUARDED) and path != OPEN:
            given = Headers(scope=scope).get("authorization", "").encode()
            if not secrets.compare_digest(given, self.expected):
                return await refuse(scope, send, 401, _NO_TOKEN, {"www-authenticate": "Bearer"})
        return await self.app(scope, receive, send)


def is_loopback(host: str) -> bool:
    """Whether only programs on this machine can reach what binds to ``host``."""
    if host.lower() == "localhost":
        return True
    return _is_address(host) and ipaddress.ip_address(host).is_loopback


def own_names(host: str) -> frozenset[str]:
    """Return the names under which a service that binds to ``host`` answers."""
    machine = set() if is_loopback(host) else {socket.gethostname(), socket.getfqdn()}
    return frozenset({"localhost", host, *machine})


def public_name(text: str) -> str:
    """Return the name ``text`` under which a proxy serves this.

    Raises UsageError where it is more or less than a name.
    """
    name = text.rstrip(".").lower()
    if not _NAME.fullmatch(name) or _is_address(name):
        raise UsageError(f"“{text}” is no host name", hint="Give the name alone: --name kitchen.example.org")
    return name


def token_from(path: Path) -> str:
    """Return the token in ``path``, made where there is none yet; raises UsageError for one that others can read."""
    try:
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    except FileExistsError:
        return _read_token(path)
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror}", hint="Name a file in a folder of yours.") from error
    with os.fdopen(descriptor, "w", encoding="utf-8") as file:
        token = secrets.token_urlsafe(32)
        file.write(token + "\n")
    return token


def _read_token(path: Path) -> str:
    try:
        with open_regular(path) as file:
            mode = os.fstat(file.fileno()).st_mode
            token = file.read(4096).decode().strip()
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"{path} cannot be read as a token", hint="Name another file; it is made.") from error
    if os.name == "posix" and stat.S_IMODE(mode) & 0o077:
        raise UsageError(f"others can read the token in {path}", hint=f"Run: chmod 600 {path}")
    if len(token) < _SHORTEST or not token.isascii() or any(c.isspace() for c in token):
        raise UsageError(
            f"the token in {path} is not one word of {_SHORTEST} letters or more",
            hint="Remove the file: another is made.",
        )
    return token


def _name_of(host: str) -> str:
    """Return ``host`` without its port, in small letters."""
    name = host.partition("]")[0].removeprefix("[") if host.startswith("[") else host.partition(":")[0]
    return name.lower()


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
