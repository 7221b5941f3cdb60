"""Work spread over the machines of a Dask cluster, answered one by one in the order in which it was given."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, TypeVar

from foon_kg.model.errors import FoonError, UsageError
from foon_kg.planning.processes import in_order

if TYPE_CHECKING:
    from distributed import Client

T = TypeVar("T")
A = TypeVar("A")

PATIENCE = 10
"""How many seconds a scheduler has to answer."""

_USUAL_PORT = 8786
"""Where a scheduler listens whose address names no port."""

_LEAST_THREADS = 8
"""Work is ready for so many at least: workers may still join."""


@contextmanager
def spread_over(make: Callable[[], Callable[[T], A]], items: Iterable[T], address: str) -> Iterator[Iterator[A]]:
    """Open the cluster whose scheduler is at ``address``; its workers work on ``items``, in their order.

    As in :func:`foon_kg.planning.processes.spread` every worker gets ``make`` once and calls it for its first item, and
    how many they are changes no answer; of millions of items a few shares for each are under way. What a worker had
    that is lost another does again. The answers raise what the work raises, and
    :class:`~foon_kg.model.errors.FoonError` where all workers were lost, or several at the same share. Raises
    :class:`~foon_kg.model.errors.UsageError` where Dask is not installed, no scheduler answers, it has no workers, or
    these have another foon-kg.
    """
    with _connected(address) as client:
        _check(client, address)
        given = client.scatter(make, broadcast=True, hash=False)
        threads = sum(client.nthreads().values())
        yield _with_reason(
            in_order(partial(client.submit, _work, given, pure=False), items, max(threads, _LEAST_THREADS))
        )


@contextmanager
def _connected(address: str) -> Iterator[Client]:
    try:
        from distributed import Client  # noqa: PLC0415 - an extra, and slow to import
    except ImportError as error:
        raise UsageError("this needs Dask, which is not installed", hint="pip install 'foon-kg[cluster]'") from error
    try:
        _knock(address)
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise UsageError(
            f"no Dask scheduler answers at {address}",
            hint="--dask names what dask scheduler prints, as in tcp://127.0.0.1:8786.",
        ) from error
    with client:
        yield client


def _knock(address: str) -> None:
    """Raise OSError where nothing listens at ``address``, and ValueError where it is none.

    Dask's own client asks again for as long as its patience lasts, and takes as long to give up once more.
    """
    from distributed.comm.addressing import parse_address, parse_host_port  # noqa: PLC0415 - an extra

    protocol, place = parse_address(address)
    if protocol in {"tcp", "tls"}:
        socket.create_connection(parse_host_port(place, _USUAL_PORT), timeout=PATIENCE).close()


def _check(client: Client, address: str) -> None:
    ours = version("foon-kg")
    try:
        theirs = client.run(_version)
    except ImportError as error:
        raise UsageError(
            f"a worker of {address} has no foon-kg: {error}", hint="Install foon-kg where dask worker runs."
        ) from error
    if not theirs:
        raise UsageError(f"the Dask scheduler at {address} has no workers", hint=f"Start some: dask worker {address}")
    other = next((worker for worker in sorted(theirs) if theirs[worker] != ours), None)
    if other is not None:
        raise UsageError(
            f"the worker {other} has foon-kg {theirs[other]}, and this is {ours}", hint="Install the same everywhere."
        )


def _with_reason(found: Iterator[A]) -> Iterator[A]:
    """Yield what is ``found``; raises FoonError with what to do where all workers were lost."""
    from distributed import KilledWorker  # noqa: PLC0415 - an extra
    from distributed.client import FutureCancelledError  # noqa: PLC0415 - the same

    try:
        yield from found
    except (KilledWorker, FutureCancelledError) as error:
        raise FoonError(
            f"the Dask cluster lost its workers: {error}",
            hint="Start them again, perhaps with more memory; with --output a run goes on where this one stopped.",
        ) from error


def _version() -> str:
    return version("foon-kg")


_kept = threading.local()


def _work(make: Callable[[], Callable[[Any], Any]], share: list[Any]) -> list[Any]:
    """Work on ``share``; what ``make`` returns is kept for the next one, for each thread of the worker apart."""
    if getattr(_kept, "make", None) is not make:
        _kept.make, _kept.work = make, make()
    return list(map(_kept.work, share))
