"""A cluster whose behaviour is scripted, as the testkit of the drivers does it: real answers, told by one real Neo4j.

Each member is a Bolt server that answers for routing itself, refuses what its role refuses, loses its connection or is
behind where a test says so, and has everything else answered by the real server. It speaks Bolt 5.4.
"""

from __future__ import annotations

import contextlib
import socket
import threading
from collections import Counter
from dataclasses import replace
from queue import SimpleQueue
from urllib.parse import urlsplit

from campaign.bolt_proxy import _end, _exactly, _message
from neo4j._codec.packstream.v1 import PackableBuffer, Packer, UnpackableBuffer, Unpacker

BEGIN, RUN, COMMIT, ROLLBACK, RESET, ROUTE, GOODBYE = 0x11, 0x10, 0x12, 0x13, 0x0F, 0x66, 0x02
SUCCESS, IGNORED, FAILURE = 0x70, 0x7E, 0x7F
SUMMARIES = {SUCCESS, IGNORED, FAILURE}
MAGIC, BOLT_5_4 = bytes.fromhex("6060b017"), bytes.fromhex("00000405")
NOT_A_LEADER = "Neo.ClientError.Cluster.NotALeader"
NOT_CAUGHT_UP = "Neo.TransientError.Transaction.BookmarkTimeout"
HELD = 60
"""Seconds after which a server lets go of who waits for it: only a test that fails gets there."""


class ScriptedCluster:
    """A cluster before the real server of ``settings``; its own ``settings`` name its first member.

    ``leader`` may be ``None``. ``begun`` has, for each transaction, the member, whether it only reads, and whether it
    asks for what was written: a member in ``behind`` that is asked for it waits for :meth:`catch_up`, and one in
    ``stuck`` says that it never gets it. ``loses`` is called with the member, the kind of a message that belongs to a
    writing transaction, and how many of its kind there were, before the server gets it: it returns whether the
    connection is lost instead.
    """

    def __init__(self, settings, members=3):
        there = urlsplit(settings.uri)
        self.server = there.hostname, there.port or 7687
        self.members = [Member(self, number) for number in range(members)]
        self.settings = replace(settings, uri=f"neo4j://{self.members[0].address}")
        self.leader = self.members[0]
        self.behind, self.stuck = set(), set()
        self.begun = SimpleQueue()
        self.written = set()
        self.counts = Counter()
        self.loses = lambda _member, _kind, _number: False
        self._caught_up = threading.Event()

    def catch_up(self):
        """Let all members have what was written."""
        self._caught_up.set()

    def wait(self):
        self._caught_up.wait(HELD)

    def told(self):
        """Return all that was begun since the last time."""
        return [self.begun.get() for _ in range(self.begun.qsize())]

    def table(self):
        """Return what a member answers who asks for the way."""
        every = [member.address for member in self.members]
        readers = [member.address for member in self.members if member is not self.leader] or every
        servers = [{"role": "ROUTE", "addresses": every}, {"role": "READ", "addresses": readers}]
        writers = [] if self.leader is None else [self.leader.address]
        return {"ttl": 300, "db": "neo4j", "servers": [*servers, {"role": "WRITE", "addresses": writers}]}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.catch_up()
        for member in self.members:
            member.end()


class Member:
    """One server of the cluster."""

    def __init__(self, cluster, number):
        self.cluster, self.number = cluster, number
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"127.0.0.1:{self._listener.getsockname()[1]}"
        self._sockets = []
        threading.Thread(target=self._accept, daemon=True).start()

    def __repr__(self):
        return f"member {self.number}"

    def end(self):
        _end(self._listener, *self._sockets)

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                client, _ = self._listener.accept()
                server = socket.create_connection(self.cluster.server)
                self._sockets += client, server
                threading.Thread(target=_Conversation(self, client, server).go_on, daemon=True).start()


class _Conversation:
    """One connection of a driver: each message is answered whole before the next is looked at."""

    def __init__(self, member, client, server):
        self.member, self.cluster = member, member.cluster
        self.client, self.server = client, server
        self.failed = self.reading = False
        self.in_transaction = False

    def go_on(self):
        with contextlib.suppress(OSError, EOFError):
            _exactly(self.client, 20)
            self.server.sendall(MAGIC + BOLT_5_4 + bytes(12))
            self.client.sendall(_exactly(self.server, 4))
            while self._answer(_message(self.client)):
                pass
        _end(self.client, self.server)

    def _answer(self, message):
        """Answer a message of the driver; return whether the connection goes on."""
        tag, fields = _unpacked(message)
        if self.failed and tag not in {RESET, GOODBYE}:
            self._say(IGNORED)
            return True
        if tag == ROUTE:
            self._say(SUCCESS, {"rt": self.cluster.table()})
            return True
        if tag == BEGIN or (tag == RUN and not self.in_transaction):
            if not self._begin(fields[-1]):
                return True
            self.in_transaction = tag == BEGIN
        if not self.reading and self._is_lost(tag):
            return False
        told = self._pass_on(message, tag)
        if tag == COMMIT and not self.reading and "bookmark" in told:
            self.cluster.written = {told["bookmark"]}
        self.in_transaction = self.in_transaction and tag not in {COMMIT, ROLLBACK, RESET}
        self.failed = self.failed and tag != RESET
        return tag != GOODBYE

    def _begin(self, extra):
        """Note what is begun, and wait for what was written; return whether this member does it."""
        self.reading = extra.get("mode") == "r"
        behind = self.member in self.cluster.behind
        waits = bool(self.cluster.written & set(extra.get("bookmarks", ())))
        self.cluster.begun.put((self.member, self.reading, waits))
        if not self.reading and self.member is not self.cluster.leader:
            return self._refuse(NOT_A_LEADER, "is a follower")
        if waits and self.member in self.cluster.stuck:
            return self._refuse(NOT_CAUGHT_UP, "is not up to the requested version")
        if behind and waits:
            self.cluster.wait()
        return True

    def _refuse(self, code, why):
        self.failed = True
        self._say(FAILURE, {"code": code, "message": f"{self.member} {why}"})
        return False

    def _is_lost(self, tag):
        if not self.in_transaction:
            return False
        self.cluster.counts[tag] += 1
        return self.cluster.loses(self.member, tag, self.cluster.counts[tag])

    def _pass_on(self, message, tag):
        """Have the server answer; return what it says of it."""
        self.server.sendall(message)
        while tag != GOODBYE:
            answer = _message(self.server)
            said, fields = _unpacked(answer)
            if said == FAILURE:
                self.failed = True
            self.client.sendall(answer)
            if said in SUMMARIES:
                return fields[0] if fields else {}
        return {}

    def _say(self, tag, *fields):
        buffer = PackableBuffer()
        Packer(buffer).pack_struct(bytes([tag]), list(fields))
        body = bytes(buffer.data)
        self.client.sendall(len(body).to_bytes(2) + body + bytes(2))


def _unpacked(message):
    """Return the tag and the fields of a message of Bolt."""
    body, place = bytearray(), 0
    while size := int.from_bytes(message[place : place + 2]):
        body += message[place + 2 : place + 2 + size]
        place += 2 + size
    unpacker = Unpacker(UnpackableBuffer(body))
    count, tag = unpacker.unpack_structure_header()
    tag = tag[0]
    looked_at = {BEGIN, RUN, SUCCESS}
    return tag, [unpacker.unpack() for _ in range(count)] if tag in looked_at else []
