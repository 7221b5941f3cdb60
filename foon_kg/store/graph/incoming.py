"""How much of an answer may come over the wire: the driver reads a row whole, however large, before anybody sees it."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import neo4j


class TooMuchCameError(OSError):
    """More bytes of an answer came than were to come; the connection is given up."""


def _is_unexpected(record: logging.LogRecord) -> bool:
    """Say whether something that the driver logs is not what was done on purpose here."""
    return "TooMuchCameError" not in record.getMessage()


logging.getLogger("neo4j.io").addFilter(_is_unexpected)


class _CountedSocket:
    """The socket of a connection, from which only so much more is read."""

    def __init__(self, socket: Any, most: int) -> None:  # noqa: ANN401 - the driver's own class
        self._socket = socket
        self._left = most

    def recv_into(self, buffer: memoryview, nbytes: int) -> int:
        """Read into ``buffer`` and return how many bytes; raises TooMuchCameError."""
        read: int = self._socket.recv_into(buffer, nbytes)
        self._left -= read
        if self._left < 0:
            raise TooMuchCameError
        return read

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401 - whatever else the driver asks of its socket
        return getattr(self._socket, name)


@contextmanager
def bound(session: neo4j.Session, most: int) -> Iterator[None]:
    """Let at most ``most`` bytes more come to a session that has just asked something and got no row yet.

    Beyond that the driver loses the connection for it, and raises an error that comes of a TooMuchCameError
    (:func:`too_much_came`). The driver has no public way to this; where another version is built otherwise nothing is
    bound here, and a test fails.
    """
    inbox = getattr(getattr(session, "_connection", None), "inbox", None)
    socket = getattr(inbox, "_socket", None)
    if inbox is None or not hasattr(socket, "recv_into"):
        yield
        return
    inbox._socket = _CountedSocket(socket, most)  # noqa: SLF001 - see above
    try:
        yield
    finally:
        inbox._socket = socket  # noqa: SLF001 - the connection is used again


def too_much_came(error: BaseException | None) -> bool:
    """Say whether an error of the driver comes of too much having come."""
    while error is not None:
        if isinstance(error, TooMuchCameError):
            return True
        error = error.__cause__ or error.__context__
    return False
