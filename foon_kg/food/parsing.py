"""Rows of the tables out of their documents (TOML): how each section of a file becomes what the program asks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from foon_kg.food.foods import FoodTable
from foon_kg.food.rows import Dish, Kind, Level, Motion, State, Utensil
from foon_kg.food.words import singular
from foon_kg.model.errors import ReadError

ROLES = frozenset({"vessel", "storage", "tool", "appliance", "lid", "wrap", "place"})
SOURCES = frozenset({"", "heat", "cold", "power", "water"})
_COOKS = frozenset({"liquid", "dry", "fat"})
"""Ways to cook: what does one of these heats."""

Toml = Mapping[str, Any]


def refused(where: str, what: str) -> ReadError:
    """Return the error of a table, read from ``where``, with ``what`` is wrong in it."""
    return ReadError(f"{where}: {what}", hint="Take the form of the table of that name in foon_kg/food.")


def food_table(documents: Iterable[tuple[str, Toml]]) -> FoodTable:
    """Return the table of foods; later documents add to earlier ones."""
    kinds: dict[str, Kind] = {}
    kind_of: dict[str, str] = {}
    endings: dict[str, str] = {}
    homonyms: dict[str, tuple[tuple[str, str], ...]] = {}
    exceptions: dict[str, Mapping[str, object]] = {}
    plurals: dict[str, str] = {}
    for where, document in documents:
        for name, row in document.get("kinds", {}).items():
            kinds[name] = _kind(name, row, kinds.get(name), where)
            for word in row.get("words", []):
                if word.startswith("*"):
                    endings[word[1:]] = name
                else:
                    kind_of[singular(word)] = name
        exceptions |= {singular(name): dict(row) for name, row in document.get("foods", {}).items()}
        homonyms |= {singular(name): tuple(row.items()) for name, row in document.get("homonyms", {}).items()}
        plurals |= {name.lower(): row.get("food", "") for name, row in document.get("plurals", {}).items()}
    by_length = sorted(endings.items(), key=lambda row: (-len(row[0]), row[0]))
    return FoodTable(kinds, kind_of, tuple(by_length), homonyms, exceptions, plurals)


def _kind(name: str, row: Toml, known: Kind | None, where: str) -> Kind:
    """Return a kind; a user's file that only adds words to a known kind leaves what is known of it."""
    if known is not None and set(row) <= {"words"}:
        return known
    try:
        owes = {treatment: Level(level) for treatment, level in row.get("owes", {}).items()}
    except ValueError as error:
        raise refused(where, f"kind “{name}”: {error}") from error
    return Kind(
        name,
        row.get("about", ""),
        tuple(row.get("of", [])),
        row.get("sold_in", ""),
        row.get("sold_as", ""),
        owes,
        frozenset(row.get("traits", [])),
        dict(row.get("when", {})),
    )


def state_row(name: str, row: Toml) -> State:
    """Return what ``row``, of the table of states, says of the state ``name``."""
    return State(
        name,
        frozenset(row.get("earns", [])),
        row.get("fine"),
        sold=row.get("sold", False),
        sold_for=frozenset(row.get("sold_for", [])),
        undivided=row.get("undivided", False),
        half=row.get("half", False),
        needs_heat=row.get("needs_heat", False),
        before=frozenset(row.get("opposite", [])),
    )


def motion_row(name: str, row: Toml) -> Motion:
    """Return what ``row``, of the table of motions, says of the motion ``name``, or of a word of one."""
    tool, does = frozenset(row.get("tool", [])), frozenset(row.get("does", []))
    return Motion(
        name,
        does | {"heat"} if does & _COOKS else does,
        frozenset(row.get("gives", [])),
        (tool,) if tool else (),
        row.get("source", ""),
    )


def utensil_rows(document: Toml, where: str) -> Iterator[tuple[str, Utensil]]:
    """Yield the utensils of a document with their names; raises ReadError where a group is none."""
    for group, row in document.get("groups", {}).items():
        if row.get("role") not in ROLES:
            raise refused(where, f"group “{group}”: its role is {row.get('role')!r}, not one of {sorted(ROLES)}")
        if row.get("source", "") not in SOURCES:
            raise refused(where, f"group “{group}”: its source is {row['source']!r}, not one of {sorted(SOURCES)}")
        for name in row.get("names", []):
            yield (
                singular(name),
                Utensil(
                    singular(name),
                    row["role"],
                    group,
                    frozenset(row.get("can", [])),
                    row.get("many", False),
                    row.get("source", ""),
                    row.get("holds", ""),
                    row.get("power", "one"),
                    row.get("always_on", False),
                    name,
                ),
            )


def dish_row(name: str, row: Toml) -> Dish:
    """Return what ``row``, of the table of dishes, says of the dish ``name``."""
    return Dish(
        singular(name),
        needs_of(row.get("needs", [])),
        row.get("heated"),
        row.get("type", False),
        frozenset(row.get("soft", [])),
        row.get("baked", False),
        row.get("tin", ""),
        row.get("stacked", False),
        row.get("grilled", False),
        row.get("laid", False),
        row.get("dressed", False),
        row.get("mashed", False),
        row.get("coated", False),
        row.get("formed", False),
        frozenset(row.get("is_no", [])),
        frozenset(row.get("raw", [])),
    )


def needs_of(rows: Iterable[Iterable[str] | str]) -> tuple[tuple[str, ...], ...]:
    """Return the lists of alternatives in ``rows``; where these are words alone, they are one such list."""
    listed = list(rows)
    if listed and all(isinstance(row, str) for row in listed):
        return (tuple(map(str, listed)),)
    return tuple(tuple(row) for row in listed)
