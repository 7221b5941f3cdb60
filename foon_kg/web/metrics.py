"""What is counted of the service while it runs, in the text format of Prometheus; as ASGI middleware."""

from __future__ import annotations

import time
from bisect import bisect_left
from collections import Counter, defaultdict
from collections.abc import Collection, Iterator, Mapping

from starlette.types import ASGIApp, Message, Receive, Scope, Send

CONTENT_TYPE = "text/plain; version=0.0.4; charset=utf-8"

BUCKETS = (0.005, 0.025, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 20.0)
"""Upper ends of the buckets of seconds that a request took."""

_METHODS = frozenset({"GET", "HEAD", "POST", "OPTIONS", "PUT", "DELETE", "PATCH"})
_BROKEN = 500
"""What is counted where no answer was begun: something failed outside of all that answers errors."""
_ESCAPED = {ord("\\"): "\\\\", ord('"'): '\\"', ord("\n"): "\\n"}


class Metrics:
    """Counts of requests, by a path of the service (``paths``), method and status, and how long they took."""

    def __init__(self, paths: Collection[str]) -> None:
        self.paths = frozenset(paths)
        self.under_way = 0
        self.started = time.time()
        self._requests: Counter[tuple[str, str, int]] = Counter()
        self._buckets: defaultdict[str, list[int]] = defaultdict(lambda: [0] * (len(BUCKETS) + 1))
        self._seconds: defaultdict[str, float] = defaultdict(float)

    def count(self, path: str, method: str, status: int, seconds: float) -> None:
        """Count a request to ``path`` by its ``method``, answered with ``status`` in so many ``seconds``.

        What is no path of the service counts as ``other``, whatever was asked.
        """
        path = path if path in self.paths else "other"
        self._requests[path, method if method in _METHODS else "other", status] += 1
        self._buckets[path][bisect_left(BUCKETS, seconds)] += 1
        self._seconds[path] += seconds

    def text(self, beside: Mapping[str, tuple[str, float]], labels: Mapping[str, str]) -> str:
        """Return all counts as Prometheus reads them.

        ``beside`` are other numbers of the moment by their names, each with what it is; ``labels`` describe what runs.
        """
        return "".join(f"{line}\n" for line in (*self._lines(), *_moment(beside), *_info(labels)))

    def _lines(self) -> Iterator[str]:
        yield from _head("foon_requests_total", "counter", "Requests that were answered.")
        for (path, method, status), count in sorted(self._requests.items()):
            yield f"foon_requests_total{_labelled(path=path, method=method, status=str(status))} {count}"
        yield from _head("foon_request_seconds", "histogram", "Seconds from a request to the end of its answer.")
        for path, counts in sorted(self._buckets.items()):
            total = 0
            for end, count in zip((*map(str, BUCKETS), "+Inf"), counts, strict=True):
                total += count
                yield f"foon_request_seconds_bucket{_labelled(path=path, le=end)} {total}"
            yield f"foon_request_seconds_sum{_labelled(path=path)} {self._seconds[path]:.6f}"
            yield f"foon_request_seconds_count{_labelled(path=path)} {total}"
        yield from _moment(
            {
                "foon_requests_under_way": ("Requests that are not answered yet.", self.under_way),
                "process_start_time_seconds": ("When the service began, in seconds since 1970.", self.started),
            }
        )


class Metered:
    """Counts every request in ``metrics``, whatever becomes of it."""

    def __init__(self, app: ASGIApp, metrics: Metrics) -> None:
        self.app = app
        self.metrics = metrics

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on."""
        if scope["type"] != "http":
            return await self.app(scope, receive, send)
        status, began = _BROKEN, time.monotonic()

        async def sent(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
            await send(message)

        self.metrics.under_way += 1
        try:
            await self.app(scope, receive, sent)
        finally:
            self.metrics.under_way -= 1
            self.metrics.count(scope["path"], scope["method"], status, time.monotonic() - began)


def _head(name: str, kind: str, what: str) -> tuple[str, str]:
    return f"# HELP {name} {what}", f"# TYPE {name} {kind}"


def _moment(numbers: Mapping[str, tuple[str, float]]) -> Iterator[str]:
    for name, (what, value) in numbers.items():
        yield from _head(name, "gauge", what)
        yield f"{name} {value:.15g}"


def _info(labels: Mapping[str, str]) -> Iterator[str]:
    yield from _head("foon_info", "gauge", "What runs: always 1.")
    yield f"foon_info{_labelled(**labels)} 1"


def _labelled(**labels: str) -> str:
    return "{" + ",".join(f'{name}="{value.translate(_ESCAPED)}"' for name, value in labels.items()) + "}"
