"""What the words of a title ask to be done, as ``named.toml`` says: a cake upside down is turned over."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from foon_kg.food.rows import Food, Motion
from foon_kg.food.shipped import shipped
from foon_kg.food.techniques import Around, Foods, all_names
from foon_kg.food.words import any_stands_in, stands_in, words

_FIELDS = ("when", "stage", "at")


@dataclass(frozen=True)
class Named:
    """Something that a dish ``called`` so asks for; the fields are those of a row of ``named.toml``.

    ``called`` and ``never`` are phrases as tuples of words.
    """

    name: str
    called: tuple[tuple[str, ...], ...]
    never: tuple[tuple[str, ...], ...]
    types: frozenset[str]
    without: tuple[Foods, ...]
    of: tuple[Foods, ...]
    by: frozenset[str]
    does: frozenset[str]
    fills: tuple[Foods, ...]
    times: int = 1
    when: str = ""
    stage: str = ""
    at: str = ""

    def said(self, told: Sequence[str]) -> str:
        """Return the words of a title, ``told`` in their order, that ask for it; ``""`` where none do."""
        if any_stands_in(self.never, told):
            return ""
        return next((" ".join(name) for name in self.called if stands_in(name, told)), "")

    def is_done_by(self, motion: str, row: Motion) -> bool:
        """Return whether a step of ``motion`` does it; ``row`` is what the tables say of the motion."""
        return not self.by.isdisjoint(words(motion)) or not self.does.isdisjoint(row.does)

    def in_time(self, found: Sequence[int], hot: Sequence[int]) -> list[int]:
        """Return which of the steps ``found`` come when it is asked; those of ``hot`` heat it."""
        if self.when == "done":
            return [number for number in found if hot and number > hot[0]]
        if self.when == "before":
            return [number for number in found if hot and number < hot[-1]]
        return list(found)

    def is_of(self, label: str, facts: Food) -> bool:
        """Return whether it is done to the food ``label``; ``facts`` are what the tables say of that food."""
        return not self.of or any(foods.mean(label, facts, ()) for foods in self.of)

    def is_ruled_out(self, foods: Collection[tuple[str, Food]], around: Around) -> bool:
        """Return whether one of ``foods`` is there ``without`` which alone it is asked; ``around`` is the recipe."""
        return any(some.mean(label, facts, (), around) for some in self.without for label, facts in foods)


def named_by(title: str, dish_type: str, foods: Collection[tuple[str, Food]]) -> tuple[tuple[Named, str], ...]:
    """Return what the ``title`` of a dish of type ``dish_type`` asks for, each with the words that do.

    ``foods`` are those of the recipe with their names.
    """
    told = words(title)
    around = Around([facts for _, facts in foods], told)
    found = []
    for one in _rows():
        said = one.said(told) if not one.types or dish_type in one.types else ""
        if said and any(one.is_of(*food) for food in foods) and not one.is_ruled_out(foods, around):
            found.append((one, said))
    return tuple(found)


@cache
def _rows() -> tuple[Named, ...]:
    rows: Mapping[str, Mapping[str, Any]] = shipped("named")["named"]
    return tuple(_named(name, row) for name, row in rows.items())


def _named(name: str, row: Mapping[str, Any]) -> Named:
    def foods(field: str) -> tuple[Foods, ...]:
        return tuple(map(Foods.read, row.get(field, ())))

    return Named(
        name, all_names(row, "called"), all_names(row, "never"), frozenset(row.get("types", ())),
        foods("without"), foods("of"),
        frozenset(word for text in row.get("by", ()) for word in words(text)), frozenset(row.get("does", ())),
        foods("fills"), row.get("times", 1), **{field: row[field] for field in _FIELDS if field in row},
    )  # fmt: skip
