"""Whether ``foon serve`` stays as it is for as long as it runs: an hour of mixed requests, and the memory it takes.

    python benchmarks/soak.py --minutes 60 [--clients 4] [--files FOLDER] [--seed 1]

Starts ``foon serve`` as anybody does, on a free port, and asks it: plans of new recipes and of the same ones, pages,
what is wrong, what is not there, half a request, a connection that is dropped. Every ten seconds the memory of all its
processes is added up, and the processor time that each answer took. It fails (exit code 1) where a request got no
answer or the wrong status, where the median memory of the last quarter is more than a tenth above that of the second,
or where an answer takes a quarter more processor time then: in the first, what is kept to be quicker fills.
"""

from __future__ import annotations

import argparse
import http.client
import json
import os
import random
import socket
import statistics
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil

from foon_kg.foon.demo import demo_folder

MOST_GROWTH = 1.1
MOST_SLOWER = 1.25
EVERY = 10.0
"""Seconds between two looks at the memory."""

A_SECOND = 40.0
"""So much is asked: more from one address the service refuses."""

FOODS = (
    "onion",
    "tomato",
    "egg",
    "butter",
    "lettuce",
    "cucumber",
    "bean",
    "flour",
    "sugar",
    "lemon",
    "kohlrabi",
    "leek",
)
STATES = ("chopped", "sliced", "whole", "diced", "")
DISHES = ("salad", "soup", "omelette", "drink", "")
PROGRAM = "import sys; from foon_kg.cli import main; sys.exit(main())"


@dataclass(frozen=True)
class Look:
    """One moment: bytes that the process which serves has, and those that plan; seconds of processor, answers."""

    serves: int
    plan: int
    processor: float
    answers: int

    @property
    def memory(self) -> int:
        """Bytes of all processes."""
        return self.serves + self.plan


@dataclass
class Soak:
    """One run: what is asked, and what came of it."""

    port: int
    random: random.Random
    pause: float
    statuses: Counter[str] = field(default_factory=Counter)
    wrong: list[str] = field(default_factory=list)

    def ask(self, method: str, path: str, *expected: int, body: object = None, raw: bytes | None = None) -> None:
        """Send a request; what is not answered as ``expected`` is wrong."""
        data = json.dumps(body).encode() if body is not None else raw
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            connection.request(method, path, data, {"Content-Type": "application/json"} if data else {})
            status = connection.getresponse()
            status.read()
            told = str(status.status)
        except (OSError, http.client.HTTPException) as error:
            told = type(error).__name__
        finally:
            connection.close()
        self.statuses[told] += 1
        if told not in map(str, expected):
            self.wrong.append(f"{method} {path}: {told}")

    def recipe(self, foods: int) -> dict[str, Any]:
        """Return what a plan is asked for."""
        chosen = self.random.sample(FOODS, foods)
        return {
            "dish_type": self.random.choice(DISHES),
            "ingredients": [f"{self.random.choice(STATES)} {food}".strip() for food in chosen],
        }

    def new_plan(self) -> None:
        """Ask for a plan that was most likely not asked for before."""
        self.ask("POST", "/api/plan", 200, 404, 422, 429, 503, body=self.recipe(self.random.randint(1, 5)))

    def same_plan(self) -> None:
        """Ask for the plan that is asked for again and again."""
        body = {"dish_type": "salad", "ingredients": ["chopped onion", "tomato"]}
        self.ask("POST", "/api/plan", 200, 429, 503, body=body)

    def page(self) -> None:
        """Ask for a page or what belongs to it."""
        self.ask("GET", self.random.choice(("/", "/explore", "/stage.js", "/picture.css", "/api/examples")), 200, 429)

    def wrong_question(self) -> None:
        """Send bytes."""
        raw = bytes(self.random.randrange(256) for _ in range(self.random.randrange(1, 2000)))
        self.ask("POST", "/api/plan", 400, 422, 429, raw=raw)

    def nowhere(self) -> None:
        """Ask for what is not there."""
        self.ask("GET", f"/{self.random.random()}", 404, 429)

    def half(self) -> None:
        """Begin a request and go."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=10) as connection:
            connection.sendall(b"POST /api/plan HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Le")

    def dropped(self) -> None:
        """Ask and do not wait for the answer."""
        body = json.dumps(self.recipe(3)).encode()
        head = f"POST /api/plan HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nContent-Type: application/json\r\n"
        with socket.create_connection(("127.0.0.1", self.port), timeout=10) as connection:
            connection.sendall(f"{head}Content-Length: {len(body)}\r\n\r\n".encode() + body)

    def go_on(self, until: float) -> None:
        """Ask one thing after another."""
        ways: tuple[Callable[[], None], ...] = (
            self.new_plan, self.new_plan, self.same_plan, self.page, self.wrong_question, self.nowhere, self.half,
            self.dropped,
        )  # fmt: skip
        while time.monotonic() < until:
            try:
                self.random.choice(ways)()
            except OSError as error:
                self.wrong.append(repr(error))
            time.sleep(self.pause)


def main() -> int:
    """Soak, and tell how it went."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--clients", type=int, default=4)
    parser.add_argument("--files", type=Path, default=demo_folder())
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    port = _free_port()
    words = ["serve", "--files", str(given.files), "--port", str(port), "--quiet"]
    server = subprocess.Popen([sys.executable, "-c", PROGRAM, *words], stdout=subprocess.DEVNULL, env=os.environ)
    try:
        _wait(port, server)
        pause = given.clients / A_SECOND
        soaks = [Soak(port, random.Random(given.seed + number), pause) for number in range(given.clients)]
        until = time.monotonic() + 60 * given.minutes
        threads = [threading.Thread(target=soak.go_on, args=(until,)) for soak in soaks]
        for thread in threads:
            thread.start()
        looks = _looks(server.pid, until, soaks)
        for thread in threads:
            thread.join()
        alive = server.poll() is None
    finally:
        server.terminate()
        server.wait()
    return _told(soaks, looks, alive=alive)


def _looks(pid: int, until: float, soaks: list[Soak]) -> list[Look]:
    """Return what is seen of a process and all below it, again and again, and tell it each minute."""
    looks: list[Look] = []
    while time.monotonic() < until:
        time.sleep(EVERY)
        looks.append(_look(pid, sum(sum(soak.statuses.values()) for soak in soaks)))
        if len(looks) % round(60 / EVERY) == 0:
            print(_line(looks[-1 - round(60 / EVERY) :]), flush=True)
    return looks


def _look(pid: int, answers: int) -> Look:
    """Return the bytes that only these processes have (Linux), or that they have, and what time they took."""
    taken, processor = [], 0.0
    for process in (psutil.Process(pid), *psutil.Process(pid).children(recursive=True)):
        try:
            found, times = process.memory_full_info(), process.cpu_times()
        except psutil.NoSuchProcess:
            continue
        taken.append(int(getattr(found, "uss", found.rss)))
        processor += times.user + times.system
    return Look(taken[0], sum(taken[1:]), processor, answers)


def _line(looks: list[Look]) -> str:
    last = looks[-1]
    return (
        f"{last.answers} answers, {last.serves / 1e6:.1f} MB serve and {last.plan / 1e6:.1f} MB plan, "
        f"{1e3 * _an_answer(looks):.2f} ms of processor an answer"
    )


def _an_answer(looks: list[Look]) -> float:
    """Return the seconds of processor that an answer took between the first and the last of some looks."""
    first, last = looks[0], looks[-1]
    return (last.processor - first.processor) / max(1, last.answers - first.answers)


def _told(soaks: list[Soak], looks: list[Look], *, alive: bool) -> int:
    statuses = sum((soak.statuses for soak in soaks), Counter[str]())
    wrong = [one for soak in soaks for one in soak.wrong]
    quarter = max(1, len(looks) // 4)
    second, last = looks[quarter : 2 * quarter] or looks, looks[-quarter:]
    early, late = (statistics.median(look.memory for look in part) for part in (second, last))
    quick, slow = _an_answer(second), _an_answer(last)
    print(f"{sum(statuses.values())} answers: " + ", ".join(f"{code}: {n}" for code, n in sorted(statuses.items())))
    print(f"memory {early / 1e6:.1f} → {late / 1e6:.1f} MB ({100 * late / early - 100:+.1f} %), {len(looks)} looks")
    print(f"processor {1e3 * quick:.2f} → {1e3 * slow:.2f} ms an answer ({100 * slow / max(quick, 1e-9) - 100:+.1f} %)")
    for one in wrong[:10]:
        print(f"wrong: {one}")
    return int(bool(wrong) or not alive or late > MOST_GROWTH * early or slow > MOST_SLOWER * quick)


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return int(listener.getsockname()[1])


def _wait(port: int, server: subprocess.Popen[bytes]) -> None:
    while server.poll() is None:
        try:
            socket.create_connection(("127.0.0.1", port), timeout=1).close()
        except OSError:
            time.sleep(0.1)
        else:
            return
    raise SystemExit("foon serve did not start")


if __name__ == "__main__":
    sys.exit(main())
