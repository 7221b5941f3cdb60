"""Runs that take a while: what a terminal shows of them while they last, and the line that closes them.

Only stderr, only where it is a terminal, and only what takes longer than a second (``SHOWN_AFTER``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from threading import Timer
from time import monotonic
from typing import TypeVar

from foon_kg.cli.streams import messages

T = TypeVar("T")

SHOWN_AFTER = 1.0
"""Seconds that a run may take without a word."""

_MINUTE = 60


def progress_bar(items: Iterable[T], label: str, total: int, done: int = 0, *, quiet: bool = False) -> Iterator[T]:
    """Pass ``items`` on, and show under a ``label`` how many of ``total`` are done, ``done`` of them before.

    Nothing is shown where it shall be ``quiet``.
    """
    with counting(label, total, done, quiet=quiet) as advance:
        for item in items:
            yield item
            advance(1)


def waited(items: Iterable[T], label: str, *, quiet: bool = False) -> Iterator[T]:
    """Pass ``items`` on.

    Show under a ``label``, unless ``quiet``, that the next is waited for, nothing while one is used.
    """
    following, ended = iter(items), object()
    while True:
        with counting(label, quiet=quiet, closing=False):
            item = next(following, ended)
        if item is ended:
            return
        yield item  # type: ignore[misc]  # only what is no end


@contextmanager
def counting(
    label: str,
    total: int | None = None,
    done: int = 0,
    *,
    quiet: bool = False,
    after: float | None = None,
    closing: bool = True,
) -> Iterator[Callable[[int], None]]:
    """Show a bar with a ``label`` of what is done, as in "Planning recipes", and close it with a line of its own.

    Yield what is told how many more are done, ``done`` of them before. Where nobody knows the ``total``, seconds run on
    instead. It is shown ``after`` so many seconds (``SHOWN_AFTER``), and not at all where it shall be ``quiet``;
    without ``closing`` no line stays behind.
    """
    after = SHOWN_AFTER if after is None else after
    console = messages(quiet=quiet)
    if quiet or not console.is_terminal:
        yield _nothing
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    named = TextColumn("{task.description}")
    bar = (named, BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    columns = bar if total is not None else (SpinnerColumn(), named, TimeElapsedColumn())
    shown = Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False)
    task = shown.add_task(label, total=total, completed=done)
    begun, counted = monotonic(), [0]

    def advance(more: int) -> None:
        counted[0] += more
        shown.advance(task, more)

    timer = Timer(after, shown.start)
    timer.daemon = True
    if after:
        timer.start()
    else:
        shown.start()
    try:
        yield advance
    finally:
        timer.cancel()
        if after:
            timer.join()
        if shown.live.is_started:
            shown.stop()
            if closing:
                told = _summary(label, counted[0], done, total)
                console.print(f"{told} in {_long(monotonic() - begun)}", style="dim", markup=False)


def _summary(label: str, counted: int, done: int, total: int | None) -> str:
    """Return the line that a bar leaves behind, but for its seconds: ``counted`` here, and ``done`` before."""
    if not (total or counted):
        return label
    return f"{label}: {counted + done:,}" + ("" if total is None else f" of {total:,}")


def _nothing(_more: int) -> None:
    """Tell nobody."""


def _long(seconds: float) -> str:
    """Return a time for people: 4.2 s, then 1:05 min."""
    return f"{seconds:.1f} s" if seconds < _MINUTE else f"{round(seconds) // 60}:{round(seconds) % 60:02} min"
