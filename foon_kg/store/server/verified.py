"""Files whose content is known: read and compared once, and again only where the file system says that they changed.

Beside the files lies a record of them: size, times and number of each as they were when its content was compared. To
look at those takes some milliseconds; to read all jars of Neo4j takes a second.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from foon_kg.model.kept import write_private
from foon_kg.store.server.jars import sha256_of

RECORD = "verified.json"
"""The name of the record."""

Seen = list[int | str]
"""Size, number, and times of the last change of content and of anything, then the SHA-256 that was compared."""


def other_than(folder: Path, hashes: Mapping[str, str]) -> tuple[str, ...]:
    """Return the names of the files in ``folder`` whose SHA-256 is not the one in ``hashes``, in their order there.

    Files that are not there are none of them. Reads what changed since it was compared, and records what is right;
    where nothing can be recorded everything is read again the next time.
    """
    before = _read(folder / RECORD)
    now = {name: seen for name, seen in before.items() if name not in hashes}
    for name, sha256 in hashes.items():
        if (seen := _as_hashed(folder / name, sha256, before.get(name))) is not None:
            now[name] = seen
    if now != before:
        with suppress(OSError):
            write_private(folder / RECORD, json.dumps(now))
    return tuple(name for name in hashes if name not in now and (folder / name).exists())


def _as_hashed(file: Path, sha256: str, recorded: Seen | None) -> Seen | None:
    """Return what is to be ``recorded`` of a file with this hash; ``None`` of another one, or one that is not there."""
    seen = _seen(file)
    if seen is None:
        return None
    seen = [*seen, sha256]
    return seen if recorded == seen or sha256_of(file) == sha256 else None


def _seen(file: Path) -> Seen | None:
    """Return what the file system says of a file, ``None`` where there is none."""
    try:
        found = file.stat()
    except FileNotFoundError:
        return None
    return [found.st_size, found.st_ino, found.st_mtime_ns, found.st_ctime_ns]


def _read(record: Path) -> dict[str, Seen]:
    with suppress(OSError, ValueError):
        told = json.loads(record.read_text(encoding="utf-8"))
        if isinstance(told, dict):
            return told
    return {}
