"""How many plans a second foon serve answers, and how long each takes: new questions, and questions asked before.

    python benchmarks/serve.py [--files FOLDER] [--recipes PATH ...] [--every N] [--jobs N] [--clients N] [--again N]
                               [--writing SECONDS] [--idle SECONDS] [--arriving N ...]

Serves as foon serve does, on a free port, with its limits (but a rate that this one address may reach), and asks for
every N-th recipe beside the checkout over ``--clients`` kept connections, from a process of its own: once each; then
``--again`` times in all once more; then as often with what an earlier answer was marked by (``If-None-Match``).
Printed for each: questions, plans a second, median and 95 % time in ms, CPU ms a question of the processes that plan
and of the one that serves, statuses. The first line is what planning costs; the others what equal questions cost, which
are kept. CPU says on a busy machine what the seconds do not. 32 callers who each ask again at once wait for each other:
with ``--arriving`` the new questions come, instead, so many a second, whoever still waits, and each is timed from the
moment at which it should have been asked; a service begun anew for each of the rates has nothing kept. With
``--writing`` the FOON is that of Neo4j (NEO4J_URI,
else the local server, whose FOON is replaced by that of ``--files``), and a process of its own takes a video out and
brings it back, a change every so many seconds; how many changes there were while each line was measured is told.
``--idle`` waits so long before the first question, of each rate that is asked for, too: processes that nobody asks
plan recorded dishes meanwhile.
"""

import argparse
import http.client
import json
import socket
import statistics
import threading
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import active_children, get_context
from multiprocessing.sharedctypes import Synchronized
from pathlib import Path
from urllib.parse import urlencode

import psutil

from foon_kg import Foon
from foon_kg.loaders import read_paths
from foon_kg.planning.batch import cores
from foon_kg.planning.recipes import IngredientWords, read_recipe, recipe_files
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, load, remove
from foon_kg.store.server import connection_settings
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.api import web_app
from foon_kg.web.callers import Callers
from foon_kg.web.connections import server_of
from foon_kg.web.foon import FixedFoon, LiveFoon
from foon_kg.web.limits import Limits
from foon_kg.web.service import FoonService

SHARED = Path(__file__).parents[1].parent / "shared" / "data"
LIMITS = Limits(per_second=1e6, burst=1_000_000, waiting=64)

Asked = tuple[str, list[str]]
"""A dish type and ingredients."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=Path, default=SHARED / "foon-111" / "TXT")
    parser.add_argument("--recipes", nargs="+", type=Path, default=[SHARED / "queries", SHARED / "queries-more"])
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=cores())
    parser.add_argument("--clients", type=int, default=32)
    parser.add_argument("--again", type=int, default=5000)
    parser.add_argument("--writing", type=float)
    parser.add_argument("--arriving", type=float, nargs="*", default=[])
    parser.add_argument("--idle", type=float, default=0.0)
    options = parser.parse_args()
    read = read_paths([options.files])
    snapshot = Snapshot.of([result.subgraph for result in read if result.subgraph is not None], Kitchen.default())
    changes = get_context("spawn").Value("i", 0)
    writer = get_context("spawn").Process(target=write_on, args=(options.files, options.writing, changes), daemon=True)
    foon: FixedFoon | LiveFoon = FixedFoon(snapshot)
    if options.writing is not None:
        settings = connection_settings()
        with Connection(settings) as connection:
            load(connection, snapshot.subgraphs)
        foon = LiveFoon(lambda: Foon(server=settings))
    questions = questions_of(snapshot, list(recipe_files(options.recipes))[:: options.every])
    for rate in options.arriving:
        arriving(snapshot, questions, options, rate)
    if options.arriving:
        return
    service = FoonService(foon, processes=options.jobs, most=LIMITS.waiting)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as asking, served(service, asking) as port:

        def measure(asked: list[Asked], *, marked: bool = False) -> Measured:
            before, changed = cpu_seconds(), changes.value
            started = time.perf_counter()
            answers = asking.submit(ask_all, port, asked, options.clients, marked=marked).result()
            spent = [after - then for after, then in zip(cpu_seconds(), before, strict=True)]
            return Measured(time.perf_counter() - started, *spent, answers, changes.value - changed)

        measure([("", [f"chopped onion{' ' * n}", "egg"]) for n in range(2 * options.jobs)])  # each process has begun
        time.sleep(options.idle)
        if options.writing is not None:
            writer.start()
        show("new questions", measure(questions))
        repeated = [questions[n % len(questions)] for n in range(options.again)]
        show("asked before", measure(repeated))
        show("with its mark", measure(repeated, marked=True))
        if options.writing is not None:
            writer.kill()


@contextmanager
def served(service: FoonService, asking: ProcessPoolExecutor) -> Iterator[int]:
    """Serve ``service`` as foon serve does and yield its port; the process of ``asking`` has begun then."""
    asking.submit(time.time).result()  # before CPU is counted
    server = server_of(web_app(service, names={"127.0.0.1"}, limits=LIMITS), LIMITS, Callers())
    with socket.create_server(("127.0.0.1", 0)) as listener:
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]})
        thread.start()
        while not server.started:
            time.sleep(0.05)
        try:
            yield listener.getsockname()[1]
        finally:
            server.should_exit = True
            thread.join()


def arriving(snapshot: Snapshot, questions: list[Asked], options: argparse.Namespace, rate: float) -> None:
    """Ask a service of its own the questions, ``rate`` a second, and print how long each took."""
    service = FoonService(FixedFoon(snapshot), processes=options.jobs, most=10_000)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as asking, served(service, asking) as port:
        begun = [("", [f"chopped onion{' ' * n}", "egg"]) for n in range(2 * options.jobs)]
        asking.submit(ask_all, port, begun, options.clients, marked=False).result()
        time.sleep(options.idle)
        before, started = cpu_seconds(), time.perf_counter()
        answers = asking.submit(ask_as_they_come, port, questions, rate, options.clients).result()
        spent = [after - then for after, then in zip(cpu_seconds(), before, strict=True)]
        show(f"{rate:g} a second", Measured(time.perf_counter() - started, *spent, answers))


def ask_as_they_come(port: int, questions: list[Asked], rate: float, clients: int) -> list[tuple[int, float]]:
    """Ask the questions at their times, ``rate`` a second, each over a connection of its own."""
    begun = time.perf_counter() + 0.5

    def ask(number: int) -> tuple[int, float]:
        due = begun + number / rate
        time.sleep(max(0.0, due - time.perf_counter()))
        line = http.client.HTTPConnection("127.0.0.1", port, timeout=120)  # one that was idle may be closed
        body = json.dumps({"dish_type": questions[number][0], "ingredients": questions[number][1]})
        line.request("POST", "/api/plan", body, {"Content-Type": "application/json"})
        answer = line.getresponse()
        answer.read()
        line.close()
        return answer.status, time.perf_counter() - due

    with ThreadPoolExecutor(max(clients, 64)) as pool:  # a thread that sleeps is one that does not wait in line
        return list(pool.map(ask, range(len(questions))))


def write_on(folder: Path, seconds: float, changes: Synchronized) -> None:  # type: ignore[type-arg]
    """Take a video out of the FOON and bring it back, a change every so many ``seconds``, and count."""
    subgraphs = [result.subgraph for result in read_paths([folder]) if result.subgraph is not None]
    video = subgraphs[len(subgraphs) // 2]
    with Connection(connection_settings()) as connection:
        while True:
            for change in (lambda: remove(connection, [video.name]), lambda: load(connection, [video])):
                change()
                changes.value += 1
                time.sleep(seconds)


def questions_of(snapshot: Snapshot, paths: list[Path]) -> list[Asked]:
    words = IngredientWords(snapshot.vocabulary(), snapshot.kitchen)
    recipes = [read_recipe(path, words).recipe for path in paths]
    return [(recipe.dish_type, [f"{one.object}, {one.state}" for one in recipe.ingredients]) for recipe in recipes]


@dataclass(frozen=True)
class Measured:
    """The seconds that all questions took, the CPU seconds of planning and serving; of each its status and seconds."""

    seconds: float
    planning: float
    serving: float
    answers: list[tuple[int, float]]
    changes: int = 0
    """How often the FOON was written to meanwhile."""


def cpu_seconds() -> tuple[float, float]:
    """Return the CPU seconds of the processes that plan, and of this one; the one that asks is in neither."""
    own = psutil.Process()
    plan = [child.pid for child in active_children() if child.name == "foon-planning"]
    living = sum(sum(psutil.Process(pid).cpu_times()[:2]) for pid in plan if pid and psutil.pid_exists(pid))
    ended = sum(own.cpu_times()[2:4])
    return living + ended, sum(own.cpu_times()[:2])


def ask_all(port: int, questions: list[Asked], clients: int, *, marked: bool) -> list[tuple[int, float]]:
    """Ask all questions; ``marked``: with the marks of their answers, which were asked for before."""
    once = {path_of(asked): asked for asked in questions} if marked else {}
    marks = {path: mark_of(port, asked) for path, asked in once.items()}

    def some(first: int) -> Iterator[tuple[int, float]]:
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
        for asked in questions[first::clients]:
            started = time.perf_counter()
            if marked:
                connection.request("GET", path_of(asked), headers={"If-None-Match": marks[path_of(asked)]})
            else:
                body = json.dumps({"dish_type": asked[0], "ingredients": asked[1]})
                connection.request("POST", "/api/plan", body, {"Content-Type": "application/json"})
            answer = connection.getresponse()
            answer.read()
            yield answer.status, time.perf_counter() - started
        connection.close()

    with ThreadPoolExecutor(clients) as pool:
        return [one for answers in pool.map(lambda first: list(some(first)), range(clients)) for one in answers]


def path_of(asked: Asked) -> str:
    return "/api/plan?" + urlencode([("dish_type", asked[0]), *(("ingredient", one) for one in asked[1])])


def mark_of(port: int, asked: Asked) -> str:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
    connection.request("GET", path_of(asked))
    answer = connection.getresponse()
    answer.read()
    return answer.headers.get("ETag", "")


def show(name: str, measured: Measured) -> None:
    times = sorted(1000 * taken for _, taken in measured.answers)
    counts = Counter(status for status, _ in measured.answers)
    statuses = ", ".join(f"{status}: {count}" for status, count in sorted(counts.items()))
    changed = f", {measured.changes} changes" if measured.changes else ""
    print(
        f"{name:<14}{len(times):>6} questions{len(times) / measured.seconds:>8.1f} a second  median "
        f"{statistics.median(times):.0f} ms  95 % {times[int(len(times) * 0.95)]:.0f} ms  CPU "
        f"{1000 * measured.planning / len(times):.1f} + {1000 * measured.serving / len(times):.2f} ms  "
        f"({statuses}{changed})"
    )


if __name__ == "__main__":
    main()
