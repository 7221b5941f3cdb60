"""Answers of one edition of the FOON, kept on disk: a new program does not fetch again what an earlier one fetched.

They are rows as JSON among what is kept (:mod:`foon_kg.model.kept`). An edition has a name that no other state of any
graph has, so nothing kept ever gets wrong.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from foon_kg.model import kept
from foon_kg.model.json_text import compact_json
from foon_kg.store.graph.statements import R, Statement

_FOLDER = "editions"


@dataclass(frozen=True)
class KeptRows:
    """What is kept of one ``edition``."""

    edition: str

    def read(self, statement: Statement[R], parameters: Mapping[str, Any]) -> list[R] | None:
        """Return the rows that are kept for ``statement`` with these ``parameters``, ``None`` where there are none."""
        body = kept.find(_FOLDER, self._asked(statement, parameters))
        return None if body is None else [statement.row(*values) for values in json.loads(body)]

    def write(self, statement: Statement[R], parameters: Mapping[str, Any], rows: list[R]) -> None:
        """Keep the ``rows`` of ``statement`` with these ``parameters``, whole or not at all."""
        values = [[getattr(row, column) for column in _columns(statement)] for row in rows]
        body = compact_json(values)
        kept.keep(_FOLDER, self._asked(statement, parameters), body)

    def _asked(self, statement: Statement[R], parameters: Mapping[str, Any]) -> str:
        """Return what is asked; a statement with other columns asks something else."""
        return json.dumps([self.edition, statement.name, _columns(statement), parameters], sort_keys=True)


def _columns(statement: Statement[Any]) -> list[str]:
    return list(statement.row.columns)
