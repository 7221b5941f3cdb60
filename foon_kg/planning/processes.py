"""Work spread over several processes, answered one by one in the order in which it was given."""

from __future__ import annotations

import gc
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sized
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from functools import cache
from itertools import islice
from multiprocessing import active_children, get_context, parent_process
from multiprocessing.connection import wait
from typing import Any, Protocol, TypeVar

from foon_kg.model.errors import FoonError

T = TypeVar("T")
A = TypeVar("A")
A_co = TypeVar("A_co", covariant=True)

_MOST_AT_ONCE = 8
"""So many items are handed to a process at a time, at most: of few each gets some, and the last one ends soon."""

_ROUNDS = 4
"""So many shares for each process are under way: it need not wait for the next one."""


@contextmanager
def spread(make: Callable[[], Callable[[T], A]], items: Iterable[T], jobs: int) -> Iterator[Iterator[A]]:
    """Open ``jobs`` processes that work on ``items``, in their order; how many they are changes no answer.

    Every process gets ``make`` once, and calls it for its first item; what that answers does the work. The answers
    raise what the work raises, and :class:`~foon_kg.model.errors.FoonError` where a process was ended from outside.
    """
    workers = min(jobs, len(items)) if isinstance(items, Sized) else jobs
    pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"), initializer=_begin, initargs=(make,))
    try:
        yield _with_reason(in_order(lambda share: pool.submit(_work, share), items, workers))
    except KeyboardInterrupt:
        for process in active_children():
            process.terminate()  # else each would end its share first
        raise
    finally:
        pool.shutdown(cancel_futures=True)


class Share(Protocol[A_co]):
    """A share of the items that somebody works on."""

    def result(self) -> A_co:
        """Wait for what came of it."""


def in_order(submit: Callable[[list[T]], Share[list[A]]], items: Iterable[T], workers: int) -> Iterator[A]:
    """Yield what comes of ``items``, in their order; ``submit`` has a share of them worked on.

    Of millions only a few shares for each of ``workers`` are under way or waited for.
    """
    at_once = _MOST_AT_ONCE
    if isinstance(items, Sized):
        at_once = max(1, min(_MOST_AT_ONCE, len(items) // (_ROUNDS * workers)))
    waiting, shares = iter(items), deque[Share[list[A]]]()
    while share := list(islice(waiting, at_once)):
        shares.append(submit(share))
        if len(shares) >= _ROUNDS * workers:
            yield from shares.popleft().result()
    while shares:
        yield from shares.popleft().result()


def _with_reason(found: Iterator[A]) -> Iterator[A]:
    """Yield what is ``found``; raises FoonError with what to do where a process was ended."""
    try:
        yield from found
    except BrokenProcessPool as error:
        raise FoonError(
            "a process that was planning was ended from outside, perhaps for want of memory",
            hint="Try --jobs 1; with --output a run goes on where this one stopped.",
        ) from error


_given: Callable[[], Callable[[Any], Any]] | None = None
"""What a working process was given to work with; the one that asks has nothing."""


def _begin(make: Callable[[], Callable[[Any], Any]]) -> None:
    global _given  # noqa: PLW0603 - the only way to keep something between the tasks of a working process
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that asks hears it, and ends this one
    threading.Thread(target=end_with_parent, daemon=True).start()
    collect_seldom()
    _given = make


def collect_seldom() -> None:
    """Let this process look for unreachable cycles seldom: what planning makes has next to none, and much is kept."""
    gc.set_threshold(100_000, 50, 100)


def collect_often() -> None:
    """Let this process look for unreachable cycles again and again: each request to one that serves leaves some.

    A command looks for them hardly ever, since it ends; for one that does not they are memory that only grows.
    """
    gc.set_threshold(10_000, 10, 10)


def keep_for_good() -> None:
    """Let what this process has made so far never be looked through again for unreachable cycles: all of it stays."""
    gc.collect()
    gc.freeze()


def end_with_parent() -> None:
    """End this process when the one that asks is killed: the queue between them would wait for ever."""
    parent = parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)


@cache
def _worker() -> Callable[[Any], Any]:
    """Return what works in this process, made for its first item: what is wrong with what was given is then told."""
    if _given is None:
        raise RuntimeError("a working process was asked before it had begun")
    made = _given()
    keep_for_good()
    return made


def _work(share: list[Any]) -> list[Any]:
    return list(map(_worker(), share))
