"""A disk that gets full under a running Neo4j: what is the matter is told, with what helps, and that does help."""

from __future__ import annotations

import resource

import psutil
import pytest
from demo_foon import demo_subgraphs
from kitchen_stories import SALAD, subgraph
from server.live_server import up

from foon_kg.model.errors import GraphError
from foon_kg.store.doctor import Level, examine
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.server import stop

pytestmark = [
    pytest.mark.campaign,
    pytest.mark.slow,
    pytest.mark.xdist_group("local-server"),
    pytest.mark.skipif(not hasattr(psutil.Process, "rlimit"), reason="no process can be kept from writing here"),
]

UNLIMITED = (resource.RLIM_INFINITY, resource.RLIM_INFINITY)
BEFORE = subgraph("first", "salad", *SALAD[:4])
MORE = demo_subgraphs()
SOME_ROOM = 20_000
"""Bytes, fewer than a load of MORE writes: it is torn off in the middle."""


def names(settings):
    with Neo4jGraph(settings) as graph:
        return {one.name for one in graph.snapshot().subgraphs}


def test_a_full_disk_is_told_with_its_remedy_and_nothing_is_lost(place, monkeypatch):
    settings = up()
    with Connection(settings) as connection:
        load(connection, [BEFORE])
    server = psutil.Process(place.recall().pid)
    log = max(path.stat().st_size for path in (place.root / "data" / "transactions" / "neo4j").iterdir())
    server.rlimit(psutil.RLIMIT_FSIZE, (log + SOME_ROOM, resource.RLIM_INFINITY))
    with Connection(settings) as connection:
        for _ in range(2):  # what fails first, and whoever asks afterwards
            with pytest.raises(GraphError, match="could not write to its disk") as told:
                load(connection, MORE)
            assert told.value.code == "broken"
            assert "foon server stop" in told.value.hint
        server.rlimit(psutil.RLIMIT_FSIZE, UNLIMITED)  # there is room again, and somebody goes on asking
        with pytest.raises(GraphError, match="could not write to its disk"):
            load(connection, MORE)
    faults = [one for one in examine() if one.level is Level.FAULT]
    assert [one.subject for one in faults] == ["Neo4j"]
    assert "foon server stop" in faults[0].remedy
    stop()
    settings = up()
    assert names(settings) == {"first"}
    with Connection(settings) as connection:
        load(connection, MORE)
    assert names(settings) == {"first", *(one.name for one in MORE)}
