"""The service answers from the FOON as it stands now, once for equal questions, and outlives its processes."""

from __future__ import annotations

import os
import signal
from concurrent.futures import ThreadPoolExecutor

import pytest
from pictures.demo_plans import demo_foon

from foon_kg.cli.demo import demo_subgraphs
from foon_kg.kitchen import Kitchen
from foon_kg.snapshot import Snapshot
from foon_kg.web.foon import FixedFoon, LiveFoon, Served
from foon_kg.web.questions import PlanQuestion, UnknownError
from foon_kg.web.service import FoonService
from foon_kg.web.workers import BusyError

SALAD = PlanQuestion("salad", ("sliced kohlrabi", "chopped onion"))


def answered(service, question):
    try:
        return service.answer(question)
    except BusyError:
        return None


class GrowingFoon:
    """A FOON of the first ``count`` videos of the demo, which the test changes."""

    def __init__(self, count):
        self.count = count
        self.edition = 0

    def grow(self, count):
        self.count, self.edition = count, self.edition + 1

    def current(self):
        return Served(
            self.edition, Snapshot.of(sorted(demo_subgraphs(), key=lambda s: s.name)[: self.count], Kitchen.default())
        )

    def close(self):
        """Nothing is open."""


def test_equal_questions_are_answered_once():
    with FoonService(FixedFoon(demo_foon())) as service:
        first = service.ask(SALAD)
        assert service.ask(PlanQuestion("salad", ("sliced kohlrabi", "chopped onion"))) is first
        assert service.ask(PlanQuestion("salad", ("chopped onion", "sliced kohlrabi"))) is not first


def test_a_new_edition_is_answered_from_at_once():
    foon = GrowingFoon(2)
    with FoonService(foon) as service:
        assert service.summary()["videos"] == 2
        with pytest.raises(UnknownError):
            service.around("watermelon slice that nobody has")
        kept = service.ask(SALAD)
        foon.grow(23)
        assert service.summary()["videos"] == 23
        assert service.ask(SALAD) is not kept
        assert service.answer(SALAD).status == 200


def test_many_threads_get_the_same_answers():
    questions = [PlanQuestion("salad", (f"{state} onion",)) for state in ("chopped", "sliced", "diced")] * 4
    with FoonService(FixedFoon(demo_foon())) as service, ThreadPoolExecutor(8) as pool:
        bodies = list(pool.map(lambda question: service.answer(question).body, questions))
        words = list(pool.map(lambda text: service.complete("ingredient", text, 5), ["chopped on"] * 20))
    assert bodies == bodies[:3] * 4
    assert all(found == words[0] for found in words)


def test_processes_answer_as_a_thread_does_and_are_begun_anew_when_ended():
    with FoonService(FixedFoon(demo_foon())) as inside, FoonService(FixedFoon(demo_foon()), processes=1) as outside:
        assert outside.answer(SALAD).body == inside.answer(SALAD).body
        (process,) = outside._edition.workers._executor._processes.values()
        os.kill(process.pid, signal.SIGKILL)
        process.join()
        other = PlanQuestion("salad", ("chopped onion",))
        answers = [answered(outside, other) for _ in range(2)]  # the first may still go to the process that ended
        assert answers[-1].body == inside.answer(other).body


@pytest.mark.neo4j
def test_a_graph_that_somebody_changes_is_read_anew(empty_graph):
    from foon_kg.graph import Connection, Neo4jGraph, load

    subgraphs = sorted(demo_subgraphs(), key=lambda subgraph: subgraph.name)
    with Connection(empty_graph) as connection:
        load(connection, subgraphs[:2])
        with FoonService(LiveFoon(lambda: Neo4jGraph(empty_graph), every=0)) as service:
            assert service.summary()["videos"] == 2
            kept = service.ask(SALAD)
            assert service.ask(SALAD) is kept
            load(connection, subgraphs[2:4])
            assert service.summary()["videos"] == 4
            assert service.ask(SALAD) is not kept
