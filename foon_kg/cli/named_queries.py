"""The queries that come with foon-kg for people: which there are, and the values they are asked with."""

from __future__ import annotations

import difflib
import json
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from foon_kg.model.errors import UsageError
from foon_kg.model.json_text import json_value

if TYPE_CHECKING:
    from foon_kg.cypher import NamedQuery


def explore_query(name: str) -> NamedQuery:
    """Return the query of this name. Raises UsageError with the nearest names where there is none."""
    from foon_kg.cypher import explore_queries

    known = {query.name: query for query in explore_queries()}
    if name in known:
        return known[name]
    near = difflib.get_close_matches(name, known, n=3, cutoff=0.4)
    meant = f"Did you mean {' or '.join(near)}? " if near else ""
    raise UsageError(f"no query is called {name}", hint=f"{meant}foon cypher --list shows them all.")


def values(query: NamedQuery, given: Mapping[str, str]) -> dict[str, object]:
    """Return the parameters of ``query`` in their types: what was ``given`` as text, else the defaults.

    Raises UsageError where one is missing, unknown, or not of its type.
    """
    if unknown := sorted(given.keys() - query.parameters.keys()):
        raise UsageError(f"{query.name} has no parameter {', '.join(unknown)}", hint=_asked_like(query))
    texts = {**query.defaults, **given}
    if missing := [name for name in query.parameters if name not in texts]:
        raise UsageError(f"{query.name} also asks for {', '.join(missing)}", hint=_asked_like(query))
    return {name: _typed(query, name, kind, texts[name]) for name, kind in query.parameters.items()}


def unknown_names(given: Iterable[object], known: Collection[str]) -> Iterator[str]:
    """Yield a sentence on each text among the ``given`` values that is no name of those ``known``, with a near one."""
    spelled = {name.lower(): name for name in sorted(known)}
    texts = (text for value in given for text in (value if isinstance(value, list) else [value]))
    for text in texts:
        if not isinstance(text, str) or not text or text in known:
            continue
        near = difflib.get_close_matches(text.lower(), spelled, n=1)
        meant = f"did you mean “{spelled[near[0]]}”?" if near else "foon cypher --name names shows them all."
        yield f"It has no name “{text}”: {meant}"


def command(query: NamedQuery) -> str:
    """Return the command that asks ``query`` with its own example."""
    shown = (f"-P {name}={_quoted(value)}" for name, value in query.examples.items())
    return " ".join(["foon cypher --name", query.name, *shown])


def _typed(query: NamedQuery, name: str, kind: str, text: str) -> object:
    if kind == "STRING":
        return text
    value = _value(kind, text)
    if kind == "INTEGER" and type(value) is int:
        return value
    if kind == "LIST<STRING>" and _is_words(value):
        return value
    wanted = "a whole number" if kind == "INTEGER" else "words with commas between them, or a list in JSON"
    raise UsageError(f"{query.name}: {name} is {text}, and should be {wanted}", hint=_asked_like(query))


def _value(kind: str, text: str) -> object:
    """Return the value of a text in JSON, else for a list the words between its commas, else ``None``."""
    try:
        return json_value(text)
    except json.JSONDecodeError:
        return [word.strip() for word in text.split(",")] if kind == "LIST<STRING>" else None


def _is_words(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(word, str) for word in value)


def _asked_like(query: NamedQuery) -> str:
    return f"For example: {command(query)}"


def _quoted(value: str) -> str:
    return f"'{value}'" if set(value) & set(' "[]') else value
