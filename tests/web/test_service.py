"""The service answers from the FOON as it stands now, once for equal questions, and outlives its processes."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from concurrent.futures import CancelledError, ThreadPoolExecutor

import psutil
import pytest
from pictures.demo_plans import demo_foon

from foon_kg import Foon
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.model.errors import GraphError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.foon import FixedFoon, LiveFoon, Served
from foon_kg.web.questions import BusyError, InternalError, PlanQuestion, TooLongError, UnknownError
from foon_kg.web.service import FoonService

SALAD = PlanQuestion("salad", ("sliced kohlrabi", "chopped onion"))
ONIONS = PlanQuestion("salad", ("chopped onion",))
TOMATOES = PlanQuestion("salad", ("diced tomato",))


def answered(service, question):
    try:
        return service.answer(question)
    except BusyError:
        return None


class GrowingFoon:
    """A FOON of the first ``count`` videos of the demo, which the test changes."""

    def __init__(self, count):
        self.count = count

    def grow(self, count):
        self.count = count

    def edition(self):
        return str(self.count)

    def read(self):
        videos = sorted(demo_subgraphs(), key=lambda s: s.name)[: self.count]
        return Served(self.edition(), Snapshot.of(videos, Kitchen.default()))

    def fresh(self):
        return self.edition()

    def close(self):
        """Nothing is open."""


def test_equal_questions_are_answered_once():
    with FoonService(FixedFoon(demo_foon())) as service:
        first = service.ask(SALAD)
        assert service.ask(PlanQuestion("salad", ("sliced kohlrabi", "chopped onion"))) is first
        assert service.ask(PlanQuestion("salad", ("chopped onion", "sliced kohlrabi"))) is not first


def test_a_new_edition_is_answered_from_at_once():
    foon = GrowingFoon(2)
    with FoonService(foon, patience=60, pause=0) as service:
        assert service.summary()["videos"] == 2
        with pytest.raises(UnknownError):
            service.around("watermelon slice that nobody has")
        kept = service.ask(SALAD)
        foon.grow(23)
        assert service.summary()["videos"] == 23
        assert service.ask(SALAD) is not kept
        assert service.answer(SALAD).status == 200


class HeldFoon:
    """A FOON whose graph changes when the test says, and is read only when the test lets it."""

    def __init__(self, videos):
        self.videos = videos
        self.let = threading.Event()
        self.let.set()
        self.begun = threading.Event()
        self.trouble = None

    def edition(self):
        return f"with {self.videos}"

    def read(self):
        self.begun.set()
        assert self.let.wait(60)
        if self.trouble:
            raise self.trouble
        return Served(self.edition(), GrowingFoon(self.videos).read().snapshot)

    def close(self):
        """Nothing is open."""


def test_while_a_new_edition_is_read_the_one_before_answers_and_says_so():
    foon = HeldFoon(2)
    with FoonService(foon, patience=0) as service:
        assert (service.current().name, service.current().newer) == ("with 2", None)
        foon.begun.clear()
        foon.let.clear()
        foon.videos = 23
        with ThreadPoolExecutor(4) as pool:  # nobody waits, however many ask
            told = list(pool.map(lambda _: (service.current().name, service.current().newer), range(8)))
        assert told == [("with 2", "with 23")] * 8
        assert service.summary()["videos"] == 2
        assert service.answer(SALAD).status in {200, 404}
        assert foon.begun.wait(60)
        reading = service.reading
        foon.let.set()
        assert reading.result(60).name == "with 23"
        assert (service.current().name, service.current().newer) == ("with 23", None)
        assert service.summary()["videos"] == 23


def test_only_who_asks_after_a_pause_waits_for_a_new_edition():
    foon = HeldFoon(2)
    with FoonService(foon, patience=60, pause=3600) as service:
        assert service.current().name == "with 2"
        foon.let.clear()
        foon.videos = 3
        assert (service.current().name, service.current().newer) == ("with 2", "with 3")
        foon.let.set()
    with FoonService(foon, patience=60, pause=0) as service:
        assert service.current().name == "with 3"
        foon.videos = 4
        assert (service.current().name, service.current().newer) == ("with 4", None)


def test_an_edition_that_cannot_be_read_is_tried_again():
    foon = HeldFoon(2)
    with FoonService(foon, patience=60, pause=0) as service:
        service.summary()
        foon.videos, foon.trouble = 3, GraphError("the graph was emptied")
        for _ in range(2):
            with pytest.raises(GraphError, match="emptied"):
                service.summary()
        foon.trouble = None
        assert service.summary()["videos"] == 3


@pytest.mark.slow
def test_a_service_that_ends_while_it_reads_leaves_no_process():
    foon = HeldFoon(2)
    service = FoonService(foon, processes=1, patience=0)
    service.summary()
    foon.let.clear()
    foon.videos = 3
    service.summary()
    reading = service.reading
    foon.let.set()
    service.close()
    assert reading.done()
    assert not multiprocessing.active_children()


@pytest.mark.skipif("forkserver" not in multiprocessing.get_all_start_methods(), reason="processes are not copied here")
def test_the_processes_of_all_editions_are_copies_of_one():
    foon = GrowingFoon(2)
    parents = set()
    with FoonService(foon, processes=2, patience=60) as service:
        for count in (2, 3):
            foon.grow(count)
            service.summary()
            parents |= {psutil.Process(child.pid).ppid() for child in multiprocessing.active_children()}
    assert len(parents) == 1
    assert os.getpid() not in parents


@pytest.mark.slow
def test_a_table_that_the_environment_names_later_is_one_of_new_processes(tmp_path, monkeypatch):
    own = tmp_path / "own.toml"
    own.write_text('[kinds.cheese]\nwords = ["grevé"]\n', encoding="utf-8")
    named = []
    for path in ("", str(own), ""):
        monkeypatch.setenv("FOON_KG_FOODS", path)
        with FoonService(FixedFoon(demo_foon()), processes=1, seconds=120) as service:
            assert service.answer(ONIONS).status in {200, 404}
            planning = psutil.Process(desk_of(service)._process.pid)
            named.append((planning.environ().get("FOON_KG_FOODS", ""), planning.ppid() == os.getpid()))
    assert named[1] == (str(own), True)
    assert named[0] == named[2]


def test_many_threads_get_the_same_answers():
    questions = [PlanQuestion("salad", (f"{state} onion",)) for state in ("chopped", "sliced", "diced")] * 4
    with FoonService(FixedFoon(demo_foon())) as service, ThreadPoolExecutor(8) as pool:
        bodies = list(pool.map(lambda question: service.answer(question).body, questions))
        words = list(pool.map(lambda text: service.complete("ingredient", text, 5), ["chopped on"] * 20))
    assert bodies == bodies[:3] * 4
    assert all(found == words[0] for found in words)


@pytest.fixture(scope="module")
def outside():
    """A service with one process that plans."""
    with FoonService(FixedFoon(demo_foon()), processes=1, seconds=120) as service:
        yield service


def desk_of(service):
    (desk,) = service.current().workers._desks
    return desk


@pytest.mark.slow
def test_a_process_answers_as_a_thread_does_and_is_begun_anew_when_ended(outside):
    with FoonService(FixedFoon(demo_foon())) as inside:
        assert outside.answer(SALAD).body == inside.answer(SALAD).body
        desk_of(outside)._process.kill()
        answers = [answered(outside, ONIONS) for _ in range(2)]  # the first may still go to the process that ended
        assert answers[-1].body == inside.answer(ONIONS).body


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="it stops a process as only POSIX can")
def test_a_process_that_never_answers_is_replaced(outside, monkeypatch):
    outside.answer(SALAD)
    desk = desk_of(outside)
    hung = desk._process
    os.kill(hung.pid, signal.SIGSTOP)
    with monkeypatch.context() as patch:
        patch.setattr(desk, "_seconds", 0.2)
        with pytest.raises(TooLongError, match=r"no answer within 0\.2 seconds"):
            outside.answer(TOMATOES)
    assert hung.exitcode == -signal.SIGKILL
    assert outside.answer(TOMATOES).status == 200
    assert desk._process.pid != hung.pid


def test_a_process_that_fails_is_told_as_an_error_of_the_service_and_replaced(outside):
    with pytest.raises(InternalError):
        outside.answer("no question at all")
    assert outside.answer(PlanQuestion("salad", ("sliced onion",))).status == 200


@pytest.mark.slow
def test_the_process_of_an_edition_ends_when_what_it_was_asked_is_answered():
    foon = GrowingFoon(2)
    with FoonService(foon, processes=1, patience=60, pause=0) as service:
        asked, before = service.ask(SALAD), psutil.Process(desk_of(service)._process.pid)
        foon.grow(3)
        assert service.answer(ONIONS).status in {200, 404}
        assert asked.result().status in {200, 404}
        assert psutil.wait_procs([before], 120)[1] == []  # whoever collects it: the service waits for it too
        assert desk_of(service)._process.is_alive()


def test_a_plan_under_way_is_given_up_when_the_service_ends():
    service = FoonService(FixedFoon(demo_foon()), processes=1)
    process = desk_of(service)._process
    future = service.ask(SALAD)
    service.close()
    with pytest.raises((BusyError, CancelledError)):
        future.result()
    assert not process.is_alive()


@pytest.mark.neo4j
def test_a_graph_that_somebody_changes_is_read_anew(empty_graph):
    from foon_kg.store.graph import Connection, load

    subgraphs = sorted(demo_subgraphs(), key=lambda subgraph: subgraph.name)
    with (
        Connection(empty_graph) as connection,
        FoonService(LiveFoon(lambda: Foon(server=empty_graph), every=0), patience=60, pause=0) as service,
    ):
        assert service.summary()["videos"] == 0
        assert service.ask(SALAD).result().status == 404
        load(connection, subgraphs[:2])
        assert service.summary()["videos"] == 2
        kept = service.ask(SALAD)
        assert service.ask(SALAD) is kept
        load(connection, subgraphs[2:4])
        assert service.summary()["videos"] == 4
        assert service.ask(SALAD) is not kept
