"""Stands between foon-kg and Neo4j and does harm to one message of Bolt, chosen by its number."""

from __future__ import annotations

import contextlib
import socket
import threading
from dataclasses import replace
from enum import IntEnum, StrEnum
from urllib.parse import urlsplit

HELLO_BYTES, PROPOSAL, TAG = 20, 4, 3
MANIFEST = bytes.fromhex("000001ff")
"""The proposal to agree on a version in more than one answer; without it one of four bytes says which it is."""


class Says(IntEnum):
    """Messages of a client by their tags."""

    BEGIN = 0x11
    RUN = 0x10
    COMMIT = 0x12


class Harm(StrEnum):
    """What happens to a message of the client."""

    LOST = "lost"
    TORN = "torn"
    """The server gets half of it."""
    UNANSWERED = "unanswered"
    """The server gets it and answers; the client gets nothing of that."""
    HALF_ANSWERED = "half answered"
    HELD = "held"
    """It waits until :meth:`BoltProxy.let_go`."""


class BoltProxy:
    """A Bolt server for one test: passes everything on to the one of ``settings`` but for one message.

    ``said`` has the tags of the messages of all clients since :meth:`strike`; ``struck`` is set once the harm is done.
    """

    def __init__(self, settings):
        there = urlsplit(settings.uri)
        self._server = there.hostname, there.port or 7687
        self._listener = socket.create_server(("127.0.0.1", 0))
        port = self._listener.getsockname()[1]
        self.settings = replace(settings, uri=f"bolt://127.0.0.1:{port}")
        self._turn = threading.Lock()
        self._number, self._harm = 0, Harm.LOST
        self.said = []
        self.struck, self._free = threading.Event(), threading.Event()
        self._sockets = []
        threading.Thread(target=self._accept, daemon=True).start()

    def strike(self, number, harm):
        """Count from here on, and do ``harm`` to the message of that number."""
        with self._turn:
            self._number, self._harm, self.said = number, harm, []
            self.struck.clear()
            self._free.clear()

    def let_go(self):
        """Let the message that is held go on its way."""
        self._free.set()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.let_go()
        _end(self._listener, *self._sockets)

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                client, _ = self._listener.accept()
                server = socket.create_connection(self._server)
                self._sockets += client, server
                one = _Connection(self, client, server)
                threading.Thread(target=one.to_server, daemon=True).start()
                threading.Thread(target=one.to_client, daemon=True).start()

    def harm_to(self, message):
        """Count a message; return what is done to it."""
        with self._turn:
            self.said.append(message[TAG])
            return self._harm if len(self.said) == self._number else None

    def wait(self):
        self.struck.set()
        self._free.wait()


class _Connection:
    def __init__(self, proxy, client, server):
        self.proxy, self.client, self.server = proxy, client, server
        self.answer = None

    def to_server(self):
        with contextlib.suppress(OSError, EOFError):
            hello = _exactly(self.client, HELLO_BYTES)
            asked = [hello[place : place + PROPOSAL] for place in range(0, HELLO_BYTES, PROPOSAL)]
            self.server.sendall(b"".join(bytes(PROPOSAL) if one == MANIFEST else one for one in asked))
            while self._pass_on(_message(self.client)):
                pass
        _end(self.client, self.server)

    def _pass_on(self, message):
        """Do what is to be done to a message; return whether there is a connection afterwards."""
        harm = self.proxy.harm_to(message)
        if harm is Harm.HELD:
            self.proxy.wait()
        if harm in {Harm.UNANSWERED, Harm.HALF_ANSWERED}:
            self.answer = harm
        if harm in {Harm.LOST, Harm.TORN}:
            self.server.sendall(message[: len(message) // 2] if harm is Harm.TORN else b"")
            self.proxy.struck.set()
            return False
        self.server.sendall(message)
        return True

    def to_client(self):
        with contextlib.suppress(OSError):
            while (answer := self.server.recv(65536)) and self.answer is None:
                self.client.sendall(answer)
            if self.answer is Harm.HALF_ANSWERED:
                self.client.sendall(answer[: len(answer) // 2])
        if self.answer is not None:
            self.proxy.struck.set()
        _end(self.client, self.server)


def _message(stream):
    """Read a message: chunks that each say their length, and an empty one."""
    parts = []
    while True:
        head = _exactly(stream, 2)
        size = int.from_bytes(head)
        parts += head, _exactly(stream, size)
        if not size and len(parts) > 2:
            return b"".join(parts)


def _exactly(stream, count):
    data = b""
    while len(data) < count:
        more = stream.recv(count - len(data))
        if not more:
            raise EOFError
        data += more
    return data


def _end(*sockets):
    for one in sockets:
        with contextlib.suppress(OSError):
            one.shutdown(socket.SHUT_RDWR)
        one.close()
