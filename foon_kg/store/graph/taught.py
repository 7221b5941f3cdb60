"""What one video teaches by itself: worked out ahead, while the database is busy with the videos before it."""

from __future__ import annotations

import sys
import threading
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

from foon_kg.integration.teaching.frames import Frame
from foon_kg.model import Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph.frame_rows import frame_row
from foon_kg.store.graph.lifting import Lifted, lifted
from foon_kg.store.graph.video_rows import VideoRows, rows_of
from foon_kg.store.snapshot import frames_in

SWITCH_SECONDS = 0.0005
"""So long the thread that works ahead keeps the interpreter from the writer, which needs it back after each read of its
socket: Python's own 5 ms are longer than most statements take, and a statement reads several times."""


class _ShortTurns:
    """Threads take turns of :data:`SWITCH_SECONDS` at most while any load is under way, as before when the last ends.

    The interval is that of the whole program: loads of several threads may end in another order than they began.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._loads = 0
        self._before = 0.0

    def begin(self) -> None:
        """Begin with a load."""
        with self._lock:
            if not self._loads:
                self._before = sys.getswitchinterval()
                sys.setswitchinterval(min(self._before, SWITCH_SECONDS))
            self._loads += 1

    def end(self) -> None:
        """End what :meth:`begin` began."""
        with self._lock:
            self._loads -= 1
            if not self._loads:
                sys.setswitchinterval(self._before)


_SHORT_TURNS = _ShortTurns()


@dataclass(frozen=True)
class Taught:
    """The frames of a video, the same as rows for the graph, by their keys what its units say, and its own rows."""

    frames: tuple[Frame, ...]
    frame_rows: tuple[dict[str, Any], ...]
    units: Mapping[str, Lifted]
    rows: VideoRows


def taught_by(subgraph: Subgraph, kitchen: Kitchen) -> Taught:
    """Return what ``subgraph`` teaches in this ``kitchen``, whatever else the graph has."""
    frames = frames_in(subgraph, kitchen)
    units = {annotation.unit.key: annotation.unit for annotation in subgraph.annotations}
    says = {key: lifted(unit) for key, unit in units.items()}
    return Taught(frames, tuple(map(frame_row, frames)), says, rows_of(subgraph, kitchen))


class Ahead:
    """What videos teach, worked out ahead: that of the next batch while one is written.

    It has a thread of its own, which runs while the writer waits for the database. What was not begun is dropped when
    the ``with`` statement ends.
    """

    def __init__(self, kitchen: Kitchen) -> None:
        self._kitchen = kitchen
        self._pool = ThreadPoolExecutor(max_workers=1)
        self._begun: dict[str, Future[Taught]] = {}

    def __enter__(self) -> Ahead:
        _SHORT_TURNS.begin()
        return self

    def __exit__(self, *_: object) -> None:
        _SHORT_TURNS.end()
        self._pool.shutdown(cancel_futures=True)

    def begin(self, videos: Iterable[Subgraph]) -> None:
        """Begin with those of the ``videos`` that were not begun yet."""
        for one in videos:
            if one.name not in self._begun:
                self._begun[one.name] = self._pool.submit(taught_by, one, self._kitchen)

    def through(self, batches: Iterable[Sequence[Subgraph]]) -> Iterator[Sequence[Subgraph]]:
        """Yield the ``batches``; when one is taken the next is begun, and what the one before taught is forgotten."""
        waiting: deque[Sequence[Subgraph]] = deque()
        for batch in batches:
            waiting.append(batch)
            self.begin(batch)
            if len(waiting) > 1:
                yield from self._written(waiting.popleft())
        for batch in waiting:
            yield from self._written(batch)

    def _written(self, batch: Sequence[Subgraph]) -> Iterator[Sequence[Subgraph]]:
        yield batch
        for one in batch:
            del self._begun[one.name]

    def taught_by(self, subgraph: Subgraph) -> Taught:
        """Return what ``subgraph`` teaches, a video of the batch that is written or of the next.

        Raises what working it out raised, and KeyError for any other video.
        """
        return self._begun[subgraph.name].result()
