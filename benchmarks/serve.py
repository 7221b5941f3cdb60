"""How many plans a second foon serve answers, and how long each takes: new questions, and questions asked before.

    python benchmarks/serve.py [--files FOLDER] [--recipes PATH ...] [--every N] [--jobs N] [--clients N] [--again N]

Starts foon serve on a free port with its own limits (but a rate that this one address may reach), asks for every N-th
recipe beside the checkout from ``--clients`` threads over kept connections, once each, then ``--again`` times in all
once more. Printed for either: questions, plans a second, median and 95 % time in ms, CPU ms a question of the processes
that plan and of the one that serves (which has these clients in it), statuses. The first line is what planning costs;
the second what equal questions cost, which are kept.
"""

import argparse
import statistics
import threading
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import httpx
import psutil
import uvicorn

from foon_kg.loaders import read_paths
from foon_kg.planning.batch import cores
from foon_kg.planning.recipes import IngredientWords, read_recipe, recipe_files
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.api import web_app
from foon_kg.web.foon import FixedFoon
from foon_kg.web.limits import Limits
from foon_kg.web.service import FoonService

SHARED = Path(__file__).parents[1].parent / "shared" / "data"
LIMITS = Limits(per_second=1e6, burst=1_000_000)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=Path, default=SHARED / "foon-111" / "TXT")
    parser.add_argument("--recipes", nargs="+", type=Path, default=[SHARED / "queries"])
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=cores())
    parser.add_argument("--clients", type=int, default=4)
    parser.add_argument("--again", type=int, default=1000)
    options = parser.parse_args()
    read = read_paths([options.files])
    snapshot = Snapshot.of([result.subgraph for result in read if result.subgraph is not None], Kitchen.default())
    questions = questions_of(snapshot, list(recipe_files(options.recipes))[:: options.every])
    service = FoonService(FixedFoon(snapshot), processes=options.jobs, most=LIMITS.waiting)
    server = uvicorn.Server(
        uvicorn.Config(web_app(service, names={"127.0.0.1"}, limits=LIMITS), port=0, log_level="error")
    )
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        time.sleep(0.05)
    address = f"http://127.0.0.1:{server.servers[0].sockets[0].getsockname()[1]}"
    warm = [{"dish_type": "", "ingredients": [f"chopped onion{' ' * n}", "egg"]} for n in range(2 * options.jobs)]
    measure(address, warm, options.clients)  # each process has begun
    show("new questions", measure(address, questions, options.clients))
    repeated = [questions[n % len(questions)] for n in range(options.again)]
    show("asked before", measure(address, repeated, options.clients))
    server.should_exit = True
    thread.join()


def questions_of(snapshot: Snapshot, paths: list[Path]) -> list[dict[str, object]]:
    words = IngredientWords(snapshot.vocabulary(), snapshot.kitchen)
    recipes = [read_recipe(path, words).recipe for path in paths]
    return [
        {"dish_type": recipe.dish_type, "ingredients": [f"{one.object}, {one.state}" for one in recipe.ingredients]}
        for recipe in recipes
    ]


@dataclass(frozen=True)
class Measured:
    """The seconds that all questions took, the CPU seconds of planning and serving; of each its status and seconds."""

    seconds: float
    planning: float
    serving: float
    answers: list[tuple[int, float]]


def cpu_seconds() -> tuple[float, float]:
    own = psutil.Process()
    spent = [sum(process.cpu_times()[:2]) for process in own.children()]
    return sum(spent), sum(own.cpu_times()[:2])


def measure(address: str, questions: list[dict[str, object]], clients: int) -> Measured:
    """Ask all questions."""
    with httpx.Client(base_url=address, timeout=60) as client:

        def ask(question: dict[str, object]) -> tuple[int, float]:
            started = time.perf_counter()
            status = client.post("/api/plan", json=question).status_code
            return status, time.perf_counter() - started

        started, before = time.perf_counter(), cpu_seconds()
        with ThreadPoolExecutor(clients) as pool:
            answers = list(pool.map(ask, questions))
        planning, serving = (after - then for after, then in zip(cpu_seconds(), before, strict=True))
        return Measured(time.perf_counter() - started, planning, serving, answers)


def show(name: str, measured: Measured) -> None:
    times = sorted(1000 * taken for _, taken in measured.answers)
    counts = Counter(status for status, _ in measured.answers)
    statuses = ", ".join(f"{status}: {count}" for status, count in sorted(counts.items()))
    print(
        f"{name:<14}{len(times):>6} questions{len(times) / measured.seconds:>8.1f} a second  median "
        f"{statistics.median(times):.0f} ms  95 % {times[int(len(times) * 0.95)]:.0f} ms  CPU "
        f"{1000 * measured.planning / len(times):.1f} + {1000 * measured.serving / len(times):.1f} ms  ({statuses})"
    )


if __name__ == "__main__":
    main()
