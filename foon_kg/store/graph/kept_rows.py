"""Answers of one edition of the FOON, kept on disk: a new program does not fetch again what an earlier one fetched.

One file an answer in the user's cache folder, which only its owner reads: a line that says what it is, then the rows
as JSON. A file that is not what it says it is counts as none and is written anew; where nothing can be written,
nothing is kept. An edition has a name that no other state of any graph has, so nothing kept ever gets wrong.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, TypeVar

from foon_kg.model.errors import ServerError
from foon_kg.store.graph.statements import Statement
from foon_kg.store.server.disk import write_private
from foon_kg.store.server.home import cache_folder

Row = TypeVar("Row")

MOST_FILES = 64
MOST_BYTES = 256_000_000
"""Beyond these the files that were written first are removed."""


@dataclass(frozen=True)
class KeptRows:
    """What is kept of one ``edition``."""

    edition: str

    def read(self, statement: Statement[Row], parameters: Mapping[str, Any]) -> list[Row] | None:
        """Answer the rows that are kept for ``statement``, ``None`` where there are none."""
        asked = self._asked(statement, parameters)
        with suppress(OSError, ValueError):
            head, _, body = self._file(asked).read_text(encoding="utf-8").partition("\n")
            if head == _head(asked, body):
                return [statement.row(*values) for values in json.loads(body)]
        return None

    def write(self, statement: Statement[Row], parameters: Mapping[str, Any], rows: list[Row]) -> None:
        """Keep ``rows`` for ``statement``, whole or not at all."""
        asked = self._asked(statement, parameters)
        values = [[getattr(row, column) for column in _columns(statement)] for row in rows]
        body = json.dumps(values, ensure_ascii=False, separators=(",", ":"))
        file = self._file(asked)
        with suppress(OSError, ServerError):
            file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            write_private(file, f"{_head(asked, body)}\n{body}")
            _remove_oldest(file.parent)

    def _asked(self, statement: Statement[Row], parameters: Mapping[str, Any]) -> str:
        """Answer what is asked; a statement with other columns asks something else."""
        return json.dumps([self.edition, statement.name, _columns(statement), parameters], sort_keys=True)

    @staticmethod
    def _file(asked: str) -> Path:
        return cache_folder() / "editions" / f"{_digest(asked)}.json"


def _columns(statement: Statement[Any]) -> list[str]:
    return [field.name for field in fields(statement.row)]


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
