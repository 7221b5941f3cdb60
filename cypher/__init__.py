"""The catalogue of named Cypher queries: one ``*.cypher`` file each, found as package data.

A file begins with a header of comments: what the query answers in plain words, then ``// param: name TYPE`` for each
parameter, ``// column: name`` for each column in order, and ``// mode: read`` or ``write``. A read that has to look at
a whole label says why with ``// scans: reason``. Everything after the header is one statement. Values reach a query
as parameters only; no part of the program puts query text together.

The queries in ``explore/`` are for people. They show with ``// example: name=value`` how they are asked; a parameter
with a ``// default: name=value`` may be left out.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Literal, cast

Mode = Literal["read", "write"]

_MARK = "//"
_MADE = re.compile(r"^CREATE .*?(?:CONSTRAINT|INDEX) (\w+)", re.MULTILINE)
_FIELDS = ("param", "column", "mode", "scans", "example", "default")


@dataclass(frozen=True)
class NamedQuery:
    """One query of the catalogue with what its header declares; ``parameters`` maps each name to its Cypher type.

    ``examples`` and ``defaults`` map names of parameters to values as a person writes them.
    """

    name: str
    text: str
    answers: str
    parameters: dict[str, str]
    columns: tuple[str, ...]
    mode: Mode
    scans: str = ""
    examples: dict[str, str] = field(default_factory=dict)
    defaults: dict[str, str] = field(default_factory=dict)

    @property
    def statement(self) -> str:
        """The text without its header."""
        lines = self.text.splitlines(keepends=True)
        return "".join(lines[sum(1 for _ in _header(lines)) :])


@cache
def named_query(name: str) -> NamedQuery:
    """Return the query kept in ``<name>.cypher``. Raises ValueError where its header is not in order.

    >>> named_query("schema_state").mode
    'read'
    """
    file = resources.files(__package__).joinpath(f"{name}.cypher")
    return read_query(name, file.read_text(encoding="utf-8"))


@cache
def catalogue() -> tuple[NamedQuery, ...]:
    """Return every named query, sorted by name; those that make the schema apart."""
    return tuple(named_query(name) for name in _names(resources.files(__package__)))


@cache
def schema_steps() -> tuple[NamedQuery, ...]:
    """Return the numbered files of ``schema/`` in their order; the number of files is the version of the schema."""
    return _folder("schema")


def schema_parts() -> dict[str, str]:
    """Return what makes each constraint and index of the schema, by its name.

    >>> "object_key" in schema_parts(), "post_name" in schema_parts()
    (True, False)
    """
    made = ((_MADE.search(step.text), step.text) for step in schema_steps())
    return {found[1]: text for found, text in made if found}


@cache
def explore_queries() -> tuple[NamedQuery, ...]:
    """Return the queries for people, sorted by name; ``foon cypher --list`` shows them and ``--name`` asks one."""
    return _folder("explore")


def _folder(name: str) -> tuple[NamedQuery, ...]:
    folder = resources.files(__package__).joinpath(name)
    files = ((name, folder.joinpath(f"{name}.cypher").read_text(encoding="utf-8")) for name in _names(folder))
    return tuple(read_query(name, text) for name, text in files)


def read_query(name: str, text: str) -> NamedQuery:
    r"""Return the query called ``name`` of the ``text`` of a ``.cypher`` file.

    Raises ValueError where its header does not say whether it reads or writes.

    >>> text = "// Counts videos.\n// column: videos\n// mode: read\nMATCH (v:Video) RETURN count(v) AS videos"
    >>> counting = read_query("count_videos", text)
    >>> counting.answers, counting.columns, counting.mode
    ('Counts videos.', ('videos',), 'read')
    """
    fields: dict[str, list[str]] = {word: [] for word in _FIELDS}
    prose: list[str] = []
    for line in _header(text.splitlines()):
        word, colon, value = line.partition(":")
        (fields[word] if colon and word in fields else prose).append(value.strip() if word in fields else line)
    if fields["mode"] not in (["read"], ["write"]):
        raise ValueError(f"{name}.cypher: the header must say “mode: read” or “mode: write” once")
    return NamedQuery(
        name,
        text,
        " ".join(prose),
        _pairs(fields["param"], " "),
        tuple(fields["column"]),
        cast("Mode", fields["mode"][0]),
        " ".join(fields["scans"]),
        _pairs(fields["example"], "="),
        _pairs(fields["default"], "="),
    )


def _pairs(lines: Iterable[str], mark: str) -> dict[str, str]:
    return {name: value for name, _, value in (line.partition(mark) for line in lines)}


def _header(lines: Iterable[str]) -> Iterable[str]:
    for line in lines:
        if not line.startswith(_MARK):
            return
        yield line.removeprefix(_MARK).strip()


def _names(folder: Traversable) -> list[str]:
    files = (file.name for file in folder.iterdir())
    return sorted(name.removesuffix(".cypher") for name in files if name.endswith(".cypher"))
