"""What is wrong with Cypher that a person typed, in their own lines and columns: errors, and names that nothing has."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from difflib import get_close_matches

import neo4j

from foon_kg.model.errors import GraphError

_PLACE = re.compile(r"\s*\(line (?P<line>\d+), column (?P<column>\d+) \(offset: \d+\)\).*", re.DOTALL)
_INPUT = re.compile(r"Invalid input '(?P<word>\w+)'")
_EXPECTED = re.compile(r"'([A-Z ]+)'")
_MISSING = re.compile(r"Expected parameter\(s\): (?P<names>.+)")
_UNKNOWN = {
    "01N50": ("label", "no node has the label", "db.labels"),
    "01N51": ("type", "no relationship has the type", "db.relationshipTypes"),
    "01N52": ("property", "nothing has the property", "db.propertyKeys"),
}
_MANUAL = "See the Cypher manual: neo4j.com/docs/cypher-manual."


def told_error(message: str, text: str | None, *, lines_before: int = 0) -> GraphError:
    """Return the error for a ``message`` of the server about ``text``; it got so many ``lines_before`` of ours.

    The place is left out where the server was asked in words that nobody typed: ``text`` is None then.

    >>> print(told_error("Invalid input 'RETRN' (line 2, column 11 (offset: 20))", "MATCH (o) RETRN o", lines_before=1))
    Invalid input 'RETRN' (line 1, column 11)
      MATCH (o) RETRN o
                ^
    """
    place = _PLACE.search(message)
    what = message if place is None else message[: place.start()]
    where = ""
    if place is not None and text is not None:
        line, column = int(place["line"]) - lines_before, int(place["column"])
        where = f" (line {line}, column {column})" + _pointed(text, line, column)
    return GraphError(what + where, hint=_hint(what), code="cypher")


def _pointed(text: str, line: int, column: int) -> str:
    """Return the line of the text with a mark below the column."""
    lines = text.splitlines()
    if not 0 < line <= len(lines):
        return ""
    return f"\n  {lines[line - 1]}\n  {' ' * (column - 1)}^"


def _hint(what: str) -> str:
    missing = _MISSING.search(what)
    if missing is not None:
        return "Give it a value: " + " ".join(f"-P {name.strip()}=VALUE" for name in missing["names"].split(","))
    wrong = _INPUT.search(what)
    if wrong is not None:
        near = get_close_matches(wrong["word"].upper(), _EXPECTED.findall(what[wrong.end() :]), 1, cutoff=0.75)
        if near:
            return f"Did you mean {near[0]}?"
    return _MANUAL


def unknown_names(
    statuses: Iterable[neo4j.GqlStatusObject], known: Callable[[str], Sequence[str]], *, lines_before: int
) -> Iterator[str]:
    """Yield a line about each label, type and property of a question that nothing in the graph has.

    ``statuses`` are the server's about that question, which came behind so many ``lines_before``. ``known`` returns the
    names that a procedure of the server lists.
    """
    told = set()
    for status in sorted(statuses, key=_place):
        if status.gql_status not in _UNKNOWN:
            continue
        kind, says, procedure = _UNKNOWN[status.gql_status]
        name = re.search("`(.+?)`", status.status_description)
        if name is None or (kind, name[1]) in told:
            continue
        told.add((kind, name[1]))
        line, column = _place(status)
        where = f" (line {line - lines_before}, column {column})" if line else ""
        yield f"{says} “{name[1]}”{where}{_meant(name[1], known(procedure))}"


def _place(status: neo4j.GqlStatusObject) -> tuple[int, int]:
    place = status.position
    return (0, 0) if place is None else (place.line, place.column)


def _meant(name: str, known: Sequence[str]) -> str:
    lower = {one.lower(): one for one in sorted(known)}
    near = get_close_matches(name.lower(), lower, 1)
    return f": did you mean “{lower[near[0]]}”?" if near else ""
