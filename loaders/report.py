"""What a load reports about its files: every notice as a line of JSON, and how many there are of each kind."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from typing import TextIO

from foon_kg.loaders.notices import Notice, NoticeKind, Severity


def write_report(notices: Iterable[Notice], stream: TextIO) -> int:
    """Write ``notices`` to ``stream``, one JSON object a line (``foon load foon --report FILE``); return how many."""
    count = 0
    for notice in notices:
        stream.write(json.dumps(notice.to_json(), ensure_ascii=True) + "\n")
        count += 1
    return count


def count_by_kind(notices: Iterable[Notice]) -> dict[tuple[Severity, NoticeKind], int]:
    """Return how many notices there are of each kind: what was rejected first, then the most frequent."""
    counts = Counter((notice.severity, notice.kind) for notice in notices)
    order = sorted(counts, key=lambda kind: (kind[0] is not Severity.REJECTED, -counts[kind], kind[1]))
    return {kind: counts[kind] for kind in order}


def summary(notices: Iterable[Notice]) -> tuple[str, ...]:
    """Return ``notices`` for people, a line a kind: ``rejected: 1 two-motions``, ``assumed: 33 name-twice``."""
    return tuple(f"{severity}: {count} {kind}" for (severity, kind), count in count_by_kind(notices).items())
