"""Neo4j is ended with kill -9 at each stage of a transaction: what was said to be stored is there, and nothing half."""

from __future__ import annotations

import threading

import pytest
from campaign.bolt_proxy import BoltProxy, Harm, Says
from campaign.whole_graph import whole_graph
from kitchen_stories import SALAD, subgraph
from server.conftest import place  # noqa: F401 - a home of its own
from server.live_server import kill, up

from foon_kg.model.errors import GraphError
from foon_kg.store.graph import Connection, load, remove

pytestmark = [pytest.mark.campaign, pytest.mark.slow, pytest.mark.xdist_group("local-server")]

BEFORE = (subgraph("first", "salad", *SALAD[:4]), subgraph("second", "soup", *SALAD[2:]))
WANTED = (subgraph("first", "salad", *SALAD), subgraph("third", "salad", *SALAD[3:]))
STAGES = {
    "the commit is not answered": (Says.COMMIT, Harm.UNANSWERED),
    "the commit does not arrive": (Says.COMMIT, Harm.HELD),
    "the transaction begins": (Says.BEGIN, Harm.UNANSWERED),
    "a statement does not arrive": (Says.RUN, Harm.HELD),
    "a statement is not answered": (Says.RUN, Harm.UNANSWERED),
}


def begin(settings):
    with Connection(settings) as connection:
        load(connection, BEFORE)
        with connection.session() as session:
            there = session.run("MATCH (v:Video) RETURN v.name").value()
        if gone := set(there) - {one.name for one in BEFORE}:
            remove(connection, gone)
        return whole_graph(connection)


def tried(settings, told):
    try:
        with Connection(settings) as connection:
            load(connection, WANTED)
        told.append("stored")
    except GraphError as error:
        told.append(error.code)


@pytest.mark.parametrize("stage", STAGES)
def test_the_graph_is_as_before_or_as_after(place, stage):  # noqa: F811 - the fixture
    tag, harm = STAGES[stage]
    settings = up()
    begin(settings)
    with BoltProxy(settings) as wire:
        wire.strike(0, harm)
        tried(wire.settings, told := [])
        assert told == ["stored"]
        numbers = [place for place, said in enumerate(wire.said, 1) if said == tag]
        number = numbers[len(numbers) // 2] if tag is Says.RUN else numbers[-1]
        with Connection(settings) as connection:
            after = whole_graph(connection)
        before = begin(settings)
        wire.strike(number, harm)
        doing = threading.Thread(target=tried, args=(wire.settings, told := []))
        doing.start()
        assert wire.struck.wait(120)
        kill(place.recall().pid)
        settings = up()
        with Connection(settings) as connection:
            found = whole_graph(connection)  # while whoever loads may try once more
        wire.let_go()
        doing.join(120)
        assert not doing.is_alive()
    assert found in (before, after)
    if stage == "the commit is not answered":
        assert found == after  # Neo4j had said that it was stored
    with Connection(up()) as connection:
        assert whole_graph(connection) == after or told != ["stored"]
        load(connection, WANTED)
        assert whole_graph(connection) == after
