"""What one program worked out and the next need not: texts in the user's cache folder.

One file an answer, which only its owner reads: a line that says what was asked and what the answer's hash is, then the
answer. A file that is not what it says it is counts as none and is written anew; where nothing can be written, nothing
is kept. ``asked`` has to name all that the answer depends on: then nothing kept ever gets wrong.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any

from foon_kg.model.json_text import compact_json
from foon_kg.model.written_files import write_whole

MOST_FILES = 64
MOST_BYTES = 256_000_000
"""Beyond these, in one folder, the files that were written first are removed."""


def cache_folder() -> Path:
    """Return the folder of what can be fetched or made again; ``FOON_KG_CACHE`` names another one."""
    chosen = os.environ.get("FOON_KG_CACHE")
    if chosen:
        return Path(chosen).expanduser().resolve()
    import platformdirs  # noqa: PLC0415 - only where nobody named a folder

    return platformdirs.user_cache_path("foon-kg", appauthor=False).expanduser().resolve()


def find(folder: str, asked: str) -> str | None:
    """Return what is kept in this folder of the cache for ``asked``, ``None`` where nothing is."""
    with suppress(OSError, ValueError):
        head, _, body = _file(folder, asked).read_text(encoding="utf-8").partition("\n")
        if head == _head(asked, body):
            return body
    return None


def keep(folder: str, asked: str, body: str) -> None:
    """Keep ``body`` for what was ``asked`` (one line) in a ``folder`` of the cache, whole or not at all."""
    # a text that is no Unicode (half a pair of surrogates, out of a file's name) is a ValueError: it is not kept
    with suppress(OSError, ValueError):
        file = _file(folder, asked)
        file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        write_private(file, f"{_head(asked, body)}\n{body}")
        _remove_oldest(file.parent)


def kept(folder: str, source: bytes, make: Callable[[], Any]) -> Any:  # noqa: ANN401 - any value of JSON
    """Return the JSON that ``make`` makes of ``source`` and of nothing else, kept in a ``folder`` of the cache."""
    asked = hashlib.blake2b(source, digest_size=16).hexdigest()
    body = find(folder, asked)
    if body is not None:
        return json.loads(body)
    value = make()
    keep(folder, asked, compact_json(value))
    return value


def code_key(places: Iterable[Traversable]) -> str:
    """Return a hash of the code and the tables at ``places``: files, and packages without their subpackages."""
    digest = hashlib.blake2b(digest_size=16)
    for place in places:
        files = [place] if place.is_file() else sorted(place.iterdir(), key=lambda file: file.name)
        for file in files:
            if file.name.endswith((".py", ".toml", ".txt")):
                digest.update(file.read_bytes())
    return digest.hexdigest()


def write_private(file: Path, text: str) -> None:
    """Write ``text`` to a ``file`` that only its owner can read, whole or not at all."""
    write_whole(file, text, mode=0o600)


def _file(folder: str, asked: str) -> Path:
    return cache_folder() / folder / f"{_digest(asked)}.json"


def _head(asked: str, body: str) -> str:
    return f"{asked} {_digest(body)}"


def _digest(text: str) -> str:
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()


def _remove_oldest(folder: Path) -> None:
    """Remove the files that were written first, until few enough and small enough ones are left."""
    found = sorted(((file.stat(), file) for file in folder.iterdir()), key=lambda row: -row[0].st_mtime_ns)
    total = 0
    for place, (stat, file) in enumerate(found):
        total += stat.st_size
        if place >= MOST_FILES or total > MOST_BYTES:
            file.unlink(missing_ok=True)
