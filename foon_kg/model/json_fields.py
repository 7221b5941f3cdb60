"""Reading JSON values by name and type; whatever does not fit is said with its place in the document."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from typing import Any, NoReturn, TypeGuard

from foon_kg.model.errors import ReadError

JsonObject = dict[str, Any]
"""A JSON object as :mod:`json` reads and writes it."""


class Fields:
    """A JSON object of which each field is asked by name and type.

    ``where`` leads to it (``plan.json: units[3]``) and begins every message. Every method raises
    :class:`~foon_kg.model.errors.ReadError` when the field is missing or of another type; fields that nobody asks
    for are left alone.
    """

    def __init__(self, value: object, where: str) -> None:
        if not isinstance(value, Mapping):
            raise ReadError(
                f"{where}: expected a JSON object, found {_shown(value)}", hint="Write it as {…} with named fields."
            )
        self._values: Mapping[str, object] = value
        self.where = where

    def __contains__(self, name: str) -> bool:
        return name in self._values

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the fields that are there, sorted.

        >>> Fields({"label": "egg", "states": []}, "node").names
        ('label', 'states')
        """
        return tuple(sorted(self._values))

    def text(self, name: str) -> str:
        """Return the text of the field called ``name``.

        >>> Fields({"label": 7}, "plan.json").text("label")
        Traceback (most recent call last):
        foon_kg.model.errors.ReadError: plan.json: “label” should be text, found 7
        """
        return self._as_text(name, self._value(name))

    def optional_text(self, name: str) -> str | None:
        """Return the text of the field called ``name``, ``None`` where it is null or left out.

        >>> Fields({"title": None}, "recipe").optional_text("title")
        """
        return None if self._values.get(name) is None else self.text(name)

    def text_or_number(self, name: str) -> str:
        """Return the text of the field called ``name``, or its number as text (2.0 is "2").

        It is ``""`` where the field is null or left out.

        >>> Fields({"id": 2.0}, "recipe").text_or_number("id"), Fields({}, "recipe").text_or_number("id")
        ('2', '')
        """
        value = self._values.get(name)
        if _is_number(value):
            return f"{value:.15g}"
        return (self.optional_text(name) or "").strip()

    def whole_number(self, name: str) -> int:
        """Return the whole number of the field called ``name``.

        >>> Fields({"unit": 3}, "sighting").whole_number("unit")
        3
        """
        value = self._value(name)
        if not isinstance(value, int) or isinstance(value, bool):
            self._refuse(name, "a whole number", value)
        return value

    def number(self, name: str) -> float:
        """Return the number of the field called ``name``.

        >>> Fields({"confidence": 1}, "substitution").number("confidence")
        1.0
        """
        value = self._value(name)
        if not _is_number(value):
            self._refuse(name, "a number", value)
        return float(value)

    def optional_number(self, name: str) -> float | None:
        """Return the number of the field called ``name``, ``None`` where it is null or left out.

        >>> Fields({}, "sighting").optional_number("start")
        """
        return None if self._values.get(name) is None else self.number(name)

    def truth(self, name: str) -> bool:
        """Return the true or false of the field called ``name``.

        >>> Fields({"exact": True}, "reference").truth("exact")
        True
        """
        value = self._value(name)
        if not isinstance(value, bool):
            self._refuse(name, "true or false", value)
        return value

    def texts(self, name: str) -> tuple[str, ...]:
        """Return the texts of the list called ``name``.

        >>> Fields({"states": ["whole", "raw"]}, "node").texts("states")
        ('whole', 'raw')
        """
        return tuple(self._as_text(f"{name}[{place}]", value) for place, value in enumerate(self._list(name)))

    def nested(self, name: str) -> Fields:
        """Return the object that the field called ``name`` is.

        >>> Fields({"goal": {"label": "salad"}}, "plan.json").nested("goal").where
        'plan.json: goal'
        """
        return Fields(self._value(name), f"{self.where}: {name}")

    def nested_list(self, name: str) -> list[Fields]:
        """Return the objects of the list called ``name``, in order.

        >>> [one.where for one in Fields({"units": [{}, {}]}, "plan.json").nested_list("units")]
        ['plan.json: units[0]', 'plan.json: units[1]']
        """
        return [Fields(value, f"{self.where}: {name}[{place}]") for place, value in enumerate(self._list(name))]

    def items(self, name: str) -> list[object]:
        """Return the items of the list called ``name``, of whatever type they are.

        >>> Fields({"row": ["egg", 2]}, "table").items("row")
        ['egg', 2]
        """
        return list(self._list(name))

    def one_of(self, name: str, allowed: tuple[str, ...]) -> str:
        """Return the text of the field called ``name``, which must be one of ``allowed``.

        >>> Fields({"origin": "guess"}, "unit").one_of("origin", ("foon", "adapted"))
        Traceback (most recent call last):
        foon_kg.model.errors.ReadError: unit: “origin” should be one of foon, adapted, found "guess"
        """
        value = self.text(name)
        if value not in allowed:
            self._refuse(name, "one of " + ", ".join(allowed), value)
        return value

    def _value(self, name: str) -> object:
        if name not in self._values:
            raise ReadError(f"{self.where}: the field “{name}” is missing", hint=f"Add “{name}”.")
        return self._values[name]

    def _as_text(self, name: str, value: object) -> str:
        if not isinstance(value, str):
            self._refuse(name, "text", value)
        return value

    def _list(self, name: str) -> list[object]:
        value = self._value(name)
        if not isinstance(value, list):
            self._refuse(name, "a list", value)
        return value

    def _refuse(self, name: str, wanted: str, value: object) -> NoReturn:
        raise ReadError(
            f"{self.where}: “{name}” should be {wanted}, found {_shown(value)}", hint=f"Make “{name}” {wanted}."
        )


def _is_number(value: object) -> TypeGuard[int | float]:
    """Return whether ``value`` is a number that a float can hold."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) <= sys.float_info.max  # Python also reads NaN, Infinity and whole numbers of 400 digits


def _shown(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False, default=str)
    longest = 60
    return text if len(text) <= longest else text[:longest] + "…"
