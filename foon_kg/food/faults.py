"""What is wrong with a table of foods or utensils: its form, and names that it uses and nobody has.

A user's own table has the form of the shipped ones. TOML says nothing of a name that is written as a text instead of a
list, so that each of its letters would be a utensil: that is asked here.
"""

from __future__ import annotations

import difflib
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from foon_kg.food.rows import Level
from foon_kg.food.words import singular

Toml = Mapping[str, Any]

UTENSILS: Mapping[str, Mapping[str, str]] = {
    "groups": {
        "role": "text", "can": "list", "names": "list", "many": "truth", "open": "truth", "source": "text",
        "holds": "text", "closed": "truth", "power": "text", "always_on": "truth",
    },
}  # fmt: skip
"""The sections of a table of utensils, and what each row of a section may say."""

FOODS: Mapping[str, Mapping[str, str]] = {
    "kinds": {
        "about": "text", "of": "list", "sold_in": "text", "sold_as": "text", "owes": "row", "traits": "list",
        "words": "list", "when": "row",
    },
    "foods": {"owes": "row", "traits": "list", "sold_in": "text", "sold_as": "text", "when": "row"},
    "homonyms": {},
    "plurals": {"food": "text"},
}  # fmt: skip
"""The sections of a table of foods; a homonym says by states what it is, a plural as which food it ends."""

_SAID = {"text": "a text", "list": "a list of texts", "truth": "true or false", "row": "a row of texts"}


def malformed(document: Toml, sections: Mapping[str, Mapping[str, str]]) -> Iterator[str]:
    """Yield what is wrong with the form of a table, one sentence each.

    ``document`` is the table as TOML is read; ``sections`` are :data:`UTENSILS` or FOODS.
    """
    for section, rows in document.items():
        if section not in sections:
            yield f"nobody asks for “{section}”{_near(section, sections)}"
        elif not isinstance(rows, Mapping):
            yield f"“{section}” holds no rows"
        else:
            for name, row in rows.items():
                yield from _malformed_row(f"{section} “{name}”", row, sections[section])


def _malformed_row(where: str, row: object, fields: Mapping[str, str]) -> Iterator[str]:
    if not isinstance(row, Mapping):
        yield f"{where}: it is no row"
        return
    for field, value in row.items():
        wanted = fields.get(field, "") if fields else "text"
        if not wanted:
            yield f"{where}: nobody asks for “{field}”{_near(field, fields)}"
        elif not _is(wanted, value):
            yield f"{where}: “{field}” is not {_SAID[wanted]}"
        elif field == "owes":
            wrong = [level for level in value.values() if level not in list(Level)]
            yield from (f"{where}: “{level}” is not one of {', '.join(Level)}" for level in wrong)


def _is(wanted: str, value: object) -> bool:
    """Return whether ``value`` is of the form ``wanted``, one of those that the sections name."""
    if wanted == "list":
        return isinstance(value, list) and all(isinstance(one, str) for one in value)
    if wanted == "row":
        return isinstance(value, Mapping) and all(isinstance(one, str) for one in value.values())
    return isinstance(value, bool if wanted == "truth" else str)


def _near(name: str, among: Collection[str]) -> str:
    near = difflib.get_close_matches(name, sorted(among), n=1)
    return f" (near it: {near[0]})" if near else ""


def unknown_targets(document: Toml, kinds: Collection[str], names: Collection[str]) -> Iterator[str]:
    """Yield which kinds and names a well-formed table of foods uses that are not among ``kinds`` and ``names``.

    ``document`` is the table as TOML is read.
    """
    for section in ("kinds", "foods"):
        for name, row in document.get(section, {}).items():
            yield from _unknown_kinds(f"{section} “{name}”", row, kinds)
    for name in document.get("foods", {}):
        if singular(name) not in names:
            yield f"foods “{name}”: no kind has it among its words"
    meant = [("homonyms", name, food) for name, row in document.get("homonyms", {}).items() for food in row.values()]
    meant += [("plurals", name, row.get("food", "")) for name, row in document.get("plurals", {}).items()]
    for section, name, food in meant:
        if singular(food) not in names:
            yield f"{section} “{name}”: there is no food “{food}”{_near(food, names)}"


def _unknown_kinds(where: str, row: Mapping[str, Any], kinds: Collection[str]) -> Iterator[str]:
    """Yield which kinds the ``row`` at ``where`` names that are not among ``kinds``."""
    for kind in (*row.get("of", []), *row.get("when", {}).values()):
        if kind not in kinds:
            yield f"{where}: there is no kind “{kind}”{_near(kind, kinds)}"


def words_twice(document: Toml) -> Iterator[str]:
    """Yield the words that two kinds have, or two groups, of a well-formed table; spellings in one kind are one.

    ``document`` is the table as TOML is read.
    """
    for section, field in (("kinds", "words"), ("groups", "names")):
        own = [set(map(_listed, row.get(field, []))) for row in document.get(section, {}).values()]
        there = Counter(word for words in own for word in words)
        yield from (f"{section}: “{word}” stands in {count} of them" for word, count in there.items() if count > 1)


def _listed(word: str) -> str:
    return word if word.startswith("*") else singular(word)
