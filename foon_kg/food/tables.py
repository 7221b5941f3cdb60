"""The tables of cooking read from their files: ``foods``, ``dishes``, ``states``, ``motions`` and ``utensils`` (TOML).

Everything that foon-kg knows of cooking stands in them; no algorithm has a list of foods or words of its own. A table
of the same form named in ``FOON_KG_UTENSILS`` or ``FOON_KG_FOODS`` adds a user's own utensils or foods.
"""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from foon_kg.errors import ReadError
from foon_kg.food.foods import FoodTable
from foon_kg.food.rows import Dish, Kind, Level, Motion, State, Utensil
from foon_kg.food.words import plain_words, singular, words

UTENSILS_VARIABLE = "FOON_KG_UTENSILS"
FOODS_VARIABLE = "FOON_KG_FOODS"

ROLES = frozenset({"vessel", "storage", "tool", "appliance", "lid", "wrap", "place"})
SOURCES = frozenset({"", "heat", "cold", "power", "water"})
_COOKS = frozenset({"liquid", "dry", "fat"})
"""Ways to cook: what does one of these heats."""

Toml = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class Tables:
    """The five tables, and how a name is looked up in each."""

    foods: FoodTable
    states: Mapping[str, State]
    motions: Mapping[str, Motion]
    motion_words: Mapping[str, Motion]
    utensils: Mapping[str, Utensil]
    utensil_states: Mapping[str, frozenset[str]]
    dishes: Mapping[str, Dish]
    unfinished: frozenset[str]
    contains: Mapping[str, tuple[tuple[str, ...], ...]]
    _states: dict[str, State] = field(default_factory=dict)
    _motions: dict[str, Motion] = field(default_factory=dict)

    @cached_property
    def dish_words(self) -> frozenset[str]:
        """The words of all names of dishes."""
        return frozenset(word for name in self.dishes for word in name.split())

    def utensil(self, label: str) -> Utensil | None:
        """Return the utensil called ``label``; ``None`` where it is none, and so a food."""
        return self.utensils.get(singular(label))

    def state(self, name: str) -> State:
        """Return what a state says: as it is listed, else as its words are ("thinly sliced" is sliced)."""
        if name not in self._states:
            self._states[name] = self.states.get(name.lower()) or self._of_words(name)
        return self._states[name]

    def motion(self, name: str) -> Motion:
        """Return what a motion does: as the phrase is listed, else all that its words do."""
        if name not in self._motions:
            self._motions[name] = self.motions.get(name.lower()) or self._of_motion_words(name)
        return self._motions[name]

    def _of_words(self, name: str) -> State:
        listed = [self.states[word] for word in sorted(plain_words(name)) if word in self.states]
        finest = max((row.fine for row in listed if row.fine is not None), default=None)
        return State(
            name,
            frozenset().union(*(row.earns for row in listed)),
            finest,
            sold=bool(listed) and all(row.sold for row in listed),
            undivided=any(row.undivided for row in listed),
            half=any(row.half for row in listed),
            needs_heat=any(row.needs_heat for row in listed),
        )

    def _of_motion_words(self, name: str) -> Motion:
        listed = [self.motion_words[word] for word in sorted(plain_words(name)) if word in self.motion_words]
        sources = sorted({row.source for row in listed} - {""})
        return Motion(
            name,
            frozenset().union(*(row.does for row in listed)),
            frozenset().union(*(row.gives for row in listed)),
            tuple(tool for row in listed for tool in row.tools),
            "heat" if "heat" in sources else "".join(sources[:1]),
            known=bool(listed),
        )

    def dishes_named(self, *texts: str) -> tuple[Dish, ...]:
        """Return the dishes that stand in ``texts`` (a goal's label, a title), the longer names only."""
        found: dict[str, Dish] = {}
        for text in texts:
            own = words(text)
            for length in range(len(own), 0, -1):
                for start in range(len(own) - length + 1):
                    name = " ".join(own[start : start + length])
                    if name in self.dishes and not any(name in other for other in found):
                        found[name] = self.dishes[name]
        return tuple(found.values())


def tables() -> Tables:
    """Return the shipped tables with what the user's own files add to them.

    Raises ReadError where a file is no table of its form.
    """
    return _read(os.environ.get(UTENSILS_VARIABLE, ""), os.environ.get(FOODS_VARIABLE, ""))


@lru_cache(maxsize=4)
def _read(own_utensils: str, own_foods: str) -> Tables:
    foods = [_shipped("foods"), *([_own(own_foods)] if own_foods else [])]
    utensils = [_shipped("utensils"), *([_own(own_utensils)] if own_utensils else [])]
    states, motions, dishes = (_shipped(name)[1] for name in ("states", "motions", "dishes"))
    rows = {name: row for where, document in utensils for name, row in _utensils(document, where)}
    return Tables(
        foods=_food_table(foods),
        states={name.lower(): _state(name, row) for name, row in states["states"].items()},
        motions={name.lower(): _motion(name, row) for name, row in motions.get("motions", {}).items()},
        motion_words={name.lower(): _motion(name, row) for name, row in motions["words"].items()},
        utensils=rows,
        utensil_states={name: frozenset(listed) for name, listed in utensils[0][1]["states"].items()},
        dishes={singular(name): _dish(name, row) for name, row in dishes["dishes"].items()},
        unfinished=frozenset(map(singular, dishes["products"]["unfinished"])),
        contains={singular(name): _needs(row) for name, row in dishes["products"]["contains"].items()},
    )


def _shipped(name: str) -> tuple[str, Toml]:
    file = f"{name}.toml"
    return file, tomllib.loads(files("foon_kg.food").joinpath(file).read_text(encoding="utf-8"))


def _own(path: str) -> tuple[str, Toml]:
    try:
        return path, tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ReadError(
            f"{path}: the table cannot be read: {error}",
            hint="Take the form of foon_kg/food/utensils.toml or foods.toml; docs/contract.md shows an example.",
        ) from error


def _refused(where: str, what: str) -> ReadError:
    return ReadError(f"{where}: {what}", hint="Take the form of the table of that name in foon_kg/food.")


def _food_table(documents: Iterable[tuple[str, Toml]]) -> FoodTable:
    kinds: dict[str, Kind] = {}
    kind_of: dict[str, str] = {}
    endings: dict[str, str] = {}
    homonyms: dict[str, tuple[tuple[str, str], ...]] = {}
    exceptions: dict[str, Mapping[str, object]] = {}
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
    by_length = sorted(endings.items(), key=lambda row: (-len(row[0]), row[0]))
    return FoodTable(kinds, kind_of, tuple(by_length), homonyms, exceptions)


def _kind(name: str, row: Toml, known: Kind | None, where: str) -> Kind:
    """Return a kind; a user's file that only adds words to a known kind leaves what is known of it."""
    if known is not None and set(row) <= {"words"}:
        return known
    try:
        owes = {treatment: Level(level) for treatment, level in row.get("owes", {}).items()}
    except ValueError as error:
        raise _refused(where, f"kind “{name}”: {error}") from error
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


def _state(name: str, row: Toml) -> State:
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


def _motion(name: str, row: Toml) -> Motion:
    tool, does = frozenset(row.get("tool", [])), frozenset(row.get("does", []))
    return Motion(
        name,
        does | {"heat"} if does & _COOKS else does,
        frozenset(row.get("gives", [])),
        (tool,) if tool else (),
        row.get("source", ""),
    )


def _utensils(document: Toml, where: str) -> Iterator[tuple[str, Utensil]]:
    for group, row in document.get("groups", {}).items():
        if row.get("role") not in ROLES:
            raise _refused(where, f"group “{group}”: its role is {row.get('role')!r}, not one of {sorted(ROLES)}")
        if row.get("source", "") not in SOURCES:
            raise _refused(where, f"group “{group}”: its source is {row['source']!r}, not one of {sorted(SOURCES)}")
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
                ),
            )


def _dish(name: str, row: Toml) -> Dish:
    return Dish(
        singular(name),
        _needs(row.get("needs", [])),
        row.get("heated"),
        row.get("type", False),
        frozenset(row.get("soft", [])),
        row.get("baked", False),
    )


def _needs(rows: Iterable[Iterable[str] | str]) -> tuple[tuple[str, ...], ...]:
    """Return lists of alternatives; a flat list is one list of alternatives."""
    listed = list(rows)
    if listed and all(isinstance(row, str) for row in listed):
        return (tuple(map(str, listed)),)
    return tuple(tuple(row) for row in listed)
